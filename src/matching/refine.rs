//! The optimum of J on the curves themselves.

use super::even::spread_evenly;
use super::exact::Objective;
use super::lattice::Survey;
use super::path::{Path, PathFinder, lines_of};
use super::place::end_at;
use super::rounds::Rounds;
use super::{Ends, Outline, Problem, RulingLine, Weights};
use crate::curve::{ClosedBSpline, Scheme, sample};

/// Samples of each curve at the first level: fine enough that the best path runs where the optimum on the curves does.
const FIRST_COUNT: usize = 160;
/// Samples of each curve beyond which the search ends whatever has been reached.
const MOST_SAMPLES: usize = 5120;
/// Relative change from one level to the next below which the search ends.
const SMALL_CHANGE: f64 = 1e-4;
/// Rows and columns looked at on either side of the path of the level before, which has half as many.
const HALF_WIDTH: usize = 4;

/// The matching of greatest J of two curves, as far as it was refined.
#[derive(Debug, Clone)]
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
    /// The samples of the last level, between which every straight piece of the correspondence is a visible line.
    pub problem: Problem,
}

/// Places `count` lines evenly along a correspondence of two curves, strictly one to one; `fineness` is the step, in shares of arc
/// length, within which the correspondence is the best one.
///
/// Each line is moved along its anti-diagonal to the top of the parabola through the values there and a step to either side,
/// when the top is near and higher: where the order of the lines does not bind it, the optimum lies there.
#[must_use]
pub fn even_places(
    curves: &[ClosedBSpline; 2],
    problem: &Problem,
    places: &[[f64; 2]],
    count: usize,
    fineness: f64,
) -> Vec<[f64; 2]> {
    let arc_lengths = curves.each_ref().map(ClosedBSpline::arc_length);
    let value = |[x, y]: [f64; 2], by: f64| {
        let end = |axis: usize, share: f64| end_at(&curves[axis], &arc_lengths[axis], share);
        problem.value_between(end(0, x + by), end(1, y - by))
    };
    spread_evenly(places, problem.ends().is_none(), count, |place| {
        let (before, here, after) = (value(place, -fineness), value(place, 0.0), value(place, fineness));
        let top = fineness * (before - after) / (2.0 * (before - 2.0 * here + after));
        if top.abs() <= 2.0 * fineness && value(place, top) > here { top } else { 0.0 }
    })
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
    /// Of open curves.
    ends: Option<Ends>,
    finder: PathFinder,
    level: Option<Level>,
    last: Option<(Path, Refined)>,
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
        Self { curves, weights, gap, ends: None, finder: PathFinder::default(), level: None, last: None }
    }

    /// A job that has not begun, for two open curves that run in the direction in which they are matched.
    #[must_use]
    pub fn open(curves: [ClosedBSpline; 2], weights: Weights, gap: f64, ends: Ends) -> Self {
        Self { ends: Some(ends), ..Self::new(curves, weights, gap) }
    }

    /// Advances while `may_go_on` says so, at least by a little. Returns the optimum when it is found, or an inner `None` when
    /// samples of the curves cannot be matched.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Option<Refined>> {
        loop {
            let Some(level) = &mut self.level else {
                match self.next_level() {
                    Some(level) => self.level = Some(level),
                    None => return Some(self.last.as_ref().map(|last| last.1.clone())),
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
                return Some(self.last.as_ref().map(|last| last.1.clone()));
            }
        }
    }

    /// Takes the result of the level; returns whether the search has ended.
    fn take(&mut self, path: Option<Path>) -> bool {
        let (Some(level), Some(path)) = (self.level.take(), path) else { return true };
        let integral = path.value;
        let before = self.last.as_ref().map(|last| last.1.integral);
        let change = before.map(|before| ((integral - before) / integral).abs());
        let count = level.problem.counts().0;
        let lines = lines_of(level.survey.lattice(), path.cells());
        let steps = if self.ends.is_some() { count - 1 } else { count };
        let place = |line: &RulingLine| [line.from as f64, line.lifted as f64].map(|k| k / steps as f64);
        let places = lines.iter().map(place).collect();
        let has_ended = change.is_some_and(|change| change < SMALL_CHANGE);
        self.last = Some((path, Refined { integral, change, count, places, problem: level.problem }));
        has_ended
    }

    /// The level after the last one; `None` when there is none or its samples cannot be matched.
    fn next_level(&self) -> Option<Level> {
        let outlines = |count: usize| {
            self.curves.each_ref().map(|curve| Outline::from(&sample(curve, Scheme::ArcLength, count)))
        };
        let (problem, survey) = match &self.last {
            None => {
                let problem = match self.ends {
                    None => Problem::new(outlines(FIRST_COUNT), self.weights, self.gap),
                    Some(ends) => Problem::open(outlines(FIRST_COUNT), self.weights, self.gap, ends),
                };
                let problem = problem.ok()?;
                let survey = Survey::new(&problem);
                (problem, survey)
            }
            Some((path, refined)) => {
                // Along open curves the samples of before stay, both ends with them.
                let count = 2 * refined.count - usize::from(self.ends.is_some());
                if count > MOST_SAMPLES {
                    return None;
                }
                let problem = refined.problem.resampled(outlines(count)).ok()?;
                let survey = Survey::within(&problem, band(path, refined.count, self.ends.is_some()));
                (problem, survey)
            }
        };
        Some(Level { problem, survey, rounds: None })
    }
}

/// First and last column of each row of twice as many samples, beside a path among `count` samples: a closed one, or one from end to end,
/// beyond which its first and its last column go on.
fn band(path: &Path, count: usize, open: bool) -> Vec<(i64, i64)> {
    let (lap, width) = (count as i64, HALF_WIDTH as i64);
    let mut spans = vec![(0, 0); count];
    let (begin, end) = (path.columns[0].0, path.columns[path.columns.len() - 1].1);
    if open {
        spans = (0..count)
            .map(|row| match row.checked_sub(path.row) {
                None => (begin, begin),
                Some(k) => path.columns.get(k).copied().unwrap_or((end, end)),
            })
            .collect();
    } else {
        for (k, &(first, last)) in path.columns[..count].iter().enumerate() {
            let (row, laps) = ((path.row + k) % count, ((path.row + k) / count) as i64);
            spans[row] = (first - laps * lap, last - laps * lap);
        }
        // The row of the start is passed at both ends of the path.
        let (row, laps) = (path.row % count, (path.row / count) as i64);
        spans[row].0 = path.columns[count].0 - (laps + 1) * lap;
    }
    // Rows of the finer level, from some before the seam to some beyond it, or from the first to the last.
    let last = 2 * lap - 2;
    let inside = |at: i64| if open { at.clamp(0, last) } else { at };
    let span = |row: i64| {
        let row = inside(row);
        let half = row.div_euclid(2);
        let at = |half: i64| {
            let (first, last) = spans[half.rem_euclid(lap) as usize];
            let shift = half.div_euclid(lap) * lap;
            (first + shift, last + shift)
        };
        let (first, last) = at(half);
        if row.rem_euclid(2) == 0 { (2 * first, 2 * last) } else { (2 * last, 2 * at(half + 1).0) }
    };
    let rows = 2 * lap - i64::from(open);
    (0..rows).map(|row| (inside(span(row - width).0 - width), inside(span(row + width).1 + width))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Form;
    use glam::{DVec2, dvec2};
    use std::f64::consts::TAU;

    fn run(curves: &[ClosedBSpline; 2], weights: Weights) -> Refined {
        let mut job = Refine::new(curves.clone(), weights, 0.0);
        loop {
            if let Some(refined) = job.step(&mut || false) {
                break refined.expect("samples that see each other");
            }
        }
    }

    /// A curve through control points at given angles and radii.
    fn curve(count: usize, radius: impl Fn(f64) -> f64) -> ClosedBSpline {
        let point = |k: usize| {
            let angle = TAU * k as f64 / count as f64;
            radius(angle) * DVec2::from_angle(angle)
        };
        ClosedBSpline::new(3, Form::Periodic, (0..count).map(point).collect(), None)
            .expect("a star-shaped curve")
    }

    fn pair() -> [ClosedBSpline; 2] {
        let inner = curve(24, |t| 1.0 + 0.35 * (3.0 * t).cos());
        [inner, curve(30, |t| 2.6 + 0.3 * (4.0 * t + 0.7).sin())]
    }

    fn close(x: f64, y: f64) -> bool {
        (x - y).abs() <= 1e-4 * x.abs()
    }

    /// The same curve with its seam at another control point.
    fn reseamed(curve: &ClosedBSpline, by: usize) -> ClosedBSpline {
        let mut points = curve.points().to_vec();
        points.rotate_left(by);
        ClosedBSpline::new(3, Form::Periodic, points, None).expect("the same curve")
    }

    #[test]
    fn circles_reach_the_closed_form() {
        // A cubic through 200 points is a circle to 1e-9.
        let circles = [curve(200, |_| 1.0), curve(200, |_| 3.0)];
        let refined = run(&circles, Weights::default());
        let [r, s] = circles.each_ref().map(|circle| circle.point(0.0).length());
        let expected = (s - r).powi(-2);
        assert!((refined.integral / expected - 1.0).abs() < 1e-7, "{} {expected}", refined.integral);
        for (x, y) in refined.places.iter().map(|place| (place[0], place[1])) {
            assert!((x - y).abs() < 1e-9, "radial lines: {x} {y}");
        }
        let places = even_places(&circles, &refined.problem, &refined.places, 17, 1e-3);
        let is_even = |(k, [x, y]): (usize, &[f64; 2])| {
            // The wobble of the radius moves the top of a parabola through close values.
            (x - y).abs() < 1e-7 && (x - k as f64 / 17.0).abs() < 1e-7
        };
        assert!(places.iter().enumerate().all(is_even));
    }

    #[test]
    fn the_optimum_knows_no_seam_no_order_and_no_direction() {
        let curves = pair();
        let expected = run(&curves, Weights::default()).integral;
        let seams = [reseamed(&curves[0], 7), reseamed(&curves[1], 19)];
        let [first, second] = curves.clone();
        let mirrored = curves.each_ref().map(|curve| {
            let flip = |p: &DVec2| dvec2(-p.x, p.y);
            let points = curve.points().iter().rev().map(flip).collect();
            ClosedBSpline::new(3, Form::Periodic, points, None).expect("the mirror image")
        });
        for (what, other) in [("seam", seams), ("order", [second, first]), ("direction", mirrored)] {
            let integral = run(&other, Weights::default()).integral;
            assert!(close(expected, integral), "{what}: {expected} {integral}");
        }
    }

    #[test]
    fn without_distance_weight_the_optimum_is_at_most_one() {
        let refined = run(&pair(), Weights { distance: 0.0, ..Weights::default() });
        assert!(refined.integral <= 1.0 && refined.integral > 0.9, "{}", refined.integral);
        assert!(refined.change.is_some_and(|change| change < SMALL_CHANGE));
    }

    #[test]
    fn it_is_at_least_every_lattice_optimum_but_for_the_rule() {
        let curves = pair();
        let refined = run(&curves, Weights::default());
        for count in [44, 100, 200] {
            let outlines =
                curves.each_ref().map(|curve| Outline::from(&sample(curve, Scheme::ArcLength, count)));
            let problem = Problem::new(outlines, Weights::default(), 0.0).expect("nested");
            let optimum =
                super::super::exact(&problem, super::super::ExactOptions::default()).expect("feasible");
            let excess = optimum.value / refined.integral - 1.0;
            assert!(excess < 1e-4 && excess > -10.0 / count as f64, "{count}: {excess}");
        }
    }

    #[test]
    fn curves_that_cannot_be_matched_have_no_optimum() {
        let apart = [curve(24, |_| 1.0), curve(24, |t| if t < 3.0 { 1.2 } else { 0.8 })];
        let mut job = Refine::new(apart, Weights::default(), 0.0);
        assert!(matches!(job.step(&mut || true), Some(None)));
    }
}
