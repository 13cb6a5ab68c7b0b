//! The lines that one vertex could have, best first.

use super::Problem;
use super::visibility::{Sight, Wedge};
use super::{Layout, RulingLine};
use std::cmp::Ordering;
use std::ops::Range;

/// A visible line with its place in the greedy order.
#[derive(Debug, Clone, Copy)]
pub(super) struct Candidate {
    rank: (f64, f64),
    pub(super) line: RulingLine,
}

impl Candidate {
    /// Orders the better candidate as the greater one: by value, then by the tie rule, then by the lower vertices.
    pub(super) fn compare(&self, other: &Self) -> Ordering {
        let vertices = |c: &Self| (c.line.from, c.line.to);
        self.rank
            .0
            .total_cmp(&other.rank.0)
            .then_with(|| other.rank.1.total_cmp(&self.rank.1))
            .then_with(|| vertices(other).cmp(&vertices(self)))
    }
}

/// The wedges at all vertices of both outlines, which tell most blocked lines at a glance.
#[derive(Debug, Clone)]
pub(super) struct Wedges([Vec<Wedge>; 2]);

impl Wedges {
    pub(super) fn new(problem: &Problem) -> Self {
        Self(
            problem
                .outlines()
                .each_ref()
                .map(|outline| (0..outline.len()).map(|vertex| Wedge::new(outline, vertex)).collect()),
        )
    }

    /// Tells whether a line leaves one of its ends away from the band: it then meets a polygon farther on. Where
    /// the projections cross, a line that meets no edge stays inside exactly one polygon if it starts so at both ends. Between open
    /// curves a line that starts into their region and meets none of its borders stays inside it.
    fn leave_band(&self, problem: &Problem, from: usize, to: usize) -> bool {
        let ends = [problem.outlines()[0].points[from], problem.outlines()[1].points[to]];
        let wedges = [&self.0[0][from], &self.0[1][to]];
        let leaves = |inner: usize| {
            wedges[inner].points_inside(ends[1 - inner]) || wedges[1 - inner].points_outside(ends[inner])
        };
        let stays = |inner: usize| {
            wedges[inner].points_outside(ends[1 - inner]) && wedges[1 - inner].points_inside(ends[inner])
        };
        match problem.layout() {
            Layout::FirstInside => leaves(0),
            Layout::SecondInside => leaves(1),
            Layout::Crossing | Layout::Loose => !stays(0) && !stays(1),
            Layout::Strip { left } => {
                let is_end = |vertex: usize, count: usize| vertex == 0 || vertex + 1 == count;
                let (a, b) = problem.counts();
                if is_end(from, a) && is_end(to, b) {
                    return !problem.is_visible(from, to);
                }
                !stays(usize::from(left)) || !problem.clears_ends(from, to)
            }
        }
    }
}

/// Yields the lines that vertex `from` of the first outline could have to some vertices of the second, in their order; lines
/// without a value are none.
pub(super) fn visible_lines(
    problem: &Problem,
    wedges: &Wedges,
    sight: &mut Sight,
    from: usize,
    vertices: impl Iterator<Item = usize>,
) -> impl Iterator<Item = RulingLine> {
    vertices.filter(move |&to| !wedges.leave_band(problem, from, to) && sight.is_clear(from, to)).map(
        move |to| {
            let value = problem.value(from, to);
            RulingLine { from, to, lifted: problem.lift(from, to), value }
        },
    )
}

/// Returns the lines that a vertex of the first outline could have to some vertices of the second in greedy order, the best last.
pub(super) fn ranked_lines(
    problem: &Problem,
    wedges: &Wedges,
    sight: &mut Sight,
    from: usize,
    vertices: Range<usize>,
) -> Vec<Candidate> {
    let mut candidates: Vec<Candidate> = visible_lines(problem, wedges, sight, from, vertices)
        .map(|line| Candidate { rank: problem.rank(line.from, line.to, line.value), line })
        .collect();
    candidates.sort_unstable_by(Candidate::compare);
    candidates
}
