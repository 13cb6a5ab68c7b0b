//! Why there are no paths.

use crate::geom::Shown;
use std::error::Error;
use std::fmt;

/// Why there are no paths of two curves.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum PathError {
    /// The tolerance is out of range.
    Tolerance {
        /// The tolerance as given.
        tolerance: f64,
        /// Smallest one.
        least: f64,
        /// Largest one.
        most: f64,
    },
    /// The tolerance takes more commands than a path may have.
    OutOfReach {
        /// The tolerance asked for.
        tolerance: f64,
        /// Most commands.
        limit: usize,
    },
}

impl fmt::Display for PathError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Tolerance { tolerance, least, most } => write!(
                f,
                "{} was found; expected {} to {}, a billionth to the whole of the diagonal of the curves",
                Shown(tolerance),
                Shown(least),
                Shown(most)
            ),
            Self::OutOfReach { tolerance, limit } => write!(
                f,
                "a tolerance of {} takes more than {limit} commands here; expected a larger one",
                Shown(tolerance)
            ),
        }
    }
}

impl Error for PathError {}
