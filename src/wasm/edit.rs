//! Changes of a document that keep its shape.

use super::engine::{Engine, read};
use super::error::to_js;
use super::results::to_value;
use crate::document::insert_point;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

#[wasm_bindgen]
impl Engine {
    /// The document with one more control point on a curve, which keeps its shape.
    #[wasm_bindgen(js_name = insertPoint)]
    pub fn insert_point(&self, text: &str, curve: usize, u: f64) -> Result<JsValue, JsValue> {
        let document = read(text).and_then(|document| insert_point(document, curve, u));
        to_value(&document.map_err(|e| to_js(&e))?)
    }
}
