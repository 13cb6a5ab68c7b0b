//! The lattice of all lines that outlines could have.

use super::row::{Wedges, visible_lines};
use super::visibility::Sight;
use super::{Ends, Problem, RulingLine};
use std::ops::RangeInclusive;

/// The value of a cell without a line.
pub(super) const ABSENT: f64 = f64::NEG_INFINITY;

/// Every visible line as a cell (i, J) of a lattice that winds round the band, with its value.
///
/// Row i is vertex i of the first outline, column J a lifted vertex of the second (see
/// [`RulingLine::lifted`]). Everything repeats under the deck translation (a, b): rows may be asked for beyond a. Covers of
/// both outlines without crossings are the monotone paths from a cell to its own translate, by steps (1, 0), (0, 1) and
/// (1, 1). Lines from one vertex fill at most one lap of columns, so a row is stored as one dense run. Between open outlines nothing
/// repeats: the paths run from the first row or column to the last one, or from corner to corner where the ends are tied.
#[derive(Debug, Clone, Default)]
pub(super) struct Lattice {
    counts: (usize, usize),
    ends: Option<Ends>,
    rows: Vec<Row>,
    values: Vec<f64>,
    masses: [Vec<f64>; 2],
}

#[derive(Debug, Clone, Copy)]
struct Row {
    first: i64,
    start: usize,
}

/// The cells of one row: the run of columns from `first` on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cells<'a> {
    pub(super) first: i64,
    pub(super) values: &'a [f64],
}

impl Cells<'_> {
    /// The value at a lifted column, [`ABSENT`] where there is no line.
    pub(super) fn at(&self, column: i64) -> f64 {
        usize::try_from(column - self.first).ok().and_then(|k| self.values.get(k)).copied().unwrap_or(ABSENT)
    }

    /// First and last column of the run; it is empty when the last is below the first.
    pub(super) fn span(&self) -> (i64, i64) {
        (self.first, self.first + self.values.len() as i64 - 1)
    }

    /// Columns that have a line.
    pub(super) fn columns(&self) -> impl Iterator<Item = i64> + '_ {
        let lines = self.values.iter().enumerate().filter(|(_, value)| **value != ABSENT);
        lines.map(|(k, _)| self.first + k as i64)
    }
}

impl Lattice {
    /// A lattice of no rows, for the outlines of a problem.
    pub(super) fn of(problem: &Problem) -> Self {
        Self::new(problem.outlines().each_ref().map(|outline| outline.shares.clone()), problem.ends())
    }

    /// A lattice of no rows, for outlines with these shares of arc length of their edges.
    pub(super) fn new(shares: [Vec<f64>; 2], ends: Option<Ends>) -> Self {
        let counts = (shares[0].len(), shares[1].len());
        let masses = shares.map(|mut shares| {
            shares.rotate_right(1);
            shares.iter().map(|share| share / 2.0).collect()
        });
        Self { counts, ends, rows: Vec::with_capacity(counts.0), values: Vec::new(), masses }
    }

    /// Adds the next row from lifted columns and values in any order; columns not named have no line.
    pub(super) fn push_row(&mut self, lines: &[(i64, f64)]) {
        let first = lines.iter().map(|line| line.0).min().unwrap_or(0);
        let last = lines.iter().map(|line| line.0).max().unwrap_or(-1);
        let start = self.values.len();
        self.values.resize(start + (last - first + 1) as usize, ABSENT);
        for &(column, value) in lines {
            self.values[start + (column - first) as usize] = value;
        }
        self.rows.push(Row { first, start });
    }

    /// Numbers of rows and of columns in one lap.
    pub(super) fn counts(&self) -> (usize, usize) {
        self.counts
    }

    /// What becomes of the ends of open outlines; `None` when they are closed.
    pub(super) fn ends(&self) -> Option<Ends> {
        self.ends
    }

    /// Number of rows added so far.
    pub(super) fn height(&self) -> usize {
        self.rows.len()
    }

    /// Row `row`, which may lie laps beyond the last one.
    pub(super) fn row(&self, row: usize) -> Cells<'_> {
        let (a, b) = self.counts;
        let (index, laps) = (row % a, row / a);
        let Row { first, start } = self.rows[index];
        let end = self.rows.get(index + 1).map_or(self.values.len(), |next| next.start);
        Cells { first: first + (laps * b) as i64, values: &self.values[start..end] }
    }

    /// Half the share of arc length of the edge that ends at a vertex: what a step to it weighs.
    pub(super) fn mass(&self, outline: usize, vertex: usize) -> f64 {
        self.masses[outline][vertex]
    }

    /// The vertex of the second outline at a lifted column.
    pub(super) fn vertex(&self, column: i64) -> usize {
        column.rem_euclid(self.counts.1 as i64) as usize
    }

    /// The line of a cell.
    pub(super) fn line(&self, row: usize, column: i64) -> RulingLine {
        let (a, b) = self.counts;
        let lifted = column - (row / a * b) as i64;
        RulingLine { from: row % a, to: self.vertex(column), lifted, value: self.row(row).at(column) }
    }

    /// Greatest value at each vertex of each outline; [`ABSENT`] where a vertex has no line.
    pub(super) fn best(&self) -> [Vec<f64>; 2] {
        let (a, b) = self.counts;
        let mut best = [vec![ABSENT; a], vec![ABSENT; b]];
        for row in 0..self.height() {
            let cells = self.row(row);
            for (column, &value) in (cells.first..).zip(cells.values) {
                let vertex = self.vertex(column);
                best[0][row] = best[0][row].max(value);
                best[1][vertex] = best[1][vertex].max(value);
            }
        }
        best
    }

    /// The row with the fewest lines.
    pub(super) fn sparsest_row(&self) -> usize {
        (0..self.height()).min_by_key(|&row| self.row(row).columns().count()).unwrap_or(0)
    }

    /// The same lines with the outlines in each other's place.
    pub(super) fn transposed(&self) -> Self {
        let (a, b) = self.counts;
        let mut rows = vec![Vec::new(); b];
        for row in 0..self.height() {
            let cells = self.row(row);
            for column in cells.columns() {
                let laps = column.div_euclid(b as i64);
                rows[self.vertex(column)].push((row as i64 - laps * a as i64, cells.at(column)));
            }
        }
        let [first, second] = self.masses.clone();
        let (values, masses) = (Vec::with_capacity(self.values.len()), [second, first]);
        let mut transposed =
            Self { counts: (b, a), ends: self.ends, rows: Vec::with_capacity(b), values, masses };
        rows.iter().for_each(|row| transposed.push_row(row));
        transposed
    }

    /// Columns of all rows of one lap.
    pub(super) fn columns(&self) -> RangeInclusive<i64> {
        let spans = || (0..self.height()).map(|row| self.row(row).span());
        spans().map(|span| span.0).min().unwrap_or(0)..=spans().map(|span| span.1).max().unwrap_or(-1)
    }
}

/// Builds the lattice of a problem, row by row.
#[derive(Debug)]
pub(super) struct Survey {
    wedges: Wedges,
    sight: Sight,
    lattice: Lattice,
    line_buffer: Vec<(i64, f64)>,
    /// First and last column looked at in each row; without, all are.
    band: Option<Vec<(i64, i64)>>,
}

impl Survey {
    pub(super) fn new(problem: &Problem) -> Self {
        Self {
            wedges: Wedges::new(problem),
            sight: Sight::new(problem.outlines()),
            lattice: Lattice::of(problem),
            line_buffer: Vec::new(),
            band: None,
        }
    }

    /// A survey of the cells between a first and a last column of each row alone.
    pub(super) fn within(problem: &Problem, band: Vec<(i64, i64)>) -> Self {
        Self { band: Some(band), ..Self::new(problem) }
    }

    /// Adds one row; returns whether there are more.
    pub(super) fn advance(&mut self, problem: &Problem) -> bool {
        let from = self.lattice.height();
        self.line_buffer.clear();
        let b = self.lattice.counts().1;
        let (vertices, range) = match &self.band {
            Some(band) => (band[from].0..=band[from].1, band[from]),
            None => (0..=b as i64 - 1, (i64::MIN, i64::MAX)),
        };
        let vertices = vertices.take(b).map(|column| column.rem_euclid(b as i64) as usize);
        let lines = visible_lines(problem, &self.wedges, &mut self.sight, from, vertices)
            .filter(|line| (range.0..=range.1).contains(&line.lifted));
        self.line_buffer.extend(lines.map(|line| (line.lifted, line.value)));
        self.lattice.push_row(&self.line_buffer);
        self.lattice.height() < self.lattice.counts().0
    }

    /// The lattice with the rows added so far.
    pub(super) fn lattice(&self) -> &Lattice {
        &self.lattice
    }

    /// Hands the lattice over; an empty one is left.
    pub(super) fn take(&mut self) -> Lattice {
        std::mem::take(&mut self.lattice)
    }
}
