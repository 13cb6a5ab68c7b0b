//! What a set of lines is worth, and whether it keeps the constraints.

use super::{Ends, Outline, Problem, RulingLine};
use crate::geom::segments_meet;
use std::ops::Range;

/// Figures of a set of ruling lines.
///
/// A sum grows with the number of lines and shrinks with the square of the size; compare `eta`, which does neither.
#[derive(Debug, Clone, PartialEq)]
pub struct Totals {
    /// Number of lines.
    pub count: usize,
    /// Sum of their values f (Eq. 10 of the paper, over the lines kept).
    pub sum: f64,
    /// Mean of their values; `None` without lines.
    pub mean: Option<f64>,
    /// J: the integral of f along the matching, the mean over both curves of their share of arc length, by the trapezoid
    /// rule between neighbouring lines; `None` when a vertex has no line.
    pub integral: Option<f64>,
    /// J over its upper bound by the same rule, at most 1; `None` when J is, or when the bound is not positive.
    pub eta: Option<f64>,
    /// Pairs of lines that cross, counted by looking at every pair.
    pub crossings: usize,
    /// Lines that meet a polygon, counted by looking at every edge; where projections cross, also those that leave the band between them.
    pub blocked: usize,
    /// Vertices of each outline without a line; where ends are free, only those between the first and the last line.
    pub uncovered: [Vec<usize>; 2],
}

/// An upper bound of J over every matching of the same samples, or of a part of them: each vertex with its best visible partner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound(f64);

impl Bound {
    /// Computes the bound from the greatest value of a visible line at each vertex of each outline.
    #[must_use]
    pub fn new(problem: &Problem, best: &[Vec<f64>; 2]) -> Self {
        Self::along(problem, best, [(0, usize::MAX); 2])
    }

    /// Computes the bound over what `lines` reach: all of closed outlines, and of open ones with free ends the stretches from the first line
    /// to the last.
    #[must_use]
    pub fn of(problem: &Problem, best: &[Vec<f64>; 2], lines: &[RulingLine]) -> Self {
        match (problem.ends(), lines) {
            (Some(Ends::Free), [first, .., last]) => {
                Self::along(problem, best, [(first.from, last.from), (first.to, last.to)])
            }
            _ => Self::new(problem, best),
        }
    }

    /// The bound over the edges between two vertices of each outline.
    fn along(problem: &Problem, best: &[Vec<f64>; 2], spans: [(usize, usize); 2]) -> Self {
        let halves =
            problem.outlines().iter().zip(best).zip(spans).map(|((outline, best), (first, last))| {
                let next = best.iter().cycle().skip(1);
                let ends = best.iter().zip(next).map(|(f, g)| (f + g) / 2.0);
                let edges = outline.shares.iter().zip(ends).enumerate();
                let inside = edges.filter(|(k, (share, _))| (first..last).contains(k) && **share > 0.0);
                inside.map(|(_, (share, f))| share * f).sum::<f64>() / 2.0
            });
        Self(halves.sum())
    }

    /// The bound itself; minus infinity when a vertex sees nothing.
    #[must_use]
    pub fn value(self) -> f64 {
        self.0
    }
}

/// Measures lines given in cyclic order (ascending `from`, then ascending `lifted`).
///
/// Crossings and blocked lines are counted on the lines as segments, independently of how the lines were found.
#[must_use]
pub fn measure(problem: &Problem, lines: &[RulingLine], bound: Bound) -> Totals {
    let sum: f64 = lines.iter().map(|line| line.value).sum();
    let uncovered = uncovered(problem, lines);
    let covered = uncovered.iter().all(Vec::is_empty);
    let integral = covered.then(|| integral(problem, lines));
    Totals {
        count: lines.len(),
        sum,
        mean: (!lines.is_empty()).then(|| sum / lines.len() as f64),
        integral,
        eta: integral.filter(|_| bound.value() > 0.0).map(|integral| integral / bound.value()),
        crossings: crossings(problem, lines),
        blocked: lines.iter().filter(|line| !problem.is_visible(line.from, line.to)).count(),
        uncovered,
    }
}

fn uncovered(problem: &Problem, lines: &[RulingLine]) -> [Vec<usize>; 2] {
    let (a, b) = problem.counts();
    let mut covered = [vec![false; a], vec![false; b]];
    for line in lines {
        covered[0][line.from] = true;
        covered[1][line.to] = true;
    }
    let reached = reached(problem, lines);
    [0, 1].map(|outline| reached[outline].clone().filter(|&vertex| !covered[outline][vertex]).collect())
}

/// Vertices of each outline beyond the first and the last line, which free ends leave out.
#[must_use]
pub fn left_out(problem: &Problem, lines: &[RulingLine]) -> [Vec<usize>; 2] {
    let (a, b) = problem.counts();
    let [first, second] = reached(problem, lines);
    [(first, a), (second, b)].map(|(reached, count)| (0..reached.start).chain(reached.end..count).collect())
}

/// Vertices of each outline that lines have to reach: all of them, or where the ends are free those from the first line to the last.
fn reached(problem: &Problem, lines: &[RulingLine]) -> [Range<usize>; 2] {
    let (a, b) = problem.counts();
    match (problem.ends(), lines) {
        (Some(Ends::Free), [first, .., last]) => [first.from..last.from + 1, first.to..last.to + 1],
        _ => [0..a, 0..b],
    }
}

/// J of lines that cover every vertex: a step from one line to the next moves on by at most one edge on each outline, and
/// weighs half the share of arc length of each edge passed.
fn integral(problem: &Problem, lines: &[RulingLine]) -> f64 {
    let (a, b) = problem.counts();
    let [first, second] = problem.outlines();
    let next = lines.iter().cycle().skip(1);
    let gaps = if problem.ends().is_some() { lines.len() - 1 } else { lines.len() };
    lines
        .iter()
        .zip(next)
        .take(gaps)
        .map(|(line, next)| {
            let steps = |from: usize, to: usize, n: usize| (to + n - from) % n;
            let on_first = (0..steps(line.from, next.from, a)).map(|k| first.shares[(line.from + k) % a]);
            let on_second = (0..steps(line.to, next.to, b)).map(|k| second.shares[(line.to + k) % b]);
            let mass = (on_first.sum::<f64>() + on_second.sum::<f64>()) / 2.0;
            mass * (line.value + next.value) / 2.0
        })
        .sum()
}

fn crossings(problem: &Problem, lines: &[RulingLine]) -> usize {
    let later = |k: usize| lines[k + 1..].iter();
    let crossed = |k: usize| later(k).filter(|other| cross(problem.outlines(), &lines[k], other)).count();
    (0..lines.len()).map(crossed).sum()
}

/// Tells of each line whether it meets a polygon or has more than an end in common with another line.
#[must_use]
pub fn broken(problem: &Problem, lines: &[RulingLine]) -> Vec<bool> {
    let mut broken: Vec<bool> = lines.iter().map(|line| !problem.is_visible(line.from, line.to)).collect();
    for (k, line) in lines.iter().enumerate() {
        for (l, other) in lines.iter().enumerate().skip(k + 1) {
            if !(broken[k] && broken[l]) && cross(problem.outlines(), line, other) {
                broken[k] = true;
                broken[l] = true;
            }
        }
    }
    broken
}

/// Tells whether two lines have more than an end in common.
pub(super) fn cross([first, second]: &[Outline; 2], line: &RulingLine, other: &RulingLine) -> bool {
    let ends = |line: &RulingLine| (first.points[line.from], second.points[line.to]);
    let ((p, q), (r, s)) = (ends(line), ends(other));
    match (line.from == other.from, line.to == other.to) {
        (true, true) => true,
        // Lines from a common end overlap only when the end of one lies on the other.
        (true, false) => segments_meet(p, q, s, s) || segments_meet(r, s, q, q),
        (false, true) => segments_meet(p, q, r, r) || segments_meet(r, s, p, p),
        (false, false) => segments_meet(p, q, r, s),
    }
}
