//! Cells that are written out.

use super::super::fields::numbers;
use super::super::node::Node;
use super::super::{Code, DocumentError};
use crate::hyperpatch::{Cell, LARGEST_COORDINATE, Net};
use crate::material::Composition;
use glam::DVec3;
use serde::ser::{SerializeSeq, SerializeStruct};
use serde::{Serialize, Serializer};

/// A cell as it is written: 64 coefficients, of which (i, j, k) stands at `(i * 4 + j) * 4 + k`.
#[derive(Debug, Clone, PartialEq)]
pub struct CellSpec(pub Cell);

/// A coefficient as it is written.
#[derive(Serialize)]
struct Coefficient<'a> {
    position: [f64; 3],
    mix: &'a [f64],
}

impl Serialize for CellSpec {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut object = to.serialize_struct("CellSpec", 1)?;
        object.serialize_field("coefficients", &Coefficients(&self.0))?;
        object.end()
    }
}

struct Coefficients<'a>(&'a Cell);

impl Serialize for Coefficients<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut list = to.serialize_seq(Some(64))?;
        for (at, point) in self.0.net().0.iter().enumerate() {
            let mix: Vec<f64> = self.0.fractions().iter().map(|fractions| fractions[at]).collect();
            list.serialize_element(&Coefficient { position: point.to_array(), mix: &mix })?;
        }
        list.end()
    }
}

impl CellSpec {
    /// Reads a cell of so many materials. Cells of any shape are taken: whether they are sound is for
    /// [`validity`](crate::hyperpatch::validity) to say, so that what is wrong can be shown.
    pub(super) fn read(node: &Node<'_>, materials: usize) -> Result<Self, DocumentError> {
        node.only(&["coefficients"])?;
        let list = node.need("coefficients")?;
        let items = list.items()?;
        list.check_count(items.len(), " coefficients", 64..=64)?;
        let (mut points, mut mixes) = ([DVec3::ZERO; 64], Vec::with_capacity(64));
        for (point, item) in points.iter_mut().zip(&items) {
            item.only(&["position", "mix"])?;
            let list = item.need("position")?;
            list.check_count(list.items()?.len(), " coordinates", 3..=3)?;
            *point = DVec3::from_array(list.triple(-LARGEST_COORDINATE..=LARGEST_COORDINATE)?);
            mixes.push(match item.get("mix")? {
                Some(list) => mix(&list, materials)?,
                None => Composition::pure(0, materials),
            });
        }
        Cell::new(Net(points), &mixes).map(Self).map_err(|e| list.error(Code::Range, e.to_string()))
    }
}

/// Reads the fractions of so many materials.
pub(super) fn mix(node: &Node<'_>, materials: usize) -> Result<Composition, DocumentError> {
    let fractions = numbers(node)?;
    node.check_count(fractions.len(), " fractions", materials..=materials)?;
    Composition::new(fractions).map_err(|e| node.error(Code::Range, e.to_string()))
}
