//! Cells and their parts, as documents name them.

use super::super::node::Node;
use super::super::{Code, DocumentError};
use crate::hyperpatch::composite::{CellId, MOST_CELLS, Match};
use crate::hyperpatch::operation::{Normals, Reach, Slope, Start};
use crate::hyperpatch::{Axis, Corner, Face};
use serde::Serializer;
use serde::ser::SerializeSeq;
use std::collections::HashSet;

/// Largest number of an operation.
pub(super) const LARGEST_ID: usize = 9_999;

/// Numbers of cells that are set apart for each operation.
pub(super) const CELLS_EACH: u32 = 10_000;

/// Faces as they are written, in the order of [`Face::all`].
const FACES: [&str; 6] = ["u0", "u1", "v0", "v1", "w0", "w1"];

/// The identifier of a cell, whether or not there is such a cell.
pub(in crate::document) fn cell(node: &Node<'_>) -> Result<CellId, DocumentError> {
    let most = LARGEST_ID * CELLS_EACH as usize + CELLS_EACH as usize - 1;
    let number = node.count()?;
    u32::try_from(number).ok().filter(|id| *id as usize <= most).map(CellId).ok_or_else(|| {
        node.error(Code::Range, format!("{number} was found; expected the number of a cell, 0 to {most}"))
    })
}

/// One or more cells, each once.
pub(super) fn cells(node: &Node<'_>) -> Result<Vec<CellId>, DocumentError> {
    let items = node.items()?;
    node.check_count(items.len(), " cells", 1..=MOST_CELLS)?;
    let (mut list, mut seen) = (Vec::with_capacity(items.len()), HashSet::new());
    for item in &items {
        let id = cell(item)?;
        if !seen.insert(id) {
            return Err(item.error(Code::Range, format!("{id} was found twice; expected each cell once")));
        }
        list.push(id);
    }
    Ok(list)
}

/// A face by its name.
pub(in crate::document) fn face(node: &Node<'_>) -> Result<Face, DocumentError> {
    node.choice(&FACES).map(|n| Face::all()[n])
}

/// An axis by its name.
pub(super) fn axis(node: &Node<'_>) -> Result<Axis, DocumentError> {
    node.choice(&["u", "v", "w"]).map(|n| Axis::ALL[n])
}

/// A corner by its three ends.
pub(in crate::document) fn corner(node: &Node<'_>) -> Result<Corner, DocumentError> {
    three(node, 1).map(|ends| Corner(ends.map(|end| end == 1)))
}

/// A coefficient by its three indices.
pub(in crate::document) fn coefficient(node: &Node<'_>) -> Result<[usize; 3], DocumentError> {
    three(node, 3)
}

/// How far a move reaches, by its name.
pub(in crate::document) fn reach(node: &Node<'_>) -> Result<Reach, DocumentError> {
    Ok(if node.choice(&["block", "single"])? == 0 { Reach::Block } else { Reach::Single })
}

/// Three whole numbers up to `most`.
fn three(node: &Node<'_>, most: usize) -> Result<[usize; 3], DocumentError> {
    let items = node.items()?;
    node.check_count(items.len(), " numbers", 3..=3)?;
    let mut found = [0; 3];
    for (place, item) in found.iter_mut().zip(&items) {
        let number = item.count()?;
        if number > most {
            return Err(item.error(
                Code::Range,
                format!("{number} was found; expected a whole number from 0 to {most}"),
            ));
        }
        *place = number;
    }
    Ok(found)
}

pub(super) fn write_cell<S: Serializer>(cell: &CellId, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_u32(cell.0)
}

pub(super) fn write_cells<S: Serializer>(cells: &[CellId], to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(cells.iter().map(|cell| cell.0))
}

pub(super) fn write_face<S: Serializer>(face: &Face, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(FACES[2 * face.axis as usize + usize::from(face.is_end)])
}

pub(super) fn write_axis<S: Serializer>(axis: &Axis, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(["u", "v", "w"][*axis as usize])
}

pub(super) fn write_corner<S: Serializer>(corner: &Corner, to: S) -> Result<S::Ok, S::Error> {
    let mut list = to.serialize_seq(Some(3))?;
    for is_end in corner.0 {
        list.serialize_element(&u8::from(is_end))?;
    }
    list.end()
}

pub(super) fn write_reach<S: Serializer>(reach: &Reach, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(if *reach == Reach::Block { "block" } else { "single" })
}

pub(super) fn write_some_match<S: Serializer>(level: &Option<Match>, to: S) -> Result<S::Ok, S::Error> {
    match level {
        Some(level) => to.serialize_str(["none", "C0", "C1"][*level as usize]),
        None => to.serialize_none(),
    }
}

pub(super) fn write_slope<S: Serializer>(rule: &Slope, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(if *rule == Slope::Flat { "flat" } else { "natural" })
}

pub(super) fn write_start<S: Serializer>(start: &Start, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(if *start == Start::C1 { "C1" } else { "free" })
}

pub(super) fn write_normals<S: Serializer>(normals: &Normals, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(if *normals == Normals::Mean { "mean" } else { "surface" })
}

pub(super) fn write_some_corner<S: Serializer>(corner: &Option<Corner>, to: S) -> Result<S::Ok, S::Error> {
    match corner {
        Some(corner) => write_corner(corner, to),
        None => to.serialize_none(),
    }
}
