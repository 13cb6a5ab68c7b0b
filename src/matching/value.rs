//! The value of a ruling line.

use glam::DVec2;

/// How a negative product of the two normals counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum NegativeProducts {
    /// sgn(c)·|c|^w: the paper's formula wherever that is defined and w = 1. A line with c < 0 is less bad when longer.
    #[default]
    Signed,
    /// max(c, 0)^w; among lines of equal value the shorter is better.
    Clamp,
    /// ((1 + c) / 2)^w: never negative.
    Half,
    /// c^w as printed: an even w rewards opposed normals, and for a fractional w a line with c < 0 has no value, minus infinity here; it is
    /// never taken.
    Printed,
}

/// What the value of a line weighs, each weight at least 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weights {
    /// Exponent of the product of the two unit normals (w_n in the paper); 0 leaves the length alone.
    pub normal: f64,
    /// Exponent of the length in the denominator (w_d in the paper).
    pub distance: f64,
    /// Exponent of the alignment of the line itself with both normals; 0 leaves it out.
    pub alignment: f64,
    /// How negative products of normals count.
    pub negative: NegativeProducts,
    /// Whether the gap between the planes counts in the length.
    pub heights: bool,
}

impl Default for Weights {
    /// Normal 1 and distance 2, the weights of the precursor's Eq. 4; no alignment; signed; heights count.
    fn default() -> Self {
        Self {
            normal: 1.0,
            distance: 2.0,
            alignment: 0.0,
            negative: NegativeProducts::default(),
            heights: true,
        }
    }
}

/// The end of a line on one of the curves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct End {
    pub point: DVec2,
    pub normal: DVec2,
}

impl Weights {
    /// Returns the value of the line between two ends, f = c^wn / d^wd (Eq. 9 of the paper).
    ///
    /// `c` is the product of the two outward normals, `d` the length with the gap `gap` between the planes, but at least
    /// `shortest`. An alignment weight adds the factor ((1 + a) / 2)^wa, where a is the product of the cosines
    /// between the line and each of the normals.
    pub(super) fn value(&self, p: End, q: End, gap: f64, shortest: f64) -> f64 {
        let cosine = p.normal.dot(q.normal);
        let along = q.point - p.point;
        let gap = if self.heights { gap } else { 0.0 };
        let squared = (along.length_squared() + gap * gap).max(shortest * shortest);
        let mut value = self.numerator(cosine);
        if self.distance == 2.0 {
            value /= squared;
        } else if self.distance != 0.0 {
            value /= squared.powf(self.distance / 2.0);
        }
        if self.alignment != 0.0 {
            let alignment = along.dot(p.normal) * along.dot(q.normal) / squared;
            value *= ((1.0 + alignment.clamp(-1.0, 1.0)) / 2.0).powf(self.alignment);
        }
        value
    }

    fn numerator(&self, cosine: f64) -> f64 {
        if self.normal == 0.0 {
            return 1.0;
        }
        let power = |x: f64| if self.normal == 1.0 { x } else { x.powf(self.normal) };
        match self.negative {
            NegativeProducts::Signed => power(cosine.abs()).copysign(cosine),
            NegativeProducts::Clamp => power(cosine.max(0.0)),
            NegativeProducts::Half => power((1.0 + cosine.clamp(-1.0, 1.0)) / 2.0),
            NegativeProducts::Printed => {
                let value = power(cosine);
                if value.is_nan() { f64::NEG_INFINITY } else { value }
            }
        }
    }
}

/// Rounds a finite number to 40 significant bits, half away from zero, so that values that differ by rounding error alone
/// compare equal.
#[must_use]
pub fn round_to_40_bits(x: f64) -> f64 {
    const DROPPED: u64 = 53 - 40;
    let half = 1 << (DROPPED - 1);
    f64::from_bits((x.to_bits() + half) & !((1 << DROPPED) - 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

    fn end(x: f64, y: f64, degrees: f64) -> End {
        End { point: dvec2(x, y), normal: DVec2::from_angle(degrees.to_radians()) }
    }

    fn value(weights: Weights, degrees: f64, gap: f64) -> f64 {
        weights.value(end(0.0, 0.0, 0.0), end(2.0, 0.0, degrees), gap, 1e-9)
    }

    #[test]
    fn default_value_is_the_cosine_over_the_squared_length() {
        assert!((value(Weights::default(), 60.0, 0.0) - 0.5 / 4.0).abs() < 1e-15);
        assert!((value(Weights::default(), 120.0, 0.0) + 0.5 / 4.0).abs() < 1e-15);
        assert!((value(Weights::default(), 60.0, 1.0) - 0.5 / 5.0).abs() < 1e-15, "the gap counts");
    }

    #[test]
    fn even_and_fractional_weights_keep_the_sign_and_are_never_nan() {
        for normal in [0.5, 2.0, 3.7] {
            let weights = Weights { normal, ..Weights::default() };
            assert!((value(weights, 120.0, 0.0) + 0.5_f64.powf(normal) / 4.0).abs() < 1e-15);
        }
    }

    #[test]
    fn modes_of_negative_products() {
        let mode = |negative| Weights { negative, ..Weights::default() };
        assert_eq!(value(mode(NegativeProducts::Clamp), 120.0, 0.0), 0.0);
        assert!((value(mode(NegativeProducts::Half), 120.0, 0.0) - 0.25 / 4.0).abs() < 1e-15);
        let length_only = Weights { normal: 0.0, distance: 1.0, ..Weights::default() };
        assert_eq!(value(length_only, 120.0, 0.0), 0.5);
    }

    #[test]
    fn printed_products_reward_opposed_normals_or_have_no_value() {
        let printed = |normal| Weights { normal, negative: NegativeProducts::Printed, ..Weights::default() };
        assert!((value(printed(2.0), 120.0, 0.0) - 0.25 / 4.0).abs() < 1e-15);
        assert!((value(printed(1.0), 120.0, 0.0) + 0.5 / 4.0).abs() < 1e-15);
        assert_eq!(value(printed(0.5), 120.0, 0.0), f64::NEG_INFINITY);
        assert!((value(printed(0.5), 60.0, 0.0) - 0.5_f64.sqrt() / 4.0).abs() < 1e-15);
    }

    #[test]
    fn alignment_prefers_lines_along_the_normals() {
        let weights = Weights { alignment: 1.0, ..Weights::default() };
        assert!((value(weights, 0.0, 0.0) - 0.25).abs() < 1e-15, "a perfect line loses nothing");
        let sideways = weights.value(end(0.0, 0.0, 90.0), end(2.0, 0.0, 90.0), 0.0, 1e-9);
        assert!((sideways - 0.125).abs() < 1e-15, "a line along the curves loses half");
    }

    #[test]
    fn heights_may_be_left_out() {
        let weights = Weights { heights: false, ..Weights::default() };
        assert_eq!(value(weights, 60.0, 1.0), value(weights, 60.0, 0.0));
    }

    #[test]
    fn touching_points_have_a_finite_value() {
        let f = Weights { distance: 4.0, ..Weights::default() };
        assert!(f.value(end(0.0, 0.0, 0.0), end(0.0, 0.0, 0.0), 0.0, 1e-9).is_finite());
    }

    #[test]
    fn rounding_drops_thirteen_bits() {
        assert_eq!(round_to_40_bits(1.0 + f64::EPSILON), 1.0);
        assert_eq!(round_to_40_bits(-1.0 - f64::EPSILON), -1.0);
        assert_ne!(round_to_40_bits(1.0 + 1e-11), 1.0);
        assert_eq!(round_to_40_bits(0.0), 0.0);
    }
}
