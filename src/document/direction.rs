//! The direction in which open curves are matched.

use super::work::{objective_of, problem_of};
use super::{DocumentError, Model};
use crate::matching::{Exact, ExactOptions, Infeasible, Layout, Obstacle, Optimum, ProblemError};

/// Two open curves matched as they were drawn, and with the second one reversed, as a job that finds out which is better.
///
/// The better one has the greater optimum of the objective of the document, J for methods without one. Where the ends are tied the lines between
/// them mostly decide at once: those that cross, or meet a curve, bound no band. Of two equal ones the direction as drawn stays.
#[derive(Debug)]
pub(super) struct Direction {
    models: Option<[Model; 2]>,
    jobs: [Exact; 2],
    outcomes: [Option<Rank>; 2],
}

/// What a direction is worth: more is better.
type Rank = (bool, f64);

impl Direction {
    /// Prepares both directions of a model of open curves as drawn; the model itself, turned as it must be, where that is clear.
    ///
    /// # Errors
    /// When the document has no model, see [`Model::new`].
    pub(super) fn new(model: Model) -> Result<Result<Self, Box<Model>>, DocumentError> {
        let turned = Model::turned(model.document().clone(), true)?;
        let problems = (|| Ok::<_, ProblemError>([problem_of(&model)?, problem_of(&turned)?]))();
        // What cannot be matched is told of the curves as they were drawn.
        let Ok([Some(drawn), Some(reversed)]) = problems else { return Ok(Err(Box::new(model))) };
        let is_strip = |layout: Layout| matches!(layout, Layout::Strip { .. });
        match [drawn.layout(), reversed.layout()].map(is_strip) {
            [true, false] => return Ok(Err(Box::new(model))),
            [false, true] => return Ok(Err(Box::new(turned))),
            [true, true] | [false, false] => {}
        }
        let job = |problem, model: &Model| {
            let pins = model.pins().to_vec();
            let objective = objective_of(&model.document().matching);
            Exact::new(problem, ExactOptions { objective, pins, ..ExactOptions::default() })
        };
        let jobs = [job(drawn, &model), job(reversed, &turned)];
        Ok(Ok(Self { models: Some([model, turned]), jobs, outcomes: [None; 2] }))
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the model in the better direction when it is found.
    pub(super) fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Model> {
        for (job, outcome) in self.jobs.iter_mut().zip(&mut self.outcomes) {
            if outcome.is_none() {
                *outcome = Some(rank(&job.step(may_go_on)?));
            }
        }
        let [drawn, reversed] = self.outcomes;
        let [model, turned] = self.models.take()?;
        Some(if reversed > drawn { turned } else { model })
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
