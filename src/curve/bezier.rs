//! One Bezier piece of a curve.

use glam::DVec2;

/// A Bezier curve over `[lo, hi]` of a knot domain, with its own parameter t in [0, 1].
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Bezier {
    /// Control points, at least one; relative to an origin that the maker chose.
    pub(super) points: Vec<DVec2>,
    /// Parameter of the whole curve at t = 0.
    pub(super) lo: f64,
    /// Parameter of the whole curve at t = 1.
    pub(super) hi: f64,
}

impl Bezier {
    pub(super) fn degree(&self) -> usize {
        self.points.len() - 1
    }

    /// Parameter of the whole curve at t; exact at both ends.
    pub(super) fn parameter(&self, t: f64) -> f64 {
        self.lo * (1.0 - t) + self.hi * t
    }

    /// Value at t in [0, 1].
    pub(super) fn point(&self, t: f64) -> DVec2 {
        bernstein_sum(&self.points, t)
    }

    /// Derivative by t, as a Bezier curve of one degree less; that of a constant is zero.
    pub(super) fn hodograph(&self) -> Self {
        let n = self.degree() as f64;
        let mut points: Vec<_> = self.points.windows(2).map(|w| (w[1] - w[0]) * n).collect();
        if points.is_empty() {
            points.push(DVec2::ZERO);
        }
        Self { points, lo: self.lo, hi: self.hi }
    }

    /// The two halves.
    pub(super) fn halves(&self) -> (Self, Self) {
        self.split(0.5)
    }

    /// The part between two parameters of the whole curve that enclose some of `[lo, hi]`.
    pub(super) fn between(&self, from: f64, to: f64) -> Self {
        let share = |part: &Self, u: f64| (u - part.lo) / (part.hi - part.lo);
        let part = if from > self.lo { self.split(share(self, from)).1 } else { self.clone() };
        if to < part.hi { part.split(share(&part, to)).0 } else { part }
    }

    /// The parts before and after t in [0, 1], by de Casteljau's algorithm.
    fn split(&self, t: f64) -> (Self, Self) {
        let mut right = self.points.clone();
        let mut left = Vec::with_capacity(right.len());
        for last in (0..right.len()).rev() {
            left.push(right[0]);
            for i in 0..last {
                right[i] = right[i] * (1.0 - t) + right[i + 1] * t;
            }
        }
        // The steps leave the right part in place: after the step that shortens the row to `last` entries the
        // entry behind it is final.
        let middle = self.lo + (self.hi - self.lo) * t;
        (Self { points: left, lo: self.lo, hi: middle }, Self { points: right, lo: middle, hi: self.hi })
    }

    /// Largest distance of a control point from the first one, in the maximum norm.
    pub(super) fn extent(&self) -> f64 {
        self.points.iter().fold(0.0, |m, p| m.max((*p - self.points[0]).abs().max_element()))
    }

    /// Unit tangents just before and just after t in [0, 1], or `None` where the piece is a single point.
    ///
    /// They are the direction of the first derivative that does not vanish, counting as vanished what is below
    /// 1e-9 of the size of the piece; its order tells whether the curve turns back (a cusp) or goes on.
    pub(super) fn tangents(&self, t: f64) -> Option<(DVec2, DVec2)> {
        let threshold = 1e-9 * self.extent();
        let mut derivative = self.hodograph();
        let mut scale = self.degree() as f64;
        for order in 1..=self.degree() {
            // Divided by its falling factorial a derivative is a combination of differences of control points.
            let value = derivative.point(t) / scale;
            if value.length() > threshold {
                let after = value.normalize();
                return Some((if order % 2 == 1 { after } else { -after }, after));
            }
            if order < self.degree() {
                scale *= derivative.degree() as f64;
                derivative = derivative.hodograph();
            }
        }
        None
    }
}

/// Sum of the Bernstein polynomials with the given coefficients at t in [0, 1], in linear time.
fn bernstein_sum(points: &[DVec2], t: f64) -> DVec2 {
    let (n, s) = (points.len() - 1, 1.0 - t);
    let (mut power, mut binomial) = (1.0, 1.0);
    let mut sum = points[0];
    for (i, point) in points.iter().enumerate().skip(1) {
        power *= t;
        binomial *= (n + 1 - i) as f64 / i as f64;
        sum = sum * s + *point * (binomial * power);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arch() -> Bezier {
        let points = [(0.0, 0.0), (1.0, 3.0), (4.0, -1.0), (5.0, 2.0), (2.0, 2.0)];
        Bezier { points: points.map(DVec2::from).to_vec(), lo: 2.0, hi: 4.0 }
    }

    #[test]
    fn halves_are_the_same_curve() {
        let whole = arch();
        let (left, right) = whole.halves();
        for i in 0..=16 {
            let t = f64::from(i) / 16.0;
            assert!((left.point(t) - whole.point(t / 2.0)).length() < 1e-14);
            assert!((right.point(t) - whole.point(0.5 + t / 2.0)).length() < 1e-14);
        }
        assert_eq!((left.hi, right.lo), (3.0, 3.0));
    }

    #[test]
    fn a_part_is_the_same_curve() {
        let whole = arch();
        for (from, to) in [(2.0, 4.0), (2.3, 4.0), (1.0, 3.1), (2.7, 2.9)] {
            let part = whole.between(from, to);
            assert!((part.lo - from.max(2.0)).abs() < 1e-15 && (part.hi - to).abs() < 1e-15);
            for t in [0.0, 0.3, 1.0] {
                let at = (part.parameter(t) - whole.lo) / (whole.hi - whole.lo);
                assert!((part.point(t) - whole.point(at)).length() < 1e-14);
            }
        }
    }

    #[test]
    fn hodograph_matches_differences() {
        let (whole, h) = (arch(), 1e-6);
        for t in [0.1, 0.5, 0.8] {
            let slope = (whole.point(t + h) - whole.point(t - h)) / (2.0 * h);
            assert!((whole.hodograph().point(t) - slope).length() < 1e-8);
        }
    }

    #[test]
    fn tangents_turn_back_at_a_cusp_and_go_on_past_a_flat_point() {
        // (t - 1/2)^2, (t - 1/2)^3 in Bernstein form: a semicubical cusp at t = 1/2.
        let cusp = [(0.25, -0.125), (-1.0 / 12.0, 0.125), (-1.0 / 12.0, -0.125), (0.25, 0.125)];
        let cusp = Bezier { points: cusp.map(DVec2::from).to_vec(), lo: 0.0, hi: 1.0 };
        let (before, after) = cusp.tangents(0.5).unwrap();
        assert!((before + DVec2::X).length() < 1e-9 && (after - DVec2::X).length() < 1e-9);
        // (t^3, 0): all control points but the last coincide.
        let flat = [DVec2::ZERO, DVec2::ZERO, DVec2::ZERO, DVec2::X];
        let flat = Bezier { points: flat.to_vec(), lo: 0.0, hi: 1.0 };
        assert_eq!(flat.tangents(0.0), Some((DVec2::X, DVec2::X)));
    }
}
