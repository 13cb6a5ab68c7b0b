//! Sampling a curve.

use glam::DVec2;

use super::closed_bspline::ClosedBSpline;

/// How samples are spread over a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Scheme {
    /// Equal steps of the parameter.
    Parameter,
    /// Equal steps of arc length.
    ArcLength,
}

/// Samples of a curve, in ascending order of parameter; all lists have one entry for each sample.
///
/// The first sample is the start of the domain; its end, the same point, is not repeated.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    /// Parameters in the domain.
    pub parameters: Vec<f64>,
    /// Points of the curve.
    pub points: Vec<DVec2>,
    /// Right-hand unit normals, bisectors at corners.
    pub normals: Vec<DVec2>,
    /// Arc length from the start of the domain.
    pub arc: Vec<f64>,
    /// Arc length of the whole curve.
    pub length: f64,
}

/// Takes `count` samples of a curve, the first at the start of its domain.
///
/// Where the curve stands still several samples by parameter may be the same point; by arc length none are. Arc
/// lengths are as accurate as [`ArcLength`](super::ArcLength) says.
///
/// # Panics
/// When `count` is below 3.
#[must_use]
pub fn sample(curve: &ClosedBSpline, scheme: Scheme, count: usize) -> Samples {
    assert!(count >= 3, "a closed curve needs at least 3 samples, not {count}");
    let (lo, hi) = curve.domain();
    let arc_length = curve.arc_length();
    let length = arc_length.total();
    let fractions = (0..count).map(|i| i as f64 / count as f64);
    let (parameters, arc): (Vec<f64>, Vec<f64>) = match scheme {
        Scheme::Parameter => fractions
            .map(|fraction| {
                let u = lo + (hi - lo) * fraction;
                (u, arc_length.at(u))
            })
            .unzip(),
        Scheme::ArcLength => fractions
            .map(|fraction| {
                let s = length * fraction;
                (arc_length.parameter(s), s)
            })
            .unzip(),
    };
    let points = parameters.iter().map(|&u| curve.point(u)).collect();
    let normals = parameters.iter().map(|&u| curve.normal(u)).collect();
    Samples { parameters, points, normals, arc, length }
}
