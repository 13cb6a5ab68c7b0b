//! Bernstein polynomials: values, exact splitting, elevation, and nets of 4 x 4 x 4 coefficients.

use super::Axis;
use std::ops::{Add, Mul, Sub};

/// What coefficients are: numbers or vectors.
pub trait Coefficient: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self> {}

impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>> Coefficient for T {}

/// The number of ways to choose `k` of `n`, exact up to `n` = 30; 0 when `k` is above `n`.
#[must_use]
pub const fn binomial(n: usize, k: usize) -> f64 {
    if k > n {
        return 0.0;
    }
    let (mut value, mut i) = (1, 0);
    while i < k {
        value = value * (n - i) / (i + 1);
        i += 1;
    }
    value as f64
}

/// The cubic Bernstein polynomials at `t`; in [0, 1] none is negative and their sum is 1.
#[must_use]
pub fn cubic(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [s * s * s, 3.0 * t * s * s, 3.0 * t * t * s, t * t * t]
}

/// The derivatives of the cubic Bernstein polynomials at `t`.
#[must_use]
pub fn cubic_slope(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t]
}

/// The point between `a` at `t` = 0 and `b` at `t` = 1.
fn between<T: Coefficient>(a: T, b: T, t: f64) -> T {
    a * (1.0 - t) + b * t
}

/// Splits a polynomial in Bernstein form at `t`, by de Casteljau's algorithm: what was on [0, `t`] is left in
/// `first`, what was on [`t`, 1] goes to `second`, each on [0, 1] again.
///
/// # Panics
/// When the two lists have different lengths.
pub fn split<T: Coefficient>(first: &mut [T], second: &mut [T], t: f64) {
    assert_eq!(first.len(), second.len(), "lists of coefficients of different degrees");
    for left in (0..first.len()).rev() {
        second[left] = first[first.len() - 1];
        for i in (first.len() - left..first.len()).rev() {
            first[i] = between(first[i - 1], first[i], t);
        }
    }
}

/// The same polynomial with one coefficient more.
///
/// A cell stays cubic, so this is a tool for making cells from polynomials of lower degree.
///
/// # Panics
/// When there is no coefficient.
#[must_use]
pub fn elevate<T: Coefficient>(coefficients: &[T]) -> Vec<T> {
    let count = coefficients.len();
    let inner = (1..count).map(|i| between(coefficients[i], coefficients[i - 1], i as f64 / count as f64));
    let mut elevated = vec![coefficients[0]];
    elevated.extend(inner);
    elevated.push(coefficients[count - 1]);
    elevated
}

/// The place of coefficient (`i`, `j`, `k`) in a list of 64; `k` runs fastest.
#[must_use]
pub const fn flat(i: usize, j: usize, k: usize) -> usize {
    (i * 4 + j) * 4 + k
}

/// How far apart neighbours along an axis are in a list of 64.
pub(super) const fn stride(axis: Axis) -> usize {
    [16, 4, 1][axis as usize]
}

/// Where the 16 lines of coefficients along an axis begin in a list of 64; the later of the other two axes runs
/// fastest.
pub(super) fn lines(axis: Axis) -> impl Iterator<Item = usize> {
    let [first, second] = axis.others().map(stride);
    (0..4).flat_map(move |a| (0..4).map(move |b| a * first + b * second))
}

/// The sum of 64 coefficients, weighted by the product of one weight for each axis.
pub(super) fn contract<T: Coefficient>(net: &[T; 64], weights: &[[f64; 4]; 3]) -> T {
    let [u, v, w] = weights;
    let line = |at: usize| net[at] * w[0] + net[at + 1] * w[1] + net[at + 2] * w[2] + net[at + 3] * w[3];
    let layer =
        |at: usize| line(at) * v[0] + line(at + 4) * v[1] + line(at + 8) * v[2] + line(at + 12) * v[3];
    layer(0) * u[0] + layer(16) * u[1] + layer(32) * u[2] + layer(48) * u[3]
}

/// The two parts of a net that is split at `t` across an axis.
pub(super) fn split_net<T: Coefficient>(net: &[T; 64], axis: Axis, t: f64) -> [[T; 64]; 2] {
    let mut parts = [*net, *net];
    let step = stride(axis);
    for start in lines(axis) {
        let mut first = [0, 1, 2, 3].map(|i| net[start + i * step]);
        let mut second = first;
        split(&mut first, &mut second, t);
        for i in 0..4 {
            parts[0][start + i * step] = first[i];
            parts[1][start + i * step] = second[i];
        }
    }
    parts
}

/// The coefficients of a line on [`lo`, `hi`], by blossoming; `lo` may be `hi`.
pub(super) fn restrict<T: Coefficient, const N: usize>(line: [T; N], lo: f64, hi: f64) -> [T; N] {
    std::array::from_fn(|place| {
        let mut blossom = line;
        for step in 1..N {
            let t = if step <= place { hi } else { lo };
            for i in 0..N - step {
                blossom[i] = between(blossom[i], blossom[i + 1], t);
            }
        }
        blossom[0]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Value of a polynomial in Bernstein form, by the definition.
    fn value(coefficients: &[f64], t: f64) -> f64 {
        let degree = coefficients.len() - 1;
        let weight = |i: usize| binomial(degree, i) * t.powi(i as i32) * (1.0 - t).powi((degree - i) as i32);
        coefficients.iter().enumerate().map(|(i, c)| c * weight(i)).sum()
    }

    #[test]
    fn binomials_are_pascals() {
        assert_eq!((0..=8).map(|k| binomial(8, k)).sum::<f64>(), 256.0);
        assert_eq!([binomial(8, 3), binomial(11, 5), binomial(3, 4)], [56.0, 462.0, 0.0]);
    }

    #[test]
    fn the_polynomials_are_a_partition_of_unity_and_their_slopes_sum_to_zero() {
        for step in 0..=100 {
            let t = f64::from(step) / 100.0;
            assert!((cubic(t).iter().sum::<f64>() - 1.0).abs() < 1e-15);
            assert!(cubic_slope(t).iter().sum::<f64>().abs() < 1e-15);
            for i in 0..4 {
                let mut one = [0.0; 4];
                one[i] = 1.0;
                assert!((cubic(t)[i] - value(&one, t)).abs() < 1e-15);
                let near = (cubic(t + 1e-6)[i] - cubic(t - 1e-6)[i]) / 2e-6;
                assert!((cubic_slope(t)[i] - near).abs() < 1e-9);
            }
        }
    }

    /// With coefficients and parameters that are short in binary, nothing is rounded.
    #[test]
    fn parts_of_a_split_are_the_polynomial_itself() {
        let whole = [1.0, -3.0, 4.0, 7.0, 0.5, 2.0, -1.0, 8.0, 3.0];
        for t in [0.25, 0.5, 0.75] {
            let (mut first, mut second) = (whole, whole);
            split(&mut first, &mut second, t);
            for step in 0..=8 {
                let s = f64::from(step) / 8.0;
                assert_eq!(value(&first, s), value(&whole, s * t), "first part at {s}");
                assert_eq!(value(&second, s), value(&whole, t + s * (1.0 - t)), "second part at {s}");
            }
        }
    }

    #[test]
    fn elevation_and_restriction_keep_the_polynomial() {
        let whole = [1.0, -3.0, 4.0, 7.0];
        let elevated = elevate(&whole);
        assert_eq!(elevated.len(), 5);
        let part = restrict(whole, 0.25, 0.75);
        for step in 0..=16 {
            let t = f64::from(step) / 16.0;
            assert!((value(&elevated, t) - value(&whole, t)).abs() < 1e-14);
            assert!((value(&part, t) - value(&whole, 0.25 + t / 2.0)).abs() < 1e-14);
        }
        assert_eq!(restrict(whole, 0.5, 0.5), [value(&whole, 0.5); 4]);
        assert_eq!(elevate(&[2.0]), [2.0, 2.0]);
    }

    #[test]
    fn every_coefficient_lies_on_one_line_of_each_axis() {
        for axis in Axis::ALL {
            let mut seen: Vec<usize> =
                lines(axis).flat_map(|at| (0..4).map(move |i| at + i * stride(axis))).collect();
            seen.sort_unstable();
            assert_eq!(seen, (0..64).collect::<Vec<_>>());
        }
        assert_eq!(flat(1, 2, 3), stride(Axis::U) + 2 * stride(Axis::V) + 3 * stride(Axis::W));
    }
}
