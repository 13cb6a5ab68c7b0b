//! Distance transforms, in steps.

use super::clock;
use super::engine::Engine;
use super::error::to_js;
use super::json::parse;
use crate::document::{DocumentError, TransformOptions};
use crate::field::transform::{ColumnTrace, DistanceJob, Search};
use js_sys::{Float32Array, Object, Reflect};
use serde::Serialize;
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

    /// The transform in the plane as it can be watched, from the same options and features.
    #[wasm_bindgen(js_name = transformSteps)]
    pub fn transform_steps(&self, options: &str, features: &[u8]) -> Result<JsValue, JsValue> {
        let found = parse(options)
            .and_then(|options| TransformOptions::read(&options))
            .and_then(|options| options.trace(features))
            .map_err(|error| to_js(&error))?;
        let bag = Object::new();
        let set = |name: &str, value: &JsValue| Reflect::set(&bag, &name.into(), value);
        set("rows", &Float32Array::from(found.rows.as_slice()).into())?;
        set("levels", &Float32Array::from(found.levels.as_slice()).into())?;
        let columns: Vec<Column> = found.columns.iter().map(Column::new).collect();
        set("columns", &serde_wasm_bindgen::to_value(&columns)?)?;
        Ok(bag.into())
    }
}

/// What happens in a column.
#[derive(Serialize)]
struct Column<'a> {
    corners: &'a [usize],
    searches: Vec<Row>,
}

/// A search along a column.
#[derive(Serialize)]
struct Row {
    from: usize,
    forward: bool,
    reach: usize,
    count: usize,
}

impl<'a> Column<'a> {
    fn new(column: &'a ColumnTrace) -> Self {
        let row = |search: &Search| Row {
            from: search.from,
            forward: search.is_forward,
            reach: search.reach,
            count: search.count,
        };
        Self { corners: &column.corners, searches: column.searches.iter().map(row).collect() }
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
