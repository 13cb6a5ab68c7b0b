//! The checks of cells that were added to a body.

use crate::hyperpatch::composite::{Body, CellId, FaceContinuity, Match, Relation, Sharing};
use crate::hyperpatch::validity::{Report, Verdict};

/// What is to be known of cells that were added: whether each is sound, whether they meet the others only in what they share, and how they
/// continue these (section 5 of the paper).
#[derive(Debug, Clone)]
pub struct Checks {
    /// The cells that the operation made and that are still there.
    pub cells: Vec<CellId>,
    /// Reports on those that are not proven to be injective, or are mirrored.
    pub doubtful: Vec<(CellId, Report)>,
    /// Pairs with one of the cells that overlap, touch besides what they share, or of which nothing was proven.
    pub meetings: Vec<([CellId; 2], Relation)>,
    /// Faces that one of the cells shares.
    pub faces: usize,
    /// Corners of these faces.
    pub corners: usize,
    /// Corners of these faces at which the shape runs on.
    pub smooth_shape: usize,
    /// Corners of these faces at which the material runs on.
    pub smooth_material: usize,
}

impl Checks {
    /// Collects what is known of some cells, of those that the body has.
    #[must_use]
    pub fn new(
        body: &Body,
        sharing: &Sharing,
        made: &[CellId],
        reports: &[(CellId, Report)],
        relations: &[([CellId; 2], Relation)],
    ) -> Self {
        let cells: Vec<CellId> = made.iter().copied().filter(|id| body.cell(*id).is_some()).collect();
        let is_made = |id: &CellId| cells.binary_search(id).is_ok();
        let is_doubtful = |report: &Report| {
            report.is_mirrored || !matches!(report.verdict, Verdict::Regular | Verdict::Valid)
        };
        let meets = |(pair, relation): &&([CellId; 2], Relation)| {
            pair.iter().any(is_made) && !matches!(relation, Relation::Disjoint | Relation::Shares { .. })
        };
        let is_here = |found: &FaceContinuity| found.face.sides.iter().any(|(id, _)| is_made(id));
        let faces: Vec<FaceContinuity> = sharing.continuity(body).into_iter().filter(is_here).collect();
        let corners = || faces.iter().flat_map(|face| face.corners);
        Self {
            doubtful: reports
                .iter()
                .filter(|(id, report)| is_made(id) && is_doubtful(report))
                .copied()
                .collect(),
            meetings: relations.iter().filter(meets).cloned().collect(),
            faces: faces.len(),
            corners: corners().count(),
            smooth_shape: corners().filter(|corner| corner.shape == Match::C1).count(),
            smooth_material: corners().filter(|corner| corner.material == Match::C1).count(),
            cells,
        }
    }
}
