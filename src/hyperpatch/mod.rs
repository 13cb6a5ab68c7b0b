//! Bodies of heterogeneous tricubic Bezier hyperpatches.
//!
//! After Conde-Rodriguez, Torres-Cantero, Garcia-Fernandez and Feito-Higueruela, *A comprehensive framework for
//! modeling heterogeneous objects* (The Visual Computer, 2017), here called *the paper*. A [`Cell`] is one polynomial
//! of degree 3 along each of three parameters (u, v, w) in [0, 1]; its 64 coefficients are pairs of a position and a
//! composition, so the material belongs to the body and follows it when its shape is edited. [`Net`] is the shape
//! alone.
//!
//! Cells stay tricubic: continuity of second order would take away the freedom to join cells with jumps, and is not
//! offered.

mod bernstein;
mod cell;
pub mod composite;
mod grid;
mod inversion;
mod jacobian;
mod net;
pub mod operation;
mod parts;
mod section;
mod tessellation;
#[cfg(test)]
mod test_cells;
pub mod validity;
mod vtk;

pub use bernstein::{binomial, cubic, cubic_slope, elevate, flat, split};
pub use cell::{Cell, CellError, LARGEST_COORDINATE, MOST_MATERIALS};
pub use grid::{Grid, GridError, LARGEST_GRID};
pub use jacobian::Jacobian;
pub use net::{Differences, Net};
pub use parts::{Axis, Corner, Edge, Face};
pub use section::{Cut, FINEST_SECTION, Plane, Section, SectionError, Sectioning, section};
pub use tessellation::{MOST_SEGMENTS, Patch, Surface, Tessellation, ToleranceError};
pub use vtk::VtkJob;
