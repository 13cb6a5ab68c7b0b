//! The presets of curves: what the list says of them, and what they show.

use super::*;
use std::path::Path;

/// A preset as the gallery lists it, and the text of its document.
pub struct Preset {
    pub id: String,
    pub title: Value,
    /// Whether the list says that there is a matching.
    pub matched: bool,
    pub text: String,
}

/// The presets in the order of the gallery.
pub fn presets() -> Vec<Preset> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/presets");
    let index = std::fs::read_to_string(folder.join("index.json")).expect("the list of presets");
    let index: Value = serde_json::from_str(&index).expect("JSON");
    let preset = |entry: &Value| {
        let id = entry["id"].as_str().expect("an id").to_owned();
        let text = std::fs::read_to_string(folder.join(format!("{id}.json"))).expect("the preset");
        Preset { id, title: entry["title"].clone(), matched: entry.get("matched").is_none(), text }
    };
    index.as_array().expect("a list").iter().map(preset).collect()
}

#[test]
fn presets_are_listed_once_each_and_say_what_they_hold() {
    let presets = presets();
    assert!(presets.len() >= 14);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/presets");
    let files = std::fs::read_dir(folder).expect("the folder of presets");
    // Bodies of hyperpatches and parts have folders of their own.
    let mut files: Vec<String> = files
        .map(|file| file.expect("a file").file_name().to_string_lossy().into_owned())
        .filter(|name| name.ends_with(".json"))
        .collect();
    let mut listed: Vec<String> = presets.iter().map(|preset| format!("{}.json", preset.id)).collect();
    listed.push("index.json".to_owned());
    files.sort();
    listed.sort();
    assert_eq!(files, listed);
    for Preset { id, title, text, .. } in presets {
        let document = read_text(&text).expect("a valid document");
        let one_to_one = id != "eight-and-two-hundred";
        let written = [String::from("\"method\": \"exact\""), format!("\"oneToOne\": {one_to_one}")];
        assert!(written.iter().all(|field| text.contains(field)), "{id}");
        assert_eq!(title, json!(document.title), "{id}");
    }
}

#[test]
fn presets_are_matched_completely_or_shown_as_not_matchable() {
    let presets = presets();
    assert_eq!(presets.iter().filter(|preset| !preset.matched).count(), 1);
    for Preset { id, matched, text, .. } in presets {
        let solution = Solve::run(read_text(&text).expect("a valid document")).expect("valid curves");
        if let Some(stack) = solution.stack() {
            assert!(stack.is_complete && solution.diagnostics.is_empty(), "{id}: {:?}", codes(&solution));
            let etas = stack.spans.iter().map(|span| span.lines().and_then(|(_, _, totals)| totals.eta));
            assert!(etas.flatten().all(|eta| eta > 0.9), "{id}");
            continue;
        }
        #[cfg(feature = "harmonic")]
        if let Some(harmonic) = solution.harmonic() {
            let blend = &harmonic.blend;
            assert!(solution.diagnostics.is_empty(), "{id}: {:?}", codes(&solution));
            assert_eq!((blend.crossings(), blend.lost(), matched), (0, 0, true), "{id}");
            assert!(blend.solution().flux_balance().iter().all(|balance| balance.abs() < 1e-3), "{id}");
            continue;
        }
        let Outcome::Matched { matching, .. } = &solution.outcome else { panic!("{id} is not matched") };
        let totals = &matching.totals;
        assert_eq!((totals.crossings, totals.blocked), (0, 0), "{id}");
        assert_eq!((matching.is_complete(), solution.is_complete()), (matched, matched), "{id}: {totals:?}");
        let codes = codes(&solution);
        if matched {
            let advice = |code: &&str| matches!(*code, "corner" | "opposed-normals");
            assert!(codes.iter().all(advice), "{id}: {codes:?}");
            assert!(totals.eta.is_some_and(|eta| eta > 0.8 && eta <= 1.0), "{id}: {totals:?}");
        } else {
            assert!(codes.contains(&"orphan"), "{id}: {codes:?}");
            assert!(totals.eta.is_none() && totals.uncovered[0].len() > 5, "{id}: {totals:?}");
        }
    }
}

/// What the gallery says of single presets.
#[test]
fn presets_show_what_they_are_there_for() {
    let presets = presets();
    let solved = |id: &str| {
        let preset = presets.iter().find(|preset| preset.id == id).expect("a preset of that name");
        Solve::run(read_text(&preset.text).expect("a valid document")).expect("valid curves")
    };
    let eta = |id: &str| {
        let Outcome::Matched { matching, .. } = solved(id).outcome else { panic!("{id} is not matched") };
        matching.totals.eta.expect("covered")
    };
    assert!(eta("offset-pair") > 1.0 - 1e-5, "every line is the best at both ends");
    assert!(eta("nested-ellipses") < 0.95);

    let square = solved("sharp-square");
    assert_eq!(codes(&square), ["corner"; 4]);
    let samples = |id: &str| solved(id).model.samples().iter().map(|s| s.points.len()).collect::<Vec<_>>();
    assert_eq!(samples("eight-and-two-hundred"), [8, 200]);
    assert_eq!(samples("reference-pair"), [44, 44]);
    let lengths: Vec<f64> =
        solved("small-in-large").model.curves().iter().map(|curve| curve.length()).collect();
    assert!((lengths[1] / lengths[0] - 13.0).abs() < 0.5, "{lengths:?}");
    for id in ["amoeba", "three-materials", "bone-section", "blade", "drop-in-leaf"] {
        assert_eq!(solved(id).model.document().materials.len(), 3, "{id}");
    }
    assert!(solved("void-core").model.document().materials[0].void);
}
