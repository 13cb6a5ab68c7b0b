//! Plane geometry: bounds, exact predicates, polygons, small solvers.

mod bounds;

pub use bounds::Bounds;
