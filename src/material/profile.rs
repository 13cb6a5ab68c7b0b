//! Composition along a curve.

use std::error::Error;
use std::fmt;

use super::Composition;

/// Composition along a curve: linear between keys; past the last one cyclic on a closed curve, and constant on an open one.
///
/// # Guarantees
/// - There is at least one key.
/// - The places are in [0, 1), on an open curve in [0, 1], and strictly ascending.
/// - All compositions have the same number of materials.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    keys: Vec<(f64, Composition)>,
    closed: bool,
}

/// Why keys are not a profile.
#[derive(Debug, Clone, PartialEq)]
pub enum ProfileError {
    /// No key was given.
    Empty,
    /// A place is outside [0, 1), on an open curve outside [0, 1], or not a number.
    Place {
        /// Position in the list, from 0.
        index: usize,
        /// The place.
        at: f64,
        /// Whether the curve is closed.
        closed: bool,
    },
    /// A place is not above the one before.
    Order {
        /// Position in the list, from 0.
        index: usize,
        /// The place.
        at: f64,
        /// The place before.
        previous: f64,
    },
    /// A composition has another number of materials than the first.
    Materials {
        /// Position in the list, from 0.
        index: usize,
        /// Its number of materials.
        found: usize,
        /// That of the first.
        expected: usize,
    },
}

impl fmt::Display for ProfileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "composition: expected at least one key"),
            Self::Place { index, at, closed } => {
                let limit = if *closed { "below 1" } else { "1" };
                write!(f, "composition[{index}].at is {at}: expected a number from 0 to {limit}")
            }
            Self::Order { index, at, previous } => {
                write!(f, "composition[{index}].at is {at}: expected more than the {previous} before it")
            }
            Self::Materials { index, found, expected } => {
                write!(f, "composition[{index}].mix has {found} fractions: expected {expected}")
            }
        }
    }
}

impl Error for ProfileError {}

impl Profile {
    /// Checks keys: a place as a fraction of the knot domain, and the composition there.
    ///
    /// # Errors
    /// No key, a place out of range, places that do not ascend strictly, or different numbers of materials.
    pub fn new(keys: Vec<(f64, Composition)>, closed: bool) -> Result<Self, ProfileError> {
        let expected = keys.first().ok_or(ProfileError::Empty)?.1.fractions().len();
        let mut previous = None;
        for (index, (at, composition)) in keys.iter().enumerate() {
            let at = *at;
            if !(0.0..=1.0).contains(&at) || closed && at == 1.0 {
                return Err(ProfileError::Place { index, at, closed });
            }
            if let Some(previous) = previous.filter(|&p| at <= p) {
                return Err(ProfileError::Order { index, at, previous });
            }
            let found = composition.fractions().len();
            if found != expected {
                return Err(ProfileError::Materials { index, found, expected });
            }
            previous = Some(at);
        }
        Ok(Self { keys, closed })
    }

    /// The same composition everywhere.
    #[must_use]
    pub fn constant(composition: Composition) -> Self {
        Self { keys: vec![(0.0, composition)], closed: true }
    }

    /// The composition at a fraction of the knot domain; fractions outside [0, 1) are wrapped into it on a closed curve.
    ///
    /// # Panics
    /// When the fraction is not finite.
    #[must_use]
    pub fn at(&self, fraction: f64) -> Composition {
        assert!(fraction.is_finite(), "the fraction {fraction} is not finite");
        let x = if self.closed { fraction.rem_euclid(1.0) } else { fraction };
        let count = self.keys.len();
        let next = self.keys.partition_point(|(at, _)| *at <= x);
        if !self.closed && (next == 0 || next == count) {
            return self.keys[next.max(1) - 1].1.clone();
        }
        let (from, a) = &self.keys[(next + count - 1) % count];
        let (to, b) = &self.keys[next % count];
        // On a closed curve a single key is followed by itself; on an open one the keys on either side differ.
        let ahead = |place: f64| if self.closed { (place - from).rem_euclid(1.0) } else { place - from };
        let span = ahead(*to);
        if span == 0.0 {
            return a.clone();
        }
        a.mix(b, ahead(x) / span)
    }

    /// The keys, places ascending.
    #[must_use]
    pub fn keys(&self) -> &[(f64, Composition)] {
        &self.keys
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two(first: f64) -> Composition {
        Composition::new(vec![first, 1.0 - first]).unwrap()
    }

    #[test]
    fn linear_between_keys_and_across_the_seam() {
        let profile = Profile::new(vec![(0.25, two(1.0)), (0.75, two(0.0))], true).unwrap();
        for (at, first) in
            [(0.25, 1.0), (0.5, 0.5), (0.75, 0.0), (0.0, 0.5), (0.875, 0.25), (1.5, 0.5), (-0.25, 0.0)]
        {
            let found = profile.at(at).fractions()[0];
            assert!((found - first).abs() < 1e-12, "at {at}: {found}, expected {first}");
        }
    }

    #[test]
    fn an_open_profile_runs_from_end_to_end_and_is_constant_beyond_its_keys() {
        let whole = Profile::new(vec![(0.0, two(1.0)), (1.0, two(0.0))], false).unwrap();
        let part = Profile::new(vec![(0.25, two(1.0)), (0.75, two(0.0))], false).unwrap();
        for (at, first, of_part) in
            [(0.0, 1.0, 1.0), (0.125, 0.875, 1.0), (0.5, 0.5, 0.5), (0.875, 0.125, 0.0), (1.0, 0.0, 0.0)]
        {
            assert!((whole.at(at).fractions()[0] - first).abs() < 1e-12, "at {at}");
            assert!((part.at(at).fractions()[0] - of_part).abs() < 1e-12, "at {at}");
        }
    }

    #[test]
    fn one_key_is_constant() {
        let profile = Profile::constant(two(0.3));
        assert_eq!(profile.at(0.9), two(0.3));
        let moved = Profile::new(vec![(0.4, two(0.3))], true).unwrap();
        assert_eq!(moved.at(0.1), two(0.3));
        assert_eq!(moved.keys().len(), 1);
    }

    #[test]
    fn wrong_keys_are_refused() {
        assert_eq!(Profile::new(vec![], true), Err(ProfileError::Empty));
        assert_eq!(
            Profile::new(vec![(1.0, two(1.0))], true),
            Err(ProfileError::Place { index: 0, at: 1.0, closed: true })
        );
        assert!(Profile::new(vec![(f64::NAN, two(1.0))], true).is_err());
        assert_eq!(
            Profile::new(vec![(0.5, two(1.0)), (0.5, two(0.0))], true),
            Err(ProfileError::Order { index: 1, at: 0.5, previous: 0.5 })
        );
        assert_eq!(
            Profile::new(vec![(0.0, two(1.0)), (0.5, Composition::pure(0, 3))], true),
            Err(ProfileError::Materials { index: 1, found: 3, expected: 2 })
        );
    }
}
