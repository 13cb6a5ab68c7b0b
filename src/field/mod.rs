//! Distances to features on grids, and compositions that are functions of them (Liu, Maekawa, Patrikalakis and others 2003, 3.2).
//!
//! Everything is in three dimensions; a grid of one layer is the plane.

mod expression;
mod grid;
mod overlap;
mod printed;
mod profile;
mod rules;
pub mod transform;

pub use expression::{Expression, ExpressionError, LONGEST_EXPRESSION};
pub use grid::{Grid, GridError, MOST_VOXELS};
pub use overlap::{Overlap, Rule};
pub use printed::{MOST_PRINTED, Printed, printed};
pub use profile::{Course, DistanceProfile, ProfileError};
pub use rules::{DesignRule, Quantity};
