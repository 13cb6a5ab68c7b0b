//! Greedy ruling line construction.

use super::chain::Chain;
use super::lattice::Lattice;
use super::row::{Candidate, Wedges, ranked_lines};
use super::visibility::Sight;
use super::{Bound, Problem, Totals, measure, prune, prune_as_printed};
use crate::geom::order_by_pair;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// A ruling line from a vertex of the first outline to a vertex of the second.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RulingLine {
    /// Vertex of the first outline.
    pub from: usize,
    /// Vertex of the second outline.
    pub to: usize,
    /// The same vertex counted on through the laps of the second outline, so that lines in cyclic order have ascending
    /// numbers; `to` is its remainder by the number of vertices.
    pub lifted: i64,
    /// Value f of the line.
    pub value: f64,
}

/// The lines that the greedy construction found.
#[derive(Debug, Clone, PartialEq)]
pub struct Matching {
    /// Lines without the redundant ones, in cyclic order.
    pub lines: Vec<RulingLine>,
    /// Every line accepted, in the order in which they were.
    pub growth: Vec<RulingLine>,
    /// Vertices of each outline that see no vertex of the other.
    pub orphans: [Vec<usize>; 2],
    /// What the lines are worth, and the check of the constraints.
    pub totals: Totals,
}

impl Matching {
    /// Tells whether every vertex has a line and no constraint is broken.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        let Totals { crossings, blocked, uncovered, .. } = &self.totals;
        *crossings == 0 && *blocked == 0 && uncovered.iter().all(Vec::is_empty)
    }
}

/// Matches two outlines greedily, in one go; the same as running [`Greedy`] to its end.
#[must_use]
pub fn greedy(problem: &Problem) -> Matching {
    let mut job = Greedy::new(problem.clone());
    loop {
        if let Some(matching) = job.step(&mut || true) {
            return matching;
        }
    }
}

/// Greedy ruling line construction as a job that advances in steps.
///
/// Algorithm II of the paper adds, again and again, the best line that is visible and crosses no earlier one, until every
/// vertex has a line. What is admissible only shrinks as lines are added, so one pass over the visible lines from
/// the best to the worst accepts the same lines in the same order as the paper's repeated scans. Values are
/// compared to 40 significant bits; among equal ones the lower vertex of the first outline, then of the second,
/// comes first. Crossing is decided by lifted indices; the printed index interval (Eq. 12) loses count of the laps.
/// Redundant lines are removed at the end. Between open outlines whose ends are tied the lines there come first of all.
///
/// The job ends also when no further line is admissible although a vertex has none: see [`Totals::uncovered`].
#[derive(Debug)]
pub struct Greedy {
    problem: Problem,
    wedges: Wedges,
    sight: Sight,
    rows: Vec<Vec<Candidate>>,
    best: [Vec<f64>; 2],
    heads: BinaryHeap<Head>,
    chain: Chain,
    covered: [Vec<bool>; 2],
    bare: usize,
    growth: Vec<RulingLine>,
    printed: Printed,
    lattice: Lattice,
}

/// Rules of the greedy construction that are taken as the paper prints them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Printed {
    /// The index interval of Eq. 12, which loses count of the laps: lines may cross.
    pub order: bool,
    /// The stop rule of Algorithm II: it finds the best line again and stops, with one line.
    pub stop: bool,
    /// The removal loop, which drops the lowest line of all while any is redundant: vertices may lose their last line.
    pub removal: bool,
}

/// Candidates taken between two looks at the clock: some ten microseconds.
const POPS_BETWEEN_LOOKS: usize = 256;

impl Greedy {
    /// A job that has not begun.
    #[must_use]
    pub fn new(problem: Problem) -> Self {
        Self::as_printed(problem, Printed::default())
    }

    /// A job that takes some rules as printed.
    #[must_use]
    pub fn as_printed(problem: Problem, printed: Printed) -> Self {
        let (a, b) = problem.counts();
        Self {
            wedges: Wedges::new(&problem),
            sight: Sight::new(problem.outlines()),
            rows: Vec::with_capacity(a),
            best: [vec![f64::NEG_INFINITY; a], vec![f64::NEG_INFINITY; b]],
            heads: BinaryHeap::new(),
            chain: if problem.ends().is_some() { Chain::open(a, b) } else { Chain::new(a, b) },
            covered: [vec![false; a], vec![false; b]],
            bare: a + b,
            growth: Vec::new(),
            printed,
            lattice: Lattice::of(&problem),
            problem,
        }
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the matching when it is found.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Matching> {
        while self.rows.len() < self.problem.counts().0 {
            self.look_from(self.rows.len());
            if !may_go_on() {
                return None;
            }
        }
        if self.growth.is_empty() {
            self.tie();
        }
        while self.grow() {
            if !may_go_on() {
                return None;
            }
        }
        Some(self.matching())
    }

    /// Share of the work that is done, from 0 to 1; finding out what is visible is nearly all of it.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.rows.len() as f64 / self.problem.counts().0 as f64
    }

    /// The problem that is being solved.
    #[must_use]
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// Hands over every visible line, once the job is done.
    pub(super) fn take_lattice(&mut self) -> Lattice {
        std::mem::take(&mut self.lattice)
    }

    fn look_from(&mut self, from: usize) {
        let vertices = 0..self.problem.counts().1;
        let mut row = ranked_lines(&self.problem, &self.wedges, &mut self.sight, from, vertices);
        for Candidate { line, .. } in &row {
            self.best[0][from] = self.best[0][from].max(line.value);
            self.best[1][line.to] = self.best[1][line.to].max(line.value);
        }
        let cells: Vec<(i64, f64)> = row.iter().map(|c| (c.line.lifted, c.line.value)).collect();
        self.lattice.push_row(&cells);
        self.heads.extend(row.pop().map(Head));
        self.rows.push(row);
    }

    /// Takes the lines that join the ends of open outlines, where they have to be joined and see each other.
    fn tie(&mut self) {
        for (from, to) in self.problem.tied().into_iter().flatten() {
            let value = self.lattice.row(from).at(to as i64);
            let line = RulingLine { from, to, lifted: to as i64, value };
            if value > f64::NEG_INFINITY && self.chain.admits(from, line.lifted) {
                self.accept(line);
            }
        }
    }

    fn accept(&mut self, line: RulingLine) {
        self.chain.insert(line.from, line.lifted);
        self.cover(0, line.from);
        self.cover(1, line.to);
        self.growth.push(line);
    }

    /// Takes some candidates; returns whether there is more to do.
    fn grow(&mut self) -> bool {
        for _ in 0..POPS_BETWEEN_LOOKS {
            if self.bare == 0 {
                return false;
            }
            let Some(Head(candidate)) = self.heads.pop() else { return false };
            let line = candidate.line;
            self.heads.extend(self.rows[line.from].pop().map(Head));
            let is_tied = self.problem.tied().is_some_and(|tied| tied.contains(&(line.from, line.to)));
            let is_valid = if is_tied {
                false
            } else if self.printed.order {
                self.chain.admits_as_printed(line.from, line.to)
            } else {
                self.chain.admits(line.from, line.lifted)
            };
            if is_valid {
                self.accept(line);
                if self.printed.stop {
                    return false;
                }
            }
        }
        true
    }

    fn cover(&mut self, outline: usize, vertex: usize) {
        let covered = &mut self.covered[outline][vertex];
        self.bare -= usize::from(!*covered);
        *covered = true;
    }

    fn matching(&mut self) -> Matching {
        let (a, b) = self.problem.counts();
        let prune = if self.printed.removal { prune_as_printed } else { prune };
        let kept = prune(&self.growth, a, b);
        let order = order_by_pair(kept.len(), |i| [kept[i].from as i64, kept[i].lifted]);
        let lines: Vec<RulingLine> = order.into_iter().map(|i| kept[i]).collect();
        let bound = Bound::of(&self.problem, &self.best, &lines);
        let totals = measure(&self.problem, &lines, bound);
        let orphans = self
            .best
            .each_ref()
            .map(|best| (0..best.len()).filter(|&vertex| best[vertex] == f64::NEG_INFINITY).collect());
        Matching { lines, growth: std::mem::take(&mut self.growth), orphans, totals }
    }
}

/// The best candidate left of one row; the greatest in the heap is the best of all.
#[derive(Debug)]
struct Head(Candidate);

impl PartialEq for Head {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Head {}

impl PartialOrd for Head {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Head {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.compare(&other.0)
    }
}
