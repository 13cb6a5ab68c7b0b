//! Indexed triangles with a composition at each vertex.

use glam::DVec3;
use std::ops::Range;

/// What a stretch of triangles belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// The ruled surface.
    Surface,
    /// The cap inside a curve, by the number of the curve among those that are capped: 0 for that of the first row, 1 for that of the last.
    Cap(usize),
}

/// Triangles of one part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Group {
    /// What they belong to.
    pub part: Part,
    /// Their indices.
    pub triangles: Range<usize>,
}

/// A surface in triangles, counter-clockwise as seen from outside.
///
/// # Guarantees
/// - No triangle has the same vertex twice; one may still have no area.
/// - Caps have no vertex of their own: those of their rim are those of the surface.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// Vertices, in the unit of the document, z up.
    pub positions: Vec<DVec3>,
    /// Fractions of the materials, [`materials`](Self::materials) of them for each vertex.
    pub fractions: Vec<f64>,
    /// A number for each vertex, or none at all: the mean over the rulings that meet in it.
    pub scalars: Vec<f64>,
    /// Indices of the vertices of each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// The parts, which cover all triangles in order.
    pub groups: Vec<Group>,
    /// Number of materials.
    pub materials: usize,
}

impl Mesh {
    /// The corners of a triangle.
    #[must_use]
    pub fn corners(&self, triangle: [u32; 3]) -> [DVec3; 3] {
        triangle.map(|vertex| self.positions[vertex as usize])
    }

    /// Fractions at a vertex.
    #[must_use]
    pub fn fractions_at(&self, vertex: usize) -> &[f64] {
        &self.fractions[vertex * self.materials..(vertex + 1) * self.materials]
    }

    /// Corners of the smallest box that holds all vertices; `None` without any.
    #[must_use]
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        let first = *self.positions.first()?;
        let grow = |(low, high): (DVec3, DVec3), point: &DVec3| (low.min(*point), high.max(*point));
        Some(self.positions.iter().fold((first, first), grow))
    }

    /// Turns all triangles over.
    pub(super) fn turn_over(&mut self) {
        self.triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
    }
}

/// The three numbers as they are stored and written: 32 bits each, no negative zero.
pub(super) fn stored(point: DVec3) -> [f32; 3] {
    (point + DVec3::ZERO).as_vec3().to_array().map(|number| number + 0.0)
}
