//! Integrals over a flat triangle.
//!
//! The solid angle is that of van Oosterom and Strackee (1983); the integral of 1/r is a sum over the sides less the height times it, so that one
//! arctangent serves both.

use super::panel::{LayerGradients, Layers, Panel};
use glam::DVec3;
use std::f64::consts::PI;

/// A side as seen from a point.
struct Side {
    /// Its direction.
    along: DVec3,
    /// Outwards, in the plane of the triangle.
    across: DVec3,
    /// Distance of the side from the foot of the point, positive when the foot is on the inner side.
    distance: f64,
    /// Places of the ends along it.
    ends: [f64; 2],
    /// Distances of the ends.
    far: [f64; 2],
}

impl Side {
    /// The integral of 1/r along the side; 0 where the point is on its line, which counts for nothing there.
    fn logarithm(&self) -> f64 {
        let [[a, b], [ra, rb]] = [self.ends, self.far];
        // On the far side of the foot both sums cancel, and the differences do not.
        let (over, under) = if a + b < 0.0 { (ra - a, rb - b) } else { (rb + b, ra + a) };
        if under > 0.0 && over > 0.0 { (over / under).ln() } else { 0.0 }
    }
}

struct Seen {
    sides: [Side; 3],
    height: f64,
    angle: f64,
}

#[inline(always)]
fn seen(panel: &Panel, x: DVec3) -> Seen {
    let r = panel.corners.map(|corner| corner - x);
    let far = r.map(|r| r.length());
    let height = r[0].dot(panel.normal);
    let is_in_plane = height.abs() <= panel.rounding();
    let angle = if is_in_plane {
        0.0
    } else {
        let volume = r[0].dot(r[1].cross(r[2]));
        let below = far[0] * far[1] * far[2]
            + r[0].dot(r[1]) * far[2]
            + r[1].dot(r[2]) * far[0]
            + r[2].dot(r[0]) * far[1];
        2.0 * volume.atan2(below)
    };
    let side = |k: usize| {
        let next = (k + 1) % 3;
        let along = (r[next] - r[k]).normalize();
        let across = along.cross(panel.normal);
        Side {
            along,
            across,
            distance: r[k].dot(across),
            ends: [r[k].dot(along), r[next].dot(along)],
            far: [far[k], far[next]],
        }
    };
    Seen { sides: [side(0), side(1), side(2)], height, angle }
}

/// Both integrals.
pub(super) fn layers(panel: &Panel, x: DVec3) -> Layers {
    let Seen { sides, height, angle } = seen(panel, x);
    let sum: f64 = sides.iter().map(|side| side.distance * side.logarithm()).sum();
    Layers { single: (sum - height * angle) / (4.0 * PI), double: angle / (4.0 * PI) }
}

/// Their gradients: in the plane by the theorem of Gauss, across it by the solid angle, and of that by the law of Biot and Savart.
pub(super) fn gradients(panel: &Panel, x: DVec3) -> LayerGradients {
    let Seen { sides, height, angle } = seen(panel, x);
    let mut gradients = LayerGradients { single: panel.normal * angle, double: DVec3::ZERO };
    for side in &sides {
        let [[a, b], [ra, rb]] = [side.ends, side.far];
        gradients.single -= side.across * side.logarithm();
        let arm = side.across * side.distance + panel.normal * height;
        let square = arm.length_squared();
        if square > 0.0 {
            gradients.double += arm.cross(side.along) * ((b / rb - a / ra) / square);
        }
    }
    LayerGradients { single: gradients.single / (4.0 * PI), double: gradients.double / (4.0 * PI) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laplace::panel::Space;

    fn panel() -> Panel {
        Space::Solid.panel([DVec3::new(0.1, 0.2, -0.3), DVec3::new(1.0, 0.1, 0.2), DVec3::new(0.3, 0.9, 0.4)])
    }

    /// By the midpoint rule on many small triangles.
    fn summed(panel: &Panel, x: DVec3) -> Layers {
        let count = 500;
        let [a, b, c] = panel.corners;
        let mut sum = Layers::default();
        let mut add = |u: f64, v: f64| {
            let r = a + (b - a) * u + (c - a) * v - x;
            sum.single += 1.0 / r.length();
            sum.double += r.dot(panel.normal) / r.length().powi(3);
        };
        let step = 1.0 / f64::from(count);
        for i in 0..count {
            for j in 0..count - i {
                let [u, v] = [i, j].map(|k| f64::from(k) * step);
                add(u + step / 3.0, v + step / 3.0);
                if j + 1 < count - i {
                    add(u + 2.0 * step / 3.0, v + 2.0 * step / 3.0);
                }
            }
        }
        let weight = panel.size * step * step / (4.0 * PI);
        Layers { single: sum.single * weight, double: sum.double * weight }
    }

    const PLACES: [DVec3; 4] = [
        DVec3::new(0.5, 0.4, 0.5),
        DVec3::new(0.5, 0.4, -0.4),
        DVec3::new(-2.0, 1.0, 0.4),
        DVec3::new(1.4, -0.1, 0.6),
    ];

    #[test]
    fn integrals_are_those_of_a_sum_over_many_pieces() {
        let panel = panel();
        for x in PLACES {
            let (exact, sum) = (layers(&panel, x), summed(&panel, x));
            assert!((exact.single - sum.single).abs() < 2e-6, "{exact:?}, not {sum:?}");
            assert!((exact.double - sum.double).abs() < 2e-5, "{exact:?}, not {sum:?}");
        }
        assert_eq!(layers(&panel, panel.centre).double, 0.0);
        for side in [1e-7, -1e-7] {
            let near = layers(&panel, panel.centre - panel.normal * side);
            assert!((near.double - 0.5 * side.signum()).abs() < 1e-6, "{near:?}");
        }
        for x in [
            panel.corners[0],
            panel.corners[0].lerp(panel.corners[1], 0.3),
            panel.corners[2] * 2.0 - panel.corners[1],
        ] {
            assert!(layers(&panel, x).single.is_finite(), "on a corner, on a side, and on its line");
        }
    }

    #[test]
    fn the_own_potential_of_an_equilateral_triangle_is_known() {
        let corner = |k: f64| DVec3::new((k * 2.0 * PI / 3.0).cos(), (k * 2.0 * PI / 3.0).sin(), 0.0);
        let panel = Space::Solid.panel([corner(0.0), corner(1.0), corner(2.0)]);
        // Three sides at distance 1/2, each seen under 120 degrees: 3 (1/2) 2 artanh(sin 60).
        let expected = 3.0 * (3.0_f64.sqrt() / 2.0).atanh() / (4.0 * PI);
        assert!((layers(&panel, panel.centre).single - expected).abs() < 1e-15);
    }

    #[test]
    fn gradients_are_differences() {
        let panel = panel();
        for x in PLACES {
            let exact = gradients(&panel, x);
            for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
                let [up, down] = [1e-5, -1e-5].map(|step| layers(&panel, x + axis * step));
                assert!((exact.single.dot(axis) - (up.single - down.single) / 2e-5).abs() < 1e-8);
                assert!((exact.double.dot(axis) - (up.double - down.double) / 2e-5).abs() < 1e-8);
            }
        }
    }
}
