//! The optimum of J on the curves themselves.

use super::course::Course;
use super::even::spread_evenly;
use super::even_open::spread_between;
use super::lattice::Survey;
use super::level::{Level, SMALL_CHANGE};
use super::path::{Path, PathFinder};
use super::place::end_at;
use super::refine_open::RefineOpen;
use super::spacing::{Spacing, corner_shares};
use super::{Ends, Problem, RulingLine, Weights};
use crate::curve::BSpline;

/// Samples of each curve at the first level, without those of corners: fine enough that the best path runs where the optimum on the curves does.
const FIRST_COUNT: usize = 320;
/// Samples of each curve beyond which the search ends whatever has been reached.
const MOST_SAMPLES: usize = 10240;
/// Rows and columns of the level before that are looked at on either side of its path.
const HALF_WIDTH: i64 = 2;
/// The same, at most, where there is no path so near to it.
const WIDEST: i64 = 32;
/// Lines of a vertex from which on the edges beside it are cut into four, and into eight.
const FAN: [usize; 2] = [3, 5];

/// Steps from a corner within which a line is not moved.
const BESIDE: f64 = 4.0;
/// Share of one curve that a single point of the other is joined with in a fan, and how many times as long this is as the edges beside the point.
const FAN_SHARE: f64 = 1.0 / 256.0;
const FAN_SLOPE: f64 = 16.0;

/// The matching of greatest J of two curves, as far as it was refined.
#[derive(Debug, Clone)]
pub struct Refined {
    /// J* by the trapezoid rule on the last level.
    pub integral: f64,
    /// Relative change of J* at the last doubling of the samples, where stretches that had stopped changing are not doubled again and count by
    /// the change when they were; `None` when there was only one level.
    pub change: Option<f64>,
    /// The correspondence once round: places in shares of arc length on both curves, ascending together, weakly, straight between
    /// one and the next. The first again, one lap on, is not repeated.
    pub places: Vec<[f64; 2]>,
    /// Whether the correspondence joins a point with a whole arc, as far as samples tell. One-to-one lines then only come near to J*, with
    /// ends ever closer together.
    pub has_fans: bool,
    /// The samples of the last level, between which every straight piece of the correspondence is a visible line.
    pub problem: Problem,
}

impl Refined {
    /// Tells whether J* has stopped changing.
    pub(super) fn has_settled(&self) -> bool {
        self.change.is_some_and(|change| change < SMALL_CHANGE)
    }
}

/// Places `count` lines evenly along a correspondence of two curves, strictly one to one; `fineness` is the step, in shares of arc
/// length, within which the correspondence is the best one.
///
/// Each line is moved along its anti-diagonal to the top of the parabola through the values there and a step to either side,
/// when the top is near and higher: where the order of the lines does not bind it, the optimum lies there. Lines beside a corner stay,
/// as their values jump there, and none passes to the other side of it.
#[must_use]
pub fn even_places(
    curves: &[BSpline; 2],
    problem: &Problem,
    places: &[[f64; 2]],
    count: usize,
    fineness: f64,
) -> Vec<[f64; 2]> {
    let arc_lengths = curves.each_ref().map(BSpline::arc_length);
    let value = |[x, y]: [f64; 2], by: f64| {
        let end = |axis: usize, share: f64| end_at(&curves[axis], &arc_lengths[axis], share);
        problem.value_between(end(0, x + by), end(1, y - by))
    };
    let corners = [0, 1].map(|axis| corner_shares(&curves[axis], &arc_lengths[axis]));
    let is_beside = |axis: usize, share: f64| {
        let off = |corner: &f64| ((share - corner + 0.5).rem_euclid(1.0) - 0.5).abs();
        corners[axis].iter().any(|corner| off(corner) <= BESIDE * fineness)
    };
    let improve = |place: [f64; 2]| {
        if is_beside(0, place[0]) || is_beside(1, place[1]) {
            return 0.0;
        }
        let (before, here, after) = (value(place, -fineness), value(place, 0.0), value(place, fineness));
        let top = fineness * (before - after) / (2.0 * (before - 2.0 * here + after));
        if top.abs() <= 2.0 * fineness && value(place, top) > here { top } else { 0.0 }
    };
    if problem.ends().is_some() {
        return spread_between(places, count, improve);
    }
    spread_evenly(places, count, &corners, improve)
}

/// Finds the matching of greatest J on the curves themselves, as a job that advances in steps.
///
/// J is the integral of f over mu, the mean of the shares of arc length on both curves. The best closed path on a lattice of samples, dense
/// where the curves bend, is found exactly; then every edge between samples is cut, in two or, beside a fan, in up to eight, and the best path is
/// sought beside the last one, again and again, until J changes by less than a ten-thousandth. After the third level only where J still
/// changes: what stopped changing, by less than half of that all together, stays as it is. A corner is two samples, one for each
/// side of it: a fan keeps to one side, so that J* is the supremum over one-to-one correspondences, to which the normal at the
/// corner itself, a single point, counts for nothing. The error falls with the square of the number of samples.
#[derive(Debug)]
pub struct Refine {
    spacings: [Spacing; 2],
    weights: Weights,
    gap: f64,
    /// What finds the optimum between open curves.
    open: Option<Box<RefineOpen>>,
    finder: PathFinder,
    level: Option<Level>,
    /// Rows and columns of the level before that are looked at on either side of its path.
    width: i64,
    last: Option<Last>,
}

/// What the last level gave.
#[derive(Debug)]
struct Last {
    path: Path,
    lines: Vec<RulingLine>,
    course: Course,
    refined: Refined,
}

impl Refine {
    /// A job that has not begun, for two counter-clockwise curves; `gap` is the distance between their planes.
    #[must_use]
    pub fn new(curves: [BSpline; 2], weights: Weights, gap: f64) -> Self {
        let (spacings, finder) = (curves.each_ref().map(Spacing::new), PathFinder::default());
        Self { spacings, weights, gap, open: None, finder, level: None, width: WIDEST, last: None }
    }

    /// A job that has not begun, for two open curves that run in the direction in which they are matched.
    #[must_use]
    pub fn open(curves: [BSpline; 2], weights: Weights, gap: f64, ends: Ends) -> Self {
        let open = RefineOpen::new(curves.clone(), weights, gap, ends);
        Self { open: Some(Box::new(open)), ..Self::new(curves, weights, gap) }
    }

    /// Advances while `may_go_on` says so, at least by a little. Returns the optimum when it is found, or an inner `None` when
    /// samples of the curves cannot be matched.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Option<Refined>> {
        if let Some(open) = &mut self.open {
            return open.step(may_go_on);
        }
        loop {
            let Some(level) = &mut self.level else {
                match self.next_level(HALF_WIDTH) {
                    Some(level) => self.level = Some(level),
                    None => return Some(self.last.take().map(|last| last.refined)),
                }
                if !may_go_on() {
                    return None;
                }
                continue;
            };
            let path = level.step(&mut self.finder, may_go_on)?;
            if self.take(path) {
                return Some(self.last.take().map(|last| last.refined));
            }
        }
    }

    /// Takes the result of the level; returns whether the search has ended.
    fn take(&mut self, path: Option<Path>) -> bool {
        let Some(level) = self.level.take() else { return true };
        let Some(path) = path else {
            // Finer samples see less of each other: the path may have to go farther round.
            let wider = 4 * self.width;
            self.level = (wider <= WIDEST).then(|| self.next_level(wider)).flatten();
            return self.level.is_none();
        };
        let (lines, mut refined) = level.end(&path);
        let course = match &self.last {
            None => Course::new(&lines, &refined.places),
            Some(last) => last.course.next(&lines, &refined.places),
        };
        refined.change = course.change();
        let has_ended = refined.has_settled();
        self.last = Some(Last { path, lines, course, refined });
        has_ended
    }

    /// The level after the last one; `None` when there is none or its samples cannot be matched.
    fn next_level(&mut self, width: i64) -> Option<Level> {
        let Some(Last { path, lines, course, refined: Refined { problem, places, .. } }) = &self.last else {
            let outlines = self.spacings.each_ref().map(|spacing| spacing.outline(FIRST_COUNT));
            let problem = Problem::new(outlines, self.weights, self.gap).ok()?;
            self.width = WIDEST;
            let survey = Survey::new(&problem);
            return Some(Level::new(problem, survey));
        };
        let counts = problem.counts();
        let parts = parts(lines, &course.unsettled_vertices(lines, places, counts));
        if parts.iter().any(|parts| parts.iter().sum::<usize>() > MOST_SAMPLES) {
            return None;
        }
        let [first, second] =
            [0, 1].map(|axis| self.spacings[axis].finer(&problem.outlines()[axis], &parts[axis]));
        let problem = problem.resampled([first.0, second.0]).ok()?;
        let band = band(path, width, counts, &[first.1, second.1], problem.counts());
        self.width = width;
        let survey = Survey::within(&problem, band);
        Some(Level::new(problem, survey))
    }
}

/// Tells whether a correspondence joins a point of a curve with a whole arc of the other one.
pub(super) fn has_fans(problem: &Problem, lines: &[RulingLine], places: &[[f64; 2]]) -> bool {
    let vertex = |axis: usize, k: usize| if axis == 0 { lines[k].from } else { lines[k].to };
    [0, 1].into_iter().any(|axis| {
        let shares = &problem.outlines()[axis].shares;
        let mut begin = 0;
        (1..=lines.len()).any(|end| {
            let first = vertex(axis, begin);
            if end < lines.len() && vertex(axis, end) == first {
                return false;
            }
            let arc = places[end - 1][1 - axis] - places[begin][1 - axis];
            begin = end;
            let beside = shares[first].max(shares[(first + shares.len() - 1) % shares.len()]);
            arc > FAN_SHARE && arc > FAN_SLOPE * beside
        })
    })
}

/// Into how many parts to cut the edge after each vertex of either outline: whole where J has settled at both of its ends, and beside a
/// vertex with many lines into more than two, so that the place of a fan is found as well as its lines are spread.
fn parts(lines: &[RulingLine], is_unsettled: &[Vec<bool>; 2]) -> [Vec<usize>; 2] {
    let mut degrees = is_unsettled.each_ref().map(|vertices| vec![0; vertices.len()]);
    for line in lines {
        degrees[0][line.from] += usize::from(is_unsettled[0][line.from]);
        degrees[1][line.to] += usize::from(is_unsettled[1][line.to]);
    }
    degrees.map(|degrees| {
        let next = degrees.iter().cycle().skip(1);
        let most = degrees.iter().zip(next).map(|(here, next)| *here.max(next));
        most.map(|most| {
            if most == 0 {
                1
            } else if most < FAN[0] {
                2
            } else if most < FAN[1] {
                4
            } else {
                8
            }
        })
        .collect()
    })
}

/// First and last column of each row of finer samples, beside a closed path among `counts` samples, whose new numbers are `numbers`;
/// `finer` are the new counts.
fn band(
    path: &Path,
    width: i64,
    counts: (usize, usize),
    numbers: &[Vec<usize>; 2],
    finer: (usize, usize),
) -> Vec<(i64, i64)> {
    let (a, b) = (counts.0, counts.1 as i64);
    let mut spans = vec![(0, 0); a];
    for (k, &(first, last)) in path.columns[..a].iter().enumerate() {
        let (row, laps) = ((path.row + k) % a, ((path.row + k) / a) as i64);
        spans[row] = (first - laps * b, last - laps * b);
    }
    // The row of the start is passed at both ends of the path.
    let (row, laps) = (path.row % a, (path.row / a) as i64);
    spans[row].0 = path.columns[a].0 - (laps + 1) * b;
    // Rows from some before the seam to some beyond it.
    let span = |row: i64| {
        let laps = row.div_euclid(a as i64);
        let (first, last) = spans[row.rem_euclid(a as i64) as usize];
        (first + laps * b, last + laps * b)
    };
    let column =
        |old: i64| numbers[1][old.rem_euclid(b) as usize] as i64 + old.div_euclid(b) * finer.1 as i64;
    let mut old = 0;
    (0..finer.0)
        .map(|row| {
            while old + 1 < a && numbers[0][old + 1] <= row {
                old += 1;
            }
            let next = old + usize::from(numbers[0][old] < row);
            let (first, last) = (span(old as i64 - width).0, span(next as i64 + width).1);
            (column(first - width), column(last + width))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::Outline;
    use super::super::level::SMALL_CHANGE;
    use super::*;
    use crate::curve::{Form, Scheme, sample};
    use glam::{DVec2, dvec2};
    use std::f64::consts::TAU;

    fn run(curves: &[BSpline; 2], weights: Weights) -> Refined {
        let mut job = Refine::new(curves.clone(), weights, 0.0);
        loop {
            if let Some(refined) = job.step(&mut || false) {
                break refined.expect("samples that see each other");
            }
        }
    }

    /// A curve through control points at given angles and radii.
    fn curve(count: usize, radius: impl Fn(f64) -> f64) -> BSpline {
        let point = |k: usize| {
            let angle = TAU * k as f64 / count as f64;
            radius(angle) * DVec2::from_angle(angle)
        };
        BSpline::new(3, Form::Periodic, (0..count).map(point).collect(), None).expect("a star-shaped curve")
    }

    fn pair() -> [BSpline; 2] {
        let inner = curve(24, |t| 1.0 + 0.35 * (3.0 * t).cos());
        [inner, curve(30, |t| 2.6 + 0.3 * (4.0 * t + 0.7).sin())]
    }

    fn close(x: f64, y: f64) -> bool {
        (x - y).abs() <= 1e-4 * x.abs()
    }

    /// The same curve with its seam at another control point.
    fn reseamed(curve: &BSpline, by: usize) -> BSpline {
        let mut points = curve.points().to_vec();
        points.rotate_left(by);
        BSpline::new(3, Form::Periodic, points, None).expect("the same curve")
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
            BSpline::new(3, Form::Periodic, points, None).expect("the mirror image")
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

    /// A square of straight pieces between corners, whose seam lies on a side.
    fn square() -> BSpline {
        let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(DVec2::from);
        let mut points: Vec<DVec2> = corners.iter().flat_map(|&corner| [corner; 3]).collect();
        points.rotate_left(1);
        BSpline::new(3, Form::Periodic, points, None).expect("a square")
    }

    #[test]
    fn a_corner_counts_by_its_sides_and_not_by_its_bisector() {
        let curves = [square(), curve(40, |_| 3.0)];
        let refined = run(&curves, Weights::default());
        assert!(refined.has_fans && refined.change.is_some_and(|change| change < SMALL_CHANGE));
        // Plain samples that miss the corners know one-sided normals alone, and lose what lies between the last sample and the corner.
        let lattice = |count: usize| {
            let outlines = [0, 1].map(|axis| sample(&curves[axis], Scheme::ArcLength, count));
            let corners = |u: &f64| (curves[0].point(*u).abs() - DVec2::ONE).length() < 1e-9;
            assert!(!outlines[0].parameters.iter().any(corners), "no sample at a corner");
            let problem = Problem::new(outlines.each_ref().map(Outline::from), Weights::default(), 0.0)
                .expect("nested");
            super::super::exact(&problem, super::super::ExactOptions::default()).expect("feasible").value
        };
        let off = [101, 203, 407].map(|count| (lattice(count) / refined.integral - 1.0).abs());
        assert!(off[2] < off[0] && off[2] < 3e-3, "{off:?}");
    }

    #[test]
    fn curves_that_cannot_be_matched_have_no_optimum() {
        let apart = [curve(24, |_| 1.0), curve(24, |t| if t < 3.0 { 1.2 } else { 0.8 })];
        let mut job = Refine::new(apart, Weights::default(), 0.0);
        assert!(matches!(job.step(&mut || true), Some(None)));
    }
}
