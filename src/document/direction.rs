//! The direction in which open curves are matched.

use super::Model;
use super::work::{objective_of, problem_on};
use crate::curve::Samples;
use crate::matching::{Exact, ExactOptions, Infeasible, Layout, Obstacle, Optimum, Outline, Problem};

/// Two open curves matched as they were drawn, and with the second one reversed, as a job that finds out which is better.
///
/// The better one has the greater optimum of the objective of the document, J for methods without one. Where the ends are tied the lines between
/// them mostly decide at once: those that cross, or meet a curve, bound no band. Of two equal ones the direction as drawn stays.
#[derive(Debug)]
pub(super) struct Direction {
    jobs: [Exact; 2],
    outcomes: [Option<Rank>; 2],
}

/// What a direction is worth: more is better.
type Rank = (bool, f64);

impl Direction {
    /// Prepares both directions of a model of open curves as drawn; `None` where nothing is left to find out, after the model was turned if it has
    /// to be.
    pub(super) fn new(model: &mut Model) -> Option<Self> {
        let (curves, samples) = model.pair()?;
        let turned = [samples[0].clone(), samples[1].reversed(&curves[1])];
        let problem = |samples: &[Samples; 2]| problem_on(samples.each_ref().map(Outline::from), model);
        // What cannot be matched is told of the curves as they were drawn.
        let problems = [problem(samples).ok()?, problem(&turned).ok()?];
        let is_strip = |problem: &Problem| matches!(problem.layout(), Layout::Strip { .. });
        match problems.each_ref().map(is_strip) {
            [true, false] => return None,
            [false, true] => {
                model.turn(1);
                return None;
            }
            [true, true] | [false, false] => {}
        }
        let objective = objective_of(&model.document().matching);
        let mut pins = model.pins().to_vec();
        let last = samples[1].arc.len() - 1;
        let jobs = problems.map(|problem| {
            let options = ExactOptions { objective, pins: pins.clone(), ..ExactOptions::default() };
            pins.iter_mut().for_each(|pin| pin.1 = last - pin.1);
            Exact::new(problem, options)
        });
        Some(Self { jobs, outcomes: [None; 2] })
    }

    /// Advances while `may_go_on` says so, at least by a little; tells whether the model has to be turned when that is found out.
    pub(super) fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<bool> {
        for (job, outcome) in self.jobs.iter_mut().zip(&mut self.outcomes) {
            if outcome.is_none() {
                *outcome = Some(rank(&job.step(may_go_on)?));
            }
        }
        let [drawn, reversed] = self.outcomes;
        Some(reversed > drawn)
    }

    /// Share of the work that is done, from 0 to 1.
    pub(super) fn progress(&self) -> f64 {
        let share = |k: usize| if self.outcomes[k].is_some() { 1.0 } else { self.jobs[k].progress() };
        (share(0) + share(1)) / 2.0
    }
}

/// An optimum before none; among those without one fewer vertices that see nothing, and end lines that do not cross.
fn rank(outcome: &Result<Optimum, Box<Infeasible>>) -> Rank {
    match outcome {
        Ok(optimum) => (true, optimum.value),
        Err(infeasible) => {
            let orphans: usize = infeasible.orphans.iter().map(Vec::len).sum();
            let all: usize = infeasible.best.iter().map(Vec::len).sum();
            let crossed = if infeasible.obstacle == Obstacle::EndsCross { all } else { 0 };
            (false, -((orphans + crossed) as f64))
        }
    }
}
