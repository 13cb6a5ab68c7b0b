//! Curves in space, matched in the plane that fits them best.

use super::control_points::ControlPoints;
use super::model::drawn_curve;
use super::{Code, CurveSpec, CurvesDocument, DocumentError};
use crate::curve::BSpline;
use crate::solid::{best_axes, mean_point};
use glam::{DVec2, DVec3, dvec2};

/// What the matching of curves in space takes for granted: it sees their projections on parallel planes, one through the mean of each curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Projection {
    /// Right-handed axes: x and y in the planes, and their normal.
    pub axes: [DVec3; 3],
    /// The point of the plane of the first curve that is nearest to the origin of the document.
    pub origin: DVec3,
    /// Greatest distance of a curve from its own plane, at the places where it was looked at.
    pub deviation: f64,
    /// Heights of the control points of each curve above the origin of the document, along the normal.
    heights: Vec<Vec<f64>>,
}

/// Places in which a curve is looked at, for each control point, and fewest and most of them.
const PLACES: (usize, usize, usize) = (8, 256, 4096);

impl Projection {
    /// What is assumed, as a sentence.
    #[must_use]
    pub fn assumed(&self) -> String {
        format!(
            "the curves are matched as they are seen along the normal of the planes that fit them best; a curve counts as lying at its mean height, from which it is up to {} away",
            self.deviation
        )
    }

    /// Heights along the normal of a curve as drawn, as the first coordinate of a curve with the same knots.
    pub(super) fn heights_along(&self, k: usize, drawn: &BSpline) -> BSpline {
        drawn.with_points(self.heights[k].iter().map(|&height| dvec2(height, 0.0)).collect())
    }
}

/// Projects the curves of a document that lie in space; a document of plane curves stays as it is.
///
/// # Errors
/// When a curve is not valid, or all of them run along one line.
pub(super) fn projected(
    mut document: CurvesDocument,
) -> Result<(CurvesDocument, Option<Projection>), DocumentError> {
    let spatial: Option<Vec<Vec<DVec3>>> =
        document.curves.iter().map(|spec| spec.points.in_space()).collect();
    let Some(spatial) = spatial.filter(|curves| !curves.is_empty()) else { return Ok((document, None)) };
    let mut polylines = Vec::with_capacity(spatial.len());
    for (k, (spec, points)) in document.curves.iter().zip(&spatial).enumerate() {
        polylines.push(polyline(&coordinates(spec, points, k)?));
    }
    let Some(axes) = best_axes(&polylines) else {
        let message = "all curves run along one line; expected curves that lie around an area";
        return Err(DocumentError::new(Code::ZeroLength, "curves", message));
    };
    let [x, y, normal] = axes;
    let mut deviation = 0.0_f64;
    for (spec, (points, line)) in document.curves.iter_mut().zip(spatial.iter().zip(&polylines)) {
        spec.height = mean_point(line).dot(normal);
        let off = line.iter().map(|point| (point.dot(normal) - spec.height).abs());
        deviation = off.fold(deviation, f64::max);
        spec.points = ControlPoints::from(points.iter().map(|p| [p.dot(x), p.dot(y)]).collect::<Vec<_>>());
    }
    let heights = spatial.iter().map(|points| points.iter().map(|p| p.dot(normal)).collect()).collect();
    let origin = normal * document.curves[0].height;
    Ok((document, Some(Projection { axes, origin, deviation, heights })))
}

/// The curve of x and y, and that of z, with the knots that the document gives.
///
/// # Errors
/// When it is not valid as a curve in space.
pub(super) fn coordinates(
    spec: &CurveSpec,
    points: &[DVec3],
    k: usize,
) -> Result<[BSpline; 2], DocumentError> {
    // The two coordinates that spread most show best whether the curve has a length.
    let (low, high) =
        points.iter().fold((DVec3::MAX, DVec3::MIN), |(low, high), &p| (low.min(p), high.max(p)));
    let spread = (high - low).to_array();
    let least = (0..3).min_by(|&i, &j| spread[i].total_cmp(&spread[j])).unwrap_or(2);
    let seen = |p: &DVec3| {
        let all = p.to_array();
        [all[(least + 1) % 3], all[(least + 2) % 3]]
    };
    let plane = ControlPoints::from(points.iter().map(seen).collect::<Vec<_>>());
    let checked = drawn_curve(&CurveSpec { points: plane, ..spec.clone() }, k)?;
    if let ([first, .., last], super::CurveForm::Clamped) = (points, spec.form)
        && first.to_array()[least] != last.to_array()[least]
    {
        let message =
            format!("the last control point {last} differs from the first {first}; expected the same point");
        let path = format!("curves[{k}].points[{}]", points.len() - 1);
        return Err(DocumentError::new(Code::Points, path, message));
    }
    let flat = points.iter().map(|p| p.truncate()).collect();
    let rise = points.iter().map(|p| DVec2::new(p.z, 0.0)).collect();
    Ok([checked.with_points(flat), checked.with_points(rise)])
}

/// A curve in space at equal steps of its parameter, from end to end.
fn polyline([flat, rise]: &[BSpline; 2]) -> Vec<DVec3> {
    let (each, fewest, most) = PLACES;
    let count = (each * flat.points().len()).clamp(fewest, most);
    let (lo, hi) = flat.domain();
    let mut line: Vec<DVec3> = (0..=count)
        .map(|step| lo + (hi - lo) * step as f64 / count as f64)
        .map(|u| flat.point(u).extend(rise.point(u).x))
        .collect();
    if flat.is_closed() {
        line[count] = line[0];
    }
    line
}
