//! Operations on coefficients: moves, and marks of continuity.

use super::super::node::Node;
use super::super::{Code, DocumentError};
use super::action::Action;
use super::names::{self, cell, coefficient, corner, face};
use crate::hyperpatch::LARGEST_COORDINATE;
use crate::hyperpatch::composite::Match;
use crate::hyperpatch::operation::Reach;

/// Reads what belongs to `move`.
pub(super) fn moved(node: &Node<'_>) -> Result<Action, DocumentError> {
    node.only(&["op", "id", "cell", "at", "by", "reach"])?;
    let reach = node.get("reach")?.map(|node| names::reach(&node)).transpose()?;
    Ok(Action::Move {
        cell: cell(&node.need("cell")?)?,
        at: coefficient(&node.need("at")?)?,
        by: node.need("by")?.triple(-LARGEST_COORDINATE..=LARGEST_COORDINATE)?,
        reach: reach.unwrap_or(Reach::Block),
    })
}

/// Reads what belongs to `continuity`.
pub(super) fn continued(node: &Node<'_>) -> Result<Action, DocumentError> {
    node.only(&["op", "id", "cell", "face", "corner", "shape", "material"])?;
    let level = |name: &'static str| -> Result<_, DocumentError> {
        let Some(found) = node.get(name)? else { return Ok(None) };
        let levels = [Match::None, Match::Block, Match::C1];
        found.choice(&["none", "C0", "C1"]).map(|n| Some(levels[n]))
    };
    let (shape, material) = (level("shape")?, level("material")?);
    if shape.is_none() && material.is_none() {
        node.need("shape")?;
    }
    let face_node = node.need("face")?;
    let face = face(&face_node)?;
    let at = node.get("corner")?;
    let at = at.as_ref().map(|node| corner(node).map(|corner| (node, corner))).transpose()?;
    if let Some((node, corner)) = at
        && !corner.faces().contains(&face)
    {
        let message = "the corner is not on the face; expected one of its four".to_owned();
        return Err(node.error(Code::Range, message));
    }
    Ok(Action::Continuity {
        cell: cell(&node.need("cell")?)?,
        face,
        corner: at.map(|(_, corner)| corner),
        shape,
        material,
    })
}
