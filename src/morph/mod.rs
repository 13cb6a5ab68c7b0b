//! What a matching carries: the ruled band between the curves, in-between curves, unit cells, amounts of the materials, lines of equal composition.

#[cfg(feature = "amounts")]
mod amounts;
mod band;
mod cell;
#[cfg(feature = "paths")]
mod cuts;
#[cfg(feature = "harmonic")]
mod harmonic;
mod iso;
mod locate;
#[cfg(feature = "paths")]
mod paths;
#[cfg(feature = "stack")]
mod stack;

#[cfg(feature = "amounts")]
pub use amounts::{Amounts, amounts, cell_amounts};
pub use band::{Band, Ruling};
pub use cell::{UnitCell, unit_cells};
#[cfg(feature = "harmonic")]
pub use harmonic::{
    Compose, Field, Fineness as HarmonicFineness, GradientLine, HarmonicBlend, HarmonicPlace, HarmonicWork,
    Ring, Rings, crossings,
};
pub use iso::IsoLine;
pub use locate::Place;
#[cfg(feature = "paths")]
pub use paths::{PathError, PathPair, SMALLEST_TOLERANCE, path_pair};
#[cfg(feature = "stack")]
pub use stack::{Overlap, Refined, Row, StackBlend, StackPlace, Strip, Thread, Weave, threads};
