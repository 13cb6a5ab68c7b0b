//! Further figures of a set of lines.

use super::even::at_even_means;
use super::parts::Parts;
use super::place::{end_at, places_of};
use super::{Problem, RulingLine};
use crate::curve::{ArcLength, BSpline};

/// Figures of a set of lines beside its [`Totals`](super::Totals).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Details {
    /// S_N: sum of f over as many lines as there are, evenly spread by arc length along the correspondence that the lines describe. It can be
    /// compared between sets of equally many lines, and grows with their number as J times it.
    pub spread_sum: f64,
    /// Smallest product of the normals at the ends of a line.
    pub least_cosine: f64,
    /// Length of the longest line.
    pub longest: f64,
}

/// Computes further figures of lines in cyclic order between the curves of a problem, whose ends lie at `places` in shares of arc
/// length; `None` without lines.
#[must_use]
pub fn details(
    curves: &[BSpline; 2],
    problem: &Problem,
    lines: &[RulingLine],
    places: &[[f64; 2]],
) -> Option<Details> {
    let arc_lengths = curves.each_ref().map(BSpline::arc_length);
    if places.is_empty() {
        return None;
    }
    let even = at_even_means(places, problem.ends().is_none(), lines.len());
    let value = |&place: &[f64; 2]| value_at(curves, &arc_lengths, problem, place);
    let cosines = lines.iter().map(|line| problem.cosine(line.from, line.to));
    let lengths = lines.iter().map(|line| problem.length(line.from, line.to));
    Some(Details {
        spread_sum: even.iter().map(value).sum(),
        least_cosine: cosines.fold(f64::INFINITY, f64::min),
        longest: lengths.fold(0.0, f64::max),
    })
}

/// J on the curves of the correspondence that is linear in arc length between lines in cyclic order, by the midpoints of eight
/// parts from each to the next, as for the J of [`OneToOne`](super::OneToOne).
#[must_use]
pub fn integral_on_curves(curves: &[BSpline; 2], problem: &Problem, lines: &[RulingLine]) -> f64 {
    let arc_lengths = curves.each_ref().map(BSpline::arc_length);
    let places = places_of(problem, lines);
    let closed = problem.ends().is_none();
    let lap = places.first().filter(|_| closed).map(|place| place.map(|share| share + 1.0));
    let next = places.iter().copied().skip(1).chain(lap);
    let parts = Parts::new(curves, &arc_lengths);
    let gap = |(place, next): (&[f64; 2], [f64; 2])| {
        let width = [next[0] - place[0], next[1] - place[1]];
        let middle = |w: &[f64]| {
            let t = (w[0] + w[1]) / 2.0;
            let at = [place[0] + t * width[0], place[1] + t * width[1]];
            (w[1] - w[0]) * value_at(curves, &arc_lengths, problem, at)
        };
        (width[0] + width[1]) / 2.0 * parts.cuts(*place, next).windows(2).map(middle).sum::<f64>()
    };
    places.iter().zip(next).map(gap).sum()
}

fn value_at(curves: &[BSpline; 2], arc_lengths: &[ArcLength; 2], problem: &Problem, [x, y]: [f64; 2]) -> f64 {
    problem.value_between(end_at(&curves[0], &arc_lengths[0], x), end_at(&curves[1], &arc_lengths[1], y))
}

#[cfg(test)]
mod tests {
    use super::super::{ExactOptions, Outline, Placing, Weights, exact, places_of_pairs};
    use super::*;
    use crate::curve::{Form, Scheme, sample};
    use glam::dvec2;

    #[test]
    fn figures_of_the_optimum_agree_with_those_of_placed_lines() {
        let square = |r: f64| vec![dvec2(r, r), dvec2(-r, r), dvec2(-r, -r), dvec2(r, -r)];
        let curves = [1.0, 2.0].map(|r| BSpline::new(3, Form::Periodic, square(r), None).expect("a square"));
        let problem = |count: usize| {
            let outlines =
                curves.each_ref().map(|curve| Outline::from(&sample(curve, Scheme::ArcLength, count)));
            Problem::new(outlines, Weights::default(), 0.0).expect("one inside the other")
        };
        let coarse = problem(60);
        let lines = exact(&coarse, ExactOptions::default()).expect("feasible").lines;
        let j = integral_on_curves(&curves, &coarse, &lines);
        let figures =
            details(&curves, &coarse, &lines, &places_of(&coarse, &lines)).expect("there are lines");
        let count = lines.len() as f64;
        assert!((figures.spread_sum / count / j - 1.0).abs() < 1e-3, "S_N is about N J");
        let brute = lines.iter().map(|line| coarse.length(line.from, line.to)).fold(0.0, f64::max);
        assert_eq!(figures.longest, brute);
        assert!(figures.least_cosine > 0.9 && figures.least_cosine <= 1.0);
        // One-to-one lines have their J from the quadrature that also gives the bound: it is the same one.
        let places: Vec<[f64; 2]> = (0..40).map(|k| [f64::from(k) / 40.0, f64::from(k) / 40.0]).collect();
        let mut job = Placing::new(&curves, &coarse, &places);
        let pairs = loop {
            if let Some(pairs) = job.step(&mut || true) {
                break pairs;
            }
        };
        let again = integral_on_curves(&curves, &pairs.problem, &pairs.lines);
        assert!((again / pairs.totals.integral.expect("J") - 1.0).abs() < 1e-12);
        let back = places_of_pairs(&curves, &pairs);
        assert!(
            back.iter().zip(&places).all(|(p, q)| (p[0] - q[0]).abs() < 1e-9 && (p[1] - q[1]).abs() < 1e-9)
        );
    }
}
