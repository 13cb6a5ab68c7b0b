//! The boundary of a body with the condition of each element.

use super::diagnostic::BoundaryDiagnostic;
use super::exact::Exact;
use super::schema::LaplaceDocument;
use crate::laplace::Space;
use glam::DVec3;

/// What a document of a boundary value problem makes.
#[derive(Debug, Clone)]
pub struct BoundaryProblem {
    /// The document.
    pub document: LaplaceDocument,
    /// Whether it lies in the plane or in space.
    pub space: Space,
    /// Where the vertices are; z is 0 in the plane.
    pub vertices: Vec<DVec3>,
    /// The vertices of each element, the second of a segment twice.
    pub elements: Vec<[u32; 3]>,
    /// For each element the index of its condition; the number of conditions where it has none.
    pub groups: Vec<u32>,
    /// Conditions that elements share. An expression makes one for each element that has its own numbers.
    pub conditions: Vec<SharedCondition>,
    /// For each element the index of its set; the number of sets where it is in none.
    pub members: Vec<u32>,
    /// The groups of the document, and one more for `rest` where it is there.
    pub sets: Vec<SetRow>,
    /// The solution where it is known.
    pub exact: Option<Exact>,
    /// What keeps it from being solved, and remarks.
    pub diagnostics: Vec<BoundaryDiagnostic>,
}

impl BoundaryProblem {
    /// Whether it can be solved.
    #[must_use]
    pub fn is_ready(&self) -> bool {
        self.diagnostics.iter().all(|diagnostic| diagnostic.is_remark)
    }
}

/// A condition of one or more elements.
#[derive(Debug, Clone, PartialEq)]
pub struct SharedCondition {
    /// Index of its set.
    pub set: usize,
    /// Whether values are known; else outward fluxes are.
    pub is_value: bool,
    /// For each material a number.
    pub data: Vec<f64>,
    /// Length or area of its elements.
    pub measure: f64,
}

/// What a set of elements amounts to.
#[derive(Debug, Clone, PartialEq)]
pub struct SetRow {
    /// Its name.
    pub name: String,
    /// Whether values are known; else outward fluxes are.
    pub is_value: bool,
    /// Number of its elements.
    pub count: usize,
    /// Length or area of them.
    pub measure: f64,
}
