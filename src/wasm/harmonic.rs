//! The harmonic blend of nested curves.

use super::clock;
use super::diagnostic::DiagnosticResult;
use super::engine::Engine;
use super::error::to_js;
use super::json::parse;
use super::laplace::set;
use super::probe::ProbeResult;
use super::results::{StageResult, arrays, to_value};
use crate::document::{
    Code, CurvesDocument, Difference, DocumentError, Harmonic, LayerName, Model, Outcome, Solution,
};
use crate::morph::HarmonicBlend;
use crate::picture::PictureOptions;
use glam::DVec2;
use js_sys::{Array, Float64Array, Object, Uint32Array};
use serde::Serialize;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

#[wasm_bindgen]
impl Engine {
    /// The harmonic blend of a document of that kind, with the comparison where `step` of it or of [`compare`](Self::compare) made one.
    pub fn harmonic(&mut self, text: &str, coarse: bool, difference: bool) -> Result<JsValue, JsValue> {
        if difference {
            self.advance_comparison(text, coarse, &mut || true).map_err(|e| to_js(&e))?;
        }
        let solution = self.solve_to(text, coarse)?;
        if !solution.model.document().is_harmonic() {
            let message = "another kind was found; expected `harmonic`";
            return Err(to_js(&DocumentError::new(Code::Range, "blend.kind", message)));
        }
        if let Outcome::Refused(error) = &solution.outcome {
            return Err(to_js(error));
        }
        result(&solution, difference)
    }

    /// Goes on comparing a harmonic blend of two curves with the ruled one for about `budget` milliseconds; returns the share done.
    pub fn compare(&mut self, text: &str, coarse: bool, budget: f64) -> Result<f64, JsValue> {
        let clock = clock();
        let start = clock.now();
        let mut may_go_on = || clock.now() - start < budget;
        self.advance_comparison(text, coarse, &mut may_go_on).map_err(|e| to_js(&e))
    }

    /// Whether a picture of a document with these options shows the difference of two blends.
    #[wasm_bindgen(js_name = showsDifference)]
    pub fn shows_difference(&mut self, text: &str, coarse: bool, options: &str) -> Result<bool, JsValue> {
        let options =
            parse(options).and_then(|options| PictureOptions::read(&options)).map_err(|e| to_js(&e))?;
        let solution = self.solve_to(text, coarse)?;
        Ok(solution.harmonic().is_some()
            && options.figure(&solution.model).layers.contains(&LayerName::Difference))
    }
}

/// What is to be said of a harmonic blend in numbers.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct HarmonicSummary {
    /// Number of the outer curve.
    outer: usize,
    /// Segments of all curves.
    segments: usize,
    /// Lines along the gradient, pairs of them that meet, and lines that were lost.
    lines: usize,
    crossings: usize,
    lost: usize,
    /// Most iterations for a quantity, and the largest residual over the right-hand side.
    iterations: usize,
    residual: f64,
    /// What flows from the outer curve to the others, and the share of it that is missing on one side.
    flux: f64,
    flux_balance: f64,
    /// Area between the curves, and how much of each material is there.
    area: f64,
    amounts: Vec<f64>,
    /// Vertices and triangles on which the blend is shown.
    vertices: usize,
    triangles: usize,
}

impl HarmonicSummary {
    pub(super) fn new(blend: &HarmonicBlend) -> Self {
        let solution = blend.solution();
        let found = || solution.convergences().iter();
        let last = found().filter_map(|own| own.residuals.last().copied());
        Self {
            outer: blend.rings().outer(),
            segments: blend.rings().count(),
            lines: blend.lines().len(),
            crossings: blend.crossings(),
            lost: blend.lost(),
            iterations: found().map(|own| own.iterations()).max().unwrap_or(0),
            residual: last.fold(0.0, f64::max),
            flux: blend.flux(),
            flux_balance: solution.flux_balance().first().map_or(0.0, |balance| balance.abs()),
            area: blend.area(),
            amounts: blend.amounts(),
            vertices: blend.field().points.len(),
            triangles: blend.field().triangles.len(),
        }
    }
}

/// The level curves of a harmonic blend, each of them with the place of its stage.
pub(super) fn levels(harmonic: &Harmonic, document: &CurvesDocument) -> Vec<StageResult> {
    let segments = document.segments();
    let stage = |(j, loops): (usize, &Vec<Vec<DVec2>>)| {
        let s = (j + 1) as f64 / segments as f64;
        loops.iter().map(|points| StageResult { s, points: arrays(points) }).collect::<Vec<_>>()
    };
    harmonic.blend.levels().iter().enumerate().flat_map(stage).collect()
}

fn result(solution: &Solution, difference: bool) -> Result<JsValue, JsValue> {
    let bag = Object::new();
    let mut diagnostics: Vec<DiagnosticResult> =
        solution.diagnostics.iter().map(DiagnosticResult::from).collect();
    let harmonic = solution.harmonic();
    let compared = harmonic.and_then(|harmonic| harmonic.difference.as_ref()).filter(|_| difference);
    diagnostics.extend(compared.and_then(Difference::remark).as_ref().map(DiagnosticResult::from));
    set(&bag, "ok", solution.is_complete().into())?;
    set(&bag, "diagnostics", to_value(&diagnostics)?)?;
    set(&bag, "coarse", solution.is_coarse.into())?;
    let whole = harmonic.map(|Harmonic { blend, .. }| blend);
    set(&bag, "outer", whole.map_or(JsValue::NULL, |blend| blend.rings().outer().into()))?;
    let segments = solution.model.document().segments();
    let levels = Array::new();
    for (j, loops) in whole.map_or(&[][..], HarmonicBlend::levels).iter().enumerate() {
        let level = Object::new();
        set(&level, "value", ((j + 1) as f64 / segments as f64).into())?;
        set(&level, "loops", loops.iter().map(|points| flat(points)).collect::<Array>().into())?;
        levels.push(&level);
    }
    set(&bag, "levels", levels.into())?;
    let lines = whole.map_or(&[][..], HarmonicBlend::lines);
    set(&bag, "lines", lines.iter().map(|line| flat(&line.points)).collect::<Array>().into())?;
    let curves: Vec<u32> = lines.iter().map(|line| line.curve as u32).collect();
    set(&bag, "lineCurves", Uint32Array::from(curves.as_slice()).into())?;
    let ends: Vec<f64> = lines.iter().flat_map(|line| [line.u, line.v]).collect();
    set(&bag, "lineParameters", Float64Array::from(ends.as_slice()).into())?;
    set(&bag, "summary", whole.map_or(Ok(JsValue::NULL), |blend| to_value(&HarmonicSummary::new(blend)))?)?;
    let found = compared.filter(|found| !found.values.is_empty()).map(|found| -> Result<JsValue, JsValue> {
        let bag = Object::new();
        set(&bag, "largest", found.largest.into())?;
        set(&bag, "mean", found.mean.into())?;
        set(&bag, "at", [found.at.x, found.at.y].into_iter().map(JsValue::from).collect::<Array>().into())?;
        Ok(bag.into())
    });
    set(&bag, "difference", found.transpose()?.unwrap_or(JsValue::NULL))?;
    Ok(bag.into())
}

/// x and y of each point.
fn flat(points: &[DVec2]) -> JsValue {
    let numbers: Vec<f64> = points.iter().flat_map(|point| point.to_array()).collect();
    Float64Array::from(numbers.as_slice()).into()
}

/// What a harmonic blend holds at a point, and the nearest line along the gradient.
pub(super) fn probe(model: &Model, harmonic: &Harmonic, at: DVec2) -> Option<ProbeResult> {
    let place = harmonic.blend.locate(at)?;
    let distance = |line: &[DVec2]| {
        let of = |pair: &[DVec2]| {
            let along = pair[1] - pair[0];
            let t = ((at - pair[0]).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            (pair[0] + t * along).distance_squared(at)
        };
        line.windows(2).map(of).fold(f64::INFINITY, f64::min)
    };
    let lines = harmonic.blend.lines();
    let distances = lines.iter().map(|line| distance(&line.points));
    let (line, _) = distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1))?;
    let nearest = &lines[line];
    let (first, last) = (nearest.points.first()?, nearest.points.last()?);
    let outer = harmonic.blend.rings().outer();
    let normals = [(nearest.curve, nearest.u), (outer, nearest.v)].map(|(k, u)| model.curves()[k].normal(u));
    Some(ProbeResult {
        span: None,
        line,
        s: place.potential,
        u: nearest.u,
        v: nearest.v,
        at: at.to_array(),
        fractions: place.composition.fractions().to_vec(),
        value: place.gradient.length(),
        cosine: normals[0].dot(normals[1]),
        length: nearest.points.windows(2).map(|pair| pair[0].distance(pair[1])).sum(),
        from: first.to_array(),
        to: last.to_array(),
        gradient: Some(place.gradient.to_array()),
    })
}
