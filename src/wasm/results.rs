//! Results as they go out: plain objects of the shapes in `docs/api.md`.

use super::diagnostic::DiagnosticResult;
#[cfg(feature = "harmonic")]
use super::harmonic::HarmonicSummary;
#[cfg(feature = "solid")]
use crate::document::Model;
use crate::document::{CurvesDocument, DocumentError, Gap, GapKind, IsoOptions, Outcome, Solution};
use crate::matching::{Details, Matching, OneToOne, Problem, RulingLine, Totals};
use crate::morph::{Band, IsoLine};
use crate::picture::Viewport;
use glam::DVec2;
use serde::Serialize;
use wasm_bindgen::prelude::JsValue;

#[derive(Serialize)]
pub(super) struct MatchResult {
    ok: bool,
    diagnostics: Vec<DiagnosticResult>,
    reversed: Vec<bool>,
    samples: Vec<SamplesResult>,
    lines: Vec<LineResult>,
    pairs: Vec<PairResult>,
    reparameterisation: Vec<[f64; 2]>,
    totals: TotalsResult,
    gap: Option<f64>,
    #[serde(rename = "gapKind")]
    gap_kind: Option<&'static str>,
    optimum: Option<f64>,
    #[serde(rename = "optimumChange")]
    optimum_change: Option<f64>,
    coarse: bool,
    /// Of a stack, the result of every span, the place s of every curve, and the parameters of every thread on every curve.
    #[cfg(feature = "stack")]
    #[serde(skip_serializing_if = "Option::is_none")]
    spans: Option<Vec<MatchResult>>,
    #[cfg(feature = "stack")]
    #[serde(skip_serializing_if = "Option::is_none")]
    knots: Option<Vec<f64>>,
    #[cfg(feature = "stack")]
    #[serde(skip_serializing_if = "Option::is_none")]
    threads: Option<Vec<Vec<f64>>>,
    #[cfg(feature = "solid")]
    #[serde(skip_serializing_if = "Option::is_none")]
    projection: Option<ProjectionResult>,
    #[cfg(feature = "harmonic")]
    #[serde(skip_serializing_if = "Option::is_none")]
    harmonic: Option<HarmonicSummary>,
}

/// How curves in space are seen in the plane.
#[cfg(feature = "solid")]
#[derive(Serialize)]
pub(super) struct ProjectionResult {
    origin: [f64; 3],
    normal: [f64; 3],
    axes: [[f64; 3]; 2],
    heights: Vec<f64>,
    deviation: f64,
    assumed: String,
}

#[derive(Serialize)]
pub(super) struct SamplesResult {
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
struct PairResult {
    u: f64,
    v: f64,
    value: f64,
    verified: bool,
    from: [f64; 2],
    to: [f64; 2],
}

#[derive(Serialize)]
pub(super) struct TotalsResult {
    pub(super) growth: Option<GrowthTotals>,
    pub(super) lines: Option<LineTotals>,
    pub(super) pairs: Option<LineTotals>,
}

/// The lines that the growth accepted, before redundant ones are removed.
#[derive(Serialize)]
pub(super) struct GrowthTotals {
    pub(super) count: usize,
    pub(super) sum: f64,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct LineTotals {
    pub(super) count: usize,
    pub(super) sum: f64,
    pub(super) mean: Option<f64>,
    pub(super) integral: Option<f64>,
    pub(super) bound: Option<f64>,
    pub(super) eta: Option<f64>,
    pub(super) spread_sum: Option<f64>,
    pub(super) least_cosine: Option<f64>,
    pub(super) longest: Option<f64>,
    pub(super) crossings: usize,
    pub(super) blocked: usize,
    pub(super) uncovered: [Vec<usize>; 2],
}

/// A view: the point in the middle and the scale in CSS pixels per unit.
#[derive(Serialize)]
pub(super) struct ViewResult {
    center: [f64; 2],
    scale: f64,
}

#[derive(Serialize)]
pub(super) struct StageResult {
    pub(super) s: f64,
    pub(super) points: Vec<[f64; 2]>,
}

impl MatchResult {
    /// The result of a solved document.
    ///
    /// # Errors
    /// When the curves meet themselves or each other.
    pub(super) fn new(solution: &Solution) -> Result<Self, DocumentError> {
        let matched = match &solution.outcome {
            Outcome::Refused(error) => return Err(error.clone()),
            Outcome::Matched { problem, matching, pairs, gap, details, .. } => {
                Some((&**problem, &**matching, pairs.as_deref(), (gap, details)))
            }
            _ => None,
        };
        #[cfg(feature = "stack")]
        let stack = solution.stack();
        let pairs = matched.and_then(|(_, _, pairs, _)| pairs);
        let gap = matched.and_then(|(.., (gap, _))| gap.as_ref());
        let details = matched.map_or([None, None], |(.., (_, details))| *details);
        let model = &solution.model;
        Ok(Self {
            ok: solution.is_complete(),
            diagnostics: solution.diagnostics.iter().map(DiagnosticResult::from).collect(),
            reversed: model.reversed().to_vec(),
            samples: model
                .samples()
                .iter()
                .map(|samples| SamplesResult {
                    parameters: samples.parameters.clone(),
                    points: arrays(&samples.points),
                    normals: arrays(&samples.normals),
                })
                .collect(),
            lines: matched.map_or_else(Vec::new, |(problem, matching, ..)| lines(problem, matching)),
            pairs: pairs.map_or_else(Vec::new, pair_results),
            reparameterisation: solution
                .band()
                .map_or_else(Vec::new, |band| band.lines().map(|ruling| [ruling.u, ruling.v]).collect()),
            #[cfg(feature = "stack")]
            totals: match stack {
                Some(stack) => super::stack::totals(stack),
                None => totals(matched, pairs, details),
            },
            #[cfg(not(feature = "stack"))]
            totals: totals(matched, pairs, details),
            gap: gap.map(|gap| gap.value),
            gap_kind: gap.map(|gap| match gap.kind {
                GapKind::Refined => "refined",
                GapKind::Supremum => "supremum",
                GapKind::Lattice => "lattice",
            }),
            optimum: gap.map(|gap| gap.optimum),
            optimum_change: gap.and_then(|gap| gap.change),
            coarse: solution.is_coarse,
            #[cfg(feature = "stack")]
            spans: stack.map(super::stack::spans).transpose()?,
            #[cfg(feature = "stack")]
            knots: stack.map(super::stack::knots),
            #[cfg(feature = "stack")]
            threads: stack.map(super::stack::threads),
            #[cfg(feature = "solid")]
            projection: ProjectionResult::of(model),
            #[cfg(feature = "harmonic")]
            harmonic: solution.harmonic().map(|harmonic| HarmonicSummary::new(&harmonic.blend)),
        })
    }
}

type Matched<'a> =
    (&'a Problem, &'a Matching, Option<&'a OneToOne>, (&'a Option<Gap>, &'a [Option<Details>; 2]));

fn totals(
    matched: Option<Matched<'_>>,
    pairs: Option<&OneToOne>,
    details: [Option<Details>; 2],
) -> TotalsResult {
    TotalsResult {
        growth: matched.and_then(|(_, matching, ..)| growth_totals(matching)),
        lines: matched.map(|(_, matching, ..)| line_totals(&matching.totals, details[0])),
        pairs: pairs.map(|pairs| line_totals(&pairs.totals, details[1])),
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

fn growth_totals(matching: &Matching) -> Option<GrowthTotals> {
    let growth = &matching.growth;
    let sum = growth.iter().map(|line| line.value).sum();
    (!growth.is_empty()).then_some(GrowthTotals { count: growth.len(), sum })
}

fn pair_results(pairs: &OneToOne) -> Vec<PairResult> {
    let [first, second] = pairs.problem.outlines();
    let pair = |k: usize| {
        let (line, (u, v)) = (&pairs.lines[k], pairs.places[k]);
        PairResult {
            u,
            v,
            value: line.value,
            verified: pairs.verified[k],
            from: first.points[line.from].to_array(),
            to: second.points[line.to].to_array(),
        }
    };
    (0..pairs.lines.len()).map(pair).collect()
}

pub(super) fn line_totals(totals: &Totals, details: Option<Details>) -> LineTotals {
    LineTotals {
        count: totals.count,
        sum: totals.sum,
        mean: totals.mean,
        integral: totals.integral,
        bound: totals.eta.zip(totals.integral).map(|(eta, integral)| integral / eta),
        eta: totals.eta,
        spread_sum: details.map(|details| details.spread_sum),
        least_cosine: details.map(|details| details.least_cosine),
        longest: details.map(|details| details.longest),
        crossings: totals.crossings,
        blocked: totals.blocked,
        uncovered: totals.uncovered.clone(),
    }
}

#[cfg(feature = "solid")]
impl ProjectionResult {
    /// That of a model; `None` of plane curves.
    pub(super) fn of(model: &Model) -> Option<Self> {
        let projection = model.projection()?;
        let [x, y, normal] = projection.axes.map(|axis| axis.to_array());
        Some(Self {
            origin: projection.origin.to_array(),
            normal,
            axes: [x, y],
            heights: model.document().curves.iter().map(|curve| curve.height).collect(),
            deviation: projection.deviation,
            assumed: projection.assumed(),
        })
    }
}

impl From<Viewport> for ViewResult {
    fn from(viewport: Viewport) -> Self {
        Self { center: viewport.center.to_array(), scale: viewport.scale / viewport.pixel_ratio }
    }
}

/// Stages of a band in the order of their numbers, both curves included.
pub(super) fn stages(band: &Band, document: &CurvesDocument) -> Vec<StageResult> {
    let segments = document.segments();
    (0..=segments)
        .map(|j| {
            let parts = if document.counts_stages_back() { segments - j } else { j };
            let s = parts as f64 / segments as f64;
            StageResult { s, points: arrays(&band.in_between(s)) }
        })
        .collect()
}

/// Lines of equal fraction as flat lists: the index of the level and whether the line is closed, 0 or 1, then x and y of
/// each point.
pub(super) fn isolines(lines: impl Fn(usize, f64) -> Vec<IsoLine>, options: &IsoOptions) -> Vec<Vec<f64>> {
    let mut flat = Vec::new();
    for (k, &level) in options.levels.iter().enumerate() {
        for line in lines(options.material, level) {
            let mut numbers = vec![k as f64, f64::from(u8::from(line.closed))];
            line.points.iter().for_each(|point| numbers.extend([point.x, point.y]));
            flat.push(numbers);
        }
    }
    flat
}

/// A result as a value of the host.
pub(super) fn to_value<T: Serialize + ?Sized>(value: &T) -> Result<JsValue, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::new().serialize_missing_as_null(true);
    value.serialize(&serializer).map_err(JsValue::from)
}

pub(super) fn arrays(points: &[DVec2]) -> Vec<[f64; 2]> {
    points.iter().map(|point| point.to_array()).collect()
}
