//! A body on the way through the operations.

use super::action::Operation;
use crate::hyperpatch::composite::{Body, CellId};
use std::cell::RefCell;
use std::sync::Arc;

/// An operation that was carried out, with what came of it. Bodies of documents that begin alike share their stages.
#[derive(Debug)]
pub struct Stage {
    pub(super) id: u32,
    pub(super) operation: Arc<Operation>,
    pub(super) row: OperationRow,
    /// The body afterwards, where it is kept.
    pub(super) body: RefCell<Option<Body>>,
}

/// What came of an operation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OperationRow {
    /// Number of the operation.
    pub id: u32,
    /// Its place in the list of [`Action::NAMES`](super::Action::NAMES).
    pub op: usize,
    /// Why it does not apply, if it does not; the body is as before then.
    pub reason: Option<String>,
    /// Cells that it changed.
    pub touched: Vec<CellId>,
    /// Cells that it made.
    pub made: Vec<CellId>,
    /// Cells that it took away.
    pub removed: Vec<CellId>,
}

impl Stage {
    /// Whether it is the stage of an operation with a number, whatever came before.
    pub(super) fn is_of(&self, id: u32, operation: &Arc<Operation>) -> bool {
        self.id == id && (Arc::ptr_eq(&self.operation, operation) || self.operation == *operation)
    }

    /// What came of the operation.
    #[must_use]
    pub fn row(&self) -> &OperationRow {
        &self.row
    }
}
