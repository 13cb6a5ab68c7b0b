//! Why there is no solution.

use glam::DVec3;
use std::error::Error;
use std::fmt;

/// The kind of a fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    /// A vertex is not finite, or there are none.
    Vertices,
    /// An element names a vertex that is not there, or there are too few elements.
    Elements,
    /// An element has no length or no area.
    Degenerate,
    /// The boundary has a gap.
    Open,
    /// Normals do not point out of the material.
    Inverted,
    /// The boundary encloses several bodies, or a cavity that lies in no body.
    Apart,
    /// The boundary meets itself.
    Meeting,
    /// A condition is not finite, too large or no fraction, or there is another number of them than of elements.
    Conditions,
    /// Fluxes alone are given, and they do not sum to nothing.
    Imbalance,
    /// Fractions do not sum to one.
    Sum,
    /// A stated limit of size is passed.
    Limit,
    /// The method cannot be used for this size, or an option of it is out of range.
    Method,
    /// A point is not finite, or there are too many.
    Points,
    /// A section has no pixels, or too many.
    Section,
    /// The sides of a section span no plane, or leave that of the problem.
    Sides,
    /// A point lies outside.
    Outside,
}

/// A fault with the element or the point that it concerns and the place.
#[derive(Debug, Clone, PartialEq)]
pub struct LaplaceError {
    /// Kind of the fault.
    pub fault: Fault,
    /// Index of the vertex, the element, the condition or the point that it concerns.
    pub index: Option<usize>,
    /// Where that is, in the coordinates of the boundary; z is 0 in the plane.
    pub at: Option<DVec3>,
    /// What was found and what was expected.
    pub message: String,
}

impl LaplaceError {
    /// A fault without index and place.
    #[must_use]
    pub fn new(fault: Fault, message: impl Into<String>) -> Self {
        Self { fault, index: None, at: None, message: message.into() }
    }

    /// The same fault of a vertex, an element, a condition or a point.
    #[must_use]
    pub fn of(self, index: usize) -> Self {
        Self { index: Some(index), ..self }
    }

    /// The same fault with a place.
    #[must_use]
    pub fn at(self, place: DVec3) -> Self {
        Self { at: Some(place), ..self }
    }
}

impl fmt::Display for LaplaceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl Error for LaplaceError {}
