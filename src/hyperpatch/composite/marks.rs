//! The continuity that is wanted where cells meet, as far as somebody has said so.

use super::{CellId, Match};
use crate::hyperpatch::{Axis, Corner, Face};
use std::collections::BTreeMap;

/// One corner of one face of a cell. The block of 2 x 2 coefficients there belongs to no other corner, so that
/// continuity may differ from corner to corner (section 3.5 of the paper, Figs. 7 and 8).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Side {
    /// The cell.
    pub cell: CellId,
    /// The corner.
    pub corner: Corner,
    /// The axis that the face lies across.
    pub axis: Axis,
}

/// What is wanted between a side and another one. Shape and material are apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mark {
    /// The other side.
    pub other: Side,
    /// Whether the first axis of the one face lies along the second of the other.
    pub is_swapped: bool,
    /// What is wanted of the shape: `None` when nothing is said and what the coefficients are decides,
    /// `Some(Match::None)` when the sides were let go and stay apart in edits although they may coincide.
    pub shape: Option<Match>,
    /// The same of the material.
    pub material: Option<Match>,
}

/// All marks of a body.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Marks {
    /// Every mark twice, once for each of its sides.
    sides: BTreeMap<Side, Mark>,
}

impl Side {
    /// The face.
    #[must_use]
    pub fn face(self) -> Face {
        Face { axis: self.axis, is_end: self.corner.0[self.axis as usize] }
    }

    /// Places of the 2 x 2 coefficients: the corner, its neighbours along the first and the second axis of the face,
    /// and the one across.
    #[must_use]
    pub fn block(self) -> [usize; 4] {
        let places = self.corner.block();
        let [first, second] = self.axis.others().map(|axis| 4 >> axis as usize);
        [places[0], places[first], places[second], places[first | second]]
    }

    /// Place of the coefficient one step inside from one on the face.
    #[must_use]
    pub fn inside(self, at: usize) -> usize {
        self.face().inside(at)
    }
}

impl Mark {
    /// Places on the other side of the coefficients of a side's block, in its order.
    #[must_use]
    pub fn other_block(&self) -> [usize; 4] {
        let [corner, first, second, across] = self.other.block();
        if self.is_swapped { [corner, second, first, across] } else { [corner, first, second, across] }
    }
}

impl Marks {
    /// The mark at a side.
    #[must_use]
    pub fn get(&self, side: Side) -> Option<&Mark> {
        self.sides.get(&side)
    }

    /// Every mark, by its lower side, with that side.
    pub fn iter(&self) -> impl Iterator<Item = (Side, Mark)> {
        self.sides.iter().filter(|(side, mark)| **side <= mark.other).map(|(side, mark)| (*side, *mark))
    }

    /// The marks at the sides of a cell, with these.
    pub fn at_cell(&self, cell: CellId) -> impl Iterator<Item = (Side, Mark)> {
        let start = Side { cell, corner: Corner([false; 3]), axis: Axis::U };
        let marks = self.sides.range(start..).take_while(move |(side, _)| side.cell == cell);
        marks.map(|(side, mark)| (*side, *mark))
    }

    /// Sets a mark for both sides, in the place of those that either had. A mark that says nothing is none.
    pub(super) fn set(&mut self, side: Side, mark: Mark) {
        for old in [side, mark.other] {
            if let Some(old) = self.sides.remove(&old) {
                self.sides.remove(&old.other);
            }
        }
        if mark.shape.is_some() || mark.material.is_some() {
            self.sides.insert(mark.other, Mark { other: side, ..mark });
            self.sides.insert(side, mark);
        }
    }

    /// Drops the marks at a cell.
    pub(super) fn forget(&mut self, cell: CellId) {
        let sides: Vec<_> = self.at_cell(cell).collect();
        for (side, mark) in sides {
            self.sides.remove(&side);
            self.sides.remove(&mark.other);
        }
    }

    /// Takes over the marks of other cells; `renamed` says what their sides are here.
    pub(super) fn copy(&mut self, other: &Self, renamed: impl Fn(Side) -> Option<Side>) {
        for (side, mark) in other.iter() {
            if let (Some(side), Some(other)) = (renamed(side), renamed(mark.other)) {
                self.set(side, Mark { other, ..mark });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn side(cell: u32, end: bool) -> Side {
        Side { cell: CellId(cell), corner: Corner([end, false, true]), axis: Axis::U }
    }

    fn mark(other: Side) -> Mark {
        Mark { other, is_swapped: false, shape: Some(Match::C1), material: None }
    }

    #[test]
    fn both_sides_know_a_mark_and_no_side_has_two() {
        let mut marks = Marks::default();
        marks.set(side(1, true), mark(side(2, false)));
        marks.set(side(2, true), mark(side(3, false)));
        assert_eq!(marks.get(side(2, false)).unwrap().other, side(1, true));
        assert_eq!((marks.iter().count(), marks.at_cell(CellId(2)).count()), (2, 2));
        marks.set(side(2, false), mark(side(4, true)));
        assert_eq!(marks.get(side(1, true)), None);
        marks.forget(CellId(2));
        assert_eq!(marks, Marks::default());
        marks.set(side(1, true), Mark { shape: None, ..mark(side(2, false)) });
        assert_eq!(marks, Marks::default(), "a mark that says nothing is none");
    }

    #[test]
    fn a_side_knows_its_block() {
        let side = side(0, true);
        assert_eq!(side.face(), Face { axis: Axis::U, is_end: true });
        assert_eq!(side.block(), [51, 55, 50, 54]);
        assert_eq!(side.inside(54), 38);
        assert_eq!(Mark { is_swapped: true, ..mark(side) }.other_block(), [51, 50, 55, 54]);
    }
}
