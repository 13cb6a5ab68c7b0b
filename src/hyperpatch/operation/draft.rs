//! Edited cells before they are put into the body, so that an edit is whole or not at all.

use super::{Change, OperationError};
use crate::hyperpatch::Cell;
use crate::hyperpatch::composite::{Body, BodyError, CellId, MOST_CELLS, Mark, Match, Side};
use crate::material::Composition;
use glam::DVec3;
use std::collections::BTreeMap;

/// Rounding that is allowed where continuity is marked, over the size of the body.
const EXACT: f64 = 1e-12;

/// Copies of the cells that an edit changes.
#[derive(Debug, Default)]
pub(super) struct Draft {
    cells: BTreeMap<CellId, Cell>,
}

impl Draft {
    /// The cell to be changed.
    fn cell(&mut self, body: &Body, id: CellId) -> Result<&mut Cell, OperationError> {
        let original = body.cell(id).ok_or(BodyError::Unknown { id })?;
        Ok(self.cells.entry(id).or_insert_with(|| original.clone()))
    }

    /// Moves a coefficient to a position.
    pub(super) fn place(
        &mut self,
        body: &Body,
        id: CellId,
        at: usize,
        position: DVec3,
    ) -> Result<(), OperationError> {
        self.cell(body, id)?.net_mut().0[at] = position;
        Ok(())
    }

    /// Gives a coefficient a composition, as fractions in the simplex.
    pub(super) fn fill(
        &mut self,
        body: &Body,
        id: CellId,
        at: usize,
        mix: &[f64],
    ) -> Result<(), OperationError> {
        let fractions = self.cell(body, id)?.fractions_mut();
        fractions.iter_mut().zip(mix).for_each(|(list, fraction)| list[at] = *fraction);
        Ok(())
    }

    /// Puts the cells into the body, and drops marks that do not hold any more.
    ///
    /// # Errors
    /// When a coordinate has become too large; the body is left as it was.
    pub(super) fn commit(self, body: &mut Body) -> Result<Change, OperationError> {
        for (id, cell) in &self.cells {
            cell.check().map_err(|error| OperationError::Cell { id: *id, error })?;
        }
        let touched: Vec<CellId> = self.cells.keys().copied().collect();
        for (id, cell) in self.cells {
            body.replace(id, cell)?;
        }
        settle(body, &touched);
        Ok(Change { touched, ..Change::default() })
    }
}

/// Drops the marks at cells that their coefficients do not hold, so that what is marked is always true. Sides that were
/// let go stay so.
pub(super) fn settle(body: &mut Body, cells: &[CellId]) {
    let mut dropped = Vec::new();
    let tolerance = exact(body);
    for id in cells {
        for (side, mark) in body.marks().at_cell(*id) {
            let Some((shape, material)) = holds(body, side, &mark, tolerance) else { continue };
            let (shape, material) =
                (mark.shape.filter(|m| *m <= shape), mark.material.filter(|m| *m <= material));
            let kept = Mark { shape, material, ..mark };
            if kept != mark {
                dropped.push((side, kept));
            }
        }
    }
    dropped.into_iter().for_each(|(side, mark)| body.mark(side, mark));
}

/// Rounding that is allowed where continuity is marked: that of the body or of its coordinates, whichever is larger.
pub(super) fn exact(body: &Body) -> f64 {
    let (lo, hi) = body.bounds();
    EXACT * body.size().max(lo.abs().max(hi.abs()).max_element())
}

/// What shape and material hold between a side and the other side of a mark, within a distance.
pub(super) fn holds(body: &Body, side: Side, mark: &Mark, tolerance: f64) -> Option<(Match, Match)> {
    let (first, second) = (body.cell(side.cell)?, body.cell(mark.other.cell)?);
    let (mut shape, mut material) = (Match::C1, Match::C1);
    for (a, b) in side.block().into_iter().zip(mark.other_block()) {
        let (c, d) = (side.inside(a), mark.other.inside(b));
        let (p, q) = (&first.net().0, &second.net().0);
        shape = shape.min(found((p[a] - q[b]).length(), ((p[a] - p[c]) - (q[d] - q[b])).length(), tolerance));
        for (p, q) in first.fractions().iter().zip(second.fractions()) {
            let bend = (p[a] - p[c]) - (q[d] - q[b]);
            material = material.min(found((p[a] - q[b]).abs(), bend.abs(), EXACT));
        }
    }
    Some((shape, material))
}

fn found(jump: f64, bend: f64, tolerance: f64) -> Match {
    match (jump <= tolerance, bend <= tolerance) {
        (false, _) => Match::None,
        (true, false) => Match::Block,
        (true, true) => Match::C1,
    }
}

/// Adds new cells under the identifiers from one on.
///
/// # Errors
/// When the body would be too full, or one of the identifiers is taken; none is added then.
pub(super) fn insert(
    body: &mut Body,
    first: CellId,
    cells: Vec<Cell>,
) -> Result<Vec<CellId>, OperationError> {
    let ids = identifiers(body, first, cells.len(), 0)?;
    for (id, cell) in ids.iter().zip(cells) {
        body.add_as(*id, cell)?;
    }
    Ok(ids)
}

/// The identifiers from one on, if the body has room for so many cells after others are taken out.
///
/// # Errors
/// When the body would be too full, or one of the identifiers is taken.
pub(super) fn identifiers(
    body: &Body,
    first: CellId,
    count: usize,
    freed: usize,
) -> Result<Vec<CellId>, OperationError> {
    if body.cells().len() + count > MOST_CELLS + freed {
        return Err(BodyError::Full.into());
    }
    let ids: Vec<CellId> = (0..count as u32).map(|n| CellId(first.0.saturating_add(n))).collect();
    match ids.iter().find(|id| body.cell(**id).is_some()) {
        Some(&id) => Err(BodyError::Taken { id }.into()),
        None => Ok(ids),
    }
}

/// Refuses a composition of another number of materials than the body has.
pub(super) fn check_mix(body: &Body, mix: &Composition) -> Result<(), OperationError> {
    let (count, expected) = (mix.fractions().len(), body.materials());
    if count == expected { Ok(()) } else { Err(OperationError::Materials { count, expected }) }
}

/// The cells of identifiers, ascending and each once.
///
/// # Errors
/// When there is none, or one is unknown.
pub(super) fn chosen(body: &Body, cells: &[CellId]) -> Result<Vec<CellId>, OperationError> {
    let mut cells = cells.to_vec();
    cells.sort_unstable();
    cells.dedup();
    if cells.is_empty() {
        return Err(OperationError::NoCells);
    }
    match cells.iter().find(|id| body.cell(**id).is_none()) {
        Some(&id) => Err(BodyError::Unknown { id }.into()),
        None => Ok(cells),
    }
}
