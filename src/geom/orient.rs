//! Exact signs: which way three points turn, whether two segments meet.

use glam::DVec2;
use robust::Coord;

/// Returns a number whose sign tells how `a`, `b`, `c` turn: positive to the left, negative to the right, zero when they
/// lie on one line.
///
/// The sign is exact for finite coordinates whose products neither overflow nor underflow (Shewchuk, *Adaptive Precision
/// Floating-Point Arithmetic and Fast Robust Geometric Predicates*, 1997); the size is about twice the area of the triangle.
#[must_use]
pub fn orient2d(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let coord = |p: DVec2| Coord { x: p.x, y: p.y };
    robust::orient2d(coord(a), coord(b), coord(c))
}

/// Tells whether the closed segments `a b` and `c d` share a point. Exact: grazing an end counts.
#[must_use]
pub fn segments_meet(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> bool {
    if a.min(b).cmpgt(c.max(d)).any() || c.min(d).cmpgt(a.max(b)).any() {
        return false;
    }
    let (c_side, d_side) = (orient2d(a, b, c), orient2d(a, b, d));
    if (c_side > 0.0 && d_side > 0.0) || (c_side < 0.0 && d_side < 0.0) {
        return false;
    }
    let (a_side, b_side) = (orient2d(c, d, a), orient2d(c, d, b));
    // Four points on one line: their boxes overlap, so the segments do.
    !((a_side > 0.0 && b_side > 0.0) || (a_side < 0.0 && b_side < 0.0))
}

/// Returns the point in which the lines through `a b` and `c d` cross, or the middle of `a b` when they are parallel.
///
/// Rounded; meant for showing where two segments that [meet](segments_meet) do so.
#[must_use]
pub fn segment_crossing(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> DVec2 {
    let denominator = (b - a).perp_dot(d - c);
    let t = (c - a).perp_dot(d - c) / denominator;
    if t.is_finite() { a + t.clamp(0.0, 1.0) * (b - a) } else { (a + b) / 2.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

    #[test]
    fn turn_is_exact_next_to_a_line() {
        // The third point is one unit in the last place off the diagonal.
        let above = dvec2(0.5, 0.5 + f64::EPSILON / 2.0);
        assert!(orient2d(dvec2(0.0, 0.0), dvec2(1.0, 1.0), above) > 0.0);
        assert!(orient2d(dvec2(0.0, 0.0), dvec2(1.0, 1.0), dvec2(0.5, 0.5)) == 0.0);
    }

    #[test]
    fn closed_segments_meet_at_ends_and_along_a_line() {
        let p = dvec2;
        assert!(segments_meet(p(0.0, 0.0), p(2.0, 2.0), p(0.0, 2.0), p(2.0, 0.0)));
        assert!(segments_meet(p(0.0, 0.0), p(1.0, 0.0), p(1.0, 0.0), p(2.0, 5.0)), "end on end");
        assert!(segments_meet(p(0.0, 0.0), p(2.0, 0.0), p(1.0, 0.0), p(1.0, 5.0)), "end inside");
        assert!(segments_meet(p(0.0, 0.0), p(2.0, 0.0), p(1.0, 0.0), p(3.0, 0.0)), "overlap");
        assert!(!segments_meet(p(0.0, 0.0), p(1.0, 0.0), p(2.0, 0.0), p(3.0, 0.0)), "apart on one line");
        assert!(!segments_meet(p(0.0, 0.0), p(3.0, 3.0), p(1.0, 0.0), p(3.0, 2.0)), "parallel");
    }

    #[test]
    fn crossing_point_of_two_diagonals() {
        let at = segment_crossing(dvec2(0.0, 0.0), dvec2(2.0, 2.0), dvec2(0.0, 2.0), dvec2(2.0, 0.0));
        assert!((at - dvec2(1.0, 1.0)).length() < 1e-15);
    }
}
