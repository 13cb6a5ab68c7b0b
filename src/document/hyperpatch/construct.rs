//! Operations that add cells to those that are there, or take some away.

use super::super::node::Node;
use super::super::{Code, DocumentError};
use super::action::Action;
use super::cells::mix;
use super::names::{self, axis, cell, cells, face};
use crate::hyperpatch::composite::{CellId, MOST_CELLS};
use crate::hyperpatch::operation::{Normals, Start};
use crate::hyperpatch::{Face, LARGEST_COORDINATE, Plane};
use glam::DVec3;
use serde::Serialize;
use std::collections::HashSet;

/// A face of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
pub struct FaceSpec {
    /// The cell.
    #[serde(serialize_with = "names::write_cell")]
    pub cell: CellId,
    /// Its face.
    #[serde(serialize_with = "names::write_face")]
    pub face: Face,
}

/// Reads what belongs to `delete`.
pub(super) fn deleted(node: &Node<'_>) -> Result<Action, DocumentError> {
    node.only(&["op", "id", "cells"])?;
    Ok(Action::Delete { cells: cells(&node.need("cells")?)? })
}

/// Reads what belongs to `copy`.
pub(super) fn copied(node: &Node<'_>) -> Result<Action, DocumentError> {
    node.only(&["op", "id", "cells", "by"])?;
    let by = node.need("by")?.triple(-LARGEST_COORDINATE..=LARGEST_COORDINATE)?;
    Ok(Action::Copy { cells: cells(&node.need("cells")?)?, by })
}

/// Reads what belongs to `mirror`.
pub(super) fn mirrored(node: &Node<'_>) -> Result<Action, DocumentError> {
    node.only(&["op", "id", "cells", "normal", "offset", "keep"])?;
    let normal_node = node.need("normal")?;
    let normal = normal_node.triple(-LARGEST_COORDINATE..=LARGEST_COORDINATE)?;
    let offset = node.get("offset")?.map_or(Ok(0.0), |node| node.number())?;
    Plane::new(DVec3::from_array(normal), offset)
        .map_err(|e| normal_node.error(Code::Range, e.to_string()))?;
    let keep = node.get("keep")?.map_or(Ok(true), |node| node.flag())?;
    Ok(Action::Mirror { cells: cells(&node.need("cells")?)?, normal, offset, keep })
}

/// Reads what belongs to `reorient`.
pub(super) fn reoriented(node: &Node<'_>) -> Result<Action, DocumentError> {
    node.only(&["op", "id", "cells"])?;
    Ok(Action::Reorient { cells: cells(&node.need("cells")?)? })
}

/// Reads what belongs to `extrude`.
pub(super) fn extruded(node: &Node<'_>, materials: usize) -> Result<Action, DocumentError> {
    node.only(&["op", "id", "faces", "by", "start", "normals", "mix"])?;
    let list = node.need("faces")?;
    let items = list.items()?;
    list.check_count(items.len(), " faces", 1..=MOST_CELLS)?;
    let (mut faces, mut seen) = (Vec::with_capacity(items.len()), HashSet::new());
    for item in &items {
        item.only(&["cell", "face"])?;
        let side = FaceSpec { cell: cell(&item.need("cell")?)?, face: face(&item.need("face")?)? };
        if !seen.insert(side) {
            let message = "this face was found twice; expected each face once".to_owned();
            return Err(item.error(Code::Range, message));
        }
        faces.push(side);
    }
    let length = node.need("by")?;
    let by = length.within(0.0..=LARGEST_COORDINATE)?;
    if by == 0.0 {
        return Err(length.error(Code::Range, "0 was found; expected a length above 0".to_owned()));
    }
    let start = node.get("start")?.map(|node| node.choice(&["C1", "free"])).transpose()?;
    let normals = node.get("normals")?.map(|node| node.choice(&["mean", "surface"])).transpose()?;
    Ok(Action::Extrude {
        faces,
        by,
        start: if start == Some(0) { Start::C1 } else { Start::Free },
        normals: if normals == Some(1) { Normals::Surface } else { Normals::Mean },
        mix: node.get("mix")?.map(|node| mix(&node, materials)).transpose()?,
    })
}

/// Reads what belongs to `subdivide`.
pub(super) fn subdivided(node: &Node<'_>) -> Result<Action, DocumentError> {
    node.only(&["op", "id", "cell", "axis", "at"])?;
    let at = match node.get("at")? {
        None => 0.5,
        Some(place) => {
            let at = place.number()?;
            if !(at > 0.0 && at < 1.0) {
                let message = format!("{at} was found; expected a number above 0 and below 1");
                return Err(place.error(Code::Range, message));
            }
            at
        }
    };
    Ok(Action::Subdivide { cell: cell(&node.need("cell")?)?, axis: axis(&node.need("axis")?)?, at })
}
