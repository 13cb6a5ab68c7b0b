//! A grid of voxels.

use std::error::Error;
use std::fmt;

/// Most voxels of a grid: those of 512 x 512 x 512.
pub const MOST_VOXELS: usize = 1 << 27;

/// How many voxels there are along x, y and z, and how far their centres are apart. x runs fastest: voxel (i, j, k) has the index
/// `(k * size[1] + j) * size[0] + i`. A grid of one layer is one of pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    size: [usize; 3],
    spacing: [f64; 3],
}

/// Why there is no such grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GridError {
    /// An axis has no voxel.
    Empty {
        /// Voxels along the axes, as given.
        size: [usize; 3],
    },
    /// There are more voxels than [`MOST_VOXELS`].
    Limit {
        /// Voxels along the axes, as given.
        size: [usize; 3],
    },
    /// Centres are not a positive, finite length apart.
    Spacing {
        /// The axis: 0, 1 or 2.
        axis: usize,
        /// The length.
        value: f64,
    },
}

impl fmt::Display for GridError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty { size: [a, b, c] } => {
                write!(f, "{a} x {b} x {c} voxels; expected 1 or more along each axis")
            }
            Self::Limit { size: [a, b, c] } => {
                write!(f, "{a} x {b} x {c} voxels; expected {MOST_VOXELS} at most in all")
            }
            Self::Spacing { axis, value } => {
                write!(f, "spacing[{axis}] is {value}; expected a finite number above 0")
            }
        }
    }
}

impl Error for GridError {}

impl Grid {
    /// # Errors
    /// When an axis has no voxel, there are too many, or a spacing is not positive and finite.
    pub fn new(size: [usize; 3], spacing: [f64; 3]) -> Result<Self, GridError> {
        if size.contains(&0) {
            return Err(GridError::Empty { size });
        }
        let count = size.iter().try_fold(1_usize, |count, along| count.checked_mul(*along));
        if count.is_none_or(|count| count > MOST_VOXELS) {
            return Err(GridError::Limit { size });
        }
        match spacing.iter().position(|step| !(step.is_finite() && *step > 0.0)) {
            Some(axis) => Err(GridError::Spacing { axis, value: spacing[axis] }),
            None => Ok(Self { size, spacing }),
        }
    }

    /// Voxels along x, y and z.
    #[must_use]
    pub fn size(&self) -> [usize; 3] {
        self.size
    }

    /// Distances between neighbouring centres along x, y and z.
    #[must_use]
    pub fn spacing(&self) -> [f64; 3] {
        self.spacing
    }

    /// Number of voxels.
    #[must_use]
    pub fn count(&self) -> usize {
        self.size.iter().product()
    }

    /// The spacing that all axes share along which there is more than one voxel.
    #[must_use]
    pub fn common_spacing(&self) -> Option<f64> {
        let mut along =
            self.size.iter().zip(self.spacing).filter(|(count, _)| **count > 1).map(|(_, step)| step);
        let first = along.next().unwrap_or(self.spacing[0]);
        along.all(|step| step == first).then_some(first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_needs_voxels_within_the_limit_and_positive_spacings() {
        let grid = |size, spacing| Grid::new(size, spacing).map(|grid| grid.count());
        assert_eq!(grid([512, 512, 512], [1.0; 3]), Ok(MOST_VOXELS));
        assert_eq!(grid([513, 512, 512], [1.0; 3]), Err(GridError::Limit { size: [513, 512, 512] }));
        let huge = [usize::MAX, 2, 1];
        assert_eq!(grid(huge, [1.0; 3]), Err(GridError::Limit { size: huge }));
        assert_eq!(grid([4, 0, 1], [1.0; 3]), Err(GridError::Empty { size: [4, 0, 1] }));
        assert_eq!(grid([4, 4, 1], [1.0, 0.0, 1.0]), Err(GridError::Spacing { axis: 1, value: 0.0 }));
        let error = Grid::new([1; 3], [1.0, 1.0, f64::NAN]).unwrap_err();
        assert_eq!(error.to_string(), "spacing[2] is NaN; expected a finite number above 0");
    }

    #[test]
    fn an_axis_of_one_voxel_has_no_say_in_the_common_spacing() {
        let common = |size, spacing| Grid::new(size, spacing).unwrap().common_spacing();
        assert_eq!(common([4, 4, 1], [0.5, 0.5, 3.0]), Some(0.5));
        assert_eq!(common([4, 4, 2], [0.5, 0.5, 3.0]), None);
        assert_eq!(common([1, 1, 1], [2.0, 3.0, 4.0]), Some(2.0));
    }
}
