//! Why a ruling line and not another.

use super::engine::Engine;
use super::results::to_value;
use crate::document::{Outcome, Solution};
use crate::matching::{Fate, Rival, RulingLine, standings};
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
    /// Index of the sample at the other end, or of the pair that ends there.
    other: usize,
    value: f64,
    fate: &'static str,
    line: Option<usize>,
}

#[wasm_bindgen]
impl Engine {
    /// A ruling line with the parts of its value and its rivals at both ends; null where there is no such line.
    pub fn explain(&mut self, text: &str, line: usize) -> Result<JsValue, JsValue> {
        let solution = self.solve_pair(text, "explain")?;
        to_value(&explain(&solution, line))
    }
}

fn explain(solution: &Solution, line: usize) -> Option<ExplainResult> {
    let (problem, lines, _) = solution.lines()?;
    let RulingLine { from, to, value, .. } = *lines.get(line)?;
    let [first, second] = problem.outlines();
    let places = |line: &RulingLine| (first.points[line.from].to_array(), second.points[line.to].to_array());
    // Lines with ends of their own are compared with those to the ends of the others: their outlines have more vertices than anyone asked for.
    let is_one_to_one = matches!(solution.outcome, Outcome::Matched { pairs: Some(_), .. });
    let (a, b) = problem.counts();
    let others = if is_one_to_one {
        [lines.iter().map(|line| line.from).collect(), lines.iter().map(|line| line.to).collect()]
    } else {
        [(0..a).collect(), (0..b).collect::<Vec<usize>>()]
    };
    let name = |end: usize, rival: &RulingLine| {
        let vertex = [rival.to, rival.from][end];
        let ends_there = |line: &RulingLine| [line.to, line.from][end] == vertex;
        if is_one_to_one { lines.iter().position(ends_there).unwrap_or(vertex) } else { vertex }
    };
    let standings = standings(problem, lines, line, others.each_ref().map(Vec::as_slice), RIVALS)?;
    let ends = standings.into_iter().enumerate().map(|(end, standing)| EndResult {
        rank: standing.rank,
        visible: standing.visible,
        rivals: standing
            .rivals
            .iter()
            .map(|Rival { line: rival, fate }| {
                let (from, to) = places(rival);
                let (fate, line) = match *fate {
                    Fate::Taken => ("taken", None),
                    Fate::Blocked => ("blocked", None),
                    Fate::Crosses(line) => ("crosses", Some(line)),
                    Fate::Free => ("free", None),
                };
                RivalResult { from, to, other: name(end, rival), value: rival.value, fate, line }
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
