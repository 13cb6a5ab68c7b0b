//! Why no curve was fitted.

use std::error::Error;
use std::fmt;

use glam::DVec2;

use crate::curve::CurveError;
use crate::geom::{Shown, ShownPlace};

/// Why no curve was fitted to a list of points. Indices count from zero.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum FitError {
    /// More points than are taken.
    TooManyPoints {
        /// Number of points given.
        count: usize,
        /// Largest number.
        limit: usize,
    },
    /// A coordinate is infinite, not a number, or larger than the limit in absolute value.
    Point {
        /// Index of the point.
        index: usize,
        /// The point as given.
        point: DVec2,
        /// Largest absolute value of a coordinate.
        limit: f64,
    },
    /// Fewer than three points that differ.
    TooFewPoints {
        /// Number of points that differ from the one before.
        count: usize,
    },
    /// All points lie on one line, so that a closed curve would run back along itself.
    Flat {
        /// The first point.
        at: DVec2,
    },
    /// The tolerance is not a positive number.
    Tolerance {
        /// The tolerance as given.
        tolerance: f64,
    },
    /// A corner was given that is no index of a point.
    CornerIndex {
        /// Its place in the list of corners.
        position: usize,
        /// The index given.
        index: usize,
        /// Number of points.
        count: usize,
    },
    /// The tolerance takes more control points than a curve may have.
    OutOfReach {
        /// The tolerance asked for.
        tolerance: f64,
        /// Largest number of control points.
        limit: usize,
    },
    /// A curve through all the points takes more control points than a curve may have.
    TooManyToMeet {
        /// Number of points that differ.
        count: usize,
        /// Largest number of control points.
        limit: usize,
    },
    /// The curve found is not one that the curve type takes: the points lie too close together for their size.
    Curve(CurveError),
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::TooManyPoints { count, limit } => {
                write!(f, "{count} points were found; expected at most {limit}")
            }
            Self::Point { index, point, limit } => write!(
                f,
                "point {index} is {}; expected finite coordinates of at most {} in absolute value",
                ShownPlace(point),
                Shown(limit)
            ),
            Self::TooFewPoints { count } => {
                write!(f, "{count} different points were found; expected at least 3")
            }
            Self::Flat { at } => {
                write!(
                    f,
                    "all points lie on one line through {}; expected points around an area",
                    ShownPlace(at)
                )
            }
            Self::Tolerance { tolerance } => {
                write!(f, "{} was found; expected a finite number above 0", Shown(tolerance))
            }
            Self::CornerIndex { position, index, count } => {
                write!(f, "corner {position} is {index}; expected an index below {count}")
            }
            Self::OutOfReach { tolerance, limit } => write!(
                f,
                "a tolerance of {} takes more than {limit} control points here; expected a larger one",
                Shown(tolerance)
            ),
            Self::TooManyToMeet { count, limit } => {
                write!(f, "a curve through {count} points was asked for; expected at most {limit}")
            }
            Self::Curve(error) => error.fmt(f),
        }
    }
}

impl Error for FitError {}
