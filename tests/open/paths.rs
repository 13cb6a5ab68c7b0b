//! Matchings of open outlines against every path by brute force, and visibility by its definition.

use super::{line, unit, wavy};
use crate::support::seeded;
use directrix::matching::{
    Bound, Ends, ExactOptions, Layout, Objective, Outline, Policy, Problem, RulingLine, Weights, exact,
    greedy, measure, one_per_vertex, trace, vertex_sets,
};
use glam::{DVec2, dvec2};
use proptest::prelude::*;

/// An outline with the normal of each vertex to the right of the line between its neighbours.
fn outline(points: Vec<DVec2>) -> Outline {
    let n = points.len();
    let along = |i: usize| points[(i + 1).min(n - 1)] - points[i.saturating_sub(1)];
    let normals = (0..n).map(|i| -along(i).perp().normalize()).collect();
    Outline::open(points, normals)
}

/// The value of a path of lines.
fn worth(problem: &Problem, objective: Objective, path: &[(usize, usize)]) -> f64 {
    let value = |(from, to): (usize, usize)| problem.value(from, to);
    let sum: f64 = path.iter().map(|&line| value(line)).sum();
    match objective {
        Objective::Sum => sum,
        Objective::SumLessPrice(price) => sum - price * path.len() as f64,
        Objective::Integral => path
            .windows(2)
            .map(|w| {
                let [first, second] = problem.outlines();
                let on_first = if w[1].0 > w[0].0 { first.shares[w[0].0] } else { 0.0 };
                let on_second = if w[1].1 > w[0].1 { second.shares[w[0].1] } else { 0.0 };
                (on_first + on_second) / 2.0 * (value(w[0]) + value(w[1])) / 2.0
            })
            .sum(),
    }
}

/// Lines by the numbers of their vertices.
type Lines = [(usize, usize)];

/// Every monotone path of visible lines from a start to an end, by plain recursion.
fn every_path(
    problem: &Problem,
    path: &mut Vec<(usize, usize)>,
    is_end: &dyn Fn(usize, usize) -> bool,
    found: &mut dyn FnMut(&Lines),
) {
    let &(i, j) = path.last().expect("a start");
    if is_end(i, j) {
        found(path);
    }
    let (a, b) = problem.counts();
    for (i, j) in [(i + 1, j), (i, j + 1), (i + 1, j + 1)] {
        if i < a && j < b && problem.is_visible(i, j) {
            path.push((i, j));
            every_path(problem, path, is_end, found);
            path.pop();
        }
    }
}

/// The best value over all paths, by looking at each of them.
fn best_by_force(problem: &Problem, objective: Objective, pins: &[(usize, usize)]) -> Option<f64> {
    let (a, b) = problem.counts();
    let is_free = problem.ends() == Some(Ends::Free);
    let starts = (0..a).flat_map(|i| (0..b).map(move |j| (i, j)));
    let starts = starts.filter(|&(i, j)| if is_free { i == 0 || j == 0 } else { i + j == 0 });
    let is_end = |i: usize, j: usize| {
        let (last_i, last_j) = (i + 1 == a, j + 1 == b);
        if is_free { last_i || last_j } else { last_i && last_j }
    };
    let mut best: Option<f64> = None;
    for start in starts.filter(|&(i, j)| problem.is_visible(i, j)) {
        every_path(problem, &mut vec![start], &is_end, &mut |path| {
            if pins.iter().all(|pin| path.contains(pin)) {
                let worth = worth(problem, objective, path);
                best = Some(best.map_or(worth, |best| best.max(worth)));
            }
        });
    }
    best
}

const OBJECTIVES: [Objective; 3] = [Objective::Integral, Objective::Sum, Objective::SumLessPrice(0.13)];

#[test]
fn the_optimum_is_the_best_of_all_paths() {
    let cases = (unit(), 3..7_usize, 3..7_usize, any::<bool>(), any::<bool>(), (0..6_usize, 0..6_usize));
    let (mut solved, mut refused, mut pinned) = (0, 0, 0);
    seeded(160, &cases, |(numbers, a, b, is_free, turned, pin)| {
        let [first, mut second] = wavy(&numbers, [a, b]);
        if turned {
            second.reverse();
        }
        let ends = if is_free { Ends::Free } else { Ends::Tied };
        let outlines = [outline(first), outline(second)];
        let Ok(problem) = Problem::open(outlines, Weights::default(), 0.0, ends) else { return Ok(()) };
        for objective in OBJECTIVES {
            let options = |pins: &[(usize, usize)]| ExactOptions {
                objective,
                pins: pins.to_vec(),
                ..ExactOptions::default()
            };
            let expected = best_by_force(&problem, objective, &[]);
            match (exact(&problem, options(&[])), expected) {
                (Ok(found), Some(expected)) => {
                    solved += 1;
                    prop_assert!((found.value - expected).abs() < 1e-9 * expected.abs().max(1.0));
                    let path: Vec<(usize, usize)> = found.lines.iter().map(|l| (l.from, l.to)).collect();
                    prop_assert!((worth(&problem, objective, &path) - found.value).abs() < 1e-9);
                    let totals =
                        measure(&problem, &found.lines, Bound::of(&problem, &found.best, &found.lines));
                    prop_assert_eq!(totals.blocked, 0);
                    prop_assert!(totals.uncovered.iter().all(Vec::is_empty) || found.lines.len() == 1);
                    if matches!(problem.layout(), Layout::Strip { .. }) {
                        prop_assert_eq!(totals.crossings, 0);
                    }
                    if let Some(eta) = totals.eta.filter(|_| objective == Objective::Integral) {
                        prop_assert!(eta <= 1.0 + 1e-12);
                        prop_assert!((totals.integral.unwrap_or(f64::NAN) - found.value).abs() < 1e-12);
                    }
                }
                (Err(_), None) => refused += 1,
                // The end lines cross: paths there are, but none without a crossing.
                (Err(why), Some(_)) if why.obstacle == directrix::matching::Obstacle::EndsCross => {
                    refused += 1
                }
                (found, expected) => prop_assert!(false, "{:?} but {:?}", found, expected),
            }
            let pin = (pin.0 % a, pin.1 % b);
            let with_pin = best_by_force(&problem, objective, &[pin]);
            if let (Ok(found), Some(expected)) = (exact(&problem, options(&[pin])), with_pin) {
                pinned += 1;
                prop_assert!((found.value - expected).abs() < 1e-9 * expected.abs().max(1.0), "{:?}", pin);
                prop_assert!(found.lines.iter().any(|line| (line.from, line.to) == pin));
            }
        }
        Ok(())
    });
    assert!(solved > 150 && refused > 60 && pinned > 60, "{solved} {refused} {pinned}");
}

/// Visible by the definition alone: the segment meets nothing by more than a hair, and inside the region its middle is.
#[test]
fn the_quick_look_sees_what_the_slow_one_sees() {
    let cases = (unit(), 3..24_usize, 3..24_usize, any::<bool>(), 0.0..1.0_f64);
    let mut strips = 0;
    seeded(120, &cases, |(numbers, a, b, is_free, gap)| {
        let [first, second] = wavy(&numbers, [a, b]);
        let gap = if gap < 0.3 { 1.0 } else { 0.0 };
        let second = if gap > 0.0 { second.iter().map(|p| *p - dvec2(0.0, 2.0)).collect() } else { second };
        let ends = if is_free { Ends::Free } else { Ends::Tied };
        let outlines = [outline(first), outline(second)];
        let Ok(problem) = Problem::open(outlines, Weights::default(), gap, ends) else { return Ok(()) };
        strips += usize::from(matches!(problem.layout(), Layout::Strip { .. }));
        for from in 0..a {
            let sets = vertex_sets(&problem, &[], 0, from);
            let mut seen: Vec<usize> = sets.visible.iter().map(|seen| seen.vertex).collect();
            seen.sort_unstable();
            let expected: Vec<usize> = (0..b).filter(|&to| problem.is_visible(from, to)).collect();
            prop_assert_eq!(seen, expected, "from {}", from);
            prop_assert_eq!(sets.valid.len(), b);
        }
        Ok(())
    });
    assert!(strips > 20, "{strips}");
}

#[test]
fn greedy_lines_are_ordered_tied_and_never_better_than_the_optimum() {
    let cases = (unit(), 4..30_usize, 4..30_usize, any::<bool>());
    let (mut complete, mut compared) = (0, 0);
    seeded(150, &cases, |(numbers, a, b, is_free)| {
        let [first, second] = wavy(&numbers, [a, b]);
        let ends = if is_free { Ends::Free } else { Ends::Tied };
        let outlines = [outline(first), outline(second)];
        let Ok(problem) = Problem::open(outlines, Weights::default(), 0.0, ends) else { return Ok(()) };
        let matching = greedy(&problem);
        let ordered = |w: &[RulingLine]| w[0].from <= w[1].from && w[0].to <= w[1].to;
        prop_assert!(matching.lines.windows(2).all(ordered));
        prop_assert_eq!(matching.totals.blocked, 0);
        if !matching.is_complete() {
            return Ok(());
        }
        complete += 1;
        if !is_free {
            let [start, end] = [matching.lines[0], matching.lines[matching.lines.len() - 1]];
            prop_assert_eq!([(start.from, start.to), (end.from, end.to)], [(0, 0), (a - 1, b - 1)]);
            let optimum = exact(&problem, ExactOptions::default()).expect("a cover was found");
            let integral = matching.totals.integral.expect("covered");
            prop_assert!(
                integral <= optimum.value + 1e-9 * optimum.value.abs(),
                "{} {}",
                integral,
                optimum.value
            );
            compared += 1;
        }
        let trace = trace(&problem, &matching.growth);
        prop_assert_eq!(trace.growth.len() - trace.removed.len(), matching.lines.len());
        for rejection in &trace.rejected {
            let by = trace.growth[rejection.by];
            let crossed = (rejection.from < by.from && rejection.to > by.to)
                || (rejection.from > by.from && rejection.to < by.to);
            prop_assert!(crossed, "{:?} {:?}", rejection, by);
        }
        Ok(())
    });
    assert!(complete > 50 && compared > 20, "{complete} {compared}");
}

#[test]
fn at_most_one_line_a_vertex_with_tied_ends() {
    let cases = (unit(), 4..20_usize, 4..20_usize);
    seeded(60, &cases, |(numbers, a, b)| {
        let [first, second] = wavy(&numbers, [a, b]);
        let outlines = [outline(first), outline(second)];
        let Ok(problem) = Problem::open(outlines, Weights::default(), 0.0, Ends::Tied) else { return Ok(()) };
        let Layout::Strip { .. } = problem.layout() else { return Ok(()) };
        let found = one_per_vertex(&problem).lines;
        prop_assert!(found.windows(2).all(|w| w[0].from < w[1].from && w[0].to < w[1].to));
        let [start, end] = [found[0], found[found.len() - 1]];
        prop_assert_eq!([(start.from, start.to), (end.from, end.to)], [(0, 0), (a - 1, b - 1)]);
        Ok(())
    });
}

#[test]
fn policies_are_those_of_closed_curves() {
    let problem = Problem::open(
        [outline(line(DVec2::ZERO, dvec2(4.0, 0.0), 5)), outline(line(dvec2(0.0, 1.0), dvec2(4.0, 1.0), 5))],
        Weights::default(),
        0.0,
        Ends::Tied,
    )
    .expect("apart");
    let strict = exact(&problem, ExactOptions::default()).expect("feasible");
    let repair = exact(&problem, ExactOptions { policy: Policy::Repair, ..ExactOptions::default() });
    assert_eq!(repair.expect("feasible"), strict);
}
