//! What an operation did, or why it does not apply.

use super::star::MOST_AROUND;
use crate::hyperpatch::composite::{BodyError, CellId};
use crate::hyperpatch::{CellError, Corner, Face};
use std::error::Error;
use std::fmt;

/// The cells that an operation had to do with; each list is ascending.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Change {
    /// Cells whose coefficients were changed, or the continuity that is wanted at them.
    pub touched: Vec<CellId>,
    /// Cells that are new.
    pub made: Vec<CellId>,
    /// Cells that are gone.
    pub removed: Vec<CellId>,
}

/// Why an operation does not apply to a body. The body is left as it was.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum OperationError {
    /// The body does not take a cell, or does not have it.
    Body(BodyError),
    /// A cell would have coefficients that no cell may have.
    Cell {
        /// The cell.
        id: CellId,
        /// What is wrong.
        error: CellError,
    },
    /// No cell was named.
    NoCells,
    /// A coefficient that no cell has.
    Coefficient {
        /// Its place in the list of 64.
        at: usize,
    },
    /// A composition of another number of materials than the body has.
    Materials {
        /// Number of fractions.
        count: usize,
        /// Number of materials of the body.
        expected: usize,
    },
    /// A displacement, length or position that is not finite, or not what is expected of it.
    Number {
        /// What the number is.
        name: &'static str,
        /// The number.
        value: f64,
        /// What is expected.
        expected: &'static str,
    },
    /// A corner that none of the cells has to which the operation is confined.
    Elsewhere {
        /// The cell whose corner it is.
        id: CellId,
        /// The corner.
        corner: Corner,
    },
    /// No cell lies on a face.
    Outer {
        /// The cell.
        id: CellId,
        /// The face.
        face: Face,
    },
    /// A cell lies on a face that should be free.
    Inner {
        /// The cell.
        id: CellId,
        /// The face.
        face: Face,
        /// The cell on the other side.
        other: CellId,
    },
    /// The cells at a corner do not lie in a grid, so that it cannot be smooth.
    Irregular {
        /// A cell at the corner.
        id: CellId,
        /// The corner of the cell.
        corner: Corner,
    },
    /// More cells at a corner than are looked at.
    Crowded {
        /// A cell at the corner.
        id: CellId,
        /// The corner of the cell.
        corner: Corner,
    },
    /// A corner that is not on the face.
    OffFace {
        /// The corner.
        corner: Corner,
        /// The face.
        face: Face,
    },
    /// A face without a normal, or whose normal is cancelled by that of another one beside it.
    NoNormal {
        /// The cell.
        id: CellId,
        /// The face.
        face: Face,
    },
    /// A cut through a row of cells comes back to a cell that it has gone through already, another way.
    SheetMeetsItself {
        /// The cell.
        id: CellId,
    },
}

impl From<BodyError> for OperationError {
    fn from(error: BodyError) -> Self {
        Self::Body(error)
    }
}

impl fmt::Display for OperationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Body(error) => error.fmt(f),
            Self::Cell { id, error } => write!(f, "cell {id}: {error}"),
            Self::NoCells => f.write_str("no cell is named; expected one or more"),
            Self::Coefficient { at } => {
                write!(f, "there is no coefficient {at}; expected a place from 0 to 63")
            }
            Self::Materials { count, expected } => {
                write!(f, "the mix has {count} fractions; expected {expected}, one for each material")
            }
            Self::Number { name, value, expected } => write!(f, "{name} is {value}; expected {expected}"),
            Self::Elsewhere { id, corner } => {
                write!(f, "none of the chosen cells is at corner {corner} of cell {id}")
            }
            Self::Outer { id, face } => {
                write!(f, "no cell lies on face {face} of cell {id}, so there is nothing to continue")
            }
            Self::Inner { id, face, other } => {
                write!(f, "face {face} of cell {id} is inside the body: cell {other} lies on it")
            }
            Self::Irregular { id, corner } => write!(
                f,
                "the cells at corner {corner} of cell {id} do not lie in a grid of two by two by two, \
                 so that nothing runs on there by itself"
            ),
            Self::Crowded { id, corner } => write!(
                f,
                "more than {MOST_AROUND} corners of cells lie at corner {corner} of cell {id}; expected no more"
            ),
            Self::OffFace { corner, face } => write!(f, "corner {corner} is not on face {face}"),
            Self::NoNormal { id, face } => write!(
                f,
                "face {face} of cell {id} gives no direction: it has no area, or folds back on a face beside it"
            ),
            Self::SheetMeetsItself { id } => write!(
                f,
                "the cut would come back to cell {id} another way and cross itself, or miss itself at the seam"
            ),
        }
    }
}

impl Error for OperationError {}
