//! Plane geometry: bounds, exact predicates, polygons, quadrature, searches over segments, banded systems.

mod band;
mod bounds;
mod deepest_point;
mod order;
mod orient;
mod polygon;
mod quadrature;
mod segment_grid;
mod shown;

pub use band::BandMatrix;
pub use bounds::Bounds;
pub use deepest_point::deepest_point;
pub use order::{order_by_number, order_by_pair};
pub use orient::{orient2d, segment_crossing, segments_meet};
pub use polygon::{Location, first_contact, first_self_contact, locate, signed_area};
pub use quadrature::{GAUSS_16, GaussLegendre};
pub use segment_grid::SegmentGrid;
pub use shown::{Full, Shown, ShownPlace};
