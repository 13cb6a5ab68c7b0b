//! Corners of a polyline, told from noise and from bends.

use glam::DVec2;

/// Smallest turn in degrees that counts as a corner.
pub(super) const SMALLEST_TURN: f64 = 40.0;
/// Length of the legs of a turn, in tolerances: a jitter of one tolerance turns them by less than a corner does.
const LEG: f64 = 4.0;
/// Longest leg as a share of the whole way: a circle turns by less than a quarter of a corner over two of them.
const LONGEST: f64 = 0.02;

/// Indices of the vertices of a closed polyline, given without repeating the first, that are corners on the scale of the
/// tolerance; ascending.
///
/// A corner is a vertex at which the ways of a few tolerances before and after it make an angle of at least
/// 40 degrees, and more than at any other vertex so near.
pub(super) fn corners(points: &[DVec2], tolerance: f64) -> Vec<usize> {
    let count = points.len();
    let mut arc = vec![0.0];
    for i in 0..count {
        arc.push(arc[i] + points[i].distance(points[(i + 1) % count]));
    }
    let length = arc[count];
    let leg = (LEG * tolerance).min(LONGEST * length);
    let mut turns: Vec<(usize, f64)> = Vec::new();
    for (i, &vertex) in points.iter().enumerate() {
        let before = vertex - at(points, &arc, arc[i] - leg);
        let after = at(points, &arc, arc[i] + leg) - vertex;
        let turn = before.perp_dot(after).atan2(before.dot(after)).abs().to_degrees();
        if turn >= SMALLEST_TURN {
            turns.push((i, turn));
        }
    }
    turns.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
    let mut found: Vec<usize> = Vec::new();
    let mut blocked = vec![false; count];
    for (i, _) in turns {
        if blocked[i] {
            continue;
        }
        found.push(i);
        let near = |k: usize| {
            let apart = (arc[k] - arc[i]).abs();
            apart.min(length - apart) <= leg
        };
        for step in 1..count {
            let k = (i + step) % count;
            if !near(k) {
                break;
            }
            blocked[k] = true;
        }
        for step in 1..count {
            let k = (i + count - step) % count;
            if !near(k) {
                break;
            }
            blocked[k] = true;
        }
    }
    found.sort_unstable();
    found
}

/// The point at a length of the way, which wraps.
fn at(points: &[DVec2], arc: &[f64], s: f64) -> DVec2 {
    let count = points.len();
    let s = s.rem_euclid(arc[count]);
    let edge = arc.partition_point(|&start| start <= s).clamp(1, count) - 1;
    let share = (s - arc[edge]) / (arc[edge + 1] - arc[edge]);
    points[edge].lerp(points[(edge + 1) % count], share.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;
    use std::f64::consts::TAU;

    fn regular(count: usize) -> Vec<DVec2> {
        (0..count).map(|k| DVec2::from_angle(TAU * k as f64 / count as f64)).collect()
    }

    #[test]
    fn a_polygon_has_corners_and_a_circle_has_none() {
        assert_eq!(corners(&regular(4), 0.01), [0, 1, 2, 3]);
        assert_eq!(corners(&regular(8), 0.01), (0..8).collect::<Vec<_>>());
        assert!(corners(&regular(12), 0.01).is_empty());
        for tolerance in [1e-4, 0.01, 0.1, 1.0] {
            assert!(corners(&regular(400), tolerance).is_empty(), "tolerance {tolerance}");
        }
    }

    #[test]
    fn jitter_of_the_size_of_the_tolerance_is_no_corner() {
        let jitter = |k: usize| 0.004 * if k.is_multiple_of(3) { 1.0 } else { -1.0 };
        let noisy: Vec<_> = regular(500).iter().enumerate().map(|(k, p)| *p * (1.0 + jitter(k))).collect();
        assert!(!corners(&noisy, 1e-6).is_empty(), "on its own scale every tooth is a corner");
        assert!(corners(&noisy, 0.01).is_empty());
    }

    #[test]
    fn a_corner_rounded_below_the_tolerance_is_one() {
        let mut points = vec![dvec2(0.0, 0.0), dvec2(10.0, 0.0)];
        let arc = (0..=6).map(|k| dvec2(10.0, 9.99) + 0.01 * DVec2::from_angle(TAU / 24.0 * f64::from(k)));
        points.extend(arc.map(|p| p - dvec2(0.01, 0.0)));
        points.push(dvec2(0.0, 10.0));
        assert_eq!(corners(&points, 0.05).len(), 4);
    }
}
