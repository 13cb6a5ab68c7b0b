//! From a point of space back to the parameters of a cell.

use super::{Axis, Net};
use glam::{DMat3, DVec3};

/// How far outside [0, 1] a parameter may be for a point on the boundary to count as inside.
pub(super) const SLACK: f64 = 1e-9;

/// Most steps of Newton's iteration; from nearby it takes four.
const MOST_STEPS: usize = 12;

/// Change of the parameters at which Newton's iteration has arrived.
const ARRIVED: f64 = 1e-11;

/// Most halvings of a part of a cell.
const MOST_HALVINGS: usize = 60;

/// Most parts that are looked at; only in cells that are nearly flat there are more.
const MOST_PARTS: usize = 1000;

/// Parameters of the volume at `target`, from a start nearby, by Newton's iteration; `None` when it leaves the cell
/// or does not arrive. Parameters outside [0, 1] by no more than [`SLACK`] are moved onto the boundary.
pub(super) fn newton(net: &Net, target: DVec3, start: DVec3) -> Option<DVec3> {
    let mut at = start;
    for _ in 0..MOST_STEPS {
        let (point, derivatives) = net.point_and_derivatives(at);
        let step = solve(derivatives, target - point)?;
        at += step;
        if !(at.min_element() > -0.5 && at.max_element() < 1.5) {
            return None;
        }
        if step.abs().max_element() < ARRIVED {
            let is_inside = at.min_element() >= -SLACK && at.max_element() <= 1.0 + SLACK;
            return is_inside.then(|| at.clamp(DVec3::ZERO, DVec3::ONE));
        }
    }
    None
}

/// The combination of three vectors that is `sum`, or `None` when they are dependent.
fn solve([a, b, c]: [DVec3; 3], sum: DVec3) -> Option<DVec3> {
    let normals = [b.cross(c), c.cross(a), a.cross(b)];
    let determinant = a.dot(normals[0]);
    let step = DVec3::from_array(normals.map(|normal| normal.dot(sum))) / determinant;
    step.is_finite().then_some(step)
}

/// A part of a volume, moved so that the point looked for is the origin.
struct Part {
    net: Net,
    lo: DVec3,
    size: DVec3,
    halvings: usize,
}

impl Net {
    /// Parameters of a point, or `None` when it does not lie in the volume.
    ///
    /// Parts whose control points all lie on one side of the point, in the axes of space or in those of the part, are
    /// left out; in the others Newton's iteration is tried, and they are halved. Points within 1e-9 of the boundary,
    /// in parameters, count as inside. In a volume that meets itself, one of the places is found; in one that is
    /// nearly flat, points may be missed.
    #[must_use]
    pub fn invert(&self, target: DVec3) -> Option<DVec3> {
        let whole = Part { net: self.map(|p| p - target), lo: DVec3::ZERO, size: DVec3::ONE, halvings: 0 };
        let (lo, hi) = self.bounds();
        let slack = (hi - lo).max_element() * SLACK;
        let mut stack = vec![whole];
        for _ in 0..MOST_PARTS {
            let part = stack.pop()?;
            if part.is_off(slack) {
                continue;
            }
            if let Some(found) = newton(self, target, part.lo + part.size / 2.0) {
                return Some(found);
            }
            if part.halvings < MOST_HALVINGS {
                stack.extend(part.halves());
            }
        }
        None
    }
}

impl Part {
    /// Whether the control points lie on one side of the origin along an axis of space or of the part.
    fn is_off(&self, slack: f64) -> bool {
        let is_off = |net: &Net, slack: DVec3| {
            let (lo, hi) = net.bounds();
            lo.cmpgt(slack).any() || hi.cmplt(-slack).any()
        };
        if is_off(&self.net, DVec3::splat(slack)) {
            return true;
        }
        let [a, b, c] = self.net.derivatives(DVec3::splat(0.5));
        let frame = DMat3::from_cols(a, b, c).inverse();
        // A part without volume has no frame; comparisons with what is not a number are false then.
        is_off(&self.net.map(|p| frame * p), DVec3::splat(SLACK) / self.size)
    }

    /// The two halves across the axis along which the part is longest.
    fn halves(&self) -> [Self; 2] {
        let middle = self.net.derivatives(DVec3::splat(0.5)).map(DVec3::length_squared);
        let longest = |a: &Axis, b: &Axis| {
            let share = |axis: &Axis| (middle[*axis as usize], self.size[*axis as usize]);
            let ((a, size_a), (b, size_b)) = (share(a), share(b));
            a.total_cmp(&b).then(size_a.total_cmp(&size_b))
        };
        let axis = Axis::ALL.into_iter().max_by(longest).unwrap_or(Axis::U);
        let [first, second] = self.net.split(axis, 0.5);
        let half = axis.unit() * (self.size[axis as usize] / 2.0);
        let (size, halvings) = (self.size - half, self.halvings + 1);
        [
            Self { net: second, lo: self.lo + half, size, halvings },
            Self { net: first, lo: self.lo, size, halvings },
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::test_cells::{quarter_ring, random_net, random_place, ring_cell, twisted};

    #[test]
    fn points_are_found_where_they_come_from() {
        for net in [quarter_ring(1.0, 2.0, 0.5), twisted(90.0), twisted(150.0), random_net(1, 0.15)] {
            for seed in 0..300 {
                let at = random_place(seed);
                let found = net.invert(net.point(at)).expect("the point is inside");
                assert!((found - at).abs().max_element() < 1e-9, "{found}, expected {at}");
            }
            for corner in crate::hyperpatch::Corner::all() {
                let at = corner.parameters();
                assert!((net.invert(net.point(at)).expect("a corner") - at).length() < 1e-8);
            }
        }
    }

    /// Radius, angle and height say whether a point lies in a cell of a ring.
    #[test]
    fn points_outside_are_not_found() {
        let net = ring_cell(8, 1, 1.0, 2.0, 0.5);
        let mut counts = [0, 0];
        for seed in 0..2000 {
            let point = random_place(seed) * DVec3::new(2.2, 2.2, 0.6);
            let (radius, angle) = (point.truncate().length(), point.y.atan2(point.x).to_degrees());
            let is_inside = (1.0..2.0).contains(&radius) && (45.0..90.0).contains(&angle) && point.z < 0.5;
            let is_near = (radius - 1.0).abs() < 1e-4 || (radius - 2.0).abs() < 1e-4;
            if !is_near {
                counts[usize::from(is_inside)] += 1;
                assert_eq!(net.invert(point).is_some(), is_inside, "{point}");
            }
        }
        assert!(counts[0] > 300 && counts[1] > 300);
    }

    #[test]
    fn points_just_off_a_face_are_outside_and_take_no_long_search() {
        let net = quarter_ring(1.0, 2.0, 1.0);
        for seed in 0..50 {
            let at = random_place(seed);
            let on = net.point(DVec3::new(at.x, at.y, 1.0));
            assert!(net.invert(on + DVec3::Z * 1e-7).is_none());
            assert!(net.invert(on + DVec3::Z * 1e-11).is_some());
        }
    }

    #[test]
    fn cells_without_volume_find_nothing_and_end() {
        let flat = Net::cuboid(DVec3::ZERO, DVec3::ONE).map(|p| DVec3::new(p.x, p.y, 0.0));
        assert_eq!(flat.invert(DVec3::new(0.5, 0.5, 0.1)), None);
        let point = flat.map(|_| DVec3::ONE);
        assert_eq!(point.invert(DVec3::ZERO), None);
        assert_eq!(point.invert(DVec3::ONE), None);
        assert_eq!(flat.invert(DVec3::new(0.3, 0.4, 0.0)), None);
    }
}
