//! Solids.

use super::engine::Engine;
use super::error::to_js;
use super::json::parse;
use super::results::{DiagnosticResult, to_value};
use crate::document::{Outcome, Solid, SolidOptions, SolidRemark, flat};
use crate::solid::{Facets, Group, Part, area, volume};
use glam::DVec3;
use js_sys::{Array, Float32Array, Object, Reflect, Uint8Array, Uint32Array};
use serde::Serialize;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

/// What is told in plain values; the arrays join it.
#[derive(Serialize)]
struct SolidResult {
    ok: bool,
    diagnostics: Vec<DiagnosticResult>,
    range: Option<(f64, f64)>,
    groups: Vec<GroupResult>,
    bounds: Option<BoundsResult>,
    watertight: bool,
    /// Of watertight meshes.
    volume: Option<f64>,
    area: f64,
    projection: Option<()>,
}

#[derive(Serialize)]
struct GroupResult {
    name: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    curve: Option<usize>,
    /// Into the indices.
    start: usize,
    count: usize,
}

#[derive(Serialize)]
struct BoundsResult {
    min: [f64; 3],
    max: [f64; 3],
}

#[wasm_bindgen]
impl Engine {
    /// The ruled surface in space with its caps.
    pub fn solid(&mut self, text: &str, options: &str) -> Result<JsValue, JsValue> {
        let solution = self.solve(text)?;
        if let Outcome::Refused(error) = &solution.outcome {
            return Err(to_js(error));
        }
        let options = parse(options)
            .and_then(|options| SolidOptions::read(&options, solution.model.materials().len()))
            .map_err(|e| to_js(&e))?;
        let solid = Solid::new(&solution, &options).map_err(|e| to_js(&e))?;
        let mut diagnostics: Vec<DiagnosticResult> =
            solution.diagnostics.iter().map(DiagnosticResult::from).collect();
        let remarks =
            solid.as_ref().map_or_else(|| flat(&solution).into_iter().collect(), |s| s.remarks.clone());
        diagnostics.extend(remarks.iter().map(DiagnosticResult::from));
        let is_whole = |solid: &Solid| solid.is_watertight || !options.caps || !solid.is_closed;
        let ok = solution.is_complete() && solid.as_ref().is_some_and(is_whole);
        result(ok, diagnostics, solid.as_ref())
    }
}

fn result(ok: bool, diagnostics: Vec<DiagnosticResult>, solid: Option<&Solid>) -> Result<JsValue, JsValue> {
    let mesh = solid.map(|solid| &solid.mesh);
    let facets = mesh.map(Facets::new).unwrap_or_default();
    let bounds = mesh.and_then(|mesh| mesh.bounds());
    let value = to_value(&SolidResult {
        ok,
        diagnostics,
        range: solid.and_then(|solid| solid.range),
        groups: mesh.map_or_else(Vec::new, |mesh| mesh.groups.iter().map(GroupResult::from).collect()),
        bounds: bounds.map(|(min, max)| BoundsResult { min: min.to_array(), max: max.to_array() }),
        watertight: solid.is_some_and(|solid| solid.is_watertight),
        volume: solid.filter(|solid| solid.is_watertight).map(|solid| volume(&solid.mesh)),
        area: mesh.map_or(0.0, area),
        projection: None,
    })?;
    let object = Object::from(value);
    let set = |name: &str, value: JsValue| Reflect::set(&object, &name.into(), &value).map(|_| ());
    let of = |vertex: &u32| *vertex as usize;
    let (mut positions, mut colors, mut fractions, mut scalars) = (Vec::new(), Vec::new(), Vec::new(), None);
    if let Some(Solid { mesh, colors: all, .. }) = solid {
        positions = facets.positions(mesh);
        colors =
            facets.vertices.iter().flat_map(|k| [all[of(k)].r, all[of(k)].g, all[of(k)].b, 255]).collect();
        fractions =
            facets.vertices.iter().flat_map(|k| mesh.fractions_at(of(k))).map(|&f| f as f32).collect();
        scalars = (!mesh.scalars.is_empty())
            .then(|| facets.vertices.iter().map(|k| mesh.scalars[of(k)] as f32).collect::<Vec<f32>>());
    }
    let normals: Vec<f32> = numbers(&facets.normals);
    set("positions", Float32Array::from(positions.as_slice()).into())?;
    set("normals", Float32Array::from(normals.as_slice()).into())?;
    set("colors", Uint8Array::from(colors.as_slice()).into())?;
    set("fractions", Float32Array::from(fractions.as_slice()).into())?;
    set("scalar", scalars.map_or(JsValue::NULL, |scalars| Float32Array::from(scalars.as_slice()).into()))?;
    set("indices", Uint32Array::from(facets.triangles.as_flattened()).into())?;
    let rulings: Vec<f32> = solid.map_or_else(Vec::new, |solid| numbers(solid.rulings.as_flattened()));
    set("rulings", Float32Array::from(rulings.as_slice()).into())?;
    set("stages", polylines(solid.map_or(&[], |solid| &solid.stages)))?;
    set("curves", polylines(solid.map_or(&[], |solid| &solid.curves)))?;
    Ok(object.into())
}

fn polylines(lines: &[Vec<DVec3>]) -> JsValue {
    lines.iter().map(|line| Float32Array::from(numbers(line).as_slice())).collect::<Array>().into()
}

fn numbers(points: &[DVec3]) -> Vec<f32> {
    points.iter().flat_map(|point| point.as_vec3().to_array()).collect()
}

impl From<&Group> for GroupResult {
    fn from(group: &Group) -> Self {
        let (name, curve) = match group.part {
            Part::Surface => ("surface", None),
            Part::Cap(curve) => ("cap", Some(curve)),
        };
        Self { name, curve, start: 3 * group.triangles.start, count: 3 * group.triangles.len() }
    }
}

impl From<&SolidRemark> for DiagnosticResult {
    fn from(remark: &SolidRemark) -> Self {
        let (curve, at) = match remark {
            SolidRemark::Uncapped { curve, at } => (Some(*curve), *at),
            SolidRemark::Flat { .. } | SolidRemark::OpenSheet | SolidRemark::Rounded => (None, None),
        };
        Self::remark(remark.code(), remark.to_string(), curve, at)
    }
}
