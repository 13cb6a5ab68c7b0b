//! Polylines across the rulings.

use crate::material::Composition;
use glam::DVec3;

/// A polyline across all rulings of a surface, closed or open, with the composition at each vertex: what a surface has at one share of the
/// way from curve to curve.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Row {
    /// A vertex on each ruling, in order; a closed one does not repeat the first.
    pub points: Vec<DVec3>,
    /// Composition at each vertex.
    pub compositions: Vec<Composition>,
}
