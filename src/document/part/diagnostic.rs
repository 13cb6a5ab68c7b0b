//! What is to be said about a part document that could be read.

use serde::Serialize;

/// A fault of a shape, a body, a feature or a rule, which is skipped while the rest works, or a remark on one that works.
///
/// | code | meaning |
/// |---|---|
/// | `shape` | a shape that cannot be made, or a reference to one |
/// | `unknown-name` | a name that no shape, or no body, has |
/// | `open` | an outline or a hole that does not close |
/// | `self-intersection` | an outline or a hole that crosses itself |
/// | `empty` | a body without area, or nothing left of a boundary |
/// | `limits` | limits in the wrong order |
/// | `course` | a number, key or value of a course that is out of range |
/// | `expression` | a text that is no expression |
/// | `limit` | a feature beyond those that the printed rule takes; a blend with it, or of a boundary with more corners than elements |
/// | `conflict` | a place of a boundary with two conditions |
/// | `apart` | a blend over a boundary whose parts meet, or from a body that is not there |
/// | `circle` | bodies that take their compositions from each other |
/// | `imbalance` | gradients alone that do not sum to nothing round the boundary |
/// | `unsolved` | a blend whose equations cannot be solved |
/// | `insulated` | remark: a blend of a boundary on which nothing is known |
/// | `clamped` | remark: gradients that ask for more than there is of a material, or less than nothing |
/// | `far` | remark: the band of a feature does not reach its body |
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct PartDiagnostic {
    /// What kind it is.
    pub code: &'static str,
    /// Whether something is skipped.
    pub skipped: bool,
    /// Path of the field.
    pub path: String,
    /// What was found and what was expected.
    pub message: String,
    /// Index of the body.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body: Option<u32>,
    /// Index of the feature in the body.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub feature: Option<u32>,
    /// Index of the piece of the boundary in the blend of the body.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub boundary: Option<u8>,
    /// Of an expression: the character, from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub character: Option<u32>,
    /// A place in the plane.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<[f64; 2]>,
}

impl PartDiagnostic {
    /// A fault of what stands at a path.
    pub(super) fn new(code: &'static str, path: impl Into<String>, message: impl Into<String>) -> Self {
        Self {
            code,
            skipped: true,
            path: path.into(),
            message: message.into(),
            body: None,
            feature: None,
            boundary: None,
            character: None,
            at: None,
        }
    }

    /// The same as a remark.
    pub(super) fn remark(self) -> Self {
        Self { skipped: false, ..self }
    }
}
