//! The control points of a curve.

#[cfg(not(feature = "solid"))]
use super::Code;
use super::DocumentError;
use super::node::Node;
#[cfg(feature = "solid")]
pub use in_space::ControlPoints;

/// Control points `[x, y]` of a curve in its plane.
#[cfg(not(feature = "solid"))]
pub type ControlPoints = Vec<[f64; 2]>;

/// Reads a list of points: the first one says whether all have two coordinates or three.
#[cfg(feature = "solid")]
pub(super) fn control_points(list: &Node<'_>) -> Result<ControlPoints, DocumentError> {
    if list.items()?.first().is_some_and(|first| first.has_length(3)) {
        return ControlPoints::read(list);
    }
    Ok(plane_points(list)?.into())
}

/// Reads a list of points in the plane, and refuses one in space.
#[cfg(not(feature = "solid"))]
pub(super) fn control_points(list: &Node<'_>) -> Result<ControlPoints, DocumentError> {
    if list.items()?.first().is_some_and(|first| first.has_length(3)) {
        return Err(list.error(Code::NotInModule, "curves in space need the module \"full\"".to_owned()));
    }
    plane_points(list)
}

pub(super) fn plane_points(list: &Node<'_>) -> Result<Vec<[f64; 2]>, DocumentError> {
    let mut points = Vec::new();
    for point in list.items()? {
        points.push(point.pair()?);
    }
    Ok(points)
}

/// Points that may have a third coordinate.
#[cfg(feature = "solid")]
mod in_space {
    use super::{DocumentError, Node};
    use crate::document::schema::LARGEST;
    use glam::DVec3;
    use serde::{Serialize, Serializer};
    use std::ops::Deref;

    /// Control points `[x, y]` of a curve in its plane, or `[x, y, z]` of one in space; as a slice, the first two coordinates.
    #[derive(Debug, Clone, PartialEq, Default)]
    pub struct ControlPoints {
        plane: Vec<[f64; 2]>,
        /// The third coordinate of each, or none at all.
        z: Vec<f64>,
    }

    impl ControlPoints {
        /// Reads points of three coordinates.
        pub(super) fn read(list: &Node<'_>) -> Result<Self, DocumentError> {
            let mut points = Self::default();
            for item in list.items()? {
                let [x, y, z] = item.triple(-LARGEST..=LARGEST)?;
                points.plane.push([x, y]);
                points.z.push(z);
            }
            Ok(points)
        }

        /// The points in space, of a curve that is not in its plane.
        pub(in crate::document) fn in_space(&self) -> Option<Vec<DVec3>> {
            let point = |(&[x, y], &z): (&[f64; 2], &f64)| DVec3::new(x, y, z);
            (!self.z.is_empty()).then(|| self.plane.iter().zip(&self.z).map(point).collect())
        }
    }

    impl From<Vec<[f64; 2]>> for ControlPoints {
        fn from(plane: Vec<[f64; 2]>) -> Self {
            Self { plane, z: Vec::new() }
        }
    }

    impl FromIterator<[f64; 2]> for ControlPoints {
        fn from_iter<I: IntoIterator<Item = [f64; 2]>>(points: I) -> Self {
            points.into_iter().collect::<Vec<_>>().into()
        }
    }

    impl From<&[DVec3]> for ControlPoints {
        fn from(points: &[DVec3]) -> Self {
            Self {
                plane: points.iter().map(|p| [p.x, p.y]).collect(),
                z: points.iter().map(|p| p.z).collect(),
            }
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
            match self.in_space() {
                Some(points) => serializer.collect_seq(points.iter().map(|point| point.to_array())),
                None => self.plane.serialize(serializer),
            }
        }
    }
}
