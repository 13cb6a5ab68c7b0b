//! Elementary functions in single precision without branches, so that compilers make vector code of loops over them.

use std::f32::consts::{FRAC_PI_2, LN_2, PI, SQRT_2};

/// Numbers that are worked on together.
pub(super) const LANES: usize = 8;

/// The natural logarithm of a positive normal number, to 2e-7 of 1, without branches: the exponent, and a polynomial for the rest (that of the Cephes library).
#[inline(always)]
pub(super) fn ln(x: f32) -> f32 {
    let bits = x.to_bits();
    let mut exponent = ((bits >> 23) as i32 - 127) as f32;
    let mut rest = f32::from_bits(bits & 0x007f_ffff | 0x3f80_0000);
    let is_large = rest > SQRT_2;
    exponent = if is_large { exponent + 1.0 } else { exponent };
    rest = if is_large { 0.5 * rest } else { rest } - 1.0;
    let square = rest * rest;
    let mut sum = 7.037_683_6e-2_f32;
    for coefficient in [
        -1.151_461e-1,
        1.167_699_87e-1,
        -1.242_014_1e-1,
        1.424_932_3e-1,
        -1.666_805_7e-1,
        2.000_071_5e-1,
        -2.499_999_4e-1,
        3.333_333e-1,
    ] {
        sum = sum * rest + coefficient;
    }
    rest - 0.5 * square + rest * square * sum + exponent * LN_2
}

/// One over the square root of a positive normal number, to 3e-7, by multiplications alone: a guess from the bits of the number, one step of Newton's and one of
/// the next order. Vector units divide and take roots several times more slowly.
#[inline(always)]
pub(super) fn inverse_root(x: f32) -> f32 {
    let guess = f32::from_bits(0x5f37_5a86 - (x.to_bits() >> 1));
    let near = guess * (1.5 - 0.5 * x * guess * guess);
    let rest = x * near * near;
    near * (1.875 + rest * (0.375 * rest - 1.25))
}

/// The angle of the vector (x, y) in [-pi, pi], to 4e-7; 0 where both are 0. The polynomial is 4.4.49 of Abramowitz and Stegun (1964).
#[inline(always)]
pub(super) fn angle(y: f32, x: f32) -> f32 {
    let (along, across) = (x.abs(), y.abs());
    let is_steep = across > along;
    let (short, long) = if is_steep { (along, across) } else { (across, along) };
    let share = short / long.max(f32::MIN_POSITIVE);
    let square = share * share;
    let mut sum = 2.866_225_7e-3_f32;
    for coefficient in [
        -1.616_573_7e-2,
        4.290_961_4e-2,
        -7.528_964e-2,
        1.065_626_4e-1,
        -1.420_89e-1,
        1.999_355_1e-1,
        -3.333_314_5e-1,
        1.0,
    ] {
        sum = sum * square + coefficient;
    }
    let turned = sum * share;
    let turned = if is_steep { FRAC_PI_2 - turned } else { turned };
    let turned = if x < 0.0 { PI - turned } else { turned };
    turned.copysign(y)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_angle_is_that_of_the_library() {
        for k in 0..40_000 {
            let turn = f64::from(k) * 1e-3;
            let length = 10.0_f64.powf(f64::from(k % 31) - 15.0);
            let [x, y] = [turn.cos() * length, turn.sin() * length].map(|part| part as f32);
            let exact = f64::from(y).atan2(f64::from(x));
            let error = (f64::from(angle(y, x)) - exact).abs();
            assert!(error < 4e-7, "{error} at ({x}, {y})");
        }
        assert_eq!([angle(0.0, 0.0), angle(0.0, 1.0), angle(2.0, 0.0)], [0.0, 0.0, FRAC_PI_2]);
    }

    #[test]
    fn the_inverse_root_is_that_of_the_library() {
        for k in 0..20_000 {
            let x = 10.0_f32.powf(k as f32 / 500.0 - 24.0);
            let error = f64::from(inverse_root(x)) * f64::from(x).sqrt() - 1.0;
            assert!(error.abs() < 3e-7, "{error} at {x}");
        }
    }

    #[test]
    fn the_logarithm_is_that_of_the_library() {
        for k in 0..20_000 {
            let x = 10.0_f32.powf(k as f32 / 500.0 - 24.0);
            let error = (f64::from(ln(x)) - f64::from(x).ln()).abs();
            assert!(error < 2e-7 * f64::from(x).ln().abs().max(1.0), "{error} at {x}");
        }
    }
}
