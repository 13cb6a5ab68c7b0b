//! The best matching of at most one line a vertex.

use super::lattice::{ABSENT, Survey};
use super::path::{PathFinder, Rule, lines_of};
use super::place::shares_of;
use super::rounds::Rounds;
use super::{Problem, RulingLine};

/// The papers' dynamic programme (Eq. 14) as a job: the greatest sum of f over visible lines that do not cross, at most one a
/// vertex, started from wherever is best; between open outlines whose ends are tied the first vertices are joined, and the last ones.
///
/// Printed, the recursion has the same arguments on both sides and no start; taken as meant it is the heaviest chain of lines whose
/// ends ascend strictly round the band, found here over all starts by Maes' divide and conquer. Lines of negative value are left
/// out. Vertices may stay without a line; the paper gives them lines of its own making afterwards, see
/// [`fill_in`](super::fill_in).
#[derive(Debug)]
pub struct OnePerVertex {
    problem: Problem,
    survey: Survey,
    rounds: Option<Rounds>,
    finder: PathFinder,
}

/// The lines of [`OnePerVertex`].
#[derive(Debug, Clone, PartialEq)]
pub struct SingleLines {
    /// Lines in cyclic order.
    pub lines: Vec<RulingLine>,
    /// Greatest value of a visible line at each vertex of each outline, minus infinity where there is none.
    pub best: [Vec<f64>; 2],
}

/// Finds the best matching of at most one line a vertex, in one go.
#[must_use]
pub fn one_per_vertex(problem: &Problem) -> SingleLines {
    let mut job = OnePerVertex::new(problem.clone());
    loop {
        if let Some(found) = job.step(&mut || true) {
            return found;
        }
    }
}

impl OnePerVertex {
    /// A job that has not begun.
    #[must_use]
    pub fn new(problem: Problem) -> Self {
        Self { survey: Survey::new(&problem), problem, rounds: None, finder: PathFinder::default() }
    }

    /// The problem that is being solved.
    #[must_use]
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// Share of the work that is done, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.survey.lattice().height() as f64 / self.problem.counts().0 as f64 * 0.8
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the lines when they are found.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<SingleLines> {
        while self.rounds.is_none() {
            if !self.survey.advance(&self.problem) {
                self.rounds = Some(Rounds::new(self.survey.lattice(), Rule::Single));
            } else if !may_go_on() {
                return None;
            }
        }
        let (lattice, rounds) = (self.survey.lattice(), self.rounds.as_mut()?);
        while rounds.advance(lattice, &mut self.finder) {
            if !may_go_on() {
                return None;
            }
        }
        let path = rounds.best()?;
        let mut lines = lines_of(lattice, path.diagonals());
        if let Some(tied) = self.problem.tied() {
            let line = |(from, to): (usize, usize)| lattice.line(from, to as i64);
            let [first, last] = tied.map(line).map(|line| (line.value != ABSENT).then_some(line));
            lines.splice(0..0, first);
            lines.extend(last);
        }
        Some(SingleLines { lines, best: lattice.best() })
    }
}

/// Gives every vertex a line: those that [`OnePerVertex`] left out are joined to the place that lies, in arc length, in the same proportion
/// between the ends of the lines before and after; beyond the first and the last line between open outlines there are none. Returns the
/// ends of all lines in shares of arc length, strictly ascending.
///
/// The paper says only that points without a line get one; nothing keeps these lines clear of the curves, so they must be verified.
#[must_use]
pub fn fill_in(problem: &Problem, lines: &[RulingLine]) -> Vec<[f64; 2]> {
    let (a, b) = problem.counts();
    let [first, second] = problem.outlines().each_ref().map(shares_of);
    let share = |shares: &[f64], lifted: i64| {
        let n = shares.len() as i64;
        shares[lifted.rem_euclid(n) as usize] + lifted.div_euclid(n) as f64
    };
    let mut places = Vec::with_capacity(a + b);
    let mut lines = lines.to_vec();
    if let Some(tied) = problem.tied() {
        // Ends that do not see each other are joined all the same, and found out.
        let line = |(from, to): (usize, usize)| RulingLine { from, to, lifted: to as i64, value: 0.0 };
        if lines.first().is_none_or(|first| first.from > 0) {
            lines.insert(0, line(tied[0]));
        }
        if lines.last().is_none_or(|last| last.from + 1 < a) {
            lines.push(line(tied[1]));
        }
    }
    for (k, line) in lines.iter().enumerate() {
        let lap = i64::from(k + 1 == lines.len());
        if lap == 1 && problem.ends().is_some() {
            places.push([share(&first, line.from as i64), share(&second, line.lifted)]);
            break;
        }
        let next = &lines[(k + 1) % lines.len()];
        let ends = (line.from as i64 + 1, next.from as i64 + lap * a as i64);
        let lifted = (line.lifted + 1, next.lifted + lap * b as i64);
        let (x, y) = (share(&first, ends.0 - 1), share(&second, lifted.0 - 1));
        let (width, height) = (share(&first, ends.1) - x, share(&second, lifted.1) - y);
        let on_first = (ends.0..ends.1).map(|i| (share(&first, i) - x) / width);
        let on_second = (lifted.0..lifted.1).map(|j| (share(&second, j) - y) / height);
        let mut between: Vec<f64> = on_first.collect();
        for t in on_second {
            let at = between.partition_point(|other| *other < t);
            let beside = [at.checked_sub(1), Some(at)].into_iter().flatten().filter_map(|k| between.get(k));
            if beside.into_iter().all(|other| (t - other).abs() >= SAME_PROPORTION) {
                between.insert(at, t);
            }
        }
        places.push([x, y]);
        places.extend(between.iter().map(|t| [x + t * width, y + t * height]));
    }
    places
}

/// Proportions closer than this are one line.
const SAME_PROPORTION: f64 = 1e-9;

#[cfg(test)]
mod tests {
    use super::super::rounds::best_by_brute_force;
    use super::super::test_shapes::{Numbers, random_problem};
    use super::super::{Bound, blocking_edge, measure};
    use super::*;
    use crate::geom::segments_meet;

    /// The heaviest set of visible lines without a common end or a crossing, by search; it knows no lattice.
    fn by_conflicts(problem: &Problem) -> f64 {
        let (a, b) = problem.counts();
        let [first, second] = problem.outlines();
        let conflict = |(i, j): (usize, usize), (k, l): (usize, usize)| {
            let ends = |i: usize, j: usize| (first.points[i], second.points[j]);
            let ((p, q), (r, s)) = (ends(i, j), ends(k, l));
            i == k || j == l || segments_meet(p, q, r, s)
        };
        let mut best = 0.0_f64;
        let mut stack = vec![(0, Vec::new(), 0.0)];
        while let Some((i, chosen, sum)) = stack.pop() {
            if i == a {
                best = best.max(sum);
                continue;
            }
            for j in (0..b).filter(|&j| blocking_edge(problem.outlines(), i, j).is_none()) {
                if chosen.iter().all(|&other| !conflict((i, j), other)) {
                    let with = chosen.iter().copied().chain([(i, j)]).collect();
                    stack.push((i + 1, with, sum + problem.value(i, j)));
                }
            }
            stack.push((i + 1, chosen, sum));
        }
        best
    }

    fn sum(lines: &[RulingLine]) -> f64 {
        lines.iter().map(|line| line.value).sum()
    }

    #[test]
    fn small_instances_equal_a_search_without_a_lattice() {
        let mut numbers = Numbers(61);
        for case in 0..150 {
            let problem = random_problem(&mut numbers, 3, 7);
            let (found, expected) = (sum(&one_per_vertex(&problem).lines), by_conflicts(&problem));
            assert!((found - expected).abs() <= 1e-9 * expected.max(1.0), "case {case}: {found}, {expected}");
        }
    }

    #[test]
    fn divide_and_conquer_equals_brute_force_and_no_vertex_has_two_lines() {
        let mut numbers = Numbers(19);
        for case in 0..600 {
            let problem = random_problem(&mut numbers, 3, 24);
            let SingleLines { lines, best } = one_per_vertex(&problem);
            let mut survey = Survey::new(&problem);
            while survey.advance(&problem) {}
            let brute =
                best_by_brute_force(survey.lattice(), Rule::Single).expect("corners are never blocked");
            assert!((sum(&lines) - brute.value).abs() <= 1e-9 * brute.value.max(1.0), "case {case}");
            let next = lines.iter().skip(1);
            assert!(
                lines.iter().zip(next).all(|(l, n)| l.from < n.from && l.lifted < n.lifted),
                "case {case}"
            );
            if let (Some(first), Some(last)) = (lines.first(), lines.last()) {
                assert!(last.lifted < first.lifted + problem.counts().1 as i64, "case {case}");
            }
            let totals = measure(&problem, &lines, Bound::new(&problem, &best));
            assert_eq!((totals.crossings, totals.blocked), (0, 0), "case {case}");
        }
    }

    #[test]
    fn every_vertex_is_filled_in_and_places_ascend() {
        let mut numbers = Numbers(29);
        for case in 0..200 {
            let problem = random_problem(&mut numbers, 3, 20);
            let lines = one_per_vertex(&problem).lines;
            let places = fill_in(&problem, &lines);
            let (a, b) = problem.counts();
            if lines.is_empty() {
                assert!(places.is_empty());
                continue;
            }
            assert!(places.len() <= a + b - lines.len(), "case {case}");
            let lap = places[0].map(|share| share + 1.0);
            let next = places.iter().skip(1).chain([&lap]);
            assert!(places.iter().zip(next).all(|(p, q)| p[0] < q[0] && p[1] < q[1]), "case {case}");
            for (axis, outline) in problem.outlines().iter().enumerate() {
                for share in shares_of(outline) {
                    let distance = |place: &[f64; 2]| {
                        let gap = (place[axis] - share).rem_euclid(1.0);
                        gap.min(1.0 - gap)
                    };
                    assert!(places.iter().any(|place| distance(place) < 1e-8), "case {case}: {share}");
                }
            }
        }
    }
}
