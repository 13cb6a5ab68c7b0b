//! What is wrong with a document, and where.

use glam::DVec2;
use std::fmt;

/// The kind of an error, stable across releases.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Code {
    /// The text is not JSON.
    Syntax,
    /// A required field is missing.
    Missing,
    /// A field that the format does not have.
    UnknownField,
    /// A value of the wrong type.
    Type,
    /// A value outside its range.
    Range,
    /// A number that is not finite.
    NonFinite,
    /// A version of the format that this release does not read.
    Version,
    /// A document of a kind that the function does not answer for.
    Kind,
    /// A value of the format that this release does not compute yet.
    NotYet,
    /// A document that only the module `full` computes.
    NotInModule,
    /// A stated limit of size is passed.
    Limit,
    /// Too few control points for the degree, or ends that do not close.
    Points,
    /// A knot vector that does not fit.
    Knots,
    /// A curve without length.
    ZeroLength,
    /// A curve that meets itself.
    SelfIntersection,
    /// Two curves of the same height that meet.
    Contact,
    /// Curves that enclose no solid.
    NoSolid,
}

impl Code {
    /// Every code, in the order of `docs/api.md`.
    pub const ALL: [Self; 17] = [
        Self::Syntax,
        Self::Missing,
        Self::UnknownField,
        Self::Type,
        Self::Range,
        Self::NonFinite,
        Self::Version,
        Self::Kind,
        Self::NotYet,
        Self::NotInModule,
        Self::Limit,
        Self::Points,
        Self::Knots,
        Self::ZeroLength,
        Self::SelfIntersection,
        Self::Contact,
        Self::NoSolid,
    ];

    /// The code as it crosses the boundary.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Syntax => "syntax",
            Self::Missing => "missing",
            Self::UnknownField => "unknown-field",
            Self::Type => "type",
            Self::Range => "range",
            Self::NonFinite => "non-finite",
            Self::Version => "version",
            Self::Kind => "kind",
            Self::NotYet => "not-yet",
            Self::NotInModule => "not-in-module",
            Self::Limit => "limit",
            Self::Points => "points",
            Self::Knots => "knots",
            Self::ZeroLength => "zero-length",
            Self::SelfIntersection => "self-intersection",
            Self::Contact => "contact",
            Self::NoSolid => "no-solid",
        }
    }
}

/// An error in a document: its kind, the path of the field, what was found and expected, and the place if it has one.
#[derive(Debug, Clone, PartialEq)]
pub struct DocumentError {
    /// Kind of the error.
    pub code: Code,
    /// Path of the field, such as `curves[0].points[2][1]`; empty for the whole document.
    pub path: String,
    /// What was found and what was expected, as a sentence without the path.
    pub message: String,
    /// Place in the plane of the document, for geometric errors.
    pub at: Option<DVec2>,
}

impl DocumentError {
    /// An error without a place.
    #[must_use]
    pub fn new(code: Code, path: impl Into<String>, message: impl Into<String>) -> Self {
        Self { code, path: path.into(), message: message.into(), at: None }
    }

    /// The same error with a place.
    #[must_use]
    pub fn with_place(self, at: DVec2) -> Self {
        Self { at: Some(at), ..self }
    }
}

impl fmt::Display for DocumentError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.path.is_empty() {
            f.write_str(&self.message)
        } else {
            write!(f, "{}: {}", self.path, self.message)
        }
    }
}

impl std::error::Error for DocumentError {}
