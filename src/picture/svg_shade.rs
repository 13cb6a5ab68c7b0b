//! Patches of a mesh that SVG can shade: one linear gradient, or one colour, each.

use glam::{DMat2, DVec2};

use super::clip::{Frame, cut};
use super::{Mesh, Viewport};
use crate::material::{Color, Oklab};

/// Largest error of colour at a corner of a patch, as a distance in Oklab; 0.02 is just visible side by side.
const COLOR_ERROR: f32 = 0.02;
/// Distance in Oklab between two stops of a gradient: between them renderers mix in sRGB, which errs by far less.
const STOP_DISTANCE: f32 = 0.06;
/// How often a triangle whose colours turn is cut into four.
const DEEPEST: u32 = 4;

/// A polygon in device pixels with its shade.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Patch {
    pub(super) ring: Vec<DVec2>,
    pub(super) shade: Shade,
}

/// The colours of a patch.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shade {
    Flat(Color),
    /// Even stops from one place to another, the same colour across.
    Linear {
        from: DVec2,
        to: DVec2,
        stops: Vec<Color>,
    },
}

#[derive(Debug, Clone, Copy)]
struct Corner {
    at: DVec2,
    color: Oklab,
}

/// The patches of a mesh inside the frame. Neighbouring triangles of a strip become one patch where one gradient shades both;
/// a triangle that no gradient shades is cut into smaller ones.
pub(super) fn patches(mesh: &Mesh, viewport: &Viewport, frame: &Frame) -> Vec<Patch> {
    let corner =
        |i: u32| Corner { at: viewport.place(mesh.vertices[i as usize]), color: mesh.colors[i as usize] };
    let mut patches = Vec::new();
    let mut triangles = mesh.triangles.as_slice();
    while let [first, rest @ ..] = triangles {
        triangles = rest;
        if let Some((quad, after)) =
            rest.split_first().and_then(|(second, after)| Some((quad(*first, *second)?, after)))
        {
            let quad = quad.map(corner);
            if is_simple(&quad)
                && let Some(shade) = shade(&quad)
            {
                push(&mut patches, quad.map(|c| c.at).to_vec(), shade, frame);
                triangles = after;
                continue;
            }
        }
        split(&mut patches, first.map(corner), DEEPEST, frame);
    }
    patches
}

/// The corners, in order, of two triangles that share an edge.
fn quad(first: [u32; 3], second: [u32; 3]) -> Option<[u32; 4]> {
    let apex = (0..3).find(|&i| !second.contains(&first[i]))?;
    let (start, end) = (first[(apex + 1) % 3], first[(apex + 2) % 3]);
    let other = second.into_iter().find(|v| !first.contains(v))?;
    (second.contains(&start) && second.contains(&end)).then_some([first[apex], start, other, end])
}

/// Tells whether the two triangles on the edge from corner 1 to corner 3 lie on either side of it.
fn is_simple([a, b, c, d]: &[Corner; 4]) -> bool {
    let edge = d.at - b.at;
    edge.perp_dot(a.at - b.at) * edge.perp_dot(c.at - b.at) < 0.0
}

fn split(patches: &mut Vec<Patch>, triangle: [Corner; 3], deepest: u32, frame: &Frame) {
    let [a, b, c] = triangle;
    let area = (b.at - a.at).perp_dot(c.at - a.at);
    if area == 0.0 {
        return;
    }
    match shade(&triangle) {
        Some(shade) => push(patches, triangle.map(|c| c.at).to_vec(), shade, frame),
        None if deepest == 0 => {
            let flat = Shade::Flat(mean(triangle.iter().map(|c| c.color)).to_color());
            push(patches, triangle.map(|c| c.at).to_vec(), flat, frame);
        }
        None => {
            let middle =
                |p: Corner, q: Corner| Corner { at: p.at.lerp(q.at, 0.5), color: p.color.lerp(q.color, 0.5) };
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            for part in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
                split(patches, part, deepest - 1, frame);
            }
        }
    }
}

fn push(patches: &mut Vec<Patch>, mut ring: Vec<DVec2>, shade: Shade, frame: &Frame) {
    if ring.iter().any(|&p| !frame.contains(p)) {
        let (min, max) = (frame.min, frame.max);
        for (axis, bound, sign) in [(0, min.x, 1.0), (0, max.x, -1.0), (1, min.y, 1.0), (1, max.y, -1.0)] {
            ring = cut(&ring, |p| sign * (p[axis] - bound), DVec2::lerp);
        }
    }
    if ring.len() >= 3 {
        patches.push(Patch { ring, shade });
    }
}

/// The shade of a polygon whose corners have the given colours, or `None` when one gradient cannot give them.
///
/// Colours are measured along the line between the two that differ most; the gradient runs where that measure ascends
/// fastest, by least squares over the corners.
fn shade(corners: &[Corner]) -> Option<Shade> {
    let pairs = (0..corners.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let distance = |(i, j): (usize, usize)| corners[i].color.distance(corners[j].color);
    let widest = pairs.max_by(|&p, &q| distance(p).total_cmp(&distance(q)))?;
    let (low, high) = (corners[widest.0].color, corners[widest.1].color);
    let spread = distance(widest);
    if spread <= COLOR_ERROR / 2.0 {
        return Some(Shade::Flat(mean(corners.iter().map(|c| c.color)).to_color()));
    }
    let along = [high.l - low.l, high.a - low.a, high.b - low.b];
    let measure = |c: Oklab| {
        let offset = [c.l - low.l, c.a - low.a, c.b - low.b];
        let dot: f32 = offset.iter().zip(along).map(|(x, y)| x * y).sum();
        f64::from(dot / (spread * spread))
    };
    let count = corners.len() as f64;
    let center = corners.iter().map(|c| c.at).sum::<DVec2>() / count;
    let level = corners.iter().map(|c| measure(c.color)).sum::<f64>() / count;
    let (mut spreads, mut rises) = (DMat2::ZERO, DVec2::ZERO);
    for corner in corners {
        let offset = corner.at - center;
        spreads += DMat2::from_cols(offset * offset.x, offset * offset.y);
        rises += offset * (measure(corner.color) - level);
    }
    let slope = spreads.inverse() * rises;
    let is_given = |c: &Corner| {
        let t = (level + slope.dot(c.at - center)).clamp(0.0, 1.0) as f32;
        low.lerp(high, t).distance(c.color) <= COLOR_ERROR
    };
    if !slope.is_finite() || slope == DVec2::ZERO || !corners.iter().all(is_given) {
        return None;
    }
    let run = slope / slope.length_squared();
    let from = center - level * run;
    let steps = (spread / STOP_DISTANCE).ceil() as u16;
    let stops = (0..=steps).map(|k| low.lerp(high, f32::from(k) / f32::from(steps)).to_color()).collect();
    Some(Shade::Linear { from, to: from + run, stops })
}

/// The mean colour of a mesh.
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

#[cfg(test)]
mod tests {
    use super::*;

    const VIEW: Viewport =
        Viewport { width: 100, height: 100, center: DVec2::splat(50.0), scale: 1.0, pixel_ratio: 1.0 };

    /// A square with a colour at each corner, from (0, 0) counter-clockwise.
    fn square(colors: [u8; 4]) -> Mesh {
        Mesh {
            vertices: vec![DVec2::ZERO, DVec2::new(100.0, 0.0), DVec2::splat(100.0), DVec2::new(0.0, 100.0)],
            colors: colors.map(|level| Color::new(level, level, level).to_oklab()).to_vec(),
            triangles: vec![[0, 1, 2], [0, 2, 3]],
        }
    }

    fn shaded(mesh: &Mesh, view: &Viewport, margin: f64) -> Vec<Patch> {
        patches(mesh, view, &Frame::around(view, margin))
    }

    fn area(patches: &[Patch]) -> f64 {
        let ring =
            |r: &Vec<DVec2>| (0..r.len()).map(|i| r[i].perp_dot(r[(i + 1) % r.len()])).sum::<f64>() / 2.0;
        patches.iter().map(|patch| ring(&patch.ring).abs()).sum()
    }

    #[test]
    fn a_blend_from_side_to_side_is_one_gradient() {
        let found = shaded(&square([30, 250, 250, 30]), &VIEW, 10.0);
        let [Patch { shade: Shade::Linear { from, to, stops }, .. }] = found.as_slice() else {
            panic!("{found:?}")
        };
        let (left, right) = if from.x < to.x { (from, to) } else { (to, from) };
        assert!(left.x.abs() < 1e-3 && (right.x - 100.0).abs() < 1e-3 && (left.y - right.y).abs() < 1e-3);
        let ends = [stops[0], stops[stops.len() - 1]];
        assert!(ends.contains(&Color::new(30, 30, 30)) && ends.contains(&Color::new(250, 250, 250)));
        assert!((area(&found) - 1e4).abs() < 1e-3);
    }

    #[test]
    fn one_colour_is_flat_and_turning_colours_are_cut_up() {
        let flat = shaded(&square([90; 4]), &VIEW, 10.0);
        assert!(matches!(flat.as_slice(), [Patch { shade: Shade::Flat(_), .. }]));
        let saddle = shaded(&square([30, 250, 30, 250]), &VIEW, 10.0);
        assert!(saddle.len() >= 2);
        assert!((area(&saddle) - 1e4).abs() < 1e-3, "{}", area(&saddle));
        let mut three = square([30, 250, 30, 250]);
        three.colors[1] = Color::new(250, 0, 0).to_oklab();
        three.colors[2] = Color::new(0, 0, 250).to_oklab();
        let three = shaded(&three, &VIEW, 10.0);
        assert!(three.len() > 8 && (area(&three) - 1e4).abs() < 1e-3);
    }

    #[test]
    fn only_the_part_in_the_frame_is_kept() {
        let near = Viewport { scale: 1e6, ..VIEW };
        let found = shaded(&square([30, 250, 250, 30]), &near, 0.0);
        assert!((area(&found) - 1e4).abs() < 1.0, "{}", area(&found));
    }
}
