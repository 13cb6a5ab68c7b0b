//! The functions of the module.

use super::clock;
use super::error::to_js;
use super::growth::{sets, steps};
use super::json::parse;
use super::painting::Painting;
use super::probe::probe;
use super::results::{MatchResult, ViewResult, isolines, stages, to_value};
use crate::document::{self, Code, CurvesDocument, DocumentError, IsoOptions, Memory, Solution, Solve};
use crate::picture::{self, DisplayList, PictureOptions, Viewport, figure};
use glam::DVec2;
use std::rc::Rc;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

/// Most rulings between two lines that stages are asked for.
const MOST_REFINED: usize = 64;

/// Answers questions about documents; remembers the last ones solved, so that asking twice costs once.
#[wasm_bindgen]
#[derive(Default)]
pub struct Engine {
    solved: Memory,
    /// The document being solved, and whether coarsely.
    job: Option<(String, bool, Solve)>,
    #[cfg(feature = "hyperpatch")]
    pub(super) bodies: crate::document::BodyMemory,
    #[cfg(feature = "part")]
    pub(super) parts: crate::document::PartMemory,
    #[cfg(feature = "laplace")]
    pub(super) boundaries: crate::document::BoundaryMemory,
    /// The document whose harmonic blend is being compared, and whether coarsely.
    #[cfg(feature = "harmonic")]
    comparing: Option<(String, bool, document::Comparing)>,
}

#[wasm_bindgen]
impl Engine {
    /// An engine that has solved nothing.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Goes on solving a document for about `budget` milliseconds; returns the share done, 1 when it is solved. `coarse` leaves out the
    /// refinement on the curves, here and below, unless it has been done.
    pub fn step(&mut self, text: &str, coarse: bool, budget: f64) -> Result<f64, JsValue> {
        let clock = clock();
        let start = clock.now();
        self.advance(text, coarse, &mut || clock.now() - start < budget).map_err(|e| to_js(&e))
    }

    /// The matching of a document.
    #[wasm_bindgen(js_name = match)]
    pub fn matching(&mut self, text: &str, coarse: bool) -> Result<JsValue, JsValue> {
        let solution = self.solve_to(text, coarse)?;
        to_value(&MatchResult::new(&solution).map_err(|e| to_js(&e))?)
    }

    /// In-between curves, with `refine` points from each ruling line to the next.
    pub fn stages(&mut self, text: &str, refine: usize) -> Result<JsValue, JsValue> {
        if !(1..=MOST_REFINED).contains(&refine) {
            let message = format!("{refine} was found; expected 1 to {MOST_REFINED}");
            return Err(to_js(&DocumentError::new(Code::Range, "options.refine", message)));
        }
        let solution = self.solve(text)?;
        #[cfg(feature = "harmonic")]
        if let Some(harmonic) = solution.harmonic() {
            return to_value(&super::harmonic::levels(harmonic, solution.model.document()));
        }
        #[cfg(feature = "stack")]
        if let Some(stack) = solution.stack() {
            return to_value(&super::stack::stages(&solution, stack, refine));
        }
        let document = solution.model.document();
        to_value(&solution.band_with(refine).map_or_else(Vec::new, |band| stages(&band, document)))
    }

    /// Lines of equal fraction of a material.
    pub fn isolines(&mut self, text: &str, options: &str) -> Result<JsValue, JsValue> {
        let solution = self.solve(text)?;
        let options = parse(options)
            .and_then(|options| IsoOptions::read(&options, solution.model.materials().len()))
            .map_err(|e| to_js(&e))?;
        #[cfg(feature = "harmonic")]
        if let Some(harmonic) = solution.harmonic() {
            let lines = |material, level| harmonic.blend.iso_lines(material, level);
            return to_value(&isolines(lines, &options));
        }
        #[cfg(feature = "stack")]
        if let Some(stack) = solution.stack() {
            let blend = stack.blend.as_ref();
            let lines = blend.map(|it| isolines(|material, level| it.iso_lines(material, level), &options));
            return to_value(&lines);
        }
        let lines = solution.band();
        to_value(&lines.map(|band| isolines(|material, level| band.iso_lines(material, level), &options)))
    }

    /// What the band holds at a point.
    pub fn probe(&mut self, text: &str, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let solution = self.solve(text)?;
        #[cfg(feature = "harmonic")]
        if let Some(harmonic) = solution.harmonic() {
            return to_value(&super::harmonic::probe(&solution.model, harmonic, DVec2::new(x, y)));
        }
        to_value(&probe(&solution, DVec2::new(x, y)))
    }

    /// The steps of the greedy construction, of a document with that method: lists of numbers, which `js/steps.js` names.
    pub fn steps(&mut self, text: &str) -> Result<JsValue, JsValue> {
        to_value(&steps(&*self.solve_pair(text, "steps")?))
    }

    /// What a vertex of a curve, 0 or 1, sees and may have after so many accepted lines, as lists of numbers.
    pub fn sets(&mut self, text: &str, step: usize, curve: usize, vertex: usize) -> Result<JsValue, JsValue> {
        let solution = self.solve_pair(text, "sets")?;
        to_value(&sets(&solution, step, curve, vertex).map_err(|e| to_js(&e))?)
    }

    /// The picture, to be painted in steps.
    pub fn painting(&mut self, text: &str, coarse: bool, options: &str) -> Result<Painting, JsValue> {
        let (_, viewport, list) = self.picture(text, coarse, false, options)?;
        let strips = picture::Painting::new(&list, &viewport).map_err(|e| refused_picture(&e.to_string()))?;
        Ok(Painting::new(strips, viewport))
    }

    /// The view that shows all of a document in a picture.
    pub fn fit(&mut self, text: &str, options: &str) -> Result<JsValue, JsValue> {
        let options =
            parse(options).and_then(|options| PictureOptions::read(&options)).map_err(|e| to_js(&e))?;
        let document = read(text).map_err(|e| to_js(&e))?;
        let model = document::Model::new(document).map_err(|e| to_js(&e))?;
        to_value(&ViewResult::from(options.fit(&model)))
    }

    /// The document with all defaults spelt out.
    pub fn defaults(&self, text: &str) -> Result<JsValue, JsValue> {
        to_value(&read(text).map_err(|e| to_js(&e))?)
    }
}

impl Engine {
    /// What a picture shows; `light` where the number of its triangles decides the size of a file.
    pub(super) fn picture(
        &mut self,
        text: &str,
        coarse: bool,
        light: bool,
        options: &str,
    ) -> Result<(Rc<Solution>, Viewport, DisplayList), JsValue> {
        let options =
            parse(options).and_then(|options| PictureOptions::read(&options)).map_err(|e| to_js(&e))?;
        let solution = self.solve_to(text, coarse)?;
        #[cfg(feature = "harmonic")]
        let solution = if solution.harmonic().is_some()
            && options.figure(&solution.model).layers.contains(&document::LayerName::Difference)
        {
            self.advance_comparison(text, coarse, &mut || true).map_err(|e| to_js(&e))?;
            self.solve_to(text, coarse)?
        } else {
            solution
        };
        options.check(&solution.model).map_err(|e| to_js(&e))?;
        #[cfg(feature = "harmonic")]
        let solution =
            if light { document::lightened(&solution).map_or(solution, Rc::new) } else { solution };
        #[cfg(not(feature = "harmonic"))]
        let _ = light;
        let viewport = options.viewport(&solution.model);
        let list = figure(&solution, &options.figure(&solution.model), &viewport);
        Ok((solution, viewport, list))
    }

    pub(super) fn solve(&mut self, text: &str) -> Result<Rc<Solution>, JsValue> {
        self.solve_to(text, false)
    }

    /// The solution of a document of at most two curves, for a function that takes no more.
    pub(super) fn solve_pair(&mut self, text: &str, name: &str) -> Result<Rc<Solution>, JsValue> {
        let solution = self.solve(text)?;
        #[cfg(not(feature = "stack"))]
        let _ = name;
        #[cfg(feature = "harmonic")]
        needs_lines(&solution, name)?;
        #[cfg(feature = "stack")]
        if let count @ 3.. = solution.model.curves().len() {
            let message =
                format!("{count} curves were found; `{name}` takes 2, such as `span` gives of a stack");
            return Err(to_js(&DocumentError::new(Code::Range, "curves", message)));
        }
        Ok(solution)
    }

    pub(super) fn solve_to(&mut self, text: &str, coarse: bool) -> Result<Rc<Solution>, JsValue> {
        loop {
            if let Some(solution) = self.solved.find(text, coarse) {
                return Ok(solution);
            }
            self.advance(text, coarse, &mut || true).map_err(|e| to_js(&e))?;
        }
    }

    fn advance(
        &mut self,
        text: &str,
        coarse: bool,
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> Result<f64, DocumentError> {
        if self.solved.find(text, coarse).is_some() {
            return Ok(1.0);
        }
        let mut job = match self.job.take() {
            Some((known, is_coarse, job)) if known == text && is_coarse == coarse => job,
            _ if coarse => Solve::coarse(read(text)?)?,
            _ => Solve::new(read(text)?)?,
        };
        let Some(solution) = job.step(may_go_on) else {
            let progress = job.progress().min(0.999);
            self.job = Some((text.to_owned(), coarse, job));
            return Ok(progress);
        };
        self.solved.keep(text, solution);
        Ok(1.0)
    }
}

#[cfg(feature = "harmonic")]
impl Engine {
    /// Goes on comparing the harmonic blend of a document with the ruled one; of other documents, and of more than two curves, there is nothing to compare.
    pub(super) fn advance_comparison(
        &mut self,
        text: &str,
        coarse: bool,
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> Result<f64, DocumentError> {
        let solution = loop {
            match self.solved.find(text, coarse) {
                Some(solution) => break solution,
                None => {
                    if self.advance(text, coarse, may_go_on)? < 1.0 {
                        return Ok(0.0);
                    }
                }
            }
        };
        let Some(harmonic) = solution.harmonic() else { return Ok(1.0) };
        let count = solution.model.curves().len();
        if harmonic.difference.is_some() || count > 2 {
            return Ok(1.0);
        }
        let mut job = match self.comparing.take() {
            Some((known, is_coarse, job)) if known == text && is_coarse == coarse => job,
            _ => document::Comparing::new(solution.model.document(), coarse)?,
        };
        let Some(difference) = job.step(&harmonic.blend, may_go_on) else {
            let progress = job.progress(&harmonic.blend);
            self.comparing = Some((text.to_owned(), coarse, job));
            return Ok(progress);
        };
        let mut compared = Rc::unwrap_or_clone(solution);
        if let document::Outcome::Harmonic(harmonic) = &mut compared.outcome {
            harmonic.difference = Some(difference);
        }
        self.solved.keep(text, compared);
        Ok(1.0)
    }
}

pub(super) fn read(text: &str) -> Result<CurvesDocument, DocumentError> {
    document::check_length(text)?;
    document::read(&parse(text)?)
}

/// Refuses a harmonic blend for a function about ruling lines.
#[cfg(feature = "harmonic")]
pub(super) fn needs_lines(solution: &Solution, name: &str) -> Result<(), JsValue> {
    if !solution.model.document().is_harmonic() {
        return Ok(());
    }
    let message = format!("`harmonic` was found; `{name}` takes a blend along ruling lines");
    Err(to_js(&DocumentError::new(Code::Range, "blend.kind", message)))
}

fn refused_picture(message: &str) -> JsValue {
    to_js(&DocumentError::new(Code::Range, "options", message))
}
