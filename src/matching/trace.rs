//! The greedy construction, step by step.

use super::chain::Chain;
use super::row::{Candidate, Wedges, ranked_lines};
use super::visibility::Sight;
use super::{Problem, RulingLine, prune};

/// How a greedy matching came about, in compact form.
///
/// What each vertex saw and could still have is not kept; [`vertex_sets`] finds it again for one vertex and one step.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    /// Lines in the order in which they were accepted.
    pub growth: Vec<RulingLine>,
    /// Visible lines that were passed over, in the order in which they came up.
    pub rejected: Vec<Rejection>,
    /// Indices into `growth` of the redundant lines, in the order in which they were removed.
    pub removed: Vec<usize>,
}

/// A visible line that crosses one accepted before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rejection {
    /// Vertex of the first outline.
    pub from: usize,
    /// Vertex of the second outline.
    pub to: usize,
    /// Number of lines accepted before it came up.
    pub step: usize,
    /// Index into the growth of the first accepted line that it crosses.
    pub by: usize,
}

/// The sets of Eqs. 11 and 12 for one vertex at one step.
#[derive(Debug, Clone, PartialEq)]
pub struct VertexSets {
    /// V: what it sees of the other outline, the best line first.
    pub visible: Vec<Seen>,
    /// R: vertices of the other outline that its lines may end in without crossing the lines there are, ascending round the band; all of
    /// them as long as there are no lines.
    pub valid: Vec<usize>,
}

/// A vertex of the other outline that one vertex sees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seen {
    /// The vertex of the other outline.
    pub vertex: usize,
    /// Value f of the line to it.
    pub value: f64,
    /// Whether the line crosses none of the lines there are and is none of them.
    pub is_candidate: bool,
}

/// Traces the greedy construction by the repaired rules; `growth` is its outcome, see [`Matching::growth`](super::Matching).
///
/// Time: of the order of the visible lines times the accepted ones, some tens of milliseconds for 200 by 200 vertices.
#[must_use]
pub fn trace(problem: &Problem, growth: &[RulingLine]) -> Trace {
    let (a, b) = problem.counts();
    let (wedges, mut sight) = (Wedges::new(problem), Sight::new(problem.outlines()));
    let mut candidates: Vec<Candidate> =
        (0..a).flat_map(|from| ranked_lines(problem, &wedges, &mut sight, from, 0..b)).collect();
    candidates.sort_unstable_by(Candidate::compare);
    candidates.reverse();
    // The lines between tied ends were not chosen.
    let tied = problem.tied().unwrap_or([(usize::MAX, usize::MAX); 2]);
    let is_tied = |line: &RulingLine| tied.contains(&(line.from, line.to));
    candidates.retain(|candidate| !is_tied(&candidate.line));
    let (mut rejected, mut step) = (Vec::new(), growth.iter().take_while(|line| is_tied(line)).count());
    for Candidate { line, .. } in &candidates {
        if step == growth.len() {
            break;
        }
        if (line.from, line.to) == (growth[step].from, growth[step].to) {
            step += 1;
        } else if let Some(by) = growth[..step].iter().position(|other| lifts_cross(line, other, (a, b))) {
            rejected.push(Rejection { from: line.from, to: line.to, step, by });
        }
    }
    let kept = prune(growth, a, b);
    let is_kept = |line: &RulingLine| kept.iter().any(|other| (other.from, other.to) == (line.from, line.to));
    let removed = (0..growth.len()).rev().filter(|&k| !is_kept(&growth[k])).collect();
    Trace { growth: growth.to_vec(), rejected, removed }
}

/// Finds what a vertex of an outline, 0 or 1, sees and may have when the lines of `growth` are there.
///
/// For the second outline the sets are those of the first with the outlines exchanged: the papers look from the first alone.
#[must_use]
pub fn vertex_sets(problem: &Problem, growth: &[RulingLine], outline: usize, vertex: usize) -> VertexSets {
    let (a, b) = problem.counts();
    // A line as the chain of this outline counts it: its end there, and that on the other one with the laps between them.
    let lifted = |line: &RulingLine| match outline {
        0 => (line.from, line.lifted),
        _ => (line.to, line.from as i64 - line.lifted.div_euclid(b as i64) * a as i64),
    };
    let [own, other] = if outline == 0 { [a, b] } else { [b, a] };
    let mut chain = if problem.ends().is_some() { Chain::open(own, other) } else { Chain::new(own, other) };
    for line in growth {
        let (at, lifted) = lifted(line);
        chain.insert(at, lifted);
    }
    let (wedges, mut sight) = (Wedges::new(problem), Sight::new(problem.outlines()));
    let mut ranked = match outline {
        0 => ranked_lines(problem, &wedges, &mut sight, vertex, 0..b),
        _ => (0..a)
            .flat_map(|from| ranked_lines(problem, &wedges, &mut sight, from, vertex..vertex + 1))
            .collect(),
    };
    ranked.sort_unstable_by(Candidate::compare);
    ranked.reverse();
    let seen = |Candidate { line, .. }: &Candidate| {
        let (at, lifted) = lifted(line);
        let is_new = growth.iter().all(|old| (old.from, old.to) != (line.from, line.to));
        let vertex = if outline == 0 { line.to } else { line.from };
        Seen { vertex, value: line.value, is_candidate: is_new && chain.admits(at, lifted) }
    };
    let valid = match chain.range(vertex) {
        Some((first, last)) => {
            (first..=last).take(other).map(|end| end.rem_euclid(other as i64) as usize).collect()
        }
        None => (0..other).collect(),
    };
    VertexSets { visible: ranked.iter().map(seen).collect(), valid }
}

/// Whether two lifted lines, or one and a translate of the other, are in opposite orders at their two ends.
fn lifts_cross(line: &RulingLine, other: &RulingLine, (a, b): (usize, usize)) -> bool {
    [-1, 0, 1].into_iter().any(|laps| {
        let across = line.from as i64 - other.from as i64 + laps * a as i64;
        let along = line.lifted - other.lifted + laps * b as i64;
        across.signum() * along.signum() < 0
    })
}

#[cfg(test)]
mod tests {
    use super::super::test_shapes::{Numbers, random_problem};
    use super::super::{Greedy, Printed, greedy};
    use super::*;
    use crate::geom::segments_meet;

    #[test]
    fn the_trace_replays_to_the_same_lines_and_its_blockers_cross() {
        let mut numbers = Numbers(6);
        let mut rejections = 0;
        for case in 0..80 {
            let problem = random_problem(&mut numbers, 3, 30);
            let matching = greedy(&problem);
            let trace = trace(&problem, &matching.growth);
            let [first, second] = problem.outlines();
            let ends = |from: usize, to: usize| (first.points[from], second.points[to]);
            for rejection in &trace.rejected {
                let by = trace.growth[rejection.by];
                assert!(rejection.by < rejection.step, "case {case}");
                let ((p, q), (r, s)) = (ends(rejection.from, rejection.to), ends(by.from, by.to));
                assert!(segments_meet(p, q, r, s), "case {case}: {rejection:?}");
                let value = problem.value(rejection.from, rejection.to);
                assert!(value >= trace.growth[rejection.step].value * (1.0 - 1e-9) - 1e-12, "case {case}");
            }
            rejections += trace.rejected.len();
            let mut replayed: Vec<RulingLine> = trace.growth.clone();
            for &k in &trace.removed {
                replayed.retain(|line| (line.from, line.to) != (trace.growth[k].from, trace.growth[k].to));
            }
            replayed.sort_by_key(|line| (line.from, line.lifted));
            assert_eq!(replayed, matching.lines, "case {case}");
        }
        assert!(rejections > 1000, "{rejections}");
    }

    #[test]
    fn every_accepted_line_was_the_best_candidate_of_both_its_ends() {
        let mut numbers = Numbers(15);
        for case in 0..40 {
            let problem = random_problem(&mut numbers, 3, 16);
            let growth = greedy(&problem).growth;
            for step in 0..growth.len() {
                let RulingLine { from, to, .. } = growth[step];
                for (outline, vertex, end) in [(0, from, to), (1, to, from)] {
                    let sets = vertex_sets(&problem, &growth[..step], outline, vertex);
                    let best = sets.visible.iter().find(|seen| seen.is_candidate).map(|seen| seen.vertex);
                    assert_eq!(best, Some(end), "case {case}, step {step}, outline {outline}");
                    assert!(sets.valid.contains(&end));
                    assert!(
                        sets.visible.windows(2).all(|pair| pair[0].value >= pair[1].value * (1.0 - 1e-9))
                    );
                }
            }
        }
    }

    #[test]
    fn candidates_are_the_visible_lines_that_cross_none() {
        let mut numbers = Numbers(21);
        let (mut candidates, mut others) = (0, 0);
        for case in 0..40 {
            let problem = random_problem(&mut numbers, 3, 14);
            let (a, b) = problem.counts();
            let growth = greedy(&problem).growth;
            let lines = &growth[..growth.len() / 2];
            let [first, second] = problem.outlines();
            let ends = |from: usize, to: usize| (first.points[from], second.points[to]);
            // Lines that share an end do not cross, although they meet.
            let crosses = |from: usize, to: usize| {
                let (p, q) = ends(from, to);
                lines.iter().filter(|line| line.from != from && line.to != to).any(|line| {
                    let (r, s) = ends(line.from, line.to);
                    segments_meet(p, q, r, s)
                })
            };
            for (outline, vertex) in (0..a).map(|i| (0, i)).chain((0..b).map(|j| (1, j))) {
                let sets = vertex_sets(&problem, lines, outline, vertex);
                let line = |other: usize| if outline == 0 { (vertex, other) } else { (other, vertex) };
                let others_seen = (0..if outline == 0 { b } else { a }).filter(|&other| {
                    let (from, to) = line(other);
                    problem.is_visible(from, to)
                });
                let mut seen: Vec<usize> = sets.visible.iter().map(|seen| seen.vertex).collect();
                seen.sort_unstable();
                assert_eq!(seen, others_seen.collect::<Vec<_>>(), "case {case}, {outline}, {vertex}");
                for Seen { vertex: other, is_candidate, .. } in sets.visible {
                    let (from, to) = line(other);
                    let is_there = lines.iter().any(|line| (line.from, line.to) == (from, to));
                    assert_eq!(is_candidate, !is_there && !crosses(from, to), "case {case}: {from}, {to}");
                    assert!(!is_candidate || sets.valid.contains(&other));
                    candidates += usize::from(is_candidate);
                    others += usize::from(!is_candidate);
                }
            }
        }
        assert!(candidates > 300 && others > 300, "{candidates} and {others}");
    }

    #[test]
    fn printed_rules_do_what_the_notes_say() {
        let mut numbers = Numbers(9);
        let (mut crossed, mut stranded) = (0, 0);
        let run = |problem: &Problem, printed: Printed| {
            let mut job = Greedy::as_printed(problem.clone(), printed);
            loop {
                if let Some(matching) = job.step(&mut || true) {
                    break matching;
                }
            }
        };
        for _ in 0..120 {
            let problem = random_problem(&mut numbers, 6, 30);
            let repaired = greedy(&problem);
            let stop = run(&problem, Printed { stop: true, ..Printed::default() });
            assert!(stop.growth[..] == repaired.growth[..1]);
            let order = run(&problem, Printed { order: true, ..Printed::default() });
            crossed += usize::from(order.totals.crossings > 0);
            let removal = run(&problem, Printed { removal: true, ..Printed::default() });
            assert_eq!(removal.growth, repaired.growth);
            let bare = |totals: &super::super::Totals| totals.uncovered.iter().map(Vec::len).sum::<usize>();
            stranded += usize::from(bare(&removal.totals) > bare(&repaired.totals));
        }
        assert!(crossed > 2 && stranded > 50, "{crossed} crossed, {stranded} stranded");
    }
}
