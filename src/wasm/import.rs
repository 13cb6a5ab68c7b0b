//! Shapes and meshes from elsewhere: reading and fitting.

use super::engine::Engine;
use super::error::to_js;
use super::json::parse;
use super::results::to_value;
use crate::curve::{Fit, fit};
use crate::document::DocumentError;
use crate::import::{
    Format, Kind, Shape, Shapes, Skipped, fit_error, from_json, from_lines, from_stl, from_svg, kind_of,
    read_fit_options,
};
use glam::DVec2;
use js_sys::{Array, Float64Array, Object, Reflect, Uint32Array};
use serde::Serialize;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

#[derive(Serialize)]
struct FitResult {
    curve: CurveResult,
    error: f64,
    corners: Vec<usize>,
    simple: bool,
    trimmed: usize,
}

#[derive(Serialize)]
struct CurveResult {
    degree: usize,
    form: &'static str,
    points: Vec<[f64; 2]>,
    knots: Vec<f64>,
}

#[wasm_bindgen]
impl Engine {
    /// The closed shapes of a text; points come as flat arrays.
    #[wasm_bindgen(js_name = readShapes)]
    pub fn read_shapes(&self, text: &str, format: &str) -> Result<JsValue, JsValue> {
        let format = match format {
            "svg" => Format::Svg,
            "points" => Format::Points,
            _ => Format::Auto,
        };
        let read = || -> Result<Shapes, DocumentError> {
            match kind_of(text, format)? {
                Kind::Svg => from_svg(text),
                Kind::Json => from_json(&parse(text)?),
                Kind::Lines => from_lines(text),
            }
        };
        let Shapes { shapes, skipped } = read().map_err(|e| to_js(&e))?;
        let result = Object::new();
        Reflect::set(&result, &"shapes".into(), &list(shapes.iter().map(shape))?.into())?;
        Reflect::set(&result, &"skipped".into(), &list(skipped.iter().map(left_out))?.into())?;
        Ok(result.into())
    }

    /// The triangles of an STL file.
    #[wasm_bindgen(js_name = readMesh)]
    pub fn read_mesh(&self, bytes: &[u8]) -> Result<JsValue, JsValue> {
        let mesh = from_stl(bytes).map_err(|e| to_js(&e))?;
        let vertices: Vec<f64> = mesh.vertices.iter().flat_map(|vertex| vertex.to_array()).collect();
        let triangles = mesh.triangles.as_flattened();
        let format = if mesh.is_binary { "binary" } else { "text" };
        let result = Object::new();
        for (name, value) in [
            ("vertices", Float64Array::from(vertices.as_slice()).into()),
            ("triangles", Uint32Array::from(triangles).into()),
            ("dropped", JsValue::from(mesh.dropped)),
            ("format", format.into()),
        ] {
            Reflect::set(&result, &name.into(), &value)?;
        }
        Ok(result.into())
    }

    /// A closed curve near a flat list of points, or through them.
    #[wasm_bindgen(js_name = fitCurve)]
    pub fn fit_curve(&self, points: &[f64], options: &str) -> Result<JsValue, JsValue> {
        let options = parse(options).and_then(|options| read_fit_options(&options)).map_err(|e| to_js(&e))?;
        let points: Vec<_> = points.chunks_exact(2).map(|pair| DVec2::new(pair[0], pair[1])).collect();
        let Fit { curve, error, corners, simple, trimmed } =
            fit(&points, &options).map_err(|e| to_js(&fit_error(e)))?;
        let (degree, count) = (curve.degree(), curve.points().len());
        let curve = CurveResult {
            degree,
            form: "periodic",
            points: curve.points().iter().map(|p| p.to_array()).collect(),
            knots: curve.knots()[degree..=degree + count].to_vec(),
        };
        to_value(&FitResult { curve, error, corners, simple, trimmed })
    }
}

fn list(items: impl Iterator<Item = Result<JsValue, JsValue>>) -> Result<Array, JsValue> {
    items.collect()
}

fn shape(shape: &Shape) -> Result<JsValue, JsValue> {
    let flat: Vec<f64> = shape.points.iter().flat_map(|p| p.to_array()).collect();
    let corners: Vec<u32> = shape.corners.iter().map(|&index| index as u32).collect();
    let object = Object::new();
    Reflect::set(&object, &"name".into(), &shape.name.as_str().into())?;
    Reflect::set(&object, &"closed".into(), &shape.closed.into())?;
    Reflect::set(&object, &"points".into(), &Float64Array::from(flat.as_slice()).into())?;
    Reflect::set(&object, &"corners".into(), &Uint32Array::from(corners.as_slice()).into())?;
    Reflect::set(&object, &"area".into(), &shape.area.into())?;
    Reflect::set(&object, &"length".into(), &shape.length.into())?;
    Ok(object.into())
}

fn left_out(skipped: &Skipped) -> Result<JsValue, JsValue> {
    let object = Object::new();
    Reflect::set(&object, &"name".into(), &skipped.name.as_str().into())?;
    Reflect::set(&object, &"reason".into(), &skipped.reason.as_str().into())?;
    Ok(object.into())
}
