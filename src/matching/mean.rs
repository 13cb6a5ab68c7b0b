//! The best mean over all matchings.

use super::lattice::Survey;
use super::path::{Path, PathFinder, lines_of};
use super::rounds::Rounds;
use super::{Objective, Problem, RulingLine};

/// Returns the lines of the greatest mean of f among matchings that keep the constraints, in cyclic order, and that mean; `None` when no
/// matching does. It favours few lines.
///
/// # References
/// W. Dinkelbach, "On nonlinear fractional programming", *Management Science* 13 (1967): the price of a line is raised to the mean of
/// the best set at the last price until that set has no value left above it.
#[must_use]
pub fn best_mean(problem: &Problem) -> Option<(Vec<RulingLine>, f64)> {
    let mut survey = Survey::new(problem);
    while survey.advance(problem) {}
    let (lattice, mut finder) = (survey.lattice(), PathFinder::default());
    let mut best: Option<(Vec<RulingLine>, f64)> = None;
    loop {
        let objective = best.as_ref().map_or(Objective::Sum, |(_, mean)| Objective::SumLessPrice(*mean));
        let mut rounds = Rounds::new(lattice, objective.rule());
        while rounds.advance(lattice, &mut finder) {}
        let lines = lines_of(lattice, rounds.best().into_iter().flat_map(Path::cells));
        let mean = lines.iter().map(|line| line.value).sum::<f64>() / lines.len() as f64;
        // The mean rises with every round but the last, over finitely many sets of lines.
        match &best {
            Some((_, before)) if mean > *before => best = Some((lines, mean)),
            None if !lines.is_empty() => best = Some((lines, mean)),
            Some(_) | None => return best,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::test_shapes::{Numbers, random_problem};
    use super::super::{ExactOptions, exact, irredundant};
    use super::*;

    #[test]
    fn no_other_solver_has_a_better_mean_and_no_price_leaves_value_above_it() {
        let mut numbers = Numbers(71);
        let mut feasible = 0;
        for case in 0..200 {
            let problem = random_problem(&mut numbers, 3, 24);
            let best = best_mean(&problem);
            let solve = |objective| exact(&problem, ExactOptions { objective, ..ExactOptions::default() });
            let Some((_, mean)) = best else {
                assert!(solve(Objective::Sum).is_err(), "case {case}");
                continue;
            };
            feasible += 1;
            let of = |lines: &[RulingLine]| lines.iter().map(|l| l.value).sum::<f64>() / lines.len() as f64;
            for objective in [Objective::Sum, Objective::Integral, Objective::SumLessPrice(0.4)] {
                let lines = solve(objective).expect("feasible").lines;
                assert!(of(&lines) <= mean * (1.0 + 1e-12) + 1e-12, "case {case}, {objective:?}");
            }
            let lines = irredundant(&problem).expect("feasible");
            assert!(of(&lines) <= mean * (1.0 + 1e-12) + 1e-12, "case {case}");
            let left = solve(Objective::SumLessPrice(mean)).expect("feasible").value;
            assert!(left.abs() <= 1e-9 * mean.abs().max(1.0), "case {case}: {left} left at the price {mean}");
        }
        assert!(feasible > 80, "{feasible}");
    }
}
