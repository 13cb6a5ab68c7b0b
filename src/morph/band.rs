//! The ruled band between two matched curves.

use crate::curve::BSpline;
use crate::material::Composition;
use glam::DVec2;

/// A straight line from the first curve to the second, with the composition at its ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Ruling {
    /// Parameter on the first curve, ascending round the band beyond the end of its domain.
    pub u: f64,
    /// Parameter on the second curve, ascending in the same way.
    pub v: f64,
    /// End on the first curve.
    pub from: DVec2,
    /// End on the second curve.
    pub to: DVec2,
    /// Composition at both ends.
    pub ends: [Composition; 2],
}

impl Ruling {
    /// Point at the share `s` of the way from the first curve (0) to the second (1).
    ///
    /// The paper's Eq. 3 runs the other way, t = 1 - s.
    #[must_use]
    pub fn point(&self, s: f64) -> DVec2 {
        self.from.lerp(self.to, s)
    }

    /// Composition at the share `s` of the way, by linear blending of volume fractions.
    #[must_use]
    pub fn composition(&self, s: f64) -> Composition {
        self.ends[0].mix(&self.ends[1], s)
    }
}

/// Rulings all round the band, or from end to end between open curves: the lines of a matching and, between each two of them, more at even
/// steps of both parameters.
///
/// Between two rulings the band is the bilinear patch on their four ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    rulings: Vec<Ruling>,
    /// Parameters of the first ruling after one lap, where the band closes.
    end: Option<(f64, f64)>,
    per_line: usize,
}

impl Band {
    /// Builds the band of lines in cyclic order, given by the parameters (u, v) of their ends, which ascend beyond the ends of
    /// the domains.
    ///
    /// `compose(curve, u)` is the composition along curve 0 or 1, for `u` beyond the domain as well, and `per_line` is the
    /// number of rulings from one line to the next, at least 1.
    #[must_use]
    pub fn new(
        curves: &[BSpline; 2],
        places: &[(f64, f64)],
        compose: impl Fn(usize, f64) -> Composition,
        per_line: usize,
    ) -> Self {
        let periods = curves.each_ref().map(|curve| curve.domain().1 - curve.domain().0);
        let (u, v) = places.first().copied().unwrap_or_default();
        let end = curves[0].is_closed().then_some((u + periods[0], v + periods[1]));
        let next = places.iter().copied().skip(1).chain(end);
        let last = places.last().copied().filter(|_| end.is_none());
        let rulings = places
            .iter()
            .zip(next)
            .flat_map(|(&(u0, v0), (u1, v1))| {
                (0..per_line).map(move |step| {
                    let t = step as f64 / per_line as f64;
                    (u0 + t * (u1 - u0), v0 + t * (v1 - v0))
                })
            })
            .chain(last)
            .map(|(u, v)| Ruling {
                u,
                v,
                from: curves[0].point(u),
                to: curves[1].point(v),
                ends: [compose(0, u), compose(1, v)],
            })
            .collect();
        Self { rulings, end, per_line }
    }

    /// A band of given rulings; `end` has the parameters of the first one after one lap, where the band closes.
    #[cfg(feature = "stack")]
    pub(super) fn of_rulings(rulings: Vec<Ruling>, end: Option<(f64, f64)>, per_line: usize) -> Self {
        Self { rulings, end, per_line }
    }

    /// All rulings, in cyclic order; every [`per_line`](Self::per_line)-th is a line of the matching.
    #[must_use]
    pub fn rulings(&self) -> &[Ruling] {
        &self.rulings
    }

    /// Number of rulings from one line of the matching to the next.
    #[must_use]
    pub fn per_line(&self) -> usize {
        self.per_line
    }

    /// The rulings that are lines of the matching.
    pub fn lines(&self) -> impl Iterator<Item = &Ruling> {
        self.rulings.iter().step_by(self.per_line)
    }

    /// Tells whether the last ruling is followed by the first.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.end.is_some()
    }

    /// In-between curve at the share `s`, as a polyline over all rulings, closed where the band is: 0 gives the first curve, 1 the second.
    ///
    /// Stage j of M is the curve at s = j / M; read as an iso-property curve, it joins the points whose
    /// composition is blended in the same ratio (Fig. 10 of the paper).
    #[must_use]
    pub fn in_between(&self, s: f64) -> Vec<DVec2> {
        self.rulings.iter().map(|ruling| ruling.point(s)).collect()
    }

    /// Each ruling with the next, all round or from end to end, and the parameters of the next, ascending.
    pub(super) fn gaps(&self) -> impl Iterator<Item = (&Ruling, &Ruling, (f64, f64))> {
        let next = self.rulings.iter().skip(1).map(|ruling| (ruling, (ruling.u, ruling.v)));
        let last = self.rulings.first().zip(self.end);
        self.rulings.iter().zip(next.chain(last)).map(|(this, (next, parameters))| (this, next, parameters))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Form;
    use glam::dvec2;

    /// Two quadratic curves, one twice the other, matched at the four quarters of their domain.
    fn band(per_line: usize) -> Band {
        let square = |r: f64| vec![dvec2(r, r), dvec2(-r, r), dvec2(-r, -r), dvec2(r, -r)];
        let curve = |r: f64| BSpline::new(2, Form::Periodic, square(r), None).expect("a valid curve");
        let curves = [curve(1.0), curve(2.0)];
        // The matching starts a quarter behind on the second curve.
        let places = [(0.0, -0.25), (0.25, 0.0), (0.5, 0.25), (0.75, 0.5)];
        let pure = |curve: usize, _: f64| Composition::pure(curve, 2);
        Band::new(&curves, &places, pure, per_line)
    }

    #[test]
    fn rulings_ascend_in_both_parameters_all_round() {
        let band = band(5);
        assert_eq!(band.rulings().len(), 20);
        assert_eq!(band.lines().count(), 4);
        for (this, next, (u, v)) in band.gaps() {
            assert!((u - this.u - 0.05).abs() < 1e-12 && (v - this.v - 0.05).abs() < 1e-12);
            assert!(next.u.rem_euclid(1.0) - u.rem_euclid(1.0) < 1e-12);
        }
        assert!((band.rulings()[0].v + 0.25).abs() < 1e-12, "one vertex behind");
    }

    #[test]
    fn in_betweens_start_and_end_on_the_curves() {
        let band = band(3);
        for (k, ruling) in band.rulings().iter().enumerate() {
            assert_eq!(band.in_between(0.0)[k], ruling.from);
            assert_eq!(band.in_between(1.0)[k], ruling.to);
            assert!((band.in_between(0.25)[k] - (0.75 * ruling.from + 0.25 * ruling.to)).length() < 1e-15);
        }
    }
}
