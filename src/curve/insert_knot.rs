//! Knot insertion: one more control point, the same shape.

use super::bspline::{BSpline, Form, check_room};
use super::error::CurveError;
use super::knots;

impl BSpline {
    /// Inserts a knot at u, which adds one control point and keeps shape and parametrisation.
    ///
    /// A u within about 1e-10 of the domain of a knot raises the multiplicity of that knot. The domain stays as it
    /// is; on a periodic curve u may be the seam.
    ///
    /// # Errors
    /// When u is not finite, when the knot is there as often as the degree already (the seam of a clamped curve
    /// and the ends of an open one always are), or when the curve has 2000 control points.
    ///
    /// # References
    /// W. Boehm, "Inserting new knots into B-spline curves", *Computer-Aided Design* 12 (1980). For the periodic
    /// form the formula is read with cyclic indices.
    pub fn insert_knot(&self, u: f64) -> Result<Self, CurveError> {
        if !u.is_finite() {
            return Err(CurveError::ParameterNotFinite { u });
        }
        let (p, count) = (self.degree(), self.points().len());
        check_room(count)?;
        let u = self.snap(self.wrap(u));
        let multiplicity = self.multiplicity(u);
        if multiplicity >= p {
            return Err(CurveError::KnotFull { value: u, multiplicity, degree: p });
        }
        let k = self.span_index(u);
        let (old, old_knots) = (self.points(), self.knots());
        // Control point i of the refined curve; indices past the last knot of the span are those of before, plus one.
        let refined = |i: usize| {
            if i + p <= k {
                old[i % count]
            } else if i > k {
                old[(i - 1) % count]
            } else {
                let t = (u - old_knots[i]) / (old_knots[i + p] - old_knots[i]);
                old[(i - 1) % count] * (1.0 - t) + old[i % count] * t
            }
        };
        let mut points = vec![old[0]; count + 1];
        let first = if self.form() == Form::Periodic { k + 1 - p } else { 0 };
        for i in first..=first + count {
            points[i % (count + 1)] = refined(i);
        }
        let knots = match self.form() {
            Form::Clamped | Form::Open => inserted(old_knots, k, u),
            Form::Periodic => {
                let domain = inserted(&old_knots[p..=p + count], k - p, u);
                knots::extend_periodically(p, &domain)
            }
        };
        Ok(Self::from_checked(p, self.form(), points, knots))
    }

    /// The knot within merging distance of u in the domain, else u; the seam of a closed curve is reported as lo.
    pub(super) fn snap(&self, u: f64) -> f64 {
        let (lo, hi) = self.domain();
        let near = knots::merging_distance(lo, hi);
        let k = self.span_index(u);
        let (below, above) = (self.knots()[k], self.knots()[k + 1]);
        if u - below <= near {
            below
        } else if above - u > near {
            u
        } else if above == hi && self.is_closed() {
            lo
        } else {
            above
        }
    }

    /// How often the knot u in the domain occurs; on a periodic curve lo and hi are the same knot.
    fn multiplicity(&self, u: f64) -> usize {
        let (lo, hi) = self.domain();
        let times = |value: f64, knots: &[f64]| knots.iter().filter(|&&knot| knot == value).count();
        match self.form() {
            Form::Clamped | Form::Open => times(u, self.knots()),
            Form::Periodic => {
                let domain = &self.knots()[self.degree()..=self.degree() + self.points().len()];
                times(u, domain) + if u == lo { times(hi, domain) - 1 } else { 0 }
            }
        }
    }
}

/// A copy of `knots` with `u` behind index `after`.
fn inserted(knots: &[f64], after: usize, u: f64) -> Vec<f64> {
    let mut result = knots.to_vec();
    result.insert(after + 1, u);
    result
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    fn pentagon() -> Vec<DVec2> {
        [(3.0, 0.0), (1.0, 2.0), (-2.0, 1.5), (-2.5, -1.0), (0.5, -2.0)].map(DVec2::from).to_vec()
    }

    fn same_shape(a: &BSpline, b: &BSpline) {
        assert_eq!(a.domain(), b.domain());
        let (lo, hi) = a.domain();
        for i in 0..=97 {
            let u = lo + (hi - lo) * f64::from(i) / 97.0;
            let gap = (a.point(u) - b.point(u)).length();
            assert!(gap < 1e-13, "u = {u}: {} and {}", a.point(u), b.point(u));
        }
    }

    #[test]
    fn a_periodic_curve_keeps_its_shape_for_every_knot_up_to_full_multiplicity() {
        for degree in 2..=4 {
            let curve = BSpline::new(degree, Form::Periodic, pentagon(), None).unwrap();
            for u in [0.0, 0.01, 0.2, 0.37, 0.6, 0.81, 0.999, 1.0, -0.13, 7.5] {
                let mut refined = curve.clone();
                loop {
                    match refined.insert_knot(u) {
                        Ok(next) => {
                            assert_eq!(next.points().len(), refined.points().len() + 1);
                            same_shape(&curve, &next);
                            refined = next;
                        }
                        Err(error) => {
                            assert!(
                                matches!(error, CurveError::KnotFull { multiplicity, .. } if multiplicity == degree)
                            );
                            break;
                        }
                    }
                }
                // With full multiplicity the curve passes through a control point.
                let at = curve.point(u);
                assert!(refined.points().iter().any(|p| (*p - at).length() < 1e-13), "u = {u}");
            }
        }
    }

    #[test]
    fn a_clamped_curve_keeps_its_shape_and_its_ends() {
        let mut points = pentagon();
        points.push(points[0]);
        let mut curve = BSpline::new(3, Form::Clamped, points, None).unwrap();
        let original = curve.clone();
        for u in [0.1, 0.1, 0.1, 0.5, 1.0 / 3.0, 0.9999] {
            curve = curve.insert_knot(u).unwrap();
            same_shape(&original, &curve);
            assert_eq!(curve.points().first(), curve.points().last());
        }
        assert!(matches!(curve.insert_knot(0.1), Err(CurveError::KnotFull { multiplicity: 3, .. })));
        assert!(matches!(curve.insert_knot(1.0), Err(CurveError::KnotFull { multiplicity: 4, .. })));
    }

    #[test]
    fn many_insertions_in_any_order_stay_on_the_curve() {
        let curve = BSpline::new(3, Form::Periodic, pentagon(), None).unwrap();
        let mut refined = curve.clone();
        for i in 0..60 {
            refined = refined.insert_knot((f64::from(i) * 0.618_033_988_749_895).fract()).unwrap();
        }
        same_shape(&curve, &refined);
        // What insertion makes passes the checks of the constructor.
        let (points, knots) = (refined.points().to_vec(), refined.knots().to_vec());
        assert_eq!(BSpline::new(3, Form::Periodic, points, Some(knots)).unwrap(), refined);
    }

    #[test]
    fn what_cannot_be_inserted_is_refused() {
        let curve = BSpline::new(3, Form::Periodic, pentagon(), None).unwrap();
        assert!(matches!(curve.insert_knot(f64::NAN), Err(CurveError::ParameterNotFinite { .. })));
        let circle = (0..2000).map(|i| DVec2::from_angle(f64::from(i) / 320.0)).collect();
        let full = BSpline::new(3, Form::Periodic, circle, None).unwrap();
        assert_eq!(full.insert_knot(0.3), Err(CurveError::TooManyPoints { count: 2001, limit: 2000 }));
    }
}
