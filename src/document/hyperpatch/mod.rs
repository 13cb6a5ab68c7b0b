//! Hyperpatch documents: materials, and the list of operations that makes a body.
//!
//! [`read_hyperpatch`] reads a document; [`HyperpatchModel`] carries its operations out and remembers the bodies on the way, so that a document
//! that differs in its last operations costs only these.

mod action;
mod apply;
mod cells;
mod construct;
mod document;
mod edit;
mod material;
mod model;
pub(super) mod names;
mod replay;
mod stage;

pub use action::{Action, Operation, OperationReading};
pub use cells::CellSpec;
pub use construct::FaceSpec;
pub use document::{
    HyperpatchDocument, HyperpatchHead, HyperpatchKind, check_cells, check_operations, read_hyperpatch,
};
pub use material::MixTarget;
pub use model::HyperpatchModel;
pub use replay::Replay;
pub use stage::{OperationRow, Stage};
