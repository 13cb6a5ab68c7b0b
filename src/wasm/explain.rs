//! Why a ruling line and not another.

use super::engine::Engine;
use super::results::to_value;
use crate::document::Solution;
use crate::matching::{Fate, RulingLine, standings};
use serde::Serialize;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

/// Other lines that are told of at each end.
const RIVALS: usize = 4;

#[derive(Serialize)]
struct ExplainResult {
    line: usize,
    from: [f64; 2],
    to: [f64; 2],
    value: f64,
    cosine: f64,
    length: f64,
    alignment: f64,
    /// Of the normals, of the length and of the alignment.
    factors: [f64; 3],
    ends: Vec<EndResult>,
}

#[derive(Serialize)]
struct EndResult {
    rank: Option<usize>,
    visible: usize,
    rivals: Vec<RivalResult>,
}

#[derive(Serialize)]
struct RivalResult {
    from: [f64; 2],
    to: [f64; 2],
    value: f64,
    fate: &'static str,
    line: Option<usize>,
}

#[wasm_bindgen]
impl Engine {
    /// A ruling line with the parts of its value and its rivals at both ends; null where there is no such line.
    pub fn explain(&mut self, text: &str, line: usize) -> Result<JsValue, JsValue> {
        let solution = self.solve(text)?;
        to_value(&explain(&solution, line))
    }
}

fn explain(solution: &Solution, line: usize) -> Option<ExplainResult> {
    let (problem, lines, _) = solution.lines()?;
    let RulingLine { from, to, value, .. } = *lines.get(line)?;
    let [first, second] = problem.outlines();
    let places = |line: &RulingLine| (first.points[line.from].to_array(), second.points[line.to].to_array());
    let ends = standings(problem, lines, line, RIVALS)?.into_iter().map(|standing| EndResult {
        rank: standing.rank,
        visible: standing.visible,
        rivals: standing
            .rivals
            .iter()
            .map(|rival| {
                let (from, to) = places(&rival.line);
                let (fate, line) = match rival.fate {
                    Fate::Taken => ("taken", None),
                    Fate::Blocked => ("blocked", None),
                    Fate::Crosses(line) => ("crosses", Some(line)),
                    Fate::Free => ("free", None),
                };
                RivalResult { from, to, value: rival.line.value, fate, line }
            })
            .collect(),
    });
    let (start, end) = places(&lines[line]);
    Some(ExplainResult {
        line,
        from: start,
        to: end,
        value,
        cosine: problem.cosine(from, to),
        length: problem.length(from, to),
        alignment: problem.alignment(from, to),
        factors: problem.factors(from, to),
        ends: ends.collect(),
    })
}
