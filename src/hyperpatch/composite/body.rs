//! The cells of a body under identifiers that stay.

use super::marks::{Mark, Marks, Side};
use super::sharing::WELD;
use crate::hyperpatch::{Cell, Jacobian};
use glam::DVec3;
use std::error::Error;
use std::fmt;

/// Most cells of a body.
pub const MOST_CELLS: usize = 10_000;

/// Identifier of a cell: no deletion changes it, and no later cell gets it again unless it is [given](Body::add_as).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CellId(pub u32);

/// Cells by their identifiers, all of the same number of materials, and the continuity that is wanted where they meet.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    materials: usize,
    cells: Vec<(CellId, Cell)>,
    /// The box of the control points of each cell.
    boxes: Vec<(DVec3, DVec3)>,
    marks: Marks,
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
    /// There is such a cell already.
    Taken {
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
            Self::Taken { id } => write!(f, "there is a cell {id} already"),
        }
    }
}

impl Error for BodyError {}

impl Body {
    /// A body without cells.
    #[must_use]
    pub fn new(materials: usize) -> Self {
        Self { materials, cells: Vec::new(), boxes: Vec::new(), marks: Marks::default(), next: 0 }
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
        self.boxes.push(cell.net().bounds());
        self.cells.push((id, cell));
        Ok(id)
    }

    /// Adds a cell under an identifier of the caller's choice. Cells that are added without one get identifiers above
    /// it.
    ///
    /// # Errors
    /// As [`Body::add`], and when there is a cell of that identifier.
    pub fn add_as(&mut self, id: CellId, cell: Cell) -> Result<(), BodyError> {
        if self.cells.len() >= MOST_CELLS {
            return Err(BodyError::Full);
        }
        self.check(&cell)?;
        let Err(index) = self.cells.binary_search_by_key(&id, |(id, _)| *id) else {
            return Err(BodyError::Taken { id });
        };
        self.next = self.next.max(id.0.saturating_add(1));
        self.boxes.insert(index, cell.net().bounds());
        self.cells.insert(index, (id, cell));
        Ok(())
    }

    /// Puts another shape and material in the place of a cell, which keeps its identifier and its marks.
    ///
    /// # Errors
    /// When there is no such cell, or the new one has another number of materials.
    pub fn replace(&mut self, id: CellId, cell: Cell) -> Result<Cell, BodyError> {
        self.check(&cell)?;
        let index = self.index(id).ok_or(BodyError::Unknown { id })?;
        self.boxes[index] = cell.net().bounds();
        Ok(std::mem::replace(&mut self.cells[index].1, cell))
    }

    /// Takes a cell out, with what is marked at it; the others keep their identifiers.
    ///
    /// # Errors
    /// When there is no such cell.
    pub fn remove(&mut self, id: CellId) -> Result<Cell, BodyError> {
        let index = self.index(id).ok_or(BodyError::Unknown { id })?;
        self.marks.forget(id);
        self.boxes.remove(index);
        Ok(self.cells.remove(index).1)
    }

    /// Takes cells out, with what is marked at them. Identifiers are ascending; those that the body does not have are
    /// passed over.
    pub(in crate::hyperpatch) fn remove_all(&mut self, ids: &[CellId]) {
        ids.iter().for_each(|id| self.marks.forget(*id));
        let is_kept: Vec<bool> = self.cells.iter().map(|(id, _)| ids.binary_search(id).is_err()).collect();
        let (mut cells, mut boxes) = (is_kept.iter(), is_kept.iter());
        self.cells.retain(|_| cells.next() == Some(&true));
        self.boxes.retain(|_| boxes.next() == Some(&true));
    }

    /// Adds all cells of another body, in their order and with their marks, and returns their new identifiers.
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
        let ids: Result<Vec<_>, _> = other.cells.iter().map(|(_, cell)| self.add(cell.clone())).collect();
        let ids = ids?;
        let renamed = |side: Side| Some(Side { cell: ids[other.index(side.cell)?], ..side });
        self.marks.copy(&other.marks, renamed);
        Ok(ids)
    }

    /// What is marked about the continuity between cells.
    #[must_use]
    pub fn marks(&self) -> &Marks {
        &self.marks
    }

    /// Marks the continuity that is wanted on a side and the one that lies on it. Nothing is moved.
    pub(in crate::hyperpatch) fn mark(&mut self, side: Side, mark: Mark) {
        self.marks.set(side, mark);
    }

    /// Puts every mark at other sides.
    pub(in crate::hyperpatch) fn rename_marks(&mut self, renamed: impl Fn(Side) -> Side) {
        let marks = std::mem::take(&mut self.marks);
        self.marks.copy(&marks, |side| Some(renamed(side)));
    }

    /// Repeats marks for other cells; `renamed` says what a side becomes, or that it has no counterpart.
    pub(in crate::hyperpatch) fn repeat_marks(&mut self, renamed: impl Fn(Side) -> Option<Side>) {
        let marks = self.marks.clone();
        self.marks.copy(&marks, renamed);
    }

    /// Length of the diagonal of the box of all control points; never zero.
    #[must_use]
    pub fn size(&self) -> f64 {
        let (lo, hi) = self.bounds();
        let diagonal = (hi - lo).length();
        if diagonal.is_finite() && diagonal > 0.0 { diagonal } else { 1.0 }
    }

    /// Distance within which control points of cells are one: 1e-9 of the size, which is rounded to a power of two, so that it
    /// seldom changes when the body does.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        WELD * self.size().log2().round().exp2()
    }

    /// The box of all control points; without any its lowest corner is above the highest.
    pub(in crate::hyperpatch) fn bounds(&self) -> (DVec3, DVec3) {
        let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        self.boxes.iter().fold(start, |(lo, hi), (a, b)| (lo.min(*a), hi.max(*b)))
    }

    /// The boxes of the control points of all cells, in their order.
    pub(in crate::hyperpatch) fn boxes(&self) -> &[(DVec3, DVec3)] {
        &self.boxes
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
    fn identifiers_may_be_given() {
        let mut body = ring(2);
        let cell = |n: usize| ring(4).cells()[n].1.clone();
        body.add_as(CellId(70_001), cell(2)).unwrap();
        body.add_as(CellId(10_000), cell(3)).unwrap();
        assert_eq!(body.cells().iter().map(|(id, _)| id.0).collect::<Vec<_>>(), [0, 1, 10_000, 70_001]);
        assert_eq!(body.cell(CellId(10_000)), Some(&cell(3)));
        assert_eq!(body.boxes()[2], cell(3).net().bounds());
        assert_eq!(body.add_as(CellId(1), cell(1)), Err(BodyError::Taken { id: CellId(1) }));
        assert_eq!(body.add(cell(1)), Ok(CellId(70_002)));
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
