//! Exact Euclidean distance transforms: how far the centre of each voxel is from the centre of the nearest voxel of a feature
//! (Liu and others 2003, Eq. 1, whose second and third step are to read (j - y)^2 and (k - z)^2).
//!
//! [`DistanceJob`] takes the method that suits: lower envelopes ([`Envelope`]), whose time is linear in the number of voxels whatever the shape, or, where
//! only distances up to a short limit matter, windows ([`Window`]). [`scan`] is the method of the paper, for comparison.
//! [`signed`] has distances inside the feature as negative ones.

mod envelope;
mod job;
mod lines;
mod scan;
mod seed;
mod signed;
mod trace;
mod window;

pub use envelope::Envelope;
pub use job::{DistanceJob, TransformError, distances};
pub use scan::{Scan, Search, scan};
pub use seed::{Near, Seed};
pub use signed::signed;
pub use trace::{ColumnTrace, MOST_TRACED, Trace, trace};
pub use window::{LONGEST_WINDOW, Window};

#[cfg(test)]
mod test_grids;
