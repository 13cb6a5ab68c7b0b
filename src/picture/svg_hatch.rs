//! The polygons that hatches cover, for SVG.

use glam::DVec2;

use super::clip::{Frame, cut};
use super::hatch::{FULL, Lines};
use super::{Blends, Path, Viewport};

/// Smaller fractions are not drawn.
const LEAST: f64 = 1e-6;

/// Room round the picture in which lines are kept, in device pixels.
const MARGIN: f64 = 16.0;

/// A corner on the screen, with the fraction of one material.
type Corner = (DVec2, f64);

/// The areas that the hatch of a material covers, in document units.
pub(super) fn hatch(blends: &Blends, material: usize, viewport: &Viewport) -> Path {
    let lines = Lines::new(material, viewport);
    let frame = Frame::around(viewport, MARGIN);
    let corner = |index: u32| {
        let index = index as usize;
        (viewport.place(blends.vertices[index]), blends.fraction(index, material))
    };
    let mut covered = Vec::new();
    for triangle in &blends.triangles {
        lines.cover(triangle.map(corner), &frame, &mut covered);
    }
    let units = |ring: Vec<DVec2>| ring.into_iter().map(|p| viewport.to_units(p)).collect();
    Path { rings: covered.into_iter().map(units).collect(), closed: true }
}

impl Lines {
    /// Adds what the lines cover of a triangle.
    fn cover(&self, triangle: [Corner; 3], frame: &Frame, covered: &mut Vec<Vec<DVec2>>) {
        let [a, b, c] = triangle;
        // All polygons turn the same way, so that those that touch are one area.
        let turn = (b.0 - a.0).perp_dot(c.0 - a.0);
        let mut ring = if turn < 0.0 { vec![a, c, b] } else { vec![a, b, c] };
        if turn == 0.0 || ring.iter().all(|corner| corner.1 < LEAST) {
            return;
        }
        let lerp = |p: Corner, q: Corner, t: f64| (p.0.lerp(q.0, t), p.1 + (q.1 - p.1) * t);
        if ring.iter().any(|corner| !frame.contains(corner.0)) {
            let (min, max) = (frame.min, frame.max);
            for (axis, bound, sign) in [(0, min.x, 1.0), (0, max.x, -1.0), (1, min.y, 1.0), (1, max.y, -1.0)]
            {
                ring = cut(&ring, |corner| sign * (corner.0[axis] - bound), lerp);
            }
        }
        let place = |corner: &Corner| self.normal.dot(corner.0) - self.phase;
        let low = ring.iter().map(place).fold(f64::INFINITY, f64::min);
        let high = ring.iter().map(place).fold(f64::NEG_INFINITY, f64::max);
        if low > high {
            return;
        }
        let half = |corner: &Corner| corner.1 * FULL * self.period / 2.0;
        let reach = FULL * self.period / 2.0;
        let last = ((high + reach) / self.period).floor() as i64;
        for k in ((low - reach) / self.period).ceil() as i64..=last {
            let line = k as f64 * self.period;
            let above = cut(&ring, |corner| half(corner) - (place(corner) - line), lerp);
            let both = cut(&above, |corner| half(corner) + (place(corner) - line), lerp);
            if both.len() >= 3 {
                covered.push(both.into_iter().map(|corner| corner.0).collect());
            }
        }
    }
}
