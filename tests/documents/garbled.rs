//! Random documents, curves and texts: refused or solved, never a panic and never a false certificate.

use super::{draw, pair, rings, solve};
use crate::support::seeded;
use directrix::document::{Outcome, read_text};
use glam::DVec2;
use proptest::prelude::*;
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// Values that a careless hand or program may put anywhere.
fn junk() -> impl Strategy<Value = Value> {
    prop_oneof![
        Just(Value::Null),
        Just(json!(-1)),
        Just(json!(0)),
        Just(json!(1e300)),
        Just(json!(1e-300)),
        Just(json!("")),
        Just(json!([])),
        Just(json!({})),
        Just(json!(true)),
        Just(json!([[0, 0], [0, 0]])),
        any::<f64>().prop_map(|x| json!(x)),
    ]
}

/// Puts a value at the place that `pick` chooses among all places of a document.
fn mutate(document: &mut Value, pick: usize, value: Value) {
    fn places(value: &Value, path: String, all: &mut Vec<String>) {
        all.push(path.clone());
        match value {
            Value::Array(items) => {
                items.iter().enumerate().for_each(|(k, v)| places(v, format!("{path}/{k}"), all))
            }
            Value::Object(map) => map.iter().for_each(|(k, v)| places(v, format!("{path}/{k}"), all)),
            _ => {}
        }
    }
    let mut all = Vec::new();
    places(document, String::new(), &mut all);
    *document.pointer_mut(&all[pick % all.len()]).expect("a place") = value;
}

#[test]
fn mutated_documents_never_panic() {
    let mut full: Value = rings();
    full["sampling"] =
        json!({"scheme": "adaptive", "counts": [9, 11], "tolerance": 1, "maxTurn": 40, "minCount": 9});
    full["blend"] = json!({"kind": "ruled", "stages": 3});
    full["matching"]["oneToOne"] = json!(true);
    full["view"] =
        json!({"s": 0.5, "center": [0, 0], "span": 90, "layers": ["grid", "normals", "value", "unitCells"]});
    full["curves"][0]["composition"] = json!([{"at": 0.25, "mix": [0.5, 0.5]}, {"at": 0.5, "mix": [0, 1]}]);
    let (mut accepted, mut refused) = (0, 0);
    let mutations = prop::collection::vec((any::<usize>(), junk()), 1..3);
    seeded(3000, &mutations, |mutations| {
        let mut document = full.clone();
        for (pick, value) in mutations {
            mutate(&mut document, pick, value);
        }
        match solve(&document) {
            Err(error) => {
                prop_assert!(!error.message.is_empty());
                refused += 1;
            }
            Ok(solution) => {
                draw(&solution);
                accepted += 1;
            }
        }
        Ok(())
    });
    assert!(accepted > 100 && refused > 1000, "{accepted} accepted, {refused} refused");
}

#[test]
fn random_curves_never_panic_and_never_pass_a_false_certificate() {
    // Half of the curves run once round the origin, so that many pairs are nested; the others run anywhere.
    let radii = |range: std::ops::Range<f64>| prop::collection::vec((range, -50.0..50.0), 3..9);
    let strategy = (radii(2.0..20.0), radii(15.0..50.0), any::<bool>(), 2_usize..5, 3_usize..40, 3_usize..40);
    let mut complete = 0;
    seeded(1500, &strategy, |(inner, outer, is_round, degree, a, b)| {
        let list = |points: &[(f64, f64)]| -> Value {
            let count = points.len() as f64;
            let round = |k: usize, r: f64| (r * DVec2::from_angle(TAU * k as f64 / count)).to_array();
            let place = |(k, &(x, y)): (usize, &(f64, f64))| if is_round { round(k, x) } else { [x, y] };
            points.iter().enumerate().map(place).map(|p| json!(p)).collect()
        };
        let mut document = pair(list(&inner), list(&outer));
        document["curves"][0]["degree"] = json!(degree);
        document["curves"][1]["degree"] = json!(degree);
        document["sampling"] = json!({"counts": [a, b]});
        document["matching"]["oneToOne"] = json!(true);
        let Ok(solution) = solve(&document) else { return Ok(()) };
        draw(&solution);
        if let Outcome::Matched { matching, pairs, .. } = &solution.outcome {
            prop_assert_eq!((matching.totals.crossings, matching.totals.blocked), (0, 0));
            prop_assert_eq!(matching.is_complete(), pairs.is_some());
            if let Some(pairs) = pairs {
                prop_assert_eq!((pairs.totals.crossings, pairs.totals.blocked), (0, 0));
                prop_assert!(pairs.totals.eta.is_none_or(|eta| eta <= 1.0 + 1e-12));
            }
            complete += u32::from(solution.is_complete());
        }
        Ok(())
    });
    assert!(complete > 200, "{complete} complete matchings");
}

#[test]
fn random_text_never_panics() {
    seeded(2000, &any::<Vec<u8>>(), |bytes| {
        let text = String::from_utf8_lossy(&bytes);
        prop_assert!(read_text(&text).is_err());
        Ok(())
    });
}
