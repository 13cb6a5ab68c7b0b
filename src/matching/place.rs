//! Lines at given places of the curves, verified.

use super::measure::cross;
use super::quadrature::Quadrature;
use super::value::End;
use super::{OneToOne, Outline, Problem, RulingLine, Totals};
use crate::curve::{ArcLength, BSpline};

/// Verifies and measures lines that join given places, as a job that advances line by line.
///
/// The outlines of a problem get the ends of the lines as further vertices. Each line is verified against every edge of
/// them and against every other line; J and its bound are integrals over the curves.
#[derive(Debug)]
pub struct Placing {
    curves: [BSpline; 2],
    arc_lengths: [ArcLength; 2],
    problem: Problem,
    places: Vec<[f64; 2]>,
    lines: Vec<RulingLine>,
    verified: Vec<bool>,
    crossings: usize,
    blocked: usize,
    quadrature: Option<Quadrature>,
    progress: f64,
}

/// Shares of arc length closer than this are one place: a million times rounding error, and far below a pixel.
const SAME: f64 = 1e-10;

impl Placing {
    /// A job that has not begun, on the curves of a problem whose outlines start where the curves do.
    ///
    /// `places` are the ends in shares of arc length on both curves, in cyclic order, strictly ascending on both and within a lap; on open
    /// curves in order from end to end.
    #[must_use]
    pub fn new(curves: &[BSpline; 2], problem: &Problem, places: &[[f64; 2]]) -> Self {
        let arc_lengths = curves.each_ref().map(BSpline::arc_length);
        let mut places = places.to_vec();
        // The first end on the first curve comes first of all in the domain.
        let closed = problem.ends().is_none();
        if closed {
            let lap = places.first().map_or(0.0, |place| place[0].floor());
            places.iter_mut().for_each(|place| *place = place.map(|share| share - lap));
            let beyond = places.iter().filter(|place| place[0] >= 1.0).count();
            places.rotate_right(beyond);
            places[..beyond].iter_mut().for_each(|place| *place = place.map(|share| share - 1.0));
        } else {
            // Rounding must not lead beyond an end.
            let inside = |share: f64| if share > 1.0 - SAME { 1.0 } else { share.max(0.0) };
            places.iter_mut().for_each(|place| *place = place.map(inside));
        }
        let refined = [0, 1].map(|axis| {
            let wrapped = |share: f64| if closed { share.rem_euclid(1.0) } else { share };
            let shares: Vec<f64> = places.iter().map(|place| wrapped(place[axis])).collect();
            with_ends(&problem.outlines()[axis], &curves[axis], &arc_lengths[axis], &shares)
        });
        let [(first, from), (second, to)] = refined;
        let problem = problem.refined([first, second]);
        let (b, shares) = (problem.counts().1 as i64, shares_of(&problem.outlines()[1]));
        let lines = (0..places.len())
            .map(|k| {
                let (from, to) = (from[k], to[k]);
                // A vertex at the seam may stand for a place a hair before it.
                let lap = (places[k][1] - shares[to]).round() as i64;
                RulingLine { from, to, lifted: to as i64 + lap * b, value: problem.value(from, to) }
            })
            .collect();
        Self {
            curves: curves.clone(),
            arc_lengths,
            problem,
            places,
            lines,
            verified: Vec::new(),
            crossings: 0,
            blocked: 0,
            quadrature: None,
            progress: 0.0,
        }
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the lines when they are verified and measured.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<OneToOne> {
        loop {
            if self.verified.len() < self.lines.len() {
                self.verify(self.verified.len());
                self.progress = 0.3 * self.verified.len() as f64 / self.lines.len() as f64;
            } else {
                let totals = self.arc_lengths.each_ref().map(ArcLength::total);
                let arcs = || [0, 1].map(|axis| self.places.iter().map(|p| p[axis] * totals[axis]).collect());
                let quadrature = self
                    .quadrature
                    .get_or_insert_with(|| Quadrature::new(&self.problem, &self.lines, arcs()));
                let done = quadrature.advance(&self.problem, &self.curves, &self.arc_lengths);
                self.progress = 0.3 + 0.7 * done;
                if done >= 1.0 {
                    let result = quadrature.result();
                    return Some(self.finish(result));
                }
            }
            if !may_go_on() {
                return None;
            }
        }
    }

    /// Share of the work that is done, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.progress
    }

    fn verify(&mut self, k: usize) {
        let line = &self.lines[k];
        let is_visible = self.problem.is_visible(line.from, line.to);
        let others = self.lines.iter().enumerate().filter(|&(other, _)| other != k);
        let crossed: Vec<usize> = others
            .filter(|(_, other)| cross(self.problem.outlines(), line, other))
            .map(|(other, _)| other)
            .collect();
        self.crossings += crossed.iter().filter(|&&other| other > k).count();
        self.blocked += usize::from(!is_visible);
        self.verified.push(is_visible && crossed.is_empty());
    }

    fn finish(&mut self, (integral, bound): (f64, f64)) -> OneToOne {
        let count = self.lines.len();
        let sum: f64 = self.lines.iter().map(|line| line.value).sum();
        let totals = Totals {
            count,
            sum,
            mean: (count > 0).then(|| sum / count as f64),
            integral: Some(integral),
            eta: (bound > 0.0).then(|| integral / bound),
            crossings: self.crossings,
            blocked: self.blocked,
            uncovered: [Vec::new(), Vec::new()],
        };
        let parameter = |axis: usize, share: f64| {
            self.arc_lengths[axis].parameter(share * self.arc_lengths[axis].total())
        };
        OneToOne {
            problem: self.problem.clone(),
            places: self.places.iter().map(|&[x, y]| (parameter(0, x), parameter(1, y))).collect(),
            lines: std::mem::take(&mut self.lines),
            verified: std::mem::take(&mut self.verified),
            failed: Vec::new(),
            totals,
        }
    }
}

/// Shares of arc length from the start of an outline to each vertex.
pub(super) fn shares_of(outline: &Outline) -> Vec<f64> {
    let ends = outline.shares.iter().scan(0.0, |sum, share| {
        let start = *sum;
        *sum += share;
        Some(start)
    });
    ends.collect()
}

/// Ends of lines between vertices, in shares of arc length on both curves, in the order of the lines: weakly ascending. The
/// outlines must start where the curves do.
#[must_use]
pub fn places_of(problem: &Problem, lines: &[RulingLine]) -> Vec<[f64; 2]> {
    let [first, second] = problem.outlines().each_ref().map(shares_of);
    let b = problem.counts().1 as i64;
    let place = |line: &RulingLine| [first[line.from], second[line.to] + line.lifted.div_euclid(b) as f64];
    lines.iter().map(place).collect()
}

/// Ends of one-to-one lines in shares of arc length on both curves, in the order of the lines.
#[must_use]
pub fn places_of_pairs(curves: &[BSpline; 2], pairs: &OneToOne) -> Vec<[f64; 2]> {
    let arc_lengths = curves.each_ref().map(BSpline::arc_length);
    let share = |axis: usize, u: f64| arc_lengths[axis].at(u) / arc_lengths[axis].total();
    pairs.places.iter().map(|&(u, v)| [share(0, u), share(1, v)]).collect()
}

/// Adds vertices to an outline at shares of arc length from 0 to 1, given in cyclic order; returns the number of each among the
/// vertices.
fn with_ends(
    outline: &Outline,
    curve: &BSpline,
    arc_length: &ArcLength,
    shares: &[f64],
) -> (Outline, Vec<usize>) {
    let old = shares_of(outline).into_iter().enumerate().map(|(vertex, share)| (share, vertex, None));
    // In ascending order from the seam on.
    let seam = (1..shares.len()).find(|&k| shares[k] < shares[k - 1]).unwrap_or(0);
    let mut new = (seam..shares.len()).chain(0..seam).map(|k| (shares[k], usize::MAX, Some(k))).peekable();
    let mut all: Vec<(f64, usize, Option<usize>)> = Vec::with_capacity(outline.len() + shares.len());
    for vertex in old {
        while let Some(end) = new.next_if(|end| end.0 < vertex.0) {
            all.push(end);
        }
        all.push(vertex);
    }
    all.extend(new);
    let mut numbers = vec![0; shares.len()];
    let (mut points, mut normals, mut places) = (Vec::new(), Vec::new(), Vec::<f64>::new());
    let mut last_is_old = false;
    for (share, vertex, end) in all {
        let repeats = places.last().is_some_and(|last| share - last < SAME);
        let old = (vertex != usize::MAX).then(|| (outline.points[vertex], outline.normals[vertex]));
        if let Some((point, normal)) = old {
            if repeats && !last_is_old {
                // The vertex takes the place of the end beside it.
                points.pop();
                normals.pop();
                places.pop();
            }
            points.push(point);
            normals.push(normal);
            places.push(share);
            last_is_old = true;
        } else if !repeats {
            if outline.closed && 1.0 - share < SAME {
                // The seam.
                numbers[end.unwrap_or(0)] = 0;
                continue;
            }
            let u = arc_length.parameter(share * arc_length.total());
            points.push(curve.point(u));
            normals.push(curve.normal(u));
            places.push(share);
            last_is_old = false;
        }
        if let Some(k) = end {
            numbers[k] = points.len() - 1;
        }
    }
    let end = if outline.closed { 1.0 } else { places.last().copied().unwrap_or(1.0) };
    let next = places.iter().copied().skip(1).chain([end]);
    let shares = places.iter().zip(next).map(|(place, next)| next - place).collect();
    (Outline { points, normals, shares, closed: outline.closed }, numbers)
}

/// A point of a curve at a share of arc length, as the end of a line.
pub(super) fn end_at(curve: &BSpline, arc_length: &ArcLength, share: f64) -> End {
    let u = arc_length.parameter(share * arc_length.total());
    End { point: curve.point(u), normal: curve.normal(u) }
}

#[cfg(test)]
mod tests {
    use super::super::Weights;
    use super::*;
    use crate::curve::{Form, Scheme, sample};
    use glam::dvec2;

    /// Two squarish curves, one round the other.
    fn pair() -> ([BSpline; 2], Problem) {
        let square = |r: f64| vec![dvec2(r, r), dvec2(-r, r), dvec2(-r, -r), dvec2(r, -r)];
        let curves = [1.0, 3.0].map(|r| BSpline::new(3, Form::Periodic, square(r), None).expect("a square"));
        let outlines = curves.each_ref().map(|curve| Outline::from(&sample(curve, Scheme::ArcLength, 12)));
        let problem = Problem::new(outlines, Weights::default(), 0.0).expect("one inside the other");
        (curves, problem)
    }

    fn run(places: &[[f64; 2]]) -> OneToOne {
        let (curves, problem) = pair();
        let mut job = Placing::new(&curves, &problem, places);
        loop {
            if let Some(lines) = job.step(&mut || false) {
                break lines;
            }
        }
    }

    #[test]
    fn ends_become_vertices_unless_they_are_and_lines_keep_their_laps() {
        // Two at samples of both curves, one before the seam of the second.
        let places = [[0.0, -0.05], [0.25, 0.25], [0.4, 0.41], [0.99, 0.9]];
        let pairs = run(&places);
        let (a, b) = pairs.problem.counts();
        assert_eq!((a, b), (12 + 2, 12 + 3));
        let back = places_of(&pairs.problem, &pairs.lines);
        for (place, back) in places.iter().zip(&back) {
            assert!(
                (place[0] - back[0]).abs() < 1e-9 && (place[1] - back[1]).abs() < 1e-9,
                "{place:?} {back:?}"
            );
        }
        let sum: f64 = pairs.problem.outlines().iter().flat_map(|o| &o.shares).sum();
        assert!((sum - 2.0).abs() < 1e-12);
        assert!(pairs.verified.iter().all(|&verified| verified));
        assert!(pairs.lines.windows(2).all(|w| w[0].from < w[1].from && w[0].lifted < w[1].lifted));
    }

    #[test]
    fn a_lap_more_or_less_and_another_first_line_give_the_same() {
        let places: Vec<[f64; 2]> =
            (0..7).map(|k| [0.1 + 0.13 * f64::from(k), 0.13 * f64::from(k)]).collect();
        let expected = run(&places);
        let later: Vec<[f64; 2]> =
            (3..10).map(|k| places[k % 7].map(|share| share + 4.0 + (k / 7) as f64)).collect();
        let found = run(&later);
        for (place, other) in expected.places.iter().zip(&found.places) {
            assert!((place.0 - other.0).abs() < 1e-9 && (place.1 - other.1).abs() < 1e-9);
        }
        let (j, other) = (expected.totals.integral.expect("J"), found.totals.integral.expect("J"));
        assert!((j - other).abs() < 1e-12 * j);
    }

    #[test]
    fn blocked_and_crossing_lines_are_marked() {
        // Nearly half a turn apart, every line passes through the inner curve, and they cross there.
        let places: Vec<[f64; 2]> = (0..6).map(|k| [f64::from(k) / 6.0, f64::from(k) / 6.0 + 0.42]).collect();
        let pairs = run(&places);
        assert_eq!(pairs.totals.blocked, 6);
        let [first, second] = pairs.problem.outlines();
        let ends = |k: usize| (first.points[pairs.lines[k].from], second.points[pairs.lines[k].to]);
        let meet = |i: usize, k: usize| {
            let ((p, q), (r, s)) = (ends(i), ends(k));
            crate::geom::segments_meet(p, q, r, s)
        };
        let crossings =
            (0..6).flat_map(|i| (i + 1..6).map(move |k| (i, k))).filter(|&(i, k)| meet(i, k)).count();
        assert_eq!(pairs.totals.crossings, crossings);
        assert!(crossings >= 9, "{crossings}");
        assert!(pairs.verified.iter().all(|&verified| !verified));
    }
}
