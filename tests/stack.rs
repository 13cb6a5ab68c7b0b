//! Stacks of more than two curves from end to end: against closed forms, against pairs, and on random curves.

#![cfg(feature = "stack")]

use crate::support::seeded;
use directrix::document::{Diagnostic, Json, Outcome, Solution, Solve, read_text, span_document, write_text};
use directrix::geom::locate;
use directrix::morph::{Refined, StackBlend, Weave};
use directrix::picture::{PictureOptions, figure, paint};
use glam::{DVec2, DVec3};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// A periodic cubic whose control points lie evenly on a circle: its samples lie on a circle but for the ripple of the spline.
fn ring(radius: f64, count: usize, height: f64) -> Value {
    let point = |k: usize| (radius * DVec2::from_angle(TAU * k as f64 / count as f64)).to_array();
    let points: Vec<[f64; 2]> = (0..count).map(point).collect();
    json!({"degree": 3, "form": "periodic", "points": points, "height": height})
}

fn stack(curves: Vec<Value>, kind: &str) -> Value {
    let count = curves.len();
    let materials: Vec<Value> =
        (0..count).map(|k| json!({"name": format!("m{k}"), "color": format!("#0{k:x}8844")})).collect();
    json!({
        "directrix": 1, "kind": "curves", "materials": materials, "curves": curves,
        "sampling": {"counts": vec![24; count]},
        "matching": {"method": "exact", "oneToOne": true, "lines": 24},
        "blend": {"kind": kind, "stages": 4},
    })
}

fn solve(document: &Value) -> Solution {
    Solve::run(read_text(&document.to_string()).expect("a valid document")).expect("valid curves")
}

fn blend(solution: &Solution) -> &StackBlend {
    let stack = solution.stack().expect("a stack");
    stack.blend.as_ref().unwrap_or_else(|| panic!("no blend: {:?}", solution.diagnostics))
}

fn codes(solution: &Solution) -> Vec<&'static str> {
    solution.diagnostics.iter().map(Diagnostic::code).collect()
}

/// Radius of the circle on which the curve of `ring` lies, to about 1e-5 of it with 48 points.
fn drawn(radius: f64, count: usize) -> f64 {
    radius * (2.0 / 3.0 + (TAU / count as f64).cos() / 3.0)
}

#[test]
fn rings_of_any_spacing_blend_at_an_even_speed() {
    let radii = [10.0, 14.0, 30.0, 33.0];
    for kind in ["ruled", "cubic"] {
        let solution = solve(&stack(radii.iter().map(|&r| ring(r, 48, 0.0)).collect(), kind));
        assert!(solution.is_complete(), "{:?}", solution.diagnostics);
        let blend = blend(&solution);
        // Straight threads: the way along them is the difference of the radii, so that the radius is linear in s.
        for step in 0..=40 {
            let s = f64::from(step) / 40.0;
            let expected = drawn(10.0 + s * 23.0, 48);
            for point in blend.in_between(s) {
                assert!(
                    (point.length() - expected).abs() < 1e-3,
                    "{kind} {s}: {} {expected}",
                    point.length()
                );
            }
        }
        for (knot, radius) in blend.knots().iter().zip(radii) {
            assert!((knot - (radius - 10.0) / 23.0).abs() < 1e-4, "{kind}: {:?}", blend.knots());
        }
    }
}

#[test]
fn a_vase_follows_the_hermite_form_of_its_radii() {
    let (radii, heights) = ([20.0, 30.0, 24.0, 12.0], [0.0, 15.0, 32.0, 45.0]);
    let curves = radii.iter().zip(heights).map(|(&r, z)| ring(r, 48, z)).collect();
    let solution = solve(&stack(curves, "cubic"));
    assert!(solution.is_complete(), "{:?}", solution.diagnostics);
    let blend = blend(&solution);
    // Knots by the ways between the circles, then the parabola of three points at each, written out independently.
    let radius = |k: usize| drawn(radii[k], 48);
    let ways: Vec<f64> =
        (0..3).map(|k| (radius(k + 1) - radius(k)).hypot(heights[k + 1] - heights[k])).collect();
    let whole: f64 = ways.iter().sum();
    let knots = [0.0, ways[0] / whole, (ways[0] + ways[1]) / whole, 1.0];
    let parabola = |k: usize, s: f64, value: &dyn Fn(usize) -> f64| {
        let (a, b, c) = (knots[k - 1], knots[k], knots[k + 1]);
        value(k - 1) * (2.0 * s - b - c) / ((a - b) * (a - c))
            + value(k) * (2.0 * s - a - c) / ((b - a) * (b - c))
            + value(k + 1) * (2.0 * s - a - b) / ((c - a) * (c - b))
    };
    for (span, share) in [(0, 0.0), (0, 0.3), (0, 0.9), (1, 0.5), (1, 0.75), (2, 0.2), (2, 1.0)] {
        let step = knots[span + 1] - knots[span];
        let slope = |k: usize| parabola(k.clamp(1, 2), knots[k], &radius) * step;
        let t: f64 = share;
        let hermite = radius(span) * (2.0 * t.powi(3) - 3.0 * t * t + 1.0)
            + slope(span) * (t.powi(3) - 2.0 * t * t + t)
            + radius(span + 1) * (3.0 * t * t - 2.0 * t.powi(3))
            + slope(span + 1) * (t.powi(3) - t * t);
        let row = blend.row(span, share);
        for point in &row.points {
            let found = point.truncate().length();
            assert!((found - hermite).abs() < 2e-3, "{span} {share}: {found} {hermite}");
            assert!((heights[span]..=heights[span + 1]).contains(&point.z));
        }
    }
    assert_eq!(blend.rows(4).len(), 13);
}

#[test]
fn a_linear_stack_of_two_is_the_pair_to_the_bit() {
    let document =
        read_text(&stack(vec![ring(10.0, 9, 0.0), ring(30.0, 14, 4.0)], "cubic").to_string()).expect("valid");
    let solution = Solve::run(document).expect("valid curves");
    let band = solution.band().expect("a band");
    let places: Vec<(f64, f64)> = band.lines().map(|line| (line.u, line.v)).collect();
    let model = &solution.model;
    let mut weave =
        Weave::new(model.curves().to_vec(), vec![0.0, 4.0], &[places], true, Refined::By(band.per_line()));
    let compose = |curve: usize, u: f64| model.composition(curve, u);
    let blend = weave.step(&compose, &mut || true).expect("at once").expect("a blend");
    for s in [0.0, 0.2, 0.5, 0.8, 1.0] {
        assert_eq!(blend.in_between(s), band.in_between(s), "{s}");
        let row = blend.row(0, s);
        let mixes: Vec<_> = band.rulings().iter().map(|ruling| ruling.composition(s)).collect();
        assert_eq!(row.compositions, mixes, "{s}");
    }
    assert_eq!(blend.unit_cells(5), directrix::morph::unit_cells(band, 5));
    assert_eq!(&blend.strip(0, 0.0, 1.0), band);
    let at = DVec2::new(13.0, 5.0);
    let (found, expected) = (blend.locate(at).expect("inside"), band.locate(at).expect("inside"));
    assert_eq!(
        (found.s, found.u, found.v, found.composition),
        (expected.s, expected.u, expected.v, expected.composition)
    );
}

#[test]
fn spans_are_the_results_of_their_pairs() {
    let document = stack(vec![ring(10.0, 8, 0.0), ring(20.0, 11, 0.0), ring(30.0, 7, 3.0)], "ruled");
    let whole = read_text(&document.to_string()).expect("valid");
    let solution = solve(&document);
    for (span, own) in solution.stack().expect("a stack").spans.iter().enumerate() {
        let pair = Solve::run(span_document(&whole, span)).expect("valid curves");
        let [a, b] = [&pair, own].map(|it| it.lines().expect("matched"));
        assert_eq!(a.1, b.1, "lines of span {span}");
        assert_eq!((a.2.integral, a.2.count), (b.2.integral, b.2.count));
    }
}

/// A closed curve with lobes.
fn lobed(radius: f64, numbers: &[f64], height: f64) -> Value {
    let count = 12;
    let point = |k: usize| {
        let angle = TAU * k as f64 / count as f64;
        let lobes: f64 =
            numbers.iter().enumerate().map(|(n, a)| a * ((n + 2) as f64 * angle + a * 9.0).cos()).sum();
        (radius * (1.0 + lobes) * DVec2::from_angle(angle)).to_array()
    };
    json!({"degree": 3, "form": "periodic", "points": (0..count).map(point).collect::<Vec<_>>(), "height": height})
}

/// Random stacks: radius steps, lobes, heights and mixes of three materials.
fn random_stack() -> impl Strategy<Value = Value> {
    let curve = (
        4.0..12.0_f64,
        prop::collection::vec(-0.09..0.09_f64, 2),
        0.0..9.0_f64,
        prop::collection::vec(0.0..1.0_f64, 4),
    );
    (prop::collection::vec(curve, 3..6), any::<bool>()).prop_map(|(curves, level)| {
        let (mut radius, mut height) = (12.0, 0.0);
        let list = curves.iter().map(|(step, lobes, climb, mix)| {
            radius += step + radius * 0.3;
            height += if level { 0.0 } else { *climb };
            let mut curve = lobed(radius, lobes, height);
            // Two keys, of which many fractions are 0.
            let key = |at: f64, a: f64, b: f64| {
                let a = if a < 0.4 { 0.0 } else { a };
                let b = if b > 0.6 { 1.0 - a } else { (1.0 - a) * b };
                let rest = 1.0 - a - b;
                json!({"at": at, "mix": [a, b, if rest.abs() < 1e-9 { 0.0 } else { rest }]})
            };
            curve["composition"] = json!([key(0.1, mix[0], mix[1]), key(0.6, mix[2], mix[3])]);
            curve
        });
        let mut document = stack(list.collect(), "cubic");
        document["materials"] = json!([
            {"name": "a", "color": "#f0e442"}, {"name": "b", "color": "#0072b2"}, {"name": "c", "color": "#009e73"}
        ]);
        document["sampling"]["counts"] = json!(vec![20; curves.len()]);
        document["matching"] = json!({"method": "exact"});
        document
    })
}

#[test]
fn cubic_blends_stay_in_the_simplex_and_between_heights() {
    let blended = std::cell::Cell::new(0);
    seeded(24, &random_stack(), |document| {
        let solution = solve(&document);
        let Some(blend) = solution.stack().and_then(|stack| stack.blend.as_ref()) else { return Ok(()) };
        blended.set(blended.get() + 1);
        let heights: Vec<f64> = solution.model.document().curves.iter().map(|curve| curve.height).collect();
        for (span, share) in blend.stages(7) {
            let row = blend.row(span, share);
            for (point, mix) in row.points.iter().zip(&row.compositions) {
                prop_assert!(mix.fractions().iter().all(|&f| (0.0..=1.0 + 1e-15).contains(&f)), "{mix:?}");
                prop_assert!((mix.fractions().iter().sum::<f64>() - 1.0).abs() < 1e-14);
                prop_assert!(point.z >= heights[span] - 1e-12 && point.z <= heights[span + 1] + 1e-12);
            }
        }
        Ok(())
    });
    assert!(blended.get() >= 18, "only {} of 24 stacks were blended", blended.get());
}

/// At an inner curve the one-sided difference quotients of a C1 blend differ by as much as the step, those of a linear one do not.
#[test]
fn a_cubic_has_no_kink_at_inner_curves_and_a_linear_one_has() {
    let keys = |a: f64, b: f64| json!([{"at": 0, "mix": [a, 1.0 - a]}, {"at": 0.5, "mix": [b, 1.0 - b]}]);
    let document = |kind: &str| {
        let shapes =
            [(14.0, 0.0, 0.7, 0.5), (26.0, 10.0, 0.4, 0.8), (34.0, 14.0, 0.5, 0.3), (52.0, 33.0, 0.6, 0.9)];
        let curves = shapes.iter().enumerate().map(|(k, &(r, z, a, b))| {
            let mut curve = lobed(r, &[0.05 * k as f64 - 0.08, 0.06], z);
            curve["composition"] = keys(a, b);
            curve
        });
        let mut document = stack(curves.collect(), kind);
        document["materials"] = json!([{"name": "a", "color": "#f0e442"}, {"name": "b", "color": "#0072b2"}]);
        document
    };
    let jump = |kind: &str, step: f64| {
        let solution = solve(&document(kind));
        let blend = blend(&solution);
        let row = |s: f64| {
            let (span, share) = blend.span_at(s);
            blend.row(span, share)
        };
        let mut worst = [0.0_f64; 2];
        for &knot in &blend.knots()[1..blend.spans()] {
            let [before, at, after] = [knot - step, knot, knot + step].map(row);
            for k in 0..at.points.len() {
                let second: DVec3 = (after.points[k] - at.points[k]) - (at.points[k] - before.points[k]);
                let fraction = |row: &directrix::morph::Row| row.compositions[k].fractions()[0];
                let mixes = (fraction(&after) - fraction(&at)) - (fraction(&at) - fraction(&before));
                worst = [worst[0].max(second.length() / step), worst[1].max(mixes.abs() / step)];
            }
        }
        worst
    };
    let steps = [1e-2, 5e-3, 2.5e-3];
    let cubic = steps.map(|step| jump("cubic", step));
    for pair in cubic.windows(2) {
        for (coarse, fine) in pair[0].iter().zip(pair[1]) {
            let rate = coarse / fine;
            assert!(
                (1.7..2.3).contains(&rate),
                "the jump of the slope falls by {rate} at half the step: {cubic:?}"
            );
        }
    }
    let linear = steps.map(|step| jump("ruled", step));
    assert!(linear.iter().flatten().all(|&jump| jump > 0.05), "{linear:?}");
    assert!((linear[0][0] / linear[2][0] - 1.0).abs() < 1e-6, "a kink keeps its size: {linear:?}");
}

#[test]
fn reordering_twice_is_the_identity() {
    let curves = vec![ring(12.0, 8, 0.0), ring(20.0, 11, 6.0), ring(16.0, 7, 12.0)];
    let first = solve(&stack(curves.clone(), "cubic"));
    let turned: Vec<Value> = curves.into_iter().rev().collect();
    let back: Vec<Value> = turned.iter().cloned().rev().collect();
    let (turned, back) = (solve(&stack(turned, "cubic")), solve(&stack(back, "cubic")));
    assert_eq!(blend(&first), blend(&back));
    // Reversed once, the stack is the same the other way round.
    let s = [0.2, 0.5, 0.7];
    let length = |points: Vec<DVec2>| {
        points.iter().zip(points.iter().cycle().skip(1)).map(|(a, b)| a.distance(*b)).sum::<f64>()
    };
    for s in s {
        let [a, b] = [blend(&first).in_between(s), blend(&turned).in_between(1.0 - s)].map(length);
        assert!((a / b - 1.0).abs() < 2e-3, "{a} {b}");
    }
}

#[test]
fn what_is_out_of_order_is_named() {
    let solution = solve(&stack(vec![ring(10.0, 8, 0.0), ring(30.0, 8, 0.0), ring(20.0, 8, 0.0)], "ruled"));
    assert!(!solution.is_complete());
    assert!(
        solution.diagnostics.iter().any(|it| matches!(it, Diagnostic::Order { curve: 1, .. })),
        "{:?}",
        codes(&solution)
    );
    let line = |y: f64| json!({"degree": 2, "form": "open", "points": [[0, y], [10, y], [20, y], [30, y]]});
    let open = |ys: [f64; 3]| solve(&stack(ys.map(line).to_vec(), "cubic"));
    assert!(open([0.0, 10.0, 20.0]).is_complete());
    let mixed = open([0.0, 20.0, 10.0]);
    assert!(codes(&mixed).contains(&"order") && !mixed.is_complete(), "{:?}", codes(&mixed));
    let meeting = stack(vec![ring(10.0, 8, 0.0), ring(20.0, 8, 5.0), ring(10.0, 8, 0.0)], "ruled");
    assert!(matches!(&solve(&meeting).outcome, Outcome::Refused(error) if error.path == "curves[2].points"));
}

/// Two rings close together beside a far one: the parabola overshoots the near pair where threads bend.
#[test]
fn an_overlap_of_a_cubic_is_reported_with_its_place() {
    let shift = |mut curve: Value, by: f64| {
        for point in curve["points"].as_array_mut().expect("points") {
            point[0] = json!(point[0].as_f64().expect("a number") + by);
        }
        curve
    };
    let curves = vec![ring(10.0, 16, 0.0), ring(12.0, 16, 0.0), shift(ring(60.0, 16, 0.0), 44.0)];
    let cubic = solve(&stack(curves.clone(), "cubic"));
    let found = cubic.diagnostics.iter().find_map(|it| match it {
        Diagnostic::Overlap { span, at } => Some((*span, *at)),
        _ => None,
    });
    let (span, at) = found.unwrap_or_else(|| panic!("{:?}", cubic.diagnostics));
    let stack_found = cubic.stack().expect("a stack");
    assert!(stack_found.blend.is_none() && !stack_found.is_complete);
    // By brute force: in-between curves of the same blend do meet, in that span.
    let places: Vec<Vec<(f64, f64)>> = stack_found
        .spans
        .iter()
        .map(|span| span.band().expect("a band").lines().map(|line| (line.u, line.v)).collect())
        .collect();
    let model = &cubic.model;
    let mut weave = Weave::new(model.curves().to_vec(), vec![0.0; 3], &places, true, Refined::Towards(176));
    let blend =
        weave.step(&|curve, u| model.composition(curve, u), &mut || true).expect("at once").expect("a blend");
    let rings: Vec<Vec<DVec2>> = (0..=32).map(|k| blend.in_between_at(span, f64::from(k) / 32.0)).collect();
    let meets =
        |a: &Vec<DVec2>, b: &Vec<DVec2>| directrix::geom::first_contact(a, b, true).map(|(k, _)| a[k]);
    let contact =
        (0..32).flat_map(|i| (i + 1..33).map(move |j| (i, j))).find_map(|(i, j)| meets(&rings[i], &rings[j]));
    assert!(contact.is_some(), "nothing meets in span {span}, but {at} is said to be turned over");
    assert!(solve(&stack(curves, "ruled")).is_complete());
}

/// The certificate that nothing overlaps, against brute force: the in-between curves of accepted level blends lie one inside the next.
#[test]
fn accepted_level_blends_are_nested() {
    let seen = std::cell::Cell::new(0);
    seeded(12, &random_stack(), |mut document| {
        for curve in document["curves"].as_array_mut().expect("curves") {
            curve["height"] = json!(0);
        }
        let solution = solve(&document);
        let Some(blend) = solution.stack().and_then(|stack| stack.blend.as_ref()) else { return Ok(()) };
        seen.set(seen.get() + 1);
        let rings: Vec<Vec<DVec2>> =
            blend.stages(8).map(|(span, share)| blend.in_between_at(span, share)).collect();
        for pair in rings.windows(2) {
            prop_assert!(directrix::geom::first_contact(&pair[0], &pair[1], true).is_none());
            prop_assert!(locate(&pair[1], pair[0][0]) == directrix::geom::Location::Inside);
        }
        Ok(())
    });
    assert!(seen.get() >= 8, "{}", seen.get());
}

#[test]
fn open_stacks_run_one_way_however_they_were_drawn() {
    let wave = |y: f64, reversed: bool, height: f64| {
        let mut points: Vec<[f64; 2]> =
            (0..7).map(|k| [10.0 * f64::from(k), y + 3.0 * f64::from(k % 2)]).collect();
        if reversed {
            points.reverse();
        }
        json!({"degree": 3, "form": "open", "points": points, "height": height})
    };
    let drawn = [false, true, true, false];
    let curves = |turned: [bool; 4]| (0..4).map(|k| wave(12.0 * k as f64, turned[k], 0.0)).collect();
    let solution = solve(&stack(curves(drawn), "cubic"));
    assert!(solution.is_complete(), "{:?}", solution.diagnostics);
    assert_eq!(solution.model.reversed(), drawn);
    let straight = solve(&stack(curves([false; 4]), "cubic"));
    let [a, b] = [blend(&solution).in_between(0.4), blend(&straight).in_between(0.4)];
    assert!(a.iter().zip(&b).all(|(a, b)| a.distance(*b) < 1e-6));
}

#[test]
fn pins_hold_in_the_span_that_they_name() {
    let mut document = stack(vec![ring(10.0, 8, 0.0), ring(20.0, 8, 0.0), ring(30.0, 8, 0.0)], "ruled");
    document["matching"]["pins"] = json!([{"u": 0.1, "v": 0.12, "pair": 1}]);
    let read = read_text(&document.to_string()).expect("valid");
    assert_eq!(read_text(&write_text(&read).expect("finite")), Ok(read));
    let solution = solve(&document);
    let spans = &solution.stack().expect("a stack").spans;
    let has = |span: usize| {
        let near = |x: f64, y: f64| ((x - y) - (x - y).round()).abs() < 1e-9;
        spans[span].band().expect("a band").lines().any(|line| near(line.u, 0.1) && near(line.v, 0.12))
    };
    assert!(has(1) && !has(0));
    let crossed =
        json!([{"u": 0.1, "v": 0.1}, {"u": 0.1, "v": 0.14, "pair": 1}, {"u": 0.14, "v": 0.1, "pair": 1}]);
    document["matching"]["pins"] = crossed;
    let refused = solve(&document);
    let pins = refused.diagnostics.iter().find_map(|it| match it {
        Diagnostic::InSpan { span, remark } => match &**remark {
            Diagnostic::Pins { pins, .. } => Some((*span, pins.clone())),
            _ => None,
        },
        _ => None,
    });
    assert_eq!(pins, Some((1, vec![1, 2])), "{:?}", refused.diagnostics);
}

#[test]
fn work_on_a_stack_can_be_stopped_at_any_time() {
    let text = stack((0..6).map(|k| ring(10.0 + 6.0 * f64::from(k), 12, 0.0)).collect(), "cubic").to_string();
    let mut job = Solve::new(read_text(&text).expect("valid")).expect("valid curves");
    let (mut steps, mut reached) = (0, 0.0);
    let solution = loop {
        if let Some(solution) = job.step(&mut || false) {
            break solution;
        }
        let progress = job.progress();
        assert!(progress >= reached && progress <= 1.0, "{reached} {progress}");
        (steps, reached) = (steps + 1, progress);
    };
    assert!(steps > 500, "{steps}");
    assert_eq!(blend(&solution), blend(&solve(&serde_json::from_str(&text).expect("JSON"))));
}

#[test]
fn every_layer_of_a_stack_is_drawn() {
    let heights = [[0.0; 3], [0.0, 9.0, 20.0]];
    let layers = [
        "material",
        "unitCells",
        "inBetweens",
        "rulingLines",
        "samples",
        "unconnected",
        "controlPoints",
        "normals",
        "value",
        "isoComposition",
    ];
    for (kind, z) in ["ruled", "cubic"].into_iter().flat_map(|kind| heights.map(|z| (kind, z))) {
        let solution =
            solve(&stack(vec![ring(10.0, 8, z[0]), ring(20.0, 8, z[1]), ring(30.0, 8, z[2])], kind));
        assert!(solution.is_complete(), "{:?}", solution.diagnostics);
        for layer in layers {
            for patterns in [false, true] {
                let options = json!({"width": 160, "height": 120, "layers": [layer], "patterns": patterns, "s": 0.4, "line": 30});
                let options =
                    PictureOptions::read(&Json::parse(&options.to_string()).expect("JSON")).expect("options");
                let viewport = options.viewport(&solution.model);
                let list = figure(&solution, &options.figure(&solution.model), &viewport);
                assert_eq!(paint(&list, &viewport).expect("painted").len(), 160 * 120 * 4);
                let names: Vec<&str> = list.layers.iter().map(|layer| layer.name.as_str()).collect();
                assert!(names.contains(&"current") && names.contains(&"line"), "{names:?}");
            }
        }
        // Lines of equal fraction go through inner curves in one piece.
        let lines = blend(&solution).iso_lines(1, 0.5);
        assert_eq!(lines.len(), 2, "inside and outside of the middle ring");
        assert!(lines.iter().all(|line| line.closed));
    }
}

/// A linear stack encloses what its pairs enclose, cut apart at the inner curves; a cubic one what its own profile does.
#[cfg(feature = "solid")]
#[test]
fn solids_of_stacks_are_closed_and_hold_the_right_volume() {
    use directrix::document::{SolidJob, SolidOptions};
    use std::rc::Rc;
    let options =
        |text: &str| SolidOptions::read(&Json::parse(text).expect("JSON"), 4).expect("valid options");
    let solid = |document: &Value, text: &str| {
        let found = SolidJob::run(Rc::new(solve(document)), options(text)).expect("within the limits");
        found.expect("a solid")
    };
    let curves =
        || vec![ring(20.0, 48, 0.0), ring(30.0, 48, 15.0), ring(24.0, 48, 32.0), ring(12.0, 48, 45.0)];
    let whole = solid(&stack(curves(), "ruled"), "{}");
    assert!(whole.is_watertight && whole.remarks.is_empty(), "{:?}", whole.remarks);
    let parts: f64 = curves()
        .windows(2)
        .map(|pair| solid(&stack(pair.to_vec(), "ruled"), "{}").volume.expect("a closed mesh"))
        .sum();
    let volume = whole.volume.expect("a closed mesh");
    assert!((volume / parts - 1.0).abs() < 1e-3, "{volume} {parts}");

    let document = stack(curves(), "cubic");
    let cubic = solid(&document, r#"{"stages": 40}"#);
    assert!(cubic.is_watertight, "{:?}", cubic.remarks);
    // The radius of the first strand over its height, by the rows of the blend.
    let solution = solve(&document);
    let rows = blend(&solution).rows(400);
    let slices = rows.windows(2).map(|pair| {
        let [a, b] = [&pair[0], &pair[1]].map(|row| (row.points[0].truncate().length(), row.points[0].z));
        std::f64::consts::PI * (b.1 - a.1) * (a.0 * a.0 + a.0 * b.0 + b.0 * b.0) / 3.0
    });
    let expected: f64 = slices.sum();
    assert!(
        (cubic.volume.expect("a closed mesh") / expected - 1.0).abs() < 2e-3,
        "{:?} {expected}",
        cubic.volume
    );
    assert!(cubic.volume > whole.volume, "the belly bulges");
    assert_eq!(cubic.stages.len(), 121);

    // Angles belong to the span of a row; there is no solid in the plane.
    let angled = solid(&document, r#"{"color": "twist"}"#);
    assert_eq!(angled.mesh.scalars.len(), angled.mesh.positions.len());
    let flat = stack(vec![ring(10.0, 8, 0.0), ring(20.0, 8, 0.0), ring(30.0, 8, 0.0)], "ruled");
    assert!(SolidJob::run(Rc::new(solve(&flat)), options("{}")).expect("within the limits").is_none());
}
