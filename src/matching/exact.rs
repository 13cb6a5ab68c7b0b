//! The exact optimum over all matchings of two outlines.

use super::lattice::{ABSENT, Lattice, Survey};
use super::measure::cross;
use super::path::{Path, PathFinder, Rule, lines_of};
use super::pins::pinned_paths;
use super::rounds::Rounds;
use super::stretch::shortest_stretch;
use super::{ExactOptions, Greedy, Objective, Obstacle, Policy, Problem, RulingLine};

/// The best matching of its kind.
#[derive(Debug, Clone, PartialEq)]
pub struct Optimum {
    /// Lines in cyclic order: ascending `from`, then ascending `lifted`.
    pub lines: Vec<RulingLine>,
    /// The greatest value of the objective; of the visible lines alone where there are occluded ones.
    pub value: f64,
    /// Indices of the lines that are not visible; empty unless the policy is [`Policy::Repair`].
    pub occluded: Vec<usize>,
    /// Greatest value of a visible line at each vertex of each outline, minus infinity where there is none.
    pub best: [Vec<f64>; 2],
}

/// Why no matching keeps the constraints.
#[derive(Debug, Clone, PartialEq)]
pub struct Infeasible {
    /// Vertices of each outline that see no vertex of the other.
    pub orphans: [Vec<usize>; 2],
    /// What stands in the way.
    pub obstacle: Obstacle,
    /// Greatest value of a visible line at each vertex, as in [`Optimum::best`].
    pub best: [Vec<f64>; 2],
}

/// Solves exactly, in one go; the same as running [`Exact`] to its end.
///
/// # Errors
/// When no matching keeps the constraints, with what stands in the way.
pub fn exact(problem: &Problem, options: ExactOptions) -> Result<Optimum, Box<Infeasible>> {
    let mut job = Exact::new(problem.clone(), options);
    loop {
        if let Some(outcome) = job.step(&mut || true) {
            return outcome;
        }
    }
}

/// Exact matching as a job that advances in steps.
///
/// A matching is a closed monotone path on the lattice of lifted lines, so that the best one is found by dynamic
/// programming over all starts in one row (Maes' divide and conquer), or between pins.
#[derive(Debug)]
pub struct Exact {
    problem: Problem,
    options: ExactOptions,
    finder: PathFinder,
    state: State,
}

#[derive(Debug)]
enum State {
    Looking(Box<Survey>),
    Searching(Box<Search>),
}

#[derive(Debug)]
struct Search {
    lattice: Lattice,
    rounds: Rounds,
    /// The lattice of the visible lines alone, once `lattice` has occluded ones.
    visible: Option<Lattice>,
}

impl Exact {
    /// A job that has not begun.
    #[must_use]
    pub fn new(problem: Problem, options: ExactOptions) -> Self {
        let state = State::Looking(Box::new(Survey::new(&problem)));
        Self { problem, options, finder: PathFinder::default(), state }
    }

    /// A job on the problem of a greedy one that is done, which spares looking for visible lines again.
    #[must_use]
    pub fn after(greedy: &mut Greedy, options: ExactOptions) -> Self {
        let lattice = greedy.take_lattice();
        let problem = greedy.problem().clone();
        if lattice.height() < problem.counts().0 {
            return Self::new(problem, options);
        }
        let rounds = Rounds::new(&lattice, options.objective.rule());
        let state = State::Searching(Box::new(Search { lattice, rounds, visible: None }));
        Self { problem, options, finder: PathFinder::default(), state }
    }

    /// The problem that is being solved.
    #[must_use]
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// Share of the work that is done, from 0 to 1; finding out what is visible is most of it.
    #[must_use]
    pub fn progress(&self) -> f64 {
        match &self.state {
            State::Looking(survey) => survey.lattice().height() as f64 / self.problem.counts().0 as f64 * 0.8,
            State::Searching(_) => 0.8,
        }
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the outcome when it is found.
    ///
    /// # Errors
    /// The outcome is an error when no matching keeps the constraints.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Result<Optimum, Box<Infeasible>>> {
        let rule = self.options.objective.rule();
        if let State::Looking(survey) = &mut self.state {
            while survey.advance(&self.problem) {
                if !may_go_on() {
                    return None;
                }
            }
            let lattice = survey.take();
            let rounds = Rounds::new(&lattice, rule);
            self.state = State::Searching(Box::new(Search { lattice, rounds, visible: None }));
        }
        let State::Searching(search) = &mut self.state else { return None };
        let pins = &self.options.pins;
        loop {
            let found = if let Some(Obstacle::EndsCross) = end_obstacle(&self.problem, &search.lattice) {
                Err(Some(Obstacle::EndsCross))
            } else if pins.is_empty() {
                while search.rounds.advance(&search.lattice, &mut self.finder) {
                    if !may_go_on() {
                        return None;
                    }
                }
                search.rounds.best().map(|path| vec![path.clone()]).ok_or(None)
            } else {
                pinned_paths(&self.problem, &search.lattice, rule, pins, &mut self.finder).map_err(Some)
            };
            match found {
                Ok(paths) => return Some(Ok(search.optimum(&self.problem, rule, &paths))),
                Err(_) if self.options.policy == Policy::Repair && search.visible.is_none() => {
                    let repaired = with_occluded(&self.problem, &search.lattice);
                    search.rounds = Rounds::new(&repaired, rule);
                    search.visible = Some(std::mem::replace(&mut search.lattice, repaired));
                }
                Err(obstacle) => return Some(Err(Box::new(search.infeasible(&self.problem, obstacle)))),
            }
        }
    }
}

impl Search {
    fn optimum(&self, problem: &Problem, rule: Rule, paths: &[Path]) -> Optimum {
        let visible = self.visible.as_ref().unwrap_or(&self.lattice);
        let mut lines = lines_of(&self.lattice, paths.iter().flat_map(Path::cells));
        lines.iter_mut().for_each(|line| line.value = problem.value(line.from, line.to));
        let is_occluded = |line: &RulingLine| visible.row(line.from).at(line.lifted) == ABSENT;
        let occluded: Vec<usize> = (0..lines.len()).filter(|&k| is_occluded(&lines[k])).collect();
        let value = if occluded.is_empty() {
            paths.iter().map(|path| path.value).sum()
        } else {
            worth(&self.lattice, rule, &lines, &occluded)
        };
        Optimum { lines, value, occluded, best: visible.best() }
    }

    fn infeasible(&self, problem: &Problem, obstacle: Option<Obstacle>) -> Infeasible {
        let visible = self.visible.as_ref().unwrap_or(&self.lattice);
        let best = visible.best();
        let orphans = best
            .each_ref()
            .map(|best| (0..best.len()).filter(|&vertex| best[vertex] == ABSENT).collect::<Vec<_>>());
        let is_blind = orphans.iter().any(|orphans| !orphans.is_empty());
        let obstacle = match obstacle {
            Some(obstacle @ Obstacle::NoRoom { .. }) => {
                // Without pins it may be just as impossible, and then the pins are not to blame.
                let rule = Objective::Integral.rule();
                let (mut rounds, mut finder) = (Rounds::new(visible, rule), PathFinder::default());
                while rounds.best().is_none() && rounds.advance(visible, &mut finder) {}
                rounds.best().map(|_| obstacle)
            }
            obstacle => obstacle,
        };
        let obstacle = obstacle.or_else(|| end_obstacle(problem, visible)).unwrap_or_else(|| {
            if is_blind { Obstacle::Orphans } else { Obstacle::Jammed(shortest_stretch(visible)) }
        });
        Infeasible { orphans, obstacle, best }
    }
}

/// What is wrong with the lines between the ends of open outlines that have to be joined.
fn end_obstacle(problem: &Problem, visible: &Lattice) -> Option<Obstacle> {
    let tied = problem.tied()?;
    let is_blocked = |(from, to): (usize, usize)| visible.row(from).at(to as i64) == ABSENT;
    if let Some(last) = tied.into_iter().position(is_blocked) {
        return Some(Obstacle::EndBlocked { last: last == 1 });
    }
    let line = |(from, to): (usize, usize)| visible.line(from, to as i64);
    cross(problem.outlines(), &line(tied[0]), &line(tied[1])).then_some(Obstacle::EndsCross)
}

/// The objective over lines in cyclic order, where occluded ones count nothing.
fn worth(lattice: &Lattice, rule: Rule, lines: &[RulingLine], occluded: &[usize]) -> f64 {
    let Rule::Cover { cells, steps, price } = rule else { return 0.0 };
    let value = |k: usize| if occluded.binary_search(&k).is_ok() { None } else { Some(lines[k].value) };
    let each = |k: usize| {
        let (line, next) = (lines[k], lines[(k + 1) % lines.len()]);
        let mass = |outline: usize, from: usize, to: usize| {
            if from == to { 0.0 } else { lattice.mass(outline, to) }
        };
        let mass = mass(0, line.from, next.from) + mass(1, line.to, next.to);
        let ends = value(k).unwrap_or(0.0) + value((k + 1) % lines.len()).unwrap_or(0.0);
        let closes = lattice.ends().is_none() || k + 1 < lines.len();
        let mass = if closes { mass } else { 0.0 };
        value(k).map_or(0.0, |value| cells * value - price) + steps * mass * ends / 2.0
    };
    (0..lines.len()).map(each).sum()
}

/// Adds to the visible lines every occluded one, on its own lap and the two beside it, at a value so low that fewer occluded
/// lines always win.
fn with_occluded(problem: &Problem, visible: &Lattice) -> Lattice {
    let (a, b) = problem.counts();
    let values = (0..a).flat_map(|row| visible.row(row).values.iter().copied());
    let largest = values.filter(|value| *value != ABSENT).fold(0.0, |most: f64, value| most.max(value.abs()));
    let largest = if largest > 0.0 { largest } else { 1.0 };
    let penalty = -largest * (1e3 + 4.0 * (a + b) as f64);
    let mut lattice = Lattice::of(problem);
    let mut row = Vec::new();
    for from in 0..a {
        row.clear();
        let cells = visible.row(from);
        let mut is_visible = vec![false; b];
        for column in cells.columns() {
            is_visible[visible.vertex(column)] = true;
            row.push((column, cells.at(column)));
        }
        for to in (0..b).filter(|&to| !is_visible[to]) {
            let lifted = problem.lift(from, to);
            let laps: &[i64] = if problem.ends().is_some() { &[0] } else { &[-1, 0, 1] };
            row.extend(laps.iter().map(|laps| (lifted + laps * b as i64, penalty)));
        }
        lattice.push_row(&row);
    }
    lattice
}

#[cfg(test)]
mod tests {
    use super::super::rounds::best_by_brute_force;
    use super::super::test_shapes::{Numbers, random_crossing, random_problem};
    use super::super::{Bound, blocking_edge, measure};
    use super::*;
    use crate::geom::segments_meet;

    const OBJECTIVES: [Objective; 3] = [Objective::Integral, Objective::Sum, Objective::SumLessPrice(0.3)];

    fn lattice(problem: &Problem) -> Lattice {
        let mut survey = Survey::new(problem);
        while survey.advance(problem) {}
        survey.take()
    }

    fn solve(problem: &Problem, objective: Objective) -> Result<Optimum, Box<Infeasible>> {
        exact(problem, ExactOptions { objective, ..ExactOptions::default() })
    }

    fn assert_close(x: f64, y: f64, what: &str) {
        assert!((x - y).abs() <= 1e-9 * x.abs().max(y.abs()).max(1e-3), "{what}: {x} against {y}");
    }

    /// The best cover by a search over sets of visible lines no two of which cross as segments; it knows no lattice. Lifts only
    /// put the lines of a finished set in order.
    fn best_by_conflicts(problem: &Problem, objective: Objective) -> Option<f64> {
        let (a, b) = problem.counts();
        let [first, second] = problem.outlines();
        let visible = |i: usize, j: usize| problem.is_visible(i, j);
        let lines: Vec<(usize, usize)> =
            (0..a).flat_map(|i| (0..b).map(move |j| (i, j))).filter(|&(i, j)| visible(i, j)).collect();
        let crosses = |(i, j): (usize, usize), (k, l): (usize, usize)| {
            i != k
                && j != l
                && segments_meet(first.points[i], second.points[j], first.points[k], second.points[l])
        };
        let worth = |chosen: &[(usize, usize)]| {
            let mut lines: Vec<RulingLine> = chosen
                .iter()
                .map(|&(from, to)| RulingLine {
                    from,
                    to,
                    lifted: problem.lift(from, to),
                    value: problem.value(from, to),
                })
                .collect();
            lines.sort_by_key(|line| (line.from, line.lifted));
            let totals = measure(problem, &lines, Bound::new(problem, &[vec![1.0; a], vec![1.0; b]]));
            totals.integral.map(|integral| match objective {
                Objective::Integral => integral,
                Objective::Sum => totals.sum,
                Objective::SumLessPrice(price) => totals.sum - price * totals.count as f64,
            })
        };
        let mut best: Option<f64> = None;
        let mut stack = vec![(0, Vec::new())];
        while let Some((next, chosen)) = stack.pop() {
            let Some(&line) = lines.get(next) else {
                let value = worth(&chosen);
                best = best.into_iter().chain(value).reduce(f64::max);
                continue;
            };
            let covers_row = |i: usize| chosen.iter().any(|&(k, _)| k == i);
            if line.0 > 0 && !covers_row(line.0 - 1) {
                continue;
            }
            stack.push((next + 1, chosen.clone()));
            if chosen.iter().all(|&other| !crosses(line, other)) {
                let with = chosen.iter().copied().chain([line]).collect();
                stack.push((next + 1, with));
            }
        }
        best
    }

    #[test]
    fn small_instances_equal_a_search_without_a_lattice() {
        let mut numbers = Numbers(20_261_125);
        let (mut feasible, mut infeasible) = (0, 0);
        for case in 0..180 {
            let make = if case < 120 { random_problem } else { random_crossing };
            let problem = make(&mut numbers, 3, 5);
            for objective in OBJECTIVES {
                let expected = best_by_conflicts(&problem, objective);
                let found = solve(&problem, objective);
                match (expected, &found) {
                    (Some(expected), Ok(found)) => {
                        assert_close(found.value, expected, &format!("case {case}, {objective:?}"));
                        feasible += 1;
                    }
                    (None, Err(_)) => infeasible += 1,
                    _ => panic!("case {case}, {objective:?}: {expected:?} against {found:?}"),
                }
            }
        }
        assert!(feasible > 300 && infeasible > 100, "{feasible} and {infeasible}");
    }

    #[test]
    fn divide_and_conquer_equals_brute_force() {
        let mut numbers = Numbers(77);
        let (mut feasible, mut infeasible) = (0, 0);
        for case in 0..1500 {
            let problem = random_problem(&mut numbers, 3, 24);
            let lattice = lattice(&problem);
            for objective in OBJECTIVES {
                let brute = best_by_brute_force(&lattice, objective.rule());
                let found = solve(&problem, objective);
                match (brute, &found) {
                    (Some(brute), Ok(found)) => {
                        assert_close(found.value, brute.value, &format!("case {case}, {objective:?}"));
                        feasible += 1;
                    }
                    (None, Err(_)) => infeasible += 1,
                    (brute, _) => panic!("case {case}, {objective:?}: {brute:?} against {found:?}"),
                }
            }
        }
        assert!(feasible > 2000 && infeasible > 500, "{feasible} and {infeasible}");
    }

    #[test]
    fn values_and_certificates_are_those_of_the_lines() {
        let mut numbers = Numbers(5);
        for case in 0..300 {
            let problem = random_problem(&mut numbers, 3, 40);
            for objective in OBJECTIVES {
                let Ok(found) = solve(&problem, objective) else { continue };
                let totals = measure(&problem, &found.lines, Bound::new(&problem, &found.best));
                assert_eq!((totals.crossings, totals.blocked), (0, 0), "case {case}");
                let value = match objective {
                    Objective::Integral => totals.integral.expect("covered"),
                    Objective::Sum => totals.sum,
                    Objective::SumLessPrice(price) => totals.sum - price * totals.count as f64,
                };
                assert_close(found.value, value, &format!("case {case}, {objective:?}"));
                assert!(totals.eta.is_none_or(|eta| eta <= 1.0 + 1e-12), "case {case}");
                let worth = worth(&lattice(&problem), objective.rule(), &found.lines, &[]);
                assert_close(found.value, worth, &format!("case {case}, {objective:?}"));
            }
        }
    }

    fn with_pins(problem: &Problem, pins: Vec<(usize, usize)>) -> Result<Optimum, Box<Infeasible>> {
        exact(problem, ExactOptions { pins, ..ExactOptions::default() })
    }

    fn holds(optimum: &Optimum, (from, to): (usize, usize)) -> bool {
        optimum.lines.iter().any(|line| (line.from, line.to) == (from, to))
    }

    #[test]
    fn pins_are_held_and_pinning_the_optimum_changes_nothing() {
        let mut numbers = Numbers(31);
        let (mut held, mut refused) = (0, 0);
        for case in 0..200 {
            let problem = random_problem(&mut numbers, 3, 30);
            let Ok(free) = solve(&problem, Objective::Integral) else { continue };
            let picked: Vec<(usize, usize)> =
                free.lines.iter().filter(|_| numbers.next() < 0.3).map(|line| (line.from, line.to)).collect();
            let again = with_pins(&problem, picked).expect("the optimum holds them");
            assert_close(again.value, free.value, &format!("case {case}"));
            let (a, b) = problem.counts();
            let pins: Vec<(usize, usize)> =
                (0..2).map(|_| (numbers.whole(0, a - 1), numbers.whole(0, b - 1))).collect();
            match with_pins(&problem, pins.clone()) {
                Ok(pinned) => {
                    held += 1;
                    assert!(pins.iter().all(|&pin| holds(&pinned, pin)), "case {case}: {pins:?}");
                    assert!(pinned.value <= free.value * (1.0 + 1e-12) + 1e-12, "case {case}");
                    let totals = measure(&problem, &pinned.lines, Bound::new(&problem, &pinned.best));
                    assert_eq!((totals.crossings, totals.blocked), (0, 0), "case {case}");
                    assert_close(totals.integral.expect("covered"), pinned.value, "value");
                }
                Err(infeasible) => {
                    refused += 1;
                    let ends = |pin: usize| {
                        let (from, to) = pins[pin];
                        (problem.outlines()[0].points[from], problem.outlines()[1].points[to])
                    };
                    match infeasible.obstacle {
                        Obstacle::PinBlocked { pin } => {
                            let (from, to) = pins[pin];
                            assert!(blocking_edge(problem.outlines(), from, to).is_some(), "case {case}");
                        }
                        Obstacle::PinsCross { pins: [i, k] } => {
                            let ((p, q), (r, s)) = (ends(i), ends(k));
                            assert!(segments_meet(p, q, r, s), "case {case}: {pins:?}");
                        }
                        Obstacle::NoRoom { .. } => {}
                        other => panic!("case {case}: {other}"),
                    }
                }
            }
        }
        assert!(held > 10 && refused > 50, "{held} and {refused}");
    }

    #[test]
    fn pins_that_name_nothing_are_refused() {
        let problem = random_problem(&mut Numbers(8), 6, 6);
        let refused = with_pins(&problem, vec![(0, 99)]).expect_err("there are 6 vertices");
        assert_eq!(refused.obstacle, Obstacle::NoSuchVertex { pin: 0 });
    }

    #[test]
    fn repair_reaches_every_vertex_with_fewest_occluded_lines() {
        let mut numbers = Numbers(123);
        let mut repaired = 0;
        for case in 0..400 {
            let problem = random_problem(&mut numbers, 3, 16);
            for objective in OBJECTIVES {
                let strict = solve(&problem, objective);
                let options = ExactOptions { objective, policy: Policy::Repair, ..ExactOptions::default() };
                let found = exact(&problem, options).expect("occluded lines reach everything");
                match strict {
                    Ok(strict) => assert_eq!(found, strict, "case {case}: nothing to repair"),
                    Err(_) => {
                        repaired += 1;
                        assert!(!found.occluded.is_empty(), "case {case}");
                    }
                }
                for (k, line) in found.lines.iter().enumerate() {
                    let blocked = blocking_edge(problem.outlines(), line.from, line.to).is_some();
                    assert_eq!(blocked, found.occluded.contains(&k), "case {case}, line {k}");
                }
                let totals = measure(&problem, &found.lines, Bound::new(&problem, &found.best));
                assert!(totals.uncovered.iter().all(Vec::is_empty), "case {case}");
                let next = found.lines.iter().skip(1);
                assert!(found.lines.iter().zip(next).all(|(l, n)| l.from <= n.from && l.lifted <= n.lifted));
            }
        }
        assert!(repaired > 100, "{repaired}");
    }

    #[test]
    fn jammed_vertices_lie_in_a_stretch_that_visible_lines_cannot_pass() {
        let mut numbers = Numbers(44);
        let (mut jammed, mut blind) = (0, 0);
        for case in 0..800 {
            let problem = random_problem(&mut numbers, 4, 20);
            let Err(infeasible) = solve(&problem, Objective::Sum) else { continue };
            match infeasible.obstacle {
                Obstacle::Orphans => {
                    blind += 1;
                    let sees = |i: usize, j: usize| blocking_edge(problem.outlines(), i, j).is_none();
                    let (a, b) = problem.counts();
                    let orphans: [Vec<usize>; 2] = [
                        (0..a).filter(|&i| (0..b).all(|j| !sees(i, j))).collect(),
                        (0..b).filter(|&j| (0..a).all(|i| !sees(i, j))).collect(),
                    ];
                    assert_eq!(infeasible.orphans, orphans, "case {case}");
                }
                Obstacle::Jammed(stretch) => {
                    jammed += 1;
                    let counts = problem.counts();
                    let count = if stretch.outline == 0 { counts.0 } else { counts.1 };
                    assert!(stretch.count >= 2 && stretch.count <= count && stretch.first < count);
                }
                other => panic!("case {case}: {other}"),
            }
        }
        assert!(jammed > 5 && blind > 50, "{jammed} and {blind}");
    }

    #[test]
    fn steps_may_be_interrupted_anywhere() {
        let problem = random_problem(&mut Numbers(3), 30, 40);
        let mut job = Exact::new(problem.clone(), ExactOptions::default());
        let mut pauses = 0;
        let outcome = loop {
            if let Some(outcome) = job.step(&mut || false) {
                break outcome;
            }
            pauses += 1;
            assert!(job.progress() <= 1.0);
        };
        assert!(pauses > 30);
        assert_eq!(outcome, solve(&problem, Objective::Integral));
    }

    #[test]
    fn crossing_projections_are_matched_between_them() {
        let mut numbers = Numbers(2);
        let mut feasible = 0;
        for case in 0..400 {
            let problem = random_crossing(&mut numbers, 4, 30);
            let lattice = lattice(&problem);
            let (a, b) = problem.counts();
            for (i, j) in (0..a).flat_map(|i| (0..b).map(move |j| (i, j))) {
                let is_line = lattice.row(i).at(problem.lift(i, j)) != ABSENT;
                assert_eq!(is_line, problem.is_visible(i, j), "case {case}: {i} to {j}");
            }
            let Ok(found) = solve(&problem, Objective::Integral) else { continue };
            feasible += 1;
            let totals = measure(&problem, &found.lines, Bound::new(&problem, &found.best));
            assert_eq!((totals.crossings, totals.blocked), (0, 0), "case {case}");
        }
        assert!(feasible > 150, "{feasible}");
    }

    #[test]
    fn after_a_greedy_job_the_outcome_is_the_same_and_stuck_lines_have_a_cover() {
        let mut numbers = Numbers(55);
        let mut stuck = 0;
        for case in 0..300 {
            let problem = random_problem(&mut numbers, 4, 24);
            let mut job = Greedy::new(problem.clone());
            let matching = loop {
                if let Some(matching) = job.step(&mut || true) {
                    break matching;
                }
            };
            let mut after = Exact::after(&mut job, ExactOptions::default());
            let outcome = after.step(&mut || true).expect("it was told to go on");
            assert_eq!(outcome, solve(&problem, Objective::Integral), "case {case}");
            match &outcome {
                Ok(optimum) if matching.is_complete() => {
                    let integral = matching.totals.integral.expect("covered");
                    assert!(integral <= optimum.value * (1.0 + 1e-12) + 1e-12, "case {case}");
                }
                Ok(_) => stuck += 1,
                Err(_) => assert!(!matching.is_complete(), "case {case}"),
            }
        }
        assert!(stuck > 0, "{stuck}");
    }
}
