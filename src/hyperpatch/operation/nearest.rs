//! The nearest values that fulfil linear conditions.

use crate::hyperpatch::bernstein::Coefficient;

/// Length of what is left of a condition below which it follows from the others.
const DEPENDENT: f64 = 1e-9;

/// Conditions: each is a sum of multiples of values that must be zero.
pub(super) type Conditions = [Vec<(usize, f64)>];

/// Changes values as little as possible, in the sum of squares, so that they fulfil conditions; those that are fixed
/// stay. The conditions must leave a solution.
///
/// The conditions are made orthonormal one after the other (Gram and Schmidt), so that each is fulfilled without
/// touching those before it; what follows from others drops out.
pub(super) fn nearest<T: Coefficient>(values: &mut [T], conditions: &Conditions, is_fixed: &[bool]) {
    let Some(&any) = values.first() else { return };
    let zero = any * 0.0;
    let mut basis: Vec<(Vec<f64>, T)> = Vec::new();
    for condition in conditions {
        let mut row = vec![0.0; values.len()];
        let mut excess = zero;
        for &(n, factor) in condition {
            excess = excess + values[n] * factor;
            if !is_fixed[n] {
                row[n] += factor;
            }
        }
        // Twice, because once leaves the rounding of the larger part.
        for _ in 0..2 {
            for (known, done) in &basis {
                let part: f64 = known.iter().zip(&row).map(|(a, b)| a * b).sum();
                row.iter_mut().zip(known).for_each(|(a, b)| *a -= part * b);
                excess = excess - *done * part;
            }
        }
        let length = row.iter().map(|x| x * x).sum::<f64>().sqrt();
        if length > DEPENDENT {
            row.iter_mut().for_each(|x| *x /= length);
            basis.push((row, excess * (1.0 / length)));
        }
    }
    for (row, excess) in basis {
        for (value, share) in values.iter_mut().zip(row) {
            *value = *value - excess * share;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One condition: the point is the foot of the perpendicular on the plane.
    #[test]
    fn the_nearest_values_are_feet_of_perpendiculars() {
        let mut values = [3.0, 1.0, 5.0];
        nearest(&mut values, &[vec![(0, 1.0), (1, -2.0), (2, 1.0)]], &[false; 3]);
        assert_eq!(values.map(|x| (x * 1e12).round() / 1e12), [2.0, 3.0, 4.0]);
        let mut values = [3.0, 1.0, 5.0];
        nearest(&mut values, &[vec![(0, 1.0), (1, -2.0), (2, 1.0)]], &[false, true, false]);
        assert!((0..3).all(|n| (values[n] - n as f64).abs() < 1e-14), "{values:?}");
    }

    #[test]
    fn conditions_that_follow_from_others_change_nothing() {
        let equal = |a: usize, b: usize| vec![(a, 1.0), (b, -1.0)];
        let (mut values, mut more) = ([1.0, 2.0, 6.0], [1.0, 2.0, 6.0]);
        nearest(&mut values, &[equal(0, 1), equal(1, 2)], &[false; 3]);
        nearest(&mut more, &[equal(0, 1), equal(1, 2), equal(0, 2), equal(0, 1)], &[false; 3]);
        assert!(values.iter().all(|x| (x - 3.0_f64).abs() < 1e-14));
        assert_eq!(values, more);
        nearest::<f64>(&mut [], &[], &[]);
    }
}
