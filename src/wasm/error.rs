//! Errors as they cross the boundary.

use crate::document::DocumentError;
use js_sys::Reflect;
use wasm_bindgen::JsValue;

/// Converts an error to an `Error` with the fields `code`, `path` and, where there is a place, `at`.
pub(super) fn to_js(error: &DocumentError) -> JsValue {
    let object = js_sys::Error::new(&error.message);
    let set = |key: &str, value: &JsValue| {
        // Setting a field of a new object fails only when the object is frozen, which it is not.
        let _ = Reflect::set(&object, &key.into(), value);
    };
    set("code", &error.code.name().into());
    set("path", &error.path.as_str().into());
    if let Some(at) = error.at {
        set("at", &[at.x, at.y].into_iter().map(JsValue::from).collect::<js_sys::Array>());
    }
    object.into()
}
