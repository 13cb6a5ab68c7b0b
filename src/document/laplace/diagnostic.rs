//! What is to be said about a boundary value problem that could be read.

use crate::laplace::{Fault, LaplaceError};
use glam::DVec3;

/// Something that keeps a problem from being solved, or a remark.
///
/// | code | meaning |
/// |---|---|
/// | `degenerate` | an element without length or area |
/// | `open` | the boundary has a gap |
/// | `inverted` | normals do not point out of the material |
/// | `apart` | several bodies, or a cavity that lies in none |
/// | `meeting` | the boundary meets itself |
/// | `missing` | elements without a condition |
/// | `conflict` | elements in two groups whose conditions differ |
/// | `expression` | a text that is no expression |
/// | `value` | an expression whose values are no fractions, or not finite |
/// | `sum` | fractions that do not sum to 1, or fluxes that do not sum to 0 |
/// | `imbalance` | fluxes alone, which do not sum to nothing |
/// | `method` | a method that cannot be used for so many elements |
/// | `elements` | remark: a run of elements that ends beyond the last one |
/// | `empty` | remark: a group without elements |
#[derive(Debug, Clone, PartialEq)]
pub struct BoundaryDiagnostic {
    /// What kind it is.
    pub code: &'static str,
    /// Whether the problem can be solved all the same.
    pub is_remark: bool,
    /// Path of the field of the document that it concerns; empty where it is the boundary.
    pub path: String,
    /// What was found and what was expected.
    pub message: String,
    /// Index of the first element that it concerns.
    pub element: Option<usize>,
    /// Where that is.
    pub place: Option<DVec3>,
    /// Number of elements that it concerns.
    pub count: Option<usize>,
    /// Of an expression: the character, from 0.
    pub character: Option<usize>,
}

impl BoundaryDiagnostic {
    /// A fault of what stands at a path.
    pub(super) fn new(code: &'static str, path: impl Into<String>, message: impl Into<String>) -> Self {
        Self {
            code,
            is_remark: false,
            path: path.into(),
            message: message.into(),
            element: None,
            place: None,
            count: None,
            character: None,
        }
    }

    /// The same as a remark.
    pub(super) fn remark(self) -> Self {
        Self { is_remark: true, ..self }
    }

    /// The same about so many elements, the first of them at a place.
    pub(super) fn about(self, count: usize, element: usize, place: DVec3) -> Self {
        Self { count: Some(count), element: Some(element), place: Some(place), ..self }
    }

    /// A fault that the solver finds.
    pub(super) fn of(error: LaplaceError) -> Self {
        let (code, path) = match error.fault {
            Fault::Degenerate => ("degenerate", ""),
            Fault::Open => ("open", ""),
            Fault::Inverted => ("inverted", ""),
            Fault::Apart => ("apart", ""),
            Fault::Imbalance => ("imbalance", "groups"),
            Fault::Sum => ("sum", "groups"),
            Fault::Conditions => ("value", "groups"),
            Fault::Method => ("method", "solver"),
            _ => ("meeting", ""),
        };
        Self { element: error.index, place: error.at, ..Self::new(code, path, error.message) }
    }
}
