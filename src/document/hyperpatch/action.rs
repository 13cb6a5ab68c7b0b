//! An operation as it is written.

use super::super::node::Node;
use super::super::{Code, DocumentError, Json};
use super::cells::CellSpec;
use super::construct::{self, FaceSpec};
use super::edit;
use super::material::{self, MixTarget};
use super::names::{self, LARGEST_ID};
use crate::hyperpatch::composite::{CellId, MOST_CELLS, Match};
use crate::hyperpatch::operation::{Normals, Reach, Slope, Start};
use crate::hyperpatch::{Axis, Corner, Face};
use crate::material::Composition;
use serde::{Serialize, Serializer};

/// What an operation does. Whether it applies is for the body to say when its turn comes.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "op", rename_all = "kebab-case")]
pub enum Action {
    /// Adds cells that are written out.
    Cells {
        /// The cells.
        cells: Vec<CellSpec>,
    },
    /// Moves a coefficient and what follows it.
    Move {
        /// The cell.
        #[serde(serialize_with = "names::write_cell")]
        cell: CellId,
        /// Indices of the coefficient.
        at: [usize; 3],
        /// By how much.
        by: [f64; 3],
        /// What follows it.
        #[serde(serialize_with = "names::write_reach")]
        reach: Reach,
    },
    /// Marks how cells are to continue each other across a face, and brings it about.
    Continuity {
        /// The cell.
        #[serde(serialize_with = "names::write_cell")]
        cell: CellId,
        /// Its face.
        #[serde(serialize_with = "names::write_face")]
        face: Face,
        /// The corner; without one all four of the face.
        #[serde(skip_serializing_if = "Option::is_none", serialize_with = "names::write_some_corner")]
        corner: Option<Corner>,
        /// In shape; without it as before.
        #[serde(skip_serializing_if = "Option::is_none", serialize_with = "names::write_some_match")]
        shape: Option<Match>,
        /// In material; without it as before.
        #[serde(skip_serializing_if = "Option::is_none", serialize_with = "names::write_some_match")]
        material: Option<Match>,
    },
    /// Gives coefficients a mix.
    Mix {
        /// The mix.
        #[serde(serialize_with = "write_mix")]
        mix: Composition,
        /// The coefficients.
        #[serde(flatten)]
        target: MixTarget,
    },
    /// Makes the material go on at a corner.
    Slope {
        /// A cell with the corner.
        #[serde(serialize_with = "names::write_cell")]
        cell: CellId,
        /// The corner.
        #[serde(serialize_with = "names::write_corner")]
        corner: Corner,
        /// How.
        #[serde(serialize_with = "names::write_slope")]
        rule: Slope,
    },
    /// Takes cells out.
    Delete {
        /// The cells.
        #[serde(serialize_with = "names::write_cells")]
        cells: Vec<CellId>,
    },
    /// Adds copies of cells in another place.
    Copy {
        /// The cells.
        #[serde(serialize_with = "names::write_cells")]
        cells: Vec<CellId>,
        /// How far away.
        by: [f64; 3],
    },
    /// Adds mirror images of cells.
    Mirror {
        /// The cells.
        #[serde(serialize_with = "names::write_cells")]
        cells: Vec<CellId>,
        /// Normal of the plane, of any length above 0.
        normal: [f64; 3],
        /// Product of the points of the plane with the normal.
        offset: f64,
        /// Whether the cells themselves stay.
        keep: bool,
    },
    /// Turns mirrored cells the right way round.
    Reorient {
        /// The cells.
        #[serde(serialize_with = "names::write_cells")]
        cells: Vec<CellId>,
    },
    /// Adds a cell on each of some faces.
    Extrude {
        /// The faces.
        faces: Vec<FaceSpec>,
        /// Length along the normals.
        by: f64,
        /// How it begins.
        #[serde(serialize_with = "names::write_start")]
        start: Start,
        /// Along which normals.
        #[serde(serialize_with = "names::write_normals")]
        normals: Normals,
        /// The mix of the new cells; without it that of the faces goes on.
        #[serde(skip_serializing_if = "Option::is_none", serialize_with = "write_some_mix")]
        mix: Option<Composition>,
    },
    /// Divides a cell, and every cell of the sheet across it.
    Subdivide {
        /// A cell of the sheet.
        #[serde(serialize_with = "names::write_cell")]
        cell: CellId,
        /// The axis that is divided.
        #[serde(serialize_with = "names::write_axis")]
        axis: Axis,
        /// Where.
        at: f64,
    },
}

/// An operation with its number, if it has one.
#[derive(Debug, Clone, PartialEq)]
pub struct Operation {
    /// The number; without it one more than the largest before it.
    pub id: Option<u32>,
    /// What it does.
    pub action: Action,
    /// Number of materials with which it was read.
    pub materials: usize,
}

impl Action {
    /// The operations by their names.
    pub const NAMES: [&str; 11] = [
        "cells",
        "move",
        "continuity",
        "mix",
        "slope",
        "delete",
        "copy",
        "mirror",
        "reorient",
        "extrude",
        "subdivide",
    ];

    /// Place of the operation in the list of names.
    #[must_use]
    pub fn kind(&self) -> usize {
        match self {
            Self::Cells { .. } => 0,
            Self::Move { .. } => 1,
            Self::Continuity { .. } => 2,
            Self::Mix { .. } => 3,
            Self::Slope { .. } => 4,
            Self::Delete { .. } => 5,
            Self::Copy { .. } => 6,
            Self::Mirror { .. } => 7,
            Self::Reorient { .. } => 8,
            Self::Extrude { .. } => 9,
            Self::Subdivide { .. } => 10,
        }
    }

    /// Number of cells that are written out in it.
    #[must_use]
    pub fn written(&self) -> usize {
        if let Self::Cells { cells } = self { cells.len() } else { 0 }
    }
}

impl Operation {
    /// Reads an operation of a document with so many materials.
    pub(super) fn read(node: &Node<'_>, materials: usize) -> Result<Self, DocumentError> {
        let name = node.need("op")?.choice(&Action::NAMES)?;
        let action = match name {
            0 => {
                node.only(&["op", "id", "cells"])?;
                let list = node.need("cells")?;
                let items = list.items()?;
                list.check_count(items.len(), " cells", 0..=MOST_CELLS)?;
                let cells: Result<_, _> = items.iter().map(|item| CellSpec::read(item, materials)).collect();
                Action::Cells { cells: cells? }
            }
            1 => edit::moved(node)?,
            2 => edit::continued(node)?,
            3 => material::mixed(node, materials)?,
            4 => material::sloped(node)?,
            5 => construct::deleted(node)?,
            6 => construct::copied(node)?,
            7 => construct::mirrored(node)?,
            8 => construct::reoriented(node)?,
            9 => construct::extruded(node, materials)?,
            _ => construct::subdivided(node)?,
        };
        Ok(Self { id: number(node)?, action, materials })
    }
}

/// The number of an operation.
fn number(node: &Node<'_>) -> Result<Option<u32>, DocumentError> {
    let Some(node) = node.get("id")? else { return Ok(None) };
    let id = node.count()?;
    if id > LARGEST_ID {
        let message = format!("{id} was found; expected a whole number from 0 to {LARGEST_ID}");
        return Err(node.error(Code::Range, message));
    }
    Ok(Some(id as u32))
}

/// An operation that is read bit by bit: its cells may come one after the other.
#[derive(Debug)]
pub struct OperationReading {
    /// Place in the list of operations.
    place: usize,
    operation: Operation,
}

impl OperationReading {
    /// Reads an operation at a place of the list. With `apart` it is an operation `cells` without these, which come by
    /// [`OperationReading::add`].
    ///
    /// # Errors
    /// The first thing that is wrong, with its path from the document on.
    pub fn new(json: &Json, place: usize, materials: usize, is_apart: bool) -> Result<Self, DocumentError> {
        let name = format!("operations[{place}]");
        let node = Node::root(json, &name);
        if !is_apart {
            return Ok(Self { place, operation: Operation::read(&node, materials)? });
        }
        node.need("op")?.choice(&Action::NAMES[..1])?;
        node.only(&["op", "id"])?;
        let operation =
            Operation { id: number(&node)?, action: Action::Cells { cells: Vec::new() }, materials };
        Ok(Self { place, operation })
    }

    /// Reads the next cell.
    ///
    /// # Errors
    /// The first thing that is wrong, with its path from the document on.
    pub fn add(&mut self, json: &Json) -> Result<(), DocumentError> {
        if let Action::Cells { cells } = &mut self.operation.action {
            let name = format!("operations[{}].cells[{}]", self.place, cells.len());
            cells.push(CellSpec::read(&Node::root(json, &name), self.operation.materials)?);
        }
        Ok(())
    }

    /// The operation.
    #[must_use]
    pub fn finish(self) -> Operation {
        self.operation
    }
}

fn write_mix<S: Serializer>(mix: &Composition, to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(mix.fractions())
}

fn write_some_mix<S: Serializer>(mix: &Option<Composition>, to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(mix.iter().flat_map(|mix| mix.fractions()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::read_hyperpatch;
    use serde_json::{Value, json};

    fn cube() -> Value {
        let coefficient = |at: usize| json!({"position": [at / 16, at / 4 % 4, at % 4], "mix": [0.25, 0.75]});
        json!({"coefficients": (0..64).map(coefficient).collect::<Vec<_>>()})
    }

    fn document(operations: &Value) -> Json {
        Json::from(json!({"directrix": 1, "kind": "hyperpatch", "operations": operations}))
    }

    /// Every operation with all defaults spelt out is written as it was read.
    #[test]
    fn what_is_written_is_what_was_read() {
        let list = json!([
            {"id": 0, "op": "cells", "cells": [cube()]},
            {"id": 1, "op": "move", "cell": 0, "at": [0, 1, 3], "by": [0.5, -1.0, 0.0], "reach": "single"},
            {"id": 2, "op": "continuity", "cell": 0, "face": "v1", "corner": [0, 1, 0], "shape": "none", "material": "C1"},
            {"id": 3, "op": "continuity", "cell": 0, "face": "w0", "shape": "C0"},
            {"id": 4, "op": "mix", "mix": [0.5, 0.5], "cells": [0, 7]},
            {"id": 5, "op": "mix", "mix": [0.5, 0.5], "cell": 0, "corner": [1, 0, 1], "within": [0]},
            {"id": 6, "op": "mix", "mix": [0.5, 0.5], "cell": 0, "corner": [1, 0, 1]},
            {"id": 7, "op": "mix", "mix": [0.5, 0.5], "cell": 0, "at": [1, 2, 3]},
            {"id": 8, "op": "slope", "cell": 0, "corner": [1, 1, 1], "rule": "natural"},
            {"id": 9, "op": "delete", "cells": [99999999]},
            {"id": 20, "op": "copy", "cells": [0], "by": [1.0, 2.0, 3.0]},
            {"id": 11, "op": "mirror", "cells": [0], "normal": [0.0, 2.0, 0.0], "offset": -1.5, "keep": false},
            {"id": 12, "op": "reorient", "cells": [0]},
            {"id": 13, "op": "extrude", "faces": [{"cell": 0, "face": "u1"}], "by": 0.25, "start": "C1", "normals": "surface", "mix": [1.0, 0.0]},
            {"id": 14, "op": "subdivide", "cell": 0, "axis": "w", "at": 0.25},
        ]);
        let read = read_hyperpatch(&document(&list)).unwrap();
        let written = serde_json::to_value(&read).unwrap();
        assert_eq!(Json::from(written["operations"].clone()), Json::from(list.clone()));
        let names: Vec<_> =
            read.operations.iter().map(|(_, operation)| Action::NAMES[operation.action.kind()]).collect();
        let expected: Vec<_> =
            list.as_array().unwrap().iter().map(|item| item["op"].as_str().unwrap()).collect();
        assert_eq!(names, expected);
    }

    /// The cells of an operation may come one after the other, and what is wrong has the same path then.
    #[test]
    fn cells_that_come_apart_make_the_same_operation() {
        let whole = json!({"op": "cells", "id": 5, "cells": [cube(), cube()]});
        let mut reading =
            OperationReading::new(&Json::from(json!({"op": "cells", "id": 5})), 3, 2, true).unwrap();
        reading.add(&Json::from(cube())).unwrap();
        let mut wrong = cube();
        wrong["coefficients"][7]["mix"] = json!([1]);
        assert_eq!(
            reading.add(&Json::from(wrong)).unwrap_err().path,
            "operations[3].cells[1].coefficients[7].mix"
        );
        reading.add(&Json::from(cube())).unwrap();
        let expected = OperationReading::new(&Json::from(whole), 3, 2, false).unwrap().finish();
        assert_eq!(reading.finish(), expected);
        let other = OperationReading::new(&Json::from(json!({"op": "delete"})), 3, 2, true);
        assert_eq!(other.unwrap_err().path, "operations[3].op");
    }

    #[test]
    fn numbers_are_given_in_order_and_once() {
        let ids = |list: Value| {
            read_hyperpatch(&document(&list))
                .map(|document| document.operations.iter().map(|(id, _)| *id).collect::<Vec<_>>())
        };
        let gone = |id: Option<u32>| match id {
            Some(id) => json!({"op": "delete", "cells": [0], "id": id}),
            None => json!({"op": "delete", "cells": [0]}),
        };
        assert_eq!(ids(json!([gone(None), gone(Some(7)), gone(Some(3)), gone(None)])), Ok(vec![0, 7, 3, 8]));
        assert_eq!(ids(json!([gone(None), gone(Some(0))])).unwrap_err().path, "operations[1].id");
        assert_eq!(ids(json!([gone(Some(9_999)), gone(None)])).unwrap_err().path, "operations[1].id");
    }
}
