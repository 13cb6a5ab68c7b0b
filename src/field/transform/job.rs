//! The transform that suits a grid and a limit.

use super::envelope::Envelope;
use super::window::Window;
use crate::field::Grid;
use std::error::Error;
use std::fmt;

/// Longest limit in voxels for which windows are faster than envelopes.
const SHORT: f64 = 48.0;
/// Sums of squares up to which `f32` holds every whole number.
const EXACT: usize = 1 << 24;

/// Why there is no transform.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TransformError {
    /// There is another number of features than of voxels.
    Length {
        /// Features given.
        found: usize,
        /// Voxels of the grid.
        expected: usize,
    },
    /// The limit is not a number of 0 or more.
    Limit {
        /// The limit.
        value: f64,
    },
}

impl fmt::Display for TransformError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { found, expected } => {
                write!(f, "features: {found} numbers were found; expected {expected}, one for each voxel")
            }
            Self::Limit { value } => write!(f, "limit is {value}; expected 0 or more"),
        }
    }
}

impl Error for TransformError {}

/// Distances from the centre of every voxel to the centre of the nearest voxel of a feature, in units of the grid; infinite without a feature,
/// and beyond the limit where there is one. In steps.
#[derive(Debug)]
pub struct DistanceJob {
    scale: f64,
    limit: f64,
    method: Method,
}

#[derive(Debug)]
enum Method {
    /// Whole numbers of voxels, or their squares in `f32`.
    Voxels(Envelope<f32>),
    /// Squared lengths, where the spacings differ or the grid is too long for whole numbers.
    Lengths(Envelope<f64>),
    Window(Window),
}

impl DistanceJob {
    /// Starts a transform; a voxel with a number other than 0 belongs to a feature.
    ///
    /// # Errors
    /// When there are not as many features as voxels, or the limit is negative or no number.
    pub fn new(grid: &Grid, features: &[u8], limit: Option<f64>) -> Result<Self, TransformError> {
        if features.len() != grid.count() {
            return Err(TransformError::Length { found: features.len(), expected: grid.count() });
        }
        let limit = limit.unwrap_or(f64::INFINITY);
        if limit.is_nan() || limit < 0.0 {
            return Err(TransformError::Limit { value: limit });
        }
        let is_feature = |index: usize| features[index] != 0;
        let longest: usize = grid.size().iter().map(|count| (count - 1).saturating_pow(2)).sum();
        let common = grid.common_spacing().filter(|_| longest <= EXACT);
        let method = match common {
            Some(step) if limit / step <= SHORT => {
                Method::Window(Window::new(grid, (limit / step) as usize, is_feature))
            }
            Some(_) => Method::Voxels(Envelope::new(grid, [1.0; 3], is_feature)),
            None => Method::Lengths(Envelope::new(grid, grid.spacing(), is_feature)),
        };
        Ok(Self { scale: common.unwrap_or(1.0), limit, method })
    }

    /// Goes on while `may_go_on` says so, at least by a little; returns whether it has come to its end.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> bool {
        match &mut self.method {
            Method::Voxels(job) => job.step(may_go_on),
            Method::Lengths(job) => job.step(may_go_on),
            Method::Window(job) => job.step(may_go_on),
        }
    }

    /// Share of the work that is done.
    #[must_use]
    pub fn progress(&self) -> f64 {
        match &self.method {
            Method::Voxels(job) => job.progress(),
            Method::Lengths(job) => job.progress(),
            Method::Window(job) => job.progress(),
        }
    }

    /// The distances, once [`step`](Self::step) has returned true.
    #[must_use]
    pub fn distances(self) -> Vec<f32> {
        let (scale, limit) = (self.scale, self.limit);
        let distance = |level: f64| {
            let distance = level.sqrt() * scale;
            if distance <= limit { distance as f32 } else { f32::INFINITY }
        };
        match self.method {
            Method::Voxels(job) => {
                let mut levels = job.into_data();
                for level in &mut levels {
                    *level = distance(f64::from(*level));
                }
                levels
            }
            Method::Lengths(job) => job.into_data().into_iter().map(distance).collect(),
            Method::Window(job) => job
                .levels()
                .map(|level| level.map_or(f32::INFINITY, |level| distance(f64::from(level))))
                .collect(),
        }
    }

    /// Runs the transform to its end.
    #[must_use]
    pub fn run(mut self) -> Vec<f32> {
        self.step(&mut || true);
        self.distances()
    }
}

/// The distances of [`DistanceJob`], at once.
///
/// # Errors
/// As [`DistanceJob::new`].
pub fn distances(grid: &Grid, features: &[u8], limit: Option<f64>) -> Result<Vec<f32>, TransformError> {
    DistanceJob::new(grid, features, limit).map(DistanceJob::run)
}

#[cfg(test)]
mod tests {
    use super::super::test_grids::{brute_force, random_features, sizes};
    use super::*;

    #[test]
    fn distances_are_in_units_of_the_grid_and_end_at_the_limit() {
        for spacing in [[0.25; 3], [1.0, 0.5, 2.0]] {
            for (size, seed) in sizes().into_iter().zip(1..) {
                let grid = Grid::new(size, spacing).unwrap();
                let features = random_features(&grid, 0.01, seed);
                let expected = brute_force(&grid, &features);
                for limit in [None, Some(0.0), Some(1.25), Some(2.0), Some(40.0)] {
                    let found = distances(&grid, &features, limit).unwrap();
                    for (a, (level, _)) in found.iter().zip(&expected) {
                        let b = level.sqrt();
                        let is_within = limit.is_none_or(|limit| b <= limit) && b.is_finite();
                        let is_right = if is_within {
                            (f64::from(*a) - b).abs() <= 1e-7 * b
                        } else {
                            *a == f32::INFINITY
                        };
                        assert!(is_right, "{a}, not {b}, {size:?}, {limit:?}");
                    }
                }
            }
        }
    }

    /// A line that is so long that squares of whole numbers do not fit into `f32`.
    #[test]
    fn long_lines_are_as_exact() {
        let grid = Grid::new([5001, 1, 1], [1.0; 3]).unwrap();
        let mut features = vec![0; 5001];
        features[0] = 1;
        let found = distances(&grid, &features, None).unwrap();
        assert!(found.iter().enumerate().all(|(n, distance)| *distance == n as f32));
    }

    #[test]
    fn wrong_input_is_refused_by_name() {
        let grid = Grid::new([2, 2, 1], [1.0; 3]).unwrap();
        let error = distances(&grid, &[1, 0, 0], None).unwrap_err();
        assert_eq!(error.to_string(), "features: 3 numbers were found; expected 4, one for each voxel");
        let error = distances(&grid, &[1, 0, 0, 0], Some(-1.0)).unwrap_err();
        assert_eq!(error, TransformError::Limit { value: -1.0 });
        assert!(distances(&grid, &[1, 0, 0, 0], Some(f64::NAN)).is_err());
        assert_eq!(distances(&grid, &[1, 0, 0, 0], Some(f64::INFINITY)).unwrap()[3], 2.0_f32.sqrt());
    }
}
