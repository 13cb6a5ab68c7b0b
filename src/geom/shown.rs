//! Numbers in messages.

use glam::DVec2;
use std::fmt;

/// A number shown with six significant figures at most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shown(pub f64);

/// A place shown as `(x, y)`, each with six significant figures at most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShownPlace(pub DVec2);

/// A number shown with all its figures, in powers of ten when it is very large or very small.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Full(pub f64);

impl fmt::Display for Full {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        let is_plain = size == 0.0 || !size.is_finite() || (1e-5..1e10).contains(&size);
        if is_plain { write!(f, "{}", self.0) } else { write!(f, "{:e}", self.0) }
    }
}

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0 == 0.0 || !self.0.is_finite() {
            return write!(f, "{}", self.0);
        }
        let decimals = 5 - self.0.abs().log10().floor() as i32;
        let scale = 10.0_f64.powi(decimals.abs());
        let rounded =
            if decimals < 0 { (self.0 / scale).round() * scale } else { (self.0 * scale).round() / scale };
        // The scale of the smallest numbers overflows.
        write!(f, "{}", if rounded.is_finite() && rounded != 0.0 { rounded } else { self.0 })
    }
}

impl fmt::Display for ShownPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({}, {})", Shown(self.0.x), Shown(self.0.y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn very_large_and_very_small_numbers_stay_short() {
        for (number, text) in [
            (0.0, "0"),
            (-2.5, "-2.5"),
            (0.1 + 0.2, "0.30000000000000004"),
            (9_999_999_999.0, "9999999999"),
            (1e12, "1e12"),
            (-1e300, "-1e300"),
            (1.25e-7, "1.25e-7"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(Full(number).to_string(), text);
        }
    }

    #[test]
    fn numbers_keep_six_figures_at_any_size() {
        for (number, text) in [
            (0.0, "0"),
            (12.0, "12"),
            (-12.345_678_9, "-12.3457"),
            (0.000_123_456_789, "0.000123457"),
            (123_456_789.0, "123457000"),
            (f64::INFINITY, "inf"),
            (1.5e-320, &1.5e-320.to_string()),
        ] {
            assert_eq!(Shown(number).to_string(), text);
        }
        assert_eq!(ShownPlace(DVec2::new(1.0, 0.5)).to_string(), "(1, 0.5)");
    }
}
