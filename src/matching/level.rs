//! The search for the best path on one level of a refinement.

use super::Objective;
use super::lattice::Survey;
use super::path::{Path, PathFinder, lines_of};
use super::place::places_of;
use super::refine::{Refined, has_fans};
use super::rounds::Rounds;
use super::{Problem, RulingLine};

/// Relative change from one level to the next below which a refinement ends.
pub(super) const SMALL_CHANGE: f64 = 1e-4;

/// Samples of two curves, and the path of greatest J among them, as a job that advances in steps.
#[derive(Debug)]
pub(super) struct Level {
    problem: Problem,
    survey: Survey,
    rounds: Option<Rounds>,
}

impl Level {
    /// A search that has not begun.
    pub(super) fn new(problem: Problem, survey: Survey) -> Self {
        Self { problem, survey, rounds: None }
    }

    /// Advances while `may_go_on` says so, at least by a little. Returns the best path when it is found, or an inner `None` where there is none.
    pub(super) fn step(
        &mut self,
        finder: &mut PathFinder,
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> Option<Option<Path>> {
        let rounds = loop {
            if let Some(rounds) = &mut self.rounds {
                break rounds;
            }
            if !self.survey.advance(&self.problem) {
                self.rounds = Some(Rounds::new(self.survey.lattice(), Objective::Integral.rule()));
            }
            if !may_go_on() {
                return None;
            }
        };
        while rounds.advance(self.survey.lattice(), finder) {
            if !may_go_on() {
                return None;
            }
        }
        Some(rounds.best().cloned())
    }

    /// What a path found on this level gives: its lines and the correspondence, which does not know yet by how much J changed.
    pub(super) fn end(self, path: &Path) -> (Vec<RulingLine>, Refined) {
        let lines = lines_of(self.survey.lattice(), path.cells());
        let places = places_of(&self.problem, &lines);
        let has_fans = has_fans(&self.problem, &lines, &places);
        let refined = Refined { integral: path.value, change: None, places, has_fans, problem: self.problem };
        (lines, refined)
    }
}
