//! The control points of a curve.

use super::DocumentError;
use super::node::Node;
#[cfg(feature = "solid")]
use super::schema::LARGEST;
#[cfg(feature = "solid")]
use glam::DVec3;
use serde::{Serialize, Serializer};
use std::ops::Deref;

/// Control points `[x, y]` of a curve in its plane, or `[x, y, z]` of one in space; as a slice, the first two coordinates.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ControlPoints {
    plane: Vec<[f64; 2]>,
    /// The third coordinate of each, or none at all.
    #[cfg(feature = "solid")]
    z: Vec<f64>,
}

impl ControlPoints {
    /// Reads a list of points: the first one says whether all have two coordinates or three.
    pub(super) fn read(list: &Node<'_>) -> Result<Self, DocumentError> {
        let items = list.items()?;
        let mut points = Self { plane: Vec::with_capacity(items.len()), ..Self::default() };
        #[cfg(feature = "solid")]
        if items.first().is_some_and(|first| first.has_length(3)) {
            for item in &items {
                let [x, y, z] = item.triple(-LARGEST..=LARGEST)?;
                points.plane.push([x, y]);
                points.z.push(z);
            }
            return Ok(points);
        }
        for item in &items {
            points.plane.push(item.pair()?);
        }
        Ok(points)
    }

    /// The points in space, of a curve that is not in its plane.
    #[cfg(feature = "solid")]
    pub(super) fn in_space(&self) -> Option<Vec<DVec3>> {
        let point = |(&[x, y], &z): (&[f64; 2], &f64)| DVec3::new(x, y, z);
        (!self.z.is_empty()).then(|| self.plane.iter().zip(&self.z).map(point).collect())
    }
}

impl From<Vec<[f64; 2]>> for ControlPoints {
    fn from(plane: Vec<[f64; 2]>) -> Self {
        Self { plane, ..Self::default() }
    }
}

#[cfg(feature = "solid")]
impl From<&[DVec3]> for ControlPoints {
    fn from(points: &[DVec3]) -> Self {
        Self { plane: points.iter().map(|p| [p.x, p.y]).collect(), z: points.iter().map(|p| p.z).collect() }
    }
}

impl Deref for ControlPoints {
    type Target = [[f64; 2]];

    fn deref(&self) -> &[[f64; 2]] {
        &self.plane
    }
}

impl Serialize for ControlPoints {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[cfg(feature = "solid")]
        if let Some(points) = self.in_space() {
            return serializer.collect_seq(points.iter().map(|point| point.to_array()));
        }
        self.plane.serialize(serializer)
    }
}
