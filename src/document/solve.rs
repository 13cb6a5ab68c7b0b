//! From a document to its matching, in steps.

use super::direction::Direction;
#[cfg(feature = "harmonic")]
use super::harmonic::{Harmonic, HarmonicJob};
#[cfg(feature = "stack")]
use super::stack::{StackWork, Stacked};
use super::work::{Found, Work};
use super::{CurvesDocument, Diagnostic, DocumentError, Model};
use crate::curve::BSpline;
use crate::matching::{
    Details, Layout, Matching, OneToOne, Problem, ProblemError, RulingLine, Totals, Weights, broken, details,
    left_out, places_of, places_of_pairs,
};
use crate::morph::Band;

/// A solved document.
#[derive(Debug, Clone)]
pub struct Solution {
    /// The curves of the document.
    pub model: Model,
    /// The matching, or why there is none.
    pub outcome: Outcome,
    /// Remarks on the geometry.
    pub diagnostics: Vec<Diagnostic>,
    /// Whether a refinement on the curves themselves was left out, which another job would do.
    pub is_coarse: bool,
}

/// How far the integral J of the lines stays below the greatest one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// One less the ratio of J to the optimum. Pairs lie off the samples and may exceed the optimum between these; one on the curves is known as well
    /// as `change` says. So it may be a little below 0.
    pub value: f64,
    /// The greatest J, by the same rule.
    pub optimum: f64,
    /// Of an optimum on the curves themselves, its relative change when the samples were last made finer.
    pub change: Option<f64>,
    /// What the optimum is.
    pub kind: GapKind,
}

/// What a gap is measured against.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GapKind {
    /// The optimum on the curves themselves.
    Refined,
    /// The supremum on the curves themselves: the best correspondence joins a point with a whole arc, so that lines with ends of their own come near
    /// to it, nearer the more there are, but never reach it.
    Supremum,
    /// The optimum between the same samples.
    Lattice,
}

/// What came out of matching a document.
#[derive(Debug, Clone)]
pub enum Outcome {
    /// The curves meet themselves or each other: they can be drawn but not matched.
    Refused(DocumentError),
    /// The curves cannot be matched as they lie, or are not both there; the diagnostics say why.
    Unmatched,
    /// More than two curves, whose neighbours are matched with each other.
    #[cfg(feature = "stack")]
    Stacked(Box<Stacked>),
    /// Curves that are blended as heat flows between them.
    #[cfg(feature = "harmonic")]
    Harmonic(Box<Harmonic>),
    /// Lines were found.
    Matched {
        /// The outlines and the values of their lines.
        problem: Box<Problem>,
        /// The lines; they may leave vertices bare.
        matching: Box<Matching>,
        /// Lines with ends of their own, where the document asks for them and the matching is complete.
        pairs: Option<Box<OneToOne>>,
        /// The band between the curves; only where every vertex has a line and no constraint is broken, or where occluded lines were
        /// added until every vertex has one.
        band: Option<Band>,
        /// Whether every vertex has a line, or the pairs stand in for that, and no constraint is broken.
        is_complete: bool,
        /// Indices of lines that are not visible, added by the policy `repair`.
        occluded: Vec<usize>,
        /// How far J stays below the optimum; of complete matchings whose optimum is known.
        gap: Option<Gap>,
        /// Further figures of the lines and of the pairs.
        details: [Option<Details>; 2],
    },
}

impl Solution {
    /// Tells whether every vertex has a line and no constraint is broken.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        #[cfg(feature = "stack")]
        if let Some(stack) = self.stack() {
            return stack.is_complete;
        }
        #[cfg(feature = "harmonic")]
        if self.harmonic().is_some() {
            return true;
        }
        matches!(self.outcome, Outcome::Matched { is_complete: true, .. })
    }

    /// The band between two curves, where the matching is complete.
    #[must_use]
    pub fn band(&self) -> Option<&Band> {
        match &self.outcome {
            Outcome::Matched { band, .. } => band.as_ref(),
            _ => None,
        }
    }

    /// The spans and the blend of more than two curves.
    #[cfg(feature = "stack")]
    #[must_use]
    pub fn stack(&self) -> Option<&Stacked> {
        match &self.outcome {
            Outcome::Stacked(stack) => Some(stack),
            _ => None,
        }
    }

    /// The harmonic blend.
    #[cfg(feature = "harmonic")]
    #[must_use]
    pub fn harmonic(&self) -> Option<&Harmonic> {
        match &self.outcome {
            Outcome::Harmonic(harmonic) => Some(harmonic),
            _ => None,
        }
    }

    /// The lines to show between two curves, with the outlines they join and what they are worth: those with ends of their own where there are
    /// some, else those between samples.
    #[must_use]
    pub fn lines(&self) -> Option<(&Problem, &[RulingLine], &Totals)> {
        match &self.outcome {
            Outcome::Matched { pairs: Some(pairs), .. } => {
                Some((&pairs.problem, &pairs.lines, &pairs.totals))
            }
            Outcome::Matched { problem, matching, .. } => Some((problem, &matching.lines, &matching.totals)),
            _ => None,
        }
    }

    /// Tells of each line to show whether it meets a curve or crosses another; empty where none does.
    #[must_use]
    pub fn broken(&self) -> Vec<bool> {
        match &self.outcome {
            Outcome::Matched { pairs: Some(pairs), .. }
                if pairs.totals.crossings + pairs.totals.blocked > 0 =>
            {
                pairs.verified.iter().map(|verified| !verified).collect()
            }
            Outcome::Matched { problem, matching, pairs: None, occluded, .. }
                if matching.totals.crossings + matching.totals.blocked + occluded.len() > 0 =>
            {
                broken(problem, &matching.lines)
            }
            _ => Vec::new(),
        }
    }

    /// Builds the band with `per_line` rulings from each line to the next.
    #[must_use]
    pub fn band_with(&self, per_line: usize) -> Option<Band> {
        match &self.outcome {
            Outcome::Matched { matching, pairs, band: Some(_), .. } => {
                band(&self.model, matching, pairs.as_deref(), per_line)
            }
            _ => None,
        }
    }
}

/// A job that matches the curves of a document.
#[derive(Debug)]
pub struct Solve {
    model: Option<Model>,
    state: State,
    is_coarse: bool,
    /// Share of the work that was done before the lines were looked for.
    begun: f64,
}

#[derive(Debug)]
enum State {
    Ready(Box<(Outcome, Vec<Diagnostic>, bool)>),
    Directing(Box<Direction>),
    Working(Box<Work>),
    #[cfg(feature = "stack")]
    Stacking(Box<StackWork>),
    #[cfg(feature = "harmonic")]
    Flowing(Box<HarmonicJob>),
}

impl Solve {
    /// Builds the curves of a document and prepares their matching.
    ///
    /// # Errors
    /// When a curve or a composition is not valid, see [`Model::new`].
    pub fn new(document: CurvesDocument) -> Result<Self, DocumentError> {
        Self::start(document, false)
    }

    /// As [`new`](Self::new), but leaves out the refinement of the method `exact` on the curves themselves: one-to-one lines then follow the
    /// optimum between the samples. For documents that change from frame to frame.
    ///
    /// # Errors
    /// As for [`new`](Self::new).
    pub fn coarse(document: CurvesDocument) -> Result<Self, DocumentError> {
        Self::start(document, true)
    }

    fn start(document: CurvesDocument, is_coarse: bool) -> Result<Self, DocumentError> {
        let model = Model::new(document)?;
        #[cfg(feature = "harmonic")]
        if model.document().is_harmonic() && model.curves().len() > 1 {
            let state = State::Flowing(Box::new(HarmonicJob::new(&model, is_coarse)));
            return Ok(Self { model: Some(model), state, is_coarse, begun: 0.0 });
        }
        #[cfg(feature = "stack")]
        if model.curves().len() > 2 {
            let state = State::Stacking(Box::new(StackWork::new(&model, is_coarse)));
            return Ok(Self { model: Some(model), state, is_coarse, begun: 0.0 });
        }
        Ok(match model.fault() {
            Some(fault) => {
                let state = State::Ready(Box::new((Outcome::Refused(fault), Vec::new(), false)));
                Self { model: Some(model), state, is_coarse, begun: 0.0 }
            }
            None => Self::of_sound(model, is_coarse),
        })
    }

    /// A job for one span of a stack whose curves are known to be sound; the first of two open ones may have to run against its drawing, as the span before
    /// has found out.
    #[cfg(feature = "stack")]
    pub(super) fn span(
        document: CurvesDocument,
        first_is_reversed: bool,
        is_coarse: bool,
    ) -> Result<Self, DocumentError> {
        let mut model = Model::new(document)?;
        if model.reversed()[0] != first_is_reversed {
            model.turn(0);
        }
        Ok(Self::of_sound(model, is_coarse))
    }

    /// A job for curves that meet neither themselves nor each other.
    fn of_sound(mut model: Model, is_coarse: bool) -> Self {
        let direction = model.ends().and_then(|_| Direction::new(&mut model));
        let state = direction
            .map_or_else(|| prepare(&model, is_coarse), |direction| State::Directing(Box::new(direction)));
        let begun = if let State::Directing(_) = state { DIRECTING } else { 0.0 };
        Self { model: Some(model), state, is_coarse, begun }
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the solution when it is found, and `None` ever
    /// after.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Solution> {
        if let State::Directing(direction) = &mut self.state {
            let is_turned = direction.step(may_go_on)?;
            let model = self.model.as_mut()?;
            if is_turned {
                model.turn(1);
            }
            self.state = prepare(model, self.is_coarse);
        }
        if let State::Working(work) = &mut self.state {
            let found = work.step(may_go_on)?;
            let problem = work.problem().clone();
            self.state = matched(self.model.as_ref()?, problem, found);
        }
        #[cfg(feature = "stack")]
        if let State::Stacking(work) = &mut self.state {
            let ready = work.step(self.model.as_mut()?, may_go_on)?;
            self.state = State::Ready(Box::new(ready));
        }
        #[cfg(feature = "harmonic")]
        if let State::Flowing(job) = &mut self.state {
            let ready = job.step(self.model.as_ref()?, may_go_on)?;
            self.state = State::Ready(Box::new(ready));
        }
        let State::Ready(ready) = &mut self.state else { return None };
        let model = self.model.take()?;
        let (outcome, diagnostics, is_coarse) =
            std::mem::replace(&mut **ready, (Outcome::Unmatched, Vec::new(), false));
        Some(Solution { model, outcome, diagnostics, is_coarse })
    }

    /// Share of the work that is done, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        match &self.state {
            State::Ready(_) => 1.0,
            State::Directing(direction) => direction.progress() * DIRECTING,
            State::Working(work) => self.begun + (1.0 - self.begun) * work.progress(),
            #[cfg(feature = "stack")]
            State::Stacking(work) => work.progress(),
            #[cfg(feature = "harmonic")]
            State::Flowing(job) => job.progress(),
        }
    }

    /// Runs the job to its end.
    ///
    /// # Errors
    /// When a curve or a composition is not valid, see [`Model::new`].
    pub fn run(document: CurvesDocument) -> Result<Solution, DocumentError> {
        let mut job = Self::new(document)?;
        loop {
            if let Some(solution) = job.step(&mut || true) {
                return Ok(solution);
            }
        }
    }
}

/// Share of the work that it takes to find the direction of open curves.
const DIRECTING: f64 = 0.4;

fn prepare(model: &Model, is_coarse: bool) -> State {
    let reason = match model.pair() {
        None => Diagnostic::Incomplete { curves: model.curves().len() },
        Some((curves, samples)) => match Work::new(model, curves, samples, is_coarse) {
            Ok(work) => return State::Working(Box::new(work)),
            Err(error) => why_unmatched(curves, model.gap(), error),
        },
    };
    let mut diagnostics = curve_remarks(model);
    diagnostics.push(reason);
    State::Ready(Box::new((Outcome::Unmatched, diagnostics, false)))
}

/// Puts a matching together with its band and the remarks on it.
fn matched(model: &Model, problem: Problem, found: Found) -> State {
    let mut diagnostics = curve_remarks(model);
    if matches!(problem.layout(), Layout::Crossing | Layout::Loose)
        && let Some(([first, second], _)) = model.pair()
    {
        diagnostics.extend(first.contact(second).map(|meeting| Diagnostic::Crossing { at: meeting.at }));
    }
    let is_complete = found.is_complete();
    let is_grown = !found.matching.growth.is_empty();
    diagnostics.extend(remarks(model.weights(), &problem, &found.matching, is_grown));
    let Found { matching, pairs, gap, occluded, is_coarse, diagnostics: more, .. } = found;
    diagnostics.extend(more);
    let failed = pairs.iter().flat_map(|pairs| &pairs.failed);
    diagnostics.extend(failed.map(|gap| Diagnostic::UnverifiedGap { lines: gap.lines.clone(), at: gap.at }));
    let count = pairs.as_ref().map_or(matching.lines.len(), |pairs| pairs.lines.len());
    let band = || band(model, &matching, pairs.as_deref(), rulings_per_line(count));
    let band = (is_complete || !occluded.is_empty()).then(band).flatten();
    let details = model.pair().map_or([None, None], |(curves, _)| {
        let of_pairs = pairs
            .as_deref()
            .and_then(|pairs| details(curves, &pairs.problem, &pairs.lines, &places_of_pairs(curves, pairs)));
        [details(curves, &problem, &matching.lines, &places_of(&problem, &matching.lines)), of_pairs]
    });
    let outcome = Outcome::Matched {
        problem: Box::new(problem),
        matching: Box::new(matching),
        pairs,
        band,
        is_complete,
        occluded,
        gap,
        details,
    };
    State::Ready(Box::new((outcome, diagnostics, is_coarse)))
}

/// Says why sampled polygons cannot be matched although the curves themselves are simple and, at equal heights, apart.
fn why_unmatched(curves: &[BSpline; 2], gap: f64, error: ProblemError) -> Diagnostic {
    match error {
        ProblemError::Apart => Diagnostic::Disjoint,
        ProblemError::NotSimple { at, .. } => Diagnostic::CoarseSampling { at: Some(at) },
        ProblemError::NotCounterClockwise { .. } => Diagnostic::CoarseSampling { at: None },
        ProblemError::Meet { at } => {
            let crossing = (gap > 0.0).then(|| curves[0].contact(&curves[1])).flatten();
            match crossing {
                Some(meeting) => Diagnostic::Crossing { at: meeting.at },
                None => Diagnostic::CoarseSampling { at: Some(at) },
            }
        }
    }
}

pub(super) fn curve_remarks(model: &Model) -> Vec<Diagnostic> {
    let corners = model.curves().iter().enumerate().flat_map(|(curve, spline)| {
        spline.corners().into_iter().map(move |corner| Diagnostic::Corner {
            curve,
            parameter: corner.u,
            at: corner.at,
            turn: corner.turn,
            normal: spline.normal(corner.u),
        })
    });
    let limits = model.coarse().iter().map(|&curve| Diagnostic::SampleLimit { curve });
    corners.chain(limits).collect()
}

fn remarks(weights: Weights, problem: &Problem, matching: &Matching, is_grown: bool) -> Vec<Diagnostic> {
    let mut remarks = Vec::new();
    let opposed: Vec<usize> = (0..matching.lines.len())
        .filter(|&k| problem.cosine(matching.lines[k].from, matching.lines[k].to) < 0.0)
        .collect();
    if !opposed.is_empty() && weights.normal > 0.0 {
        remarks.push(Diagnostic::OpposedNormals { lines: opposed });
    }
    let left_out = left_out(problem, &matching.lines);
    for curve in 0..2 {
        let left_out = &left_out[curve];
        let is_reached = |vertex: &&usize| left_out.binary_search(vertex).is_err();
        let orphans: &Vec<usize> = &matching.orphans[curve].iter().filter(is_reached).copied().collect();
        if !left_out.is_empty() {
            remarks.push(Diagnostic::LeftOut { curve, vertices: left_out.clone() });
        }
        let bare = matching.totals.uncovered[curve].iter().copied();
        let stuck: Vec<usize> = bare.filter(|vertex| orphans.binary_search(vertex).is_err()).collect();
        if !orphans.is_empty() {
            remarks.push(Diagnostic::Orphan { curve, vertices: orphans.clone() });
        }
        if !stuck.is_empty() && is_grown {
            remarks.push(Diagnostic::Stuck { curve, vertices: stuck });
        }
    }
    remarks
}

/// Rulings of the band from one line to the next: enough for smooth curves and colours, some two hundred in all.
fn rulings_per_line(lines: usize) -> usize {
    const IN_ALL: usize = 176;
    IN_ALL.div_ceil(lines.max(1)).clamp(2, 32)
}

fn band(model: &Model, matching: &Matching, pairs: Option<&OneToOne>, per_line: usize) -> Option<Band> {
    let (curves, samples) = model.pair()?;
    let compose = |curve: usize, u: f64| model.composition(curve, u);
    let (lo, hi) = curves[1].domain();
    let place = |line: &RulingLine| {
        let laps = line.lifted.div_euclid(samples[1].parameters.len() as i64);
        (samples[0].parameters[line.from], samples[1].parameters[line.to] + laps as f64 * (hi - lo))
    };
    let places =
        pairs.map_or_else(|| matching.lines.iter().map(place).collect(), |pairs| pairs.places.clone());
    Some(Band::new(curves, &places, compose, per_line))
}
