//! Matching from end to end: against a literal reading of the paper, against closed forms, under symmetries.

use crate::support::outlines::{Shape, circle, random_pair};
use crate::support::seeded;
use directrix::geom::segments_meet;
use directrix::matching::{
    Layout, Matching, NegativeProducts, Outline, Problem, RulingLine, Weights, blocking_edge, greedy, prune,
    round_to_40_bits,
};
use glam::{DAffine2, DVec2, dvec2};
use proptest::prelude::*;
use std::collections::BTreeSet;

fn problem(first: Outline, second: Outline, weights: Weights) -> Problem {
    Problem::new([first, second], weights, 0.0).expect("nested simple outlines")
}

/// Algorithms I and II of the paper taken literally, with its two repairs: a line is not taken twice, and a line is
/// admissible when, as a segment, it crosses none of those taken. It knows nothing of lifts, grids or sorting.
fn literal(problem: &Problem, stop_at_cover: bool) -> Vec<RulingLine> {
    let (a, b) = problem.counts();
    let [first, second] = problem.outlines();
    let is_visible: Vec<Vec<bool>> =
        (0..a).map(|i| (0..b).map(|j| blocking_edge(problem.outlines(), i, j).is_none()).collect()).collect();
    let mut lines: Vec<(usize, usize)> = Vec::new();
    let crosses = |i: usize, j: usize, (k, l): (usize, usize)| {
        i != k
            && j != l
            && segments_meet(first.points[i], second.points[j], first.points[k], second.points[l])
    };
    loop {
        let bare =
            (0..a).any(|i| lines.iter().all(|l| l.0 != i)) || (0..b).any(|j| lines.iter().all(|l| l.1 != j));
        if stop_at_cover && !bare {
            break;
        }
        let mut best: Option<(f64, usize, usize)> = None;
        for (i, seen) in is_visible.iter().enumerate() {
            for (j, &sees) in seen.iter().enumerate() {
                let is_valid = !lines.contains(&(i, j)) && lines.iter().all(|&l| !crosses(i, j, l));
                if !sees || !is_valid {
                    continue;
                }
                let value = round_to_40_bits(problem.value(i, j));
                if best.is_none_or(|(most, _, _)| value > most) {
                    best = Some((value, i, j));
                }
            }
        }
        let Some((_, i, j)) = best else { break };
        lines.push((i, j));
    }
    lines
        .into_iter()
        .map(|(from, to)| RulingLine { from, to, lifted: 0, value: problem.value(from, to) })
        .collect()
}

fn pairs(lines: &[RulingLine]) -> Vec<(usize, usize)> {
    lines.iter().map(|line| (line.from, line.to)).collect()
}

fn set(lines: &[RulingLine]) -> BTreeSet<(usize, usize)> {
    pairs(lines).into_iter().collect()
}

#[test]
fn concentric_circles_match_perfectly_whatever_the_counts() {
    for (a, b) in [(3, 3), (12, 12), (12, 13), (44, 44), (7, 200)] {
        let matching =
            greedy(&problem(circle(1.0, a, DVec2::ZERO), circle(3.0, b, DVec2::ZERO), Weights::default()));
        assert!(matching.is_complete(), "{a} to {b}");
        let eta = matching.totals.eta.expect("positive values");
        assert!(eta <= 1.0 + 1e-12, "{a} to {b}: {eta}");
        if a == b {
            assert!((eta - 1.0).abs() < 1e-12);
            let integral = matching.totals.integral.expect("all covered");
            assert!((integral - 0.25).abs() < 1e-12, "J = d^-2 at distance 2");
            assert_eq!(pairs(&matching.lines), (0..a).map(|i| (i, i)).collect::<Vec<_>>());
        }
    }
}

#[test]
fn greedy_equals_the_literal_algorithm() {
    let mut tried = 0;
    seeded(60, &random_pair(3..=14), |(shape, first, second)| {
        for weights in [
            Weights::default(),
            Weights { normal: 0.0, distance: 1.0, ..Weights::default() },
            Weights { negative: NegativeProducts::Half, alignment: 1.0, ..Weights::default() },
        ] {
            let problem = problem(first.clone(), second.clone(), weights);
            let matching = greedy(&problem);
            let literal = literal(&problem, true);
            assert_eq!(pairs(&matching.growth), pairs(&literal), "{shape:?}");
            let (a, b) = problem.counts();
            assert_eq!(set(&matching.lines), set(&prune(&literal, a, b)), "{shape:?}");
            tried += 1;
        }
        Ok(())
    });
    assert!(tried >= 180);
}

#[test]
fn stopping_at_coverage_or_at_saturation_keeps_the_same_lines() {
    seeded(40, &random_pair(3..=12), |(shape, first, second)| {
        let problem = problem(first, second, Weights::default());
        let (a, b) = problem.counts();
        let matching = greedy(&problem);
        if matching.is_complete() {
            let saturated = literal(&problem, false);
            prop_assert_eq!(set(&matching.lines), set(&prune(&saturated, a, b)), "{:?}", shape);
        }
        Ok(())
    });
}

#[test]
fn certificates_hold_and_every_component_is_a_star() {
    seeded(120, &random_pair(3..=60), |(shape, first, second)| {
        let problem = problem(first, second, Weights::default());
        let matching = greedy(&problem);
        prop_assert_eq!(matching.totals.crossings, 0, "{:?}", shape);
        prop_assert_eq!(matching.totals.blocked, 0, "{:?}", shape);
        let degree = |pick: fn(&RulingLine) -> usize, vertex: usize| {
            matching.lines.iter().filter(|line| pick(line) == vertex).count()
        };
        for line in &matching.lines {
            prop_assert!(degree(|l| l.from, line.from) == 1 || degree(|l| l.to, line.to) == 1);
        }
        if let Some(eta) = matching.totals.eta {
            prop_assert!(eta <= 1.0 + 1e-12, "{:?}: {}", shape, eta);
        }
        for (line, next) in matching.lines.iter().zip(&matching.lines[1..]) {
            prop_assert!(line.from <= next.from && line.lifted <= next.lifted);
        }
        Ok(())
    });
}

/// Applies `map` to both outlines and returns the greedy lines.
fn mapped(outlines: &[Outline; 2], map: DAffine2) -> Matching {
    let [first, second] = outlines.each_ref().map(|outline| {
        let turn = |n: &DVec2| map.transform_vector2(*n).normalize();
        let points = outline.points.iter().map(|p| map.transform_point2(*p)).collect();
        Outline::new(points, outline.normals.iter().map(turn).collect())
    });
    greedy(&problem(first, second, Weights::default()))
}

#[test]
fn rigid_motion_and_scaling_keep_the_lines() {
    seeded(40, &random_pair(4..=40), |(shape, first, second)| {
        let outlines = [first, second];
        let still = mapped(&outlines, DAffine2::IDENTITY);
        let moved = mapped(&outlines, DAffine2::from_angle_translation(1.234, dvec2(-70.0, 31.0)));
        prop_assert_eq!(set(&still.lines), set(&moved.lines), "{:?}", shape);
        let scaled = mapped(&outlines, DAffine2::from_scale(DVec2::splat(0.037)));
        prop_assert_eq!(set(&still.lines), set(&scaled.lines), "{:?}", shape);
        let ratio = scaled.totals.sum / still.totals.sum;
        prop_assert!((ratio * 0.037_f64.powi(2) - 1.0).abs() < 1e-9, "values scale like d^-2: {}", ratio);
        Ok(())
    });
}

#[test]
fn another_start_vertex_swapping_and_reflection_keep_the_lines() {
    seeded(40, &random_pair(4..=40), |(shape, first, second)| {
        let (a, b) = (first.len(), second.len());
        let lines = set(&greedy(&problem(first.clone(), second.clone(), Weights::default())).lines);

        let swapped = greedy(&problem(second.clone(), first.clone(), Weights::default()));
        let transposed: BTreeSet<_> = swapped.lines.iter().map(|l| (l.to, l.from)).collect();
        prop_assert_eq!(&lines, &transposed, "{:?}", shape);

        let shift = |outline: &Outline, by: usize| {
            let mut outline = outline.clone();
            outline.points.rotate_left(by);
            outline.normals.rotate_left(by);
            outline.shares.rotate_left(by);
            outline
        };
        let shifted = greedy(&problem(shift(&first, 3), shift(&second, 2), Weights::default()));
        let back: BTreeSet<_> = shifted.lines.iter().map(|l| ((l.from + 3) % a, (l.to + 2) % b)).collect();
        prop_assert_eq!(&lines, &back, "{:?}", shape);

        // A mirror image runs clockwise until its vertices are reversed: the same as drawing the curves the other way.
        let mirror = |outline: &Outline| {
            let flip = |p: &DVec2| dvec2(-p.x, p.y);
            Outline::new(
                outline.points.iter().rev().map(flip).collect(),
                outline.normals.iter().rev().map(flip).collect(),
            )
        };
        let mirrored = greedy(&problem(mirror(&first), mirror(&second), Weights::default()));
        let back: BTreeSet<_> = mirrored.lines.iter().map(|l| (a - 1 - l.from, b - 1 - l.to)).collect();
        prop_assert_eq!(&lines, &back, "{:?}", shape);
        Ok(())
    });
}

#[test]
fn a_vertex_that_sees_nothing_is_named() {
    // The pocket of the inner outline winds round a corner: its deepest vertices cannot see out.
    let inner = [
        (0.0, 0.0),
        (10.0, 0.0),
        (10.0, 10.0),
        (4.0, 10.0),
        (4.0, 9.0),
        (9.0, 9.0),
        (9.0, 1.0),
        (1.0, 1.0),
        (1.0, 8.0),
        (2.0, 8.0),
        (2.0, 2.0),
        (3.0, 2.0),
        (3.0, 10.0),
        (0.0, 10.0),
    ];
    let inner: Vec<DVec2> = inner.iter().map(|&(x, y)| dvec2(x, y)).collect();
    let normals = vec![DVec2::X; inner.len()];
    let outer = circle(20.0, 24, dvec2(5.0, 5.0));
    let problem = problem(Outline::new(inner, normals), outer, Weights::default());
    let matching = greedy(&problem);
    assert!(!matching.is_complete());
    let blind: Vec<usize> = (0..problem.counts().0)
        .filter(|&i| (0..24).all(|j| blocking_edge(problem.outlines(), i, j).is_some()))
        .collect();
    assert!(!blind.is_empty());
    assert_eq!(matching.orphans, [blind.clone(), vec![]]);
    assert!(blind.iter().all(|i| matching.totals.uncovered[0].contains(i)));
    assert_eq!(matching.totals.integral, None);
    assert_eq!(matching.totals.crossings + matching.totals.blocked, 0, "the partial result is sound");
}

#[test]
fn either_curve_may_be_the_inner_one() {
    let (small, large) = (circle(1.0, 9, DVec2::ZERO), circle(2.0, 10, dvec2(0.2, 0.1)));
    let inside = problem(small.clone(), large.clone(), Weights::default());
    let outside = problem(large, small, Weights::default());
    assert_eq!((inside.layout(), outside.layout()), (Layout::FirstInside, Layout::SecondInside));
    let (inside, outside) = (greedy(&inside), greedy(&outside));
    let (a, b) = (inside.totals.integral.expect("covered"), outside.totals.integral.expect("covered"));
    assert!((a - b).abs() < 1e-14);
}

#[test]
fn a_star_and_its_counts() {
    let shape = Shape { lobes: 5, depth: 0.45, phase: 0.1, turn: 0.0 };
    let star = shape.outline(4.0, 80, DVec2::ZERO);
    let matching = greedy(&problem(star, circle(9.0, 60, DVec2::ZERO), Weights::default()));
    assert!(matching.is_complete());
    assert!(matching.totals.count >= 80 && matching.totals.count < 140);
    let turned = matching.lines.last().expect("lines").lifted - matching.lines[0].lifted;
    assert!((50..=60).contains(&turned), "once round the band: {turned} of 60 vertices");
    assert!(matching.totals.mean.is_some_and(|mean| mean > 0.0));
}
