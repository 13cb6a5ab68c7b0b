//! One-to-one pairs from end to end: on circles by closed form, on random shapes by a slow checker.

use crate::support::pairs::Picture;
use crate::support::{list, seeded};
use directrix::document::{Diagnostic, Outcome, Solution, Solve, read_text};
use directrix::matching::{Matching, OneToOne, RulingLine, round_to_40_bits};
use glam::{DVec2, dvec2};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::f64::consts::TAU;

fn ring(radius: f64, count: usize, turn: f64) -> Value {
    let point = |k: usize| radius * DVec2::from_angle(turn + TAU * k as f64 / count as f64);
    (0..count).map(|k| json!(point(k).to_array())).collect()
}

fn document(inner: Value, outer: Value, counts: [usize; 2]) -> Value {
    json!({
        "directrix": 1, "kind": "curves", "matching": {"method": "greedy", "oneToOne": true},
        "sampling": {"counts": counts},
        "curves": [
            {"degree": 3, "form": "periodic", "points": inner},
            {"degree": 3, "form": "periodic", "points": outer},
        ],
    })
}

fn solve(document: &Value) -> Option<Solution> {
    let solution = Solve::run(read_text(&document.to_string()).expect("fields in range")).ok()?;
    matches!(solution.outcome, Outcome::Matched { .. }).then_some(solution)
}

fn parts(solution: &Solution) -> (&Matching, Option<&OneToOne>) {
    let Outcome::Matched { matching, pairs, .. } = &solution.outcome else { panic!("matched") };
    (matching, pairs.as_deref())
}

/// Number of pairs that the first pass of insertion leaves: a + b less the number of steps k_i of at least 1 from the partner
/// of one vertex to that of the next, each vertex with its best line.
fn predicted(lines: &[RulingLine], a: usize, b: usize) -> usize {
    let best: Vec<i64> = (0..a)
        .map(|i| {
            let own = lines.iter().filter(|line| line.from == i);
            let value = |line: &&RulingLine| round_to_40_bits(line.value);
            let most = own.clone().map(|line| value(&line)).fold(f64::NEG_INFINITY, f64::max);
            own.filter(|line| value(line) == most).map(|line| line.lifted).min().expect("covered")
        })
        .collect();
    let next = best.iter().copied().skip(1).chain([best[0] + b as i64]);
    a + b - best.iter().zip(next).filter(|(this, next)| next - *this >= 1).count()
}

/// Checks everything that pairs promise.
fn check(solution: &Solution) -> Result<usize, TestCaseError> {
    let (matching, pairs) = parts(solution);
    prop_assert_eq!(matching.is_complete(), pairs.is_some());
    let Some(pairs) = pairs else { return Ok(0) };
    let samples = solution.model.samples();
    let [a, b] = [0, 1].map(|axis| samples[axis].parameters.len());
    prop_assert_eq!(pairs.lines.len(), predicted(&matching.lines, a, b));
    prop_assert_eq!(pairs.lines.len(), matching.lines.len(), "insertion keeps the number of lines");

    // Strictly monotone round the band, but for gaps that keep their star lines.
    let count = pairs.places.len();
    let is_star = |k: usize, next: usize| {
        pairs.failed.iter().any(|gap| gap.lines.contains(&k) && gap.lines.contains(&next))
    };
    let period = |axis: usize| {
        let (lo, hi) = solution.model.curves()[axis].domain();
        hi - lo
    };
    for k in 0..count {
        let next = (k + 1) % count;
        let lap = if next == 0 { 1.0 } else { 0.0 };
        let (u, v) = pairs.places[k];
        let (to_u, to_v) = (pairs.places[next].0 + lap * period(0), pairs.places[next].1 + lap * period(1));
        prop_assert!(to_u >= u && to_v >= v && (to_u, to_v) != (u, v), "{} at {:?}", k, (u, v));
        prop_assert!(is_star(k, next) || (to_u > u && to_v > v), "{} of {}: {:?}", k, count, (u, v));
    }
    prop_assert!(pairs.places[0].0 >= solution.model.curves()[0].domain().0);
    prop_assert!(pairs.places[count - 1].0 < solution.model.curves()[0].domain().1);

    // Every sample is the end of a pair.
    for (axis, samples) in samples.iter().enumerate() {
        let outline = &pairs.problem.outlines()[axis];
        let missing = samples.points.iter().filter(|point| !outline.points.contains(point)).count();
        prop_assert_eq!(missing, 0, "curve {}", axis);
    }

    let picture = Picture::of(&solution.model, pairs);
    let (crossed, blocked) = picture.faults();
    let outlines = pairs.problem.outlines();
    prop_assert_eq!(picture.vertices(), [outlines[0].len(), outlines[1].len()]);
    let bad = |k: usize| blocked.contains(&k) || crossed.iter().any(|&(i, j)| i == k || j == k);
    for k in 0..count {
        prop_assert!(!pairs.verified[k] || !bad(k), "pair {} is verified and {:?} {:?}", k, crossed, blocked);
    }
    prop_assert!(pairs.verified.iter().all(|&verified| verified), "what fails is replaced");
    prop_assert_eq!((pairs.totals.crossings, pairs.totals.blocked), (0, 0));
    prop_assert!(pairs.totals.uncovered.iter().all(Vec::is_empty));
    if let Some(eta) = pairs.totals.eta {
        prop_assert!(eta <= 1.0 + 1e-12, "{}", eta);
    }
    let named = solution.diagnostics.iter().filter(|d| matches!(d, Diagnostic::UnverifiedGap { .. })).count();
    prop_assert_eq!(named, pairs.failed.len());
    Ok(pairs.failed.len())
}

#[test]
fn rings_of_unequal_counts_are_paired_at_equal_angles() {
    for counts in [[12, 36], [36, 12], [12, 12], [12, 13], [3, 200], [200, 3], [44, 45]] {
        let solution = solve(&document(ring(10.0, 12, 0.0), ring(30.0, 12, 0.0), counts)).expect("rings");
        check(&solution).expect("sound");
        let pairs = parts(&solution).1.expect("complete");
        assert!(pairs.failed.is_empty(), "{counts:?}");
        let eta = pairs.totals.eta.expect("positive");
        // One curve is the other three times as large, so pairs at equal parameters are perfect.
        if counts[0] % counts[1] == 0 || counts[1] % counts[0] == 0 {
            let most = counts[0].max(counts[1]);
            assert_eq!(pairs.lines.len(), most);
            let off = pairs.places.iter().map(|(u, v)| (u - v).abs()).fold(0.0, f64::max);
            assert!(off < 1e-9, "{counts:?}: {off}");
            assert!(eta > 1.0 - 1e-5, "{counts:?}: {eta}");
        } else {
            assert!(eta > 0.97, "{counts:?}: {eta}");
        }
        // Distance two thirds of the outer radius, which the spline keeps to 1e-3.
        let integral = pairs.totals.integral.expect("covered");
        let distance = 2.0 / 3.0 * solution.model.curves()[1].point(0.0).length();
        assert!((integral * distance * distance - 1.0).abs() < 0.04, "{counts:?}: {integral}");
    }
}

#[test]
fn inserted_points_divide_their_gap_in_the_proportion_of_their_partners() {
    // One sample of the triangle faces many of the outer ring, whose parameters are uneven.
    let mut uneven = document(ring(10.0, 12, 0.0), ring(30.0, 12, 0.4), [3, 17]);
    uneven["curves"][1]["knots"] = json!([0.0, 0.5, 1.0, 3.0, 4.0, 5.5, 6.0, 7.0, 8.0, 8.5, 9.0, 11.0, 12.0]);
    let solution = solve(&uneven).expect("rings");
    let (matching, pairs) = parts(&solution);
    let pairs = pairs.expect("complete");
    assert!(pairs.failed.is_empty());
    check(&solution).expect("sound");
    let samples = solution.model.samples();
    let is_sample = |k: usize| samples[0].parameters.contains(&pairs.places[k].0);
    let kept: Vec<usize> = (0..pairs.places.len()).filter(|&k| is_sample(k)).collect();
    assert_eq!(kept.len(), 3);
    for &k in &kept {
        let (from, to) = (pairs.lines[k].from, pairs.lines[k].to);
        let (p, q) = (pairs.problem.outlines()[0].points[from], pairs.problem.outlines()[1].points[to]);
        let own = |line: &&RulingLine| samples[0].points[line.from] == p;
        let best = matching.lines.iter().filter(own).max_by(|a, b| a.value.total_cmp(&b.value));
        assert_eq!(samples[1].points[best.expect("covered").to], q, "the best line of a vertex stays");
    }
    for pair in kept.windows(2) {
        let ((u0, v0), (u1, v1)) = (pairs.places[pair[0]], pairs.places[pair[1]]);
        for &(u, v) in &pairs.places[pair[0] + 1..pair[1]] {
            assert!(((u - u0) / (u1 - u0) - (v - v0) / (v1 - v0)).abs() < 1e-12, "Eq. 13");
        }
    }
}

#[test]
fn the_integral_converges_to_that_of_fine_trapezoids() {
    let solution = solve(&document(ring(10.0, 12, 0.0), ring(30.0, 7, 1.0), [20, 31])).expect("rings");
    let pairs = parts(&solution).1.expect("complete");
    let curves = solution.model.curves();
    let arcs = [curves[0].arc_length(), curves[1].arc_length()];
    let value = |s: f64, t: f64| {
        let (u, v) = (arcs[0].parameter(s), arcs[1].parameter(t));
        let squared = curves[0].point(u).distance_squared(curves[1].point(v));
        curves[0].normal(u).dot(curves[1].normal(v)) / squared
    };
    let (mut integral, count) = (0.0, pairs.places.len());
    for k in 0..count {
        let (u, v) = pairs.places[k];
        let (s, t) = (arcs[0].at(u), arcs[1].at(v));
        let lap = if k + 1 == count { 1.0 } else { 0.0 };
        let (u, v) = pairs.places[(k + 1) % count];
        let (to_s, to_t) = (arcs[0].at(u) + lap * arcs[0].total(), arcs[1].at(v) + lap * arcs[1].total());
        let mass = ((to_s - s) / arcs[0].total() + (to_t - t) / arcs[1].total()) / 2.0;
        for part in 0..100 {
            let at = |x: f64| value(s + x * (to_s - s), t + x * (to_t - t));
            let x = f64::from(part) / 100.0;
            integral += mass / 100.0 * (at(x) + at(x + 0.01)) / 2.0;
        }
    }
    let found = pairs.totals.integral.expect("covered");
    assert!((found / integral - 1.0).abs() < 1e-4, "{found} and {integral}");

    // The bound looks at some partners only; looking at very many raises it little.
    let best = |axis: usize| {
        let mids = 200;
        let length = [arcs[0].total(), arcs[1].total()];
        let at = |k: usize, axis: usize| (k as f64 + 0.5) / f64::from(mids) * length[axis];
        let partner = |k: usize, m: usize| {
            if axis == 0 { value(at(k, 0), at(m, 1)) } else { value(at(m, 0), at(k, 1)) }
        };
        let mids = mids as usize;
        (0..mids).map(|k| (0..mids).map(|m| partner(k, m)).fold(f64::NEG_INFINITY, f64::max)).sum::<f64>()
            / mids as f64
    };
    let eta = found / ((best(0) + best(1)) / 2.0);
    let stated = pairs.totals.eta.expect("positive");
    assert!((stated - eta).abs() < 2e-3, "{stated} and {eta}, nothing being hidden between rings");
}

#[test]
fn star_matching_is_untouched_by_insertion() {
    let mut with = document(ring(10.0, 9, 0.3), ring(30.0, 7, 1.0), [20, 31]);
    let inserted = solve(&with).expect("rings");
    with["matching"]["oneToOne"] = json!(false);
    let plain = solve(&with).expect("rings");
    assert_eq!(parts(&plain).0, parts(&inserted).0);
    assert!(parts(&plain).1.is_none());
    let totals = parts(&plain).0.totals.clone();
    assert_eq!(plain.lines().map(|(_, _, totals)| totals.clone()), Some(totals));
    let band = inserted.band().expect("complete");
    let places: Vec<(f64, f64)> = band.lines().map(|ruling| (ruling.u, ruling.v)).collect();
    assert_eq!(places, parts(&inserted).1.expect("complete").places, "the band follows the pairs");
}

#[test]
fn another_start_or_direction_gives_as_many_pairs() {
    let count = |document: &Value| {
        let solution = solve(document).expect("rings");
        check(&solution).expect("sound");
        parts(&solution).1.expect("complete").lines.len()
    };
    let base = document(ring(10.0, 9, 0.3), ring(30.0, 7, 1.0), [20, 31]);
    let mut swapped = base.clone();
    swapped["curves"].as_array_mut().expect("a list").reverse();
    swapped["sampling"]["counts"] = json!([31, 20]);
    assert_eq!(count(&base), count(&swapped));
    // The seams lie inside fans of either curve, at their sides and between them.
    for counts in [[5, 23], [23, 5], [7, 9]] {
        for turn in 0..12 {
            let outer = ring(30.0, 12, 0.1 + TAU * f64::from(turn) / 31.0);
            assert!(count(&document(ring(10.0, 12, 0.0), outer, counts)) >= counts[0].max(counts[1]));
        }
    }
}

/// Control points of a thick open arc from the angle `gap` to a lap less `gap`: a C, or a U where the gap is wide.
fn open_arc(radius: f64, half: f64, gap: f64, count: usize) -> Vec<DVec2> {
    let angle = |k: usize| gap + (TAU - 2.0 * gap) * k as f64 / (count - 1) as f64;
    let side = |radius: f64, k: usize| radius * DVec2::from_angle(angle(k));
    let outside = (0..count).map(|k| side(radius + half, k));
    outside.chain((0..count).rev().map(|k| side(radius - half, k))).collect()
}

#[test]
fn random_shapes_keep_every_promise() {
    let radii = |range: std::ops::Range<f64>| prop::collection::vec(range, 4..12);
    let stars = (radii(4.0..16.0), radii(20.0..40.0), 3_usize..60, 3_usize..60);
    let (mut complete, mut failed) = (0, 0);
    seeded(120, &stars, |(inner, outer, a, b)| {
        let star = |radii: &[f64]| -> Vec<DVec2> {
            let turn = TAU / radii.len() as f64;
            radii.iter().enumerate().map(|(k, r)| r * DVec2::from_angle(turn * k as f64)).collect()
        };
        let document = document(list(&star(&inner)), list(&star(&outer)), [a, b]);
        if let Some(solution) = solve(&document) {
            complete += usize::from(solution.is_complete());
            failed += check(&solution)?;
        }
        Ok(())
    });
    assert!(complete > 80, "{complete} stars are complete, {failed} gaps kept");

    let arcs =
        (10.0..24.0, 1.5..6.0, 0.15..1.6, 5_usize..12, 12_usize..90, 12_usize..90, 30.0..60.0, -4.0..4.0);
    let (mut complete, mut failed) = (0, 0);
    seeded(200, &arcs, |(radius, half, gap, count, a, b, outer, shift)| {
        let inner: Vec<DVec2> =
            open_arc(radius, half, gap, count).iter().map(|p| *p + dvec2(shift, -shift)).collect();
        let document = document(list(&inner), ring(outer, 9, gap), [a, b]);
        if let Some(solution) = solve(&document) {
            complete += usize::from(solution.is_complete());
            failed += check(&solution)?;
        }
        Ok(())
    });
    assert!(complete > 50 && failed > 5, "{complete} arcs are complete, {failed} gaps kept");
}
