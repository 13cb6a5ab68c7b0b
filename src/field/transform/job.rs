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
/// Distances that are made of squares between two looks at the clock.
const BATCH: usize = 1 << 16;

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
    work: Work,
}

#[derive(Debug)]
enum Work {
    /// Squares of whole numbers of voxels.
    Voxels(Envelope<f32>),
    /// Squared lengths, where the spacings differ or the grid is too long for whole numbers in `f32`.
    Lengths(Envelope<f64>),
    Window(Window),
    /// Squares become distances; those before the number are done.
    Rooting(Vec<f32>, usize),
    Gathering(Levels, Vec<f32>),
    Done(Vec<f32>),
}

/// Squares that distances are made of in another place.
#[derive(Debug)]
enum Levels {
    Lengths(Vec<f64>),
    /// With the distance of each square.
    Window(Window, Vec<f32>),
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
        let work = match common {
            Some(step) if limit / step <= SHORT => Work::Window(Window::new(grid, limit / step, is_feature)),
            Some(_) => Work::Voxels(Envelope::new(grid, [1.0; 3], is_feature)),
            None => Work::Lengths(Envelope::new(grid, grid.spacing(), is_feature)),
        };
        Ok(Self { scale: common.unwrap_or(1.0), limit, work })
    }

    /// Goes on while `may_go_on` says so, at least by a little; returns whether it has come to its end.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> bool {
        loop {
            let work = std::mem::replace(&mut self.work, Work::Done(Vec::new()));
            self.work = self.advance(work, may_go_on);
            if matches!(self.work, Work::Done(_)) {
                return true;
            }
            if !may_go_on() {
                return false;
            }
        }
    }

    fn advance(&self, work: Work, may_go_on: &mut dyn FnMut() -> bool) -> Work {
        match work {
            Work::Voxels(mut job) => match job.step(may_go_on) {
                true => Work::Rooting(job.into_data(), 0),
                false => Work::Voxels(job),
            },
            Work::Lengths(mut job) => match job.step(may_go_on) {
                true => Work::Gathering(Levels::Lengths(job.into_data()), Vec::new()),
                false => Work::Lengths(job),
            },
            Work::Window(mut job) => match job.step(may_go_on) {
                true => {
                    let within = (0..job.beyond()).map(|level| self.distance(level as f64));
                    let table = within.chain([f32::INFINITY]).collect();
                    Work::Gathering(Levels::Window(job, table), Vec::new())
                }
                false => Work::Window(job),
            },
            Work::Rooting(mut levels, next) => {
                let end = levels.len().min(next + BATCH);
                for level in &mut levels[next..end] {
                    *level = self.distance(f64::from(*level));
                }
                if end < levels.len() { Work::Rooting(levels, end) } else { Work::Done(levels) }
            }
            Work::Gathering(levels, mut found) => {
                let next = found.len();
                let count = match &levels {
                    Levels::Lengths(all) => {
                        found.extend(all.iter().skip(next).take(BATCH).map(|level| self.distance(*level)));
                        all.len()
                    }
                    Levels::Window(job, table) => {
                        found.extend(job.levels(next, BATCH).map(|level| table[level]));
                        job.count()
                    }
                };
                if found.len() < count { Work::Gathering(levels, found) } else { Work::Done(found) }
            }
            Work::Done(found) => Work::Done(found),
        }
    }

    fn distance(&self, level: f64) -> f32 {
        let distance = level.sqrt() * self.scale;
        if distance <= self.limit { distance as f32 } else { f32::INFINITY }
    }

    /// Share of the work that is done.
    #[must_use]
    pub fn progress(&self) -> f64 {
        match &self.work {
            Work::Voxels(job) => 0.9 * job.progress(),
            Work::Lengths(job) => 0.9 * job.progress(),
            Work::Window(job) => 0.9 * job.progress(),
            Work::Rooting(..) | Work::Gathering(..) => 0.95,
            Work::Done(_) => 1.0,
        }
    }

    /// The distances, once [`step`](Self::step) has returned true; none before.
    #[must_use]
    pub fn distances(self) -> Vec<f32> {
        if let Work::Done(found) = self.work { found } else { Vec::new() }
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
                for limit in [None, Some(0.0), Some(1.25), Some(2.2), Some(40.0)] {
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

    #[test]
    fn it_can_be_stopped_at_any_time() {
        for (size, spacing, limit) in
            [([30, 20, 4], 1.0, None), ([30, 20, 4], 1.0, Some(5.0)), ([9, 7, 5], 0.5, None)]
        {
            let grid = Grid::new(size, [1.0, 1.0, spacing]).unwrap();
            let features = random_features(&grid, 0.02, 3);
            let mut job = DistanceJob::new(&grid, &features, limit).unwrap();
            while !job.step(&mut || false) {
                assert!((0.0..1.0).contains(&job.progress()));
            }
            assert_eq!((job.progress(), job.distances()), (1.0, distances(&grid, &features, limit).unwrap()));
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
