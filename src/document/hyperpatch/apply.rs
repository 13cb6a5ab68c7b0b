//! What operations do, by the kernel.

use super::action::Action;
use super::material::MixTarget;
use super::names::CELLS_EACH;
use crate::hyperpatch::composite::{Body, BodyError, CellId, MOST_CELLS};
use crate::hyperpatch::flat;
use crate::hyperpatch::operation::{self, Change, Extrusion, OperationError};
use glam::DVec3;

/// Carries out an operation. Cells that it makes get numbers from ten thousand times its own on.
///
/// # Errors
/// Why it does not apply; the body is as before then.
pub(super) fn apply(body: &mut Body, id: u32, action: &Action) -> Result<Change, OperationError> {
    let first = CellId(id * CELLS_EACH);
    match action {
        Action::Cells { cells } => {
            if body.cells().len() + cells.len() > MOST_CELLS {
                return Err(BodyError::Full.into());
            }
            let mut made = Vec::with_capacity(cells.len());
            for (id, cell) in (first.0..).map(CellId).zip(cells) {
                body.add_as(id, cell.0.clone())?;
                made.push(id);
            }
            Ok(Change { made, ..Change::default() })
        }
        Action::Move { cell, at: [i, j, k], by, reach } => {
            operation::move_coefficient(body, *cell, flat(*i, *j, *k), DVec3::from_array(*by), *reach)
        }
        Action::Mix { mix, target } => match target {
            MixTarget::Cells { cells } => operation::mix_cells(body, cells, mix),
            MixTarget::Corner { cell, corner, within } => {
                operation::mix_corner(body, *cell, *corner, mix, within.as_deref())
            }
            MixTarget::Coefficient { cell, at: [i, j, k] } => {
                operation::mix_coefficient(body, *cell, flat(*i, *j, *k), mix)
            }
        },
        Action::Delete { cells } => operation::delete(body, cells),
        Action::Copy { cells, by } => operation::copy(body, cells, DVec3::from_array(*by), first),
        Action::Mirror { cells, normal, offset, keep } => {
            let normal = DVec3::from_array(*normal);
            operation::mirror(body, cells, normal, offset / normal.length(), *keep, first)
        }
        Action::Reorient { cells } => operation::reorient(body, cells),
        Action::Subdivide { cell, axis, at } => operation::subdivide(body, *cell, *axis, *at, first),
        Action::Continuity { cell, face, corner, shape, material } => {
            operation::set_continuity(body, *cell, *face, *corner, *shape, *material)
        }
        Action::Slope { cell, corner, rule } => operation::slope(body, *cell, *corner, *rule),
        Action::Extrude { faces, by, start, normals, mix } => {
            let faces = faces.iter().map(|side| (side.cell, side.face)).collect();
            let (by, start, normals, mix) = (*by, *start, *normals, mix.clone());
            operation::extrude(body, &Extrusion { faces, by, start, normals, mix }, first)
        }
    }
}
