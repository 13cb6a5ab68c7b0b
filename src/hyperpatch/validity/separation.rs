//! Planes that separate points, found by walking towards the point of a hull that is nearest to the origin.
//!
//! What a search finds is checked on every point, so a result never depends on how it was found.

use glam::DVec3;

/// Most steps of a search.
const MOST_STEPS: usize = 40;

/// Sine of the angle by which a direction must be on the positive side of each vector.
const SINE: f64 = 1e-9;

/// Distance of two hulls over their largest coordinate that no rounding can feign.
const GAP: f64 = 1e-13;

/// A unit vector that has a positive product with all vectors, none of which may be zero, or `None` when none was
/// found.
///
/// # References
/// E. Gilbert, "An iterative procedure for computing the minimum of a quadratic form on a convex set", *SIAM Journal
/// on Control* 4 (1966).
pub(in crate::hyperpatch) fn positive_direction(vectors: &[DVec3]) -> Option<DVec3> {
    let units: Vec<DVec3> = vectors.iter().map(|v| v.normalize_or_zero()).collect();
    let mut nearest = units.iter().sum::<DVec3>() / units.len() as f64;
    for _ in 0..MOST_STEPS {
        let length = nearest.length();
        let (least, vector) = lowest(&units, nearest);
        if least > SINE * length && length > 0.0 {
            return Some(nearest / length);
        }
        nearest = step(nearest, vector)?;
    }
    None
}

/// Whether a plane was found that strictly separates two lists of points.
pub(in crate::hyperpatch) fn are_separated(a: &[DVec3], b: &[DVec3]) -> bool {
    let (low_a, high_a) = bounds(a);
    let (low_b, high_b) = bounds(b);
    let largest = [low_a, high_a, low_b, high_b].iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    let gap = GAP * largest;
    if (low_a - high_b).max_element() > gap || (low_b - high_a).max_element() > gap {
        return true;
    }
    let mean = |points: &[DVec3]| points.iter().sum::<DVec3>() / points.len() as f64;
    let mut nearest = mean(a) - mean(b);
    for _ in 0..MOST_STEPS {
        let (low, first) = lowest(a, nearest);
        let (high, second) = lowest(b, -nearest);
        if low + high > gap * nearest.length() {
            return true;
        }
        match step(nearest, first - second) {
            Some(next) => nearest = next,
            None => return false,
        }
    }
    false
}

/// The least product of a point with a direction, and the point.
fn lowest(points: &[DVec3], direction: DVec3) -> (f64, DVec3) {
    points.iter().fold((f64::INFINITY, DVec3::ZERO), |best, &point| {
        let product = point.dot(direction);
        if product < best.0 { (product, point) } else { best }
    })
}

/// The point of a segment that is nearest to the origin; `None` when it is the origin, or no nearer than the start.
fn step(from: DVec3, to: DVec3) -> Option<DVec3> {
    let along = to - from;
    let share = -from.dot(along) / along.length_squared();
    let next = from + along * share.min(1.0);
    (share > 0.0 && next.length_squared() > 0.0).then_some(next)
}

/// Smallest and largest coordinates.
fn bounds(points: &[DVec3]) -> (DVec3, DVec3) {
    points.iter().fold((points[0], points[0]), |(lo, hi), &point| (lo.min(point), hi.max(point)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::Net;
    use crate::hyperpatch::test_cells::random_place;
    use glam::DMat3;

    #[test]
    fn separated_cubes_are_told_from_those_that_meet() {
        let cube = Net::cuboid(DVec3::ZERO, DVec3::ONE).0;
        // A cube turned onto a corner reaches sqrt(3) / 2 from its middle, and less along other directions.
        let turn =
            DMat3::from_axis_angle(DVec3::new(1.0, -1.0, 0.0).normalize(), (1.0 / 3.0_f64.sqrt()).acos());
        let turned =
            |height: f64| cube.map(|p| turn * (p - DVec3::splat(0.5)) + DVec3::new(0.5, 0.5, height));
        let touching = 1.0 + 3.0_f64.sqrt() / 2.0;
        assert!(are_separated(&cube, &turned(touching + 1e-6)));
        assert!(!are_separated(&cube, &turned(touching - 1e-6)));
        assert!(!are_separated(&cube, &cube));
        assert!(!are_separated(&cube, &cube.map(|p| p + DVec3::X)), "a shared face is no gap");
    }

    /// Segments on crossing lines, whose boxes overlap.
    #[test]
    fn boxes_that_overlap_need_an_oblique_plane() {
        let a = [DVec3::new(0.0, 0.0, 0.0), DVec3::new(1.0, 1.0, 0.0)];
        let b = [DVec3::new(0.0, 1.0, 0.01), DVec3::new(1.0, 0.0, 0.01)];
        let c = [DVec3::new(0.5, 0.0, 0.0), DVec3::new(1.0, 0.49, 0.0)];
        assert!(are_separated(&a, &b) && are_separated(&a, &c));
        assert!(!are_separated(&a, &b.map(|p| p.truncate().extend(0.0))));
    }

    #[test]
    fn vectors_on_one_side_have_a_direction() {
        let vectors: Vec<DVec3> = (0..30).map(random_place).collect();
        let found = positive_direction(&vectors).unwrap();
        assert!(vectors.iter().all(|v| v.dot(found) > 0.0));
        let mut both = vectors.clone();
        both.extend(vectors.iter().map(|v| -*v));
        assert_eq!(positive_direction(&both), None);
        assert_eq!(positive_direction(&[DVec3::X, DVec3::ZERO]), None);
        assert_eq!(positive_direction(&[DVec3::X, DVec3::Y, DVec3::NEG_ONE * 0.5 + DVec3::Z * 0.5]), None);
        let narrow = [
            DVec3::new(1.0, 0.01, 0.0),
            DVec3::new(-1.0, 0.01, 0.0),
            DVec3::Z,
            DVec3::new(0.0, 0.0, -1.0) + DVec3::Y,
        ];
        assert!(positive_direction(&narrow).is_some());
    }
}
