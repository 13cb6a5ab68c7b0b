//! Results as they go out: plain objects of the shapes in `docs/api.md`.

#[cfg(feature = "harmonic")]
use crate::document::Harmonic;
#[cfg(feature = "solid")]
use crate::document::Model;
use crate::document::{
    Code, CurvesDocument, Diagnostic, DocumentError, Gap, GapKind, IsoOptions, Outcome, Solution,
};
use crate::matching::{
    Details, Insertion, Matching, Obstacle, OneToOne, Outline, Problem, RulingLine, Seen, Totals, Trace,
    VertexSets, trace, vertex_sets,
};
#[cfg(feature = "harmonic")]
use crate::morph::HarmonicBlend;
use crate::morph::{Band, IsoLine, Place};
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

/// What is to be said of a harmonic blend in numbers.
#[cfg(feature = "harmonic")]
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct HarmonicSummary {
    /// Number of the outer curve.
    outer: usize,
    /// Segments of all curves.
    segments: usize,
    /// Lines along the gradient, pairs of them that meet, and lines that were lost.
    lines: usize,
    crossings: usize,
    lost: usize,
    /// Most iterations for a quantity, and the largest residual over the right-hand side.
    iterations: usize,
    residual: f64,
    /// What flows from the outer curve to the others, and the share of it that is missing on one side.
    flux: f64,
    flux_balance: f64,
    /// Area between the curves, and how much of each material is there.
    area: f64,
    amounts: Vec<f64>,
    /// Vertices and triangles on which the blend is shown.
    vertices: usize,
    triangles: usize,
}

#[cfg(feature = "harmonic")]
impl HarmonicSummary {
    pub(super) fn new(blend: &HarmonicBlend) -> Self {
        let solution = blend.solution();
        let found = || solution.convergences().iter();
        let last = found().filter_map(|own| own.residuals.last().copied());
        Self {
            outer: blend.rings().outer(),
            segments: blend.rings().count(),
            lines: blend.lines().len(),
            crossings: blend.crossings(),
            lost: blend.lost(),
            iterations: found().map(|own| own.iterations()).max().unwrap_or(0),
            residual: last.fold(0.0, f64::max),
            flux: blend.flux(),
            flux_balance: solution.flux_balance().first().map_or(0.0, |balance| balance.abs()),
            area: blend.area(),
            amounts: blend.amounts(),
            vertices: blend.field().points.len(),
            triangles: blend.field().triangles.len(),
        }
    }
}

/// The level curves of a harmonic blend, each of them with the place of its stage.
#[cfg(feature = "harmonic")]
pub(super) fn levels(harmonic: &Harmonic, document: &CurvesDocument) -> Vec<StageResult> {
    let segments = document.segments();
    let stage = |(j, loops): (usize, &Vec<Vec<DVec2>>)| {
        let s = (j + 1) as f64 / segments as f64;
        loops.iter().map(|points| StageResult { s, points: arrays(points) }).collect::<Vec<_>>()
    };
    harmonic.blend.levels().iter().enumerate().flat_map(stage).collect()
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

#[derive(Serialize, Default)]
pub(super) struct DiagnosticResult {
    code: &'static str,
    message: String,
    #[cfg(feature = "stack")]
    #[serde(skip_serializing_if = "Option::is_none")]
    span: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    curve: Option<usize>,
    #[cfg(feature = "harmonic")]
    #[serde(skip_serializing_if = "Option::is_none")]
    curves: Option<Vec<usize>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    vertices: Option<Vec<usize>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    lines: Option<Vec<usize>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pins: Option<Vec<usize>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    parameter: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    turn: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    normal: Option<[f64; 2]>,
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
    pub(super) s: f64,
    pub(super) points: Vec<[f64; 2]>,
}

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

#[cfg(feature = "solid")]
impl DiagnosticResult {
    /// A remark that speaks of nothing more than a curve and a place.
    pub(super) fn remark(
        code: &'static str,
        message: String,
        curve: Option<usize>,
        at: Option<DVec2>,
    ) -> Self {
        Self { code, message, curve, at: at.map(|at| at.to_array()), ..Self::default() }
    }
}

impl From<&Diagnostic> for DiagnosticResult {
    fn from(diagnostic: &Diagnostic) -> Self {
        let mut result = Self { code: diagnostic.code(), message: diagnostic.to_string(), ..Self::default() };
        match diagnostic {
            Diagnostic::Corner { curve, parameter, at, turn, normal } => {
                result.curve = Some(*curve);
                result.parameter = Some(*parameter);
                result.turn = Some(*turn);
                result.normal = Some(normal.to_array());
                result.at = Some(at.to_array());
            }
            Diagnostic::OpposedNormals { lines }
            | Diagnostic::Occluded { lines }
            | Diagnostic::Unverified { lines } => result.lines = Some(lines.clone()),
            Diagnostic::Pins { pins, obstacle } => {
                result.pins = Some(pins.clone());
                result.reason = Some(match obstacle {
                    Obstacle::PinsCross { .. } => "cross",
                    Obstacle::NoRoom { .. } => "no-room",
                    _ => "blocked",
                });
            }
            Diagnostic::Orphan { curve, vertices }
            | Diagnostic::Stuck { curve, vertices }
            | Diagnostic::LeftOut { curve, vertices }
            | Diagnostic::Jammed { curve, vertices } => {
                result.curve = Some(*curve);
                result.vertices = Some(vertices.clone());
            }
            Diagnostic::Incomplete { .. }
            | Diagnostic::Disjoint
            | Diagnostic::Solvable
            | Diagnostic::Ends { .. } => {}
            Diagnostic::SampleLimit { curve } => result.curve = Some(*curve),
            Diagnostic::UnverifiedGap { lines, at } => {
                result.lines = Some(lines.clone());
                result.at = Some(at.to_array());
            }
            Diagnostic::Crossing { at } => result.at = Some(at.to_array()),
            Diagnostic::CoarseSampling { at } => result.at = at.map(|at| at.to_array()),
            #[cfg(feature = "stack")]
            Diagnostic::InSpan { span, remark } => {
                result = Self { message: result.message, span: Some(*span), ..Self::from(&**remark) };
            }
            #[cfg(feature = "stack")]
            Diagnostic::Order { curve, at } => {
                result.curve = Some(*curve);
                result.at = Some(at.to_array());
            }
            #[cfg(feature = "stack")]
            Diagnostic::Overlap { span, at } => {
                result.span = Some(*span);
                result.at = Some(at.to_array());
            }
            #[cfg(feature = "stack")]
            Diagnostic::NoThread => {}
            #[cfg(feature = "harmonic")]
            Diagnostic::SeveralInner { curves, .. }
            | Diagnostic::OpenCurves { curves }
            | Diagnostic::HeightsIgnored { curves } => result.curves = Some(curves.clone()),
            #[cfg(feature = "harmonic")]
            Diagnostic::CurvesMeet { curves, at } | Diagnostic::Nested { curves, at } => {
                result.curves = Some(curves.to_vec());
                result.at = Some(at.to_array());
            }
            #[cfg(feature = "harmonic")]
            Diagnostic::NoOuter { curves, at } => {
                result.curves = Some(curves.clone());
                result.at = Some(at.to_array());
            }
            #[cfg(feature = "harmonic")]
            Diagnostic::NoField { at, .. } => result.at = at.map(|at| at.to_array()),
            #[cfg(feature = "harmonic")]
            Diagnostic::LostLines { .. } | Diagnostic::NoRuledBlend => {}
        }
        result
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

/// The steps of a greedy matching: a list each for the lines accepted (from, to, value), those passed over (from, to, step, blocking line),
/// those removed (index among the accepted), and what the passes of insertion move (curve, vertex, x, y, value).
pub(super) fn steps(solution: &Solution) -> [Vec<Vec<f64>>; 4] {
    let Outcome::Matched { problem, matching, pairs, .. } = &solution.outcome else {
        return Default::default();
    };
    let Trace { growth, rejected, removed } = trace(problem, &matching.growth);
    let model = &solution.model;
    let inserted = match (model.pair(), pairs) {
        (Some((curves, samples)), Some(_)) => Insertion::new(curves, samples, problem, matching).inserted(),
        _ => Vec::new(),
    };
    let number = |k: usize| k as f64;
    [
        growth.iter().map(|line| vec![number(line.from), number(line.to), line.value]).collect(),
        rejected.iter().map(|no| [no.from, no.to, no.step, no.by].map(number).to_vec()).collect(),
        removed.iter().map(|&k| vec![number(k)]).collect(),
        inserted
            .iter()
            .map(|new| vec![number(new.curve), number(new.vertex), new.at.x, new.at.y, new.value])
            .collect(),
    ]
}

/// The sets of a vertex: first R as a list, then of each vertex that it sees the number, the value of the line, and 1 for a candidate.
///
/// # Errors
/// When there is no such step or vertex.
pub(super) fn sets(
    solution: &Solution,
    step: usize,
    curve: usize,
    vertex: usize,
) -> Result<Vec<Vec<f64>>, DocumentError> {
    let refused = |path: &str, found: usize, count: usize| {
        let message = format!("{found} was found; expected a whole number below {count}");
        Err(DocumentError::new(Code::Range, path, message))
    };
    let (steps, count) = match &solution.outcome {
        Outcome::Matched { problem, matching, .. } => {
            (matching.growth.len() + 1, problem.outlines().get(curve).map_or(0, Outline::len))
        }
        _ => (0, 0),
    };
    if step >= steps {
        return refused("options.step", step, steps);
    }
    if curve > 1 {
        return refused("options.curve", curve, 2);
    }
    if vertex >= count {
        return refused("options.vertex", vertex, count);
    }
    let Outcome::Matched { problem, matching, .. } = &solution.outcome else { return Ok(Vec::new()) };
    let VertexSets { visible, valid } = vertex_sets(problem, &matching.growth[..step], curve, vertex);
    let seen = |seen: &Seen| vec![seen.vertex as f64, seen.value, f64::from(u8::from(seen.is_candidate))];
    let valid = valid.iter().map(|&vertex| vertex as f64).collect();
    Ok(std::iter::once(valid).chain(visible.iter().map(seen)).collect())
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

/// A result as a value of the host.
pub(super) fn to_value<T: Serialize + ?Sized>(value: &T) -> Result<JsValue, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::new().serialize_missing_as_null(true);
    value.serialize(&serializer).map_err(JsValue::from)
}

pub(super) fn arrays(points: &[DVec2]) -> Vec<[f64; 2]> {
    points.iter().map(|point| point.to_array()).collect()
}
