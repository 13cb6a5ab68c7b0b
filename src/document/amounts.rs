//! How much of each material is in the band of a document.

use super::Solution;
use crate::morph::{self, Amounts, cell_amounts};

/// What the band of a solution holds.
#[derive(Debug, Clone, PartialEq)]
pub struct BandAmounts {
    /// Between the curves themselves.
    pub exact: Amounts,
    /// Estimated error of the area and of every amount.
    pub error: f64,
    /// In the unit cells.
    pub in_cells: Amounts,
    /// Number of lines from which to the next the band is turned over, at least in part.
    pub folded: usize,
}

/// The amounts of a solution, of curves at different heights those of the projection; `None` unless the matching is complete, or was
/// repaired.
#[must_use]
pub fn amounts(solution: &Solution) -> Option<BandAmounts> {
    let ((curves, _), band) = solution.model.pair().zip(solution.band())?;
    let model = &solution.model;
    let places: Vec<_> = band.lines().map(|ruling| (ruling.u, ruling.v)).collect();
    let keys = [0, 1].map(|curve| model.key_parameters(curve));
    let compose = |curve: usize, u: f64| model.composition(curve, u);
    let (exact, error) = morph::amounts(curves, &places, keys.each_ref().map(Vec::as_slice), compose);
    let (in_cells, folded) = cell_amounts(band);
    Some(BandAmounts { exact, error, in_cells, folded })
}
