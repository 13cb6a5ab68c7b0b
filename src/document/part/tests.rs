//! Part documents from JSON to answers.

use super::*;
use crate::document::{Code, DocumentError, Json};
use serde_json::{Value, json};
use std::rc::Rc;

/// A rectangle of 100 x 60 with a feature at its left edge.
pub(super) fn minimal() -> Value {
    json!({
        "directrix": 1, "kind": "part",
        "materials": [{"name": "a", "color": "#000000"}, {"name": "b", "color": "#ffffff"}],
        "shapes": [
            {"name": "outline", "kind": "polygon", "points": [[0, 0], [100, 0], [100, 60], [0, 60]]},
            {"name": "left", "kind": "segment", "from": [0, 0], "to": [0, 60]},
            {"name": "axis", "kind": "line", "through": [50, 0], "direction": [0, 2]},
            {"name": "bore", "kind": "circle", "center": [70, 30], "radius": 10},
        ],
        "bodies": [{"name": "plate", "outline": "outline", "features": [{"reference": "left", "to": 40, "start": [0, 1]}]}],
        "rules": [{"material": 1, "most": 0.5}, {"material": 1, "of": "gradient", "most": 0.01}],
    })
}

pub(super) fn model(value: &Value) -> Result<PartModel, DocumentError> {
    read_part(&Json::from(value.clone())).and_then(PartModel::new)
}

pub(super) fn known(value: &Value) -> Rc<KnownPart> {
    Rc::new(KnownPart::new(model(value).expect("a valid document")))
}

pub(super) fn answer(known: &Rc<KnownPart>, name: &str, rest: Value) -> PartAnswer {
    let ask = PartAsk::read(name, &Json::from(rest), known.model()).expect("a question");
    let mut job = PartJob::new(Rc::clone(known), ask.clone());
    let mut steps = 0;
    let stepped = loop {
        if let Some(answer) = job.step(&mut || false) {
            break answer;
        }
        assert!((0.0..1.0).contains(&job.progress()) && steps < 1_000_000, "{name}");
        steps += 1;
    };
    assert!(job.step(&mut || true).is_none(), "{name}: nothing more ever after");
    let fresh = Rc::new(KnownPart::new(known.model().clone()));
    let whole = PartJob::new(fresh, ask).run().expect("an answer");
    assert_eq!(format!("{stepped:?}"), format!("{whole:?}"), "{name}");
    stepped
}

fn refused(edit: impl FnOnce(&mut Value)) -> (Code, String) {
    let mut value = minimal();
    edit(&mut value);
    let error = model(&value).expect_err("refused");
    assert!(!error.message.is_empty());
    (error.code, error.path)
}

/// Code, path and whether something is skipped, of each diagnostic.
fn said(edit: impl FnOnce(&mut Value)) -> Vec<(&'static str, String, bool)> {
    let mut value = minimal();
    edit(&mut value);
    let model = model(&value).expect("a document that can be read");
    model.diagnostics().iter().map(|each| (each.code, each.path.clone(), each.skipped)).collect()
}

fn one(code: &'static str, path: &str, is_skipped: bool) -> Vec<(&'static str, String, bool)> {
    vec![(code, path.to_owned(), is_skipped)]
}

#[test]
fn defaults_are_spelt_out_and_read_back() {
    let document = read_part(&Json::from(minimal())).expect("valid");
    let written = serde_json::to_value(&document).expect("JSON");
    let body = &written["bodies"][0];
    assert_eq!((&body["rule"], &body["default"]), (&json!("repaired"), &json!([1.0, 0.0])));
    let feature = json!({"name": "Feature 1", "hidden": false, "reference": "left", "from": 0.0, "to": 40.0,
        "start": [0.0, 1.0], "end": [1.0, 0.0], "course": {"kind": "linear"}});
    assert_eq!(body["features"][0], feature);
    assert_eq!(
        written["rules"][0],
        json!({"name": "Rule 1", "material": 1, "of": "fraction", "least": 0.0, "most": 0.5})
    );
    assert_eq!(read_part(&Json::from(written)).expect("valid"), document);
}

#[test]
fn every_course_and_reference_reads_back() {
    let mut value = minimal();
    let features = [
        json!({"kind": "power", "power": 2}),
        json!({"kind": "exponential", "rate": -1}),
        json!({"kind": "smoothstep"}),
        json!({"kind": "periodic", "waves": 3}),
        json!({"kind": "piecewise", "keys": [{"at": 0, "mix": [1, 0]}, {"at": 1, "mix": [0.5, 0.5]}]}),
        json!({"kind": "expression", "text": "sin(d) ^ 2"}),
    ];
    let mut features: Vec<Value> = features
        .iter()
        .map(|course| json!({"reference": "bore", "to": 5, "start": [0, 1], "course": course}))
        .collect();
    features.push(json!({"references": {"a": "left", "b": {"boundary": "plate", "except": ["left"]}},
        "distance": "min(a, b)", "from": 1, "to": 5, "materials": [1], "start": [1], "end": [1]}));
    value["bodies"][0]["features"] = json!(features);
    value["bodies"][0]["holes"] = json!(["bore"]);
    let document = read_part(&Json::from(value)).expect("valid");
    let written = serde_json::to_value(&document).expect("JSON");
    assert_eq!(written["bodies"][0]["features"][6]["start"], json!([0.0, 1.0]));
    assert_eq!(read_part(&Json::from(written)).expect("valid"), document);
    assert_eq!(PartModel::new(document).expect("a model").diagnostics(), []);
}

#[test]
fn wrong_fields_are_refused_with_their_path() {
    let first = "bodies[0].features[0]";
    assert_eq!(refused(|d| d["kind"] = json!("curves")), (Code::Kind, "kind".into()));
    assert_eq!(refused(|d| d["kind"] = json!("hyperpatch")), (Code::Kind, "kind".into()));
    assert_eq!(refused(|d| d["directrix"] = json!(2)), (Code::Version, "directrix".into()));
    assert_eq!(refused(|d| d["bodies"] = json!({})), (Code::Type, "bodies".into()));
    assert_eq!(
        refused(|d| drop(d.as_object_mut().map(|d| d.remove("bodies")))),
        (Code::Missing, "bodies".into())
    );
    assert_eq!(
        refused(|d| d["shapes"][1]["name"] = json!("outline")),
        (Code::Range, "shapes[1].name".into())
    );
    assert_eq!(refused(|d| d["shapes"][1]["name"] = json!("")), (Code::Range, "shapes[1].name".into()));
    assert_eq!(refused(|d| d["shapes"][3]["radius"] = json!(-1)), (Code::Range, "shapes[3].radius".into()));
    assert_eq!(
        refused(|d| d["shapes"][3]["at"] = json!([0, 0])),
        (Code::UnknownField, "shapes[3].at".into())
    );
    assert_eq!(
        refused(|d| d["shapes"][0]["points"][2][1] = json!(1e10)),
        (Code::Range, "shapes[0].points[2][1]".into())
    );
    assert_eq!(refused(|d| d["bodies"][0]["rule"] = json!("best")), (Code::Range, "bodies[0].rule".into()));
    assert_eq!(
        refused(|d| d["bodies"][0]["default"] = json!([0.5, 0.6])),
        (Code::Range, "bodies[0].default".into())
    );
    let feature = |field: &str, value: Value| refused(|d| d["bodies"][0]["features"][0][field] = value);
    assert_eq!(feature("start", json!([1])), (Code::Range, format!("{first}.start")));
    assert_eq!(feature("start", json!([1, -1])), (Code::Range, format!("{first}.start")));
    assert_eq!(feature("from", json!(-1)), (Code::Range, format!("{first}.from")));
    assert_eq!(feature("reference", json!(3)), (Code::Type, format!("{first}.reference")));
    assert_eq!(
        feature("reference", json!({"boundary": "plate", "but": []})),
        (Code::UnknownField, format!("{first}.reference.but"))
    );
    assert_eq!(feature("distance", json!("a")), (Code::Range, format!("{first}.distance")));
    assert_eq!(feature("references", json!({"a": "left"})), (Code::Range, format!("{first}.reference")));
    assert_eq!(feature("materials", json!([1, 1])), (Code::Range, format!("{first}.materials[1]")));
    assert_eq!(
        feature("course", json!({"kind": "linear", "power": 2})),
        (Code::UnknownField, format!("{first}.course.power"))
    );
    assert_eq!(refused(|d| d["rules"][0]["material"] = json!(2)), (Code::Range, "rules[0].material".into()));
    assert_eq!(
        refused(|d| d["materials"][0]["color"] = json!("red")),
        (Code::Range, "materials[0].color".into())
    );
}

#[test]
fn limits_are_kept() {
    let many = |count: usize, each: &dyn Fn(usize) -> Value| Value::Array((0..count).map(each).collect());
    let point = |n: usize| json!({"name": n.to_string(), "kind": "point", "at": [0, 0]});
    let body = |n: usize| json!({"name": n.to_string(), "outline": "outline"});
    let feature = |_: usize| json!({"reference": "left", "to": 40, "start": [0, 1]});
    let rule = |_: usize| json!({"material": 0});
    assert_eq!(refused(|d| d["shapes"] = many(MOST_SHAPES + 1, &point)), (Code::Limit, "shapes".into()));
    assert_eq!(
        refused(|d| d["shapes"][0]["points"] = many(MOST_PART_POINTS, &|n| json!([n, n * n]))),
        (Code::Limit, "shapes".into())
    );
    assert_eq!(refused(|d| d["bodies"] = many(MOST_BODIES + 1, &body)), (Code::Limit, "bodies".into()));
    assert_eq!(
        refused(|d| d["bodies"][0]["features"] = many(MOST_PART_FEATURES + 1, &feature)),
        (Code::Limit, "bodies[0].features".into())
    );
    assert_eq!(refused(|d| d["rules"] = many(MOST_PART_RULES + 1, &rule)), (Code::Limit, "rules".into()));
    assert_eq!(said(|d| d["bodies"] = many(MOST_BODIES, &body)), []);
    assert_eq!(said(|d| d["bodies"][0]["features"] = many(MOST_PART_FEATURES, &feature)), []);
}

#[test]
fn faults_are_said_where_they_are_and_the_rest_works() {
    let first = "bodies[0].features[0]";
    let at = |field: &str| format!("{first}.{field}");
    let feature = |field: &str, value: Value| said(|d| d["bodies"][0]["features"][0][field] = value);
    assert_eq!(said(|_| ()), []);
    assert_eq!(feature("reference", json!("right")), one("unknown-name", &at("reference"), true));
    assert_eq!(
        feature("reference", json!({"boundary": "disc"})),
        one("unknown-name", &at("reference.boundary"), true)
    );
    let except = json!({"boundary": "plate", "except": ["left", "right"]});
    assert_eq!(feature("reference", except), one("unknown-name", &at("reference.except[1]"), true));
    let all = json!({"boundary": "plate", "except": ["outline"]});
    assert_eq!(feature("reference", all), one("empty", &at("reference.except"), true));
    assert_eq!(feature("from", json!(40)), one("limits", &at("to"), true));
    assert_eq!(
        feature("course", json!({"kind": "power", "power": 0})),
        one("course", &at("course.power"), true)
    );
    assert_eq!(
        feature("course", json!({"kind": "expression", "text": "sqrt(0 - d)"})),
        one("expression", &at("course.text"), true)
    );
    assert_eq!(feature("hidden", json!(true)), []);
    assert_eq!(said(|d| d["shapes"][3]["radius"] = json!(0)), one("shape", "shapes[3].radius", true));
    assert_eq!(
        said(|d| d["shapes"][2]["direction"] = json!([0, 0])),
        one("shape", "shapes[2].direction", true)
    );
    assert_eq!(said(|d| d["bodies"][0]["outline"] = json!("left")), one("open", "bodies[0].outline", true));
    assert_eq!(
        said(|d| d["bodies"][0]["outline"] = json!("right")),
        one("unknown-name", "bodies[0].outline", true)
    );
    assert_eq!(said(|d| d["bodies"][0]["holes"] = json!(["left"])), one("open", "bodies[0].holes[0]", true));
    assert_eq!(
        said(|d| d["bodies"][0]["holes"] = json!(["outline"])),
        one("empty", "bodies[0].holes", false)
    );
    assert_eq!(said(|d| d["rules"][0]["least"] = json!(0.6)), one("limits", "rules[0].most", true));
    let far = |d: &mut Value| d["shapes"][1] = json!({"name": "left", "kind": "point", "at": [500, 0]});
    assert_eq!(said(far), one("far", first, false));
    let crossed = |d: &mut Value| d["shapes"][0]["points"] = json!([[0, 0], [100, 60], [100, 0], [0, 60]]);
    let mut value = minimal();
    crossed(&mut value);
    let found = model(&value).expect("a document");
    assert_eq!(found.diagnostics()[0].code, "self-intersection");
    assert_eq!(found.diagnostics()[0].at, Some([50.0, 30.0]));
    let flat = |d: &mut Value| d["shapes"][0]["points"] = json!([[0, 0], [100, 60], [50, 30]]);
    assert_eq!(said(flat)[0].1, "bodies[0].outline");

    let mut value = minimal();
    value["bodies"][0]["features"] = json!([
        {"reference": "left", "to": 40, "start": [0, 1], "course": {"kind": "expression", "text": "d +* 2"}},
        {"references": {"a": "left"}, "distance": "a + b", "to": 40, "start": [0, 1]},
        {"reference": "left", "to": 40, "start": [0, 1]},
    ]);
    let found = known(&value);
    let faults = found.model().diagnostics();
    let places: Vec<_> = faults.iter().map(|each| (each.feature, each.character)).collect();
    assert_eq!(places, [(Some(0), Some(3)), (Some(1), Some(4))], "{faults:?}");
    let PartAnswer::Place(Some(place)) = answer(&found, "probe", json!({"point": [10, 30]})) else {
        panic!("a place")
    };
    assert_eq!((place.leaf, place.fractions), (4, Some(vec![0.25, 0.75])));
}

#[test]
fn bodies_refer_to_each_other_in_any_order() {
    let mut value = minimal();
    value["bodies"] = json!([
        {"name": "plate", "outline": "outline", "features": [{"reference": {"boundary": "disc"}, "to": 5, "start": [0, 1]}]},
        {"name": "disc", "outline": "bore", "features": [{"reference": {"boundary": "plate"}, "to": 50, "start": [0, 1]}]},
    ]);
    let found = known(&value);
    assert_eq!(found.model().diagnostics(), []);
    let PartAnswer::Place(Some(place)) = answer(&found, "probe", json!({"point": [70, 30]})) else {
        panic!("a place")
    };
    assert_eq!((place.body, place.distances), (1, vec![30.0]));
    let PartAnswer::Place(Some(place)) = answer(&found, "probe", json!({"point": [70, 42]})) else {
        panic!("a place")
    };
    assert_eq!((place.body, place.distances), (0, vec![2.0]));
}

#[test]
fn questions_are_answered_in_steps_as_at_once() {
    let mut value = minimal();
    value["bodies"][0]["holes"] = json!(["bore"]);
    let found = known(&value);
    let size = json!({"options": {"size": [50, 30]}});
    let PartAnswer::Raster(raster, Some(colors)) =
        answer(&found, "evaluate", json!({"options": {"size": [50, 30], "colors": true}}))
    else {
        panic!("a raster")
    };
    assert_eq!((raster.body.len(), colors.len(), colors[3]), (1500, 6000, 255));
    let PartAnswer::Violations(_, masks, counts) = answer(&found, "violations", size.clone()) else {
        panic!("rules")
    };
    // Of 40 half has more than one half, and all of it a slope of 1/40.
    assert_eq!(counts[0], 300);
    assert!(counts[1] >= 600 && counts[1] <= 630, "{counts:?}");
    assert_eq!(masks.iter().filter(|mask| **mask & 1 == 1).count(), 300);
    let PartAnswer::Amounts(amounts) = answer(&found, "amounts", size.clone()) else { panic!("amounts") };
    assert!((amounts.amounts[0][1] - 1200.0).abs() < 1e-3);
    assert!((amounts.areas[0] - (6000.0 - 100.0 * std::f64::consts::PI)).abs() < 20.0);
    let PartAnswer::Leaves(rows) = answer(&found, "leaves", size) else { panic!("leaves") };
    assert_eq!(rows.iter().map(|row| (row.body, row.leaf)).collect::<Vec<_>>(), [(0, 0), (0, 1)]);
    assert!((rows[1].area - 2400.0).abs() < 1e-9);
    let lines = json!({"options": {"size": [50, 30], "material": 1, "levels": [0.25, 0.5]}});
    let PartAnswer::Isolines(lines) = answer(&found, "isolines", lines) else { panic!("lines") };
    for (level, lines) in lines {
        assert_eq!(lines.len(), 1);
        assert!(lines[0].points.iter().all(|point| (point.x - 40.0 * (1.0 - level)).abs() < 1e-4));
    }
    let along = json!({"ends": [[-10, 30], [50, 30]], "count": 7});
    let PartAnswer::Along(along) = answer(&found, "along", along) else { panic!("a line") };
    assert_eq!((along.body[0], along.body[2], along.leaves[2]), (0, 1, 1));
    assert!(along.fractions[1][0].is_nan() && (along.fractions[1][2] - 0.75).abs() < 1e-12);
    for format in ["csv", "vti", "nrrd", "png"] {
        let options = json!({"options": {"size": [9, 7], "format": format}});
        assert!(
            matches!(answer(&found, "file", options), PartAnswer::File(bytes) if bytes.len() > 100),
            "{format}"
        );
    }
}

#[test]
fn wrong_questions_are_refused_with_their_path() {
    let found = known(&minimal());
    let refused = |name: &str, rest: Value| {
        let error = PartAsk::read(name, &Json::from(rest), found.model()).expect_err(name);
        (error.code, error.path)
    };
    let options = |options: Value| refused("evaluate", json!({"options": options}));
    assert_eq!(options(json!({"size": [0, 5]})), (Code::Range, "options.size[0]".into()));
    assert_eq!(options(json!({"size": [5000, 5000]})), (Code::Limit, "options.size".into()));
    assert_eq!(options(json!({"box": [[0, 0], [0, 5]]})), (Code::Range, "options.box".into()));
    assert_eq!(options(json!({"depth": 1})), (Code::UnknownField, "options.depth".into()));
    assert_eq!(refused("probe", json!({})), (Code::Missing, "point".into()));
    assert_eq!(
        refused("along", json!({"ends": [[0, 0], [1, 1]], "count": 1})),
        (Code::Range, "count".into())
    );
    assert_eq!(
        refused("isolines", json!({"options": {"material": 2}})),
        (Code::Range, "options.material".into())
    );
    assert_eq!(
        refused("file", json!({"options": {"format": "stl"}})),
        (Code::Range, "options.format".into())
    );
    assert_eq!(
        refused("file", json!({"options": {"format": "csv", "material": 1}})),
        (Code::Range, "options.material".into())
    );
    let row = json!({"options": {"format": "png", "size": [20_000, 2]}});
    assert_eq!(refused("file", row), (Code::Limit, "options.size[0]".into()));
    assert_eq!(refused("melt", json!({})), (Code::Range, String::new()));
    let nothing = known(&json!({"directrix": 1, "kind": "part", "bodies": []}));
    let error = PartAsk::read("amounts", &Json::from(json!({})), nothing.model()).expect_err("no box");
    assert_eq!((error.code, error.path.as_str()), (Code::Range, "options.box"));
}

/// What is remembered of one document has no say in another one.
#[test]
fn edits_in_any_order_equal_building_afresh() {
    let edits: [fn(&mut Value); 4] = [
        |d| d["bodies"][0]["features"][0]["to"] = json!(25),
        |d| d["bodies"][0]["rule"] = json!("printed"),
        |d| d["shapes"][1]["from"] = json!([20, 10]),
        |d| d["bodies"][0]["holes"] = json!(["bore"]),
    ];
    let mut memory = PartMemory::default();
    for order in [[0, 1, 2, 3], [3, 1, 0, 2], [2, 3, 1, 0], [1, 0, 3, 2]] {
        let mut value = minimal();
        for n in order {
            edits[n](&mut value);
            let text = value.to_string();
            let found =
                memory.find(&text).unwrap_or_else(|| memory.keep(&text, model(&value).expect("a document")));
            answer(&found, "evaluate", json!({"options": {"size": [20, 12]}}));
        }
    }
}

#[test]
fn presets_are_valid_and_have_no_fault() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("www/presets/part");
    let mut count = 0;
    for file in std::fs::read_dir(folder).expect("the folder of presets") {
        let path = file.expect("a file").path();
        let text = std::fs::read_to_string(&path).expect("a text");
        let model = model(&serde_json::from_str(&text).expect("JSON")).expect("a valid document");
        let known = Rc::new(KnownPart::new(model));
        let summary = PartAsk::read("part", &Json::from(json!({})), known.model()).expect("a question");
        assert!(PartJob::new(Rc::clone(&known), summary).run().is_some());
        assert_eq!(known.diagnostics(), [], "{}", path.display());
        count += 1;
    }
    assert_eq!(count, 9);
}

/// The box grows evenly to whole pixels, and one of whole pixels stays.
#[test]
fn pixels_of_a_pitch_are_square_and_hold_the_box() {
    let found = known(&minimal());
    let frame = |options: Value| match answer(&found, "evaluate", json!({"options": options})) {
        PartAnswer::Raster(raster, _) => raster.frame,
        _ => panic!("a raster"),
    };
    let whole = frame(json!({"pitch": 0.5}));
    assert_eq!((whole.size(), whole.bounds().max.to_array()), ([200, 120], [100.0, 60.0]));
    let grown = frame(json!({"pitch": 7}));
    assert_eq!(grown.size(), [15, 9]);
    assert_eq!(grown.bounds().min.to_array(), [-2.5, -1.5]);
    assert_eq!(grown.step().to_array(), [7.0, 7.0]);
    let refused = |options: Value| {
        let rest = Json::from(json!({"options": options}));
        let error = PartAsk::read("evaluate", &rest, found.model()).expect_err("refused");
        (error.code, error.path)
    };
    assert_eq!(refused(json!({"pitch": 1e-9})), (Code::Limit, "options.pitch".into()));
    assert_eq!(refused(json!({"pitch": 0})), (Code::Range, "options.pitch".into()));
    assert_eq!(refused(json!({"pitch": 1, "size": [4, 4]})), (Code::Range, "options.pitch".into()));
}

#[test]
fn pictures_alone_are_dithered_and_slices_are_of_all_materials() {
    let found = known(&minimal());
    let file = |options: Value| match answer(&found, "file", json!({"options": options})) {
        PartAnswer::File(bytes) => bytes,
        _ => panic!("a file"),
    };
    for dither in ["none", "diffusion", "blue-noise"] {
        let size = [64, 48];
        assert!(file(json!({"format": "png", "size": size, "dither": dither})).starts_with(b"\x89PNG"));
        assert!(
            file(json!({"format": "png", "material": 1, "size": size, "dither": dither}))
                .starts_with(b"\x89PNG")
        );
        assert!(file(json!({"format": "slices", "size": size, "dither": dither})).starts_with(b"PK\x03\x04"));
    }
    let refused = |options: Value| {
        let rest = Json::from(json!({"options": options}));
        let error = PartAsk::read("file", &rest, found.model()).expect_err("refused");
        (error.code, error.path)
    };
    let dither = |format: &str, kind: &str| refused(json!({"format": format, "dither": kind}));
    assert_eq!(dither("csv", "diffusion"), (Code::Range, "options.dither".into()));
    assert_eq!(dither("png", "ordered"), (Code::Range, "options.dither".into()));
    assert_eq!(refused(json!({"format": "slices", "material": 0})), (Code::Range, "options.material".into()));
}

/// A number below `count` that follows from the seed.
pub(super) fn random(seed: &mut u64, count: usize) -> usize {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    ((*seed >> 33) as usize) % count
}

/// Changes one value somewhere in a document.
pub(super) fn mutate(value: &mut Value, seed: &mut u64) {
    match value {
        Value::Object(map) if !map.is_empty() && random(seed, 30) > 0 => {
            let n = random(seed, map.len());
            if let Some(inner) = map.values_mut().nth(n) {
                mutate(inner, seed);
            }
        }
        Value::Array(list) if !list.is_empty() && random(seed, 30) > 0 => match random(seed, 12) {
            0 => drop(list.remove(random(seed, list.len()))),
            1 => list.push(list[random(seed, list.len())].clone()),
            _ => {
                let n = random(seed, list.len());
                mutate(&mut list[n], seed);
            }
        },
        Value::Number(number) => {
            let old = number.as_f64().unwrap_or(0.0);
            let new = [0.0, 1.0, -1.0, old / 3.0, old * 1e6, 0.5, 1e9, 1e-12, old + 17.0];
            *value = json!(new[random(seed, new.len())]);
        }
        _ => {
            let new = [
                json!(null),
                json!("outline"),
                json!("left"),
                json!("bore"),
                json!("printed"),
                json!("depth"),
                json!("min(a, b) / 0"),
                json!({"boundary": "plate"}),
                json!([]),
                json!(3),
            ];
            *value = new[random(seed, new.len())].clone();
        }
    }
}

#[test]
fn mutated_documents_never_panic() {
    let mut start = minimal();
    start["bodies"][0]["features"] = json!([
        {"reference": "left", "to": 40, "start": [0, 1]},
        {"references": {"a": "axis", "b": {"boundary": "plate", "except": ["left"]}}, "distance": "min(a, b)", "from": 1, "to": 9, "start": [0, 1]},
        {"reference": "bore", "to": 12, "start": [0, 1], "course": {"kind": "piecewise", "keys": [{"at": 0.2, "mix": [0, 1]}]}},
        {"reference": "axis", "from": 2, "to": 12, "start": [0.5, 0.5], "course": {"kind": "expression", "text": "1 - exp(-d)"}},
    ]);
    start["bodies"][0]["holes"] = json!(["bore"]);
    let mut read = 0;
    for first in 0..6000_u64 {
        let mut seed = first;
        let mut value = start.clone();
        for _ in 0..=random(&mut seed, 3) {
            mutate(&mut value, &mut seed);
        }
        let run = std::panic::catch_unwind(|| {
            let Ok(model) = model(&value) else { return 0 };
            let known = Rc::new(KnownPart::new(model));
            for name in ["evaluate", "violations", "isolines"] {
                let size = json!({"options": {"size": [16, 9]}});
                if let Ok(ask) = PartAsk::read(name, &Json::from(size), known.model()) {
                    let answer = PartJob::new(Rc::clone(&known), ask).run();
                    if let Some(PartAnswer::Raster(raster, _)) = answer {
                        let sum = |at: usize| raster.fractions.iter().map(|list| list[at]).sum::<f32>();
                        let is_sound = |at: usize| raster.body[at] == 0 || (sum(at) - 1.0).abs() < 1e-4;
                        assert!((0..raster.body.len()).all(is_sound), "fractions do not sum to 1");
                    }
                }
            }
            1
        });
        read += run.unwrap_or_else(|_| panic!("seed {first}: {value}"));
    }
    assert!(read > 500, "{read} could be read");
}
