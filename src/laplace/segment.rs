//! Integrals over a straight segment in the plane.
//!
//! With s along the segment from the foot of the point, h the distance to its line and theta the angle under which it is seen,
//! the integral of ln r is [s ln r] - L + h theta.

use super::panel::{LayerGradients, Layers, Panel};
use glam::DVec3;
use std::f64::consts::TAU;

struct Seen {
    /// Direction of the segment.
    along: DVec3,
    /// Places of the ends along it, from the foot of the point.
    ends: [f64; 2],
    /// Height of the line above the point, positive from inside.
    height: f64,
    /// Signed angle, 0 on the line itself.
    angle: f64,
}

fn seen(panel: &Panel, x: DVec3) -> Seen {
    let [a, b, _] = panel.corners;
    let along = (b - a) / panel.size;
    let (from, to) = (a - x, b - x);
    let height = from.dot(panel.normal);
    let is_in_line = height.abs() <= panel.rounding();
    // The cross product is that of the ends as seen from the point, which is positive from inside.
    let angle =
        if is_in_line { 0.0 } else { (from.x * to.y - from.y * to.x).atan2(from.x * to.x + from.y * to.y) };
    Seen { along, ends: [from.dot(along), to.dot(along)], height, angle }
}

/// s ln r at an end; its limit 0 on the end itself.
fn term(s: f64, height: f64) -> f64 {
    let squared = s * s + height * height;
    if squared > 0.0 { 0.5 * s * squared.ln() } else { 0.0 }
}

/// Both integrals.
pub(super) fn layers(panel: &Panel, x: DVec3) -> Layers {
    let Seen { ends: [a, b], height, angle, .. } = seen(panel, x);
    let logarithms = term(b, height) - term(a, height) - panel.size + height * angle;
    Layers { single: -logarithms / TAU, double: angle / TAU }
}

/// Their gradients.
pub(super) fn gradients(panel: &Panel, x: DVec3) -> LayerGradients {
    let Seen { along, ends: [a, b], height, angle } = seen(panel, x);
    let squares = [a, b].map(|s| s * s + height * height);
    // Of the integral of ln r: minus that of (y - x)/r^2.
    let single = along * (-0.5 * (squares[1] / squares[0]).ln()) - panel.normal * angle;
    // The angle between the directions to the ends: an end at (s, h) turns by the cross product over its square.
    let turn = |s: f64, square: f64| (panel.normal * s - along * height) / square;
    let double = turn(b, squares[1]) - turn(a, squares[0]);
    LayerGradients { single: -single / TAU, double: double / TAU }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laplace::panel::Space;

    fn panel() -> Panel {
        let [a, b] = [DVec3::new(0.2, -0.1, 0.0), DVec3::new(0.9, 0.4, 0.0)];
        Space::Plane.panel([a, b, b])
    }

    /// By the midpoint rule on many pieces.
    fn summed(panel: &Panel, x: DVec3) -> Layers {
        let count = 200_000;
        let mut sum = Layers::default();
        for k in 0..count {
            let y = panel.corners[0].lerp(panel.corners[1], (f64::from(k) + 0.5) / f64::from(count));
            let r = y - x;
            sum.single -= r.length().ln();
            sum.double += r.dot(panel.normal) / r.length_squared();
        }
        let weight = panel.size / f64::from(count) / TAU;
        Layers { single: sum.single * weight, double: sum.double * weight }
    }

    #[test]
    fn integrals_are_those_of_a_sum_over_many_pieces() {
        let panel = panel();
        for x in [
            DVec3::new(0.5, 0.5, 0.0),
            DVec3::new(0.6, 0.0, 0.0),
            DVec3::new(-3.0, 1.0, 0.0),
            DVec3::new(1.2, 0.61, 0.0),
        ] {
            let (exact, sum) = (layers(&panel, x), summed(&panel, x));
            assert!((exact.single - sum.single).abs() < 1e-9, "{exact:?}, not {sum:?}");
            assert!((exact.double - sum.double).abs() < 1e-9, "{exact:?}, not {sum:?}");
        }
        let own = layers(&panel, panel.centre);
        assert_eq!(own.double, 0.0);
        assert!((own.single + panel.size * ((panel.size / 2.0).ln() - 1.0) / TAU).abs() < 1e-15);
        assert!(layers(&panel, panel.corners[0]).single.is_finite(), "on an end");
        assert!(layers(&panel, panel.centre - panel.normal * 1e-9).double > 0.499, "from inside");
    }

    #[test]
    fn gradients_are_differences() {
        let panel = panel();
        for x in [DVec3::new(0.5, 0.5, 0.0), DVec3::new(0.6, 0.0, 0.0), DVec3::new(-3.0, 1.0, 0.0)] {
            let exact = gradients(&panel, x);
            for axis in [DVec3::X, DVec3::Y] {
                let [up, down] = [1e-5, -1e-5].map(|step| layers(&panel, x + axis * step));
                assert!((exact.single.dot(axis) - (up.single - down.single) / 2e-5).abs() < 1e-8);
                assert!((exact.double.dot(axis) - (up.double - down.double) / 2e-5).abs() < 1e-8);
            }
        }
    }
}
