//! Bodies of several cells: what they share, how they continue, and whether they overlap.
//!
//! The paper calls the cells of a body disjoint and lets them share corners, edges and faces (section 3.3), which
//! closed cells cannot both be: here their interiors are disjoint. On what they share, a point has the material of
//! the cell with the lowest identifier (section 3.2, whose printed set of internal boundary points is empty; it is
//! taken as the boundaries of cells without the outer one).

mod body;
mod continuity;
mod locate;
mod marks;
mod relation;
mod shared;
mod sharing;
mod tree;
mod verdicts;
mod weld;

pub use body::{Body, BodyError, CellId, MOST_CELLS};
pub use continuity::{Contact, Continuity, CornerContinuity, FaceContinuity, Match};
pub use locate::{Place, Probe};
pub use marks::{Mark, Marks, Side};
pub use relation::{Pairs, Relation, relate};
pub use sharing::{Matching, SharedFace, Sharing};
pub use verdicts::Verdicts;
pub(super) use weld::Weld;
