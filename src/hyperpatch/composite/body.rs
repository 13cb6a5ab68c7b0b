//! The cells of a body under identifiers that stay.

use crate::hyperpatch::{Cell, Jacobian};
use std::error::Error;
use std::fmt;

/// Most cells of a body.
pub const MOST_CELLS: usize = 10_000;

/// Identifier of a cell: its place in the order of creation, which no deletion changes and no later cell gets again.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CellId(pub u32);

/// Cells in the order of their creation, all of the same number of materials.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    materials: usize,
    cells: Vec<(CellId, Cell)>,
    next: u32,
}

/// Why a cell is not taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum BodyError {
    /// There are as many cells as a body may have.
    Full,
    /// The cell has another number of materials.
    Materials {
        /// Number of the cell.
        count: usize,
        /// Number of the body.
        expected: usize,
    },
    /// There is no such cell.
    Unknown {
        /// The identifier.
        id: CellId,
    },
}

impl fmt::Display for CellId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0)
    }
}

impl fmt::Display for BodyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Full => write!(f, "the body has {MOST_CELLS} cells; expected no more"),
            Self::Materials { count, expected } => {
                write!(f, "the cell has {count} materials; expected {expected}, as the body has")
            }
            Self::Unknown { id } => write!(f, "there is no cell {id}"),
        }
    }
}

impl Error for BodyError {}

impl Body {
    /// A body without cells.
    #[must_use]
    pub fn new(materials: usize) -> Self {
        Self { materials, cells: Vec::new(), next: 0 }
    }

    /// Number of materials.
    #[must_use]
    pub fn materials(&self) -> usize {
        self.materials
    }

    /// The cells, by identifier from the lowest on.
    #[must_use]
    pub fn cells(&self) -> &[(CellId, Cell)] {
        &self.cells
    }

    /// A cell.
    #[must_use]
    pub fn cell(&self, id: CellId) -> Option<&Cell> {
        self.index(id).map(|index| &self.cells[index].1)
    }

    /// Adds a cell, whatever its shape: it is for [`certify`](crate::hyperpatch::validity::certify) and
    /// [`Pairs`](super::Pairs) to say whether it is sound.
    ///
    /// # Errors
    /// When the body is full, or the cell has another number of materials.
    pub fn add(&mut self, cell: Cell) -> Result<CellId, BodyError> {
        if self.cells.len() >= MOST_CELLS {
            return Err(BodyError::Full);
        }
        self.check(&cell)?;
        let id = CellId(self.next);
        self.next += 1;
        self.cells.push((id, cell));
        Ok(id)
    }

    /// Puts another shape and material in the place of a cell, which keeps its identifier.
    ///
    /// # Errors
    /// When there is no such cell, or the new one has another number of materials.
    pub fn replace(&mut self, id: CellId, cell: Cell) -> Result<Cell, BodyError> {
        self.check(&cell)?;
        let index = self.index(id).ok_or(BodyError::Unknown { id })?;
        Ok(std::mem::replace(&mut self.cells[index].1, cell))
    }

    /// Takes a cell out; the others keep their identifiers.
    ///
    /// # Errors
    /// When there is no such cell.
    pub fn remove(&mut self, id: CellId) -> Result<Cell, BodyError> {
        let index = self.index(id).ok_or(BodyError::Unknown { id })?;
        Ok(self.cells.remove(index).1)
    }

    /// Adds all cells of another body, in their order, and returns their new identifiers.
    ///
    /// # Errors
    /// When there would be too many cells, or the other body has another number of materials; nothing is added then.
    pub fn merge(&mut self, other: &Self) -> Result<Vec<CellId>, BodyError> {
        if self.cells.len() + other.cells.len() > MOST_CELLS {
            return Err(BodyError::Full);
        }
        if let Some((_, cell)) = other.cells.first() {
            self.check(cell)?;
        }
        other.cells.iter().map(|(_, cell)| self.add(cell.clone())).collect()
    }

    /// Volume of all cells: exact up to rounding.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.cells.iter().map(|(_, cell)| Jacobian::new(cell.net()).volume()).sum()
    }

    /// Volume of each material in all cells.
    #[must_use]
    pub fn amounts(&self) -> Vec<f64> {
        let mut sums = vec![0.0; self.materials];
        for (_, cell) in &self.cells {
            sums.iter_mut().zip(cell.amounts()).for_each(|(sum, amount)| *sum += amount);
        }
        sums
    }

    /// Index of a cell in the list.
    pub(super) fn index(&self, id: CellId) -> Option<usize> {
        self.cells.binary_search_by_key(&id, |(id, _)| *id).ok()
    }

    /// Refuses a cell with another number of materials.
    fn check(&self, cell: &Cell) -> Result<(), BodyError> {
        if cell.materials() == self.materials {
            return Ok(());
        }
        Err(BodyError::Materials { count: cell.materials(), expected: self.materials })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::test_cells::ring_cell;
    use crate::material::Composition;

    fn ring(count: usize) -> Body {
        let mut body = Body::new(2);
        for n in 0..count {
            let cell = Cell::uniform(ring_cell(count, n, 1.0, 2.0, 1.0), &Composition::pure(n % 2, 2));
            body.add(cell.unwrap()).unwrap();
        }
        body
    }

    #[test]
    fn identifiers_outlast_deletions() {
        let mut body = ring(4);
        body.remove(CellId(1)).unwrap();
        let id = body.add(ring(4).cells()[0].1.clone()).unwrap();
        assert_eq!(id, CellId(4));
        body.remove(CellId(4)).unwrap();
        assert_eq!(body.add(ring(4).cells()[0].1.clone()), Ok(CellId(5)), "no identifier is given twice");
        assert_eq!(body.cells().iter().map(|(id, _)| id.0).collect::<Vec<_>>(), [0, 2, 3, 5]);
        assert_eq!(body.cell(CellId(2)), ring(4).cell(CellId(2)));
        assert_eq!(body.remove(CellId(1)), Err(BodyError::Unknown { id: CellId(1) }));
    }

    #[test]
    fn bodies_merge_and_add_up() {
        let mut body = ring(12);
        let volume = body.volume();
        assert!((body.amounts()[0] - volume / 2.0).abs() < 1e-12);
        let ids = body.merge(&ring(4)).unwrap();
        assert_eq!(ids, [12, 13, 14, 15].map(CellId));
        assert!((body.volume() - volume - ring(4).volume()).abs() < 1e-12);
        assert_eq!(body.merge(&Body::new(3)), Ok(Vec::new()));
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        let mut body = ring(2);
        let three = Cell::uniform(ring_cell(4, 0, 1.0, 2.0, 1.0), &Composition::pure(0, 3)).unwrap();
        let error = Err(BodyError::Materials { count: 3, expected: 2 });
        assert_eq!(body.add(three.clone()), error);
        assert_eq!(body.replace(CellId(0), three.clone()).map(|_| CellId(0)), error);
        let mut other = Body::new(3);
        other.add(three).unwrap();
        assert!(body.merge(&other).is_err());
        assert_eq!(body.cells().len(), 2);

        let mut one = Body::new(2);
        one.add(ring(4).cells()[0].1.clone()).unwrap();
        let mut many = Body::new(2);
        for _ in 0..MOST_CELLS {
            many.add(one.cells()[0].1.clone()).unwrap();
        }
        assert_eq!(many.add(one.cells()[0].1.clone()), Err(BodyError::Full));
        assert_eq!(many.merge(&one), Err(BodyError::Full));
        assert!(BodyError::Full.to_string().contains("10000"));
    }
}
