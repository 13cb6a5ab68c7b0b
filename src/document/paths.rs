//! The matched pair of a document as paths with the same commands.

use super::{Code, DocumentError, Json, Node, Solution};
use crate::morph::{PathError, PathPair, path_pair};

/// Tolerance that is taken where none is given, as a share of the diagonal of the box of both curves: below what a screen shows.
const TOLERANCE: f64 = 1e-4;

/// How paths are wanted; see `docs/api.md`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PathOptions {
    /// Largest distance of either path from its curve; `None`: 1e-4 times the diagonal of the box of both curves.
    pub tolerance: Option<f64>,
}

impl PathOptions {
    /// Reads options; all may be left out.
    ///
    /// # Errors
    /// When a field is unknown or of the wrong type.
    pub fn read(options: &Json) -> Result<Self, DocumentError> {
        let root = Node::root(options, "options");
        root.only(&["tolerance"])?;
        Ok(Self { tolerance: root.get("tolerance")?.map(|node| node.number()).transpose()? })
    }
}

/// The two curves of a solution as paths; `None` unless the matching is complete, or was repaired.
///
/// # Errors
/// When the tolerance is out of range or takes too many commands.
pub fn paths(solution: &Solution, options: &PathOptions) -> Result<Option<PathPair>, DocumentError> {
    let Some(((curves, _), band)) = solution.model.pair().zip(solution.band()) else { return Ok(None) };
    let bounds = curves[0].bounds().union(curves[1].bounds());
    let tolerance = options.tolerance.unwrap_or_else(|| TOLERANCE * (bounds.max - bounds.min).length());
    let places: Vec<_> = band.lines().map(|ruling| (ruling.u, ruling.v)).collect();
    path_pair(curves, &places, tolerance).map(Some).map_err(|error| {
        let code = if matches!(error, PathError::Tolerance { .. }) { Code::Range } else { Code::Limit };
        DocumentError::new(code, "options.tolerance", error.to_string())
    })
}
