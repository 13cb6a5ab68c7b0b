//! The best matching without redundant lines.

use super::lattice::{ABSENT, Lattice, Survey};
use super::{Problem, RulingLine};

/// Returns the lines of the greatest sum of f among matchings without redundant lines (both of whose ends have another
/// line), in cyclic order; `None` when no matching keeps the constraints, and of open outlines.
///
/// On the lattice such a matching never turns from a step (1, 0) to a step (0, 1) or back, so a state for each last
/// step is kept. Paths that meet may not exchange their ends here, which rules out divide and conquer: every start is tried with
/// each first step, in a time of the order of a b k for k starts. It likes long fans; see the remarks on objectives in
/// [`Objective`](super::Objective) for what to prefer.
#[must_use]
pub fn irredundant(problem: &Problem) -> Option<Vec<RulingLine>> {
    if problem.ends().is_some() {
        return None;
    }
    let mut survey = Survey::new(problem);
    while survey.advance(problem) {}
    let lattice = survey.take();
    let row = lattice.sparsest_row();
    let starts: Vec<i64> = lattice.row(row).columns().collect();
    let tries = starts.iter().flat_map(|&start| STEPS.map(|first| (start, first)));
    let best = tries
        .filter_map(|(start, first)| from_start(&lattice, row, start, first))
        .reduce(|best, next| if next.0 > best.0 { next } else { best })?;
    let mut lines: Vec<RulingLine> = best.1.iter().map(|&(row, column)| lattice.line(row, column)).collect();
    lines.sort_unstable_by_key(|line| (line.from, line.lifted));
    Some(lines)
}

/// Numbers of the steps (1, 1), (1, 0) and (0, 1): states by the last step to a cell.
const STEPS: [usize; 3] = [0, 1, 2];

/// Whether a step may follow another: not one along the other outline.
fn may_follow(last: usize, next: usize) -> bool {
    last == 0 || next == 0 || last == next
}

type Cell = (usize, i64);

/// The best path from a cell to its translate that begins with a given step: its sum and its cells, the end not repeated.
fn from_start(lattice: &Lattice, row: usize, start: i64, first: usize) -> Option<(f64, Vec<Cell>)> {
    let (a, b) = lattice.counts();
    let width = b + 1;
    // Sums by state, and the state before, of the cells (row + k, start + l).
    let mut sums = vec![[ABSENT; 3]; (a + 1) * width];
    let mut before = vec![[0_u8; 3]; (a + 1) * width];
    let at = |k: usize, l: usize| k * width + l;
    for k in 0..=a {
        let cells = lattice.row(row + k);
        for l in 0..width {
            let value = cells.at(start + l as i64);
            if value == ABSENT || k + l == 0 {
                continue;
            }
            for step in STEPS {
                let (dk, dl) = (usize::from(step != 2), usize::from(step != 1));
                if k < dk || l < dl {
                    continue;
                }
                let from = at(k - dk, l - dl);
                let (mut best, mut last) = (ABSENT, 0);
                if from == 0 {
                    if step == first {
                        best = 0.0;
                    }
                } else {
                    for state in STEPS {
                        if may_follow(state, step) && sums[from][state] > best {
                            (best, last) = (sums[from][state], state);
                        }
                    }
                }
                sums[at(k, l)][step] = best + value;
                before[at(k, l)][step] = last as u8;
            }
        }
    }
    let (mut k, mut l) = (a, b);
    let ends = STEPS.map(|last| if may_follow(last, first) { sums[at(k, l)][last] } else { ABSENT });
    let mut state =
        STEPS.into_iter().reduce(|best, step| if ends[step] > ends[best] { step } else { best })?;
    if ends[state] == ABSENT {
        return None;
    }
    let sum = ends[state];
    let mut path = Vec::new();
    while k + l > 0 {
        let last = usize::from(before[at(k, l)][state]);
        (k, l) = (k - usize::from(state != 2), l - usize::from(state != 1));
        path.push((row + k, start + l as i64));
        state = last;
    }
    Some((sum, path))
}

#[cfg(test)]
mod tests {
    use super::super::test_shapes::{Numbers, random_problem};
    use super::super::{Bound, measure};
    use super::*;
    use std::collections::BTreeSet;

    /// Redundant lines of a set.
    fn redundant(lines: &[RulingLine]) -> usize {
        let degree = |same: &dyn Fn(&RulingLine) -> bool| lines.iter().filter(|line| same(line)).count();
        let is_redundant =
            |line: &&RulingLine| degree(&|l| l.from == line.from) > 1 && degree(&|l| l.to == line.to) > 1;
        lines.iter().filter(is_redundant).count()
    }

    /// The best sum of a cover by stars, by trying every closed path on the lattice.
    fn by_enumeration(problem: &Problem) -> Option<f64> {
        let mut survey = Survey::new(problem);
        while survey.advance(problem) {}
        let lattice = survey.take();
        let (a, b) = lattice.counts();
        let mut best: Option<f64> = None;
        for start in lattice.row(0).columns() {
            let mut stack = vec![vec![(0, start)]];
            while let Some(path) = stack.pop() {
                let (row, column) = path[path.len() - 1];
                if (row, column) == (a, start + b as i64) {
                    let lines: Vec<RulingLine> =
                        path[1..].iter().map(|&(row, column)| lattice.line(row, column)).collect();
                    if redundant(&lines) == 0 {
                        let sum = lines.iter().map(|line| line.value).sum::<f64>();
                        best = Some(best.map_or(sum, |best| best.max(sum)));
                    }
                    continue;
                }
                for (next_row, next_column) in [(row + 1, column), (row, column + 1), (row + 1, column + 1)] {
                    let is_inside = next_row <= a && next_column <= start + b as i64;
                    if is_inside && lattice.row(next_row).at(next_column) != ABSENT {
                        let mut longer = path.clone();
                        longer.push((next_row, next_column));
                        stack.push(longer);
                    }
                }
            }
        }
        best
    }

    #[test]
    fn equals_enumeration() {
        let mut numbers = Numbers(91);
        let mut feasible = 0;
        for case in 0..150 {
            let problem = random_problem(&mut numbers, 3, 6);
            let found = irredundant(&problem).map(|lines| lines.iter().map(|line| line.value).sum::<f64>());
            let expected = by_enumeration(&problem);
            feasible += usize::from(expected.is_some());
            match (found, expected) {
                (Some(found), Some(expected)) => {
                    assert!((found - expected).abs() <= 1e-9 * expected.abs().max(1.0), "case {case}");
                }
                (found, expected) => assert_eq!(found, expected, "case {case}"),
            }
        }
        assert!(feasible > 80, "{feasible}");
    }

    #[test]
    fn no_line_is_redundant_and_every_vertex_has_one() {
        let mut numbers = Numbers(17);
        for case in 0..60 {
            let problem = random_problem(&mut numbers, 4, 20);
            let Some(lines) = irredundant(&problem) else { continue };
            let (a, b) = problem.counts();
            let totals = measure(&problem, &lines, Bound::new(&problem, &[vec![1.0; a], vec![1.0; b]]));
            let froms: BTreeSet<usize> = lines.iter().map(|line| line.from).collect();
            assert_eq!((redundant(&lines), froms.len()), (0, a), "case {case}");
            assert_eq!((totals.crossings, totals.blocked), (0, 0), "case {case}");
            assert!(totals.integral.is_some(), "case {case}");
        }
    }
}
