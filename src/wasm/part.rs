//! Parts: questions and their answers, in steps.

use super::clock;
use super::engine::Engine;
use super::error::to_js;
use super::json::parse;
use crate::document::{
    self, Along, ComposingRule, DocumentError, KnownPart, LeafRow, PartAmounts, PartAnswer, PartAsk,
    PartDiagnostic, PartJob, PartMemory, PartModel,
};
use crate::geom::Bounds;
use crate::part::{Blend, Frame, PartIsoline, Place, Raster};
use js_sys::{Array, Float32Array, Float64Array, Object, Reflect, Uint8Array, Uint32Array};
use serde::Serialize;
use std::rc::Rc;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

/// An answer under way.
#[wasm_bindgen]
pub struct PartAsking {
    /// The text of a document that is still to be read, with the name of the question and what belongs to it.
    unread: Option<[String; 3]>,
    job: Option<PartJob>,
    known: Option<Rc<KnownPart>>,
    answer: Option<PartAnswer>,
}

#[wasm_bindgen]
impl Engine {
    /// A question about a part document by its name, to be answered in steps; what belongs to it comes as JSON.
    pub fn part(&mut self, text: &str, name: &str, rest: &str) -> PartAsking {
        let unread = Some([text, name, rest].map(str::to_owned));
        PartAsking { unread, job: None, known: None, answer: None }
    }

    /// Goes on with an answer for about `budget` milliseconds; returns the share done, 1 when it is there. Reading a document takes a turn
    /// of its own.
    #[wasm_bindgen(js_name = answerPart)]
    pub fn advance_part(&mut self, asking: &mut PartAsking, budget: f64) -> Result<f64, JsValue> {
        let clock = clock();
        let start = clock.now();
        let mut may_go_on = || clock.now() - start < budget;
        if let Some([text, name, rest]) = asking.unread.take() {
            let known = part(&mut self.parts, &text).map_err(|error| to_js(&error))?;
            let ask = parse(&rest)
                .and_then(|rest| PartAsk::read(&name, &rest, known.model()))
                .map_err(|error| to_js(&error))?;
            asking.job = Some(PartJob::new(Rc::clone(&known), ask));
            asking.known = Some(known);
            if !may_go_on() {
                return Ok(0.0);
            }
        }
        let Some(job) = &mut asking.job else { return Ok(1.0) };
        asking.answer = job.step(&mut may_go_on);
        if asking.answer.is_none() {
            return Ok(job.progress());
        }
        asking.job = None;
        Ok(1.0)
    }
}

/// The part of a document, read unless it is known.
fn part(memory: &mut PartMemory, text: &str) -> Result<Rc<KnownPart>, DocumentError> {
    if let Some(known) = memory.find(text) {
        return Ok(known);
    }
    document::check_length(text)?;
    let model = PartModel::new(document::read_part(&parse(text)?)?)?;
    Ok(memory.keep(text, model))
}

#[wasm_bindgen]
impl PartAsking {
    /// The answer, which is there when [`Engine::advance_part`] has returned 1.
    pub fn result(self) -> Result<JsValue, JsValue> {
        let (Some(answer), Some(known)) = (&self.answer, &self.known) else { return Ok(JsValue::UNDEFINED) };
        let model = known.model();
        match answer {
            PartAnswer::Model => value(&Summary::new(known)),
            PartAnswer::Defaults => value(model.document()),
            PartAnswer::Raster(found, colors) => raster(found, colors.as_deref()),
            PartAnswer::Place(place) => value(&place.as_ref().map(|place| Probed::new(model, place))),
            PartAnswer::Along(found) => along(found),
            PartAnswer::Violations(found, masks, counts) => violations(model, found, masks, counts),
            PartAnswer::Amounts(amounts) => value(&Amounts::new(amounts)),
            PartAnswer::Isolines(lines) => value(&lines.iter().map(Lines::new).collect::<Vec<_>>()),
            PartAnswer::Leaves(rows) => {
                value(&rows.iter().map(|row| Leaf::new(model, row)).collect::<Vec<_>>())
            }
            PartAnswer::File(bytes) => Ok(Uint8Array::from(bytes.as_slice()).into()),
        }
    }
}

fn value<T: Serialize + ?Sized>(value: &T) -> Result<JsValue, JsValue> {
    let serializer =
        serde_wasm_bindgen::Serializer::new().serialize_missing_as_null(true).serialize_maps_as_objects(true);
    value.serialize(&serializer).map_err(JsValue::from)
}

fn corners(bounds: Bounds) -> [[f64; 2]; 2] {
    [bounds.min.to_array(), bounds.max.to_array()]
}

/// What is to be said about a part.
#[derive(Serialize)]
struct Summary<'a> {
    bodies: Vec<Body<'a>>,
    diagnostics: Vec<PartDiagnostic>,
    #[serde(rename = "box")]
    bounds: Option<[[f64; 2]; 2]>,
}

#[derive(Serialize)]
struct Body<'a> {
    name: &'a str,
    rule: ComposingRule,
    /// Whether it could be made.
    made: bool,
    #[serde(rename = "box")]
    bounds: Option<[[f64; 2]; 2]>,
    /// Number of elements of its blend.
    blend: Option<usize>,
    features: Vec<FeatureRow<'a>>,
}

#[derive(Serialize)]
struct FeatureRow<'a> {
    name: &'a str,
    /// Whether it takes part: not hidden, and without a fault.
    active: bool,
}

impl<'a> Summary<'a> {
    fn new(known: &'a KnownPart) -> Self {
        let (model, part) = (known.model(), known.part());
        let bodies = model.document().bodies.iter().zip(&part.bodies);
        let body = |(spec, made): (&'a document::BodySpec, &Option<crate::part::Body>)| {
            let slots = made.as_ref().map_or(&[][..], |body| &body.slots);
            let feature = |(k, feature): (usize, &'a document::FeatureSpec)| FeatureRow {
                name: &feature.name,
                active: slots.contains(&(k as u32)),
            };
            Body {
                name: &spec.name,
                rule: spec.rule,
                made: made.is_some(),
                bounds: made.as_ref().map(|body| corners(body.region.bounds())),
                blend: made.as_ref().and_then(|body| body.blend.as_ref()).map(Blend::elements),
                features: spec.features.iter().enumerate().map(feature).collect(),
            }
        };
        Self {
            bodies: bodies.map(body).collect(),
            diagnostics: known.diagnostics(),
            bounds: model.part().bounds().map(corners),
        }
    }
}

/// What there is at a point.
#[derive(Serialize)]
struct Probed<'a> {
    body: usize,
    fractions: Option<&'a [f64]>,
    leaf: u32,
    distances: Vec<Distance<'a>>,
    /// Index of the feature to which the distance is least.
    nearest: Option<u32>,
}

#[derive(Serialize)]
struct Distance<'a> {
    feature: u32,
    name: &'a str,
    distance: f64,
    holds: bool,
}

impl<'a> Probed<'a> {
    fn new(model: &'a PartModel, place: &'a Place) -> Self {
        let slots = model.part().bodies[place.body].as_ref().map_or(&[][..], |body| &body.slots);
        let features = &model.document().bodies[place.body].features;
        let row = |(feature, distance): (&u32, &f64)| Distance {
            feature: *feature,
            name: &features[*feature as usize].name,
            distance: *distance,
            holds: place.leaf >> feature & 1 == 1,
        };
        let nearest = slots.iter().zip(&place.distances).min_by(|a, b| a.1.total_cmp(b.1));
        Self {
            body: place.body,
            fractions: place.fractions.as_deref(),
            leaf: place.leaf,
            distances: slots.iter().zip(&place.distances).map(row).collect(),
            nearest: nearest.map(|(feature, _)| *feature),
        }
    }
}

#[derive(Serialize)]
struct Amounts<'a> {
    area: f64,
    amounts: Vec<f64>,
    bodies: Vec<BodyAmounts<'a>>,
}

#[derive(Serialize)]
struct BodyAmounts<'a> {
    area: f64,
    amounts: &'a [f64],
}

impl<'a> Amounts<'a> {
    fn new(found: &'a PartAmounts) -> Self {
        let materials = found.amounts.first().map_or(0, Vec::len);
        let total = |material: usize| found.amounts.iter().map(|list| list[material]).sum();
        let body = |(area, amounts): (&f64, &'a Vec<f64>)| BodyAmounts { area: *area, amounts };
        Self {
            area: found.areas.iter().sum(),
            amounts: (0..materials).map(total).collect(),
            bodies: found.areas.iter().zip(&found.amounts).map(body).collect(),
        }
    }
}

#[derive(Serialize)]
struct Lines {
    level: f64,
    lines: Vec<Vec<[f64; 2]>>,
    closed: Vec<bool>,
}

impl Lines {
    fn new((level, lines): &(f64, Vec<PartIsoline>)) -> Self {
        let points = |line: &PartIsoline| line.points.iter().map(|point| point.to_array()).collect();
        Self {
            level: *level,
            lines: lines.iter().map(points).collect(),
            closed: lines.iter().map(|line| line.is_closed).collect(),
        }
    }
}

/// A leaf with the features that hold it.
#[derive(Serialize)]
struct Leaf<'a> {
    body: usize,
    leaf: u32,
    features: Vec<usize>,
    names: Vec<&'a str>,
    area: f64,
}

impl<'a> Leaf<'a> {
    fn new(model: &'a PartModel, row: &LeafRow) -> Self {
        let all = &model.document().bodies[row.body].features;
        let features: Vec<usize> = (0..all.len()).filter(|k| row.leaf >> k & 1 == 1).collect();
        let names = features.iter().map(|k| all[*k].name.as_str()).collect();
        Self { body: row.body, leaf: row.leaf, names, features, area: row.area }
    }
}

fn set(bag: &Object, name: &str, value: JsValue) -> Result<(), JsValue> {
    Reflect::set(bag, &name.into(), &value).map(|_| ())
}

/// An object with the size and the box of a raster.
fn framed(frame: &Frame) -> Result<Object, JsValue> {
    let bag = Object::new();
    set(&bag, "size", value(&frame.size())?)?;
    set(&bag, "box", value(&corners(frame.bounds()))?)?;
    Ok(bag)
}

fn raster(found: &Raster, colors: Option<&[u8]>) -> Result<JsValue, JsValue> {
    let bag = framed(&found.frame)?;
    set(&bag, "body", Uint8Array::from(found.body.as_slice()).into())?;
    let fractions = found.fractions.iter().map(|list| Float32Array::from(list.as_slice())).collect::<Array>();
    set(&bag, "fractions", fractions.into())?;
    set(&bag, "leaves", Uint32Array::from(found.leaves.as_slice()).into())?;
    if let Some(colors) = colors {
        set(&bag, "colors", Uint8Array::from(colors).into())?;
    }
    Ok(bag.into())
}

fn along(found: &Along) -> Result<JsValue, JsValue> {
    let bag = Object::new();
    set(&bag, "body", Uint8Array::from(found.body.as_slice()).into())?;
    let fractions = found.fractions.iter().map(|list| Float64Array::from(list.as_slice())).collect::<Array>();
    set(&bag, "fractions", fractions.into())?;
    set(&bag, "leaves", Uint32Array::from(found.leaves.as_slice()).into())?;
    Ok(bag.into())
}

fn violations(
    model: &PartModel,
    found: &Raster,
    masks: &[u32],
    counts: &[usize],
) -> Result<JsValue, JsValue> {
    #[derive(Serialize)]
    struct Row<'a> {
        rule: usize,
        name: &'a str,
        count: usize,
        area: f64,
    }
    let pixel = found.frame.step().x * found.frame.step().y;
    let row = |(rule, count): (usize, &usize)| Row {
        rule,
        name: &model.document().rules[rule].name,
        count: *count,
        area: *count as f64 * pixel,
    };
    let bag = framed(&found.frame)?;
    set(&bag, "rules", value(&counts.iter().enumerate().map(row).collect::<Vec<_>>())?)?;
    set(&bag, "pixels", Uint32Array::from(masks).into())?;
    Ok(bag.into())
}
