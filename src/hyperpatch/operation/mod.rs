//! Operations on bodies: edits of shape and material that keep the continuity that is wanted, and ways to add cells.
//!
//! Every operation either does all that it says and tells which cells it touched, made and removed, or leaves the body
//! as it was and says why. Whether the cells are sound afterwards is for [`validity`](super::validity) to say, so that
//! what is wrong can be shown rather than refused.
//!
//! An edit at a corner looks at the box of every cell and at no more of those that are elsewhere, so that it takes some
//! ten microseconds in a body of hundreds of cells, and needs no index that somebody would have to keep.
//!
//! Every coefficient belongs to the block of one corner, and no edit at a corner touches the block of another one
//! (section 3.5 of the paper, Figs. 7 and 8).

mod change;
mod continuity;
mod copy;
mod delete;
mod draft;
mod extrude;
mod material;
mod mix;
mod moving;
mod nearest;
mod neighbourhood;
#[cfg(test)]
mod properties;
mod slope;
mod star;
mod subdivide;
#[cfg(test)]
mod test_bodies;

pub use change::{Change, OperationError};
pub use continuity::set_continuity;
pub use copy::{copy, mirror, reorient};
pub use delete::delete;
pub use extrude::{Extrusion, Normals, Start, extrude};
pub use material::pair;
pub use mix::{mix_cells, mix_coefficient, mix_corner};
pub use moving::{Reach, move_coefficient, moves};
pub use neighbourhood::{JointState, Neighbour, Neighbourhood, neighbourhood};
pub use slope::{Slope, slope};
pub use subdivide::subdivide;
