//! What is told of a place in a figure.

use crate::document::Solution;
use crate::matching::{Problem, RulingLine};
use crate::morph::Place;
use glam::DVec2;
use serde::Serialize;

#[derive(Serialize)]
pub(super) struct ProbeResult {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) span: Option<usize>,
    pub(super) line: usize,
    pub(super) s: f64,
    pub(super) u: f64,
    pub(super) v: f64,
    pub(super) at: [f64; 2],
    pub(super) fractions: Vec<f64>,
    pub(super) value: f64,
    pub(super) cosine: f64,
    pub(super) length: f64,
    pub(super) from: [f64; 2],
    pub(super) to: [f64; 2],
    /// Of the potential of a harmonic blend.
    #[cfg(feature = "harmonic")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) gradient: Option<[f64; 2]>,
}

/// What the band holds at a point, and the nearest ruling line; `None` outside the band or without one.
pub(super) fn probe(solution: &Solution, at: DVec2) -> Option<ProbeResult> {
    #[cfg(feature = "stack")]
    if let Some(stack) = solution.stack() {
        return super::stack::probe(stack, at);
    }
    let (band, (problem, lines, _)) = (solution.band()?, solution.lines()?);
    let place = band.locate(at)?;
    probed(problem, lines, place, at)
}

/// What is told of a place and of the ruling line next to it.
pub(super) fn probed(
    problem: &Problem,
    lines: &[RulingLine],
    place: Place,
    at: DVec2,
) -> Option<ProbeResult> {
    let Place { line, s, u, v, composition } = place;
    let ruling = lines.get(line)?;
    let [first, second] = problem.outlines();
    Some(ProbeResult {
        span: None,
        line,
        s,
        u,
        v,
        at: at.to_array(),
        fractions: composition.fractions().to_vec(),
        value: ruling.value,
        cosine: problem.cosine(ruling.from, ruling.to),
        length: problem.length(ruling.from, ruling.to),
        from: first.points[ruling.from].to_array(),
        to: second.points[ruling.to].to_array(),
        #[cfg(feature = "harmonic")]
        gradient: None,
    })
}
