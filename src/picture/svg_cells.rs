//! Flat cells of a mesh, for pictures that cannot be shaded smoothly.

use std::collections::BTreeMap;

use glam::DVec2;

use super::clip::{Frame, cut};
use super::{Mesh, Viewport};
use crate::material::{Color, Oklab};

/// Largest difference of colour inside a cell, as a distance in Oklab: below the 0.02 that is just visible side by side.
const COLOR_STEP: f32 = 0.012;

/// Cells asked for at most; beyond it the steps become coarser, so that the file stays within some megabytes.
const MOST_CELLS: f32 = 40_000.0;

#[derive(Debug, Clone, Copy)]
struct Corner {
    at: DVec2,
    color: Oklab,
    /// Along the main change of colour, 0 to the number of strips.
    strip: f64,
}

/// Polygons of one colour, in device pixels, sorted by colour: each triangle is cut into strips across its main change of colour.
/// Triangles apart from the frame are left out, those across its border cut.
pub(super) fn flat_cells(mesh: &Mesh, viewport: &Viewport, frame: &Frame) -> Vec<(Color, Vec<Vec<DVec2>>)> {
    let triangles: Vec<[Corner; 3]> = mesh.triangles.iter().map(|t| corners(mesh, viewport, *t)).collect();
    let wanted: f32 = triangles.iter().map(|t| (spread(t).0 / COLOR_STEP).max(1.0)).sum();
    let step = COLOR_STEP * (wanted / MOST_CELLS).max(1.0);

    let mut cells: BTreeMap<[u8; 3], Vec<Vec<DVec2>>> = BTreeMap::new();
    for triangle in triangles {
        let (ring, strips) = in_strips(triangle, step, frame);
        for strip in 0..strips {
            let above = cut(&ring, |c| c.strip - f64::from(strip), Corner::lerp);
            let cell = cut(&above, |c| f64::from(strip + 1) - c.strip, Corner::lerp);
            if cell.len() >= 3 {
                let color = mean(cell.iter().map(|corner| corner.color)).to_color();
                let points = cell.iter().map(|corner| corner.at).collect();
                cells.entry([color.r, color.g, color.b]).or_default().push(points);
            }
        }
    }
    cells.into_iter().map(|([r, g, b], polygons)| (Color { r, g, b }, polygons)).collect()
}

fn corners(mesh: &Mesh, viewport: &Viewport, triangle: [u32; 3]) -> [Corner; 3] {
    triangle.map(|i| Corner {
        at: viewport.place(mesh.vertices[i as usize]),
        color: mesh.colors[i as usize],
        strip: 0.0,
    })
}

/// The largest difference of colour between two corners, and which two.
fn spread(triangle: &[Corner; 3]) -> (f32, usize, usize) {
    [(0, 1), (1, 2), (2, 0)]
        .map(|(i, j)| (triangle[i].color.distance(triangle[j].color), i, j))
        .into_iter()
        .fold((0.0, 0, 1), |best, next| if next.0 > best.0 { next } else { best })
}

/// The triangle inside the frame with its corners measured in strips, and the number of strips.
fn in_strips(mut triangle: [Corner; 3], step: f32, frame: &Frame) -> (Vec<Corner>, u32) {
    let (widest, i, j) = spread(&triangle);
    let strips = (widest / step).ceil().max(1.0);
    let (from, to) = (triangle[i].color, triangle[j].color);
    let along = |c: Oklab| {
        (c.l - from.l) * (to.l - from.l) + (c.a - from.a) * (to.a - from.a) + (c.b - from.b) * (to.b - from.b)
    };
    for corner in &mut triangle {
        let share = if widest > 0.0 { along(corner.color) / (widest * widest) } else { 0.5 };
        corner.strip = f64::from(share.clamp(0.0, 1.0) * strips);
    }
    let mut ring = triangle.to_vec();
    if triangle.iter().any(|c| !frame.contains(c.at)) {
        let (min, max) = (frame.min, frame.max);
        for (axis, bound, sign) in [(0, min.x, 1.0), (0, max.x, -1.0), (1, min.y, 1.0), (1, max.y, -1.0)] {
            ring = cut(&ring, |c| sign * (c.at[axis] - bound), Corner::lerp);
        }
    }
    (ring, strips as u32)
}

/// The mean colour of the vertices of a mesh that is not empty.
pub(super) fn mean_color(mesh: &Mesh) -> Color {
    mean(mesh.colors.iter().copied()).to_color()
}

fn mean(colors: impl ExactSizeIterator<Item = Oklab>) -> Oklab {
    let share = 1.0 / colors.len() as f32;
    let zero = Oklab { l: 0.0, a: 0.0, b: 0.0 };
    colors.fold(zero, |sum, color| Oklab {
        l: sum.l + color.l * share,
        a: sum.a + color.a * share,
        b: sum.b + color.b * share,
    })
}

impl Corner {
    fn lerp(self, other: Self, t: f64) -> Self {
        Self {
            at: self.at.lerp(other.at, t),
            color: self.color.lerp(other.color, t as f32),
            strip: self.strip + (other.strip - self.strip) * t,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const VIEW: Viewport =
        Viewport { width: 100, height: 100, center: DVec2::splat(50.0), scale: 1.0, pixel_ratio: 1.0 };

    fn blend() -> Mesh {
        let (dark, light) = (Color::new(30, 30, 30).to_oklab(), Color::new(250, 250, 250).to_oklab());
        Mesh {
            vertices: vec![DVec2::ZERO, DVec2::new(100.0, 0.0), DVec2::splat(100.0), DVec2::new(0.0, 100.0)],
            colors: vec![dark, light, light, dark],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
        }
    }

    fn area(cells: &[(Color, Vec<Vec<DVec2>>)]) -> f64 {
        let ring = |r: &Vec<DVec2>| {
            (0..r.len()).map(|i| r[i].perp_dot(r[(i + 1) % r.len()])).sum::<f64>().abs() / 2.0
        };
        cells.iter().flat_map(|(_, polygons)| polygons).map(ring).sum()
    }

    #[test]
    fn cells_cover_the_mesh_in_small_steps_of_colour() {
        let cells = flat_cells(&blend(), &VIEW, &Frame::around(&VIEW, 10.0));
        assert!((area(&cells) - 1e4).abs() < 1e-3, "{}", area(&cells));
        assert!(cells.len() >= 55, "{}", cells.len());
        let steps = cells.windows(2).map(|pair| pair[0].0.to_oklab().distance(pair[1].0.to_oklab()));
        assert!(steps.fold(0.0, f32::max) < 0.02);
    }

    #[test]
    fn only_the_part_in_the_frame_is_kept() {
        let near = Viewport { scale: 1e6, ..VIEW };
        let cells = flat_cells(&blend(), &near, &Frame::around(&near, 0.0));
        assert!((area(&cells) - 1e4).abs() < 1.0, "{}", area(&cells));
    }
}
