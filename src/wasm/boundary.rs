//! Boundary value problems of documents, and solutions that are known, in steps.

use super::clock;
use super::engine::Engine;
use super::error::to_js;
use super::json::parse;
use super::laplace::fault;
use crate::document::{
    self, BoundaryDiagnostic, BoundaryJob, BoundaryProblem, ExactJob, SolverSpec, read_laplace,
};
use crate::laplace::Space;
use glam::DVec3;
use js_sys::{Array, Float64Array, Object, Reflect, Uint32Array};
use serde::Serialize;
use std::rc::Rc;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

/// A question about a document of a boundary value problem.
#[wasm_bindgen]
pub struct BoundaryAsking {
    text: String,
    /// Coordinates of points whose exact fractions are asked for.
    points: Option<Vec<f64>>,
    work: Work,
}

enum Work {
    Unread,
    Making(Box<BoundaryJob>),
    Found(Rc<BoundaryProblem>),
    Evaluating(ExactJob),
}

#[wasm_bindgen]
impl Engine {
    /// The boundary of a document, or with points, coordinate after coordinate, the exact fractions there; to be answered in steps.
    pub fn boundary(&self, text: &str, points: Option<Vec<f64>>) -> BoundaryAsking {
        BoundaryAsking { text: text.to_owned(), points, work: Work::Unread }
    }

    /// Goes on with an answer for about `budget` milliseconds; returns the share done, 1 when it is there. Reading a document takes a turn of its own.
    #[wasm_bindgen(js_name = answerBoundary)]
    pub fn advance_boundary(&mut self, asking: &mut BoundaryAsking, budget: f64) -> Result<f64, JsValue> {
        let clock = clock();
        let start = clock.now();
        let mut may_go_on = || clock.now() - start < budget;
        loop {
            match &mut asking.work {
                Work::Unread => {
                    if let Some(known) = self.boundaries.find(&asking.text) {
                        asking.work = Work::Found(known);
                        continue;
                    }
                    let document = document::check_length(&asking.text)
                        .and_then(|()| read_laplace(&parse(&asking.text)?))
                        .map_err(|error| to_js(&error))?;
                    asking.work = Work::Making(Box::new(BoundaryJob::new(document)));
                    if !may_go_on() {
                        return Ok(0.0);
                    }
                }
                Work::Making(job) => {
                    if !job.step(&mut may_go_on) {
                        return Ok(job.progress());
                    }
                    if let Work::Making(job) = std::mem::replace(&mut asking.work, Work::Unread) {
                        asking.work = Work::Found(self.boundaries.keep(&asking.text, job.boundary()));
                    }
                }
                Work::Found(known) => {
                    let Some(points) = asking.points.take() else { return Ok(1.0) };
                    asking.work = Work::Evaluating(evaluating(known, &points)?);
                }
                Work::Evaluating(job) => {
                    let is_done = job.step(&mut may_go_on).map_err(|error| fault(&error, 3))?;
                    return Ok(if is_done { 1.0 } else { job.progress().min(0.999) });
                }
            }
        }
    }
}

/// A question about points, refused where no exact solution is known.
fn evaluating(known: &Rc<BoundaryProblem>, points: &[f64]) -> Result<ExactJob, JsValue> {
    let dimension = known.space.dimension();
    if known.exact.is_none() {
        let message = "no exact solution of this problem is known; expected one whose `boundary` names it";
        return Err(refusal("no-exact", "model", message));
    }
    if !points.len().is_multiple_of(dimension) {
        let message = format!("{} numbers were found; expected {dimension} for each point", points.len());
        return Err(refusal("range", "points", &message));
    }
    let point = |numbers: &[f64]| DVec3::new(numbers[0], numbers[1], numbers.get(2).copied().unwrap_or(0.0));
    let points = points.chunks_exact(dimension).map(point).collect();
    ExactJob::new(Rc::clone(known), points).map_err(|error| fault(&error, dimension))
}

fn refusal(code: &str, path: &str, message: &str) -> JsValue {
    let object = js_sys::Error::new(message);
    for (key, value) in [("code", code), ("path", path)] {
        // Setting a field of a new object fails only when the object is frozen, which it is not.
        let _ = Reflect::set(&object, &key.into(), &value.into());
    }
    object.into()
}

#[wasm_bindgen]
impl BoundaryAsking {
    /// The answer, which is there when [`Engine::advance_boundary`] has returned 1: of points their fractions, else the boundary.
    pub fn result(self) -> Result<JsValue, JsValue> {
        match self.work {
            Work::Evaluating(job) => Ok(Float64Array::from(job.numbers().as_slice()).into()),
            Work::Found(known) => boundary(&known),
            _ => Ok(JsValue::UNDEFINED),
        }
    }
}

/// A boundary as plain lists.
fn boundary(known: &BoundaryProblem) -> Result<JsValue, JsValue> {
    let bag = Object::new();
    let set = |name: &str, value: JsValue| Reflect::set(&bag, &name.into(), &value).map(|_| ());
    let dimension = known.space.dimension();
    let vertices: Vec<f64> =
        known.vertices.iter().flat_map(|vertex| vertex.to_array().into_iter().take(dimension)).collect();
    let elements: Vec<u32> =
        known.elements.iter().flat_map(|corners| corners.iter().copied().take(dimension)).collect();
    let list = |numbers: &[u32]| JsValue::from(Uint32Array::from(numbers));
    let names = known.conditions.iter().map(|condition| known.sets[condition.set].name.as_str());
    let measures: Vec<f64> = known.conditions.iter().map(|condition| condition.measure).collect();
    let sets: Vec<Set<'_>> = known
        .sets
        .iter()
        .map(|row| Set {
            name: &row.name,
            known: if row.is_value { "value" } else { "flux" },
            count: row.count,
            measure: row.measure,
        })
        .collect();
    let conditions = known.conditions.iter().map(|condition| {
        let object = Object::new();
        let data: Array = condition.data.iter().copied().map(JsValue::from).collect();
        let key = if condition.is_value { "value" } else { "flux" };
        Reflect::set(&object, &key.into(), &data).map(|_| JsValue::from(object))
    });
    set("dimension", dimension.into())?;
    set("vertices", Float64Array::from(vertices.as_slice()).into())?;
    set("elements", list(&elements))?;
    set("groups", list(&known.groups))?;
    set("conditions", conditions.collect::<Result<Array, JsValue>>()?.into())?;
    set("names", names.map(JsValue::from).collect::<Array>().into())?;
    set("measures", Float64Array::from(measures.as_slice()).into())?;
    set("members", list(&known.members))?;
    set("sets", value(&sets)?)?;
    set("composition", true.into())?;
    set("solver", value(&SolverSpec::from(known.document.options))?)?;
    set("exact", known.exact.as_ref().map_or(JsValue::NULL, |exact| exact.name().into()))?;
    set("ready", known.is_ready().into())?;
    let said: Vec<Said<'_>> = known.diagnostics.iter().map(|one| Said::new(one, known.space)).collect();
    set("diagnostics", value(&said)?)?;
    Ok(bag.into())
}

fn value<T: Serialize>(value: &T) -> Result<JsValue, JsValue> {
    value.serialize(&serde_wasm_bindgen::Serializer::new()).map_err(JsValue::from)
}

/// What a set of elements amounts to.
#[derive(Serialize)]
struct Set<'a> {
    name: &'a str,
    known: &'static str,
    count: usize,
    measure: f64,
}

/// A diagnostic.
#[derive(Serialize)]
struct Said<'a> {
    code: &'static str,
    remark: bool,
    path: &'a str,
    message: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    element: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    place: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    count: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    character: Option<usize>,
}

impl<'a> Said<'a> {
    fn new(one: &'a BoundaryDiagnostic, space: Space) -> Self {
        Self {
            code: one.code,
            remark: one.is_remark,
            path: &one.path,
            message: &one.message,
            element: one.element,
            place: one.place.map(|place| place.to_array()[..space.dimension()].to_vec()),
            count: one.count,
            character: one.character,
        }
    }
}
