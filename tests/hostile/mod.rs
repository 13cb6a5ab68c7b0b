//! Bad input: every case is refused with its field, what was found and what was expected, and no bytes whatever make the
//! reader, the solver or the painter panic or hang.
//!
//! The cases of `cases.json` are tried on the module in Node and on the page as well.

#![cfg(feature = "curves")]

use crate::support::{SEED, seeded};
use directrix::document::{DocumentError, Json, Outcome, Solution, Solve, read_text};
use directrix::picture::{PictureOptions, figure, paint, to_svg};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::time::{Duration, Instant};

/// Longest that one input may take here, natively and with the checks of a test build: a hang is longer.
const PATIENCE: Duration = Duration::from_secs(10);

fn table() -> Value {
    serde_json::from_str(include_str!("cases.json")).expect("JSON")
}

/// The text of a case: given, or the base document changed.
fn text_of(case: &Value, base: &Value) -> String {
    if let Some(text) = case["text"].as_str() {
        return text.repeat(case["times"].as_u64().unwrap_or(1) as usize);
    }
    let mut document = base.clone();
    for (pointer, value) in case["set"].as_object().into_iter().flatten() {
        put(&mut document, pointer, value.clone());
    }
    if let [Value::Number(curve), Value::Number(count)] =
        &case["ring"].as_array().cloned().unwrap_or_default()[..]
    {
        let count = count.as_u64().expect("a count");
        let points: Vec<[u64; 2]> = (0..count).map(|k| [k % 1000, k / 1000]).collect();
        put(&mut document, &format!("/curves/{curve}/points"), json!(points));
    }
    if let [Value::String(pointer), item, Value::Number(count)] =
        &case["fill"].as_array().cloned().unwrap_or_default()[..]
    {
        let count = count.as_u64().expect("a count") as usize;
        let value = item.as_str().map_or_else(|| json!(vec![item; count]), |text| json!(text.repeat(count)));
        put(&mut document, pointer, value);
    }
    let text = document.to_string();
    match &case["replace"] {
        Value::Array(pair) => {
            text.replacen(pair[0].as_str().expect("a text"), pair[1].as_str().expect("a text"), 1)
        }
        _ => text,
    }
}

/// Sets a field, which need not be there, or adds an item to a list.
fn put(document: &mut Value, pointer: &str, value: Value) {
    let (parent, name) = pointer.rsplit_once('/').expect("a pointer");
    match document.pointer_mut(parent).expect("a place") {
        Value::Array(items) => {
            let index: usize = name.parse().expect("an index");
            if index == items.len() { items.push(value) } else { items[index] = value }
        }
        Value::Object(map) => {
            map.insert(name.to_owned(), value);
        }
        other => panic!("{pointer} is in {other}"),
    }
}

/// Reads and solves, with a refusal of the geometry as the error that `match` throws.
fn solve(text: &str) -> Result<Solution, DocumentError> {
    let solution = Solve::run(read_text(text)?)?;
    match &solution.outcome {
        Outcome::Refused(error) => Err(error.clone()),
        _ => Ok(solution),
    }
}

#[test]
fn every_case_is_refused_with_its_reason() {
    let table = table();
    assert!(solve(&table["base"].to_string()).is_ok_and(|solution| solution.is_complete()));
    for case in table["cases"].as_array().expect("a list") {
        let start = Instant::now();
        let name = &case["name"];
        let error = solve(&text_of(case, &table["base"])).expect_err(&name.to_string());
        assert!(start.elapsed() < PATIENCE, "{name} took {:?}", start.elapsed());
        if let Some(code) = case["code"].as_str() {
            assert_eq!(error.code.name(), code, "{name}: {error}");
        }
        if let Some(path) = case["path"].as_str() {
            assert_eq!(error.path, path, "{name}: {error}");
        }
        for words in case["says"].as_array().expect("a list") {
            let words = words.as_str().expect("a text");
            assert!(error.message.contains(words), "{name}: {error} does not say {words}");
        }
        assert!(error.message.len() < 400, "{name}: {} characters", error.message.len());
    }
}

/// A document with every field there is.
fn full() -> Value {
    let ring = |r: f64, n: u32| -> Value {
        let at = |k: u32| f64::from(k) * std::f64::consts::TAU / f64::from(n);
        (0..n).map(|k| json!([(r * at(k).cos()).round(), (r * at(k).sin()).round()])).collect()
    };
    json!({
        "directrix": 1, "kind": "curves", "title": "All", "unit": "mm",
        "materials": [{"name": "a", "color": "#f0e442", "void": false}, {"name": "b", "color": "#009e73"}],
        "curves": [
            {"name": "in", "degree": 3, "form": "periodic", "points": ring(10.0, 7), "height": 0,
             "composition": [{"at": 0, "mix": [1, 0]}, {"at": 0.5, "mix": [0.25, 0.75]}]},
            {"degree": 2, "form": "periodic", "points": ring(30.0, 6), "knots": [0, 1, 2, 3, 4, 5, 6]},
        ],
        "sampling": {"scheme": "adaptive", "tolerance": 0.1, "maxTurn": 12, "minCount": 8, "counts": [9, 11]},
        "matching": {"method": "greedy", "normalWeight": 1, "distanceWeight": 2, "alignmentWeight": 0.5,
                     "negative": "half", "oneToOne": true, "policy": "strict"},
        "blend": {"kind": "ruled", "stages": 4},
        "view": {"s": 0.5, "center": [0, 0], "span": 90, "isoMaterial": 1,
                 "layers": ["grid", "normals", "value", "unitCells", "isoComposition", "controlPoints"]},
    })
}

/// Values that a careless hand or program may put anywhere.
fn junk() -> impl Strategy<Value = Value> {
    let plain = [
        json!(null),
        json!(true),
        json!(""),
        json!([]),
        json!({}),
        json!(-1),
        json!(0),
        json!(0.5),
        json!(1),
        json!(2),
        json!(7),
        json!(1e300),
        json!(-1e300),
        json!(1e-300),
        json!(1e12),
        json!(1e15),
        json!("NaN"),
        json!("greedy"),
        json!([[0, 0], [0, 0]]),
        json!([0, 1]),
        json!("\u{0}\u{202e}\u{10ffff}"),
    ];
    prop_oneof![4 => prop::sample::select(plain.to_vec()), 1 => any::<f64>().prop_map(|x| json!(x))]
}

/// What is done to a document: a value put, a field or an item removed, or an item repeated, at the place chosen among all.
#[derive(Debug, Clone)]
enum Change {
    Put(usize, Value),
    Remove(usize),
    Repeat(usize),
}

fn change() -> impl Strategy<Value = Change> {
    prop_oneof![
        3 => (any::<usize>(), junk()).prop_map(|(pick, value)| Change::Put(pick, value)),
        1 => any::<usize>().prop_map(Change::Remove),
        1 => any::<usize>().prop_map(Change::Repeat),
    ]
}

fn places(value: &Value, path: &str, all: &mut Vec<String>) {
    let mut inside = |name: &str, value: &Value| {
        let path = format!("{path}/{name}");
        all.push(path.clone());
        places(value, &path, all);
    };
    match value {
        Value::Array(items) => items.iter().enumerate().for_each(|(k, item)| inside(&k.to_string(), item)),
        Value::Object(map) => map.iter().for_each(|(name, item)| inside(name, item)),
        _ => {}
    }
}

fn apply(document: &mut Value, change: Change) {
    let mut all = Vec::new();
    places(document, "", &mut all);
    if all.is_empty() {
        return;
    }
    let (Change::Put(pick, _) | Change::Remove(pick) | Change::Repeat(pick)) = &change;
    let pointer = &all[pick % all.len()];
    let (parent, name) = pointer.rsplit_once('/').expect("a pointer");
    match (document.pointer_mut(parent).expect("a place"), change) {
        (Value::Array(items), Change::Put(_, value)) => {
            items[name.parse::<usize>().expect("an index")] = value
        }
        (Value::Array(items), Change::Remove(_)) => drop(items.remove(name.parse().expect("an index"))),
        (Value::Array(items), Change::Repeat(_)) => {
            let index: usize = name.parse().expect("an index");
            items.insert(index, items[index].clone());
        }
        (Value::Object(map), Change::Put(_, value)) => drop(map.insert(name.to_owned(), value)),
        (Value::Object(map), Change::Remove(_)) => drop(map.remove(name)),
        (Value::Object(map), Change::Repeat(_)) => {
            let value = map[name].clone();
            map.insert(format!("{name}2"), value);
        }
        _ => unreachable!("a place lies in a list or an object"),
    }
}

/// Solves, paints and writes; an error must have words. Returns whether there was none.
fn survive(text: &str, options: &PictureOptions) -> Result<bool, TestCaseError> {
    let start = Instant::now();
    let shown = read_text(text).and_then(Solve::run).and_then(|solution| {
        options.check(&solution.model)?;
        Ok(solution)
    });
    let accepted = match shown {
        Err(error) => {
            prop_assert!(!error.message.is_empty() && error.message.len() < 1000, "{error}");
            false
        }
        Ok(solution) => {
            let viewport = options.viewport(&solution.model);
            let list = figure(&solution, &options.figure(&solution.model), &viewport);
            if let Ok(pixels) = paint(&list, &viewport) {
                prop_assert_eq!(pixels.len(), viewport.width as usize * viewport.height as usize * 4);
            }
            let svg = to_svg(&list, &viewport, "t", "d");
            prop_assert!(svg.starts_with("<svg") && !svg.contains("NaN") && !svg.contains("inf"));
            true
        }
    };
    prop_assert!(start.elapsed() < PATIENCE, "took {:?}", start.elapsed());
    Ok(accepted)
}

fn options(value: &Value) -> Option<PictureOptions> {
    PictureOptions::read(&Json::parse(&value.to_string()).ok()?).ok()
}

fn picture() -> Value {
    json!({"width": 60, "height": 40, "pixelRatio": 1, "theme": "dark", "background": false, "s": 0.3, "line": 2, "isoMaterial": 0,
           "view": {"center": [1, 2], "scale": 0.7}, "layers": ["material", "inBetweens", "rulingLines", "samples", "unconnected"]})
}

#[test]
fn mutated_documents_are_refused_or_drawn() {
    println!("seed {SEED}");
    let shown = options(&picture()).expect("valid options");
    let (mut accepted, mut refused) = (0, 0);
    seeded(5000, &prop::collection::vec(change(), 1..4), |changes| {
        let mut document = full();
        changes.into_iter().for_each(|change| apply(&mut document, change));
        *(if survive(&document.to_string(), &shown)? { &mut accepted } else { &mut refused }) += 1;
        Ok(())
    });
    assert!(accepted > 300 && refused > 2000, "{accepted} accepted, {refused} refused");
}

#[test]
fn mutated_options_of_pictures_are_refused_or_painted() {
    println!("seed {SEED}");
    let text = full().to_string();
    let mut accepted = 0;
    seeded(400, &prop::collection::vec(change(), 1..3), |changes| {
        let mut value = picture();
        changes.into_iter().for_each(|change| apply(&mut value, change));
        if let Some(options) = options(&value) {
            accepted += u32::from(survive(&text, &options)?);
        }
        Ok(())
    });
    assert!(accepted > 40, "{accepted} accepted");
}

/// Bytes of a document's text changed, dropped, doubled and cut off, not only whole values.
#[test]
fn mutated_texts_are_refused_or_drawn() {
    println!("seed {SEED}");
    let base = full().to_string();
    let shown = options(&picture()).expect("valid options");
    let edit = (any::<prop::sample::Index>(), 0..4_u8, any::<u8>());
    let mut accepted = 0;
    seeded(5000, &prop::collection::vec(edit, 1..5), |edits| {
        let mut bytes = base.clone().into_bytes();
        for (place, kind, byte) in edits {
            if bytes.is_empty() {
                break;
            }
            let index = place.index(bytes.len());
            match kind {
                0 => bytes[index] = byte,
                1 => bytes[index] = b"0123456789-.eE\"[]{},:"[byte as usize % 21],
                2 => drop(bytes.remove(index)),
                _ if byte < 40 => bytes.truncate(index),
                _ => bytes.insert(index, bytes[index]),
            }
        }
        accepted += u32::from(survive(&String::from_utf8_lossy(&bytes), &shown)?);
        Ok(())
    });
    assert!(accepted > 60, "{accepted} accepted");
}

#[test]
fn random_bytes_are_refused() {
    println!("seed {SEED}");
    let json = "[\\[\\]{}\",:0-9eE.+ntrufalse \\\\-]{0,300}";
    let text = prop_oneof![
        prop::collection::vec(any::<u8>(), 0..600)
            .prop_map(|bytes| String::from_utf8_lossy(&bytes).into_owned()),
        json.prop_map(String::from),
        any::<String>(),
    ];
    seeded(5000, &text, |text| {
        let error = read_text(&text).expect_err("no document");
        prop_assert!(!error.message.is_empty() && error.message.len() < 1000);
        Ok(())
    });
}
