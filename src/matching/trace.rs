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

/// The sets of Eqs. 11 and 12 for one vertex of the first outline at one step.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct VertexSets {
    /// V_i: vertices of the second outline that it sees.
    pub visible: Vec<usize>,
    /// R_i: vertices of the second outline that its lines may end in without crossing the lines there are, ascending round the band; all of
    /// them as long as there are no lines.
    pub valid: Vec<usize>,
    /// The vertex of the second outline at the end of its best candidate, a visible and valid one without a line to it.
    pub best: Option<usize>,
}

/// Traces the greedy construction by the repaired rules; `growth` is its outcome, see [`Matching::growth`](super::Matching).
///
/// Time: of the order of the visible lines times the accepted ones, some tens of milliseconds for 200 by 200 vertices.
#[must_use]
pub fn trace(problem: &Problem, growth: &[RulingLine]) -> Trace {
    let (a, b) = problem.counts();
    let (wedges, mut sight) = (Wedges::new(problem), Sight::new(problem.outlines()));
    let mut candidates: Vec<Candidate> =
        (0..a).flat_map(|from| ranked_lines(problem, &wedges, &mut sight, from)).collect();
    candidates.sort_unstable_by(|p, q| q.compare(p));
    let (mut rejected, mut step) = (Vec::new(), 0);
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

/// Finds what a vertex of the first outline sees and may have when the lines of `growth` are there.
#[must_use]
pub fn vertex_sets(problem: &Problem, growth: &[RulingLine], vertex: usize) -> VertexSets {
    let (a, b) = problem.counts();
    let mut chain = Chain::new(a, b);
    growth.iter().for_each(|line| chain.insert(line.from, line.lifted));
    let (wedges, mut sight) = (Wedges::new(problem), Sight::new(problem.outlines()));
    let ranked = ranked_lines(problem, &wedges, &mut sight, vertex);
    let is_new =
        |line: &RulingLine| growth.iter().all(|other| (other.from, other.to) != (line.from, line.to));
    let best = ranked.iter().rev().map(|candidate| candidate.line);
    let best =
        best.filter(|line| is_new(line) && chain.admits(line.from, line.lifted)).map(|line| line.to).next();
    let mut visible: Vec<usize> = ranked.iter().map(|candidate| candidate.line.to).collect();
    visible.sort_unstable();
    let valid = match chain.range(vertex) {
        Some((first, last)) => {
            (first..=last).take(b).map(|column| column.rem_euclid(b as i64) as usize).collect()
        }
        None => (0..b).collect(),
    };
    VertexSets { visible, valid, best }
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
    fn every_accepted_line_was_the_best_candidate_of_its_vertex() {
        let mut numbers = Numbers(15);
        for case in 0..40 {
            let problem = random_problem(&mut numbers, 3, 16);
            let growth = greedy(&problem).growth;
            for step in 0..growth.len() {
                let sets = vertex_sets(&problem, &growth[..step], growth[step].from);
                assert_eq!(sets.best, Some(growth[step].to), "case {case}, step {step}");
                assert!(sets.visible.contains(&growth[step].to) && sets.valid.contains(&growth[step].to));
            }
        }
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
