//! Hatches in place of colours: the angle of the lines tells the material, the share of the area that they cover its fraction.
//!
//! Lines of one material are parallel and evenly spaced on the screen. Across each triangle the width of a line is linear, as the fraction
//! is, so that it covers a convex polygon: the triangle cut by two half planes. Pictures in pixels take how much of each pixel the
//! lines cover, SVG the polygons of `svg_hatch.rs`. Where a material is alone its lines cover [`FULL`] of the area, for lines that fill it have no angle; half
//! the fraction covers half of that, exactly.

use glam::DVec2;

use super::Viewport;
use crate::material::Composition;

/// Share of the area that the lines of a pure material cover.
pub const FULL: f64 = 0.5;

/// From one line to the next, in CSS pixels.
const PERIOD: f64 = 7.0;

/// Angles in degrees from the horizontal, counter-clockwise. Further materials have them again, each round with lines farther apart.
const ANGLES: [f64; 4] = [0.0, 45.0, 90.0, 135.0];

/// Triangles with a composition at each vertex, linear between them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Blends {
    /// Vertices in document units.
    pub vertices: Vec<DVec2>,
    /// Composition at each vertex.
    pub mixes: Vec<Composition>,
    /// Indices of the three vertices of each triangle.
    pub triangles: Vec<[u32; 3]>,
}

impl Blends {
    /// The fraction of a material at a vertex; none of one that is not there.
    pub(super) fn fraction(&self, vertex: usize, material: usize) -> f64 {
        self.mixes[vertex].fractions().get(material).copied().unwrap_or(0.0)
    }
}

/// The parallel lines of one material.
#[derive(Clone, Copy)]
pub(super) struct Lines {
    /// Across the lines, of unit length.
    pub(super) normal: DVec2,
    /// Pixels from one line to the next.
    pub(super) period: f64,
    /// How far the first line lies from the upper left corner of the picture.
    pub(super) phase: f64,
}

impl Lines {
    /// The lines of a material. One of them passes through the origin of the document, so that they move with the figure.
    pub(super) fn new(material: usize, viewport: &Viewport) -> Self {
        let angle = ANGLES[material % ANGLES.len()].to_radians();
        let normal = DVec2::new(angle.sin(), angle.cos());
        let period = PERIOD * viewport.pixel_ratio * (1.0 + (material / ANGLES.len()) as f64 / 2.0);
        Self { normal, period, phase: normal.dot(viewport.place(DVec2::ZERO)).rem_euclid(period) }
    }

    /// How much of a pixel the lines cover where the material has a fraction: what a square of one pixel along the normal has of the
    /// nearest line. The mean over a period is exact.
    pub(super) fn coverage(&self, center: DVec2, fraction: f64) -> f64 {
        let place = (self.normal.dot(center) - self.phase) / self.period;
        let away = (place - (place + 0.5).floor()).abs() * self.period;
        let half = fraction * FULL * self.period / 2.0;
        ((away + 0.5).min(half) - (away - 0.5).max(-half)).clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::Color;
    use crate::picture::svg_hatch::hatch;
    use crate::picture::{DisplayList, Item, Path, paint};

    const INK: Color = Color::new(0, 0, 0);

    /// A square of the plane with the compositions at its corners, from the lower left one counter-clockwise.
    fn square(mixes: [&[f64]; 4]) -> Blends {
        Blends {
            vertices: vec![
                DVec2::new(-50.0, -50.0),
                DVec2::new(50.0, -50.0),
                DVec2::new(50.0, 50.0),
                DVec2::new(-50.0, 50.0),
            ],
            mixes: mixes.map(|mix| Composition::new(mix.to_vec()).unwrap()).to_vec(),
            triangles: vec![[0, 1, 2], [0, 2, 3]],
        }
    }

    fn pure(material: usize) -> Blends {
        let mut mix = vec![0.0; 16];
        mix[material] = 1.0;
        square([&mix, &mix, &mix, &mix])
    }

    fn view(scale: f64) -> Viewport {
        Viewport { width: 420, height: 420, center: DVec2::ZERO, scale, pixel_ratio: 1.0 }
    }

    /// Ink of each pixel, 0 to 1.
    fn inked(blends: &Blends, material: usize, viewport: &Viewport) -> Vec<f64> {
        let mut list = DisplayList::new(Some(Color::new(255, 255, 255)));
        let item = Item::Hatch {
            blends: blends.clone(),
            materials: vec![material],
            outline: Path::default(),
            color: INK,
        };
        list.push("hatch", item);
        let data = paint(&list, viewport).unwrap();
        data.chunks_exact(4).map(|pixel| 1.0 - f64::from(pixel[0]) / 255.0).collect()
    }

    /// Area of the rings, in units.
    fn area(path: &Path) -> f64 {
        let ring =
            |r: &Vec<DVec2>| (0..r.len()).map(|i| r[i].perp_dot(r[(i + 1) % r.len()])).sum::<f64>() / 2.0;
        path.rings.iter().map(|r| ring(r).abs()).sum()
    }

    /// Of a uniform mix the lines cover their share of the square, but for those cut by its sides: at most one line at
    /// each of two sides.
    #[test]
    fn the_covered_share_is_the_fraction() {
        for fraction in [0.05, 0.25, 0.5, 0.8, 1.0] {
            let mix = [fraction, 1.0 - fraction];
            let blends = square([&mix, &mix, &mix, &mix]);
            for (material, share) in mix.into_iter().enumerate() {
                let view = view(4.0);
                let found = area(&hatch(&blends, material, &view)) / 1e4;
                let bound = FULL * share * PERIOD / 400.0;
                assert!((found - FULL * share).abs() <= bound, "{material} {share}: {found}");
                let painted = inked(&blends, material, &view).iter().sum::<f64>() / 160_000.0;
                assert!((painted - found).abs() < 0.005, "{material} {share}: {painted}, {found}");
            }
        }
    }

    /// Where the fraction rises from side to side the share of each strip does, too.
    #[test]
    fn density_follows_the_fraction_across_a_blend() {
        let (none, all): (&[f64], &[f64]) = (&[1.0, 0.0], &[0.0, 1.0]);
        let blends = square([none, all, all, none]);
        let view = view(4.0);
        let ink = inked(&blends, 1, &view);
        // 392 pixels hold 56 lines along any side, or 40 diagonals.
        for (from, to) in [(20, 76), (100, 156), (180, 236), (260, 316), (340, 396)] {
            let columns = (10..402).flat_map(|y| (from..to).map(move |x| y * 420 + x));
            let share = columns.map(|i| ink[i]).sum::<f64>() / (392 * (to - from)) as f64;
            let middle = (f64::from(from as u32 + to as u32) / 2.0 - 10.0) / 400.0;
            assert!((share - FULL * middle).abs() < 0.02, "{from}: {share} for {middle}");
        }
    }

    /// Ink is the same along the lines and changes across them, at the angle of the material.
    #[test]
    fn lines_run_at_the_angle_of_the_material() {
        let view = view(4.0);
        let steps: [(isize, isize); 4] = [(1, 0), (1, -1), (0, -1), (-1, -1)];
        for material in 0..8 {
            let ink = inked(&pure(material), material, &view);
            let change = |(dx, dy): (isize, isize)| {
                let inside = (60..360_isize).flat_map(|y| (60..360_isize).map(move |x| (x, y)));
                let at = |x: isize, y: isize| ink[(y * 420 + x) as usize];
                inside.map(|(x, y)| (at(x, y) - at(x + dx, y + dy)).abs()).sum::<f64>() / 90_000.0
            };
            for (k, &step) in steps.iter().enumerate() {
                if k == material % 4 {
                    assert!(change(step) < 0.01, "{material} along {step:?}: {}", change(step));
                } else {
                    assert!(change(step) > 0.1, "{material} across {step:?}: {}", change(step));
                }
            }
        }
    }

    /// The distance between lines is one of the screen: a square of twice the size on it has twice as many.
    #[test]
    fn zoom_leaves_the_lines_as_far_apart() {
        let count = |scale: f64, material| {
            let path = hatch(&pure(material), material, &view(scale));
            let normal = Lines::new(material, &view(scale)).normal;
            let mut places: Vec<f64> = path
                .rings
                .iter()
                .map(|ring| {
                    let middle = ring.iter().sum::<DVec2>() / ring.len() as f64;
                    (normal.dot(DVec2::new(middle.x, -middle.y)) * scale / PERIOD).round()
                })
                .collect();
            places.sort_by(f64::total_cmp);
            places.dedup();
            places.len() as f64
        };
        for material in 0..4 {
            let (one, two) = (count(2.0, material), count(4.0, material));
            assert!((two / one - 2.0).abs() < 0.15, "{material}: {one}, {two}");
        }
    }

    /// Triangles of a strip share their corners on every line, so that no seam shows between them.
    #[test]
    fn there_are_no_seams() {
        let mut blends = Blends::default();
        for i in 0..=40 {
            let x = f64::from(i) * 2.5 - 50.0;
            blends.vertices.extend([DVec2::new(x, -50.0), DVec2::new(x + 0.7, 50.0)]);
            blends.mixes.extend(vec![Composition::new(vec![1.0]).unwrap(); 2]);
        }
        for i in (0..80).step_by(2) {
            blends.triangles.extend([[i, i + 1, i + 2], [i + 2, i + 1, i + 3]]);
        }
        let view = view(3.0);
        let ink = inked(&blends, 0, &view);
        let rows = (100..320).map(|y| &ink[y * 420 + 100..y * 420 + 320]);
        for row in rows {
            assert!(row.iter().all(|value| (value - row[0]).abs() < 0.02), "{row:?}");
        }
    }

    #[test]
    fn a_view_far_off_or_far_in_keeps_few_lines() {
        let far = Viewport { center: DVec2::new(1e12, -1e12), ..view(1.0) };
        assert!(hatch(&pure(0), 0, &far).rings.is_empty());
        let near = view(1e9);
        let rings = hatch(&pure(1), 1, &near).rings.len();
        assert!((60..400).contains(&rings), "{rings}");
    }
}
