//! Every method of matching, through documents: on the presets, with pins, with repair, with heights, as printed.

use directrix::curve::BSpline;
use directrix::document::{Diagnostic, GapKind, Outcome, Solution, Solve, read_text};
use directrix::matching::{OneToOne, Totals, places_of};
use glam::DVec2;
use serde_json::{Value, json};
use std::f64::consts::TAU;
use std::path::Path;

/// The presets of two curves: the methods are those of a pair.
fn presets() -> Vec<(String, Value)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/presets");
    let mut presets: Vec<(String, Value)> = std::fs::read_dir(folder)
        .expect("presets")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|e| e == "json") && !path.ends_with("index.json"))
        .map(|path| {
            let text = std::fs::read_to_string(&path).expect("a file");
            let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
            (name, serde_json::from_str::<Value>(&text).expect("JSON"))
        })
        .filter(|(_, document)| document["curves"].as_array().is_some_and(|curves| curves.len() == 2))
        .collect();
    presets.sort_by(|a, b| a.0.cmp(&b.0));
    presets
}

fn preset(name: &str) -> Value {
    presets().into_iter().find(|(known, _)| known == name).expect("a preset").1
}

fn with(document: &Value, matching: Value) -> Value {
    let mut document = document.clone();
    document["matching"] = matching;
    // A harmonic blend has no lines to be matched.
    document["blend"]["kind"] = json!("ruled");
    document
}

fn solve(document: &Value) -> Solution {
    Solve::run(read_text(&document.to_string()).expect("a document")).expect("curves")
}

fn lines(solution: &Solution) -> &Totals {
    match &solution.outcome {
        Outcome::Matched { matching, .. } => &matching.totals,
        _ => panic!("{:?}", solution.diagnostics),
    }
}

fn pairs(solution: &Solution) -> Option<&OneToOne> {
    match &solution.outcome {
        Outcome::Matched { pairs, .. } => pairs.as_deref(),
        _ => None,
    }
}

fn gap(solution: &Solution) -> Option<(f64, GapKind)> {
    match &solution.outcome {
        Outcome::Matched { gap, .. } => gap.map(|gap| (gap.value, gap.kind)),
        _ => None,
    }
}

fn codes(solution: &Solution) -> Vec<&'static str> {
    solution.diagnostics.iter().map(Diagnostic::code).collect()
}

fn rings(heights: [f64; 2], center: [f64; 2], radii: [f64; 2]) -> Value {
    let ring = |radius: f64, center: DVec2| -> Value {
        (0..12)
            .map(|k| json!((center + radius * DVec2::from_angle(TAU * f64::from(k) / 12.0)).to_array()))
            .collect()
    };
    json!({
        "directrix": 1, "kind": "curves", "matching": {"method": "exact"},
        "curves": [
            {"degree": 3, "form": "periodic", "points": ring(radii[0], center.into()), "height": heights[0]},
            {"degree": 3, "form": "periodic", "points": ring(radii[1], DVec2::ZERO), "height": heights[1]},
        ],
    })
}

const METHODS: [&str; 5] = ["exact", "greedy", "one-per-vertex", "shift", "parameter"];

#[test]
fn on_every_preset_certificates_hold_and_no_lines_beat_the_optimum() {
    for (name, document) in presets() {
        let run = |method: &str, one_to_one: bool| {
            let weights = &document["matching"];
            let mut matching = json!({"method": method, "oneToOne": one_to_one});
            for weight in ["normalWeight", "distanceWeight", "negative"] {
                if weights.get(weight).is_some() {
                    matching[weight] = weights[weight].clone();
                }
            }
            solve(&with(&document, matching))
        };
        let optimum = run("exact", false);
        let best = lines(&optimum).integral.filter(|_| optimum.is_complete());
        for method in METHODS {
            let plain = run(method, false);
            if let (true, Some(best), Some(j)) = (plain.is_complete(), best, lines(&plain).integral)
                && !matches!(method, "shift" | "parameter")
            {
                assert!(j <= best * (1.0 + 1e-12), "{name}, {method}: {j} above {best}");
            }
            if let Some((value, kind)) = gap(&plain) {
                assert!(
                    kind == GapKind::Lattice && (-1e-12..1.0).contains(&value),
                    "{name}, {method}: {value}"
                );
            }
            let solution = run(method, true);
            let Some(pairs) = pairs(&solution) else { continue };
            let totals = &pairs.totals;
            let is_sound = totals.crossings + totals.blocked == 0;
            assert_eq!(solution.is_complete(), is_sound, "{name}, {method}");
            assert!(totals.eta.is_none_or(|eta| eta <= 1.0 + 1e-12), "{name}, {method}");
            assert!(
                pairs.places.windows(2).all(|w| w[0].0 < w[1].0 && w[0].1 < w[1].1)
                    || !pairs.failed.is_empty()
            );
            if method == "exact" {
                assert!(is_sound, "{name}: {} crossings, {} blocked", totals.crossings, totals.blocked);
            }
        }
    }
}

#[test]
fn on_the_reference_pair_the_methods_are_ordered_as_in_the_paper() {
    let document = preset("reference-pair");
    let sum = |method: &str, k: Value| {
        let mut matching = json!({"method": method, "oneToOne": true, "lines": 44});
        if method == "shift" {
            matching["shift"] = k;
        }
        let mut document = with(&document, matching);
        document["sampling"] = json!({"scheme": "arc-length", "counts": [44, 44]});
        let solution = solve(&document);
        let Outcome::Matched { details, .. } = &solution.outcome else { panic!("matched") };
        details[1].expect("pairs").spread_sum / pairs(&solution).expect("pairs").lines.len() as f64
    };
    let values = [
        sum("parameter", json!(null)),
        sum("shift", json!("best")),
        sum("greedy", json!(null)),
        sum("exact", json!(null)),
    ];
    assert!(values.windows(2).all(|w| w[0] < w[1]), "{values:?}");
    let shifts = (0..44).map(|k| sum("shift", json!(k)));
    assert!(shifts.fold(f64::NEG_INFINITY, f64::max) <= values[1] * (1.0 + 1e-3), "every shift was tried");
}

#[test]
fn exact_gives_as_many_lines_as_asked_for_and_names_its_gap() {
    let document = preset("amoeba");
    let mut gaps = Vec::new();
    for count in [3, 44, 177] {
        let solution = solve(&with(&document, json!({"method": "exact", "oneToOne": true, "lines": count})));
        assert!(solution.is_complete());
        assert_eq!(pairs(&solution).expect("pairs").lines.len(), count);
        let Outcome::Matched { gap: Some(gap), pairs: Some(pairs), .. } = &solution.outcome else {
            panic!("refined")
        };
        assert!(gap.change.is_some_and(|change| change < 1e-4), "{gap:?}");
        assert_eq!(gap.kind, GapKind::Supremum, "one of its points is joined with an arc");
        let integral = pairs.totals.integral.expect("J");
        assert!((1.0 - integral / gap.optimum - gap.value).abs() < 1e-12);
        gaps.push(gap.value);
    }
    assert!(gaps[0] > 0.1 && gaps[1] < 1e-3 && gaps[2] < gaps[1] / 3.0, "more lines come nearer: {gaps:?}");
    let greedy = solve(&with(&document, json!({"method": "greedy", "oneToOne": true})));
    let (value, kind) = gap(&greedy).expect("the lattice optimum is known");
    assert!(kind == GapKind::Lattice && value.abs() < 0.05, "{value}");
}

/// Whether a pair joins two parameters, up to whole domains.
fn joins(curves: &[BSpline], pairs: &OneToOne, (u, v): (f64, f64)) -> bool {
    let is_same = |axis: usize, x: f64, y: f64| {
        let (lo, hi) = curves[axis].domain();
        let laps = (x - y) / (hi - lo);
        (laps - laps.round()).abs() < 1e-6
    };
    pairs.places.iter().any(|&(x, y)| is_same(0, x, u) && is_same(1, y, v))
}

#[test]
fn pins_are_joined_whatever_way_the_curves_are_drawn() {
    let mut document = rings([0.0, 0.0], [1.0, 2.0], [10.0, 30.0]);
    for reverse in [false, true] {
        if reverse {
            document["curves"][1]["points"].as_array_mut().expect("points").reverse();
        }
        // On the outer curve drawn backwards the same place has another parameter.
        let free = solve(&with(&document, json!({"method": "exact", "oneToOne": true})));
        let (u, v) = pairs(&free).expect("pairs").places[5];
        let off = v + 0.04;
        let drawn = if reverse { 1.0 - off } else { off };
        let pinned = json!({"method": "exact", "oneToOne": true, "pins": [{"u": u, "v": drawn}]});
        let solution = solve(&with(&document, pinned));
        assert!(solution.is_complete(), "{:?}", solution.diagnostics);
        let found = pairs(&solution).expect("pairs");
        assert!(joins(solution.model.curves(), found, (u, off)), "reversed {reverse}: {u} {off}");
        assert!(!joins(solution.model.curves(), pairs(&free).expect("pairs"), (u, off)));
        assert!(found.totals.integral < pairs(&free).expect("pairs").totals.integral);
        assert_eq!(gap(&solution).expect("the free optimum is known").1, GapKind::Lattice);
    }
}

#[test]
fn contradictory_pins_are_named() {
    let document = rings([0.0, 0.0], [0.0, 0.0], [10.0, 30.0]);
    let pinned = |pins: Value| solve(&with(&document, json!({"method": "exact", "pins": pins})));
    let solution = pinned(json!([{"u": 0.6, "v": 0.6}, {"u": 0.1, "v": 0.15}, {"u": 0.15, "v": 0.1}]));
    assert!(!solution.is_complete());
    let named = solution.diagnostics.iter().find_map(|d| match d {
        Diagnostic::Pins { pins, .. } => Some(pins.clone()),
        _ => None,
    });
    assert_eq!(named, Some(vec![1, 2]));
    assert_eq!(lines(&solution).crossings, 0, "what is shown is sound");
    // Half a turn apart: the line passes through the inner ring.
    let solution = pinned(json!([{"u": 0.0, "v": 0.5}]));
    let message = solution.diagnostics.iter().map(ToString::to_string).collect::<String>();
    assert!(message.contains("pin 0 meets a curve"), "{message}");
}

#[test]
fn repair_reaches_every_vertex_and_marks_what_it_added() {
    let document = preset("closed-pocket");
    for method in ["exact", "greedy"] {
        let strict = solve(&with(&document, json!({"method": method})));
        assert!(!strict.is_complete() && strict.band().is_none());
        assert!(codes(&strict).contains(&"orphan"), "{:?}", codes(&strict));
        let repaired = solve(&with(&document, json!({"method": method, "policy": "repair"})));
        assert!(!repaired.is_complete(), "what was added does not count as sound");
        assert!(repaired.band().is_some(), "but it goes over from one curve to the other");
        let Outcome::Matched { problem, matching, occluded, .. } = &repaired.outcome else {
            panic!("matched")
        };
        assert!(!occluded.is_empty() && codes(&repaired).contains(&"occluded"));
        for (k, line) in matching.lines.iter().enumerate() {
            assert_eq!(problem.is_visible(line.from, line.to), !occluded.contains(&k), "line {k}");
        }
        assert_eq!(matching.totals.count + occluded.len(), matching.lines.len(), "totals leave them out");
        assert_eq!(matching.totals.blocked, 0);
    }
}

#[test]
fn crossing_projections_at_different_heights_are_matched() {
    let apart = rings([0.0, 20.0], [8.0, 0.0], [20.0, 20.0]);
    let solution = solve(&with(&apart, json!({"method": "exact", "oneToOne": true})));
    assert!(codes(&solution).contains(&"crossing"));
    let totals = lines(&solution);
    assert_eq!((totals.crossings, totals.blocked), (0, 0));
    assert!(solution.is_complete(), "{:?} {:?}", solution.diagnostics, totals.uncovered);
    let ignored = solve(&with(&apart, json!({"method": "exact", "printed": ["heights"]})));
    assert!(lines(&ignored).sum > totals.sum, "lengths without the height are shorter");
    let disjoint = solve(&rings([0.0, 20.0], [80.0, 0.0], [20.0, 20.0]));
    assert!(matches!(disjoint.outcome, Outcome::Unmatched) && codes(&disjoint) == ["disjoint"]);
}

#[test]
fn printed_rules_change_what_they_say() {
    let document = preset("amoeba");
    let run = |printed: Value| solve(&with(&document, json!({"method": "greedy", "printed": printed})));
    let repaired = run(json!([]));
    assert!(lines(&run(json!(["normals"]))).sum < 0.0, "a perfect match is -1");
    assert_eq!(lines(&run(json!(["stop"]))).count, 1);
    let removed = run(json!(["removal"]));
    assert!(lines(&removed).uncovered.iter().any(|bare| !bare.is_empty()));
    assert!(lines(&repaired).uncovered.iter().all(Vec::is_empty));
    let even = json!({"method": "exact", "normalWeight": 2, "printed": ["negative"]});
    assert!(lines(&solve(&with(&document, even))).sum > 0.0);
}

#[test]
fn methods_by_index_take_as_many_samples_of_one_curve_as_of_the_other() {
    let mut document = preset("nested-ellipses");
    document["sampling"] = json!({"scheme": "arc-length", "counts": [12, 31]});
    for (method, shift) in [("parameter", json!(null)), ("shift", json!(7)), ("shift", json!("best"))] {
        let mut matching = json!({"method": method});
        if method == "shift" {
            matching["shift"] = shift.clone();
        }
        let solution = solve(&with(&document, matching));
        let Outcome::Matched { problem, matching, .. } = &solution.outcome else { panic!("matched") };
        assert_eq!(problem.counts(), (31, 31));
        let places = places_of(problem, &matching.lines);
        assert!(places.windows(2).all(|w| w[0][0] < w[1][0] && w[0][1] < w[1][1]));
        if shift == json!(7) {
            assert!(matching.lines.iter().all(|line| line.to == (line.from + 7) % 31));
        }
    }
}

#[test]
fn a_greedy_matching_that_is_stuck_says_so_and_repair_solves_it() {
    let mut stuck = 0;
    let shapes = (1..8).flat_map(|k| [0.3, 0.5, 0.7].map(|width| (0.2 * f64::from(k), width)));
    for ((opening, width), count) in shapes.flat_map(|shape| [12, 20, 30].map(|count| (shape, count))) {
        let arc = |radius: f64, k: u32, n: u32| {
            let angle = opening / 2.0 + (TAU - opening) * f64::from(k) / f64::from(n - 1);
            json!((radius * DVec2::from_angle(angle)).to_array())
        };
        let bent: Vec<Value> = (0..24)
            .map(|k| arc(10.0, k, 24))
            .chain((0..18).rev().map(|k| arc(10.0 * (1.0 - width), k, 18)))
            .collect();
        let mut document = rings([0.0, 0.0], [0.0, 0.0], [10.0, 16.0]);
        document["curves"][0]["points"] = json!(bent);
        document["sampling"] = json!({"counts": [count, count + 3]});
        let strict = solve(&with(&document, json!({"method": "greedy"})));
        let exact = solve(&with(&document, json!({"method": "exact"})));
        let is_stuck = codes(&strict).contains(&"solvable");
        assert_eq!(is_stuck, !strict.is_complete() && exact.is_complete(), "{opening} {width} {count}");
        if is_stuck {
            stuck += 1;
            let repaired = solve(&with(&document, json!({"method": "greedy", "policy": "repair"})));
            assert!(repaired.is_complete());
        }
    }
    assert!(stuck > 0, "some of these shapes are hard for the greedy method: {stuck}");
}

#[test]
fn one_to_one_lines_come_as_near_to_the_optimum_of_sharp_corners_as_there_are_lines() {
    for (name, counts, least) in
        [("sharp-square", [48, 240, 960], [4e-3, 1e-3, 2e-4]), ("gear", [120, 480, 1000], [2e-2, 4e-3, 2e-3])]
    {
        let document = preset(name);
        for (count, least) in counts.into_iter().zip(least) {
            let matching = json!({"method": "exact", "oneToOne": true, "lines": count});
            let solution = solve(&with(&document, matching));
            assert!(solution.is_complete(), "{name}: {:?}", solution.diagnostics);
            let (value, kind) = gap(&solution).expect("refined");
            assert_eq!(kind, GapKind::Supremum, "{name}");
            assert!(value < least && value > -1e-4, "{name}, {count} lines: {value}");
        }
    }
}

#[test]
fn a_line_that_cannot_be_verified_makes_way_for_one_of_the_matching() {
    for count in [80, 100] {
        let mut document = preset("open-c");
        document["sampling"]["counts"] = json!([count, count]);
        let solution = solve(&document);
        assert!(solution.is_complete(), "{count}: {:?}", solution.diagnostics);
        assert!(codes(&solution).contains(&"unverified-gap"), "{count}: the gap is named");
        let pairs = pairs(&solution).expect("pairs");
        assert!(pairs.verified.iter().all(|&verified| verified));
        let kept: usize = pairs.failed.iter().map(|gap| gap.lines.len() - 2).sum();
        assert!((1..count / 4).contains(&kept), "{count}: {kept} lines were kept");
        let (value, kind) = gap(&solution).expect("that of the samples");
        assert!(kind == GapKind::Lattice && value.abs() < 1e-3, "{value}");
    }
}
