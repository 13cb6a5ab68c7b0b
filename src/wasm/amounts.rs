//! Unit cells, and how much of each material is in the band.

use super::engine::Engine;
use super::results::to_value;
use crate::document::{BandAmounts, CurvesDocument, Solution, amounts};
use crate::morph::{UnitCell, unit_cells};
use serde::Serialize;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

#[derive(Serialize)]
struct AmountsResult<'a> {
    unit: &'a str,
    area: f64,
    /// The area without what is empty space.
    body: f64,
    error: f64,
    materials: Vec<MaterialResult<'a>>,
    cells: CellsResult,
    /// Difference of the heights of the curves.
    rise: f64,
}

#[derive(Serialize)]
struct MaterialResult<'a> {
    name: &'a str,
    void: bool,
    amount: f64,
    share: f64,
}

#[derive(Serialize)]
struct CellsResult {
    area: f64,
    amounts: Vec<f64>,
    difference: f64,
    folded: usize,
}

#[derive(Serialize)]
struct CellResult {
    line: usize,
    stage: usize,
    corners: [[f64; 2]; 4],
    area: f64,
    centroid: [f64; 2],
    fractions: Vec<f64>,
    folded: bool,
}

#[wasm_bindgen]
impl Engine {
    /// Unit cells.
    pub fn cells(&mut self, text: &str) -> Result<JsValue, JsValue> {
        let solution = self.solve(text)?;
        #[cfg(feature = "harmonic")]
        super::engine::needs_lines(&solution, "cells")?;
        let document = solution.model.document();
        let segments = document.segments();
        #[cfg(feature = "stack")]
        if let Some(stack) = solution.stack() {
            let found = stack.blend.as_ref().map_or_else(Vec::new, |blend| {
                cells(blend.unit_cells(segments), document, segments * blend.spans())
            });
            return to_value(&found);
        }
        let of_band = |band| cells(unit_cells(band, segments), document, segments);
        to_value(&solution.band().map_or_else(Vec::new, of_band))
    }

    /// The area of the band and the amount of each material in it; null without a complete matching.
    pub fn amounts(&mut self, text: &str) -> Result<JsValue, JsValue> {
        let solution = self.solve(text)?;
        #[cfg(feature = "harmonic")]
        super::engine::needs_lines(&solution, "amounts")?;
        to_value(&amounts(&solution).map(|found| result(&solution, found)))
    }
}

fn result(solution: &Solution, found: BandAmounts) -> AmountsResult<'_> {
    let BandAmounts { exact, error, in_cells, folded } = found;
    let model = &solution.model;
    let materials = model.materials();
    let empty: f64 =
        exact.materials.iter().zip(materials).filter(|(_, of)| of.void).map(|(amount, _)| amount).sum();
    let share = |amount: f64| if exact.area > 0.0 { amount / exact.area } else { 0.0 };
    AmountsResult {
        unit: &model.document().unit,
        area: exact.area,
        body: exact.area - empty,
        error,
        materials: materials
            .iter()
            .zip(&exact.materials)
            .map(|(of, &amount)| MaterialResult {
                name: &of.name,
                void: of.void,
                amount,
                share: share(amount),
            })
            .collect(),
        cells: CellsResult {
            area: in_cells.area,
            difference: in_cells.difference(&exact),
            amounts: in_cells.materials,
            folded,
        },
        rise: model.gap(),
    }
}

/// Unit cells, each with the lower of the numbers of the stages beside it; `segments` is the number of the last stage.
fn cells(cells: Vec<UnitCell>, document: &CurvesDocument, segments: usize) -> Vec<CellResult> {
    let convert = |cell: UnitCell| CellResult {
        line: cell.line,
        stage: if document.counts_stages_back() { segments - 1 - cell.stage } else { cell.stage },
        corners: cell.corners.map(|corner| corner.to_array()),
        area: cell.area,
        centroid: cell.centroid.to_array(),
        fractions: cell.composition.fractions().to_vec(),
        folded: cell.is_folded,
    };
    cells.into_iter().map(convert).collect()
}
