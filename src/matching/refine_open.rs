//! The optimum of J between open curves, on the curves themselves.

use super::lattice::Survey;
use super::level::Level;
use super::path::{Path, PathFinder};
use super::refine::Refined;
use super::{Ends, Outline, Problem, Weights};
use crate::curve::{BSpline, Scheme, sample};

/// Samples of each curve at the first level: fine enough that the best path runs where the optimum on the curves does.
const FIRST_COUNT: usize = 160;
/// Samples of each curve beyond which the search ends whatever has been reached.
const MOST_SAMPLES: usize = 5120;
/// Rows and columns looked at on either side of the path of the level before, which has half as many.
const HALF_WIDTH: usize = 4;

/// Finds the matching of greatest J between two open curves, as a job that advances in steps.
///
/// The best path on a lattice of samples evenly spread by arc length is found exactly; then the edges between samples are halved, again and
/// again, and the best path is sought beside the last one, until J changes by less than a ten-thousandth. Samples of one level stay on the
/// next, both ends with them.
#[derive(Debug)]
pub(super) struct RefineOpen {
    curves: [BSpline; 2],
    weights: Weights,
    gap: f64,
    ends: Ends,
    finder: PathFinder,
    level: Option<Level>,
    last: Option<(Path, Refined)>,
}

impl RefineOpen {
    /// A job that has not begun, for two curves that run in the direction in which they are matched.
    pub(super) fn new(curves: [BSpline; 2], weights: Weights, gap: f64, ends: Ends) -> Self {
        Self { curves, weights, gap, ends, finder: PathFinder::default(), level: None, last: None }
    }

    /// Advances while `may_go_on` says so, at least by a little. Returns the optimum when it is found, or an inner `None` when
    /// samples of the curves cannot be matched.
    pub(super) fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Option<Refined>> {
        loop {
            let Some(level) = &mut self.level else {
                match self.next_level() {
                    Some(level) => self.level = Some(level),
                    None => return Some(self.last.take().map(|last| last.1)),
                }
                if !may_go_on() {
                    return None;
                }
                continue;
            };
            let path = level.step(&mut self.finder, may_go_on)?;
            if self.take(path) {
                return Some(self.last.take().map(|last| last.1));
            }
        }
    }

    /// Takes the result of the level; returns whether the search has ended.
    fn take(&mut self, path: Option<Path>) -> bool {
        let (Some(level), Some(path)) = (self.level.take(), path) else { return true };
        let before = self.last.as_ref().map(|last| last.1.integral);
        let (_, mut refined) = level.end(&path);
        refined.change = before.map(|before| ((refined.integral - before) / refined.integral).abs());
        let has_ended = refined.has_settled();
        self.last = Some((path, refined));
        has_ended
    }

    /// The level after the last one; `None` when there is none or its samples cannot be matched.
    fn next_level(&self) -> Option<Level> {
        let outlines = |count: usize| {
            self.curves.each_ref().map(|curve| Outline::from(&sample(curve, Scheme::ArcLength, count)))
        };
        let (problem, survey) = match &self.last {
            None => {
                let problem = Problem::open(outlines(FIRST_COUNT), self.weights, self.gap, self.ends).ok()?;
                let survey = Survey::new(&problem);
                (problem, survey)
            }
            Some((path, refined)) => {
                let count = refined.problem.counts().0;
                let finer = 2 * count - 1;
                if finer > MOST_SAMPLES {
                    return None;
                }
                let problem = refined.problem.resampled(outlines(finer)).ok()?;
                let survey = Survey::within(&problem, band(path, count));
                (problem, survey)
            }
        };
        Some(Level::new(problem, survey))
    }
}

/// First and last column of each row of the samples and those between them, beside a path from end to end among `count` samples, beyond
/// which its first and its last column go on.
fn band(path: &Path, count: usize) -> Vec<(i64, i64)> {
    let columns = &path.columns;
    let (begin, end) = (columns[0].0, columns[columns.len() - 1].1);
    let at = |row: i64| match usize::try_from(row - path.row as i64) {
        Err(_) => (begin, begin),
        Ok(k) => columns.get(k).copied().unwrap_or((end, end)),
    };
    let (width, last) = (HALF_WIDTH as i64, 2 * count as i64 - 2);
    let inside = |at: i64| at.clamp(0, last);
    let span = |row: i64| {
        let (half, odd) = (inside(row) / 2, inside(row) % 2);
        if odd == 0 { (2 * at(half).0, 2 * at(half).1) } else { (2 * at(half).1, 2 * at(half + 1).0) }
    };
    (0..=last).map(|row| (inside(span(row - width).0 - width), inside(span(row + width).1 + width))).collect()
}
