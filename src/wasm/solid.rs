//! Solids, and files of them, in steps.

use super::clock;
use super::diagnostic::DiagnosticResult;
use super::engine::Engine;
use super::error::to_js;
use super::json::parse;
use super::results::{ProjectionResult, to_value};
use crate::document::{
    DocumentError, Outcome, Solid, SolidJob, SolidOptions, SolidRemark, Solution, flat, why_no_solid,
};
use crate::solid::{Facets, FileJob, Format, Group, Part};
use glam::DVec3;
use js_sys::{Array, Float32Array, Object, Reflect, Uint8Array, Uint32Array};
use serde::Serialize;
use std::rc::Rc;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

/// A solid under way.
#[wasm_bindgen]
pub struct Modelling {
    solution: Rc<Solution>,
    work: Work,
    /// Of a file; else the mesh is wanted as it is drawn.
    format: Option<Format>,
}

enum Work {
    Building(Box<SolidJob>),
    Shading(Box<Solid>),
    Drawing(Box<Solid>, Facets),
    Drawn(Box<Solid>, Box<Drawn>),
    Writing(FileJob),
    Written(Vec<u8>),
    /// There is no solid.
    Nothing,
}

/// What is told in plain values; the arrays join it.
#[derive(Serialize, Default)]
struct SolidResult {
    ok: bool,
    diagnostics: Vec<DiagnosticResult>,
    range: Option<(f64, f64)>,
    groups: Vec<GroupResult>,
    bounds: Option<BoundsResult>,
    watertight: bool,
    volume: Option<f64>,
    area: f64,
    projection: Option<ProjectionResult>,
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
    /// The ruled surface in space with its caps, to be built in steps.
    pub fn solid(&mut self, text: &str, options: &str) -> Result<Modelling, JsValue> {
        self.modelling(text, |materials| {
            parse(options).and_then(|options| Ok((None, SolidOptions::read(&options, materials)?)))
        })
    }

    /// A file of the ruled surface with its caps, to be written in steps.
    #[wasm_bindgen(js_name = solidFile)]
    pub fn solid_file(&mut self, text: &str, options: &str) -> Result<Modelling, JsValue> {
        let modelling = self.modelling(text, |materials| {
            let (format, options) = SolidOptions::read_file(&parse(options)?, materials)?;
            Ok((Some(format), options))
        })?;
        match modelling.work {
            Work::Nothing => Err(to_js(&why_no_solid(&modelling.solution))),
            _ => Ok(modelling),
        }
    }
}

impl Engine {
    fn modelling(
        &mut self,
        text: &str,
        read: impl FnOnce(usize) -> Result<(Option<Format>, SolidOptions), DocumentError>,
    ) -> Result<Modelling, JsValue> {
        let solution = self.solve(text)?;
        if let Outcome::Refused(error) = &solution.outcome {
            return Err(to_js(error));
        }
        let start = || {
            let (format, options) = read(solution.model.materials().len())?;
            let job = SolidJob::new(Rc::clone(&solution), options)?;
            Ok((format, job.map_or(Work::Nothing, |job| Work::Building(Box::new(job)))))
        };
        let (format, work) = start().map_err(|error| to_js(&error))?;
        Ok(Modelling { solution, work, format })
    }
}

#[wasm_bindgen]
impl Modelling {
    /// Goes on for about `budget` milliseconds; returns the share done, 1 when all is.
    pub fn step(&mut self, budget: f64) -> f64 {
        let clock = clock();
        let start = clock.now();
        let mut may_go_on = || clock.now() - start < budget;
        loop {
            self.work = match std::mem::replace(&mut self.work, Work::Nothing) {
                Work::Building(mut job) => match (job.step(&mut may_go_on), self.format) {
                    (None, _) => Work::Building(job),
                    (Some(solid), None) => Work::Shading(Box::new(solid)),
                    (Some(solid), Some(format)) => Work::Writing(solid.into_file(format, &self.solution)),
                },
                Work::Shading(solid) => {
                    let facets = Facets::new(&solid.mesh);
                    Work::Drawing(solid, facets)
                }
                Work::Drawing(solid, facets) => {
                    let drawn = Drawn::new(&solid, facets);
                    Work::Drawn(solid, Box::new(drawn))
                }
                Work::Writing(mut job) => match job.step(&mut may_go_on) {
                    None => Work::Writing(job),
                    Some(bytes) => Work::Written(bytes),
                },
                done => {
                    self.work = done;
                    return 1.0;
                }
            };
            if !may_go_on() {
                return self.progress();
            }
        }
    }

    /// The solid, or the file, which is complete when `step` has returned 1.
    pub fn result(self) -> Result<JsValue, JsValue> {
        if let Work::Written(bytes) = &self.work {
            return Ok(Uint8Array::from(bytes.as_slice()).into());
        }
        let blank = Drawn::default();
        let (solid, drawn) = match &self.work {
            Work::Drawn(solid, drawn) => (Some(solid.as_ref()), drawn.as_ref()),
            _ => (None, &blank),
        };
        let object = Object::from(to_value(&self.plain(solid))?);
        let set = |name: &str, value: JsValue| Reflect::set(&object, &name.into(), &value).map(|_| ());
        set("positions", Float32Array::from(drawn.positions.as_slice()).into())?;
        set("normals", Float32Array::from(drawn.normals.as_slice()).into())?;
        set("colors", Uint8Array::from(drawn.colors.as_slice()).into())?;
        set("fractions", Float32Array::from(drawn.fractions.as_slice()).into())?;
        let scalars = drawn.scalars.as_deref();
        set("scalar", scalars.map_or(JsValue::NULL, |scalars| Float32Array::from(scalars).into()))?;
        set("indices", Uint32Array::from(drawn.triangles.as_flattened()).into())?;
        let rulings = solid.map_or_else(Vec::new, |solid| numbers(solid.rulings.as_flattened()));
        set("rulings", Float32Array::from(rulings.as_slice()).into())?;
        set("stages", polylines(solid.map_or(&[], |solid| &solid.stages)))?;
        set("curves", polylines(solid.map_or(&[], |solid| &solid.curves)))?;
        Ok(object.into())
    }
}

impl Modelling {
    /// Share of the work that is done, below 1 until `step` finds nothing left to do: what is handed over takes a turn of its own.
    fn progress(&self) -> f64 {
        match &self.work {
            Work::Building(job) => 0.6 * job.progress(),
            Work::Shading(_) => 0.6,
            Work::Drawing(..) => 0.8,
            Work::Writing(job) => 0.6 + 0.39 * job.progress(),
            Work::Drawn(..) | Work::Written(_) | Work::Nothing => 0.99,
        }
    }

    fn plain(&self, solid: Option<&Solid>) -> SolidResult {
        let remarks = solid.map_or_else(|| flat(&self.solution).into_iter().collect(), |s| s.remarks.clone());
        let diagnostics = self.solution.diagnostics.iter().map(DiagnosticResult::from);
        let diagnostics = diagnostics.chain(remarks.iter().map(DiagnosticResult::from)).collect();
        let Some(solid) = solid else {
            return SolidResult { diagnostics, ..SolidResult::default() };
        };
        let mesh = &solid.mesh;
        SolidResult {
            ok: self.solution.is_complete() && solid.is_whole(),
            diagnostics,
            range: solid.range,
            groups: mesh.groups.iter().map(GroupResult::from).collect(),
            bounds: mesh.bounds().map(|(min, max)| BoundsResult { min: min.to_array(), max: max.to_array() }),
            watertight: solid.is_watertight,
            volume: solid.volume,
            area: solid.area,
            projection: ProjectionResult::of(&self.solution.model),
        }
    }
}

/// The vertices as they are drawn.
#[derive(Default)]
struct Drawn {
    positions: Vec<f32>,
    normals: Vec<f32>,
    colors: Vec<u8>,
    fractions: Vec<f32>,
    scalars: Option<Vec<f32>>,
    triangles: Vec<[u32; 3]>,
}

impl Drawn {
    fn new(Solid { mesh, colors, .. }: &Solid, facets: Facets) -> Self {
        let vertices = || facets.vertices.iter().map(|&vertex| vertex as usize);
        let color = |vertex: usize| [colors[vertex].r, colors[vertex].g, colors[vertex].b, u8::MAX];
        let has_scalars = !mesh.scalars.is_empty();
        Self {
            positions: facets.positions(mesh),
            normals: numbers(&facets.normals),
            colors: vertices().flat_map(color).collect(),
            fractions: vertices().flat_map(|k| mesh.fractions_at(k)).map(|&part| part as f32).collect(),
            scalars: has_scalars.then(|| vertices().map(|k| mesh.scalars[k] as f32).collect()),
            triangles: facets.triangles,
        }
    }
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
