//! How much of each material is in the band.

use super::engine::Engine;
use super::results::to_value;
use crate::document::{BandAmounts, Solution, amounts};
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

#[wasm_bindgen]
impl Engine {
    /// The area of the band and the amount of each material in it; null without a complete matching.
    pub fn amounts(&mut self, text: &str) -> Result<JsValue, JsValue> {
        let solution = self.solve(text)?;
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
