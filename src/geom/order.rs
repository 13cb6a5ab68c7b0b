//! The order of things by number.
//!
//! One sort serves all types: the standard library compiles another for each type and comparison, which add up to a twentieth of
//! the module.

/// Indices `0..count` in ascending order of a number for each, as [`f64::total_cmp`] has it; equal ones keep their order.
pub fn order_by_number(count: usize, mut number: impl FnMut(usize) -> f64) -> Vec<usize> {
    order_by_pair(count, |i| [total(number(i)), 0])
}

/// Indices `0..count` in ascending order of a pair for each, the first number before the second; equal ones keep their order.
pub fn order_by_pair(count: usize, mut pair: impl FnMut(usize) -> [i64; 2]) -> Vec<usize> {
    sorted((0..count).map(|i| (pair(i), i)).collect())
}

#[inline(never)]
fn sorted(mut keys: Vec<([i64; 2], usize)>) -> Vec<usize> {
    keys.sort_unstable();
    keys.into_iter().map(|(_, i)| i).collect()
}

/// An integer in the order of [`f64::total_cmp`]: the bits as a signed number, those below the sign turned over where it is set.
fn total(x: f64) -> i64 {
    let bits = x.to_bits() as i64;
    bits ^ (((bits >> 63) as u64) >> 1) as i64
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn numbers_are_in_the_order_of_the_standard_library(numbers in prop::collection::vec(any::<f64>(), 0..200)) {
            let mut expected: Vec<usize> = (0..numbers.len()).collect();
            expected.sort_by(|&i, &k| numbers[i].total_cmp(&numbers[k]));
            prop_assert_eq!(order_by_number(numbers.len(), |i| numbers[i]), expected);
        }

        #[test]
        fn pairs_are_in_the_order_of_the_standard_library(pairs in prop::collection::vec([-3_i64..3, -3..3], 0..200)) {
            let mut expected: Vec<usize> = (0..pairs.len()).collect();
            expected.sort_by_key(|&i| pairs[i]);
            prop_assert_eq!(order_by_pair(pairs.len(), |i| pairs[i]), expected);
        }
    }

    #[test]
    fn signed_zeros_and_nan_have_a_place() {
        let numbers = [f64::NAN, 0.0, -0.0, f64::NEG_INFINITY, -f64::NAN, 1.0];
        assert_eq!(order_by_number(numbers.len(), |i| numbers[i]), [4, 3, 2, 1, 5, 0]);
    }
}
