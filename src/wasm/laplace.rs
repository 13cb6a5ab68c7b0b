//! Laplace's equation: problems, solutions and questions about them, in steps.

use super::clock;
use super::engine::Engine;
use super::error::to_js;
use super::json::parse;
use crate::document::{LaplaceInput, LaplaceLists, read_frame};
use crate::laplace::{
    Convergence, Fault, LaplaceError, LaplaceJob, PointsJob, Quantity, SectionJob, Solution, Stage,
};
use glam::DVec3;
use js_sys::{Array, Float32Array, Float64Array, Object, Reflect, Uint32Array};
use std::rc::Rc;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

/// A problem being solved.
#[wasm_bindgen]
pub struct LaplaceSolving {
    job: Option<LaplaceJob>,
    solution: Option<Solution>,
    /// 2 or 3.
    dimension: usize,
    /// Milliseconds for the equations, and for solving them.
    times: [f64; 2],
}

/// A solved problem.
#[wasm_bindgen]
pub struct LaplaceSolved {
    solution: Rc<Solution>,
    times: [f64; 2],
}

/// A question under way.
#[wasm_bindgen]
pub struct LaplaceAsking(Work);

enum Work {
    Points(Box<PointsJob>),
    Section(Box<SectionJob<Rc<Solution>>>),
}

#[wasm_bindgen]
impl Engine {
    /// A problem to be solved in steps: options as JSON, coordinates of vertices, vertices of elements, 1 for each element whose values are given and 0 for
    /// fluxes, and these data, for each element one after the other.
    pub fn laplace(
        &self,
        options: &str,
        vertices: &[f64],
        elements: &[u32],
        is_value: &[u8],
        data: &[f64],
    ) -> Result<LaplaceSolving, JsValue> {
        let input = parse(options).and_then(|options| LaplaceInput::read(&options)).map_err(|e| to_js(&e))?;
        let clock = clock();
        let start = clock.now();
        let dimension = input.dimension;
        let problem = input.problem(LaplaceLists { vertices, elements, is_value, data });
        let job = problem.and_then(|problem| LaplaceJob::new(problem, input.options));
        let job = job.map_err(|error| fault(&error, dimension))?;
        Ok(LaplaceSolving { job: Some(job), solution: None, dimension, times: [clock.now() - start, 0.0] })
    }
}

#[wasm_bindgen]
impl LaplaceSolving {
    /// Goes on for about `budget` milliseconds; returns the share done, 1 when it is solved.
    pub fn step(&mut self, budget: f64) -> Result<f64, JsValue> {
        let clock = clock();
        let start = clock.now();
        let Some(job) = &mut self.job else { return Ok(1.0) };
        loop {
            let stage = job.stage();
            let began = clock.now();
            let found = job
                .step(&mut || clock.now() - start < budget)
                .map_err(|error| fault(&error, self.dimension))?;
            self.times[usize::from(stage == Stage::Solving)] += clock.now() - began;
            if found.is_some() {
                self.solution = found;
                self.job = None;
                return Ok(1.0);
            }
            if clock.now() - start >= budget {
                return Ok(job.progress());
            }
        }
    }

    /// The solution, once [`step`](Self::step) has returned 1.
    pub fn result(self) -> Option<LaplaceSolved> {
        self.solution.map(|solution| LaplaceSolved { solution: Rc::new(solution), times: self.times })
    }
}

#[wasm_bindgen]
impl LaplaceSolved {
    /// What is to be said about the solution, and values and fluxes on elements.
    pub fn summary(&self) -> Result<JsValue, JsValue> {
        let solution = &*self.solution;
        let problem = solution.problem();
        let dimension = problem.mesh().space().dimension();
        let bag = Object::new();
        set(&bag, "dimension", dimension.into())?;
        set(&bag, "elements", problem.mesh().elements().len().into())?;
        set(&bag, "materials", solution.materials().into())?;
        set(&bag, "converged", solution.convergences().iter().all(|found| found.is_converged).into())?;
        let iterations: Vec<u32> =
            solution.convergences().iter().map(|found| found.iterations() as u32).collect();
        set(&bag, "iterations", Uint32Array::from(iterations.as_slice()).into())?;
        let residuals = |list: fn(&Convergence) -> &Vec<f64>| -> JsValue {
            columns(solution.convergences().iter().map(list))
        };
        set(&bag, "residuals", residuals(|found| &found.residuals))?;
        set(&bag, "preconditionedResiduals", residuals(|found| &found.preconditioned))?;
        set(&bag, "condition", solution.condition().map_or(JsValue::NULL, JsValue::from))?;
        let times = Object::new();
        set(&times, "assembly", self.times[0].into())?;
        set(&times, "solve", self.times[1].into())?;
        set(&bag, "times", times.into())?;
        set(&bag, "values", columns(solution.values().iter()))?;
        set(&bag, "fluxes", columns(solution.fluxes().iter()))?;
        let enclosed = problem.enclosed();
        set(&bag, "parts", enclosed.parts.into())?;
        set(&bag, "measure", enclosed.measure.into())?;
        set(&bag, "closure", enclosed.closure.max(solution.row_closure()).into())?;
        let balance = solution.flux_balance();
        set(&bag, "fluxBalance", Float64Array::from(balance.as_slice()).into())?;
        set(&bag, "imbalance", problem.imbalance().into())?;
        let range = |range: Option<[f64; 2]>| -> JsValue {
            range.map_or(JsValue::NULL, |ends| ends.into_iter().map(JsValue::from).collect::<Array>().into())
        };
        set(&bag, "ranges", solution.ranges().into_iter().map(range).collect::<Array>().into())?;
        Ok(bag.into())
    }

    /// A question about points, one after the other: values, or gradients; those outside are refused or have no numbers.
    pub fn points(&self, points: &[f64], gradients: bool, refuses: bool) -> Result<LaplaceAsking, JsValue> {
        let dimension = self.dimension();
        let point =
            |numbers: &[f64]| DVec3::new(numbers[0], numbers[1], numbers.get(2).copied().unwrap_or(0.0));
        let points = points.chunks_exact(dimension).map(point).collect();
        let quantity = if gradients { Quantity::Gradients } else { Quantity::Values };
        let job = PointsJob::new(Rc::clone(&self.solution), points, quantity, refuses);
        Ok(LaplaceAsking(Work::Points(Box::new(job.map_err(|error| fault(&error, dimension))?))))
    }

    /// A section on pixels; `frame` is its `origin`, `sides` and `size` as JSON.
    pub fn section(&self, frame: &str) -> Result<LaplaceAsking, JsValue> {
        let frame =
            parse(frame).and_then(|frame| read_frame(&frame, &self.solution)).map_err(|e| to_js(&e))?;
        let job = SectionJob::new(Rc::clone(&self.solution), frame);
        Ok(LaplaceAsking(Work::Section(Box::new(job.map_err(|error| fault(&error, self.dimension()))?))))
    }

    fn dimension(&self) -> usize {
        self.solution.problem().mesh().space().dimension()
    }
}

#[wasm_bindgen]
impl LaplaceAsking {
    /// Goes on for about `budget` milliseconds; returns the share done.
    pub fn step(&mut self, budget: f64) -> Result<f64, JsValue> {
        let clock = clock();
        let start = clock.now();
        let mut may_go_on = || clock.now() - start < budget;
        let share = |is_done: bool, progress: f64| if is_done { 1.0 } else { progress.min(0.999) };
        match &mut self.0 {
            Work::Points(job) => {
                let is_done = job.step(&mut may_go_on).map_err(|error| fault(&error, job.dimension()))?;
                Ok(share(is_done, job.progress()))
            }
            Work::Section(job) => Ok(share(job.step(&mut may_go_on), job.progress())),
        }
    }

    /// The answer, once [`step`](Self::step) has returned 1.
    pub fn result(self) -> Result<JsValue, JsValue> {
        let bag = Object::new();
        match self.0 {
            Work::Points(job) => {
                let found = job.found();
                set(&bag, "values", Float64Array::from(found.numbers.as_slice()).into())?;
                set(&bag, "clamped", found.clamped.into())?;
                set(&bag, "outside", found.outside.into())?;
            }
            Work::Section(job) => {
                let section = job.section();
                let size = section.size.into_iter().map(JsValue::from).collect::<Array>();
                set(&bag, "size", size.into())?;
                let values = section.values.iter().map(|list| Float32Array::from(list.as_slice()));
                set(&bag, "values", values.collect::<Array>().into())?;
                set(&bag, "inside", section.inside.into())?;
                set(&bag, "clamped", section.clamped.into())?;
            }
        }
        Ok(bag.into())
    }
}

pub(super) fn set(bag: &Object, name: &str, value: JsValue) -> Result<(), JsValue> {
    Reflect::set(bag, &name.into(), &value).map(|_| ())
}

/// A list of arrays, one for each material.
fn columns<'a>(lists: impl Iterator<Item = &'a Vec<f64>>) -> JsValue {
    lists.map(|list| Float64Array::from(list.as_slice())).collect::<Array>().into()
}

/// An error with the code and the path of what it concerns, and its place.
pub(super) fn fault(error: &LaplaceError, dimension: usize) -> JsValue {
    let (code, list) = match error.fault {
        Fault::Vertices => ("range", "vertices"),
        Fault::Elements => ("range", "elements"),
        Fault::Degenerate | Fault::Open | Fault::Inverted | Fault::Apart | Fault::Meeting => {
            ("mesh", "elements")
        }
        Fault::Conditions | Fault::Imbalance | Fault::Sum => ("range", "conditions"),
        Fault::Limit => ("limit", "elements"),
        Fault::Method => ("range", "solver"),
        Fault::Points => ("range", "points"),
        Fault::Section => ("range", "size"),
        Fault::Sides => ("range", "sides"),
        Fault::Outside => ("outside", "points"),
    };
    let path = error.index.map_or_else(|| list.to_owned(), |index| format!("{list}[{index}]"));
    let object = js_sys::Error::new(&error.message);
    let place =
        error.at.map(|at| at.to_array().into_iter().take(dimension).map(JsValue::from).collect::<Array>());
    for (key, value) in [
        ("code", code.into()),
        ("path", path.into()),
        ("place", place.map_or(JsValue::UNDEFINED, JsValue::from)),
    ] {
        // Setting a field of a new object fails only when the object is frozen, which it is not.
        let _ = Reflect::set(&object, &key.into(), &value);
    }
    object.into()
}
