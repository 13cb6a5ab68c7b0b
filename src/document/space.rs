//! Where the curves of a document lie in space.

use super::Model;
use crate::morph::Ruling;
use glam::{DVec2, DVec3};

/// The way from the plane in which curves are matched into space.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Space {
    heights: [f64; 2],
}

impl Space {
    /// That of a model with two curves.
    pub(super) fn of(model: &Model) -> Option<Self> {
        let [first, second] = model.document().curves.as_slice() else { return None };
        Some(Self { heights: [first.height, second.height] })
    }

    /// The point of a curve at a parameter, whose place in the plane is known.
    pub(super) fn point(&self, curve: usize, _u: f64, planar: DVec2) -> DVec3 {
        planar.extend(self.heights[curve])
    }

    /// Unit tangent of a curve at a parameter; at a corner the direction half-way.
    pub(super) fn tangent(&self, model: &Model, curve: usize, u: f64) -> DVec3 {
        model.curves()[curve].normal(u).perp().extend(0.0)
    }

    /// Axes of the plane, and its normal.
    pub(super) fn axes(&self) -> [DVec3; 3] {
        [DVec3::X, DVec3::Y, DVec3::Z]
    }

    /// Ends of a ruling.
    pub(super) fn ends(&self, ruling: &Ruling) -> [DVec3; 2] {
        [self.point(0, ruling.u, ruling.from), self.point(1, ruling.v, ruling.to)]
    }
}
