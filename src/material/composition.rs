//! What a body is made of at one point: volume fractions of its materials.

use std::error::Error;
use std::fmt;

/// How far the sum of given fractions may be from 1 before they are refused; closer sums are normalised.
///
/// Large enough for fractions that were written with ten decimals, far too small to hide a forgotten material.
const SUM_TOLERANCE: f64 = 1e-9;

/// Volume fractions of the materials at a point: a point of the simplex.
///
/// # Guarantees
/// - There is at least one fraction.
/// - Each is finite and not negative.
/// - Their sum is 1 up to rounding.
#[derive(Debug, Clone, PartialEq)]
pub struct Composition(Vec<f64>);

/// Why fractions are not a composition.
#[derive(Debug, Clone, PartialEq)]
pub enum CompositionError {
    /// No fraction was given.
    Empty,
    /// A fraction is not a finite number.
    NotFinite {
        /// Position in the list, from 0.
        index: usize,
        /// The fraction.
        value: f64,
    },
    /// A fraction is below 0.
    Negative {
        /// Position in the list, from 0.
        index: usize,
        /// The fraction.
        value: f64,
    },
    /// The fractions do not add up to 1.
    Sum {
        /// What they add up to.
        sum: f64,
    },
}

impl fmt::Display for CompositionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "mix: expected one fraction for each material, found none"),
            Self::NotFinite { index, value } => {
                write!(f, "mix[{index}] is {value}: expected a finite number")
            }
            Self::Negative { index, value } => write!(f, "mix[{index}] is {value}: expected 0 or more"),
            Self::Sum { sum } => write!(f, "mix adds up to {sum}: expected 1 (within {SUM_TOLERANCE:e})"),
        }
    }
}

impl Error for CompositionError {}

impl Composition {
    /// Checks and normalises volume fractions, one for each material in the order of the document.
    ///
    /// # Errors
    /// An empty list, a negative or non-finite fraction, or a sum farther than 1e-9 from 1.
    pub fn new(fractions: Vec<f64>) -> Result<Self, CompositionError> {
        if fractions.is_empty() {
            return Err(CompositionError::Empty);
        }
        for (index, &value) in fractions.iter().enumerate() {
            if !value.is_finite() {
                return Err(CompositionError::NotFinite { index, value });
            }
            if value < 0.0 {
                return Err(CompositionError::Negative { index, value });
            }
        }
        let sum: f64 = fractions.iter().sum();
        if (sum - 1.0).abs() > SUM_TOLERANCE {
            return Err(CompositionError::Sum { sum });
        }
        Ok(Self(fractions.into_iter().map(|f| f / sum).collect()))
    }

    /// All of one material out of `count`.
    ///
    /// # Panics
    /// When `index` is not below `count`.
    #[must_use]
    pub fn pure(index: usize, count: usize) -> Self {
        assert!(index < count, "material {index} of {count}");
        Self((0..count).map(|i| if i == index { 1.0 } else { 0.0 }).collect())
    }

    /// The composition of fractions that rounding may have brought a little below 0 or off the sum 1, such as those of a mean.
    #[cfg(any(feature = "hyperpatch", feature = "stack", feature = "harmonic"))]
    pub(crate) fn rounded(mut fractions: Vec<f64>) -> Self {
        fractions.iter_mut().for_each(|fraction| *fraction = fraction.max(0.0));
        let sum: f64 = fractions.iter().sum();
        fractions.iter_mut().for_each(|fraction| *fraction /= sum);
        Self(fractions)
    }

    /// The composition that is nearest to any finite numbers: their projection onto the simplex.
    ///
    /// It serves to take what a person typed or dragged; it does not keep the slope of a gradient.
    ///
    /// # Errors
    /// An empty list, or a number that is not finite.
    ///
    /// # References
    /// M. Held, P. Wolfe and H. Crowder, "Validation of subgradient optimization", *Mathematical Programming* 6 (1974).
    pub fn nearest(numbers: &[f64]) -> Result<Self, CompositionError> {
        if let Some(index) = numbers.iter().position(|number| !number.is_finite()) {
            return Err(CompositionError::NotFinite { index, value: numbers[index] });
        }
        let mut sorted = numbers.to_vec();
        sorted.sort_unstable_by(|a, b| b.total_cmp(a));
        let largest = *sorted.first().ok_or(CompositionError::Empty)?;
        // Measured from the largest number, so that huge ones do not swallow the 1.
        let (mut sum, mut level) = (0.0, 0.0);
        for (k, number) in sorted.iter().enumerate() {
            sum += number - largest;
            let candidate = (sum - 1.0) / (k + 1) as f64;
            if number - largest <= candidate {
                break;
            }
            level = candidate;
        }
        let fractions: Vec<f64> = numbers.iter().map(|number| (number - largest - level).max(0.0)).collect();
        let sum: f64 = fractions.iter().sum();
        Ok(Self(fractions.into_iter().map(|fraction| fraction / sum).collect()))
    }

    /// The fractions, one for each material.
    #[must_use]
    pub fn fractions(&self) -> &[f64] {
        &self.0
    }

    /// The straight blend `(1 - t) self + t other`; `t` is clamped to [0, 1], so the result is a composition again.
    ///
    /// # Panics
    /// When the two have different numbers of materials, or `t` is not a number.
    #[must_use]
    pub fn mix(&self, other: &Self, t: f64) -> Self {
        assert_eq!(self.0.len(), other.0.len(), "compositions of different numbers of materials");
        assert!(!t.is_nan(), "the blend parameter is not a number");
        let t = t.clamp(0.0, 1.0);
        Self(self.0.iter().zip(&other.0).map(|(a, b)| a * (1.0 - t) + b * t).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn good_fractions_sum_to_one() {
        let thirds = Composition::new(vec![0.333_333_333_3, 0.333_333_333_3, 0.333_333_333_4]).unwrap();
        assert!((thirds.fractions().iter().sum::<f64>() - 1.0).abs() < 1e-15);
        assert_eq!(Composition::new(vec![1.0]).unwrap(), Composition::pure(0, 1));
    }

    #[test]
    fn wrong_fractions_are_refused_with_their_place() {
        assert_eq!(Composition::new(vec![]), Err(CompositionError::Empty));
        assert_eq!(
            Composition::new(vec![1.5, -0.5]),
            Err(CompositionError::Negative { index: 1, value: -0.5 })
        );
        assert_eq!(Composition::new(vec![0.5, 0.4]), Err(CompositionError::Sum { sum: 0.9 }));
        assert!(matches!(
            Composition::new(vec![0.5, f64::NAN]),
            Err(CompositionError::NotFinite { index: 1, .. })
        ));
        assert!(CompositionError::Sum { sum: 0.9 }.to_string().contains("expected 1"));
    }

    #[test]
    fn the_nearest_composition_is_nearer_than_any_other() {
        for numbers in [
            &[0.5, 0.5, 0.5][..],
            &[-0.1, 1.1, 0.3],
            &[2.0, -3.0, 1.9],
            &[0.2, 0.3, 0.5],
            &[1e300, -1e300, 0.0],
        ] {
            let nearest = Composition::nearest(numbers).unwrap();
            assert!(Composition::new(nearest.fractions().to_vec()).is_ok(), "{nearest:?}");
            let distance = |mix: &[f64]| mix.iter().zip(numbers).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
            for (i, j) in [(20, 0), (3, 5), (0, 20), (7, 7), (0, 0), (10, 3)] {
                let other = [f64::from(i) / 20.0, f64::from(j) / 20.0, f64::from(20 - i - j) / 20.0];
                assert!(
                    distance(nearest.fractions()) <= distance(&other) + 1e-12,
                    "{numbers:?}: {nearest:?}"
                );
            }
        }
        assert_eq!(Composition::nearest(&[-0.1, 1.1]).unwrap().fractions(), [0.0, 1.0]);
        assert_eq!(Composition::nearest(&[]), Err(CompositionError::Empty));
        assert!(matches!(
            Composition::nearest(&[0.0, f64::NAN]),
            Err(CompositionError::NotFinite { index: 1, .. })
        ));
    }

    #[test]
    fn mixing_stays_on_the_simplex() {
        let a = Composition::pure(0, 3);
        let b = Composition::new(vec![0.0, 0.25, 0.75]).unwrap();
        assert_eq!(a.mix(&b, 0.0), a);
        assert_eq!(a.mix(&b, 1.0), b);
        assert_eq!(a.mix(&b, 7.0), b);
        assert_eq!(a.mix(&b, 0.5).fractions(), [0.5, 0.125, 0.375]);
    }
}
