//! Sampling a curve.

use glam::DVec2;

use super::bspline::BSpline;

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
/// The first sample is the start of the domain; its end, the same point, is not repeated. On an open curve the end is the last sample.
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

impl Samples {
    /// Samples of an open curve as those of the same curve reversed.
    #[must_use]
    pub(crate) fn reversed(&self, curve: &BSpline) -> Self {
        let (lo, hi) = curve.domain();
        // The ends stay exact.
        let mirrored = |&u: &f64| {
            if u == lo {
                hi
            } else if u == hi {
                lo
            } else {
                lo + (hi - u)
            }
        };
        Self {
            parameters: self.parameters.iter().rev().map(mirrored).collect(),
            points: self.points.iter().rev().copied().collect(),
            normals: self.normals.iter().rev().map(|normal| -*normal).collect(),
            arc: self.arc.iter().rev().map(|arc| self.length - arc).collect(),
            length: self.length,
        }
    }

    /// Adds samples at parameters, wrapped into the domain, where there is none yet; returns the number of the sample at each.
    ///
    /// A parameter closer than a billionth of the domain to a sample means that sample.
    pub fn insert(&mut self, curve: &BSpline, parameters: &[f64]) -> Vec<usize> {
        let (lo, hi) = curve.domain();
        let close = 1e-9 * (hi - lo);
        let arc_length = curve.arc_length();
        let parameters: Vec<f64> = parameters
            .iter()
            .map(|&u| {
                let wrapped = curve.wrap(u);
                if curve.is_closed() && hi - wrapped < close { lo } else { wrapped }
            })
            .collect();
        let nearest = |known: &[f64], u: f64| known.iter().position(|&known| (known - u).abs() < close);
        for &u in &parameters {
            if nearest(&self.parameters, u).is_none() {
                let at = self.parameters.partition_point(|&known| known < u);
                self.parameters.insert(at, u);
                self.points.insert(at, curve.point(u));
                self.normals.insert(at, curve.normal(u));
                self.arc.insert(at, arc_length.at(u));
            }
        }
        parameters.iter().map(|&u| nearest(&self.parameters, u).unwrap_or(0)).collect()
    }
}

/// Takes `count` samples of a curve, the first at the start of its domain; on an open curve the last at its end.
///
/// Where the curve stands still several samples by parameter may be the same point; by arc length none are. Arc
/// lengths are as accurate as [`ArcLength`](super::ArcLength) says.
///
/// # Panics
/// When `count` is below 3.
#[must_use]
pub fn sample(curve: &BSpline, scheme: Scheme, count: usize) -> Samples {
    assert!(count >= 3, "a curve needs at least 3 samples, not {count}");
    let (lo, hi) = curve.domain();
    let arc_length = curve.arc_length();
    let length = arc_length.total();
    let steps = if curve.is_closed() { count } else { count - 1 };
    let fractions = (0..count).map(|i| i as f64 / steps as f64);
    let (parameters, arc): (Vec<f64>, Vec<f64>) = match scheme {
        Scheme::Parameter => fractions
            .map(|fraction| {
                let u = if fraction < 1.0 { lo + (hi - lo) * fraction } else { hi };
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

#[cfg(test)]
mod tests {
    use super::super::Form;
    use super::*;

    #[test]
    fn inserted_samples_are_found_again_and_known_ones_stay() {
        let square = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(DVec2::from).to_vec();
        let curve = BSpline::new(3, Form::Periodic, square, None).expect("a square");
        let mut samples = sample(&curve, Scheme::Parameter, 4);
        let numbers = samples.insert(&curve, &[0.6, 0.25, 1.1, 1.0, 0.6 + 1e-12]);
        assert_eq!(numbers, [4, 2, 1, 0, 4]);
        assert_eq!(samples.parameters.len(), 6);
        assert!(
            samples.parameters.windows(2).all(|w| w[0] < w[1]) && samples.arc.windows(2).all(|w| w[0] < w[1])
        );
        assert!(samples.points[4].distance(curve.point(0.6)) < 1e-12);
        assert_eq!((samples.normals.len(), samples.arc.len()), (6, 6));
    }
}
