//! Where the curves of a document lie in space.

use super::Model;
use super::model::drawn_curve;
use crate::curve::BSpline;
use crate::morph::Ruling;
use glam::{DVec2, DVec3};

/// Part of the domain on either side of a corner at which its two tangents are taken.
const BESIDE: f64 = 1e-7;
/// A cosine below this between two computations of one tangent tells a corner.
const SAME: f64 = 1.0 - 1e-9;
/// Part of its size by which a body has to leave a plane to be one.
const THINNEST: f64 = 1e-9;

/// The way from the plane in which curves are matched into space.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Space {
    axes: [DVec3; 3],
    heights: Vec<f64>,
    /// Heights along the curves, as the first coordinate, of those that do not lie in a plane.
    rises: Option<Vec<BSpline>>,
    /// Whether all lies in one plane.
    is_flat: bool,
}

impl Space {
    /// That of a model with two curves or more.
    pub(super) fn of(model: &Model) -> Option<Self> {
        let heights: Vec<f64> = model.document().curves.iter().map(|curve| curve.height).collect();
        let [first, _, ..] = heights[..] else { return None };
        let farthest = heights.iter().fold(0.0_f64, |most, height| most.max((height - first).abs()));
        let Some(projection) = model.projection() else {
            let axes = [DVec3::X, DVec3::Y, DVec3::Z];
            return Some(Self { axes, heights, rises: None, is_flat: farthest == 0.0 });
        };
        let rise = |k: usize| {
            let drawn = drawn_curve(&model.document().curves[k], k).ok()?;
            let rise = projection.heights_along(k, &drawn);
            Some(if model.reversed()[k] { rise.reversed() } else { rise })
        };
        let thinnest = THINNEST * model.bounds().diagonal();
        let is_flat = farthest <= thinnest && projection.deviation <= thinnest;
        let rises = (0..heights.len()).map(rise).collect::<Option<_>>()?;
        Some(Self { axes: projection.axes, heights, rises: Some(rises), is_flat })
    }

    /// Whether all lies in one plane, so that there is no solid.
    pub(super) fn is_flat(&self) -> bool {
        self.is_flat
    }

    /// The point of a curve at a parameter, whose place in the plane is known.
    pub(super) fn point(&self, curve: usize, u: f64, planar: DVec2) -> DVec3 {
        let height = self.rises.as_ref().map_or(self.heights[curve], |rises| rises[curve].point(u).x);
        self.at(planar, height)
    }

    /// Unit tangent of a curve at a parameter; at a corner the direction half-way.
    pub(super) fn tangent(&self, model: &Model, curve: usize, u: f64) -> DVec3 {
        let planar = &model.curves()[curve];
        let forward = planar.normal(u).perp();
        let Some(rises) = &self.rises else { return self.at(forward, 0.0) };
        let velocity =
            |u: f64| self.at(planar.derivative(u), rises[curve].derivative(u).x).normalize_or_zero();
        if planar.derivative(u).normalize_or_zero().dot(forward) > SAME {
            return velocity(u);
        }
        let (lo, hi) = planar.domain();
        let step = BESIDE * (hi - lo);
        (velocity(u - step) + velocity(u + step)).normalize_or(self.at(forward, 0.0))
    }

    /// Whether the curves lie in planes across the normal.
    #[cfg(feature = "stack")]
    pub(super) fn is_plane(&self) -> bool {
        self.rises.is_none()
    }

    /// Axes of the plane, and its normal.
    pub(super) fn axes(&self) -> [DVec3; 3] {
        self.axes
    }

    /// Ends of a ruling.
    pub(super) fn ends(&self, ruling: &Ruling) -> [DVec3; 2] {
        [self.point(0, ruling.u, ruling.from), self.point(1, ruling.v, ruling.to)]
    }

    /// A point of the plane at a height above it.
    pub(super) fn at(&self, planar: DVec2, height: f64) -> DVec3 {
        let [x, y, normal] = self.axes;
        x * planar.x + y * planar.y + normal * height
    }
}
