//! Documents from end to end: the presets, every refusal of a shape, and what a solution carries.

mod garbled;
mod pictures;
mod presets;

use self::presets::{Preset, presets};
use crate::support::seeded;
use directrix::document::Json;
use directrix::document::{
    Code, Diagnostic, DocumentError, Outcome, Solution, Solve, insert_point, read_text, write_text,
};
use directrix::matching::blocking_edge;
use directrix::morph::Band;
use directrix::picture::{Item, PictureOptions, figure, paint, to_svg};
use glam::{DVec2, dvec2};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::f64::consts::TAU;

fn ring(radius: f64, count: usize, center: DVec2) -> Value {
    let point = |k: usize| center + radius * DVec2::from_angle(TAU * k as f64 / count as f64);
    (0..count).map(|k| json!(point(k).to_array())).collect()
}

fn pair(inner: Value, outer: Value) -> Value {
    json!({
        "directrix": 1, "kind": "curves", "matching": {"method": "greedy"},
        "curves": [
            {"degree": 3, "form": "periodic", "points": inner},
            {"degree": 3, "form": "periodic", "points": outer},
        ],
    })
}

fn rings() -> Value {
    pair(ring(10.0, 12, DVec2::ZERO), ring(30.0, 12, DVec2::ZERO))
}

fn solve(document: &Value) -> Result<Solution, DocumentError> {
    Solve::run(read_text(&document.to_string())?)
}

/// Solves, and turns a refusal of the geometry into the error that `match` throws.
fn matched(document: &Value) -> Result<Solution, DocumentError> {
    let solution = solve(document)?;
    match &solution.outcome {
        Outcome::Refused(error) => Err(error.clone()),
        _ => Ok(solution),
    }
}

fn refused(document: &Value, code: Code, path: &str) -> DocumentError {
    let error = matched(document).expect_err("refused");
    assert_eq!((error.code, error.path.as_str()), (code, path), "{error}");
    error
}

fn codes(solution: &Solution) -> Vec<&'static str> {
    solution.diagnostics.iter().map(Diagnostic::code).collect()
}

#[test]
fn concentric_circles_and_offset_curves_have_eta_one() {
    let solution = matched(&rings()).expect("valid");
    let Outcome::Matched { matching, .. } = &solution.outcome else { panic!("matched") };
    let eta = matching.totals.eta.expect("covered");
    assert!((eta - 1.0).abs() < 1e-12, "equal counts, aligned seams: {eta}");

    // The samples of an offset curve: the same parameters, moved along the normal by a distance below the least radius of
    // curvature. The value of every line is then d^-2 and nothing is better.
    let curve = &solution.model.curves()[1];
    let wavy = pair(
        ring(1.0, 5, DVec2::ZERO),
        json!([[40, 0], [25, 25], [0, 30], [-30, 28], [-42, 0], [-20, -30], [10, -38]]),
    );
    let wavy = matched(&wavy).expect("valid");
    let base = &wavy.model.samples()[1];
    for distance in [0.5, 2.0] {
        let outset: Vec<DVec2> =
            base.points.iter().zip(&base.normals).map(|(p, n)| *p + distance * *n).collect();
        let outline =
            |points: &[DVec2]| directrix::matching::Outline::new(points.to_vec(), base.normals.clone());
        let problem = directrix::matching::Problem::new(
            [outline(&base.points), outline(&outset)],
            directrix::matching::Weights::default(),
            0.0,
        )
        .expect("an offset curve lies outside");
        let totals = directrix::matching::greedy(&problem).totals;
        assert!((totals.eta.expect("covered") - 1.0).abs() < 1e-12, "{distance}: {:?}", totals.eta);
        assert!((totals.integral.expect("covered") * distance * distance - 1.0).abs() < 1e-9);
    }
    assert!(curve.length() > 0.0);
}

#[test]
fn band_of_an_annulus_has_its_radii_and_fractions() {
    let solution = matched(&rings()).expect("valid");
    let band = solution.band().expect("complete");
    let radius = |curve: usize| solution.model.curves()[curve].point(0.0).length();
    let (near, far) = (radius(0), radius(1));
    for s in [0.0, 0.2, 0.5, 1.0] {
        for point in band.in_between(s) {
            // A cubic spline on 12 points is round to 1e-3.
            assert!((point.length() - (near + s * (far - near))).abs() < 2e-3 * far);
        }
    }
    for (angle, share) in [(0.1, 0.3), (2.0, 0.75), (4.4, 0.01), (6.2, 0.99)] {
        let point = (near + share * (far - near)) * DVec2::from_angle(angle);
        let place = band.locate(point).expect("inside the band");
        assert!((place.s - share).abs() < 2e-3, "{} at {share}", place.s);
        let fractions = place.composition.fractions();
        assert!((fractions[1] - place.s).abs() < 1e-12, "two pure materials");
        assert!((fractions.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    }
    assert_eq!(band.locate(DVec2::ZERO), None);
    assert_eq!(band.locate(dvec2(100.0, 0.0)), None);
    let cells = directrix::morph::unit_cells(band, 5);
    let area: f64 = cells.iter().map(|cell| directrix::geom::signed_area(&cell.corners)).sum();
    let sectors = solution.model.samples()[0].points.len() as f64;
    let exact = sectors / 2.0 * (TAU / sectors).sin() * (far * far - near * near);
    assert!((area / exact - 1.0).abs() < 2e-3, "cells tile the ring of {sectors} sectors");
}

/// Fractions of a material at a point in every patch between two rulings that holds it, by Newton's method.
fn fractions_by_newton(band: &Band, point: DVec2, material: usize) -> Vec<f64> {
    let rulings = band.rulings();
    let mut found = Vec::new();
    for (this, next) in rulings.iter().zip(rulings.iter().cycle().skip(1)) {
        let (mut t, mut s) = (0.5, 0.5);
        for _ in 0..40 {
            let across = next.point(s) - this.point(s);
            let along = (this.to - this.from).lerp(next.to - next.from, t);
            let miss = point - this.point(s).lerp(next.point(s), t);
            let area = across.perp_dot(along);
            if area.abs() > 1e-14 {
                t += miss.perp_dot(along) / area;
                s += across.perp_dot(miss) / area;
            }
        }
        let inside = |x: f64| (-1e-7..=1.0 + 1e-7).contains(&x);
        let reached = this.point(s).lerp(next.point(s), t).distance(point) < 1e-9;
        if inside(t) && inside(s) && reached {
            found.push(this.composition(s).mix(&next.composition(s), t).fractions()[material]);
        }
    }
    found
}

#[test]
fn iso_lines_of_every_preset_have_their_fraction_and_are_drawn() {
    for Preset { id, text, .. } in presets() {
        let solution = Solve::run(read_text(&text).expect("a valid document")).expect("valid curves");
        let Some(band) = solution.band() else { continue };
        let (mut met, mut points, mut elsewhere) = (0, 0, 0);
        for material in 0..solution.model.materials().len() {
            for tenth in 1..10 {
                let level = f64::from(tenth) / 10.0;
                for line in band.iso_lines(material, level) {
                    met += 1;
                    for point in line.points {
                        points += 1;
                        let has = |fraction: f64| (fraction - level).abs() < 1e-6;
                        let place = band.locate(point).expect("in the band");
                        if has(place.composition.fractions()[material]) {
                            continue;
                        }
                        // Patches that overlap have two compositions at one point, and the reading takes the first.
                        elsewhere += 1;
                        let all = fractions_by_newton(band, point, material);
                        assert!(all.len() > 1 && all.iter().any(|&f| has(f)), "{id}: {all:?} for {level}");
                    }
                }
            }
        }
        assert!(elsewhere * 50 <= points, "{id}: {elsewhere} of {points} points lie where patches overlap");
        assert!(met >= 9, "{id}: {met} lines");
        let draw = |options: Value| {
            let options =
                PictureOptions::read(&Json::parse(&options.to_string()).expect("JSON")).expect("valid");
            options.check(&solution.model)?;
            let viewport = options.viewport(&solution.model);
            let list = figure(&solution, &options.figure(&solution.model), &viewport);
            Ok::<_, DocumentError>((
                to_svg(&list, &viewport, "", ""),
                paint(&list, &viewport).expect("a picture"),
            ))
        };
        let size = json!({"width": 300, "height": 240, "layers": ["material", "isoComposition"]});
        let (svg, pixels) = draw(size.clone()).expect("valid");
        assert!(svg.contains("id=\"layer-iso-composition\""), "{id}");
        let mut plain = size.clone();
        plain["layers"] = json!(["material"]);
        let (bare, without) = draw(plain).expect("valid");
        assert!(!bare.contains("iso-composition") && pixels != without, "{id}");
        let mut beyond = size;
        beyond["isoMaterial"] = json!(16);
        let error = draw(beyond).expect_err("no such material");
        assert_eq!((error.code, error.path.as_str()), (Code::Range, "options.isoMaterial"));
    }
}

#[test]
fn every_refusal_of_a_curve_names_its_field() {
    let edit = |pointer: &str, value: Value| {
        let mut document = rings();
        *document.pointer_mut(pointer).expect("a field") = value;
        document
    };
    let with = |field: &str, value: Value| {
        let mut document = rings();
        document["curves"][1][field] = value;
        document
    };
    let error =
        refused(&edit("/curves/0/points", json!([[0, 0], [1, 0], [0, 1]])), Code::Points, "curves[0].points");
    assert!(error.message.contains('4'), "{error}");
    refused(&edit("/curves/0/degree", json!(1)), Code::Range, "curves[0].degree");
    refused(&edit("/curves/0/degree", json!(33)), Code::Range, "curves[0].degree");
    refused(
        &edit("/curves/1/points", json!([[5, 5], [5, 5], [5, 5], [5, 5]])),
        Code::ZeroLength,
        "curves[1].points",
    );
    refused(&edit("/curves/1/points/3", json!([1e300, 0])), Code::Range, "curves[1].points[3]");
    refused(&edit("/curves/1/points", ring(30.0, 2001, DVec2::ZERO)), Code::Limit, "curves[1].points");
    refused(&edit("/curves/1/form", json!("clamped")), Code::Points, "curves[1].points[11]");
    let decreasing: Vec<f64> = (0..13).map(|k| if k == 6 { 4.0 } else { f64::from(k) }).collect();
    refused(&with("knots", json!(decreasing)), Code::Knots, "curves[1].knots[6]");
    let crowded: Vec<f64> = (0..13).map(|k| if (5..9).contains(&k) { 5.0 } else { f64::from(k) }).collect();
    refused(&with("knots", json!(crowded)), Code::Knots, "curves[1].knots[5]");
    refused(&with("knots", json!([0, 1, 2])), Code::Knots, "curves[1].knots");
    refused(
        &with("composition", json!([{"at": 0, "mix": [1]}])),
        Code::Range,
        "curves[1].composition[0].mix",
    );
    refused(
        &with("composition", json!([{"at": 0, "mix": [0.5, 0.6]}])),
        Code::Range,
        "curves[1].composition[0].mix",
    );
    refused(&with("composition", json!([])), Code::Range, "curves[1].composition");
    refused(&with("composition", json!([{"at": 1, "mix": [1, 0]}])), Code::Range, "curves[1].composition");
    let mut document = rings();
    document["materials"] = json!([{"name": "a", "color": "red"}]);
    refused(&document, Code::Range, "materials[0].color");
}

#[test]
fn curves_that_meet_are_refused_with_the_place() {
    let eight = json!([[10, 0], [10, 10], [-10, -10], [-10, 0], [-10, 10], [10, -10]]);
    let error =
        refused(&pair(eight, ring(40.0, 12, DVec2::ZERO)), Code::SelfIntersection, "curves[0].points");
    assert!(error.at.expect("a place").length() < 3.0, "{error}");
    let error = refused(
        &pair(ring(10.0, 12, dvec2(22.0, 0.0)), ring(30.0, 12, DVec2::ZERO)),
        Code::Contact,
        "curves[1].points",
    );
    let at = error.at.expect("a place");
    assert!((at.length() - 28.66).abs() < 0.5, "on the outer curve: {at}");
    let same = refused(
        &pair(ring(10.0, 12, DVec2::ZERO), ring(10.0, 12, DVec2::ZERO)),
        Code::Contact,
        "curves[1].points",
    );
    assert!(same.at.is_some());
}

#[test]
fn geometry_that_cannot_be_matched_is_explained() {
    let apart = matched(&pair(ring(10.0, 12, dvec2(50.0, 0.0)), ring(10.0, 12, DVec2::ZERO))).expect("valid");
    assert!(!apart.is_complete());
    assert_eq!(codes(&apart), ["disjoint"]);

    let mut crossing = pair(ring(10.0, 12, dvec2(22.0, 0.0)), ring(30.0, 12, DVec2::ZERO));
    crossing["curves"][0]["height"] = json!(5);
    assert_eq!(codes(&matched(&crossing).expect("valid")), ["crossing"]);

    // A thin ring sampled with triangles: the chords of the outer one cut the inner one.
    let mut coarse = pair(ring(29.0, 12, DVec2::ZERO), ring(30.0, 12, DVec2::ZERO));
    coarse["sampling"] = json!({"counts": [60, 3]});
    assert_eq!(codes(&matched(&coarse).expect("valid")), ["coarse-sampling"]);
    coarse["sampling"] = json!({"counts": [60, 60]});
    assert!(matched(&coarse).expect("valid").is_complete(), "finer samples mend it");
}

#[test]
fn adaptive_samples_are_as_many_as_the_shape_needs() {
    let count = |sampling: Value| {
        let mut document = rings();
        document["sampling"] = sampling;
        let solution = matched(&document).expect("valid");
        let limits = codes(&solution).iter().filter(|&&code| code == "sample-limit").count();
        assert!(solution.is_complete(), "{:?}", solution.diagnostics);
        let counts: Vec<usize> = solution.model.samples().iter().map(|s| s.points.len()).collect();
        (counts, limits)
    };
    // The turn decides on round curves: 360 / 24 is 15 degrees, give or take the waves of the spline.
    assert_eq!(count(json!({"scheme": "adaptive", "maxTurn": 16, "tolerance": 1})), (vec![24, 24], 0));
    assert_eq!(
        count(json!({"scheme": "adaptive", "maxTurn": 90, "tolerance": 9, "minCount": 20})),
        (vec![20, 20], 0)
    );
    // Chords of 30 degrees lie 1.02 inside the larger ring and a third of that inside the smaller one.
    assert_eq!(count(json!({"scheme": "adaptive", "maxTurn": 90, "tolerance": 0.5})), (vec![12, 24], 0));
    assert_eq!(count(json!({"scheme": "adaptive", "tolerance": 1e-9})), (vec![1000, 1000], 2));
    let counts = json!({"scheme": "adaptive", "maxTurn": 16, "tolerance": 1, "counts": [5, 900]});
    assert_eq!(count(counts), (vec![24, 24], 0), "counts are those of the other schemes");
}

#[test]
fn drawings_in_progress_are_shown_and_say_what_is_missing() {
    let whole = rings();
    for count in 0..2 {
        let mut document = whole.clone();
        document["curves"] = whole["curves"].as_array().expect("a list")[..count].into();
        let solution = matched(&document).expect("valid");
        assert!(!solution.is_complete() && matches!(solution.outcome, Outcome::Unmatched));
        assert_eq!(codes(&solution), ["incomplete"]);
        let message = solution.diagnostics[0].to_string();
        assert!(message.starts_with(&format!("{count} of 2 curves")), "{message}");
        assert_eq!((solution.model.samples().len(), solution.model.reversed().len()), (count, count));
        draw(&solution);
        let read = read_text(&document.to_string()).expect("valid");
        assert_eq!(read_text(&write_text(&read).expect("finite")), Ok(read.clone()));
        let beyond = insert_point(read, count, 0.5).expect_err("no such curve");
        assert_eq!((beyond.code, beyond.path.as_str()), (Code::Range, "curve"), "{beyond}");
    }

    let mut one = whole.clone();
    one["curves"] = json!([whole["curves"][1]]);
    let finer = insert_point(read_text(&one.to_string()).expect("valid"), 0, 0.3).expect("a curve");
    assert_eq!(finer.curves[0].points.len(), 13);
    let eight = json!([[10, 0], [10, 10], [-10, -10], [-10, 0], [-10, 10], [10, -10]]);
    one["curves"][0]["points"] = eight;
    refused(&one, Code::SelfIntersection, "curves[0].points");

    let mut none = whole;
    none["curves"] = json!([]);
    let solution = matched(&none).expect("valid");
    let options = r#"{"width": 400, "height": 300}"#;
    let options = PictureOptions::read(&Json::parse(options).expect("JSON")).expect("valid options");
    let view = options.viewport(&solution.model);
    assert_eq!(view.center, DVec2::ZERO);
    let seen = view.visible();
    assert!(seen.max.y >= 50.0 && seen.max.y < 70.0, "100 units and a margin: {seen:?}");
}

#[test]
fn vertices_that_see_nothing_are_named_and_the_partial_result_is_sound() {
    // A C that nearly closes round its own hollow.
    let c: Vec<[f64; 2]> = (0..=24)
        .map(|k| 0.25 + (TAU - 0.5) * f64::from(k) / 24.0)
        .map(|t| [20.0 * t.cos(), 20.0 * t.sin()])
        .chain(
            (0..=24)
                .rev()
                .map(|k| 0.25 + (TAU - 0.5) * f64::from(k) / 24.0)
                .map(|t| [14.0 * t.cos(), 14.0 * t.sin()]),
        )
        .collect();
    let mut document = pair(json!(c), ring(40.0, 12, DVec2::ZERO));
    document["sampling"] = json!({"counts": [80, 44]});
    let solution = matched(&document).expect("valid");
    assert!(!solution.is_complete() && solution.band().is_none());
    let Outcome::Matched { problem, matching, .. } = &solution.outcome else { panic!("partial lines") };
    assert!(!matching.lines.is_empty());
    let blind: Vec<usize> =
        (0..80).filter(|&i| (0..44).all(|j| blocking_edge(problem.outlines(), i, j).is_some())).collect();
    let named = solution.diagnostics.iter().find_map(|diagnostic| match diagnostic {
        Diagnostic::Orphan { curve: 0, vertices } => Some(vertices.clone()),
        _ => None,
    });
    assert_eq!(named, Some(blind));
    assert_eq!((matching.totals.crossings, matching.totals.blocked), (0, 0));
}

#[test]
fn corners_are_accepted_and_named() {
    let square = json!([[-10, -10], [-10, -10], [-10, -10], [10, -10], [10, 10], [-10, 10]]);
    let solution = matched(&pair(square, ring(40.0, 12, DVec2::ZERO))).expect("valid");
    assert!(solution.is_complete());
    assert_eq!(codes(&solution), ["corner"]);
    let normals = &solution.model.samples()[0].normals;
    assert!(normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-12));
}

#[test]
fn drawing_direction_and_order_of_the_curves_do_not_matter() {
    let points = |turn: f64| -> Vec<[f64; 2]> {
        (0..10)
            .map(|k| f64::from(k) * TAU / 10.0)
            .map(|t| {
                let r = 12.0 + 4.0 * (2.0 * t + turn).cos();
                [r * t.cos(), r * t.sin()]
            })
            .collect()
    };
    let outer: Vec<[f64; 2]> = points(1.0).iter().map(|[x, y]| [3.0 * x, 3.0 * y]).collect();
    let clockwise: Vec<[f64; 2]> = outer.iter().rev().copied().collect();
    let eta = |document: &Value| {
        let solution = matched(document).expect("valid");
        let Outcome::Matched { matching, .. } = &solution.outcome else { panic!("matched") };
        (solution.model.reversed().to_vec(), matching.totals.eta.expect("covered"))
    };
    let (straight, eta_straight) = eta(&pair(json!(points(0.3)), json!(outer)));
    let (turned, eta_turned) = eta(&pair(json!(points(0.3)), json!(clockwise)));
    assert_eq!((straight, turned), (vec![false, false], vec![false, true]));
    // The seam moves with the drawing direction, and the samples with it.
    assert!((eta_straight - eta_turned).abs() < 0.02);
    let (_, eta_swapped) = eta(&pair(json!(outer), json!(points(0.3))));
    assert!((eta_straight - eta_swapped).abs() < 1e-12);
}

#[test]
fn what_is_written_is_read_as_the_same_document() {
    seeded(200, &prop::collection::vec((any::<f64>(), any::<f64>()), 4..8), |points| {
        let points: Vec<[f64; 2]> =
            points.iter().map(|&(x, y)| [x, y]).filter(|p| p.iter().all(|x| x.is_finite())).collect();
        let Ok(document) = read_text(&pair(json!(points), ring(30.0, 12, DVec2::ZERO)).to_string()) else {
            return Err(TestCaseError::fail("finite points are read"));
        };
        let text = write_text(&document).expect("finite");
        prop_assert_eq!(read_text(&text), Ok(document));
        Ok(())
    });
}

/// Twice the area of a triangle, positive when it turns counter-clockwise.
fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// Tells whether two segments cross inside both.
fn cross_inside([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> bool {
    turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0
}

#[test]
fn lines_that_break_a_constraint_are_drawn_apart_and_without_a_blend() {
    let mut faults = 0;
    for Preset { id, text, .. } in presets() {
        for (method, one_to_one) in [
            ("parameter", false),
            ("parameter", true),
            ("shift", false),
            ("greedy", true),
            ("one-per-vertex", true),
        ] {
            let mut document: Value = serde_json::from_str(&text).expect("JSON");
            document["matching"]["method"] = json!(method);
            document["matching"]["oneToOne"] = json!(one_to_one);
            // A harmonic blend has no lines to be matched.
            document["blend"]["kind"] = json!("ruled");
            let solution = solve(&document).expect("a valid document");
            if solution.stack().is_some() {
                continue;
            }
            let (problem, lines, totals) = solution.lines().expect("lines");
            let [first, second] = problem.outlines();
            let segments: Vec<[DVec2; 2]> =
                lines.iter().map(|line| [first.points[line.from], second.points[line.to]]).collect();
            let is_broken = |k: usize| {
                let crossed =
                    segments.iter().enumerate().any(|(l, other)| l != k && cross_inside(segments[k], *other));
                crossed || blocking_edge(problem.outlines(), lines[k].from, lines[k].to).is_some()
            };
            let mut expected: Vec<Vec<DVec2>> =
                (0..lines.len()).filter(|&k| is_broken(k)).map(|k| segments[k].to_vec()).collect();
            faults += expected.len();

            let options =
                PictureOptions::read(&Json::parse(r#"{"width": 300, "height": 240}"#).expect("JSON"));
            let options = options.expect("valid");
            let viewport = options.viewport(&solution.model);
            let list = figure(&solution, &options.figure(&solution.model), &viewport);
            let drawn = |name: &str| -> Vec<Vec<DVec2>> {
                let layers = list.layers.iter().filter(|layer| layer.name == name);
                let items = layers.flat_map(|layer| &layer.items);
                items
                    .flat_map(|item| match item {
                        Item::Stroke { path, .. } => path.rings.clone(),
                        _ => panic!("lines are strokes"),
                    })
                    .collect()
            };
            let mut broken = drawn("broken-lines");
            assert_eq!(broken.len() + drawn("ruling-lines").len(), lines.len(), "{id} {method}");
            assert_eq!(broken.is_empty(), totals.crossings + totals.blocked == 0, "{id} {method}");
            let by_place = |a: &Vec<DVec2>, b: &Vec<DVec2>| {
                a[0].to_array().partial_cmp(&b[0].to_array()).expect("finite")
            };
            broken.sort_by(by_place);
            expected.sort_by(by_place);
            assert_eq!(broken, expected, "{id} {method}");
            let has = |name: &str| list.layers.iter().any(|layer| layer.name == name);
            assert!(broken.is_empty() || !has("material"), "{id} {method}");
            let Outcome::Matched { matching, .. } = &solution.outcome else { panic!("{id} has lines") };
            let bare = matching.totals.uncovered.iter().any(|bare| !bare.is_empty());
            assert_eq!(has("unconnected"), bare && !solution.is_complete(), "{id} {method}");
        }
    }
    assert!(faults > 200, "{faults} lines break a constraint");
}

/// Paints and writes a solution, small.
fn draw(solution: &Solution) {
    let options = r#"{"width": 60, "height": 40, "s": 0.3, "line": 2}"#;
    let options = PictureOptions::read(&Json::parse(options).expect("JSON")).expect("valid options");
    let viewport = options.viewport(&solution.model);
    let list = figure(solution, &options.figure(&solution.model), &viewport);
    let pixels = paint(&list, &viewport).expect("a picture");
    assert_eq!(pixels.len(), 60 * 40 * 4);
    assert!(to_svg(&list, &viewport, "t", "d").starts_with("<svg"));
}
