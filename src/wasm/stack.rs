//! Results of stacks: those of their spans, and what belongs to all curves together.

use super::probe::{ProbeResult, probed};
use super::results::{GrowthTotals, LineTotals, MatchResult, StageResult, TotalsResult, arrays, line_totals};
use crate::curve::BSpline;
use crate::document::{DocumentError, Outcome, Solution, Stacked};
use crate::morph::{Place, StackBlend, StackPlace};
use glam::DVec2;

/// The results of the spans.
///
/// # Errors
/// Never: curves that meet are refused before spans are solved.
pub(super) fn spans(stack: &Stacked) -> Result<Vec<MatchResult>, DocumentError> {
    stack.spans.iter().map(MatchResult::new).collect()
}

/// Place s of every curve; none without a blend.
pub(super) fn knots(stack: &Stacked) -> Vec<f64> {
    stack.blend.as_ref().map_or_else(Vec::new, |blend| blend.knots().to_vec())
}

/// Parameters of every thread on every curve; none without a blend.
pub(super) fn threads(stack: &Stacked) -> Vec<Vec<f64>> {
    stack.blend.as_ref().map_or_else(Vec::new, |blend| blend.threads().map(<[f64]>::to_vec).collect())
}

/// Totals over all spans. J and its bound are means over a span, so that they have no sum.
pub(super) fn totals(stack: &Stacked) -> TotalsResult {
    let growths = stack.spans.iter().filter_map(|span| match &span.outcome {
        Outcome::Matched { matching, .. } if !matching.growth.is_empty() => Some(&matching.growth),
        _ => None,
    });
    let growth = growths.fold(None, |all: Option<GrowthTotals>, growth| {
        let (count, sum) = all.map_or((0, 0.0), |all| (all.count, all.sum));
        let own: f64 = growth.iter().map(|line| line.value).sum();
        Some(GrowthTotals { count: count + growth.len(), sum: sum + own })
    });
    let lines = stack.spans.iter().map(|span| match &span.outcome {
        Outcome::Matched { matching, details, .. } => Some(line_totals(&matching.totals, details[0])),
        _ => None,
    });
    let pairs = stack.spans.iter().map(|span| match &span.outcome {
        Outcome::Matched { pairs: Some(pairs), details, .. } => Some(line_totals(&pairs.totals, details[1])),
        _ => None,
    });
    TotalsResult { growth, lines: together(lines), pairs: together(pairs) }
}

/// Counts and sums of all spans; `None` unless each of them has its own.
fn together(spans: impl Iterator<Item = Option<LineTotals>>) -> Option<LineTotals> {
    let spans = spans.collect::<Option<Vec<LineTotals>>>()?;
    let count = spans.iter().map(|own| own.count).sum();
    let sum: f64 = spans.iter().map(|own| own.sum).sum();
    Some(LineTotals {
        count,
        sum,
        mean: (count > 0).then(|| sum / count as f64),
        integral: None,
        bound: None,
        eta: None,
        spread_sum: None,
        least_cosine: spans.iter().filter_map(|own| own.least_cosine).reduce(f64::min),
        longest: spans.iter().filter_map(|own| own.longest).reduce(f64::max),
        crossings: spans.iter().map(|own| own.crossings).sum(),
        blocked: spans.iter().map(|own| own.blocked).sum(),
        uncovered: [Vec::new(), Vec::new()],
    })
}

/// The stages of a stack in the order of their numbers, all curves included, with `refine` points from each thread to the next.
pub(super) fn stages(solution: &Solution, stack: &Stacked, refine: usize) -> Vec<StageResult> {
    let Some(blend) = stack.blend_with(&solution.model, refine) else { return Vec::new() };
    let document = solution.model.document();
    let stage = |(span, share)| StageResult {
        s: blend.s_at(span, share),
        points: arrays(&blend.in_between_at(span, share)),
    };
    let mut stages: Vec<StageResult> = blend.stages(document.segments()).map(stage).collect();
    if document.counts_stages_back() {
        stages.reverse();
    }
    stages
}

/// What a stack holds at a point, and the nearest ruling line of its span.
pub(super) fn probe(stack: &Stacked, at: DVec2) -> Option<ProbeResult> {
    let StackPlace { span, s, u, v, composition } =
        stack.blend.as_ref().and_then(|it: &StackBlend| it.locate(at))?;
    let solution = &stack.spans[span];
    let (problem, lines, _) = solution.lines()?;
    let curves = solution.model.curves();
    let away = |curve: &BSpline, from: f64, to: f64| {
        let (lo, hi) = curve.domain();
        let share = (to - from) / (hi - lo);
        (if curve.is_closed() { share - share.round() } else { share }).abs()
    };
    let distances =
        solution.band()?.lines().map(|line| away(&curves[0], line.u, u) + away(&curves[1], line.v, v));
    let (line, _) = distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1))?;
    let place = Place { line, s, u, v, composition };
    Some(ProbeResult { span: Some(span), ..probed(problem, lines, place, at)? })
}
