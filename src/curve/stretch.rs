//! Parts of a curve in Bezier form.

use glam::DVec2;

use super::bezier::Bezier;
use super::bspline::BSpline;

impl BSpline {
    /// Bezier points of the parts between the given pairs of parameters, each relative to `origin`; one point where both are equal.
    ///
    /// Pairs ascend; parameters beyond the domain wrap. No knot may lie inside a part, up to rounding: it is taken from the span that
    /// holds its middle.
    #[must_use]
    pub fn stretches(&self, ends: &[(f64, f64)], origin: DVec2) -> Vec<Vec<DVec2>> {
        // Neighbours often lie on one span, whose Bezier form is worked out once.
        let mut known: Option<(usize, Bezier)> = None;
        let mut stretch = |&(from, to): &(f64, f64)| {
            if to <= from {
                return vec![self.point(from) - origin];
            }
            let middle = from + (to - from) / 2.0;
            let wrapped = self.wrap(middle);
            let span = self.span_index(wrapped);
            if known.as_ref().is_none_or(|&(index, _)| index != span) {
                known = self.piece(span, origin).map(|piece| (span, piece));
            }
            let Some((_, piece)) = &known else { return vec![self.point(from) - origin] };
            piece.between(from + (wrapped - middle), to + (wrapped - middle)).points
        };
        ends.iter().map(&mut stretch).collect()
    }

    /// The knots, and the parameters `more`, from `start` to one lap beyond it, ascending and without repetition; `start` itself is not
    /// among them.
    #[must_use]
    pub fn marks_from(&self, start: f64, more: &[f64]) -> Vec<f64> {
        let (lo, hi) = self.domain();
        let inner = &self.knots()[self.degree()..self.knots().len() - self.degree() - 1];
        let ahead = |knot: f64| start + (knot - start).rem_euclid(hi - lo);
        let mut knots: Vec<f64> =
            inner.iter().chain(more).map(|&knot| ahead(knot)).filter(|&knot| knot > start).collect();
        knots.sort_by(f64::total_cmp);
        knots.dedup();
        knots
    }
}

#[cfg(test)]
mod tests {
    use super::super::Form;
    use super::*;

    #[test]
    fn stretches_are_parts_of_the_curve_all_round_and_beyond() {
        let points: Vec<_> =
            (0..7).map(|k| DVec2::from_angle(0.9 * f64::from(k)) * (2.0 + f64::from(k % 3))).collect();
        let origin = DVec2::new(3.0, -1.0);
        for degree in [2, 3, 5] {
            let curve = BSpline::new(degree, Form::Periodic, points.clone(), None).unwrap();
            let start = -0.3;
            let mut ends = curve.marks_from(start, &[]);
            assert_eq!(ends.len(), 7);
            ends.insert(0, start);
            ends.push(start + 1.0);
            // Every part in two, so that neighbours share a span.
            let halves = ends.windows(2).flat_map(|pair| {
                let middle = f64::midpoint(pair[0], pair[1]);
                [(pair[0], middle), (middle, pair[1])]
            });
            let halves: Vec<_> = halves.collect();
            for (bezier, (from, to)) in curve.stretches(&halves, origin).iter().zip(&halves) {
                assert_eq!(bezier.len(), degree + 1);
                assert!((bezier[0] + origin).distance(curve.point(*from)) < 1e-12);
                assert!((bezier[degree] + origin).distance(curve.point(*to)) < 1e-12);
            }
            assert_eq!(curve.stretches(&[(0.4, 0.4)], origin), [[curve.point(0.4) - origin]]);
        }
    }
}
