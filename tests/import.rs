//! Shapes from SVG, lines of numbers and JSON, from text to curve; what is refused, and random input.

#![cfg(feature = "import")]

use crate::support::seeded;
use directrix::curve::{CornerRule, EndRule, FitOptions, fit};
use directrix::document::{Code, DocumentError};
use directrix::import::{Format, LONGEST_TEXT, MOST_SHAPES, Shape, Shapes, read_shapes};
use glam::{DVec2, dvec2};
use proptest::prelude::*;
use std::f64::consts::TAU;

fn read(text: &str) -> Shapes {
    read_shapes(text, Format::Auto).unwrap_or_else(|error| panic!("{error}"))
}

fn refused(text: &str) -> DocumentError {
    read_shapes(text, Format::Auto).expect_err("refused")
}

fn svg(content: &str) -> String {
    format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 100 100">{content}</svg>"#
    )
}

fn only(content: &str) -> Shape {
    let Shapes { mut shapes, skipped } = read(&svg(content));
    assert_eq!((shapes.len(), skipped.len()), (1, 0), "{shapes:?} {skipped:?}");
    shapes.remove(0)
}

fn bounds(shape: &Shape) -> [f64; 4] {
    let fold = |f: fn(f64, f64) -> f64, of: fn(&DVec2) -> f64| shape.points.iter().map(of).reduce(f).unwrap();
    [fold(f64::min, |p| p.x), fold(f64::min, |p| p.y), fold(f64::max, |p| p.x), fold(f64::max, |p| p.y)]
}

fn assert_bounds(content: &str, expected: [f64; 4]) {
    let found = bounds(&only(content));
    let off = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off < 1e-3, "{content}: {found:?}, expected {expected:?}");
}

#[test]
fn every_basic_shape_is_read_with_y_up() {
    assert_bounds(r#"<rect x="10" y="20" width="30" height="40"/>"#, [10.0, -60.0, 40.0, -20.0]);
    assert_bounds(r#"<circle cx="10" cy="20" r="5"/>"#, [5.0, -25.0, 15.0, -15.0]);
    assert_bounds(r#"<ellipse cx="10" cy="20" rx="5" ry="2"/>"#, [5.0, -22.0, 15.0, -18.0]);
    assert_bounds(r#"<polygon points="0,0 10,0 10,30"/>"#, [0.0, -30.0, 10.0, 0.0]);
    assert_bounds(r#"<polyline points="0,0 10,0 10,30 0 0"/>"#, [0.0, -30.0, 10.0, 0.0]);
    assert_bounds(r#"<path d="M0 0h10v30z"/>"#, [0.0, -30.0, 10.0, 0.0]);
    assert_bounds(
        r#"<rect x="10%" y="1in" width="10mm" height="1pc"/>"#,
        [10.0, -112.0, 10.0 + 960.0 / 25.4, -96.0],
    );
}

#[test]
fn areas_and_lengths_are_those_of_the_shapes() {
    let circle = only(r#"<circle cx="50" cy="50" r="20"/>"#);
    assert!((circle.area - TAU / 2.0 * 400.0).abs() < 0.1 && (circle.length - TAU * 20.0).abs() < 0.01);
    assert!(circle.closed && circle.corners.is_empty());
    // Round corners of 3 x 2: the square without its corners, and an ellipse of these.
    let rounded = only(r#"<rect width="30" height="20" rx="3" ry="2"/>"#);
    assert!((rounded.area - (600.0 - 4.0 * 6.0 + TAU / 2.0 * 6.0)).abs() < 0.01, "{}", rounded.area);
    assert!(rounded.corners.is_empty(), "{:?}", rounded.corners);
    let square = only(r#"<rect width="30" height="20"/>"#);
    assert_eq!((square.area, square.length, square.corners.len()), (600.0, 100.0, 4));
}

#[test]
fn transforms_views_and_uses_are_followed() {
    let rect = r#"<rect width="10" height="20"/>"#;
    for (content, expected) in [
        (format!(r#"<g transform="translate(5 6) scale(2,1)">{rect}</g>"#), [5.0, -26.0, 25.0, -6.0]),
        (format!(r#"<g transform="matrix(0 1 -1 0 0 0)">{rect}</g>"#), [-20.0, -10.0, 0.0, 0.0]),
        (format!(r#"<g transform="rotate(90 10 10)">{rect}</g>"#), [0.0, -10.0, 20.0, 0.0]),
        (format!(r#"<g transform="skewX(45)">{rect}</g>"#), [0.0, -20.0, 30.0, 0.0]),
        (format!(r#"<svg x="1" y="2">{rect}</svg>"#), [1.0, -22.0, 11.0, -2.0]),
        // The view of 20 x 20 fills 40 x 80 in width; the rest of the height is shared.
        (
            format!(r#"<svg width="40" height="80" viewBox="0 0 20 20">{rect}</svg>"#),
            [0.0, -60.0, 20.0, -20.0],
        ),
        (
            format!(
                r#"<svg width="40" height="80" viewBox="0 0 20 20" preserveAspectRatio="none">{rect}</svg>"#
            ),
            [0.0, -80.0, 20.0, 0.0],
        ),
        (format!(r##"<defs><g id="a">{rect}</g></defs><use href="#a" x="3"/>"##), [3.0, -20.0, 13.0, 0.0]),
        (
            format!(
                r##"<symbol id="b" viewBox="0 0 10 20">{rect}</symbol><use xlink:href="#b" y="1" width="20" height="40"/>"##
            ),
            [0.0, -41.0, 20.0, -1.0],
        ),
    ] {
        assert_bounds(&content, expected);
    }
}

#[test]
fn what_is_not_shown_by_itself_does_not_count() {
    let rect = r#"<rect width="10" height="20"/>"#;
    for hidden in [
        format!("<defs>{rect}</defs>"),
        format!(
            "<clipPath>{rect}</clipPath><mask>{rect}</mask><marker>{rect}</marker><pattern>{rect}</pattern>"
        ),
        format!(r#"<g display="none">{rect}</g><g style="fill: red; display : none">{rect}</g>"#),
        format!("<symbol>{rect}</symbol><text>word</text><style>rect {{}}</style>"),
    ] {
        let error = refused(&svg(&hidden));
        assert_eq!((error.code, error.path.as_str()), (Code::Missing, ""), "{hidden}");
        assert_eq!(read(&svg(&format!("{hidden}{rect}"))).shapes.len(), 1);
    }
}

#[test]
fn shapes_are_named_and_what_is_skipped_says_why() {
    let Shapes { shapes, skipped } = read(&svg(r##"<path id="ring" d="M0 0h20v20h-20z M5 5v10h10v-10z"/>
        <path d="M0 0h9v9z"><title> Tooth </title></path>
        <path d="M0 0L5 5"/><path d="M0 0h50v50"/><line x2="10"/><path d="" id="nothing"/><path d="M0 0 L x"/>
        <rect width="0" height="4"/><circle r="-1"/><use href="#gone"/><g transform="turn(3)"><rect/></g>
        <polygon points="0,0 10,0 20,0"/><path d="M0 0h10v10h-10v-9.95"/>"##));
    let names: Vec<_> = shapes.iter().map(|shape| (shape.name.as_str(), shape.closed)).collect();
    assert_eq!(names, [("ring, part 1", true), ("ring, part 2", true), ("Tooth", true), ("path 11", false)]);
    let reasons: Vec<_> = skipped.iter().map(|s| format!("{}: {}", s.name, s.reason)).collect();
    let expected = [
        "path 3: it is open: its ends are 7.07107 apart",
        "path 4: it is open",
        "line 5: a line encloses no area",
        "nothing: it has no points",
        "path 7: its path data breaks off at command 2",
        "rect 8: it has no width or no height",
        "circle 9: it has no radius",
        "use 9: it uses \"#gone\", which is not in the text",
        "g 9: its transform cannot be read",
        "polygon 10: it encloses no area",
    ];
    assert_eq!(reasons.len(), expected.len(), "{reasons:#?}");
    for (reason, expected) in reasons.iter().zip(expected) {
        assert!(reason.starts_with(expected), "{reason}; expected {expected}");
    }
}

#[test]
fn text_that_is_no_svg_is_refused_with_its_line() {
    for (text, code, path) in [
        ("", Code::Syntax, ""),
        (" \n ", Code::Syntax, ""),
        ("<svg>\n<path d=1/></svg>", Code::Syntax, "line 2"),
        ("<html/>", Code::Type, ""),
        ("<svg xmlns='http://www.w3.org/2000/svg'/>", Code::Missing, ""),
        ("<svg>&lt;</sgv>", Code::Syntax, "line 1"),
    ] {
        let error = refused(text);
        assert_eq!((error.code, error.path.as_str()), (code, path), "{text}: {error}");
    }
    assert_eq!(refused(&" ".repeat(LONGEST_TEXT + 1)).code, Code::Limit);
}

#[test]
fn bombs_are_refused() {
    let entities = (1..12).fold(String::from(r#"<!ENTITY e0 "lol">"#), |text, k| {
        let inner = format!("&e{};", k - 1).repeat(10);
        format!(r#"{text}<!ENTITY e{k} "{inner}">"#)
    });
    let bomb = format!("<!DOCTYPE svg [{entities}]><svg>&e11;<rect width='1' height='1'/></svg>");
    assert_eq!(refused(&bomb).code, Code::Syntax);
    // A document type by itself does no harm, nor do entities as drawing programs write them.
    let harmless = r#"<?xml version="1.0"?><!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "svg11.dtd" [<!ENTITY d "M0 0h1v1z">]>
        <svg xmlns="http://www.w3.org/2000/svg"><path d="&d;"/></svg>"#;
    assert_eq!(read(harmless).shapes.len(), 1);

    let deep = svg(&format!("{}<rect/>{}", "<g>".repeat(101), "</g>".repeat(101)));
    assert_eq!(refused(&deep).code, Code::Limit);
    let deeper = svg(&format!("{}{}", "<g>".repeat(90_000), "</g>".repeat(90_000)));
    assert_eq!(refused(&deeper).code, Code::Limit);
    let many = svg(&"<g/>".repeat(100_001));
    assert_eq!(refused(&many).code, Code::Limit);
    assert_eq!(refused(&svg(r##"<g id="a"><use href="#a"/></g>"##)).code, Code::Limit);
    // Uses of uses: 3^20 rectangles.
    let doubled: String = (1..20)
        .map(|k| format!(r##"<g id="g{k}">{}</g>"##, format!(r##"<use href="#g{}"/>"##, k - 1).repeat(3)))
        .collect();
    let bomb = svg(&format!(r#"<g id="g0"><rect width="1" height="1"/></g>{doubled}"#));
    assert_eq!(refused(&bomb).code, Code::Limit);

    let segments = svg(&format!(r#"<path d="M0 0{}z"/>"#, "l1 1".repeat(20_001)));
    assert_eq!(refused(&segments).code, Code::Limit);
    let boxes = svg(&r#"<rect width="1" height="1"/>"#.repeat(MOST_SHAPES + 3));
    let found = read(&boxes);
    assert_eq!((found.shapes.len(), found.skipped.len()), (MOST_SHAPES, 3));
}

#[test]
fn json_is_read_in_all_its_forms() {
    let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)].map(DVec2::from);
    let list = "[[0, 0], [4, 0], [4, 4], [0, 4]]";
    let ring = "[[0, 0, 7], [4, 0, 7], [4, 4, 7], [0, 4, 7], [0, 0, 7]]";
    let objects = r#"[{"x": 0, "y": 0}, {"x": 4, "y": 0}, {"y": 4, "x": 4, "z": 1}, {"x": 0, "y": 4}]"#;
    for (text, names) in [
        (list.to_owned(), vec!["list 1"]),
        (objects.to_owned(), vec!["list 1"]),
        (format!(r#"{{"points": {list}, "name": "Inner"}}"#), vec!["Inner"]),
        (format!(r#"[{list}, {objects}, {{"points": {list}, "name": "C"}}]"#), vec!["list 1", "list 2", "C"]),
        (format!(r#"{{"shapes": [{{"name": "A", "points": {list}}}]}}"#), vec!["A"]),
        (format!(r#"{{"type": "Polygon", "coordinates": [{ring}, {ring}]}}"#), vec!["list 1", "list 2"]),
        (
            format!(r#"{{"type": "MultiPolygon", "coordinates": [[{ring}], [{ring}]]}}"#),
            vec!["list 1", "list 2"],
        ),
        (
            format!(
                r#"{{"type": "FeatureCollection", "features": [{{"type": "Feature", "properties": {{"name": "Lake"}},
                "geometry": {{"type": "Polygon", "coordinates": [{ring}]}}}}]}}"#
            ),
            vec!["Lake"],
        ),
    ] {
        let shapes = read(&text).shapes;
        assert_eq!(shapes.iter().map(|s| s.name.as_str()).collect::<Vec<_>>(), names, "{text}");
        for shape in shapes {
            assert_eq!((shape.points.as_slice(), shape.area, shape.length), (square.as_slice(), 16.0, 16.0));
        }
    }
}

#[test]
fn what_is_wrong_in_json_is_named_by_its_path() {
    for (text, code, path) in [
        ("[", Code::Syntax, ""),
        ("[]", Code::Missing, ""),
        ("{}", Code::Missing, "points"),
        (r#"{"points": 3}"#, Code::Type, "points"),
        ("[[0, 0], [1, \"x\"], [2, 2]]", Code::Type, "[1][1]"),
        ("[[0, 0], [1], [2, 2]]", Code::Type, "[1]"),
        ("[[0, 0], [1, 1e13]]", Code::Range, "[1][1]"),
        ("[[0, 0], [1, 1e999]]", Code::NonFinite, ""),
        ("[0, 0, 4, 0]", Code::Type, "[0]"),
        (r#"[{"x": 0}]"#, Code::Missing, "[0].y"),
        (r#"{"type": "LineString", "coordinates": []}"#, Code::Range, "type"),
        (r#"{"type": "Feature", "geometry": null}"#, Code::Type, "geometry"),
    ] {
        let error = refused(text);
        assert_eq!((error.code, error.path.as_str()), (code, path), "{text}: {error}");
    }
    let many = format!("[{}[0, 1]]", "[0, 0],".repeat(100_000));
    let error = refused(&many);
    assert_eq!((error.code, error.path.as_str()), (Code::Limit, "[20000]"));
    let deep = format!("{}[0, 0]{}", "[".repeat(60), "]".repeat(60));
    assert_eq!(refused(&deep).code, Code::Limit);
}

#[test]
fn short_and_flat_lists_are_skipped_with_the_reason() {
    let Shapes { shapes, skipped } = read("0 0\n1 1\n\n0 0\n1 1\n2 2\n\n0 0\n1 0\n0 1\n");
    assert_eq!((shapes.len(), shapes[0].name.as_str(), shapes[0].closed), (1, "list 3", false));
    let reasons: Vec<_> = skipped.iter().map(|s| s.reason.as_str()).collect();
    assert_eq!(reasons, ["it has 2 different points; a closed shape has at least 3", "it encloses no area"]);
}

#[test]
fn shapes_of_a_drawing_become_curves_with_its_corners() {
    let shape = only(r#"<path d="M10 10 H60 A30 30 0 0 1 60 70 H10 Z"/>"#);
    assert_eq!(shape.corners.len(), 2);
    let options = FitOptions {
        tolerance: 0.05,
        corners: CornerRule::Keep,
        through: false,
        corner_indices: Some(shape.corners.clone()),
        ends: EndRule::Join,
    };
    let result = fit(&shape.points, &options).unwrap();
    assert!(result.simple && result.error <= 0.05 && result.curve.points().len() <= 24);
    assert_eq!(result.curve.corners().len(), 2);
    // The shape is a rectangle and a half disc.
    assert!((result.curve.signed_area().abs() - (50.0 * 60.0 + TAU / 4.0 * 900.0)).abs() < 5.0);
}

/// A few texts of each kind, to be changed at random.
fn samples() -> Vec<String> {
    let points: Vec<_> =
        (0..9).map(|k| dvec2((TAU * f64::from(k) / 9.0).cos(), (TAU * f64::from(k) / 9.0).sin())).collect();
    let lines: String = points.iter().map(|p| format!("{},{}\n", p.x, p.y)).collect();
    vec![
        svg(
            r##"<g transform="translate(3 4) rotate(30)"><path d="M0 0C1 2 3 4 5 6S7 8 9 0Q1 2 3 4T5 6A3 4 20 0 1 9 9H1V2z"/></g>
            <defs><rect id="r" x="1" y="2" width="30%" height="4mm" rx="1"/></defs><use href="#r" x="5"/>"##,
        ),
        svg(
            r#"<svg viewBox="0 0 10 10" width="5" height="4"><ellipse rx="3" ry="4"/><polygon points="1,2 3,4 5,0"/></svg>"#,
        ),
        format!("x;y\n{}", lines.replace('.', "-").replace(',', ";")),
        format!("Outer\n{lines}\n\nInner\n{lines}"),
        r#"{"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4]]], "name": "a"}"#.to_owned(),
        r#"[{"points": [{"x": 0, "y": 1}, {"x": 2, "y": 5}, {"x": 9, "y": 5}]}, [[1, 2], [3, 4], [5, 9]]]"#
            .to_owned(),
    ]
}

/// Whatever is read is fit for use.
fn check(text: &str) {
    for format in [Format::Auto, Format::Svg, Format::Points] {
        let Ok(found) = read_shapes(text, format) else { continue };
        for shape in &found.shapes {
            assert!(shape.points.len() >= 3 && shape.points.iter().all(|p| p.is_finite()));
            assert!(shape.corners.windows(2).all(|pair| pair[0] < pair[1]));
            assert!(shape.corners.last().is_none_or(|last| *last < shape.points.len()));
            assert!(shape.length > 0.0 && shape.area >= 0.0);
            if shape.points.len() < 400 {
                let options = FitOptions {
                    tolerance: 0.01 * shape.length,
                    corners: CornerRule::Keep,
                    through: false,
                    corner_indices: Some(shape.corners.clone()),
                    ends: EndRule::Join,
                };
                if let Ok(result) = fit(&shape.points, &options) {
                    assert!(result.error <= options.tolerance * (1.0 + 1e-6));
                }
            }
        }
    }
}

#[test]
fn random_bytes_never_panic() {
    let texts = prop::collection::vec(any::<u8>(), 0..400);
    seeded(2000, &texts, |bytes| {
        check(&String::from_utf8_lossy(&bytes));
        Ok(())
    });
}

#[test]
fn changed_texts_never_panic() {
    let samples = samples();
    let piece = prop::sample::select(vec![
        "-", ".", "e", "9", "1e308", "<", ">", "/", "\"", "z", "A", "M", ",", ";", "\n", "[", "]", "{", "}",
        "null", "&", "#r", "NaN", "0", " ", "\t", "%", "scale(0)", "\u{0}", "é",
    ]);
    let change =
        (0..samples.len(), prop::collection::vec((any::<prop::sample::Index>(), 0..12_usize, piece), 1..8));
    seeded(4000, &change, |(index, changes)| {
        let mut text: Vec<char> = samples[index].chars().collect();
        for (at, gone, piece) in changes {
            let start = at.index(text.len() + 1);
            let end = (start + gone).min(text.len());
            text.splice(start..end, piece.chars());
        }
        check(&text.iter().collect::<String>());
        Ok(())
    });
}
