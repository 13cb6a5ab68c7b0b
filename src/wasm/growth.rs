//! The growth of a greedy matching, step by step, as it goes out.

use crate::document::{Code, DocumentError, Outcome, Solution};
use crate::matching::{Insertion, Outline, Seen, Trace, VertexSets, trace, vertex_sets};

/// The steps of a greedy matching: a list each for the lines accepted (from, to, value), those passed over (from, to, step, blocking line),
/// those removed (index among the accepted), and what the passes of insertion move (curve, vertex, x, y, value).
pub(super) fn steps(solution: &Solution) -> [Vec<Vec<f64>>; 4] {
    let Outcome::Matched { problem, matching, pairs, .. } = &solution.outcome else {
        return Default::default();
    };
    let Trace { growth, rejected, removed } = trace(problem, &matching.growth);
    let model = &solution.model;
    let inserted = match (model.pair(), pairs) {
        (Some((curves, samples)), Some(_)) => Insertion::new(curves, samples, problem, matching).inserted(),
        _ => Vec::new(),
    };
    let number = |k: usize| k as f64;
    [
        growth.iter().map(|line| vec![number(line.from), number(line.to), line.value]).collect(),
        rejected.iter().map(|no| [no.from, no.to, no.step, no.by].map(number).to_vec()).collect(),
        removed.iter().map(|&k| vec![number(k)]).collect(),
        inserted
            .iter()
            .map(|new| vec![number(new.curve), number(new.vertex), new.at.x, new.at.y, new.value])
            .collect(),
    ]
}

/// The sets of a vertex: first R as a list, then of each vertex that it sees the number, the value of the line, and 1 for a candidate.
///
/// # Errors
/// When there is no such step or vertex.
pub(super) fn sets(
    solution: &Solution,
    step: usize,
    curve: usize,
    vertex: usize,
) -> Result<Vec<Vec<f64>>, DocumentError> {
    let refused = |path: &str, found: usize, count: usize| {
        let message = format!("{found} was found; expected a whole number below {count}");
        Err(DocumentError::new(Code::Range, path, message))
    };
    let (steps, count) = match &solution.outcome {
        Outcome::Matched { problem, matching, .. } => {
            (matching.growth.len() + 1, problem.outlines().get(curve).map_or(0, Outline::len))
        }
        _ => (0, 0),
    };
    if step >= steps {
        return refused("options.step", step, steps);
    }
    if curve > 1 {
        return refused("options.curve", curve, 2);
    }
    if vertex >= count {
        return refused("options.vertex", vertex, count);
    }
    let Outcome::Matched { problem, matching, .. } = &solution.outcome else { return Ok(Vec::new()) };
    let VertexSets { visible, valid } = vertex_sets(problem, &matching.growth[..step], curve, vertex);
    let seen = |seen: &Seen| vec![seen.vertex as f64, seen.value, f64::from(u8::from(seen.is_candidate))];
    let valid = valid.iter().map(|&vertex| vertex as f64).collect();
    Ok(std::iter::once(valid).chain(visible.iter().map(seen)).collect())
}
