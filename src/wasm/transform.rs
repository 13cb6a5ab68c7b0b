//! Distance transforms, in steps.

use super::clock;
use super::engine::Engine;
use super::error::to_js;
use super::json::parse;
use crate::document::{DocumentError, TransformOptions};
use crate::field::transform::DistanceJob;
use js_sys::Float32Array;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

/// A transform under way.
#[wasm_bindgen]
pub struct Transforming(DistanceJob);

#[wasm_bindgen]
impl Engine {
    /// Distances to the voxels that are not 0, to be found in steps; `options` are `size`, `spacing` and `limit` as JSON.
    pub fn transform(&self, options: &str, features: &[u8]) -> Result<Transforming, JsValue> {
        let start = |options: TransformOptions| options.start(features).map(Transforming);
        parse(options)
            .and_then(|options| TransformOptions::read(&options))
            .and_then(start)
            .map_err(|e: DocumentError| to_js(&e))
    }
}

#[wasm_bindgen]
impl Transforming {
    /// Goes on for about `budget` milliseconds; returns the share done.
    pub fn step(&mut self, budget: f64) -> f64 {
        let clock = clock();
        let start = clock.now();
        self.0.step(&mut || clock.now() - start < budget);
        self.0.progress()
    }

    /// The distances, once [`step`](Self::step) has returned 1.
    pub fn result(self) -> Float32Array {
        Float32Array::from(self.0.distances().as_slice())
    }
}
