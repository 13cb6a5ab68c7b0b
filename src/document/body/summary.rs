//! What is to be said about a body as a whole.

use crate::hyperpatch::composite::{Body, CellId, Relation, Sharing};
use crate::hyperpatch::validity::{Report, Verdict};

/// What a status line says about a body.
#[derive(Debug, Clone)]
pub struct Summary {
    /// Number of cells.
    pub cells: usize,
    /// Number of cells with each verdict, from `Regular` to `Invalid`.
    pub verdicts: [usize; 5],
    /// Number of mirrored cells.
    pub mirrored: usize,
    /// The cell with the worst verdict and, of those, with the least margin.
    pub worst: Option<(CellId, Report)>,
    /// Pairs of cells that overlap, touch besides what they share, or of which nothing was proven.
    pub doubtful: Vec<([CellId; 2], Relation)>,
    /// Number of faces that two cells share.
    pub shared_faces: usize,
    /// Number of faces with which the body ends.
    pub outer_faces: usize,
    /// Largest difference between 1 and the sum of the fractions of a coefficient. No point of the body has a larger one, because
    /// its fractions are means of those.
    pub sum_error: f64,
}

impl Summary {
    /// Collects what is known.
    #[must_use]
    pub fn new(
        body: &Body,
        sharing: &Sharing,
        reports: &[(CellId, Report)],
        relations: &[([CellId; 2], Relation)],
    ) -> Self {
        let mut verdicts = [0; 5];
        for (_, report) in reports {
            verdicts[rank(report.verdict)] += 1;
        }
        let worse = |a: &&(CellId, Report), b: &&(CellId, Report)| {
            rank(a.1.verdict)
                .cmp(&rank(b.1.verdict))
                .then(b.1.margin.total_cmp(&a.1.margin))
                .then(b.0.cmp(&a.0))
        };
        let is_doubtful = |(_, relation): &&([CellId; 2], Relation)| {
            !matches!(relation, Relation::Disjoint | Relation::Shares { .. })
        };
        let sum_error = |at: usize, fractions: &[[f64; 64]]| {
            (fractions.iter().map(|list| list[at]).sum::<f64>() - 1.0).abs()
        };
        let errors =
            body.cells().iter().flat_map(|(_, cell)| (0..64).map(|at| sum_error(at, cell.fractions())));
        Self {
            cells: reports.len(),
            verdicts,
            mirrored: reports.iter().filter(|(_, report)| report.is_mirrored).count(),
            worst: reports.iter().max_by(worse).copied(),
            doubtful: relations.iter().filter(is_doubtful).cloned().collect(),
            shared_faces: sharing.shared_faces().len(),
            outer_faces: sharing.outer_faces().len(),
            sum_error: errors.fold(0.0, f64::max),
        }
    }
}

/// Place of a verdict from best to worst.
fn rank(verdict: Verdict) -> usize {
    verdict as usize
}
