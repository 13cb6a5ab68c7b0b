//! Pictures of documents: golden ones of the presets, patterns, and lines where the band has no colours.

use super::presets::{Preset, presets};
use super::*;
use crate::support::golden;
use directrix::material::Color;
use std::path::Path;

#[test]
fn golden_presets() {
    let options = r#"{"width": 280, "height": 210, "theme": "light"}"#;
    let options = PictureOptions::read(&Json::parse(options).expect("JSON")).expect("valid options");
    for Preset { id, text, .. } in presets() {
        let solution = Solve::run(read_text(&text).expect("a valid document")).expect("valid curves");
        let viewport = options.viewport(&solution.model);
        let data = paint(&figure(&solution, &options.figure(&solution.model), &viewport), &viewport);
        let picture = golden::Picture { width: 280, height: 210, data: data.expect("a picture") };
        golden::check(&format!("preset-{id}"), &picture, golden::SAME_CODE);
    }
}

/// The section of each preset of a part, 160 pixels along its longer side, in the colours that the page shows.
#[cfg(feature = "part")]
#[test]
fn golden_sections() {
    use directrix::document::{KnownPart, PartAnswer, PartAsk, PartJob, PartModel, read_part};
    use std::rc::Rc;

    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/presets/part");
    let mut count = 0;
    for file in std::fs::read_dir(folder).expect("the folder of presets") {
        let path = file.expect("a file").path();
        let text = std::fs::read_to_string(&path).expect("a text");
        let document = read_part(&Json::parse(&text).expect("JSON")).expect("a valid document");
        let model = PartModel::new(document).expect("a part");
        let extent = model.part().bounds().map(|bounds| bounds.max - bounds.min).expect("a body");
        let size = extent.to_array().map(|along| (160.0 * along / extent.max_element()).round());
        let options = json!({"options": {"size": [size[0] as u32, size[1] as u32], "colors": true}});
        let ask = PartAsk::read("evaluate", &Json::from(options), &model).expect("a question");
        let answer = PartJob::new(Rc::new(KnownPart::new(model)), ask).run();
        let Some(PartAnswer::Raster(raster, Some(data))) = answer else { panic!("{}", path.display()) };
        let [width, height] = raster.frame.size().map(|along| along as u32);
        let name = path.file_stem().and_then(|name| name.to_str()).expect("a name");
        golden::check(&format!("part-{name}"), &golden::Picture { width, height, data }, golden::SAME_CODE);
        count += 1;
    }
    assert_eq!(count, 9);
}

/// A document as it is painted and written with the given options.
fn drawn(id: &str, options: &str) -> (golden::Picture, String) {
    let Preset { text, .. } = presets().into_iter().find(|preset| preset.id == id).expect("a preset");
    let solution = Solve::run(read_text(&text).expect("a valid document")).expect("valid curves");
    let options = PictureOptions::read(&Json::parse(options).expect("JSON")).expect("valid options");
    let viewport = options.viewport(&solution.model);
    let list = figure(&solution, &options.figure(&solution.model), &viewport);
    let data = paint(&list, &viewport).expect("a picture");
    let picture = golden::Picture { width: viewport.width, height: viewport.height, data };
    (picture, to_svg(&list, &viewport, "t", "d"))
}

#[test]
fn golden_patterns() {
    for id in ["three-materials", "void-core"] {
        let options = r#"{"width": 420, "height": 315, "patterns": true, "layers": ["material"], "s": null}"#;
        golden::check(&format!("patterns-{id}"), &drawn(id, options).0, golden::SAME_CODE);
    }
}

/// Patterns show no colour at all, in pixels and in SVG, and have ink for every material but empty space.
#[test]
fn patterns_are_black_and_white() {
    let options = |patterns: bool| {
        format!(
            r#"{{"width": 420, "height": 315, "patterns": {patterns}, "layers": ["material"], "s": null}}"#
        )
    };
    for (id, hatches) in [("three-materials", 3), ("void-core", 1)] {
        let grey = |picture: &golden::Picture| {
            picture.data.chunks_exact(4).all(|p| p[0].abs_diff(p[1]) <= 6 && p[1].abs_diff(p[2]) <= 6)
        };
        let (picture, svg) = drawn(id, &options(true));
        assert!(grey(&picture), "{id}");
        assert!(!svg.contains("Gradient"), "{id}");
        assert_eq!(svg.matches("fill-rule=\"evenodd\"").count(), hatches, "{id}");
        let (picture, svg) = drawn(id, &options(false));
        assert!(!grey(&picture) && svg.contains("Gradient"), "{id}");
    }
}

/// In-between curves are white on the band; with the material hidden they were white on the white canvas, and ruling lines
/// were black on the black one.
#[test]
fn lines_inside_the_band_show_without_its_colours() {
    let solution = matched(&rings()).expect("valid");
    let painted = |theme: &str, layers: &str| {
        let options = format!(r#"{{"width": 200, "height": 150, "theme": "{theme}", "layers": [{layers}]}}"#);
        let options = PictureOptions::read(&Json::parse(&options).expect("JSON")).expect("valid options");
        let viewport = options.viewport(&solution.model);
        paint(&figure(&solution, &options.figure(&solution.model), &viewport), &viewport).expect("a picture")
    };
    for theme in ["light", "dark"] {
        let bare = painted(theme, "");
        for layer in ["\"inBetweens\"", "\"rulingLines\""] {
            let lines = painted(theme, layer);
            let strong = |(a, b): (&u8, &u8)| a.abs_diff(*b) > 40;
            let changed = bare.iter().zip(&lines).filter(|pair| strong(*pair)).count();
            assert!(changed > 2000, "{theme}, {layer}: {changed} levels changed");
        }
    }
}

/// Where the band does not show the material, the current in-between curve wears it: one colour on rings of one material each, as many as
/// the composition takes along a curve whose material varies.
#[test]
fn the_current_in_between_wears_its_materials_on_the_bare_canvas() {
    let strokes = |document: &Value, layers: &str, s: f64| -> Vec<(f32, Color, Vec<DVec2>)> {
        let solution = matched(document).expect("a valid document");
        let options = format!(r#"{{"width": 300, "height": 240, "s": {s}, "layers": [{layers}]}}"#);
        let options = PictureOptions::read(&Json::parse(&options).expect("JSON")).expect("valid options");
        let viewport = options.viewport(&solution.model);
        let list = figure(&solution, &options.figure(&solution.model), &viewport);
        let current = list.layers.iter().filter(|layer| layer.name == "current");
        current
            .flat_map(|layer| &layer.items)
            .map(|item| match item {
                Item::Stroke { path, style } => (style.width_px, style.color, path.rings.concat()),
                _ => panic!("lines are strokes"),
            })
            .collect()
    };
    let plain = rings();
    let [halo, line] = &strokes(&plain, "\"material\"", 0.5)[..] else { panic!("two lines on the band") };
    assert!(halo.0 > line.0 && line.0 < 2.0);
    // The default materials, mixed in Oklab by the share of the way.
    let [yellow, green] = [Color::new(0xf0, 0xe4, 0x42), Color::new(0x00, 0x9e, 0x73)].map(Color::to_oklab);
    for s in [0.0, 0.25, 1.0] {
        let [casing, worn] = &strokes(&plain, "\"grid\"", s)[..] else { panic!("one colour") };
        assert!(casing.0 > worn.0);
        assert_eq!(worn.1, yellow.lerp(green, s as f32).to_color());
        let (first, last) = (worn.2[0], worn.2[worn.2.len() - 1]);
        assert!(first.distance(last) < 1e-12, "it goes all round");
    }
    let mut varied = rings();
    varied["curves"][1]["composition"] = json!([{"at": 0, "mix": [1, 0]}, {"at": 0.5, "mix": [0, 1]}]);
    let worn = strokes(&varied, "\"grid\"", 1.0);
    assert!(worn.len() > 40, "{} strokes", worn.len());
    let start = |stroke: &(f32, Color, Vec<DVec2>)| stroke.2[0];
    for pair in worn[1..].windows(2) {
        assert!(
            pair[0].2[pair[0].2.len() - 1].distance(start(&pair[1])) < 1e-12,
            "each goes on from the one before"
        );
        assert_ne!(pair[0].1, pair[1].1);
    }
}
