//! Planar B-spline curves: basis, evaluation, arc length, sampling, checks, fitting.
//!
//! A curve is checked once, in [`BSpline::new`], and never changes; operations give new curves. Parameters
//! are in the knot domain `[lo, hi)` of the curve and are wrapped into it. Questions that need pieces (area,
//! lengths, nearest point, intersections) turn every knot span into a Bezier curve and work in coordinates
//! about the middle of the curve, so a shape far from the origin loses nothing.

mod adaptive;
mod arc_length;
mod basis;
mod bezier;
mod bspline;
mod cone;
mod corner;
mod error;
mod fit;
mod flatten;
mod hull_tree;
mod insert_knot;
mod knots;
mod meeting;
mod nearest;
mod sample;
#[cfg(feature = "paths")]
mod stretch;

pub use adaptive::{Fineness, sample_adaptively};
pub use arc_length::ArcLength;
pub use bspline::{BSpline, Form};
pub use corner::Corner;
pub use error::CurveError;
pub use fit::{CornerRule, EndRule, Fit, FitError, FitOptions, MOST_POINTS as MOST_FIT_POINTS, fit};
pub use meeting::Meeting;
pub use nearest::Nearest;
pub use sample::{Samples, Scheme, sample};
