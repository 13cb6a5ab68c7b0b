//! A hyperpatch document: its head and its list of operations.

use super::super::fields::materials;
use super::super::node::Node;
use super::super::read::check_kind;
use super::super::{Code, DocumentError, Json, MaterialSpec};
use super::action::{Action, Operation};
use super::names::LARGEST_ID;
use crate::hyperpatch::composite::MOST_CELLS;
use serde::ser::SerializeSeq;
use serde::{Serialize, Serializer};
use std::collections::HashSet;
use std::sync::Arc;

/// Most operations of a document.
const MOST_OPERATIONS: usize = 10_000;

/// A hyperpatch document in memory, with all defaults filled in.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct HyperpatchDocument {
    /// Version of the format: 1.
    pub directrix: u32,
    /// Always `hyperpatch`.
    pub kind: HyperpatchKind,
    /// What it says besides the operations.
    #[serde(flatten)]
    pub head: HyperpatchHead,
    /// What makes the body, in order, each with its number. Copies of documents share them.
    #[serde(serialize_with = "write_operations")]
    pub operations: Vec<(u32, Arc<Operation>)>,
}

/// What a hyperpatch document says besides its operations.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HyperpatchHead {
    /// Title, at most 200 characters.
    pub title: String,
    /// Unit of length, for display only.
    pub unit: String,
    /// Materials; a mix has one fraction for each.
    pub materials: Vec<MaterialSpec>,
}

/// The kind of a hyperpatch document.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum HyperpatchKind {
    /// Cells of tricubic Bezier hyperpatches.
    Hyperpatch,
}

/// Reads a hyperpatch document and checks every field by itself.
///
/// # Errors
/// The first thing that is wrong, with the path of its field; a document of another kind among them. Colours are checked by
/// [`HyperpatchModel::new`](super::HyperpatchModel::new).
pub fn read_hyperpatch(document: &Json) -> Result<HyperpatchDocument, DocumentError> {
    let root = Node::root(document, "");
    let head = HyperpatchHead::read(document)?;
    let list = root.need("operations")?;
    let items = list.items()?;
    let mut counts = Vec::with_capacity(items.len());
    check_operations(items.len())?;
    for item in &items {
        counts.push(written(item)?);
    }
    check_cells(counts)?;
    let read = |item: &Node<'_>| Operation::read(item, head.materials.len()).map(Arc::new);
    let operations = items.iter().map(read).collect::<Result<_, _>>()?;
    HyperpatchDocument::new(head, operations)
}

/// Number of cells that an item of the list seems to write out.
fn written(item: &Node<'_>) -> Result<usize, DocumentError> {
    let Ok(Some(op)) = item.get("op") else { return Ok(0) };
    if op.choice(&["cells"]).is_err() {
        return Ok(0);
    }
    item.need("cells")?.items().map(|items| items.len())
}

/// Refuses too many operations.
///
/// # Errors
/// With code `limit`, beyond 10,000.
pub fn check_operations(count: usize) -> Result<(), DocumentError> {
    if count <= MOST_OPERATIONS {
        return Ok(());
    }
    let message = format!("{count} operations were found; expected 0 to {MOST_OPERATIONS}");
    Err(DocumentError::new(Code::Limit, "operations", message))
}

/// Refuses more cells that are written out than a body has; `counts` says how many each operation has.
///
/// # Errors
/// With code `limit`, at the operation that passes it.
pub fn check_cells(counts: impl IntoIterator<Item = usize>) -> Result<(), DocumentError> {
    let mut sum = 0_usize;
    for (place, count) in counts.into_iter().enumerate() {
        sum = sum.saturating_add(count);
        if sum > MOST_CELLS {
            let message = format!("{sum} cells up to here were found; expected 0 to {MOST_CELLS}");
            return Err(DocumentError::new(Code::Limit, format!("operations[{place}].cells"), message));
        }
    }
    Ok(())
}

impl HyperpatchHead {
    /// Reads what a document says besides its operations, which may be there or not.
    ///
    /// # Errors
    /// The first thing that is wrong, with its path.
    pub fn read(document: &Json) -> Result<Self, DocumentError> {
        let root = Node::root(document, "");
        check_kind(&root, "hyperpatch")?;
        root.only(&["directrix", "kind", "title", "unit", "materials", "operations"])?;
        let text = |name: &str, most: usize, default: &str| match root.get(name)? {
            Some(node) => node.text(most),
            None => Ok(default.to_owned()),
        };
        let materials = materials(&root)?;
        Ok(Self { title: text("title", 200, "Untitled")?, unit: text("unit", 16, "mm")?, materials })
    }
}

impl HyperpatchDocument {
    /// A document of operations that were read for its number of materials.
    ///
    /// # Errors
    /// When there are too many operations or cells, or two operations have one number, with the path of the field.
    pub fn new(head: HyperpatchHead, operations: Vec<Arc<Operation>>) -> Result<Self, DocumentError> {
        check_operations(operations.len())?;
        check_cells(operations.iter().map(|operation| operation.action.written()))?;
        let (mut numbered, mut taken, mut next) = (Vec::with_capacity(operations.len()), HashSet::new(), 0);
        for (place, operation) in operations.into_iter().enumerate() {
            let id = operation.id.unwrap_or(next);
            let fault = |code, message| DocumentError::new(code, format!("operations[{place}].id"), message);
            if id as usize > LARGEST_ID {
                let message =
                    format!("an operation without a number follows {LARGEST_ID}; expected a smaller number");
                return Err(fault(Code::Limit, message));
            }
            if !taken.insert(id) {
                let message = format!("{id} was found twice; expected each number once");
                return Err(fault(Code::Range, message));
            }
            next = next.max(id + 1);
            numbered.push((id, operation));
        }
        Ok(Self { directrix: 1, kind: HyperpatchKind::Hyperpatch, head, operations: numbered })
    }
}

/// An operation with its number spelt out.
#[derive(Serialize)]
struct Written<'a> {
    id: u32,
    #[serde(flatten)]
    action: &'a Action,
}

fn write_operations<S: Serializer>(list: &[(u32, Arc<Operation>)], to: S) -> Result<S::Ok, S::Error> {
    let mut written = to.serialize_seq(Some(list.len()))?;
    for (id, operation) in list {
        written.serialize_element(&Written { id: *id, action: &operation.action })?;
    }
    written.end()
}
