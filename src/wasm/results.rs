//! Results as they go out: plain objects of the shapes in `docs/api.md`.

use crate::document::{Diagnostic, DocumentError, Outcome, Solution};
use crate::matching::{Matching, Problem, RulingLine};
use crate::morph::{Band, Place, UnitCell, unit_cells};
use crate::picture::Viewport;
use glam::DVec2;
use serde::Serialize;

#[derive(Serialize)]
pub(super) struct MatchResult {
    ok: bool,
    diagnostics: Vec<DiagnosticResult>,
    reversed: [bool; 2],
    samples: Vec<SamplesResult>,
    lines: Vec<LineResult>,
    pairs: [(); 0],
    reparameterisation: Vec<[f64; 2]>,
    totals: TotalsResult,
}

#[derive(Serialize)]
struct SamplesResult {
    parameters: Vec<f64>,
    points: Vec<[f64; 2]>,
    normals: Vec<[f64; 2]>,
}

#[derive(Serialize)]
struct LineResult {
    from: usize,
    to: usize,
    value: f64,
    visible: bool,
}

#[derive(Serialize)]
struct TotalsResult {
    lines: Option<LineTotals>,
    pairs: Option<LineTotals>,
}

#[derive(Serialize)]
struct LineTotals {
    count: usize,
    sum: f64,
    mean: Option<f64>,
    integral: Option<f64>,
    eta: Option<f64>,
    crossings: usize,
    blocked: usize,
    uncovered: [Vec<usize>; 2],
}

#[derive(Serialize)]
struct DiagnosticResult {
    code: &'static str,
    message: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    curve: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    vertices: Option<Vec<usize>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    lines: Option<Vec<usize>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    parameter: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    turn: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    at: Option<[f64; 2]>,
}

/// A view: the point in the middle and the scale in CSS pixels per unit.
#[derive(Serialize)]
pub(super) struct ViewResult {
    center: [f64; 2],
    scale: f64,
}

#[derive(Serialize)]
pub(super) struct StageResult {
    s: f64,
    points: Vec<[f64; 2]>,
}

#[derive(Serialize)]
pub(super) struct CellResult {
    line: usize,
    stage: usize,
    corners: [[f64; 2]; 4],
    fractions: Vec<f64>,
}

#[derive(Serialize)]
pub(super) struct ProbeResult {
    line: usize,
    s: f64,
    u: f64,
    v: f64,
    at: [f64; 2],
    fractions: Vec<f64>,
    value: f64,
    cosine: f64,
    length: f64,
    from: [f64; 2],
    to: [f64; 2],
}

impl MatchResult {
    /// The result of a solved document.
    ///
    /// # Errors
    /// When the curves meet themselves or each other.
    pub(super) fn new(solution: &Solution) -> Result<Self, DocumentError> {
        let matched = match &solution.outcome {
            Outcome::Refused(error) => return Err(error.clone()),
            Outcome::Unmatched => None,
            Outcome::Matched { problem, matching, .. } => Some((problem, matching)),
        };
        let model = &solution.model;
        Ok(Self {
            ok: solution.is_complete(),
            diagnostics: solution.diagnostics.iter().map(DiagnosticResult::from).collect(),
            reversed: model.reversed(),
            samples: model
                .samples()
                .iter()
                .map(|samples| SamplesResult {
                    parameters: samples.parameters.clone(),
                    points: pairs(&samples.points),
                    normals: pairs(&samples.normals),
                })
                .collect(),
            lines: matched.map_or_else(Vec::new, |(problem, matching)| lines(problem, matching)),
            pairs: [],
            reparameterisation: solution
                .band()
                .map_or_else(Vec::new, |band| band.lines().map(|ruling| [ruling.u, ruling.v]).collect()),
            totals: TotalsResult { lines: matched.map(|(_, matching)| line_totals(matching)), pairs: None },
        })
    }
}

fn lines(problem: &Problem, matching: &Matching) -> Vec<LineResult> {
    let visible = |line: &RulingLine| problem.is_visible(line.from, line.to);
    matching
        .lines
        .iter()
        .map(|line| LineResult { from: line.from, to: line.to, value: line.value, visible: visible(line) })
        .collect()
}

fn line_totals(matching: &Matching) -> LineTotals {
    let totals = matching.totals.clone();
    LineTotals {
        count: totals.count,
        sum: totals.sum,
        mean: totals.mean,
        integral: totals.integral,
        eta: totals.eta,
        crossings: totals.crossings,
        blocked: totals.blocked,
        uncovered: totals.uncovered,
    }
}

impl From<&Diagnostic> for DiagnosticResult {
    fn from(diagnostic: &Diagnostic) -> Self {
        let mut result = Self {
            code: diagnostic.code(),
            message: diagnostic.to_string(),
            curve: None,
            vertices: None,
            lines: None,
            parameter: None,
            turn: None,
            at: None,
        };
        match diagnostic {
            Diagnostic::Corner { curve, parameter, at, turn } => {
                result.curve = Some(*curve);
                result.parameter = Some(*parameter);
                result.turn = Some(*turn);
                result.at = Some(at.to_array());
            }
            Diagnostic::OpposedNormals { lines } => result.lines = Some(lines.clone()),
            Diagnostic::Orphan { curve, vertices } | Diagnostic::Stuck { curve, vertices } => {
                result.curve = Some(*curve);
                result.vertices = Some(vertices.clone());
            }
            Diagnostic::Disjoint => {}
            Diagnostic::Crossing { at } => result.at = Some(at.to_array()),
            Diagnostic::CoarseSampling { at } => result.at = at.map(|at| at.to_array()),
        }
        result
    }
}

impl From<Viewport> for ViewResult {
    fn from(viewport: Viewport) -> Self {
        Self { center: viewport.center.to_array(), scale: viewport.scale / viewport.pixel_ratio }
    }
}

/// Stages j = 0 to M of a band, at s = j / M.
pub(super) fn stages(band: &Band, stages: usize) -> Vec<StageResult> {
    (0..=stages)
        .map(|j| {
            let s = j as f64 / stages as f64;
            StageResult { s, points: pairs(&band.in_between(s)) }
        })
        .collect()
}

/// Unit cells of a band.
pub(super) fn cells(band: &Band, stages: usize) -> Vec<CellResult> {
    let convert = |cell: UnitCell| CellResult {
        line: cell.line,
        stage: cell.stage,
        corners: cell.corners.map(|corner| corner.to_array()),
        fractions: cell.composition.fractions().to_vec(),
    };
    unit_cells(band, stages).into_iter().map(convert).collect()
}

/// What the band holds at a point, and the nearest ruling line; `None` outside the band or without one.
pub(super) fn probe(solution: &Solution, at: DVec2) -> Option<ProbeResult> {
    let Outcome::Matched { problem, matching, band: Some(band) } = &solution.outcome else { return None };
    let Place { line, s, u, v, composition } = band.locate(at)?;
    let ruling = matching.lines.get(line)?;
    let [first, second] = problem.outlines();
    Some(ProbeResult {
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
    })
}

fn pairs(points: &[DVec2]) -> Vec<[f64; 2]> {
    points.iter().map(|point| point.to_array()).collect()
}
