//! Open curves: closed forms, certificates checked by slow geometry, and independence of how curves are drawn.

mod paths;

use crate::support::pairs::Picture;
use crate::support::{list, seeded};
use directrix::document::{Code, Diagnostic, Outcome, Solution, Solve, read_text};
use directrix::matching::Totals;
use glam::{DVec2, dvec2};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::f64::consts::{FRAC_PI_2, PI};

/// Two open curves through their control points, of degree 3.
fn document(curves: [&[DVec2]; 2], counts: [usize; 2], matching: &Value) -> Value {
    let curve = |points: &[DVec2]| json!({"degree": 3, "form": "open", "points": list(points)});
    json!({
        "directrix": 1, "kind": "curves", "matching": matching, "sampling": {"counts": counts},
        "curves": curves.map(curve),
    })
}

fn solve(document: &Value) -> Solution {
    Solve::run(read_text(&document.to_string()).expect("fields in range")).expect("curves")
}

fn totals(solution: &Solution) -> &Totals {
    match &solution.outcome {
        Outcome::Matched { pairs: Some(pairs), .. } => &pairs.totals,
        Outcome::Matched { matching, .. } => &matching.totals,
        _ => panic!("{:?} {:?}", solution.outcome, solution.diagnostics),
    }
}

fn integral(solution: &Solution) -> f64 {
    totals(solution).integral.expect("covered")
}

fn line(from: DVec2, to: DVec2, count: usize) -> Vec<DVec2> {
    (0..count).map(|k| from.lerp(to, k as f64 / (count - 1) as f64)).collect()
}

/// Control points whose cubic is a circular arc to about 1e-6: the vertices of a fine polygon just outside it.
fn arc(radius: f64, from: f64, to: f64, count: usize) -> Vec<DVec2> {
    (0..count)
        .map(|k| radius * DVec2::from_angle(from + (to - from) * k as f64 / (count - 1) as f64))
        .collect()
}

/// A pair of wavy polylines, one above the other, the lower ones reaching beyond the other at either end; some turn in like a hook.
fn wavy(numbers: &[f64], counts: [usize; 2]) -> [Vec<DVec2>; 2] {
    let wave = |seed: &[f64], count: usize, height: f64| {
        let point = |k: usize| {
            let t = k as f64 / (count - 1) as f64;
            let x = 4.0 * seed[0] + (6.0 + 3.0 * seed[1]) * t;
            let bend =
                2.5 * (seed[2] - 0.5) * (PI * t).sin() + 1.2 * seed[3] * (9.0 * t + 6.0 * seed[4]).sin();
            dvec2(x, height + bend)
        };
        (0..count).map(point).collect::<Vec<_>>()
    };
    [wave(&numbers[..5], counts[0], 0.0), wave(&numbers[5..], counts[1], 2.4)]
}

#[test]
fn two_parallel_segments_have_the_identity_and_a_known_integral() {
    let (low, high) = (line(DVec2::ZERO, dvec2(10.0, 0.0), 6), line(dvec2(0.0, 2.0), dvec2(10.0, 2.0), 6));
    for (objective, one_to_one) in [("integral", false), ("integral", true)] {
        let matching = json!({"method": "exact", "objective": objective, "oneToOne": one_to_one, "lines": 9});
        for second in [high.clone(), high.iter().rev().copied().collect()] {
            let solution = solve(&document([&low, &second], [21, 21], &matching));
            assert!(solution.is_complete(), "{:?}", solution.diagnostics);
            let totals = totals(&solution);
            assert!((integral(&solution) - 0.25).abs() < 1e-12, "{totals:?}");
            assert!(totals.eta.is_some_and(|eta| (eta - 1.0).abs() < 1e-12), "{totals:?}");
            let Outcome::Matched { matching, pairs, .. } = &solution.outcome else { panic!("matched") };
            assert_eq!(matching.lines.len(), 21);
            assert!(matching.lines.iter().all(|line| line.from == line.to));
            if let Some(pairs) = pairs {
                assert_eq!(pairs.lines.len(), 9);
                for (k, &(u, v)) in pairs.places.iter().enumerate() {
                    let even = k as f64 / 8.0;
                    assert!((solution.model.curves()[0].point(u).x - 10.0 * even).abs() < 1e-9);
                    assert!((solution.model.curves()[1].point(v).x - 10.0 * even).abs() < 1e-9);
                }
            }
        }
    }
}

#[test]
fn two_concentric_arcs_have_radial_lines() {
    let (inner, outer) = (arc(10.0, 0.1, 0.1 + FRAC_PI_2, 200), arc(30.0, 0.1, 0.1 + FRAC_PI_2, 200));
    for ends in ["tied", "free"] {
        let matching = json!({"method": "exact", "oneToOne": true, "lines": 12, "ends": ends});
        let solution = solve(&document([&outer, &inner], [40, 40], &matching));
        assert!(solution.is_complete(), "{:?}", solution.diagnostics);
        // The cubic lies a hair inside its control points.
        assert!((integral(&solution) * 400.0 - 1.0).abs() < 1e-4, "{}", integral(&solution));
        let Outcome::Matched { pairs: Some(pairs), gap: Some(gap), .. } = &solution.outcome else {
            panic!("one to one")
        };
        assert!(gap.value < 1e-4);
        for line in &pairs.lines {
            let [p, q] =
                [pairs.problem.outlines()[0].points[line.from], pairs.problem.outlines()[1].points[line.to]];
            assert!(p.angle_to(q).abs() < 1e-6, "{p} {q}");
        }
    }
}

fn unit() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(0.0..1.0, 10)
}

fn methods() -> Vec<Value> {
    let mut all = Vec::new();
    for ends in ["tied", "free"] {
        for one_to_one in [false, true] {
            for method in ["exact", "greedy", "one-per-vertex", "shift", "parameter"] {
                all.push(json!({"method": method, "oneToOne": one_to_one, "ends": ends}));
            }
            let sum = json!({"method": "exact", "objective": "sum", "oneToOne": one_to_one, "ends": ends});
            let price = json!({"method": "exact", "objective": "sum-less-price", "linePrice": 0.05,
                "oneToOne": one_to_one, "ends": ends});
            all.extend([sum, price]);
        }
    }
    all
}

/// Checks what a result promises by plain geometry.
fn check(solution: &Solution) -> Result<(), TestCaseError> {
    let Outcome::Matched { matching, pairs, is_complete, .. } = &solution.outcome else { return Ok(()) };
    let model = &solution.model;
    let lists = Picture::of_open_lines(model, &matching.lines).faults();
    if matching.totals.crossings + matching.totals.blocked == 0 {
        prop_assert_eq!(&lists, &(vec![], vec![]));
    }
    let Some(pairs) = pairs else { return Ok(()) };
    let is_back = |w: &[(f64, f64)]| w[1].0 <= w[0].0 || w[1].1 <= w[0].1;
    prop_assert!(!pairs.places.windows(2).any(is_back) || !pairs.failed.is_empty(), "{:?}", pairs.places);
    for (curve, place) in model.curves().iter().zip([0, 1]) {
        let (lo, hi) = curve.domain();
        let u = |k: usize| if place == 0 { pairs.places[k].0 } else { pairs.places[k].1 };
        prop_assert!((0..pairs.places.len()).all(|k| (lo..=hi).contains(&u(k))));
        for (k, line) in pairs.lines.iter().enumerate() {
            let vertex = if place == 0 { line.from } else { line.to };
            let off = pairs.problem.outlines()[place].points[vertex].distance(curve.point(u(k)));
            prop_assert!(off < 1e-9 * model.bounds().diagonal());
        }
    }
    let (crossed, blocked) = Picture::as_verified_open(model, pairs).faults();
    for (k, &verified) in pairs.verified.iter().enumerate() {
        let is_bad = blocked.contains(&k) || crossed.iter().any(|&(i, j)| i == k || j == k);
        prop_assert!(!(verified && is_bad), "pair {}: {:?} {:?}", k, crossed, blocked);
    }
    if *is_complete {
        prop_assert_eq!((pairs.totals.crossings, pairs.totals.blocked), (0, 0));
        prop_assert!(pairs.totals.eta.is_none_or(|eta| eta <= 1.0 + 1e-12), "{:?}", pairs.totals.eta);
    }
    Ok(())
}

#[test]
fn every_method_keeps_its_promises() {
    let methods = methods();
    let mut complete = vec![0; methods.len()];
    seeded(8, &unit(), |numbers| {
        let [first, second] = wavy(&numbers, [8, 9]);
        for (k, matching) in methods.iter().enumerate() {
            let solution = solve(&document([&first, &second], [17, 22], matching));
            check(&solution)?;
            complete[k] += usize::from(solution.is_complete());
            if let (Some(band), true) = (solution.band(), solution.is_complete()) {
                prop_assert!(!band.is_closed());
                let lines = band.lines().count();
                prop_assert_eq!(band.rulings().len(), (lines - 1) * band.per_line() + 1);
            }
        }
        Ok(())
    });
    for (matching, complete) in methods.iter().zip(complete) {
        // At most one line a vertex leaves some of unequal numbers without one, unless they are filled in.
        if matching["method"] == "one-per-vertex" && matching["oneToOne"] == false {
            continue;
        }
        assert!(complete >= 2, "{matching}: {complete}");
    }
}

/// Reversing either curve as drawn, or both, changes labels alone; so does exchanging the curves.
#[test]
fn the_direction_of_drawing_does_not_matter() {
    let back = |points: &[DVec2]| points.iter().rev().copied().collect::<Vec<_>>();
    for ends in ["tied", "free"] {
        let matching = json!({"method": "exact", "ends": ends});
        let mut compared = 0;
        seeded(16, &unit(), |numbers| {
            let [first, second] = wavy(&numbers, [7, 8]);
            let run = |pair: [&[DVec2]; 2], counts| solve(&document(pair, counts, &matching));
            let segments = |solution: &Solution, swap: bool| -> Vec<[f64; 4]> {
                let Outcome::Matched { matching, problem, .. } = &solution.outcome else { return Vec::new() };
                let [one, other] = problem.outlines();
                let mut ends: Vec<[f64; 4]> = matching
                    .lines
                    .iter()
                    .map(|line| {
                        let (p, q) = (one.points[line.from], other.points[line.to]);
                        let (p, q) = if swap { (q, p) } else { (p, q) };
                        [p.x, p.y, q.x, q.y]
                    })
                    .collect();
                ends.sort_by(|a, b| a.partial_cmp(b).expect("finite"));
                ends
            };
            let plain = run([&first, &second], [15, 19]);
            if !plain.is_complete() {
                return Ok(());
            }
            compared += 1;
            let expected = segments(&plain, false);
            for (pair, counts, swap) in [
                ([&back(&first) as &[DVec2], &second], [15, 19], false),
                ([&first, &back(&second)], [15, 19], false),
                ([&back(&first), &back(&second)], [15, 19], false),
                ([&second, &first], [19, 15], true),
            ] {
                let other = run(pair, counts);
                prop_assert!((integral(&other) - integral(&plain)).abs() < 1e-9 * integral(&plain).abs());
                let found = segments(&other, swap);
                prop_assert_eq!(found.len(), expected.len());
                for (a, b) in found.iter().zip(&expected) {
                    prop_assert!(a.iter().zip(b).all(|(x, y)| (x - y).abs() < 1e-6), "{:?} {:?}", a, b);
                }
            }
            Ok(())
        });
        assert!(compared >= 5, "{compared}");
    }
}

#[test]
fn the_second_curve_is_reversed_where_that_is_better() {
    let (low, high) = (line(DVec2::ZERO, dvec2(10.0, 0.0), 6), line(dvec2(10.0, 2.0), dvec2(0.0, 2.0), 6));
    for ends in ["tied", "free"] {
        for method in ["exact", "greedy", "parameter"] {
            let solution = solve(&document([&low, &high], [9, 9], &json!({"method": method, "ends": ends})));
            assert_eq!(solution.model.reversed(), [false, true], "{method}, {ends}");
            assert!(solution.is_complete());
        }
    }
    // The printed normals give a perfect match the product -1, whichever way the curves were drawn.
    let printed = json!({"method": "exact", "printed": ["normals"]});
    let solution = solve(&document([&low, &high], [9, 9], &printed));
    assert_eq!(solution.model.reversed(), [false, true]);
    assert!(integral(&solution) < 0.0);
}

#[test]
fn free_ends_leave_out_what_is_hidden_and_tied_ends_say_so() {
    // The lower curve runs on behind the hook of the upper one.
    let low = line(dvec2(0.0, 0.0), dvec2(20.0, 0.0), 12);
    let mut high = line(dvec2(0.0, 3.0), dvec2(9.0, 3.0), 8);
    high.extend(line(dvec2(10.0, 2.0), dvec2(10.0, 0.5), 6));
    high.extend(line(dvec2(10.5, 0.5), dvec2(10.5, 5.0), 6));
    let tied = solve(&document([&low, &high], [30, 30], &json!({"method": "exact"})));
    let free = solve(&document(
        [&low, &high],
        [30, 30],
        &json!({"method": "exact", "ends": "free",
        "objective": "sum-less-price", "linePrice": 0.02}),
    ));
    assert!(free.is_complete(), "{:?}", free.diagnostics);
    let is_left_out = |d: &&Diagnostic| matches!(d, Diagnostic::LeftOut { .. });
    assert!(free.diagnostics.iter().any(|d| is_left_out(&d)), "{:?}", free.diagnostics);
    assert!(totals(&free).eta.is_some_and(|eta| eta <= 1.0 + 1e-12 && eta > 0.5));
    assert!(tied.diagnostics.iter().all(|d| !is_left_out(&d)));
}

#[test]
fn end_lines_that_meet_a_curve_are_named() {
    // The end of the upper curve is coiled up.
    let low = line(dvec2(0.0, 0.0), dvec2(20.0, 0.0), 12);
    let hook = [
        (0.0, 3.0),
        (10.0, 3.0),
        (20.0, 3.0),
        (25.0, 4.0),
        (25.0, 9.0),
        (18.0, 9.0),
        (17.0, 6.0),
        (20.0, 5.0),
        (22.0, 7.0),
    ]
    .map(DVec2::from);
    let solution = solve(&document([&low, &hook], [30, 30], &json!({"method": "exact"})));
    assert!(!solution.is_complete());
    let named = solution.diagnostics.iter().find(|d| d.code() == "ends");
    assert!(
        named.is_some_and(|d| d.to_string().contains("the ends of the curves meets a curve")),
        "{:?}",
        solution.diagnostics
    );
    let repaired = solve(&document([&low, &hook], [30, 30], &json!({"method": "exact", "policy": "repair"})));
    let Outcome::Matched { matching, occluded, .. } = &repaired.outcome else { panic!("repaired") };
    assert!(!occluded.is_empty(), "{:?}", repaired.diagnostics);
    let reaches = |vertex: usize| matching.lines.iter().any(|line| line.to == vertex);
    assert!((0..30).all(reaches), "{:?}", matching.lines);
}

#[test]
fn refinement_converges_and_any_number_of_lines_is_one_to_one() {
    let numbers = [0.1, 0.5, 0.8, 0.4, 0.3, 0.1, 0.6, 0.4, 0.5, 0.9];
    let [first, second] = wavy(&numbers, [8, 9]);
    let (mut values, mut gaps) = (Vec::new(), Vec::new());
    for lines in [3, 10, 64, 200] {
        let matching = json!({"method": "exact", "oneToOne": true, "lines": lines});
        let solution = solve(&document([&first, &second], [20, 30], &matching));
        check(&solution).expect("promises");
        assert!(solution.is_complete(), "{lines}: {:?}", solution.diagnostics);
        let Outcome::Matched { pairs: Some(pairs), gap: Some(gap), .. } = &solution.outcome else {
            panic!("one to one")
        };
        assert!(gap.change.is_some_and(|change| change < 1e-4), "{gap:?}");
        gaps.push(gap.value);
        assert_eq!(pairs.lines.len(), lines);
        let ends = solution.model.curves().each_ref_domain();
        assert_eq!([pairs.places[0], pairs.places[lines - 1]], ends, "both ends have a line");
        values.push(integral(&solution));
    }
    // J of many evenly spread lines is J on the curves.
    assert!((values[2] / values[3] - 1.0).abs() < 5e-3, "{values:?}");
    assert!(gaps[3] < 1e-3 && gaps[3] < gaps[0], "the more lines, the nearer to the optimum: {gaps:?}");
}

/// Starts and ends of the domains of two curves, as pairs.
trait Domains {
    fn each_ref_domain(&self) -> [(f64, f64); 2];
}

impl Domains for [directrix::curve::BSpline] {
    fn each_ref_domain(&self) -> [(f64, f64); 2] {
        let [first, second] = [self[0].domain(), self[1].domain()];
        [(first.0, second.0), (first.1, second.1)]
    }
}

#[test]
fn compositions_are_constant_beyond_their_keys() {
    let (low, high) = (line(DVec2::ZERO, dvec2(10.0, 0.0), 6), line(dvec2(10.0, 2.0), dvec2(0.0, 2.0), 6));
    let mut document = document([&low, &high], [9, 9], &json!({"method": "exact"}));
    document["curves"][0]["composition"] = json!([{"at": 0.25, "mix": [1, 0]}, {"at": 1, "mix": [0, 1]}]);
    document["curves"][1]["composition"] = json!([{"at": 0, "mix": [1, 0]}, {"at": 0.5, "mix": [0, 1]}]);
    let solution = solve(&document);
    let first = |curve: usize, u: f64| solution.model.composition(curve, u).fractions()[0];
    for (u, expected) in [(0.0, 1.0), (0.25, 1.0), (0.625, 0.5), (1.0, 0.0)] {
        assert!((first(0, u) - expected).abs() < 1e-12, "{u}");
    }
    // The second curve runs against its drawing: u there is 1 - u here.
    for (u, expected) in [(1.0, 1.0), (0.75, 0.5), (0.5, 0.0), (0.0, 0.0)] {
        assert!((first(1, u) - expected).abs() < 1e-12, "{u}");
    }
    let band = solution.band().expect("a band");
    let place = band.locate(dvec2(6.25, 1.0)).expect("inside");
    assert!((place.s - 0.5).abs() < 1e-9);
    assert!(band.locate(dvec2(-0.1, 1.0)).is_none() && band.locate(dvec2(10.1, 1.0)).is_none());
    let iso = band.iso_lines(0, 0.25);
    assert!(!iso.is_empty() && iso.iter().all(|line| !line.closed));
}

#[test]
fn adaptive_samples_have_both_ends() {
    let [first, second] = wavy(&[0.1, 0.5, 0.8, 0.4, 0.3, 0.1, 0.6, 0.4, 0.5, 0.9], [8, 9]);
    let mut document = document([&first, &second], [20, 30], &json!({"method": "exact"}));
    document["sampling"] = json!({"scheme": "adaptive", "minCount": 5, "maxTurn": 10});
    let solution = solve(&document);
    for (curve, samples) in solution.model.curves().iter().zip(solution.model.samples()) {
        let (lo, hi) = curve.domain();
        assert_eq!((samples.parameters[0], samples.parameters[samples.parameters.len() - 1]), (lo, hi));
        assert_eq!(samples.arc[samples.arc.len() - 1], samples.length);
        assert!(samples.parameters.len() >= 5);
        let turns = samples.normals.windows(2).map(|w| w[0].angle_to(w[1]).to_degrees().abs());
        assert!(turns.fold(0.0, f64::max) <= 10.0 + 1e-6);
    }
}

#[test]
fn what_cannot_be_is_refused_with_the_field() {
    let (low, high) = (line(DVec2::ZERO, dvec2(10.0, 0.0), 6), line(dvec2(0.0, 2.0), dvec2(10.0, 2.0), 6));
    let good = document([&low, &high], [9, 9], &json!({"method": "exact"}));
    let refused = |change: &dyn Fn(&mut Value)| {
        let mut document = good.clone();
        change(&mut document);
        match read_text(&document.to_string()).and_then(Solve::run) {
            Err(error) => error,
            Ok(Solution { outcome: Outcome::Refused(error), .. }) => error,
            Ok(_) => panic!("{document} was taken"),
        }
    };
    let ring = json!([[0, 1], [4, 1], [4, 4], [0, 4]]);
    let mixed = refused(&|d| d["curves"][1] = json!({"degree": 3, "form": "periodic", "points": ring}));
    assert_eq!((mixed.code, mixed.path.as_str()), (Code::Range, "curves[1].form"));
    assert!(mixed.message.contains("closed") && mixed.message.contains("open"), "{mixed}");
    let shift = refused(&|d| d["matching"] = json!({"method": "shift", "shift": 3}));
    assert_eq!((shift.code, shift.path.as_str()), (Code::Range, "matching.shift"));
    let ends = refused(&|d| d["matching"]["ends"] = json!("loose"));
    assert_eq!((ends.code, ends.path.as_str()), (Code::Range, "matching.ends"));
    let at = refused(&|d| d["curves"][0]["composition"] = json!([{"at": 1.5, "mix": [1, 0]}]));
    assert_eq!((at.code, at.path.as_str()), (Code::Range, "curves[0].composition"));
    let shared = refused(&|d| d["curves"][1]["points"] = list(&line(DVec2::ZERO, dvec2(8.0, 6.0), 6)));
    assert_eq!((shared.code, shared.path.as_str()), (Code::Contact, "curves[1].points"));
    assert!(shared.at.is_some_and(|at| at.length() < 1e-6), "{shared:?}");
    let loops = json!([[0, 2], [10, 2], [10, 8], [2, 8], [2, 0.5]]);
    let own = refused(&|d| d["curves"][1]["points"] = loops.clone());
    assert_eq!(own.code, Code::SelfIntersection);
    assert!(own.at.is_some());
    let closing = json!([[0, 2], [10, 2], [10, 8], [0, 8], [0, 2]]);
    let own = refused(&|d| d["curves"][1]["points"] = closing.clone());
    assert_eq!(own.code, Code::SelfIntersection);
    assert!(own.message.contains("clamped"), "{own}");
    let knots = refused(&|d| d["curves"][0]["knots"] = json!([0, 0, 0, 0, 1, 2, 3, 3, 3]));
    assert_eq!((knots.code, knots.path.as_str()), (Code::Knots, "curves[0].knots"));
}

#[test]
fn crossing_projections_at_two_heights_have_lines_on_both_sides() {
    let low = line(DVec2::ZERO, dvec2(10.0, 0.0), 6);
    let rising = line(dvec2(0.0, -2.0), dvec2(10.0, 2.0), 6);
    let mut document = document([&low, &rising], [20, 20], &json!({"method": "exact"}));
    document["curves"][1]["height"] = json!(1.5);
    let solution = solve(&document);
    assert!(solution.is_complete(), "{:?}", solution.diagnostics);
    assert!(solution.diagnostics.iter().any(|d| d.code() == "crossing"));
    check(&solution).expect("promises");
}

#[test]
fn pins_are_kept_on_open_curves() {
    let (low, high) = (line(DVec2::ZERO, dvec2(10.0, 0.0), 6), line(dvec2(10.0, 2.0), dvec2(0.0, 2.0), 6));
    for one_to_one in [false, true] {
        let matching =
            json!({"method": "exact", "oneToOne": one_to_one, "lines": 7, "pins": [{"u": 0.3, "v": 0.55}]});
        let solution = solve(&document([&low, &high], [11, 11], &matching));
        assert!(solution.is_complete(), "{:?}", solution.diagnostics);
        let [first, second] = solution.model.curves() else { panic!("two curves") };
        // v is that of the curve as drawn, which is reversed here.
        let (p, q) = (first.point(0.3), second.point(0.45));
        let joined: Vec<(DVec2, DVec2)> = match &solution.outcome {
            Outcome::Matched { pairs: Some(pairs), .. } => {
                pairs.places.iter().map(|&(u, v)| (first.point(u), second.point(v))).collect()
            }
            Outcome::Matched { matching, problem, .. } => {
                let [one, other] = problem.outlines();
                matching.lines.iter().map(|line| (one.points[line.from], other.points[line.to])).collect()
            }
            _ => panic!("matched"),
        };
        assert!(joined.iter().any(|&(a, b)| a.distance(p) < 1e-9 && b.distance(q) < 1e-9), "{joined:?}");
        let [start, end] = [joined[0], joined[joined.len() - 1]];
        assert!(start.0.distance(DVec2::ZERO) < 1e-9 && end.0.distance(dvec2(10.0, 0.0)) < 1e-9);
    }
}
