//! Blends of part documents from JSON to answers, against solutions in closed form.

use super::tests::{answer, known, minimal, model, mutate, random};
use super::*;
use crate::document::{Code, Json};
use glam::DVec2;
use serde_json::{Value, json};
use std::rc::Rc;

fn materials(count: usize) -> Value {
    let colors = ["#000000", "#ffffff", "#ff0000"];
    (0..count).map(|k| json!({"name": format!("m{k}"), "color": colors[k]})).collect()
}

/// A ring about a place between two circles.
fn ring(center: [f64; 2], radii: [f64; 2], boundaries: &Value) -> Value {
    let circle =
        |name: &str, radius: f64| json!({"name": name, "kind": "circle", "center": center, "radius": radius});
    json!({"directrix": 1, "kind": "part", "materials": materials(2),
        "shapes": [circle("rim", radii[1]), circle("bore", radii[0])],
        "bodies": [{"name": "ring", "outline": "rim", "holes": ["bore"], "blend": {"kind": "laplace", "boundaries": boundaries}}]})
}

/// The unit square with its sides by name, and the lines x = 0 and y = 0.
fn square(size: f64, boundaries: &Value) -> Value {
    let side = |name: &str, from: [f64; 2], to: [f64; 2]| json!({"name": name, "kind": "segment", "from": from.map(|x| x * size), "to": to.map(|x| x * size)});
    json!({"directrix": 1, "kind": "part", "materials": materials(2),
        "shapes": [
            {"name": "square", "kind": "polygon", "points": [[0, 0], [size, 0], [size, size], [0, size]]},
            side("low", [0.0, 0.0], [1.0, 0.0]), side("right", [1.0, 0.0], [1.0, 1.0]),
            side("high", [0.0, 1.0], [1.0, 1.0]), side("left", [0.0, 0.0], [0.0, 1.0]),
        ],
        "bodies": [{"name": "plate", "outline": "square", "default": [0.25, 0.75], "blend": {"kind": "laplace", "boundaries": boundaries}}]})
}

/// The part of a document once its blends are solved, in steps.
fn solved(value: &Value) -> Rc<KnownPart> {
    let known = known(value);
    let mut job = PartJob::new(Rc::clone(&known), PartAsk::Summary);
    while job.step(&mut || false).is_none() {
        assert!((0.0..1.0).contains(&job.progress()));
    }
    known
}

/// The fraction of the second material at a point; the sum is 1.
fn at(known: &KnownPart, [x, y]: [f64; 2]) -> f64 {
    let fractions = known.part().place(DVec2::new(x, y)).and_then(|place| place.fractions);
    let fractions = fractions.expect("a point inside");
    assert!((fractions.iter().sum::<f64>() - 1.0).abs() < 1e-12 && fractions.iter().all(|f| *f >= 0.0));
    fractions[1]
}

/// Places within the unit square.
fn inner() -> impl Iterator<Item = [f64; 2]> {
    (0..25).map(|k| [0.1 + 0.2 * f64::from(k % 5), 0.1 + 0.2 * f64::from(k / 5)])
}

/// Code, path and whether something is skipped, once the blends are solved.
fn said(value: &Value) -> Vec<(&'static str, String, bool)> {
    let found = solved(value).diagnostics();
    found.iter().map(|each| (each.code, each.path.clone(), each.skipped)).collect()
}

/// Between two circles the fraction is A + B ln r, whatever their size is, the one of logarithmic capacity 1 among them.
#[test]
fn a_ring_is_a_logarithm_of_the_radius() {
    let boundaries = json!([{"on": "rim", "value": [1, 0]}, {"on": "bore", "value": [0, 1]}]);
    for scale in [1e-3, 1.0, 250.0] {
        let center = [3.0 * scale, -2.0 * scale];
        let known = solved(&ring(center, [0.4 * scale, scale], &boundaries));
        for (radius, angle) in [(0.41, 0.3), (0.6, 2.0), (0.8, 4.0), (0.999, 5.5)] {
            let r = radius * scale;
            let found = at(&known, [center[0] + r * f64::cos(angle), center[1] + r * f64::sin(angle)]);
            let exact = f64::ln(radius) / f64::ln(0.4);
            assert!((found - exact).abs() < 2e-3, "{scale}: {found}, not {exact}, at {radius}");
        }
        assert_eq!(known.diagnostics(), []);
    }
    // A gradient on the rim in place of a value: 1 - 0.4 ln(r / 0.4) has the slope -0.4 where r is 1.
    let boundaries = json!([{"on": "rim", "flux": [0.4, -0.4]}, {"on": "bore", "value": [0, 1]}]);
    let known = solved(&ring([0.0, 0.0], [0.4, 1.0], &boundaries));
    for radius in [0.45_f64, 0.7, 0.95] {
        let exact = 1.0 - 0.4 * (radius / 0.4).ln();
        assert!((at(&known, [0.0, radius]) - exact).abs() < 3e-3);
    }
}

/// Between two sides, with the others insulated, the fraction is linear. The sides are named by shapes that lie on the outline.
#[test]
fn a_strip_with_insulated_sides_is_linear() {
    let by_sides = json!([{"on": "left", "value": [1, 0]}, {"on": "right", "value": [0, 1]}]);
    let found = solved(&square(1.0, &by_sides));
    for [x, y] in inner() {
        assert!((at(&found, [x, y]) - x).abs() < 1e-3, "({x}, {y})");
    }
    // What the sides leave of the outline may be named after them or before.
    let whole = json!([{"on": "square", "flux": [0, 0]}, {"on": "right", "value": [0, 1]}, {"on": "left", "value": [1, 0]}]);
    let same = solved(&square(1.0, &whole));
    for point in inner() {
        assert!((at(&found, point) - at(&same, point)).abs() < 1e-9);
    }
    // Gradients alone: the mean over the boundary is the default.
    let gradients = json!([{"on": "left", "flux": [0.5, -0.5]}, {"on": "right", "flux": [-0.5, 0.5]}]);
    let floating = solved(&square(1.0, &gradients));
    for [x, y] in inner() {
        let exact = 0.75 + 0.5 * (x - 0.5);
        assert!((at(&floating, [x, y]) - exact).abs() < 2e-3, "({x}, {y})");
    }
    assert_eq!(floating.diagnostics(), []);
}

/// (x^2 - y^2 + 1) / 2 with values by a feature on one side, a gradient on another one, and nothing across the axes; finer elements are nearer.
#[test]
fn mixed_data_of_a_harmonic_polynomial_give_it_back() {
    let boundaries = json!([{"on": "high", "from": {"feature": "exact"}}, {"on": "right", "flux": [-1, 1]}]);
    let error = |elements: usize, boundaries: &Value| {
        let mut value = square(1.0, boundaries);
        let blend = &mut value["bodies"][0]["blend"];
        blend["elements"] = json!(elements);
        value["bodies"][0]["features"] = json!([{"name": "exact", "hidden": true, "references": {"a": "left", "b": "low"},
            "distance": "a^2 - b^2 + 1", "to": 2, "start": [1, 0], "end": [0, 1]}]);
        let found = solved(&value);
        let errors = inner().map(|[x, y]| (at(&found, [x, y]) - (x * x - y * y + 1.0) / 2.0).abs());
        errors.fold(0.0, f64::max)
    };
    let [coarse, fine] = [60, 240].map(|elements| error(elements, &boundaries));
    assert!(fine < 4e-4 && fine < coarse / 4.0, "{coarse}, then {fine}");
    let values = json!([{"on": "square", "from": {"feature": "exact"}}]);
    let [coarse, fine] = [60, 240].map(|elements| error(elements, &values));
    assert!(fine < 1e-4 && coarse < 1e-3 && fine < coarse, "{coarse}, then {fine}");
}

/// Pixels give what points give, and keep to the range of the values on the boundary.
#[test]
fn a_raster_is_every_pixel_by_itself_and_keeps_the_maximum_principle() {
    let mut value = ring(
        [3.0, -2.0],
        [2.0, 9.0],
        &json!([{"on": "rim", "value": [0.7, 0.2, 0.1]}, {"on": "bore", "value": [0.2, 0.5, 0.3]}]),
    );
    value["materials"] = materials(3);
    value["shapes"].as_array_mut().expect("shapes").extend([
        json!({"name": "slot", "kind": "polygon", "points": [[7, -3], [10, -3], [10, -1], [7, -1]]}),
        json!({"name": "face", "kind": "segment", "from": [7, -3], "to": [7, -1]}),
        json!({"name": "line", "kind": "line", "through": [0, 2], "direction": [1, 0]}),
    ]);
    let body = &mut value["bodies"][0];
    body["holes"] = json!(["bore", "slot"]);
    body["blend"]["boundaries"]
        .as_array_mut()
        .expect("boundaries")
        .push(json!({"on": "face", "value": [0.1, 0.8, 0.1]}));
    let plain = solved(&value);
    let options = json!({"options": {"size": [90, 83]}});
    let PartAnswer::Raster(raster, _) = answer(&plain, "evaluate", options.clone()) else {
        panic!("a raster")
    };
    let ranges = [[0.1, 0.7], [0.2, 0.8], [0.1, 0.3]];
    for (k, [low, high]) in ranges.into_iter().enumerate() {
        let inside = raster.fractions[k].iter().zip(&raster.body).filter(|(_, body)| **body > 0);
        assert!(inside.clone().count() > 4000);
        assert!(
            inside.into_iter().all(|(f, _)| (low - 1e-5..=high + 1e-5).contains(&f64::from(*f))),
            "material {k}"
        );
    }
    // With a feature on top, which ends in the default of the body: that is, in the blend.
    value["bodies"][0]["features"] = json!([{"reference": "line", "to": 2, "start": [0, 0, 1]}]);
    let topped = solved(&value);
    for (known, is_plain) in [(&plain, true), (&topped, false)] {
        let PartAnswer::Raster(raster, _) = answer(known, "evaluate", options.clone()) else {
            panic!("a raster")
        };
        let part = known.part();
        for at in (0..raster.body.len()).step_by(7) {
            let Some(place) = part.place(raster.frame.center(at % 90, at / 90)) else { continue };
            assert_eq!(place.leaf, raster.leaves[at]);
            let fractions = place.fractions.expect("fractions");
            for (list, exact) in raster.fractions.iter().zip(&fractions) {
                assert!((f64::from(list[at]) - exact).abs() < 2e-4, "{} and {exact}", list[at]);
            }
            if is_plain {
                continue;
            }
            let below =
                plain.part().place(raster.frame.center(at % 90, at / 90)).and_then(|place| place.fractions);
            let [below, away] = [below.expect("fractions"), vec![place.distances[0]; 3]];
            let share = (1.0 - away[0] / 2.0).max(0.0);
            for (k, fraction) in fractions.iter().enumerate() {
                let own = if k == 2 { 1.0 } else { 0.0 };
                assert!((fraction - (share * own + (1.0 - share) * below[k])).abs() < 1e-9);
            }
        }
    }
}

/// A ring takes over what the disc inside and the frame outside have, which may come later and be blended themselves; neither order nor unit has a say.
#[test]
fn bodies_take_over_what_their_neighbours_have() {
    let build = |order: [usize; 3], unit: f64| {
        let circle = |name: &str, radius: f64| json!({"name": name, "kind": "circle", "center": [5.0 * unit, 0], "radius": radius * unit});
        let from = |name: &str, other: &str| json!({"on": name, "from": {"body": other}});
        let bodies = [
            json!({"name": "core", "outline": "small", "default": [0.1, 0.9],
                "features": [{"reference": "left", "to": 4.0 * unit, "start": [1, 0]}]}),
            json!({"name": "ring", "outline": "middle", "holes": ["small"],
                "blend": {"kind": "laplace", "boundaries": [from("small", "core"), from("middle", "frame")]}}),
            json!({"name": "frame", "outline": "large", "holes": ["middle"],
                "blend": {"kind": "laplace", "boundaries": [{"on": "large", "value": [1, 0]}, {"on": "middle", "value": [0.4, 0.6]}]}}),
        ];
        let bodies: Vec<&Value> = order.iter().map(|k| &bodies[*k]).collect();
        solved(
            &json!({"directrix": 1, "kind": "part", "materials": materials(2), "bodies": bodies, "shapes": [
            circle("small", 2.0), circle("middle", 4.0), circle("large", 6.0),
            {"name": "left", "kind": "point", "at": [3.0 * unit, 0]}]}),
        )
    };
    let first = build([0, 1, 2], 1.0);
    let points: Vec<[f64; 2]> = (0..40)
        .map(|k| {
            let (radius, angle) = (0.3 + 0.14 * f64::from(k), 0.7 * f64::from(k));
            [5.0 + radius * angle.cos(), radius * angle.sin()]
        })
        .collect();
    // The ring joins the core without a jump, within the steps of its elements.
    for angle in [0.5_f64, 2.0, 4.0] {
        let near = |radius: f64| at(&first, [5.0 + radius * angle.cos(), radius * angle.sin()]);
        assert!((near(1.9999) - near(2.0001)).abs() < 0.02);
        assert!((near(3.9999) - near(4.0001)).abs() < 0.01 && (near(4.0001) - 0.6).abs() < 0.01);
    }
    assert_eq!(first.diagnostics(), []);
    for (order, unit) in [([2, 1, 0], 1.0), ([1, 0, 2], 1e3), ([0, 2, 1], 1e-4)] {
        let other = build(order, unit);
        for point in &points {
            let scaled = point.map(|x| x * unit);
            let change = (at(&first, *point) - at(&other, scaled)).abs();
            // Equations are solved to 1e-6.
            assert!(change < 1e-5, "{order:?} at {point:?}: {change}");
        }
    }
}

/// Curves are divided where they bend, and pieces are told by what is near.
#[test]
fn pieces_within_a_distance_of_a_shape_are_told_apart() {
    let mut value = ring(
        [0.0, 0.0],
        [4.0, 10.0],
        &json!([{"on": "spot", "within": 3, "value": [0, 1]}, {"on": "bore", "value": [1, 0]}]),
    );
    value["shapes"]
        .as_array_mut()
        .expect("shapes")
        .push(json!({"name": "spot", "kind": "point", "at": [10.5, 0]}));
    let found = solved(&value);
    // Nothing but the spot is warm; it is between where the point is 3 away.
    assert!(
        at(&found, [9.9, 0.0]) > 0.95 && at(&found, [-9.9, 0.0]) < 0.05 && at(&found, [0.0, 4.001]) < 0.01
    );
    let end = f64::acos((100.0 + 110.25 - 9.0) / (2.0 * 10.0 * 10.5));
    assert!(at(&found, [9.999 * (0.9 * end).cos(), 9.999 * (0.9 * end).sin()]) > 0.98);
    assert!(at(&found, [9.999 * (1.3 * end).cos(), 9.999 * (1.3 * end).sin()]) < 0.9);
    assert_eq!(found.diagnostics(), []);
}

#[test]
fn blends_read_back_with_their_defaults() {
    let value = square(
        1.0,
        &json!([{"on": "left"}, {"on": "right", "within": 2, "value": [0, 1]}, {"on": "low", "flux": [1, -1]},
        {"on": "high", "from": {"body": "plate"}}, {"on": "square", "from": {"feature": "f"}}]),
    );
    let document = read_part(&Json::from(value)).expect("valid");
    let written = serde_json::to_value(&document).expect("JSON");
    let blend = &written["bodies"][0]["blend"];
    assert_eq!((&blend["kind"], &blend["elements"]), (&json!("laplace"), &json!(300)));
    assert_eq!(blend["boundaries"][0], json!({"on": "left", "within": 0.0}));
    assert_eq!(blend["boundaries"][3], json!({"on": "high", "within": 0.0, "from": {"body": "plate"}}));
    assert_eq!(read_part(&Json::from(written)).expect("valid"), document);
    // A body without one says nothing of it.
    let plain = serde_json::to_value(read_part(&Json::from(minimal())).expect("valid")).expect("JSON");
    assert!(plain["bodies"][0].get("blend").is_none());
}

#[test]
fn wrong_fields_are_refused_with_their_path() {
    let refused = |blend: Value| {
        let mut value = minimal();
        value["bodies"][0]["blend"] = blend;
        let error = model(&value).expect_err("refused");
        (error.code, error.path.replace("bodies[0].blend", "b"))
    };
    let boundary = |boundary: Value| refused(json!({"kind": "laplace", "boundaries": [boundary]}));
    assert_eq!(refused(json!({})), (Code::Missing, "b.kind".into()));
    assert_eq!(refused(json!({"kind": "poisson"})), (Code::Range, "b.kind".into()));
    assert_eq!(refused(json!({"kind": "laplace", "elements": 31})), (Code::Range, "b.elements".into()));
    assert_eq!(refused(json!({"kind": "laplace", "elements": 2001})), (Code::Limit, "b.elements".into()));
    assert_eq!(refused(json!({"kind": "laplace", "rest": 1})), (Code::UnknownField, "b.rest".into()));
    let many = vec![json!({"on": "left"}); MOST_BOUNDARIES + 1];
    assert_eq!(refused(json!({"kind": "laplace", "boundaries": many})), (Code::Limit, "b.boundaries".into()));
    assert_eq!(boundary(json!({"value": [1, 0]})), (Code::Missing, "b.boundaries[0].on".into()));
    assert_eq!(
        boundary(json!({"on": "left", "value": [1, 1]})),
        (Code::Range, "b.boundaries[0].value".into())
    );
    assert_eq!(boundary(json!({"on": "left", "flux": [1, 1]})), (Code::Range, "b.boundaries[0].flux".into()));
    assert_eq!(boundary(json!({"on": "left", "flux": [1]})), (Code::Range, "b.boundaries[0].flux".into()));
    assert_eq!(
        boundary(json!({"on": "left", "flux": [1, -1], "value": [1, 0]})),
        (Code::Range, "b.boundaries[0].flux".into())
    );
    assert_eq!(boundary(json!({"on": "left", "within": -1})), (Code::Range, "b.boundaries[0].within".into()));
    assert_eq!(
        boundary(json!({"on": "left", "from": {}})),
        (Code::Missing, "b.boundaries[0].from.body".into())
    );
    assert_eq!(
        boundary(json!({"on": "left", "from": {"body": "a", "feature": "b"}})),
        (Code::Range, "b.boundaries[0].from.feature".into())
    );
    let body = |n: usize| json!({"name": n.to_string(), "outline": "outline", "blend": {"kind": "laplace"}});
    let mut value = minimal();
    value["bodies"] = (0..=MOST_BLENDS).map(body).collect();
    let error = model(&value).expect_err("refused");
    assert_eq!((error.code, error.path.as_str()), (Code::Limit, "bodies"));
}

#[test]
fn faults_are_said_where_they_are_and_the_default_stays() {
    let faulty = |edit: &dyn Fn(&mut Value)| {
        let mut value =
            square(1.0, &json!([{"on": "left", "value": [1, 0]}, {"on": "right", "value": [0, 1]}]));
        edit(&mut value);
        let found = solved(&value);
        let faults: Vec<_> =
            found.diagnostics().iter().map(|each| (each.code, each.path.clone(), each.skipped)).collect();
        let is_skipped = faults.iter().any(|(.., skipped)| *skipped);
        if is_skipped && value["bodies"][0]["rule"] != json!("printed") {
            assert!((at(&found, [0.9, 0.9]) - 0.75).abs() < 1e-12, "the default stays");
        }
        faults
    };
    let one = |code: &'static str, path: &str, skipped: bool| {
        vec![(code, format!("bodies[0].blend{path}"), skipped)]
    };
    let with = |boundary: Value| {
        faulty(&|d| {
            d["bodies"][0]["blend"]["boundaries"].as_array_mut().expect("a list").push(boundary.clone())
        })
    };
    assert_eq!(faulty(&|_| ()), []);
    assert_eq!(with(json!({"on": "back"})), one("unknown-name", ".boundaries[2].on", true));
    assert_eq!(
        with(json!({"on": "low", "from": {"body": "other"}})),
        one("unknown-name", ".boundaries[2].from.body", true)
    );
    assert_eq!(
        with(json!({"on": "low", "from": {"feature": "other"}})),
        one("unknown-name", ".boundaries[2].from.feature", true)
    );
    assert_eq!(
        with(json!({"on": "low", "from": {"body": "plate"}})),
        one("circle", ".boundaries[2].from.body", true)
    );
    assert_eq!(with(json!({"on": "left", "value": [0, 1]})), one("conflict", ".boundaries[2]", true));
    assert_eq!(with(json!({"on": "left", "value": [1, 0]})), []);
    let far = |d: &mut Value| d["shapes"][4]["from"] = json!([-5, 0]);
    assert_eq!(faulty(&far), []);
    let apart = |d: &mut Value| d["shapes"][4] = json!({"name": "left", "kind": "point", "at": [-5, 0]});
    assert_eq!(faulty(&apart), one("empty", ".boundaries[0]", true));
    assert_eq!(faulty(&|d| d["bodies"][0]["rule"] = json!("printed")).len(), 1);
    assert_eq!(faulty(&|d| d["bodies"][0]["blend"]["boundaries"] = json!([])), one("insulated", "", false));
    let unbalanced = json!([{"on": "left", "flux": [1, -1]}]);
    assert_eq!(
        faulty(&|d| d["bodies"][0]["blend"]["boundaries"] = unbalanced.clone()),
        one("imbalance", "", true)
    );
    let steep = json!([{"on": "left", "flux": [5, -5]}, {"on": "right", "value": [0, 1]}]);
    assert_eq!(faulty(&|d| d["bodies"][0]["blend"]["boundaries"] = steep.clone()), one("clamped", "", false));
    let hole = |points: Value| {
        faulty(&|d| {
            let shape = json!({"name": "hole", "kind": "polygon", "points": points});
            d["shapes"].as_array_mut().expect("shapes").push(shape);
            d["bodies"][0]["holes"] = json!(["hole"]);
        })
    };
    assert_eq!(hole(json!([[0.4, 0.4], [0.6, 0.4], [0.5, 0.6]])), []);
    assert_eq!(hole(json!([[0.4, 0.4], [1.6, 0.4], [0.5, 0.6]])), one("apart", "", true));
    // A hole outside takes nothing away.
    assert_eq!(hole(json!([[1.4, 0.4], [1.6, 0.4], [1.5, 0.6]])), []);
    let jagged: Vec<[f64; 2]> =
        (0..80).map(|k| [f64::from(k), f64::from(k % 2) - 5.0]).chain([[79.0, 50.0], [0.0, 50.0]]).collect();
    let corners = faulty(&|d| {
        d["shapes"][0]["points"] = json!(jagged);
        d["bodies"][0]["blend"] =
            json!({"kind": "laplace", "elements": 60, "boundaries": [{"on": "square", "value": [0, 1]}]});
        d["bodies"][0]["default"] = json!([0.25, 0.75]);
    });
    assert_eq!(corners, one("limit", "", true));
}

#[test]
fn circles_of_bodies_and_bodies_that_are_not_there_are_said() {
    let from = |on: &str, other: &str| json!({"kind": "laplace", "boundaries": [{"on": on, "from": {"body": other}}]});
    let mut value = minimal();
    value["bodies"] = json!([
        {"name": "plate", "outline": "outline", "holes": ["bore"], "blend": from("bore", "disc")},
        {"name": "disc", "outline": "bore", "blend": from("bore", "plate")},
    ]);
    let circle = |k: usize| ("circle", format!("bodies[{k}].blend"), true);
    assert_eq!(said(&value), [circle(0), circle(1)]);
    value["bodies"][1] = json!({"name": "disc", "outline": "bore", "default": [0, 1]});
    assert_eq!(said(&value), []);
    assert!((at(&solved(&value), [5.0, 5.0]) - 1.0).abs() < 1e-3);
    // The neighbour is there round the bore, and not along the outline.
    value["bodies"][0]["blend"] = from("outline", "disc");
    assert_eq!(said(&value), [("apart", "bodies[0].blend.boundaries[0]".into(), true)]);
}

/// What is remembered of other documents is found again, and has no say where anything differs.
#[test]
fn edits_in_any_order_equal_building_afresh() {
    let edits: [fn(&mut Value); 4] = [
        |d| d["bodies"][0]["blend"]["boundaries"][0]["value"] = json!([0.5, 0.5]),
        |d| d["shapes"][1]["radius"] = json!(3),
        |d| d["bodies"][0]["blend"]["elements"] = json!(64),
        |d| d["bodies"][0]["features"] = json!([{"reference": "rim", "to": 2, "start": [0.5, 0.5]}]),
    ];
    let mut memory = PartMemory::default();
    for order in [[0, 1, 2, 3], [3, 1, 0, 2], [2, 3, 1, 0]] {
        let mut value = ring(
            [0.0, 0.0],
            [4.0, 10.0],
            &json!([{"on": "rim", "value": [0, 1]}, {"on": "bore", "value": [1, 0]}]),
        );
        for n in order {
            edits[n](&mut value);
            let text = value.to_string();
            let found =
                memory.find(&text).unwrap_or_else(|| memory.keep(&text, model(&value).expect("a document")));
            answer(&found, "evaluate", json!({"options": {"size": [20, 12]}}));
        }
    }
    // An edit of a feature alone needs no solving: the blend is there after a few looks at the clock.
    let text = |to: f64| {
        let mut value = ring(
            [0.0, 0.0],
            [4.0, 10.0],
            &json!([{"on": "rim", "value": [0, 1]}, {"on": "bore", "value": [1, 0]}]),
        );
        value["bodies"][0]["features"] = json!([{"reference": "rim", "to": to, "start": [0.5, 0.5]}]);
        value
    };
    let steps = |memory: &mut PartMemory, to: f64| {
        let value = text(to);
        let known = memory.keep(&value.to_string(), model(&value).expect("a document"));
        let mut job = PartJob::new(known, PartAsk::Summary);
        (0..).position(|_| job.step(&mut || false).is_some()).expect("it ends")
    };
    let [first, second] = [steps(&mut PartMemory::default(), 2.0), {
        let mut memory = PartMemory::default();
        steps(&mut memory, 1.0);
        steps(&mut memory, 2.0)
    }];
    assert!(second < first, "{second} steps after an edit of a feature, {first} without memory");
}

#[test]
fn mutated_blends_never_panic() {
    let mut start = minimal();
    start["bodies"] = json!([
        {"name": "plate", "outline": "outline", "holes": ["bore"], "features": start["bodies"][0]["features"],
            "blend": {"kind": "laplace", "elements": 40, "boundaries": [{"on": "outline", "value": [0, 1]}, {"on": "left", "flux": [0.001, -0.001], "within": 1},
                {"on": "bore", "from": {"body": "disc"}}]}},
        {"name": "disc", "outline": "bore", "blend": {"kind": "laplace", "elements": 32, "boundaries": [{"on": "axis", "within": 40, "from": {"feature": "f"}}]},
            "features": [{"name": "f", "hidden": true, "reference": "left", "to": 90, "start": [0, 1]}]},
    ]);
    assert_eq!(said(&start), []);
    let mut read = 0;
    for first in 0..1500_u64 {
        let mut seed = first;
        let mut value = start.clone();
        for _ in 0..=random(&mut seed, 3) {
            mutate(&mut value, &mut seed);
        }
        let run = std::panic::catch_unwind(|| {
            let Ok(model) = model(&value) else { return 0 };
            let known = Rc::new(KnownPart::new(model));
            let _ = PartJob::new(Rc::clone(&known), PartAsk::Summary).run();
            let size = json!({"options": {"size": [16, 9]}});
            if let Ok(ask) = PartAsk::read("evaluate", &Json::from(size), known.model()) {
                let answer = PartJob::new(Rc::clone(&known), ask).run();
                let Some(PartAnswer::Raster(raster, _)) = answer else { panic!("a raster") };
                let sum = |at: usize| raster.fractions.iter().map(|list| list[at]).sum::<f32>();
                let is_sound = |at: usize| raster.body[at] == 0 || (sum(at) - 1.0).abs() < 1e-4;
                assert!((0..raster.body.len()).all(is_sound), "fractions do not sum to 1");
            }
            1
        });
        read += run.unwrap_or_else(|_| panic!("seed {first}: {value}"));
    }
    assert!(read > 200, "{read} could be read");
}
