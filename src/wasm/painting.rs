//! A picture under way.

use super::clock;
use super::results::{ViewResult, to_value};
use crate::picture::{self, Viewport};
use js_sys::{Object, Reflect, Uint8ClampedArray};
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

/// Paints a picture in steps, straight into an array of the host: the module never holds more than a strip of it.
#[wasm_bindgen]
pub struct Painting {
    strips: picture::Painting,
    viewport: Viewport,
    data: Uint8ClampedArray,
    /// Bytes painted.
    filled: u32,
}

#[wasm_bindgen]
impl Painting {
    /// Goes on painting for about `budget` milliseconds, one strip at least; returns the share done, 1 when all is painted.
    pub fn step(&mut self, budget: f64) -> f64 {
        let clock = clock();
        let start = clock.now();
        for strip in self.strips.by_ref() {
            let end = self.filled + strip.len() as u32;
            self.data.subarray(self.filled, end).copy_from(&strip);
            self.filled = end;
            if clock.now() - start >= budget {
                break;
            }
        }
        self.strips.progress()
    }

    /// The picture, which is complete when `step` has returned 1.
    pub fn picture(self) -> Result<JsValue, JsValue> {
        let result = Object::new();
        Reflect::set(&result, &"width".into(), &self.viewport.width.into())?;
        Reflect::set(&result, &"height".into(), &self.viewport.height.into())?;
        Reflect::set(&result, &"data".into(), &self.data)?;
        Reflect::set(&result, &"view".into(), &to_value(&ViewResult::from(self.viewport))?)?;
        Ok(result.into())
    }
}

impl Painting {
    pub(super) fn new(strips: picture::Painting, viewport: Viewport) -> Self {
        let data = Uint8ClampedArray::new_with_length(viewport.width * viewport.height * 4);
        Self { strips, viewport, data, filled: 0 }
    }
}
