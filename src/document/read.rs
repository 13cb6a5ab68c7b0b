//! Reading of documents.

use super::fields::curves_document;
use super::node::Node;
use super::{Code, CurvesDocument, DocumentError, Json};
use crate::geom::Full;

/// Longest text of a document that is read, in bytes.
pub const LONGEST_TEXT: usize = 4 << 20;

/// The version of the format that this release reads and writes.
const VERSION: f64 = 1.0;

/// Reads a document and checks every field by itself.
///
/// # Errors
/// The first thing that is wrong, with the path of its field: another version, a missing or unknown field, a wrong type, a
/// value out of range, or one that only a later release computes. Shapes and compositions are checked by
/// [`Model::new`](super::Model::new).
pub fn read(document: &Json) -> Result<CurvesDocument, DocumentError> {
    let root = Node::root(document, "");
    check_kind(&root, "curves")?;
    curves_document(&root)
}

/// The kinds of documents.
const KINDS: [&str; 4] = ["curves", "part", "hyperpatch", "laplace"];

/// Refuses a document of another version of the format, and one of another kind than that named.
pub(super) fn check_kind(root: &Node<'_>, expected: &str) -> Result<(), DocumentError> {
    check_version(root)?;
    let kind = root.need("kind")?;
    let found = KINDS[kind.choice(&KINDS)?];
    if found == expected {
        return Ok(());
    }
    Err(kind.error(Code::Kind, format!("`{found}` was found; expected the kind `{expected}`")))
}

/// Refuses a document of another version of the format.
fn check_version(root: &Node<'_>) -> Result<(), DocumentError> {
    let version = root.need("directrix")?;
    let number = version.number()?;
    if number == VERSION {
        return Ok(());
    }
    let message = format!("version {} was found; this release reads version {VERSION}", Full(number));
    Err(version.error(Code::Version, message))
}

/// Refuses text that is too long to be a document.
///
/// # Errors
/// With code `limit`, beyond [`LONGEST_TEXT`] bytes.
pub fn check_length(text: &str) -> Result<(), DocumentError> {
    if text.len() <= LONGEST_TEXT {
        return Ok(());
    }
    let message = format!("the text has {} bytes; at most {LONGEST_TEXT} are read", text.len());
    Err(DocumentError::new(Code::Limit, "", message))
}

/// Reads the text of a document.
///
/// # Errors
/// When the text is too long or is not JSON, and as [`read`] does.
#[cfg(not(target_arch = "wasm32"))]
pub fn read_text(text: &str) -> Result<CurvesDocument, DocumentError> {
    check_length(text)?;
    read(&Json::parse(text)?)
}

/// Writes a document with all defaults spelt out, as one line of JSON.
///
/// # Errors
/// Never for a document that [`read`] accepted; a number that is not finite cannot be written.
#[cfg(not(target_arch = "wasm32"))]
pub fn write_text(document: &CurvesDocument) -> Result<String, DocumentError> {
    serde_json::to_string(document).map_err(|e| DocumentError::new(Code::NonFinite, "", e.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, json};

    fn minimal() -> Value {
        let square = |r: f64| json!([[r, r], [-r, r], [-r, -r], [r, -r]]);
        json!({
            "directrix": 1, "kind": "curves", "matching": {"method": "greedy"},
            "curves": [
                {"degree": 3, "form": "periodic", "points": square(1.0)},
                {"degree": 3, "form": "periodic", "points": square(3.0)},
            ],
        })
    }

    fn refusal(edit: impl FnOnce(&mut Value)) -> (Code, String, String) {
        let mut document = minimal();
        edit(&mut document);
        let error = read_text(&document.to_string()).expect_err("refused");
        (error.code, error.path, error.message)
    }

    fn expect(code: Code, path: &str, edit: impl FnOnce(&mut Value)) {
        let (found, at, message) = refusal(edit);
        assert_eq!((found, at.as_str()), (code, path), "{message}");
        assert!(!message.is_empty());
    }

    #[test]
    fn a_minimal_document_has_the_stated_defaults() {
        let document = read_text(&minimal().to_string()).expect("valid");
        assert_eq!(document.title, "Untitled");
        assert_eq!(document.unit, "mm");
        assert_eq!(document.sampling.counts, [44, 44]);
        assert_eq!((document.matching.normal_weight, document.matching.distance_weight), (1.0, 2.0));
        assert_eq!(document.blend.stages, 5);
        assert!(!document.matching.one_to_one);
    }

    #[test]
    fn adaptive_samples_have_the_stated_defaults() {
        let mut document = minimal();
        document["sampling"] = json!({"scheme": "adaptive"});
        let sampling = read_text(&document.to_string()).expect("valid").sampling;
        // The control points of the larger square lie in a box of 6 by 6.
        let tolerance = sampling.tolerance.expect("spelt out");
        assert!((tolerance - 6e-3 * 2.0_f64.sqrt()).abs() < 1e-15);
        assert_eq!((sampling.max_turn, sampling.min_count), (Some(15.0), Some(12)));
        document["sampling"] = json!({"maxTurn": 20});
        let sampling = read_text(&document.to_string()).expect("valid").sampling;
        assert_eq!((sampling.max_turn, sampling.tolerance), (Some(20.0), None), "kept for later, not used");
        document["sampling"] = json!({"scheme": "adaptive"});
        document["curves"] = json!([]);
        let sampling = read_text(&document.to_string()).expect("valid").sampling;
        assert_eq!(sampling.tolerance, Some(0.1), "of a blank plane 100 units across");
    }

    #[test]
    fn what_is_written_reads_back_as_the_same_document() {
        let document = read_text(&minimal().to_string()).expect("valid");
        let text = write_text(&document).expect("finite");
        assert_eq!(read_text(&text), Ok(document.clone()));
        assert_eq!(write_text(&read_text(&text).expect("valid")).expect("finite"), text);
    }

    #[test]
    fn text_that_is_not_json_is_refused() {
        for text in ["", "{", "null and more", "{\"directrix\": 1,}", "\u{0}"] {
            let error = read_text(text).expect_err("refused");
            assert!(matches!(error.code, Code::Syntax | Code::Type), "{text}: {error}");
            assert_eq!(error.path, "", "{text}");
        }
        let twice = minimal().to_string() + "{}";
        assert_eq!(read_text(&twice).expect_err("refused").code, Code::Syntax);
    }

    #[test]
    fn errors_name_the_field() {
        expect(Code::Missing, "directrix", |d| {
            d.as_object_mut().expect("object").remove("directrix");
        });
        expect(Code::Missing, "matching", |d| {
            d.as_object_mut().expect("object").remove("matching");
        });
        expect(Code::Missing, "matching.method", |d| d["matching"] = json!({}));
        expect(Code::Missing, "curves[1].points", |d| {
            d["curves"][1].as_object_mut().expect("object").remove("points");
        });
        expect(Code::UnknownField, "curves[0].colour", |d| d["curves"][0]["colour"] = json!("red"));
        expect(Code::UnknownField, "sampels", |d| d["sampels"] = json!(4));
        expect(Code::Type, "curves[1].points[2][0]", |d| d["curves"][1]["points"][2][0] = json!("1"));
        expect(Code::Type, "curves[1].points[2][0]", |d| d["curves"][1]["points"][2][0] = Value::Null);
        expect(Code::Type, "curves[1].points[2]", |d| d["curves"][1]["points"][2] = json!([1, 2, 3]));
        expect(Code::Range, "curves[0].form", |d| d["curves"][0]["form"] = json!("closed"));
        expect(Code::Range, "matching.method", |d| d["matching"]["method"] = json!("best"));
        expect(Code::Version, "directrix", |d| {
            d["directrix"] = json!(2);
            d["later"] = json!("field");
        });
    }

    #[test]
    fn numbers_beyond_the_range_of_doubles_are_refused() {
        let text = minimal().to_string().replacen("3.0", "1e999", 1);
        let error = read_text(&text).expect_err("refused");
        assert_eq!(error.code, Code::NonFinite);
        assert!(error.message.contains("line 1"), "{}", error.message);
    }

    #[test]
    fn other_kinds_and_long_texts_are_refused() {
        expect(Code::Kind, "kind", |d| d["kind"] = json!("part"));
        expect(Code::Kind, "kind", |d| d["kind"] = json!("hyperpatch"));
        expect(Code::Range, "kind", |d| d["kind"] = json!("mesh"));
        let error = read_text(&" ".repeat(LONGEST_TEXT + 1)).expect_err("refused");
        assert_eq!(error.code, Code::Limit);
    }

    fn expect_at(code: Code, path: &str, pointer: &str, value: Value) {
        let (parent, field) = pointer.rsplit_once('/').expect("a pointer");
        expect(code, path, |d| {
            for optional in ["sampling", "blend", "view"] {
                d[optional] = json!({});
            }
            d.pointer_mut(parent).expect("a parent")[field] = value;
        });
    }

    #[test]
    #[cfg(feature = "harmonic")]
    fn a_harmonic_blend_has_the_stated_defaults() {
        let mut document = minimal();
        document["blend"] = json!({"kind": "harmonic"});
        let blend = read_text(&document.to_string()).expect("valid").blend;
        assert_eq!((blend.lines, blend.segments, blend.stages), (Some(44), Some(200), 5));
        document["blend"] = json!({"segments": 300});
        let read = read_text(&document.to_string()).expect("valid");
        assert_eq!((read.blend.lines, read.blend.segments), (None, Some(300)), "kept for later, not used");
        assert_eq!(read_text(&write_text(&read).expect("finite")), Ok(read));
        expect_at(Code::Range, "blend.segments", "/blend/segments", json!(15));
        expect_at(Code::Limit, "blend.segments", "/blend/segments", json!(1001));
        expect_at(Code::Range, "blend.lines", "/blend/lines", json!(0));
        expect_at(Code::Limit, "blend.lines", "/blend/lines", json!(401));
    }

    #[test]
    fn settings_of_methods_have_the_stated_defaults() {
        let with = |matching: Value| {
            let mut document = minimal();
            document["matching"] = matching;
            let read = read_text(&document.to_string()).expect("valid");
            assert_eq!(read_text(&write_text(&read).expect("finite")), Ok(read.clone()));
            read.matching
        };
        let greedy = with(json!({"method": "greedy"}));
        assert_eq!((greedy.objective, greedy.shift, greedy.line_price), (None, None, None));
        let exact = with(
            json!({"method": "exact", "pins": [{"u": 0.25, "v": -1}], "printed": ["heights", "normals"]}),
        );
        assert_eq!(exact.objective, Some(super::super::ObjectiveName::Integral));
        assert_eq!((exact.lines, exact.pins.len()), (None, 1));
        assert!(exact.is_printed(super::super::PrintedRule::Normals));
        let priced = with(json!({"method": "exact", "objective": "sum-less-price"}));
        assert_eq!(priced.line_price, Some(0.0));
        let shift = with(json!({"method": "shift"}));
        assert_eq!(shift.shift, Some(super::super::Shift::Best(super::super::BestShift::Best)));
        let shift = with(json!({"method": "shift", "shift": 4}));
        assert_eq!(shift.shift, Some(super::super::Shift::By(4)));
    }

    #[test]
    fn values_out_of_range_are_refused_by_path() {
        expect_at(Code::Range, "matching.objective", "/matching/objective", json!("mean"));
        expect_at(Code::Range, "matching.linePrice", "/matching/linePrice", json!(-1));
        expect_at(Code::Range, "matching.lines", "/matching/lines", json!(2));
        expect_at(Code::Limit, "matching.lines", "/matching/lines", json!(1001));
        expect_at(Code::Range, "matching.shift", "/matching/shift", json!("most"));
        expect_at(Code::Type, "matching.shift", "/matching/shift", json!(-3));
        expect_at(Code::Range, "matching.policy", "/matching/policy", json!("mend"));
        expect_at(Code::Range, "matching.pins", "/matching/pins", json!([{"u": 0.1, "v": 0.2}]));
        expect_at(Code::Range, "matching.printed[1]", "/matching/printed", json!(["stop", "start"]));
        expect_at(Code::Range, "curves[1].height", "/curves/1/height", json!(1e300));
        expect_at(Code::Range, "sampling.counts", "/sampling/counts", json!([4]));
        expect_at(Code::Range, "sampling.counts[1]", "/sampling/counts", json!([4, 2]));
        expect_at(Code::Limit, "sampling.counts[0]", "/sampling/counts", json!([1001, 4]));
        expect_at(Code::Type, "sampling.counts[0]", "/sampling/counts", json!([-1, 4]));
        expect_at(Code::Type, "sampling.counts[1]", "/sampling/counts", json!([4, 5.5]));
        expect_at(Code::Range, "sampling.tolerance", "/sampling/tolerance", json!(0));
        expect_at(Code::Range, "sampling.tolerance", "/sampling/tolerance", json!(1e13));
        expect_at(Code::Range, "sampling.maxTurn", "/sampling/maxTurn", json!(0.9));
        expect_at(Code::Range, "sampling.maxTurn", "/sampling/maxTurn", json!(91));
        expect_at(Code::Range, "sampling.minCount", "/sampling/minCount", json!(2));
        expect_at(Code::Limit, "sampling.minCount", "/sampling/minCount", json!(1001));
        expect_at(Code::Type, "sampling.minCount", "/sampling/minCount", json!(12.5));
        expect_at(Code::Range, "matching.normalWeight", "/matching/normalWeight", json!(-1));
        expect_at(Code::Range, "matching.distanceWeight", "/matching/distanceWeight", json!(101));
        expect_at(Code::Type, "matching.oneToOne", "/matching/oneToOne", json!(1));
        expect_at(Code::Range, "blend.stages", "/blend/stages", json!(0));
        expect_at(Code::Limit, "blend.stages", "/blend/stages", json!(201));
        expect_at(Code::Range, "materials", "/materials", json!([]));
        expect_at(Code::Limit, "title", "/title", json!("x".repeat(201)));
        expect_at(Code::Range, "view.s", "/view/s", json!(1.5));
        expect_at(Code::Range, "view.isoMaterial", "/view/isoMaterial", json!(2));
        expect_at(Code::Type, "view.isoMaterial", "/view/isoMaterial", json!(-1));
        expect_at(Code::Type, "view.patterns", "/view/patterns", json!("yes"));
        expect_at(Code::Range, "view.layers[0]", "/view/layers", json!(["rulings"]));
    }
}
