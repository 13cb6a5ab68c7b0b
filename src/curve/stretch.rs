//! Part of a curve in Bezier form.

use glam::DVec2;

use super::closed_bspline::ClosedBSpline;

impl ClosedBSpline {
    /// Bezier points of the part between two ascending parameters, relative to `origin`; one point where they are equal.
    ///
    /// Parameters beyond the domain wrap. No knot may lie between them, up to rounding: the piece is that of the span which
    /// holds their middle.
    #[must_use]
    pub fn stretch(&self, from: f64, to: f64, origin: DVec2) -> Vec<DVec2> {
        let middle = from + (to - from) / 2.0;
        let wrapped = self.wrap(middle);
        let whole = if to > from { self.piece(self.span_index(wrapped), origin) } else { None };
        let Some(piece) = whole else { return vec![self.point(from) - origin] };
        piece.between(from + (wrapped - middle), to + (wrapped - middle)).points
    }

    /// The knots from `start` to one lap beyond it, ascending and without repetition; `start` itself is not among them.
    #[must_use]
    pub fn knots_from(&self, start: f64) -> Vec<f64> {
        let (lo, hi) = self.domain();
        let inner = &self.knots()[self.degree()..self.knots().len() - self.degree() - 1];
        let ahead = |knot: f64| start + (knot - start).rem_euclid(hi - lo);
        let mut knots: Vec<f64> =
            inner.iter().map(|&knot| ahead(knot)).filter(|&knot| knot > start).collect();
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
            let curve = ClosedBSpline::new(degree, Form::Periodic, points.clone(), None).unwrap();
            let start = -0.3;
            let mut ends = curve.knots_from(start);
            assert_eq!(ends.len(), 7);
            ends.insert(0, start);
            ends.push(start + 1.0);
            for pair in ends.windows(2) {
                let bezier = curve.stretch(pair[0], pair[1], origin);
                assert_eq!(bezier.len(), degree + 1);
                assert!((bezier[0] + origin).distance(curve.point(pair[0])) < 1e-12);
                assert!((bezier[degree] + origin).distance(curve.point(pair[1])) < 1e-12);
            }
            assert_eq!(curve.stretch(0.4, 0.4, origin), [curve.point(0.4) - origin]);
        }
    }
}
