//! Insertion of a control point.

use super::model::drawn_curve;
use super::{Code, CurvesDocument, DocumentError};
#[cfg(feature = "solid")]
use super::{ControlPoints, projection::coordinates};
#[cfg(feature = "solid")]
use crate::curve::CurveError;

/// Returns the document with one more control point on curve `curve`, by a knot at the parameter `u` of the curve as drawn.
///
/// The curve keeps its shape and its domain; its knots are spelt out from then on.
///
/// # Errors
/// When there is no such curve, the curve is not valid, `u` is not finite, or the knot is full.
pub fn insert_point(
    mut document: CurvesDocument,
    curve: usize,
    u: f64,
) -> Result<CurvesDocument, DocumentError> {
    let count = document.curves.len();
    let Some(spec) = document.curves.get_mut(curve) else {
        let message = format!("{curve} was found; expected a number below {count}");
        return Err(DocumentError::new(Code::Range, "curve", message));
    };
    #[cfg(feature = "solid")]
    if let Some(points) = spec.points.in_space() {
        let [flat, rise] = coordinates(spec, &points, curve)?;
        let refused = |e: CurveError| DocumentError::new(Code::Knots, "u", e.to_string());
        let (flat, rise) = (flat.insert_knot(u).map_err(refused)?, rise.insert_knot(u).map_err(refused)?);
        let points: Vec<_> = flat.points().iter().zip(rise.points()).map(|(p, z)| p.extend(z.x)).collect();
        spec.points = ControlPoints::from(points.as_slice());
        spec.knots = Some(flat.knots().to_vec());
        return Ok(document);
    }
    let finer = drawn_curve(spec, curve)?
        .insert_knot(u)
        .map_err(|e| DocumentError::new(Code::Knots, "u", e.to_string()))?;
    spec.points = finer.points().iter().map(|point| point.to_array()).collect();
    spec.knots = Some(finer.knots().to_vec());
    Ok(document)
}
