//! The best monotone path through the lattice.

use super::RulingLine;
use super::lattice::{ABSENT, Lattice};
use std::rc::Rc;

/// What a path collects.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Rule {
    /// Cells with a line, by steps (1, 0), (0, 1), (1, 1): every vertex passed has a line. A cell is worth
    /// `cells` times its value less `price`, a step `steps` times its share of arc length times the mean value of its ends.
    Cover {
        /// 1 to add up the values of lines, else 0.
        cells: f64,
        /// 1 to integrate values over arc length, else 0.
        steps: f64,
        /// Price of every line.
        price: f64,
    },
    /// Corners between cells, all of which exist: a step (1, 1) to the corner (i, J) takes the line (i - 1, J - 1), which must have a
    /// positive value, steps (1, 0) and (0, 1) leave a vertex out. No vertex gets two lines.
    Single,
}

/// A monotone path: in each row from `row` on it runs from the first to the last of two columns, and enters the next row
/// at that last column (a step (1, 0)) or at the one after it (a step (1, 1)).
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Path {
    pub(super) row: usize,
    pub(super) columns: Vec<(i64, i64)>,
    pub(super) value: f64,
    /// Whether the path ends here: else its end is the start of the next one, or its own translate.
    pub(super) ends: bool,
}

/// Where a path begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Begin {
    /// In a cell that the path before counts.
    After(usize, i64),
    /// In a cell, which counts.
    At(usize, i64),
    /// In any cell of the first row or column.
    Anywhere,
}

/// Where a path ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Finish {
    /// In a cell.
    At(usize, i64),
    /// In any cell of the last row or column.
    Anywhere,
}

impl Path {
    /// Cells of the path in order, with the start, without an end that is the start of the next one.
    pub(super) fn cells(&self) -> impl Iterator<Item = (usize, i64)> + '_ {
        let last = self.columns.len() - 1;
        self.columns.iter().enumerate().flat_map(move |(k, &(first, end))| {
            let end = if k == last && !self.ends { end - 1 } else { end };
            (first..=end).map(move |column| (self.row + k, column))
        })
    }

    /// Steps (1, 1) of the path, each by the cell at its start.
    pub(super) fn diagonals(&self) -> impl Iterator<Item = (usize, i64)> + '_ {
        let pairs = self.columns.windows(2).enumerate();
        pairs.filter(|(_, w)| w[0].1 != w[1].0).map(|(k, w)| (self.row + k, w[0].1))
    }
}

/// Lines of cells in cyclic order, from the first vertex of the first outline on: what lies a lap on comes first, a lap back.
///
/// `cells` ascend weakly and span one lap of rows at most.
pub(super) fn lines_of(lattice: &Lattice, cells: impl Iterator<Item = (usize, i64)>) -> Vec<RulingLine> {
    let (mut lines, mut later) = (Vec::new(), Vec::new());
    for (row, column) in cells {
        let list = if row < lattice.counts().0 { &mut later } else { &mut lines };
        list.push(lattice.line(row, column));
    }
    lines.append(&mut later);
    lines
}

/// Paths that a path must stay between, weakly; both have its rows.
#[derive(Debug, Clone, Default)]
pub(super) struct Bounds {
    pub(super) lower: Option<Rc<Path>>,
    pub(super) upper: Option<Rc<Path>>,
}

const DIAGONAL: u8 = 0;
const ALONG_FIRST: u8 = 1;
const ALONG_SECOND: u8 = 2;
const START: u8 = 3;

/// Finds best paths; keeps its memory from one to the next.
#[derive(Debug, Clone, Default)]
pub(super) struct PathFinder {
    /// How each cell is best reached, row after row.
    steps: Vec<u8>,
    /// First column of each row and where its steps begin.
    rows: Vec<(i64, usize)>,
    /// Columns `first..` of the row above: the best value of a path to them, and their own value.
    best: Vec<f64>,
    own: Vec<f64>,
    above_best: Vec<f64>,
    above_own: Vec<f64>,
}

impl PathFinder {
    /// Returns the best path from one cell to another, or `None` when there is none. The value of the end is counted, that of the
    /// start as [`Begin`] says.
    ///
    /// Of paths of equal value the one with the later steps (1, 1) wins. Time and memory are a multiple of the cells between the
    /// ends and the bounds.
    pub(super) fn find(
        &mut self,
        lattice: &Lattice,
        rule: Rule,
        begin: Begin,
        finish: Finish,
        bounds: &Bounds,
    ) -> Option<Path> {
        let (a, b) = lattice.counts();
        let (from, is_free) = match begin {
            Begin::After(row, column) | Begin::At(row, column) => ((row, column), false),
            Begin::Anywhere => ((0, 0), true),
        };
        let to = match finish {
            Finish::At(row, column) => (row, column),
            Finish::Anywhere => (a - 1, b as i64 - 1),
        };
        let mut end: Option<(f64, usize, i64)> = None;
        self.steps.clear();
        self.rows.clear();
        self.best.clear();
        self.own.clear();
        for row in from.0..=to.0 {
            let k = row - from.0;
            let (mut low, mut high) = (from.1, to.1);
            if let Rule::Cover { .. } = rule {
                let (first, last) = lattice.row(row).span();
                (low, high) = (low.max(first), high.min(last));
            }
            if let Some(lower) = &bounds.lower {
                low = low.max(lower.columns[k].0);
            }
            if let Some(upper) = &bounds.upper {
                high = high.min(upper.columns[k].1);
            }
            if low > high {
                if !is_free {
                    return None;
                }
                high = low - 1;
            }
            self.take_over(low, high);
            self.rows.push((low, self.steps.len()));
            let is_first = k == 0;
            if is_first && !is_free && low > from.1 {
                return None;
            }
            let alive = match rule {
                _ if low > high => true,
                Rule::Cover { cells, steps, price } => {
                    let start = (is_first || is_free).then_some(begin);
                    self.cover(lattice, row, (low, high), start, (cells, steps, price))
                }
                Rule::Single => self.single(lattice, row, (low, high), is_first),
            };
            if !alive && !is_free {
                return None;
            }
            if finish == Finish::Anywhere {
                let is_end = |column: i64| row == to.0 || column == to.1;
                for (column, &value) in (low..).zip(&self.best).filter(|(column, _)| is_end(*column)) {
                    if value != ABSENT && end.is_none_or(|(best, ..)| value > best) {
                        end = Some((value, row, column));
                    }
                }
            }
        }
        if let Finish::At(row, column) = finish {
            let &(low, _) = self.rows.last()?;
            let value = usize::try_from(column - low).ok().and_then(|k| self.best.get(k)).copied()?;
            end = (value != ABSENT).then_some((value, row, column));
        }
        end.map(|(value, row, column)| self.trace(from.0, (row, column), value))
    }

    /// Lays the row above over the columns from one before `low` to `high`.
    fn take_over(&mut self, low: i64, high: i64) {
        let width = (high - low + 2) as usize;
        let offset = self.rows.last().map_or(0, |&(first, _)| low - 1 - first);
        for (row, above) in [(&mut self.best, &mut self.above_best), (&mut self.own, &mut self.above_own)] {
            above.clear();
            above.resize(width, ABSENT);
            let (skip, pad) = (offset.max(0) as usize, (-offset).max(0) as usize);
            if skip < row.len() && pad < width {
                let count = (row.len() - skip).min(width - pad);
                above[pad..pad + count].copy_from_slice(&row[skip..skip + count]);
            }
            row.clear();
        }
    }

    fn cover(
        &mut self,
        lattice: &Lattice,
        row: usize,
        (low, high): (i64, i64),
        begin: Option<Begin>,
        (cells, steps, price): (f64, f64, f64),
    ) -> bool {
        let line = lattice.row(row);
        let own = &line.values[(low - line.first) as usize..=(high - line.first) as usize];
        let across = steps * lattice.mass(0, row % lattice.counts().0) / 2.0;
        let (mut left, mut left_own, mut alive) = (ABSENT, ABSENT, false);
        let mut vertex = lattice.vertex(low);
        for (k, &value) in own.iter().enumerate() {
            let along = steps * lattice.mass(1, vertex) / 2.0;
            vertex = if vertex + 1 == lattice.counts().1 { 0 } else { vertex + 1 };
            let (mut best, mut step) = (ABSENT, DIAGONAL);
            if value != ABSENT {
                let gain = cells * value - price;
                // Cells without a line are worth minus infinity, so that no sum from one of them is greater than another.
                let candidates = [
                    (self.above_best[k] + (across + along) * (self.above_own[k] + value) + gain, DIAGONAL),
                    (self.above_best[k + 1] + across * (self.above_own[k + 1] + value) + gain, ALONG_FIRST),
                    (left + along * (left_own + value) + gain, ALONG_SECOND),
                ];
                for (sum, by) in candidates {
                    if sum > best {
                        (best, step) = (sum, by);
                    }
                }
                let start = match begin {
                    Some(Begin::After(..)) if k == 0 => 0.0,
                    Some(Begin::At(..)) if k == 0 => gain,
                    Some(Begin::Anywhere) if row == 0 || low + k as i64 == 0 => gain,
                    _ => ABSENT,
                };
                if start > best {
                    (best, step) = (start, START);
                }
            }
            alive |= best != ABSENT;
            (left, left_own) = (best, value);
            self.best.push(best);
            self.own.push(value);
            self.steps.push(step);
        }
        alive
    }

    fn single(&mut self, lattice: &Lattice, row: usize, (low, high): (i64, i64), is_first: bool) -> bool {
        let taken = (!is_first).then(|| lattice.row(row - 1));
        let mut left = ABSENT;
        for (k, column) in (low..=high).enumerate() {
            let (mut best, mut step) = (self.above_best[k + 1], ALONG_FIRST);
            if left > best {
                (best, step) = (left, ALONG_SECOND);
            }
            let value = taken.map_or(ABSENT, |cells| cells.at(column - 1));
            let sum = self.above_best[k] + value;
            if value > 0.0 && sum > best {
                (best, step) = (sum, DIAGONAL);
            }
            if is_first && k == 0 {
                (best, step) = (0.0, START);
            }
            left = best;
            self.best.push(best);
            self.own.push(ABSENT);
            self.steps.push(step);
        }
        true
    }

    /// Follows the steps back from the end to the start; `first_row` is the first one looked at.
    fn trace(&self, first_row: usize, to: (usize, i64), value: f64) -> Path {
        let mut columns = vec![(to.1, to.1); to.0 - first_row + 1];
        let (mut k, mut column) = (columns.len() - 1, to.1);
        loop {
            let (first, start) = self.rows[k];
            match self.steps[start + (column - first) as usize] {
                START => break,
                ALONG_SECOND => column -= 1,
                step => {
                    columns[k].0 = column;
                    // The first row has steps along itself alone, down to the start.
                    k -= 1;
                    column -= i64::from(step == DIAGONAL);
                    columns[k].1 = column;
                }
            }
        }
        columns[k].0 = column;
        columns.drain(..k);
        Path { row: first_row + k, columns, value, ends: false }
    }
}
