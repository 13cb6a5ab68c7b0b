//! What a matching carries: the ruled band between the curves, in-between curves, unit cells, compositions.

mod band;
mod cell;
mod locate;

pub use band::{Band, Ruling};
pub use cell::{UnitCell, unit_cells};
pub use locate::Place;
