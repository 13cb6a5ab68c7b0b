//! More than two curves: the matchings of neighbours woven into one blend.
//!
//! Neighbours are matched pair by pair; such a pair is a span. A *thread* follows the matching from curve to curve, so that it has one
//! parameter on every curve, and the threads through all lines of all spans, none of which crosses another, carry shape and composition
//! through the whole stack.

mod blend;
mod cubic;
mod overlap;
mod place;
mod thread;
mod weave;

pub use blend::{Row, StackBlend, Strip};
pub use overlap::Overlap;
pub use place::StackPlace;
pub use thread::{Thread, threads};
pub use weave::{Refined, Weave};
