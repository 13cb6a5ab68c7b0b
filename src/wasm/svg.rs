//! The picture as SVG.

use super::engine::Engine;
use crate::picture::to_svg;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

#[wasm_bindgen]
impl Engine {
    /// The picture as SVG, with a description for those who do not see it.
    pub fn svg(&mut self, text: &str, options: &str, description: &str) -> Result<String, JsValue> {
        let (solution, viewport, list) = self.picture(text, false, true, options)?;
        Ok(to_svg(&list, &viewport, &solution.model.document().title, description))
    }
}
