//! JSON text, read by the host.

use crate::document::{Code, DocumentError, Json};
use js_sys::{Array, JSON, Object};
use wasm_bindgen::{JsCast, JsValue};

/// Deepest nesting that is read: a document has six levels.
const DEEPEST: usize = 64;

/// Parses JSON text with the parser of the host.
///
/// # Errors
/// With code `syntax` and the host's words when the text is not JSON; with code `limit` when it is nested too deep.
pub(super) fn parse(text: &str) -> Result<Json, DocumentError> {
    let value = JSON::parse(text).map_err(|error| {
        let reason = error.dyn_ref::<js_sys::Error>().map_or_else(String::new, |e| String::from(e.message()));
        DocumentError::new(Code::Syntax, "", format!("the text is not JSON that can be read: {reason}"))
    })?;
    convert(&value, 0).ok_or_else(|| {
        DocumentError::new(Code::Limit, "", format!("expected at most {DEEPEST} levels of nesting"))
    })
}

fn convert(value: &JsValue, depth: usize) -> Option<Json> {
    if let Some(number) = value.as_f64() {
        return Some(Json::Number(number));
    }
    if let Some(text) = value.as_string() {
        return Some(Json::Text(text));
    }
    if let Some(flag) = value.as_bool() {
        return Some(Json::Flag(flag));
    }
    if depth == DEEPEST {
        return None;
    }
    if let Some(list) = value.dyn_ref::<Array>() {
        return list.iter().map(|item| convert(&item, depth + 1)).collect::<Option<_>>().map(Json::List);
    }
    let Some(object) = value.dyn_ref::<Object>() else { return Some(Json::Null) };
    let field = |entry: JsValue| {
        let entry: Array = entry.unchecked_into();
        Some((entry.get(0).as_string()?, convert(&entry.get(1), depth + 1)?))
    };
    Object::entries(object).iter().map(field).collect::<Option<_>>().map(Json::Object)
}
