//! A stack of more than two curves: its spans solved one after the other, then woven into one blend, in steps.

use super::{BlendKind, CurvesDocument, Diagnostic, Model, Outcome, Pin, Solution, Solve};
use crate::geom::{Location, SegmentGrid, locate, segments_meet};
use crate::morph::{Refined, StackBlend, Weave};
use glam::DVec2;
use std::vec::IntoIter;

/// The matchings of all neighbours in a stack, and their blend.
#[derive(Debug, Clone)]
pub struct Stacked {
    /// The solution of every span, as that of a document of its two curves. Of open curves the first one may run against its drawing already.
    pub spans: Vec<Solution>,
    /// The blend through all curves; only where every span has a band, and nothing lies over something else in the plane.
    pub blend: Option<StackBlend>,
    /// Whether every span is complete, and there is a blend.
    pub is_complete: bool,
}

impl Stacked {
    /// Weaves the blend with a number of strands from each thread to the next.
    #[must_use]
    pub fn blend_with(&self, model: &Model, per_line: usize) -> Option<StackBlend> {
        self.blend.as_ref()?;
        let mut weave = weave(model, &self.spans, Refined::By(per_line))?;
        weave.step(&|curve, u| model.composition(curve, u), &mut || true)?
    }

    /// Number of lines that are shown of the spans before one: lines of a stack are counted on from span to span.
    #[must_use]
    pub fn lines_before(&self, span: usize) -> usize {
        let count = |solution: &Solution| solution.lines().map_or(0, |(_, lines, _)| lines.len());
        self.spans[..span].iter().map(count).sum()
    }
}

/// The document of one span: its two curves with their counts and their pins.
#[must_use]
pub fn span_document(document: &CurvesDocument, span: usize) -> CurvesDocument {
    let mut part = document.clone();
    part.curves = document.curves[span..=span + 1].to_vec();
    part.sampling.counts = document.sampling.counts[span..=span + 1].to_vec();
    part.matching.pins = pins_of(document, span).map(|(_, pin)| Pin { pair: 0, ..pin }).collect();
    part.blend.kind = BlendKind::Ruled;
    part
}

/// The pins of a span, with their numbers in the document.
fn pins_of(document: &CurvesDocument, span: usize) -> impl Iterator<Item = (usize, Pin)> {
    document.matching.pins.iter().copied().enumerate().filter(move |(_, pin)| pin.pair == span)
}

/// A stack on its way to its blend.
#[derive(Debug)]
pub(super) struct StackWork {
    is_coarse: bool,
    /// Curves to look at by themselves and in pairs: what is left of these questions.
    checks: IntoIter<(usize, usize)>,
    job: Option<Box<Solve>>,
    spans: Vec<Solution>,
    /// Number of spans in all.
    count: usize,
    diagnostics: Vec<Diagnostic>,
    weaving: Weaving,
}

#[derive(Debug)]
enum Weaving {
    Waiting,
    Working(Box<Weave>),
    /// The blend, and the number of gaps between its strands that were looked at.
    Checking(Option<Box<StackBlend>>, usize),
    Over(Option<Box<StackBlend>>),
}

/// What a stack comes to, its remarks, and whether a refinement was left out.
pub(super) type Ready = (Outcome, Vec<Diagnostic>, bool);

impl StackWork {
    pub(super) fn new(model: &Model, is_coarse: bool) -> Self {
        Self {
            is_coarse,
            checks: checks(model.curves().len()).into_iter(),
            job: None,
            spans: Vec::new(),
            count: model.curves().len() - 1,
            diagnostics: Vec::new(),
            weaving: Weaving::Waiting,
        }
    }

    /// Advances while `may_go_on` says so, at least by a little. Turns open curves of the model as the spans find out.
    pub(super) fn step(&mut self, model: &mut Model, may_go_on: &mut dyn FnMut() -> bool) -> Option<Ready> {
        for (i, j) in self.checks.by_ref() {
            let fault = if i == j { model.self_contact(i) } else { model.contact(i, j) };
            if let Some(fault) = fault {
                return Some((Outcome::Refused(fault), Vec::new(), false));
            }
            if !may_go_on() {
                return None;
            }
        }
        while self.spans.len() < self.count {
            let span = self.spans.len();
            let job = match &mut self.job {
                Some(job) => job,
                none => {
                    let part = span_document(model.document(), span);
                    match Solve::span(part, model.reversed()[span], self.is_coarse) {
                        Ok(job) => none.insert(Box::new(job)),
                        Err(error) => return Some((Outcome::Refused(error), Vec::new(), false)),
                    }
                }
            };
            let solution = job.step(may_go_on)?;
            self.job = None;
            if solution.model.reversed()[1] != model.reversed()[span + 1] {
                model.turn(span + 1);
            }
            self.spans.push(solution);
            if !may_go_on() {
                return None;
            }
        }
        loop {
            self.weaving = match &mut self.weaving {
                Weaving::Waiting => {
                    self.remark(model);
                    let is_sound = !self.diagnostics.iter().any(|it| matches!(it, Diagnostic::Order { .. }));
                    let woven =
                        if is_sound { weave(model, &self.spans, Refined::Towards(STRANDS)) } else { None };
                    woven.map_or(Weaving::Over(None), |woven| Weaving::Working(Box::new(woven)))
                }
                Weaving::Working(job) => {
                    match job.step(&|curve, u| model.composition(curve, u), may_go_on)? {
                        Some(blend) => Weaving::Checking(Some(Box::new(blend)), 0),
                        None => {
                            self.diagnostics.push(Diagnostic::NoThread);
                            Weaving::Over(None)
                        }
                    }
                }
                Weaving::Checking(checked, looked) => {
                    let blend = checked.as_ref()?;
                    let mut overlap = None;
                    while *looked < blend.gaps() && overlap.is_none() {
                        overlap = blend.overlap_at(*looked);
                        *looked += 1;
                        if !may_go_on() && *looked < blend.gaps() && overlap.is_none() {
                            return None;
                        }
                    }
                    let blend = checked.take().filter(|_| overlap.is_none());
                    self.diagnostics
                        .extend(overlap.map(|it| Diagnostic::Overlap { span: it.span, at: it.at }));
                    Weaving::Over(blend)
                }
                Weaving::Over(blend) => {
                    let blend = blend.take().map(|blend| *blend);
                    let spans = std::mem::take(&mut self.spans);
                    let is_complete = blend.is_some() && spans.iter().all(Solution::is_complete);
                    let is_coarse = spans.iter().any(|span| span.is_coarse);
                    let stacked = Stacked { spans, blend, is_complete };
                    let diagnostics = std::mem::take(&mut self.diagnostics);
                    return Some((Outcome::Stacked(Box::new(stacked)), diagnostics, is_coarse));
                }
            };
        }
    }

    /// Share of the work that is done, from 0 to 1.
    pub(super) fn progress(&self) -> f64 {
        let own = self.job.as_ref().map_or(0.0, |job| job.progress());
        SPANS * (self.spans.len() as f64 + own) / self.count as f64
    }

    /// Takes over the remarks on the curves and on the spans, with the numbers of curves and pins in the stack, and looks for what lies over
    /// something else.
    fn remark(&mut self, model: &Model) {
        self.diagnostics.extend(super::solve::curve_remarks(model));
        for (span, solution) in self.spans.iter().enumerate() {
            let numbers: Vec<usize> = pins_of(model.document(), span).map(|(number, _)| number).collect();
            let of_the_curve =
                |it: &&Diagnostic| matches!(it, Diagnostic::Corner { .. } | Diagnostic::SampleLimit { .. });
            let own = solution.diagnostics.iter().filter(|it| !of_the_curve(it));
            let placed =
                own.map(|it| Diagnostic::InSpan { span, remark: Box::new(it.in_stack(span, &numbers)) });
            self.diagnostics.extend(placed);
        }
        let misplaced = out_of_order(model, &self.spans);
        #[cfg(feature = "harmonic")]
        if !misplaced.is_empty() {
            self.diagnostics.extend(super::harmonic::several_inner(model));
        }
        self.diagnostics.extend(misplaced);
    }
}

/// Every curve by itself, then every pair, as [`Model::fault`] asks.
fn checks(count: usize) -> Vec<(usize, usize)> {
    let pairs = (1..count).flat_map(|j| (0..j).map(move |i| (i, j)));
    (0..count).map(|k| (k, k)).chain(pairs).collect()
}

/// Share of the work that the spans take.
const SPANS: f64 = 0.9;
/// Strands of a blend towards which threads are refined for the picture.
const STRANDS: usize = 176;

/// Prepares the blend of solved spans; `None` unless each of them has a band.
fn weave(model: &Model, spans: &[Solution], per_line: Refined) -> Option<Weave> {
    let places = |span: &Solution| -> Option<Vec<(f64, f64)>> {
        Some(span.band()?.lines().map(|ruling| (ruling.u, ruling.v)).collect())
    };
    let places = spans.iter().map(places).collect::<Option<Vec<_>>>()?;
    let document = model.document();
    let heights = document.curves.iter().map(|curve| curve.height).collect();
    let is_cubic = document.blend.kind == BlendKind::Cubic;
    Some(Weave::new(model.curves().to_vec(), heights, &places, is_cubic, per_line))
}

/// Curves of one height that lie in the plane between others than their neighbours in the stack.
///
/// Of closed curves, a curve with two neighbours of its height has to lie inside one of them and outside the other. Of open ones, no line of a span
/// may meet another curve of the same height.
fn out_of_order(model: &Model, spans: &[Solution]) -> Vec<Diagnostic> {
    let curves = &model.document().curves;
    let is_level = |i: usize, j: usize| curves[i].height == curves[j].height;
    let samples = model.samples();
    if model.ends().is_none() {
        let is_inside =
            |i: usize, j: usize| locate(&samples[j].points, samples[i].points[0]) == Location::Inside;
        return (1..spans.len())
            .filter(|&k| is_level(k - 1, k) && is_level(k, k + 1))
            .filter(|&k| is_inside(k - 1, k) == is_inside(k + 1, k))
            .map(|k| Diagnostic::Order { curve: k, at: samples[k].points[0] })
            .collect();
    }
    let mut found = Vec::new();
    for (curve, samples) in samples.iter().enumerate() {
        let edges = samples.points.windows(2).map(|pair| (pair[0], pair[1])).collect();
        let grid = SegmentGrid::new(edges);
        let meets = |(from, to): (DVec2, DVec2)| {
            grid.find(from, to, |_, a, b| segments_meet(from, to, a, b)).map(|_| from)
        };
        let others = (0..spans.len()).filter(|&span| {
            curve != span && curve != span + 1 && is_level(curve, span) && is_level(curve, span + 1)
        });
        let at = others.flat_map(|span| ends(&spans[span])).find_map(meets);
        found.extend(at.map(|at| Diagnostic::Order { curve, at }));
    }
    found
}

/// Ends of the lines of a span.
fn ends(span: &Solution) -> Vec<(DVec2, DVec2)> {
    let Some((problem, lines, _)) = span.lines() else { return Vec::new() };
    let [first, second] = problem.outlines();
    lines.iter().map(|line| (first.points[line.from], second.points[line.to])).collect()
}
