//! A hyperpatch document with its body made.

use super::super::{DocumentError, MaterialSpec};
use super::action::{Action, Operation};
use super::cells::CellSpec;
use super::replay::Replay;
use super::stage::Stage;
use super::{HyperpatchDocument, HyperpatchHead};
use crate::hyperpatch::composite::Body;
use crate::material::Material;
use std::rc::Rc;
use std::sync::Arc;

/// A hyperpatch document with its body made, and with what came of each operation.
#[derive(Debug, Clone)]
pub struct HyperpatchModel {
    document: HyperpatchDocument,
    materials: Vec<Material>,
    body: Body,
    stages: Vec<Rc<Stage>>,
}

impl HyperpatchModel {
    /// Carries out the operations; those that do not apply are passed over, and [`HyperpatchModel::stages`] say why. Cells of any shape
    /// are taken: whether they are sound is for [`validity`](crate::hyperpatch::validity) to say, so that what is wrong can be shown.
    ///
    /// # Errors
    /// When a colour is not valid, with the path of the field.
    pub fn new(document: HyperpatchDocument) -> Result<Self, DocumentError> {
        Ok(Replay::new(document, [])?.run())
    }

    /// As [`HyperpatchModel::new`], with what models of documents that begin alike have in common with it.
    ///
    /// # Errors
    /// As there.
    pub fn after<'a>(
        document: HyperpatchDocument,
        before: impl IntoIterator<Item = &'a Self>,
    ) -> Result<Self, DocumentError> {
        Ok(Replay::new(document, before)?.run())
    }

    pub(super) fn of(
        document: HyperpatchDocument,
        materials: Vec<Material>,
        body: Body,
        stages: Vec<Rc<Stage>>,
    ) -> Self {
        Self { document, materials, body, stages }
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

    /// What came of each operation, in their order.
    #[must_use]
    pub fn stages(&self) -> &[Rc<Stage>] {
        &self.stages
    }

    /// The document of a body as it is: all its cells by one operation. Identifiers start anew.
    #[must_use]
    pub fn document_of(
        title: String,
        unit: String,
        materials: Vec<MaterialSpec>,
        body: &Body,
    ) -> HyperpatchDocument {
        let cells: Vec<CellSpec> = body.cells().iter().map(|(_, cell)| CellSpec(cell.clone())).collect();
        let operation = Operation { id: None, action: Action::Cells { cells }, materials: body.materials() };
        let operations = if body.cells().is_empty() { Vec::new() } else { vec![(0, Arc::new(operation))] };
        HyperpatchDocument {
            directrix: 1,
            kind: super::HyperpatchKind::Hyperpatch,
            head: HyperpatchHead { title, unit, materials },
            operations,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::read_hyperpatch;
    use super::*;
    use crate::document::{Code, Json};
    use crate::hyperpatch::composite::{CellId, MOST_CELLS};
    use crate::hyperpatch::validity::{Verdict, certify};
    use crate::material::Composition;
    use glam::DVec3;
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
        assert_eq!(
            (model.document().head.title.as_str(), model.document().head.unit.as_str()),
            ("Untitled", "mm")
        );
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
        document["operations"] = json!([{"op": "cells", "cells": [cube(), cube(), cube()]}]);
        let model = model(&document).unwrap();
        let text = serde_json::to_string(model.document()).unwrap();
        let again = read_hyperpatch(&Json::parse(&text).unwrap()).unwrap();
        assert_eq!(serde_json::to_string(&again).unwrap(), text);
        assert_eq!(HyperpatchModel::new(again).unwrap().body(), model.body());
        let materials = model.document().head.materials.clone();
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
        expect(Code::Limit, "operations", |d| d["operations"] = json!(vec![json!(null); 10_001]));
    }
}
