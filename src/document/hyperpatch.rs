//! Hyperpatch documents: materials, and the operations that make a body.

use super::fields::{materials, numbers};
use super::model::materials as build_materials;
use super::node::Node;
use super::read::check_version;
use super::{Code, DocumentError, Json, MaterialSpec};
use crate::hyperpatch::composite::{Body, CellId, MOST_CELLS};
use crate::hyperpatch::{Cell, LARGEST_COORDINATE, Net};
use crate::material::{Composition, Material};
use glam::DVec3;
use serde::Serialize;

/// Most operations of a document.
const MOST_OPERATIONS: usize = 10_000;

/// A hyperpatch document in memory, with all defaults filled in.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct HyperpatchDocument {
    /// Version of the format: 1.
    pub directrix: u32,
    /// Always `hyperpatch`.
    pub kind: HyperpatchKind,
    /// Title, at most 200 characters.
    pub title: String,
    /// Unit of length, for display only.
    pub unit: String,
    /// Materials; a mix has one fraction for each.
    pub materials: Vec<MaterialSpec>,
    /// What makes the body, in order.
    pub operations: Vec<OperationSpec>,
}

/// The kind of a hyperpatch document.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum HyperpatchKind {
    /// Cells of tricubic Bezier hyperpatches.
    Hyperpatch,
}

/// An operation on the body.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "op", rename_all = "kebab-case")]
pub enum OperationSpec {
    /// Adds cells.
    Cells {
        /// The cells; they get the next identifiers.
        cells: Vec<CellSpec>,
    },
}

/// A cell.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CellSpec {
    /// 64 coefficients; (i, j, k) stands at `(i * 4 + j) * 4 + k`.
    pub coefficients: Vec<CoefficientSpec>,
}

/// A coefficient of a cell.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CoefficientSpec {
    /// Position [x, y, z], coordinates up to 1e9 either way.
    pub position: [f64; 3],
    /// Fraction of each material; they sum to 1.
    pub mix: Vec<f64>,
}

/// Reads a hyperpatch document and checks every field by itself.
///
/// # Errors
/// The first thing that is wrong, with the path of its field; a document of another kind among them. Mixes and
/// colours are checked by [`HyperpatchModel::new`].
pub fn read_hyperpatch(document: &Json) -> Result<HyperpatchDocument, DocumentError> {
    let root = Node::root(document, "");
    check_version(&root)?;
    let kind = root.need("kind")?;
    let kinds = ["curves", "part", "hyperpatch"];
    let found = kind.choice(&kinds)?;
    if found != 2 {
        let message = format!("`{}` was found; expected the kind `hyperpatch`", kinds[found]);
        return Err(kind.error(Code::Kind, message));
    }
    root.only(&["directrix", "kind", "title", "unit", "materials", "operations"])?;
    let text = |name: &str, most: usize, default: &str| match root.get(name)? {
        Some(node) => node.text(most),
        None => Ok(default.to_owned()),
    };
    let materials = materials(&root)?;
    let list = root.need("operations")?;
    let items = list.items()?;
    list.check_count(items.len(), " operations", 0..=MOST_OPERATIONS)?;
    let (mut operations, mut count) = (Vec::with_capacity(items.len()), 0);
    for item in &items {
        let op = item.need("op")?;
        op.choice(&["cells"])?;
        item.only(&["op", "cells"])?;
        let cells = item.need("cells")?;
        operations.push(OperationSpec::Cells { cells: read_cells(&cells, &mut count, materials.len())? });
    }
    Ok(HyperpatchDocument {
        directrix: 1,
        kind: HyperpatchKind::Hyperpatch,
        title: text("title", 200, "Untitled")?,
        unit: text("unit", 16, "mm")?,
        materials,
        operations,
    })
}

/// Reads cells; `count` is how many the document has so far.
fn read_cells(list: &Node<'_>, count: &mut usize, materials: usize) -> Result<Vec<CellSpec>, DocumentError> {
    let items = list.items()?;
    *count += items.len();
    list.check_count(*count, " cells up to here", 0..=MOST_CELLS)?;
    let mut cells = Vec::with_capacity(items.len());
    for item in &items {
        item.only(&["coefficients"])?;
        let list = item.need("coefficients")?;
        let items = list.items()?;
        list.check_count(items.len(), " coefficients", 64..=64)?;
        let mut coefficients = Vec::with_capacity(64);
        for item in &items {
            coefficients.push(coefficient(item, materials)?);
        }
        cells.push(CellSpec { coefficients });
    }
    Ok(cells)
}

/// Reads a coefficient; without a mix it is all of the first material.
fn coefficient(node: &Node<'_>, materials: usize) -> Result<CoefficientSpec, DocumentError> {
    node.only(&["position", "mix"])?;
    let list = node.need("position")?;
    let items = list.items()?;
    list.check_count(items.len(), " coordinates", 3..=3)?;
    let mut position = [0.0; 3];
    for (coordinate, item) in position.iter_mut().zip(&items) {
        *coordinate = item.within(-LARGEST_COORDINATE..=LARGEST_COORDINATE)?;
    }
    let Some(list) = node.get("mix")? else {
        return Ok(CoefficientSpec { position, mix: Composition::pure(0, materials).fractions().to_vec() });
    };
    let mix = numbers(&list)?;
    list.check_count(mix.len(), " fractions", materials..=materials)?;
    Ok(CoefficientSpec { position, mix })
}

/// A hyperpatch document with its body made.
#[derive(Debug, Clone)]
pub struct HyperpatchModel {
    document: HyperpatchDocument,
    materials: Vec<Material>,
    body: Body,
}

impl HyperpatchModel {
    /// Carries out the operations. Cells of any shape are taken: whether they are sound is for
    /// [`validity`](crate::hyperpatch::validity) to say, so that what is wrong can be shown.
    ///
    /// # Errors
    /// When a colour or a mix is not valid, with the path of the field.
    pub fn new(document: HyperpatchDocument) -> Result<Self, DocumentError> {
        let materials = build_materials(&document.materials)?;
        let mut body = Body::new(materials.len());
        for (n, OperationSpec::Cells { cells }) in document.operations.iter().enumerate() {
            for (k, spec) in cells.iter().enumerate() {
                let path = format!("operations[{n}].cells[{k}]");
                let fault = |e: String| DocumentError::new(Code::Range, path.clone(), e);
                let cell = build_cell(spec, &path)?;
                body.add(cell).map_err(|e| fault(e.to_string()))?;
            }
        }
        Ok(Self { document, materials, body })
    }

    /// The document.
    #[must_use]
    pub fn document(&self) -> &HyperpatchDocument {
        &self.document
    }

    /// The materials.
    #[must_use]
    pub fn materials(&self) -> &[Material] {
        &self.materials
    }

    /// The body.
    #[must_use]
    pub fn body(&self) -> &Body {
        &self.body
    }

    /// The document of a body as it is: all its cells by one operation. Identifiers start anew.
    #[must_use]
    pub fn document_of(
        title: String,
        unit: String,
        materials: Vec<MaterialSpec>,
        body: &Body,
    ) -> HyperpatchDocument {
        let coefficient = |cell: &Cell, at: usize| CoefficientSpec {
            position: cell.net().0[at].to_array(),
            mix: cell.mix(at).fractions().to_vec(),
        };
        let spec = |(_, cell): &(CellId, Cell)| CellSpec {
            coefficients: (0..64).map(|at| coefficient(cell, at)).collect(),
        };
        let cells: Vec<CellSpec> = body.cells().iter().map(spec).collect();
        let operations = if cells.is_empty() { Vec::new() } else { vec![OperationSpec::Cells { cells }] };
        HyperpatchDocument {
            directrix: 1,
            kind: HyperpatchKind::Hyperpatch,
            title,
            unit,
            materials,
            operations,
        }
    }
}

fn build_cell(spec: &CellSpec, path: &str) -> Result<Cell, DocumentError> {
    let mut points = [DVec3::ZERO; 64];
    let mut mixes = Vec::with_capacity(64);
    for (at, coefficient) in spec.coefficients.iter().take(64).enumerate() {
        points[at] = DVec3::from_array(coefficient.position);
        mixes.push(Composition::new(coefficient.mix.clone()).map_err(|e| {
            DocumentError::new(Code::Range, format!("{path}.coefficients[{at}].mix"), e.to_string())
        })?);
    }
    Cell::new(Net(points), &mixes)
        .map_err(|e| DocumentError::new(Code::Range, format!("{path}.coefficients"), e.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::validity::{Verdict, certify};
    use serde_json::{Value, json};

    fn cube() -> Value {
        let coefficient = |at: usize| json!({"position": [at / 16, at / 4 % 4, at % 4], "mix": [0.25, 0.75]});
        json!({"coefficients": (0..64).map(coefficient).collect::<Vec<_>>()})
    }

    fn minimal() -> Value {
        json!({"directrix": 1, "kind": "hyperpatch", "operations": [{"op": "cells", "cells": [cube()]}]})
    }

    fn model(value: &Value) -> Result<HyperpatchModel, DocumentError> {
        read_hyperpatch(&Json::from(value.clone())).and_then(HyperpatchModel::new)
    }

    fn expect(code: Code, path: &str, edit: impl FnOnce(&mut Value)) {
        let mut document = minimal();
        edit(&mut document);
        let error = model(&document).expect_err("refused");
        assert_eq!((error.code, error.path.as_str()), (code, path), "{}", error.message);
        assert!(!error.message.is_empty());
    }

    #[test]
    fn a_minimal_document_is_a_body() {
        let model = model(&minimal()).unwrap();
        assert_eq!((model.document().title.as_str(), model.document().unit.as_str()), ("Untitled", "mm"));
        assert_eq!(model.materials().len(), 2);
        let (id, cell) = &model.body().cells()[0];
        assert_eq!((*id, certify(cell.net()).verdict), (CellId(0), Verdict::Regular));
        assert!((model.body().volume() - 27.0).abs() < 1e-12);
        assert!((cell.composition(DVec3::splat(0.3)).fractions()[1] - 0.75).abs() < 1e-15);
        let empty = self::model(&json!({"directrix": 1, "kind": "hyperpatch", "operations": []})).unwrap();
        assert!(empty.body().cells().is_empty());
    }

    #[test]
    fn a_coefficient_without_a_mix_is_all_of_the_first_material() {
        let mut document = minimal();
        document["operations"][0]["cells"][0]["coefficients"][5] = json!({"position": [0, 1, 1]});
        assert_eq!(model(&document).unwrap().body().cells()[0].1.mix(5), Composition::pure(0, 2));
    }

    #[test]
    fn what_is_written_reads_back_as_the_same_body() {
        let mut document = minimal();
        document["operations"] =
            json!([{"op": "cells", "cells": [cube()]}, {"op": "cells", "cells": [cube(), cube()]}]);
        let model = model(&document).unwrap();
        let text = serde_json::to_string(model.document()).unwrap();
        assert_eq!(read_hyperpatch(&Json::parse(&text).unwrap()).as_ref(), Ok(model.document()));
        let materials = model.document().materials.clone();
        let again = HyperpatchModel::document_of("Copy".into(), "mm".into(), materials, model.body());
        assert_eq!(HyperpatchModel::new(again).unwrap().body(), model.body());
    }

    /// Documents merge by their bodies: the cells of the second come after those of the first.
    #[test]
    fn saved_bodies_merge() {
        let mut body = model(&minimal()).unwrap().body().clone();
        let ids = body.merge(model(&minimal()).unwrap().body()).unwrap();
        assert_eq!((ids, body.cells().len()), (vec![CellId(1)], 2));
    }

    #[test]
    fn wrong_documents_are_refused_with_the_path() {
        let first = "operations[0].cells[0].coefficients";
        expect(Code::Version, "directrix", |d| d["directrix"] = json!(2));
        expect(Code::Kind, "kind", |d| d["kind"] = json!("curves"));
        expect(Code::Missing, "operations", |d| {
            d.as_object_mut().unwrap().remove("operations");
        });
        expect(Code::UnknownField, "curves", |d| d["curves"] = json!([]));
        expect(Code::Range, "operations[0].op", |d| d["operations"][0]["op"] = json!("melt"));
        expect(Code::UnknownField, "operations[0].angle", |d| d["operations"][0]["angle"] = json!(3));
        expect(Code::Type, "operations[0].cells", |d| d["operations"][0]["cells"] = json!(3));
        expect(Code::Range, first, |d| {
            d["operations"][0]["cells"][0]["coefficients"].as_array_mut().unwrap().pop();
        });
        let at = |rest: &str| format!("{first}[17]{rest}");
        let edit = |field: &'static str, value: Value| {
            move |d: &mut Value| d["operations"][0]["cells"][0]["coefficients"][17][field] = value
        };
        expect(Code::Range, &at(".position"), edit("position", json!([1, 2])));
        expect(Code::Type, &at(".position[1]"), edit("position", json!([1, null, 2])));
        expect(Code::Range, &at(".position[2]"), edit("position", json!([1, 2, 2e9])));
        expect(Code::Range, &at(".mix"), edit("mix", json!([1])));
        expect(Code::Range, &at(".mix"), edit("mix", json!([0.5, 0.6])));
        expect(Code::Range, &at(".mix"), edit("mix", json!([-0.5, 1.5])));
        expect(Code::UnknownField, &at(".weight"), edit("weight", json!(1)));
        expect(Code::Range, "materials[0].color", |d| {
            d["materials"] = json!([{"name": "a", "color": "blue"}, {"name": "b", "color": "#000000"}])
        });
    }

    #[test]
    fn numbers_that_are_not_finite_are_refused() {
        let mut json = Json::from(minimal());
        let mut node = &mut json;
        for name in ["operations", "0", "cells", "0", "coefficients", "3", "position", "1"] {
            node = match node {
                Json::Object(fields) => &mut fields.iter_mut().find(|(key, _)| key == name).unwrap().1,
                Json::List(items) => &mut items[name.parse::<usize>().unwrap()],
                _ => unreachable!("the path leads through lists and objects"),
            };
        }
        *node = Json::Number(f64::NAN);
        let error = read_hyperpatch(&json).unwrap_err();
        assert_eq!(
            (error.code, error.path.as_str()),
            (Code::NonFinite, "operations[0].cells[0].coefficients[3].position[1]")
        );
    }

    #[test]
    fn more_cells_than_a_body_has_are_refused_before_they_are_read() {
        expect(Code::Limit, "operations[1].cells", |d| {
            let cells = vec![json!(null); MOST_CELLS];
            d["operations"] = json!([{"op": "cells", "cells": [cube()]}, {"op": "cells", "cells": cells}]);
        });
        expect(Code::Limit, "operations", |d| {
            d["operations"] = json!(vec![json!(null); MOST_OPERATIONS + 1])
        });
    }
}
