//! Operations on the material.

use super::super::node::Node;
use super::super::{Code, DocumentError};
use super::action::Action;
use super::cells::mix;
use super::names::{self, cell, cells, coefficient, corner};
use crate::hyperpatch::Corner;
use crate::hyperpatch::composite::CellId;
use crate::hyperpatch::operation::Slope;
use serde::Serialize;

/// What gets a mix.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum MixTarget {
    /// All 64 coefficients of some cells.
    Cells {
        /// The cells.
        #[serde(serialize_with = "names::write_cells")]
        cells: Vec<CellId>,
    },
    /// The block of a corner, in every cell with it or in some.
    Corner {
        /// A cell with the corner.
        #[serde(serialize_with = "names::write_cell")]
        cell: CellId,
        /// The corner.
        #[serde(serialize_with = "names::write_corner")]
        corner: Corner,
        /// The cells in which it counts; without them all.
        #[serde(skip_serializing_if = "Option::is_none", serialize_with = "write_within")]
        within: Option<Vec<CellId>>,
    },
    /// One coefficient.
    Coefficient {
        /// The cell.
        #[serde(serialize_with = "names::write_cell")]
        cell: CellId,
        /// Indices of the coefficient.
        at: [usize; 3],
    },
}

/// Reads what belongs to `mix`.
pub(super) fn mixed(node: &Node<'_>, materials: usize) -> Result<Action, DocumentError> {
    node.only(&["op", "id", "mix", "cells", "cell", "corner", "within", "at"])?;
    let mix = mix(&node.need("mix")?, materials)?;
    let alone = |names: &[&'static str], with: &str| -> Result<(), DocumentError> {
        for name in names {
            if let Some(found) = node.get(name)? {
                return Err(found.error(Code::Range, format!("expected no `{name}` beside `{with}`")));
            }
        }
        Ok(())
    };
    let target = if let Some(list) = node.get("cells")? {
        alone(&["cell", "corner", "within", "at"], "cells")?;
        MixTarget::Cells { cells: cells(&list)? }
    } else {
        let found = cell(&node.need("cell")?)?;
        if let Some(at) = node.get("at")? {
            alone(&["corner", "within"], "at")?;
            MixTarget::Coefficient { cell: found, at: coefficient(&at)? }
        } else {
            let within = node.get("within")?.map(|list| cells(&list)).transpose()?;
            MixTarget::Corner { cell: found, corner: corner(&node.need("corner")?)?, within }
        }
    };
    Ok(Action::Mix { mix, target })
}

/// Reads what belongs to `slope`.
pub(super) fn sloped(node: &Node<'_>) -> Result<Action, DocumentError> {
    node.only(&["op", "id", "cell", "corner", "rule"])?;
    Ok(Action::Slope {
        cell: cell(&node.need("cell")?)?,
        corner: corner(&node.need("corner")?)?,
        rule: match node.need("rule")?.choice(&["flat", "natural"])? {
            0 => Slope::Flat,
            _ => Slope::Natural,
        },
    })
}

fn write_within<S: serde::Serializer>(cells: &Option<Vec<CellId>>, to: S) -> Result<S::Ok, S::Error> {
    names::write_cells(cells.as_deref().unwrap_or_default(), to)
}
