//! Boundaries of bodies: segments in the plane, triangles in space.

use super::error::{Fault, LaplaceError};
use super::panel::{Panel, Space};
use glam::{DVec2, DVec3};
use std::collections::HashMap;

/// Most elements of a boundary.
pub const MOST_ELEMENTS: usize = 32_000;

/// Least size of an element, over that of the whole boundary, and least area of a triangle, over the square of its longest side.
const SMALLEST: f64 = 1e-11;

/// Longest coordinate; beyond, areas leave what numbers can hold.
const LARGEST: f64 = 1e100;

/// A boundary whose elements have a size each. Vertices with equal coordinates are one.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    space: Space,
    vertices: Vec<DVec3>,
    elements: Vec<[u32; 3]>,
}

/// How coordinates are moved and scaled for computing: the box is centred, with the diagonal 1 in space and 0.4 in the plane, where logarithms fail for
/// boundaries of logarithmic capacity 1 (degenerate scale), which is at most half of the diagonal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scaling {
    centre: DVec3,
    scale: f64,
}

impl Scaling {
    /// From the coordinates of the boundary to those of computing.
    #[must_use]
    pub fn inwards(&self, point: DVec3) -> DVec3 {
        (point - self.centre) * self.scale
    }

    /// From the coordinates of computing to those of the boundary.
    #[must_use]
    pub fn outwards(&self, point: DVec3) -> DVec3 {
        point / self.scale + self.centre
    }

    /// Lengths of computing over lengths of the boundary.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.scale
    }
}

impl Mesh {
    /// A boundary in the plane: segments with the material on their left, so that outer boundaries run counter-clockwise and holes clockwise.
    ///
    /// # Errors
    /// When a vertex is not finite, an element names one that is not there or has no length, or there are fewer than 3 or more than [`MOST_ELEMENTS`].
    pub fn plane(vertices: &[DVec2], segments: &[[u32; 2]]) -> Result<Self, LaplaceError> {
        let vertices = vertices.iter().map(|vertex| vertex.extend(0.0)).collect();
        Self::new(Space::Plane, vertices, segments.iter().map(|[a, b]| [*a, *b, *b]).collect())
    }

    /// A boundary in space: triangles that run counter-clockwise as seen from outside the material.
    ///
    /// # Errors
    /// When a vertex is not finite, an element names one that is not there or has no area, or there are fewer than 4 or more than [`MOST_ELEMENTS`].
    pub fn solid(vertices: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, LaplaceError> {
        Self::new(Space::Solid, vertices, triangles)
    }

    fn new(space: Space, vertices: Vec<DVec3>, mut elements: Vec<[u32; 3]>) -> Result<Self, LaplaceError> {
        let wrong = vertices.iter().position(|v| !(v.is_finite() && v.abs().max_element() <= LARGEST));
        if let Some(wrong) = wrong {
            let [x, y, z] = vertices[wrong].to_array();
            let message =
                format!("({x:e}, {y:e}, {z:e}) was found; expected finite coordinates up to {LARGEST:e}");
            return Err(LaplaceError::new(Fault::Vertices, message).of(wrong));
        }
        let least = if space == Space::Plane { 3 } else { 4 };
        if elements.len() < least {
            let message = format!("{} elements were found; expected {least} or more", elements.len());
            return Err(LaplaceError::new(Fault::Elements, message));
        }
        if elements.len() > MOST_ELEMENTS {
            let message = format!("{} elements were found; expected {MOST_ELEMENTS} at most", elements.len());
            return Err(LaplaceError::new(Fault::Limit, message));
        }
        let one = welded(&vertices);
        for (number, element) in elements.iter_mut().enumerate() {
            for vertex in element {
                let Some(first) = one.get(*vertex as usize) else {
                    let last = vertices.len().saturating_sub(1);
                    let message =
                        format!("vertex {vertex} was found; expected the index of one, 0 to {last}");
                    return Err(LaplaceError::new(Fault::Elements, message).of(number));
                };
                *vertex = *first;
            }
        }
        let mesh = Self { space, vertices, elements };
        let (low, high) = mesh.bounds();
        let whole = (high - low).length();
        for number in 0..mesh.elements.len() {
            let panel = space.panel(mesh.corners(number));
            let least = match space {
                Space::Plane => SMALLEST * whole,
                Space::Solid => SMALLEST * panel.diameter * panel.diameter,
            };
            if !(panel.size > least && panel.diameter > SMALLEST * whole) {
                let what = if space == Space::Plane { "length" } else { "area" };
                let message =
                    format!("the element has the {what} {:e}; expected more than {least:e}", panel.size);
                let [a, b, c] = mesh.corners(number);
                return Err(LaplaceError::new(Fault::Degenerate, message).of(number).at((a + b + c) / 3.0));
            }
        }
        Ok(mesh)
    }

    /// Whether it lies in the plane or in space.
    #[must_use]
    pub fn space(&self) -> Space {
        self.space
    }

    /// The vertices as they were given.
    #[must_use]
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// The vertices of each element; of those with equal coordinates the first one, and the second of a segment twice.
    #[must_use]
    pub fn elements(&self) -> &[[u32; 3]] {
        &self.elements
    }

    /// Where the vertices of an element are.
    #[must_use]
    pub fn corners(&self, element: usize) -> [DVec3; 3] {
        self.elements[element].map(|vertex| self.vertices[vertex as usize])
    }

    /// The elements as panels.
    #[must_use]
    pub fn panels(&self) -> Vec<Panel> {
        (0..self.elements.len()).map(|element| self.space.panel(self.corners(element))).collect()
    }

    /// The corners of the box of all elements.
    #[must_use]
    pub fn bounds(&self) -> (DVec3, DVec3) {
        let corners = || self.elements.iter().flatten().map(|vertex| self.vertices[*vertex as usize]);
        (corners().fold(DVec3::INFINITY, DVec3::min), corners().fold(DVec3::NEG_INFINITY, DVec3::max))
    }

    /// The coordinates of computing.
    #[must_use]
    pub fn scaling(&self) -> Scaling {
        let (low, high) = self.bounds();
        let diagonal = if self.space == Space::Plane { 0.4 } else { 1.0 };
        Scaling { centre: (low + high) / 2.0, scale: diagonal / (high - low).length() }
    }
}

/// For each vertex the first one with its coordinates.
fn welded(vertices: &[DVec3]) -> Vec<u32> {
    let mut first = HashMap::with_capacity(vertices.len());
    // Adding 0 makes one of the two zeros.
    let key = |vertex: &DVec3| vertex.to_array().map(|x| (x + 0.0).to_bits());
    vertices.iter().zip(0..).map(|(vertex, number)| *first.entry(key(vertex)).or_insert(number)).collect()
}
