//! The browser boundary: conversions only.
//!
//! Documents and options come in as JSON text, which the host's own parser reads; results go out as plain objects and typed
//! arrays. `js/` wraps these functions and is the interface to use.

#[cfg(feature = "amounts")]
mod amounts;
#[cfg(feature = "hyperpatch")]
mod answers;
#[cfg(feature = "laplace")]
mod boundary;
mod diagnostic;
#[cfg(feature = "edit")]
mod edit;
mod engine;
mod error;
#[cfg(feature = "explain")]
mod explain;
mod growth;
#[cfg(feature = "harmonic")]
mod harmonic;
#[cfg(feature = "hyperpatch")]
mod hyperpatch;
#[cfg(feature = "import")]
mod import;
mod json;
#[cfg(feature = "laplace")]
mod laplace;
mod painting;
#[cfg(feature = "part")]
mod part;
#[cfg(feature = "paths")]
mod paths;
mod probe;
#[cfg(feature = "hyperpatch")]
mod reading;
mod results;
#[cfg(feature = "solid")]
mod solid;
#[cfg(feature = "stack")]
mod stack;
#[cfg(feature = "svg")]
mod svg;
#[cfg(feature = "field")]
mod transform;

use js_sys::Reflect;
use wasm_bindgen::prelude::{JsCast, JsValue, wasm_bindgen};

/// Runs once when the module is loaded: a panic then says on the console where it happened before the module traps.
#[wasm_bindgen(start)]
fn start() {
    console_error_panic_hook::set_once();
}

/// The clock of the host.
fn clock() -> web_sys::Performance {
    let performance = Reflect::get(&js_sys::global(), &"performance".into());
    performance.unwrap_or(JsValue::UNDEFINED).unchecked_into()
}
