//! The best path round the band, or through it from end to end.

use super::Ends;
use super::lattice::Lattice;
use super::path::{Begin, Bounds, Finish, Path, PathFinder, Rule};
use std::ops::Range;
use std::rc::Rc;

/// A search for the best closed path over all cells of one row, advancing by one path at a time.
///
/// Every closed path passes the row; for each start in it there is a best path to the start's own translate. Best paths of two starts
/// need not cross: where they meet they share a cell, after which both may go on along the better one. So the path of
/// a middle start lies between those of the starts on either side, and halving the list of starts takes a
/// number of cells that grows with the logarithm of its length. A start without a path bounds nothing. Between open outlines there is
/// one search, from one end to the other.
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
            _ if lattice.ends().is_some() => (0, vec![0]),
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
        let (begin, finish) = match lattice.ends() {
            None => (Begin::After(from.0, from.1), Finish::At(to.0, to.1)),
            Some(ends) => through(self.rule, ends, (a, b)),
        };
        let found = finder.find(lattice, self.rule, begin, finish, &bounds).map(|path| {
            let ends = lattice.ends().is_some();
            Rc::new(Path { ends, ..path })
        });
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

/// Where a path between open outlines of `a` and `b` vertices begins and ends. With tied ends and at most one line a vertex it begins after
/// the line at the start, and ends before that at the end.
fn through(rule: Rule, ends: Ends, (a, b): (usize, usize)) -> (Begin, Finish) {
    let (last_row, last) = (a - 1, b as i64 - 1);
    match (rule, ends) {
        (Rule::Cover { .. }, Ends::Tied) => (Begin::At(0, 0), Finish::At(last_row, last)),
        (Rule::Cover { .. }, Ends::Free) => (Begin::Anywhere, Finish::Anywhere),
        (Rule::Single, Ends::Tied) => (Begin::After(1, 1), Finish::At(last_row, last)),
        (Rule::Single, Ends::Free) => (Begin::After(0, 0), Finish::At(a, b as i64)),
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
