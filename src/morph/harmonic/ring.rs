//! Closed curves as rings of straight segments.

use crate::curve::BSpline;
use glam::DVec2;

/// A closed curve, counter-clockwise, as a polygon with a vertex at each of its corners.
#[derive(Debug, Clone, PartialEq)]
pub struct Ring {
    /// Parameters of the vertices, ascending in the domain of the curve.
    pub parameters: Vec<f64>,
    /// The vertices, which lie on the curve.
    pub points: Vec<DVec2>,
    /// Length of the domain.
    period: f64,
}

impl Ring {
    /// Cuts a closed curve into about `count` segments, at least 3: even in arc length from corner to corner, and at least one on each of these stretches.
    #[must_use]
    pub fn new(curve: &BSpline, count: usize) -> Self {
        let (lo, hi) = curve.domain();
        let arc = curve.arc_length();
        let total = arc.total();
        let mut cuts: Vec<f64> = curve.corners().iter().map(|corner| arc.at(corner.u)).collect();
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|a, b| *a - *b < 1e-9 * total);
        if cuts.is_empty() {
            cuts.push(0.0);
        }
        let ends = cuts.iter().skip(1).copied().chain([cuts[0] + total]);
        let stretches: Vec<(f64, f64)> = cuts.iter().copied().zip(ends).collect();
        let least = 3_usize.div_ceil(stretches.len());
        let mut parameters: Vec<f64> = Vec::with_capacity(count + stretches.len());
        for (from, to) in stretches {
            let share = count as f64 * (to - from) / total;
            let parts = (share.round() as usize).max(least);
            let place = |part: usize| (from + (to - from) * part as f64 / parts as f64).rem_euclid(total);
            parameters.extend((0..parts).map(|part| arc.parameter(place(part))));
        }
        parameters.iter_mut().filter(|u| **u >= hi).for_each(|u| *u = lo);
        parameters.sort_by(f64::total_cmp);
        parameters.dedup();
        let points = parameters.iter().map(|&u| curve.point(u)).collect();
        Self { parameters, points, period: hi - lo }
    }

    /// Number of segments, and of vertices.
    #[must_use]
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there are none, which is never so.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// The parameter at the share `t` of a segment, which may lie beyond the end of the domain.
    #[must_use]
    pub fn parameter(&self, segment: usize, t: f64) -> f64 {
        let from = self.parameters[segment];
        let to = self.parameters.get(segment + 1).map_or(self.parameters[0] + self.period, |u| *u);
        from + (to - from) * t
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Form;
    use crate::geom::signed_area;
    use glam::dvec2;

    #[test]
    fn a_smooth_curve_is_cut_into_even_segments() {
        let points = (0..12).map(|k| 5.0 * DVec2::from_angle(f64::from(k) * std::f64::consts::TAU / 12.0));
        let curve = BSpline::new(3, Form::Periodic, points.collect(), None).expect("a curve");
        let ring = Ring::new(&curve, 200);
        assert_eq!(ring.len(), 200);
        let length = |k: usize| ring.points[k].distance(ring.points[(k + 1) % 200]);
        assert!((0..200).all(|k| (length(k) / length(0) - 1.0).abs() < 1e-3));
        assert!((signed_area(&ring.points) / curve.signed_area() - 1.0).abs() < 1e-3);
        assert!((ring.parameter(199, 1.0) - ring.parameters[0] - 1.0).abs() < 1e-12);
    }

    #[test]
    fn corners_are_vertices() {
        // A square as a clamped curve of degree 2 with double control points at its corners.
        let corners = [dvec2(0.0, 0.0), dvec2(4.0, 0.0), dvec2(4.0, 1.0), dvec2(0.0, 1.0)];
        let points: Vec<DVec2> = corners.iter().flat_map(|&p| [p, p]).chain([corners[0]]).collect();
        let curve = BSpline::new(2, Form::Clamped, points, None).expect("a curve");
        let ring = Ring::new(&curve, 20);
        for corner in corners {
            assert!(ring.points.iter().any(|point| point.distance(corner) < 1e-9), "{corner} of {ring:?}");
        }
        assert!(ring.len().abs_diff(20) < 4);
    }
}
