//! Why a curve was refused.

use std::error::Error;
use std::fmt;

use crate::geom::Full;
use glam::DVec2;

/// Why the numbers given do not make a [`BSpline`](super::BSpline). Indices count from zero.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum CurveError {
    /// The degree is outside 2..=32.
    Degree {
        /// The degree given.
        degree: usize,
    },
    /// Fewer control points than degree + 1.
    TooFewPoints {
        /// Number of points given.
        count: usize,
        /// Smallest number for this degree.
        needed: usize,
    },
    /// More control points than a curve may have.
    TooManyPoints {
        /// Number of points given, or that there would be.
        count: usize,
        /// Largest number.
        limit: usize,
    },
    /// A coordinate is infinite or not a number.
    PointNotFinite {
        /// Index of the control point.
        index: usize,
        /// The point as given.
        point: DVec2,
    },
    /// A coordinate is larger than the limit in absolute value.
    PointTooLarge {
        /// Index of the control point.
        index: usize,
        /// The point as given.
        point: DVec2,
        /// Largest absolute value of a coordinate.
        limit: f64,
    },
    /// All control points coincide, up to rounding, so the curve is one point.
    ZeroLength {
        /// Where the points lie.
        at: DVec2,
    },
    /// The first and the last control point of a clamped curve differ.
    NotClosed {
        /// First control point.
        first: DVec2,
        /// Last control point.
        last: DVec2,
    },
    /// The number of knots fits neither form of knot vector.
    KnotCount {
        /// Number of knots given.
        count: usize,
        /// Number of knots of the full vector.
        full: usize,
        /// Number of knots of the domain alone, which periodic curves accept as well.
        domain: Option<usize>,
    },
    /// A knot is infinite, not a number, or larger than the limit in absolute value.
    KnotNotFinite {
        /// Index of the knot.
        index: usize,
        /// The knot as given.
        value: f64,
        /// Largest absolute value of a knot.
        limit: f64,
    },
    /// A knot is smaller than the one before it.
    KnotsDecrease {
        /// Index of the smaller knot.
        index: usize,
        /// The knot before it.
        previous: f64,
        /// The smaller knot.
        value: f64,
    },
    /// The domain of the knots has no length, or too little for its parameters to be told apart.
    EmptyDomain {
        /// Start of the domain.
        lo: f64,
        /// End of the domain.
        hi: f64,
        /// Smallest length for knots of this size.
        needed: f64,
    },
    /// The knots of a periodic curve outside its domain do not repeat the spacing inside it.
    KnotsNotPeriodic {
        /// Index of the knot.
        index: usize,
        /// The knot as given.
        value: f64,
        /// The knot one period away, moved by the period.
        expected: f64,
    },
    /// One of the `degree + 1` end knots of a clamped curve differs from the end of the domain.
    KnotsNotClamped {
        /// Index of the knot.
        index: usize,
        /// The knot as given.
        value: f64,
        /// The end of the domain.
        expected: f64,
    },
    /// A knot occurs so often that the curve would have a gap.
    Multiplicity {
        /// Index of its first occurrence.
        index: usize,
        /// The knot.
        value: f64,
        /// How often it occurs; on periodic curves the two ends of the domain are one knot.
        multiplicity: usize,
        /// How often it may occur.
        limit: usize,
    },
    /// A parameter for a new knot is infinite or not a number.
    ParameterNotFinite {
        /// The parameter as given.
        u: f64,
    },
    /// A knot cannot be inserted because it is there as often as the degree allows.
    KnotFull {
        /// The knot.
        value: f64,
        /// How often it is there.
        multiplicity: usize,
        /// Degree of the curve.
        degree: usize,
    },
}

impl fmt::Display for CurveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Degree { degree } => write!(f, "degree is {degree}; expected 2 to 32"),
            Self::TooFewPoints { count, needed } => {
                write!(f, "{count} control points; expected at least degree + 1 = {needed}")
            }
            Self::TooManyPoints { count, limit } => {
                write!(f, "{count} control points; expected at most {limit}")
            }
            Self::PointNotFinite { index, point } => {
                let (x, y) = (Full(point.x), Full(point.y));
                write!(f, "control point {index} is ({x}, {y}); expected finite coordinates")
            }
            Self::PointTooLarge { index, point, limit } => write!(
                f,
                "control point {index} is ({}, {}); expected coordinates of at most {limit:e} in absolute value",
                Full(point.x),
                Full(point.y)
            ),
            Self::ZeroLength { at } => {
                write!(
                    f,
                    "all control points lie at ({}, {}); expected a curve of positive length",
                    Full(at.x),
                    Full(at.y)
                )
            }
            Self::NotClosed { first, last } => write!(
                f,
                "the last control point is ({}, {}); expected the first one, ({}, {}), since the curve is clamped",
                Full(last.x),
                Full(last.y),
                Full(first.x),
                Full(first.y)
            ),
            Self::KnotCount { count, full, domain: None } => write!(f, "{count} knots; expected {full}"),
            Self::KnotCount { count, full, domain: Some(domain) } => {
                write!(f, "{count} knots; expected {full}, or the {domain} knots of the domain")
            }
            Self::KnotNotFinite { index, value, limit } => {
                let value = Full(value);
                write!(f, "knot {index} is {value}; expected a number of at most {limit:e} in absolute value")
            }
            Self::KnotsDecrease { index, previous, value } => {
                let (value, previous) = (Full(value), Full(previous));
                write!(f, "knot {index} is {value}; expected at least the knot before it, {previous}")
            }
            Self::EmptyDomain { lo, hi, needed } => {
                let (lo, hi) = (Full(lo), Full(hi));
                write!(f, "the knots span the domain [{lo}, {hi}]; expected a length of at least {needed:e}")
            }
            Self::KnotsNotPeriodic { index, value, expected } => {
                write!(
                    f,
                    "knot {index} is {value}; expected {expected}, since the spacing repeats with the period"
                )
            }
            Self::KnotsNotClamped { index, value, expected } => {
                write!(
                    f,
                    "knot {index} is {value}; expected {expected}, the end of the domain of a clamped curve"
                )
            }
            Self::Multiplicity { index, value, multiplicity, limit } => {
                write!(
                    f,
                    "knot {index}, {value}, occurs {multiplicity} times; expected at most {limit} times"
                )
            }
            Self::ParameterNotFinite { u } => write!(f, "the parameter is {u}; expected a finite number"),
            Self::KnotFull { value, multiplicity, degree } => write!(
                f,
                "the knot {value} is there {multiplicity} times; expected fewer than the degree, {degree}, for another one"
            ),
        }
    }
}

impl Error for CurveError {}
