//! A JSON value, as documents and options arrive in.

#[cfg(not(target_arch = "wasm32"))]
use super::{Code, DocumentError};

/// A JSON value.
///
/// Natively it is [parsed](Json::parse) from text by `serde_json`; in the browser the host's own parser builds it, which
/// spares the module that code. Of a field that occurs twice the last one counts. A number too large for a double
/// is infinite in the browser and refused natively.
#[derive(Debug, Clone, PartialEq)]
pub enum Json {
    /// `null`.
    Null,
    /// `true` or `false`.
    Flag(bool),
    /// A number.
    Number(f64),
    /// A text.
    Text(String),
    /// A list.
    List(Vec<Json>),
    /// An object: names and values.
    Object(Vec<(String, Json)>),
}

impl Json {
    /// Parses JSON text.
    ///
    /// # Errors
    /// With code `syntax`, line and column when the text is not JSON; with code `non-finite` for a number too large.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn parse(text: &str) -> Result<Self, DocumentError> {
        let value: serde_json::Value = serde_json::from_str(text).map_err(|e| {
            let message = e.to_string();
            let code =
                if message.starts_with("number out of range") { Code::NonFinite } else { Code::Syntax };
            DocumentError::new(code, "", format!("the text is not JSON that can be read: {message}"))
        })?;
        Ok(Self::from(value))
    }
}

#[cfg(not(target_arch = "wasm32"))]
impl From<serde_json::Value> for Json {
    fn from(value: serde_json::Value) -> Self {
        use serde_json::Value;
        match value {
            Value::Null => Self::Null,
            Value::Bool(flag) => Self::Flag(flag),
            Value::Number(number) => Self::Number(number.as_f64().unwrap_or(f64::INFINITY)),
            Value::String(text) => Self::Text(text),
            Value::Array(values) => Self::List(values.into_iter().map(Self::from).collect()),
            Value::Object(map) => {
                Self::Object(map.into_iter().map(|(name, v)| (name, Self::from(v))).collect())
            }
        }
    }
}
