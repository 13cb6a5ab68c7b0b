//! The optimum of J on the curves themselves.

use super::exact::Objective;
use super::lattice::Survey;
use super::path::{Path, PathFinder};
use super::rounds::Rounds;
use super::{Outline, Problem, Weights};
use crate::curve::{ClosedBSpline, Scheme, sample};

/// Samples of each curve at the first level: fine enough that the best path runs where the optimum on the curves does.
const FIRST_COUNT: usize = 160;
/// Samples of each curve beyond which the search ends whatever has been reached.
const MOST_SAMPLES: usize = 2560;
/// Relative change from one level to the next below which the search ends.
const SMALL_CHANGE: f64 = 1e-4;
/// Columns looked at beside the path of the level before: three of its cells.
const HALF_WIDTH: i64 = 6;

/// The matching of greatest J of two curves, as far as it was refined.
#[derive(Debug, Clone, PartialEq)]
pub struct Refined {
    /// J* by the trapezoid rule on the last level.
    pub integral: f64,
    /// Relative change of J* at the last doubling of the samples; `None` when there was only one level.
    pub change: Option<f64>,
    /// Samples of each curve at the last level.
    pub count: usize,
    /// The correspondence once round: places in shares of arc length on both curves, ascending together, weakly, straight between
    /// one and the next. The first again, one lap on, is not repeated.
    pub places: Vec<[f64; 2]>,
}

/// Finds the matching of greatest J on the curves themselves, as a job that advances in steps.
///
/// J is the integral of f over mu, the mean of the shares of arc length on both curves. The best closed path on a lattice of samples
/// evenly spread by arc length is found exactly; then the samples are doubled, again and again, and the best path is sought beside the
/// last one, until J changes by less than a ten-thousandth. Where curves are smooth the error falls with the square of the
/// number of samples.
#[derive(Debug)]
pub struct Refine {
    curves: [ClosedBSpline; 2],
    weights: Weights,
    gap: f64,
    finder: PathFinder,
    level: Option<Level>,
    last: Option<(Problem, Path, Refined)>,
}

#[derive(Debug)]
struct Level {
    problem: Problem,
    survey: Survey,
    rounds: Option<Rounds>,
}

impl Refine {
    /// A job that has not begun, for two counter-clockwise curves; `gap` is the distance between their planes.
    #[must_use]
    pub fn new(curves: [ClosedBSpline; 2], weights: Weights, gap: f64) -> Self {
        Self { curves, weights, gap, finder: PathFinder::default(), level: None, last: None }
    }

    /// Advances while `may_go_on` says so, at least by a little. Returns the optimum when it is found, or an inner `None` when
    /// samples of the curves cannot be matched.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Option<Refined>> {
        loop {
            let Some(level) = &mut self.level else {
                match self.next_level() {
                    Some(level) => self.level = Some(level),
                    None => return Some(self.last.as_ref().map(|last| last.2.clone())),
                }
                if !may_go_on() {
                    return None;
                }
                continue;
            };
            let rounds = loop {
                if let Some(rounds) = &mut level.rounds {
                    break rounds;
                }
                if !level.survey.advance(&level.problem) {
                    let rule = Objective::Integral.rule();
                    level.rounds = Some(Rounds::new(level.survey.lattice(), rule));
                }
                if !may_go_on() {
                    return None;
                }
            };
            while rounds.advance(level.survey.lattice(), &mut self.finder) {
                if !may_go_on() {
                    return None;
                }
            }
            let path = rounds.best().cloned();
            if self.take(path) {
                return Some(self.last.as_ref().map(|last| last.2.clone()));
            }
        }
    }

    /// Takes the result of the level; returns whether the search has ended.
    fn take(&mut self, path: Option<Path>) -> bool {
        let (Some(level), Some(path)) = (self.level.take(), path) else { return true };
        let integral = path.value;
        let before = self.last.as_ref().map(|last| last.2.integral);
        let change = before.map(|before| ((integral - before) / integral).abs());
        let count = level.problem.counts().0;
        let share = |k: f64| k / count as f64;
        let places = path.cells().map(|(row, column)| [share(row as f64), share(column as f64)]).collect();
        let has_ended = change.is_some_and(|change| change < SMALL_CHANGE);
        self.last = Some((level.problem, path, Refined { integral, change, count, places }));
        has_ended
    }

    /// The level after the last one; `None` when there is none or its samples cannot be matched.
    fn next_level(&self) -> Option<Level> {
        let outlines = |count: usize| {
            self.curves.each_ref().map(|curve| Outline::from(&sample(curve, Scheme::ArcLength, count)))
        };
        let (problem, survey) = match &self.last {
            None => {
                let problem = Problem::new(outlines(FIRST_COUNT), self.weights, self.gap).ok()?;
                let survey = Survey::new(&problem);
                (problem, survey)
            }
            Some((last, path, refined)) => {
                let count = 2 * refined.count;
                if count > MOST_SAMPLES {
                    return None;
                }
                let problem = last.resampled(outlines(count)).ok()?;
                let survey = Survey::within(&problem, band(path, refined.count));
                (problem, survey)
            }
        };
        Some(Level { problem, survey, rounds: None })
    }
}

/// First and last column of each row of twice as many samples, beside a closed path among `count` samples.
fn band(path: &Path, count: usize) -> Vec<(i64, i64)> {
    let lap = count as i64;
    let mut spans = vec![(0, 0); count];
    for (k, &(first, last)) in path.columns[..count].iter().enumerate() {
        let (row, laps) = ((path.row + k) % count, ((path.row + k) / count) as i64);
        spans[row] = (first - laps * lap, last - laps * lap);
    }
    // The row of the start is passed at both ends of the path.
    let (row, laps) = (path.row % count, (path.row / count) as i64);
    spans[row].0 = path.columns[count].0 - (laps + 1) * lap;
    let pairs = (0..count).map(|row| {
        let next = if row + 1 < count { spans[row + 1].0 } else { spans[0].0 + lap };
        let (first, last) = spans[row];
        [(2 * first - HALF_WIDTH, 2 * last + HALF_WIDTH), (2 * last - HALF_WIDTH, 2 * next + HALF_WIDTH)]
    });
    pairs.flatten().collect()
}
