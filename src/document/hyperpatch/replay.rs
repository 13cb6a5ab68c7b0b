//! The job that carries out the operations of a document.

use super::super::model::materials as build_materials;
use super::apply::apply;
use super::stage::{OperationRow, Stage};
use super::{HyperpatchDocument, HyperpatchModel};
use crate::document::DocumentError;
use crate::hyperpatch::composite::Body;
use crate::hyperpatch::operation::Change;
use crate::material::Material;
use std::cell::RefCell;
use std::rc::Rc;

/// Stages before the last one that all keep their bodies; farther back ever fewer do.
const KEPT: usize = 32;

/// The job that carries out the operations of a document, one after the other, from the last body that is known on.
#[derive(Debug)]
pub struct Replay {
    document: HyperpatchDocument,
    materials: Vec<Material>,
    stages: Vec<Rc<Stage>>,
    body: Body,
    /// Number of operations that the body has gone through.
    done: usize,
}

impl Replay {
    /// The job for a document. What models of documents that begin alike have in common with it is taken over.
    ///
    /// # Errors
    /// When a colour is not valid, with the path of the field.
    pub fn new<'a>(
        document: HyperpatchDocument,
        before: impl IntoIterator<Item = &'a HyperpatchModel>,
    ) -> Result<Self, DocumentError> {
        let materials = build_materials(&document.head.materials)?;
        let is_alike = |model: &&HyperpatchModel| model.body().materials() == materials.len();
        let common = |model: &'a HyperpatchModel| {
            let pairs = model.stages().iter().zip(&document.operations);
            &model.stages()[..pairs.take_while(|(stage, (id, made))| stage.is_of(*id, made)).count()]
        };
        let stages = before.into_iter().filter(is_alike).map(common).max_by_key(|stages| stages.len());
        let stages = stages.unwrap_or_default().to_vec();
        let known = |(n, stage): (usize, &Rc<Stage>)| Some((n + 1, stage.body.borrow().clone()?));
        let start = stages.iter().enumerate().rev().find_map(known);
        let (done, body) = start.unwrap_or_else(|| (0, Body::new(materials.len())));
        Ok(Self { document, materials, stages, body, done })
    }

    /// Share of the work that is done, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.done as f64 / self.document.operations.len().max(1) as f64
    }

    /// Advances while `may_go_on` says so, by one operation at least; tells whether all are carried out.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> bool {
        while let Some((id, operation)) = self.document.operations.get(self.done) {
            let outcome = apply(&mut self.body, *id, &operation.action);
            self.done += 1;
            let kept = is_kept(self.done, self.document.operations.len()).then(|| self.body.clone());
            if let Some(stage) = self.stages.get(self.done - 1) {
                *stage.body.borrow_mut() = kept;
            } else {
                let (reason, change) = match outcome {
                    Ok(change) => (None, change),
                    Err(error) => (Some(error.to_string()), Change::default()),
                };
                let row = OperationRow {
                    id: *id,
                    op: operation.action.kind(),
                    reason,
                    touched: change.touched,
                    made: change.made,
                    removed: change.removed,
                };
                let (operation, body) = (operation.clone(), RefCell::new(kept));
                self.stages.push(Rc::new(Stage { id: *id, operation, row, body }));
            }
            if !may_go_on() {
                break;
            }
        }
        self.done >= self.document.operations.len()
    }

    /// Runs the job to its end.
    #[must_use]
    pub fn run(mut self) -> HyperpatchModel {
        while !self.step(&mut || true) {}
        self.finish()
    }

    /// The model, once all operations are carried out.
    #[must_use]
    pub fn finish(self) -> HyperpatchModel {
        for (n, stage) in self.stages.iter().enumerate() {
            if !is_kept(n + 1, self.stages.len()) {
                stage.body.take();
            }
        }
        HyperpatchModel::of(self.document, self.materials, self.body, self.stages)
    }
}

/// Whether the body after so many operations is kept, of `count`: the last ones, and of those farther back the more of them the nearer they
/// are, so that no way to a body is longer than a few operations or a share of the way back.
fn is_kept(done: usize, count: usize) -> bool {
    let back = count.saturating_sub(done) / KEPT;
    back == 0 || done.is_multiple_of(back.next_power_of_two())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Json, read_hyperpatch};
    use crate::hyperpatch::composite::CellId;
    use serde_json::{Value, json};

    /// Cubes in a row along x, of one material.
    fn row(count: usize) -> Value {
        let cell = |n: usize| {
            let coefficient =
                |at: usize| json!({"position": [3 * n + at / 16, at / 4 % 4, at % 4], "mix": [1]});
            json!({"coefficients": (0..64).map(coefficient).collect::<Vec<_>>()})
        };
        json!({"op": "cells", "cells": (0..count).map(cell).collect::<Vec<_>>()})
    }

    fn document(operations: &[Value]) -> HyperpatchDocument {
        let materials = json!([{"name": "a", "color": "#000000"}]);
        let value =
            json!({"directrix": 1, "kind": "hyperpatch", "materials": materials, "operations": operations});
        read_hyperpatch(&Json::from(value)).unwrap()
    }

    fn made(operations: &[Value]) -> HyperpatchModel {
        HyperpatchModel::new(document(operations)).unwrap()
    }

    fn moved(cell: u32, by: f64) -> Value {
        json!({"op": "move", "cell": cell, "at": [3, 3, 3], "by": [by, 0, 0]})
    }

    fn common(a: &HyperpatchModel, b: &HyperpatchModel) -> usize {
        a.stages().iter().zip(b.stages()).take_while(|(a, b)| Rc::ptr_eq(a, b)).count()
    }

    #[test]
    fn operations_are_carried_out_in_order_and_cells_numbered_by_them() {
        let model =
            made(&[row(2), moved(1, 0.5), row(1), json!({"op": "delete", "cells": [0], "id": 7}), row(1)]);
        let ids: Vec<u32> = model.body().cells().iter().map(|(id, _)| id.0).collect();
        assert_eq!(ids, [1, 20_000, 80_000], "the last one follows number 7");
        assert_eq!(model.body().cell(CellId(1)).unwrap().net().0[63].x, 6.5);
        let rows: Vec<_> = model.stages().iter().map(|stage| stage.row().clone()).collect();
        assert_eq!(rows[0].made, [CellId(0), CellId(1)]);
        assert_eq!((&rows[1].touched[..], &rows[3].removed[..]), (&[CellId(1)][..], &[CellId(0)][..]));
        assert!(rows.iter().all(|row| row.reason.is_none()));
    }

    /// What does not apply is passed over, and says why; the rest goes on as if it were not there.
    #[test]
    fn an_operation_that_does_not_apply_is_passed_over() {
        let gone = json!({"op": "delete", "cells": [0]});
        let model = made(&[row(2), gone.clone(), moved(0, 0.5), moved(1, 0.5)]);
        let reason = model.stages()[2].row().reason.as_deref();
        assert!(reason.is_some_and(|reason| reason.contains("no cell 0")), "{reason:?}");
        assert_eq!(model.body(), made(&[row(2), gone, moved(1, 0.5)]).body());
        let cell = |model: &HyperpatchModel| model.body().cell(CellId(0)).cloned();
        let upstream = made(&[row(2), moved(0, 0.5), moved(1, 0.5)]);
        assert!(cell(&upstream).is_some(), "without the deletion it applies");
    }

    /// A document that begins like a known one costs what comes after, and has the body that it has alone.
    #[test]
    fn what_documents_begin_with_is_made_once() {
        let base = [row(3), moved(1, 0.25), moved(2, 0.25)];
        let first = made(&base);
        let mut longer = base.to_vec();
        longer.push(moved(0, 0.5));
        let second = HyperpatchModel::after(document(&longer), [&first]).unwrap();
        assert_eq!((common(&first, &second), second.stages().len()), (3, 4));
        assert_eq!(second.body(), made(&longer).body());
        // Another last operation, and none: the body is the same to the last bit.
        longer[3] = moved(0, 0.75);
        let third = HyperpatchModel::after(document(&longer), [&second, &first]).unwrap();
        assert_eq!((common(&second, &third), third.body()), (3, made(&longer).body()));
        let undone = HyperpatchModel::after(document(&base), [&third]).unwrap();
        assert_eq!((common(&undone, &first), undone.body()), (3, first.body()));
        // A change upstream.
        longer[1] = moved(1, 0.0);
        let upstream = HyperpatchModel::after(document(&longer), [&third]).unwrap();
        assert_eq!((common(&upstream, &third), upstream.body()), (1, made(&longer).body()));
        // An untouched cell is shared, not copied.
        let shape = |model: &HyperpatchModel| std::ptr::from_ref(model.body().cell(CellId(2)).unwrap().net());
        assert_eq!(shape(&second), shape(&third));
    }

    /// Of long lists few bodies are kept, and going back any way leads to the body that the list has alone.
    #[test]
    fn going_back_far_leads_to_the_same_body() {
        let list: Vec<Value> = std::iter::once(row(2)).chain((0..600).map(|n| moved(n % 2, 1e-3))).collect();
        let whole = made(&list);
        let kept = whole.stages().iter().filter(|stage| stage.body.borrow().is_some()).count();
        assert!(kept < 200, "{kept} bodies");
        for count in [600, 599, 570, 500, 301, 64, 3, 1, 0] {
            let back = HyperpatchModel::after(document(&list[..count]), [&whole]).unwrap();
            assert_eq!((common(&back, &whole), back.body()), (count, made(&list[..count]).body()), "{count}");
        }
    }

    /// Materials may be named and coloured anew at no cost; another number of them makes another body.
    #[test]
    fn materials_count() {
        let base = [row(1), moved(0, 0.25)];
        let first = made(&base);
        let mut painted = document(&base);
        painted.head.materials[0].color = "#ff0000".to_owned();
        assert_eq!(common(&HyperpatchModel::after(painted, [&first]).unwrap(), &first), 2);
        let mut wrong = document(&base);
        wrong.head.materials[0].color = "red".to_owned();
        assert_eq!(HyperpatchModel::new(wrong).unwrap_err().path, "materials[0].color");
    }

    #[test]
    fn steps_are_short_and_lead_to_the_same_body() {
        let list: Vec<Value> = std::iter::once(row(2)).chain((0..20).map(|_| moved(0, 0.01))).collect();
        let mut replay = Replay::new(document(&list), []).unwrap();
        let (mut steps, mut last) = (1, 0.0);
        while !replay.step(&mut || false) {
            assert!(replay.progress() > last);
            last = replay.progress();
            steps += 1;
        }
        assert_eq!((steps, replay.finish().body()), (21, made(&list).body()));
    }
}
