//! What a matching carries: the ruled band between the curves, in-between curves, unit cells, lines of equal composition.

mod band;
mod cell;
mod iso;
mod locate;

pub use band::{Band, Ruling};
pub use cell::{UnitCell, unit_cells};
pub use iso::IsoLine;
pub use locate::Place;
