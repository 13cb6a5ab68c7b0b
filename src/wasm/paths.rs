//! The matched pair as paths.

use super::engine::Engine;
use super::error::to_js;
use super::json::parse;
use super::results::to_value;
use crate::document::{PathOptions, Solution, paths};
use crate::geom::Bounds;
use crate::morph::PathPair;
use serde::Serialize;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

#[derive(Serialize)]
struct PathsResult {
    from: String,
    to: String,
    commands: usize,
    closed: bool,
    error: f64,
    /// x, y, width and height with y down.
    #[serde(rename = "viewBox")]
    view_box: [f64; 4],
    /// Of each curve, of each command.
    fractions: [Vec<Vec<f64>>; 2],
}

#[wasm_bindgen]
impl Engine {
    /// The two curves as paths with the same commands; null without a complete matching.
    #[wasm_bindgen(js_name = morphPaths)]
    pub fn morph_paths(&mut self, text: &str, options: &str) -> Result<JsValue, JsValue> {
        let options =
            parse(options).and_then(|options| PathOptions::read(&options)).map_err(|e| to_js(&e))?;
        let solution = self.solve_pair(text, "morphPaths")?;
        let found = paths(&solution, &options).map_err(|e| to_js(&e))?;
        to_value(&found.map(|pair| result(&solution, &pair)))
    }
}

fn result(solution: &Solution, pair: &PathPair) -> PathsResult {
    let ([from, to], error) = pair.svg();
    let Bounds { min, max } = pair.bounds();
    let model = &solution.model;
    PathsResult {
        from,
        to,
        commands: pair.commands(),
        closed: pair.closed,
        error,
        view_box: [min.x, -max.y, max.x - min.x, max.y - min.y],
        fractions: [
            pair.middles.iter().map(|&(u, _)| model.composition(0, u).fractions().to_vec()).collect(),
            pair.middles.iter().map(|&(_, v)| model.composition(1, v).fractions().to_vec()).collect(),
        ],
    }
}
