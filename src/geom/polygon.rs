//! Questions about simple polygons, given as their vertices in order, the first not repeated, and about open polylines.

use super::{SegmentGrid, orient2d, segments_meet};
use glam::DVec2;

/// Where a point lies with respect to a polygon.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Location {
    /// Strictly inside.
    Inside,
    /// On an edge or a vertex.
    Boundary,
    /// Strictly outside.
    Outside,
}

/// Returns the area of a polygon, positive when its vertices run counter-clockwise with y up.
#[must_use]
pub fn signed_area(polygon: &[DVec2]) -> f64 {
    let Some(&origin) = polygon.first() else { return 0.0 };
    edges(polygon).map(|(a, b)| (a - origin).perp_dot(b - origin)).sum::<f64>() / 2.0
}

/// Returns where `point` lies with respect to a simple polygon of either orientation. Exact.
#[must_use]
pub fn locate(polygon: &[DVec2], point: DVec2) -> Location {
    let mut inside = false;
    for (a, b) in edges(polygon) {
        if (a.y > point.y) == (b.y > point.y) {
            // The edge does not cross the horizontal line of the point; it may lie on it.
            let (low, high) = (a.min(b), a.max(b));
            let in_box = low.cmple(point).all() && point.cmple(high).all();
            if in_box && orient2d(a, b, point) == 0.0 {
                return Location::Boundary;
            }
            continue;
        }
        let side = orient2d(a, b, point);
        if side == 0.0 {
            return Location::Boundary;
        }
        if (side > 0.0) == (b.y > a.y) {
            inside = !inside;
        }
    }
    if inside { Location::Inside } else { Location::Outside }
}

/// Returns two edges of a polygon, or of an open polyline where `closed` is false, by the index of their first vertex, that meet
/// although they are not neighbours, or neighbours that run back over each other; `None` when it is simple. Exact.
#[must_use]
pub fn first_self_contact(polygon: &[DVec2], closed: bool) -> Option<(usize, usize)> {
    let n = polygon.len();
    let vertex = |i: usize| polygon[i % n];
    let open = usize::from(!closed);
    for i in 0..n - 2 * open {
        let (a, b, c) = (vertex(i), vertex(i + 1), vertex(i + 2));
        let folds_back = orient2d(a, b, c) == 0.0 && (b - a).dot(c - b) <= 0.0;
        if folds_back {
            return Some((i, (i + 1) % n));
        }
    }
    let grid = SegmentGrid::new(edges(polygon).take(n - open).collect());
    (0..n - open).find_map(|i| {
        let (a, b) = (vertex(i), vertex(i + 1));
        let neighbour = |k: usize| k == i || (k + 1) % n == i || (i + 1) % n == k;
        grid.find(a, b, |k, c, d| !neighbour(k) && segments_meet(a, b, c, d)).map(|k| (i.min(k), i.max(k)))
    })
}

/// Returns an edge of each of two polygons, or open polylines where `closed` is false, by the index of its first vertex, that meet;
/// `None` when the outlines have no point in common. Exact; it does not look at which polygon contains the other.
#[must_use]
pub fn first_contact(first: &[DVec2], second: &[DVec2], closed: bool) -> Option<(usize, usize)> {
    let open = usize::from(!closed);
    let grid = SegmentGrid::new(edges(second).take(second.len() - open).collect());
    edges(first)
        .take(first.len() - open)
        .enumerate()
        .find_map(|(i, (a, b))| grid.find(a, b, |_, c, d| segments_meet(a, b, c, d)).map(|k| (i, k)))
}

fn edges(polygon: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().copied().zip(next.copied())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

    const SQUARE: [DVec2; 4] = [dvec2(0.0, 0.0), dvec2(2.0, 0.0), dvec2(2.0, 2.0), dvec2(0.0, 2.0)];

    #[test]
    fn area_has_the_sign_of_the_orientation() {
        assert_eq!(signed_area(&SQUARE), 4.0);
        let mut clockwise = SQUARE;
        clockwise.reverse();
        assert_eq!(signed_area(&clockwise), -4.0);
        assert_eq!(signed_area(&[]), 0.0);
    }

    #[test]
    fn points_of_a_square_are_located() {
        let expect = [
            (dvec2(1.0, 1.0), Location::Inside),
            (dvec2(3.0, 2.0), Location::Outside),
            (dvec2(-1.0, 0.0), Location::Outside),
            (dvec2(2.0, 1.0), Location::Boundary),
            (dvec2(1.0, 2.0), Location::Boundary),
            (dvec2(0.0, 0.0), Location::Boundary),
            (dvec2(1.0, 2.0 + 1e-15), Location::Outside),
        ];
        for (point, location) in expect {
            assert_eq!(locate(&SQUARE, point), location, "{point}");
        }
    }

    #[test]
    fn bow_tie_and_spike_are_not_simple() {
        let bow_tie = [SQUARE[0], SQUARE[2], SQUARE[1], SQUARE[3]];
        assert_eq!(first_self_contact(&bow_tie, true), Some((0, 2)));
        let spike = [SQUARE[0], dvec2(3.0, 0.0), SQUARE[1], SQUARE[2], SQUARE[3]];
        assert_eq!(first_self_contact(&spike, true), Some((0, 1)));
        assert_eq!(first_self_contact(&SQUARE, true), None);
        let straight = [SQUARE[0], dvec2(1.0, 0.0), SQUARE[1], SQUARE[2], SQUARE[3]];
        assert_eq!(first_self_contact(&straight, true), None, "a straight vertex is no contact");
    }

    #[test]
    fn outlines_touch_at_a_vertex_or_not_at_all() {
        let shifted = SQUARE.map(|p| p + dvec2(2.0, 2.0));
        assert!(first_contact(&SQUARE, &shifted, true).is_some());
        let inner = SQUARE.map(|p| p * 0.5 + dvec2(0.5, 0.5));
        assert_eq!(first_contact(&SQUARE, &inner, true), None);
    }
}
