//! The best closed path round the band.

use super::lattice::Lattice;
use super::path::{Bounds, Path, PathFinder, Rule};
use std::ops::Range;
use std::rc::Rc;

/// A search for the best closed path over all cells of one row, advancing by one path at a time.
///
/// Every closed path passes the row; for each start in it there is a best path to the start's own translate. Best paths of two starts
/// need not cross: where they meet they share a cell, after which both may go on along the better one. So the path of
/// a middle start lies between those of the starts on either side, and halving the list of starts takes a
/// number of cells that grows with the logarithm of its length. A start without a path bounds nothing.
///
/// # References
/// M. Maes, "On a cyclic string-to-string correction problem", *Information Processing Letters* 35 (1990).
#[derive(Debug, Clone)]
pub(super) struct Rounds {
    row: usize,
    starts: Vec<i64>,
    tasks: Vec<(Range<usize>, Bounds)>,
    rule: Rule,
    best: Option<Rc<Path>>,
    /// Whether paths bound each other; without, every start is searched in full.
    divides: bool,
}

impl Rounds {
    /// A search through the sparsest row, or for [`Rule::Single`] through the corners before the first row.
    pub(super) fn new(lattice: &Lattice, rule: Rule) -> Self {
        let (row, starts) = match rule {
            Rule::Cover { .. } => {
                let row = lattice.sparsest_row();
                (row, lattice.row(row).columns().collect())
            }
            Rule::Single => {
                let columns = lattice.columns();
                (0, (*columns.start()..=*columns.end() + 1).collect())
            }
        };
        Self::through(row, starts, rule)
    }

    fn through(row: usize, starts: Vec<i64>, rule: Rule) -> Self {
        let tasks = vec![(0..starts.len(), Bounds::default())];
        Self { row, starts, tasks, rule, best: None, divides: true }
    }

    /// Searches from one more start; returns whether there are more.
    pub(super) fn advance(&mut self, lattice: &Lattice, finder: &mut PathFinder) -> bool {
        let Some((range, bounds)) = self.tasks.pop() else { return false };
        if range.is_empty() {
            return !self.tasks.is_empty();
        }
        let middle = range.start + range.len() / 2;
        let (a, b) = lattice.counts();
        let start = self.starts[middle];
        let (from, to) = ((self.row, start), (self.row + a, start + b as i64));
        let found = finder.find(lattice, self.rule, from, to, &bounds).map(Rc::new);
        let bound = found.clone().filter(|_| self.divides);
        let lower = Bounds { lower: bound.clone().or(bounds.lower.clone()), upper: bounds.upper.clone() };
        let upper = Bounds { lower: bounds.lower, upper: bound.or(bounds.upper) };
        self.tasks.push((middle + 1..range.end, lower));
        self.tasks.push((range.start..middle, upper));
        if let Some(path) = found
            && self.best.as_ref().is_none_or(|best| path.value > best.value)
        {
            self.best = Some(path);
        }
        true
    }

    /// The best path found so far.
    pub(super) fn best(&self) -> Option<&Path> {
        self.best.as_deref()
    }
}

/// Returns the best closed path by searching from every start in full: the reference for [`Rounds`].
#[cfg(test)]
pub(super) fn best_by_brute_force(lattice: &Lattice, rule: Rule) -> Option<Path> {
    let mut rounds = Rounds { divides: false, ..Rounds::new(lattice, rule) };
    let mut finder = PathFinder::default();
    while rounds.advance(lattice, &mut finder) {}
    rounds.best().cloned()
}
