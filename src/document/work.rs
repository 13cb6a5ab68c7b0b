//! The methods of a document at work, in steps.

use super::schema::{Method, ObjectiveName, Policy, PrintedRule, Shift};
use super::solve::{Gap, GapKind};
use super::{Diagnostic, Model};
use crate::curve::{BSpline, Samples};
use crate::matching::{
    self, Bound, Exact, ExactOptions, Greedy, Infeasible, Insertion, Matching, Objective, OnePerVertex,
    OneToOne, Optimum, Outline, Placing, Printed, Problem, ProblemError, Refine, Refined, RulingLine, Spread,
    best_shift, even_places, fill_in, integral_on_curves, measure, places_of, shifted,
};

/// A document on its way to lines, and then to one-to-one lines where it asks for them.
#[derive(Debug)]
pub(super) struct Work {
    curves: [BSpline; 2],
    samples: [Samples; 2],
    pins: Vec<(usize, usize)>,
    spec: super::MatchingSpec,
    /// Leave out the refinement on the curves.
    is_coarse: bool,
    problem: Problem,
    stage: Stage,
    found: Found,
    /// Evenly spread lines of the method `exact`, with the outlines that they are verified against.
    spread: Option<Box<(Problem, Spread)>>,
    /// Share of the work that is done, as said last: it never falls.
    reached: f64,
}

/// What has been found so far.
#[derive(Debug, Clone)]
pub(super) struct Found {
    pub(super) matching: Matching,
    pub(super) pairs: Option<Box<OneToOne>>,
    pub(super) gap: Option<Gap>,
    /// Indices of lines that are not visible.
    pub(super) occluded: Vec<usize>,
    pub(super) diagnostics: Vec<Diagnostic>,
    /// A refinement on the curves that belongs to the method was left out.
    pub(super) is_coarse: bool,
    /// The exact method was refused: the lines are a part of what was asked for.
    is_partial: bool,
    /// The lattice optimum of J of the same samples.
    optimum: Option<Optimum>,
    refined: Option<Refined>,
}

#[derive(Debug)]
enum Stage {
    Growing(Box<Greedy>),
    Solving(Box<Exact>),
    Choosing(Box<OnePerVertex>),
    Rating(Box<Exact>),
    Refining(Box<Refine>),
    Inserting(Box<Insertion>),
    Placing(Box<Placing>),
    Done,
}

impl Found {
    /// Tells whether every vertex has a line and no constraint is broken, as far as the document asks.
    pub(super) fn is_complete(&self) -> bool {
        let broken = self.pairs.as_ref().map(|pairs| pairs.totals.crossings + pairs.totals.blocked);
        match broken {
            _ if self.is_partial || !self.occluded.is_empty() => false,
            Some(broken) => broken == 0,
            None => self.matching.is_complete(),
        }
    }
}

impl Work {
    /// Prepares the method of a document with both curves; `is_coarse` leaves out the refinement of `exact` on the curves.
    ///
    /// # Errors
    /// When the sampled polygons cannot be matched.
    pub(super) fn new(
        model: &Model,
        curves: &[BSpline; 2],
        samples: &[Samples; 2],
        is_coarse: bool,
    ) -> Result<Self, ProblemError> {
        let spec = model.document().matching.clone();
        let mut outlines = samples.each_ref().map(Outline::from);
        if spec.is_printed(PrintedRule::Normals) {
            outlines[1].normals.iter_mut().for_each(|normal| *normal = -*normal);
        }
        let problem = problem_on(outlines, model)?;
        let matching = assemble(&problem, Vec::new(), &blank(&problem));
        let found = Found {
            matching,
            pairs: None,
            gap: None,
            occluded: Vec::new(),
            diagnostics: Vec::new(),
            is_coarse: false,
            is_partial: false,
            optimum: None,
            refined: None,
        };
        let mut work = Self {
            curves: curves.clone(),
            samples: samples.clone(),
            pins: model.pins().to_vec(),
            spec,
            is_coarse,
            problem,
            stage: Stage::Done,
            found,
            spread: None,
            reached: 0.0,
        };
        work.stage = match work.spec.method {
            Method::Greedy => work.growing(),
            Method::Exact => Stage::Solving(Box::new(Exact::new(work.problem.clone(), work.options()))),
            Method::OnePerVertex => Stage::Choosing(Box::new(OnePerVertex::new(work.problem.clone()))),
            Method::Shift | Method::Parameter => {
                Stage::Rating(Box::new(Exact::new(work.problem.clone(), ExactOptions::default())))
            }
        };
        Ok(work)
    }

    /// The outlines and the values of their lines.
    pub(super) fn problem(&self) -> &Problem {
        &self.problem
    }

    /// Advances while `may_go_on` says so, at least by a little; returns what was found when all is.
    pub(super) fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Found> {
        let found = self.advance(may_go_on);
        self.reached = self.reached.max(self.share());
        found
    }

    /// Share of the work that is done, from 0 to 1.
    pub(super) fn progress(&self) -> f64 {
        self.reached
    }

    fn advance(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Found> {
        loop {
            self.stage = match &mut self.stage {
                Stage::Growing(job) => {
                    self.found.matching = job.step(may_go_on)?;
                    // How stages are counted says nothing of lines.
                    let is_printed = self.spec.printed.iter().any(|rule| *rule != PrintedRule::Stages);
                    if self.found.is_partial || is_printed {
                        Stage::Done
                    } else {
                        let options =
                            ExactOptions { policy: policy(self.spec.policy), ..ExactOptions::default() };
                        Stage::Rating(Box::new(Exact::after(job, options)))
                    }
                }
                Stage::Solving(job) => match job.step(may_go_on)? {
                    Ok(optimum) => self.solved(optimum),
                    Err(infeasible) => {
                        self.found.diagnostics.extend(why(&infeasible));
                        self.found.is_partial = true;
                        self.growing()
                    }
                },
                Stage::Choosing(job) => {
                    let found = job.step(may_go_on)?;
                    self.found.matching = assemble(&self.problem, found.lines, &found.best);
                    Stage::Rating(Box::new(Exact::new(self.problem.clone(), ExactOptions::default())))
                }
                Stage::Rating(job) => {
                    let outcome = job.step(may_go_on)?;
                    self.rated(outcome)
                }
                Stage::Refining(job) => {
                    self.found.refined = job.step(may_go_on)?;
                    self.even()
                }
                Stage::Inserting(job) => {
                    self.found.pairs = Some(Box::new(job.step(may_go_on)?));
                    self.finish()
                }
                Stage::Placing(job) => {
                    let pairs = job.step(may_go_on)?;
                    self.placed(pairs)
                }
                Stage::Done => return Some(self.found.clone()),
            };
        }
    }

    /// Share of the work that is done, by the stage alone.
    fn share(&self) -> f64 {
        let lines = if self.spec.one_to_one { 0.6 } else { 1.0 };
        match &self.stage {
            Stage::Growing(job) => job.progress() * lines,
            Stage::Solving(job) | Stage::Rating(job) => job.progress() * lines,
            Stage::Choosing(job) => job.progress() * lines,
            Stage::Refining(_) => 0.6,
            Stage::Inserting(job) => 0.6 + 0.4 * job.progress(),
            Stage::Placing(job) => 0.8 + 0.2 * job.progress(),
            Stage::Done => 1.0,
        }
    }

    fn growing(&self) -> Stage {
        let is = |rule| self.spec.is_printed(rule);
        let printed = Printed {
            order: is(PrintedRule::Order),
            stop: is(PrintedRule::Stop),
            removal: is(PrintedRule::Removal),
        };
        Stage::Growing(Box::new(Greedy::as_printed(self.problem.clone(), printed)))
    }

    fn options(&self) -> ExactOptions {
        let objective = objective_of(&self.spec);
        ExactOptions { objective, policy: policy(self.spec.policy), pins: self.pins.clone() }
    }

    /// Takes the optimum of the method `exact`, or of the rescue of a greedy matching.
    fn solved(&mut self, optimum: Optimum) -> Stage {
        let is_occluded = |k: &usize| optimum.occluded.binary_search(k).is_ok();
        let lines: Vec<RulingLine> =
            (0..optimum.lines.len()).filter(|k| !is_occluded(k)).map(|k| optimum.lines[k]).collect();
        let visible = assemble(&self.problem, lines, &optimum.best);
        self.found.matching = Matching { lines: optimum.lines.clone(), ..visible };
        if !optimum.occluded.is_empty() {
            self.found.diagnostics.push(Diagnostic::Occluded { lines: optimum.occluded.clone() });
            self.found.occluded = optimum.occluded;
            return Stage::Done;
        }
        let is_integral = self.options().objective == Objective::Integral;
        if self.spec.method == Method::Exact && (!is_integral || !self.pins.is_empty()) {
            return Stage::Rating(Box::new(Exact::new(self.problem.clone(), ExactOptions::default())));
        }
        self.found.optimum = Some(optimum);
        self.one_to_one()
    }

    /// Takes the lattice optimum of J, against which the lines are rated.
    fn rated(&mut self, outcome: Result<Optimum, Box<Infeasible>>) -> Stage {
        let best = match &outcome {
            Ok(optimum) => &optimum.best,
            Err(infeasible) => &infeasible.best,
        };
        if let Method::Shift | Method::Parameter = self.spec.method {
            let shift = match (self.spec.method, self.spec.shift) {
                (Method::Parameter, _) => 0,
                // Open curves have no seam.
                _ if self.problem.ends().is_some() => 0,
                (_, Some(Shift::By(shift))) => shift,
                (_, Some(Shift::Best(_)) | None) => best_shift(&self.problem),
            };
            self.found.matching = assemble(&self.problem, shifted(&self.problem, shift), best);
        }
        let is_stuck = self.spec.method == Method::Greedy && !self.found.matching.is_complete();
        match outcome {
            Ok(optimum) if is_stuck && self.spec.policy == Policy::Repair => return self.solved(optimum),
            Ok(optimum) => {
                if is_stuck {
                    self.found.diagnostics.push(Diagnostic::Solvable);
                }
                self.found.optimum = Some(optimum);
            }
            Err(infeasible) if is_stuck => self.found.diagnostics.extend(why(&infeasible)),
            Err(_) => {}
        }
        self.one_to_one()
    }

    /// Begins with one-to-one lines, where they are asked for and the lines allow it.
    fn one_to_one(&mut self) -> Stage {
        let matching = &self.found.matching;
        let may = self.spec.one_to_one && (matching.is_complete() || self.spec.method != Method::Greedy);
        if !may || matching.lines.is_empty() {
            return self.finish();
        }
        match self.spec.method {
            Method::Greedy => {
                let job = Insertion::new(&self.curves, &self.samples, &self.problem, matching);
                Stage::Inserting(Box::new(job))
            }
            Method::Exact if self.pins.is_empty() && self.options().objective == Objective::Integral => {
                if self.is_coarse {
                    self.found.is_coarse = true;
                    return self.even();
                }
                let (curves, gap, weights) =
                    (self.curves.clone(), self.problem.gap(), self.problem.weights());
                Stage::Refining(Box::new(match self.problem.ends() {
                    None => Refine::new(curves, weights, gap),
                    Some(ends) => Refine::open(curves, weights, gap, ends),
                }))
            }
            Method::Exact => self.even(),
            Method::OnePerVertex => self.placing(&self.problem, &fill_in(&self.problem, &matching.lines)),
            Method::Shift | Method::Parameter => {
                self.placing(&self.problem, &places_of(&self.problem, &matching.lines))
            }
        }
    }

    fn placing(&self, problem: &Problem, places: &[[f64; 2]]) -> Stage {
        Stage::Placing(Box::new(Placing::new(&self.curves, problem, places)))
    }

    /// Spreads lines evenly along the refined optimum, or along that of the samples where there is none.
    fn even(&mut self) -> Stage {
        let (a, b) = self.problem.counts();
        let count = self.spec.lines.unwrap_or(a.max(b));
        let (problem, spread) = if let Some(Refined { problem, places, .. }) = &self.found.refined {
            let (a, b) = problem.counts();
            let even = even_places(&self.curves, problem, places, count, 1.0 / a.max(b) as f64);
            (problem.clone(), Spread::new(places.clone(), even, &[]))
        } else {
            let lines = &self.found.matching.lines;
            let path = places_of(&self.problem, lines);
            let mut even = even_places(&self.curves, &self.problem, &path, count, 0.0);
            let is_pin = |line: &&RulingLine| self.pins.contains(&(line.from, line.to));
            let pinned: Vec<RulingLine> = lines.iter().filter(is_pin).copied().collect();
            let pinned = places_of(&self.problem, &pinned);
            let closed = self.problem.ends().is_none();
            matching::hold_places(&mut even, closed, &pinned);
            (self.problem.clone(), Spread::new(path, even, &pinned))
        };
        if problem.ends().is_some() {
            // Between open curves evenly spread lines stand or fall as they are.
            return self.placing(&problem, spread.even());
        }
        let stage = self.placing(&problem, &spread.places());
        self.spread = Some(Box::new((problem, spread)));
        stage
    }

    /// Takes verified one-to-one lines, or tries others where evenly spread ones failed.
    fn placed(&mut self, mut pairs: OneToOne) -> Stage {
        if let Some((problem, spread)) = self.spread.as_deref_mut() {
            if spread.learn(&self.curves, &pairs) {
                let places = spread.places();
                return Stage::Placing(Box::new(Placing::new(&self.curves, problem, &places)));
            }
            pairs.failed = spread.gaps(&self.curves, &pairs);
        }
        self.found.pairs = Some(Box::new(pairs));
        self.finish()
    }

    /// Rates what was found.
    fn finish(&mut self) -> Stage {
        if let Some(pairs) = &self.found.pairs {
            let lines: Vec<usize> = (0..pairs.lines.len()).filter(|&k| !pairs.verified[k]).collect();
            if !lines.is_empty() && (pairs.failed.is_empty() || self.spread.is_some()) {
                self.found.diagnostics.push(Diagnostic::Unverified { lines });
            }
        }
        if self.found.is_complete() {
            self.found.gap = self.gap();
        }
        Stage::Done
    }

    fn gap(&self) -> Option<Gap> {
        let rated = |integral: f64, optimum: f64, change: Option<f64>, kind: GapKind| {
            (optimum > 0.0).then(|| Gap { value: 1.0 - integral / optimum, optimum, change, kind })
        };
        let pairs = self.found.pairs.as_ref();
        if let (Some(refined), Some(pairs)) = (&self.found.refined, pairs) {
            let kind = if refined.has_fans { GapKind::Supremum } else { GapKind::Refined };
            return rated(pairs.totals.integral?, refined.integral, refined.change, kind);
        }
        let optimum = self.found.optimum.as_ref()?;
        let (integral, best) = match pairs {
            Some(pairs) => {
                (pairs.totals.integral?, integral_on_curves(&self.curves, &self.problem, &optimum.lines))
            }
            None => (self.found.matching.totals.integral?, optimum.value),
        };
        rated(integral, best, None, GapKind::Lattice)
    }
}

/// Two outlines with the weights of a model.
///
/// # Errors
/// When they cannot be matched.
pub(super) fn problem_on(outlines: [Outline; 2], model: &Model) -> Result<Problem, ProblemError> {
    match model.ends() {
        None => Problem::new(outlines, model.weights(), model.gap()),
        Some(ends) => Problem::open(outlines, model.weights(), model.gap(), ends),
    }
}

/// What is maximised, J where nothing is said.
pub(super) fn objective_of(spec: &super::MatchingSpec) -> Objective {
    match spec.objective {
        Some(ObjectiveName::Sum) => Objective::Sum,
        Some(ObjectiveName::SumLessPrice) => Objective::SumLessPrice(spec.line_price.unwrap_or(0.0)),
        Some(ObjectiveName::Integral) | None => Objective::Integral,
    }
}

fn policy(policy: Policy) -> matching::Policy {
    match policy {
        Policy::Strict => matching::Policy::Strict,
        Policy::Repair => matching::Policy::Repair,
    }
}

/// Values that nothing has yet.
fn blank(problem: &Problem) -> [Vec<f64>; 2] {
    let (a, b) = problem.counts();
    [vec![f64::NEG_INFINITY; a], vec![f64::NEG_INFINITY; b]]
}

/// Puts lines together with their totals.
fn assemble(problem: &Problem, lines: Vec<RulingLine>, best: &[Vec<f64>; 2]) -> Matching {
    let blind = |best: &Vec<f64>| (0..best.len()).filter(|&k| best[k] == f64::NEG_INFINITY).collect();
    let totals = measure(problem, &lines, Bound::of(problem, best, &lines));
    Matching { lines, growth: Vec::new(), orphans: best.each_ref().map(blind), totals }
}

/// Says what stands in the way of an exact matching, beyond vertices that see nothing.
fn why(infeasible: &Infeasible) -> Option<Diagnostic> {
    use matching::{Obstacle, Stretch};
    Some(match infeasible.obstacle {
        Obstacle::Orphans => return None,
        Obstacle::Jammed(Stretch { outline, first, count }) => {
            let all = infeasible.best[outline].len();
            let vertices = (first..first + count).map(|vertex| vertex % all).collect();
            Diagnostic::Jammed { curve: outline, vertices }
        }
        Obstacle::EndBlocked { .. } | Obstacle::EndsCross => {
            Diagnostic::Ends { obstacle: infeasible.obstacle }
        }
        Obstacle::NoSuchVertex { pin } | Obstacle::PinBlocked { pin } => {
            Diagnostic::Pins { pins: vec![pin], obstacle: infeasible.obstacle }
        }
        Obstacle::PinsCross { pins } | Obstacle::NoRoom { pins } => {
            let mut pins = pins.to_vec();
            pins.dedup();
            Diagnostic::Pins { pins, obstacle: infeasible.obstacle }
        }
    })
}
