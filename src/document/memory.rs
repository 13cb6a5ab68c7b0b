//! Solutions that are remembered by the text of their documents.

use super::Solution;
use std::collections::VecDeque;
use std::rc::Rc;

/// Solutions that are kept, whatever their size.
const KEPT: usize = 4;
/// Solutions that are kept while they are small: many figures of a page take turns.
const KEPT_SMALL: usize = 32;
/// What small ones may weigh together, in pairs of samples: as much as ten of 200 to 200 samples.
const SMALL: usize = 400_000;
/// What a solution weighs at least: the curves and the lines of a small one count as well.
const LEAST: usize = 1000;

/// The solutions that were used last. Those used longest ago are forgotten: all but 4, and of small ones all but 32.
#[derive(Debug, Default)]
pub struct Memory {
    /// The one used last comes first.
    solved: VecDeque<(String, Rc<Solution>)>,
}

impl Memory {
    /// The solution of a document if there is one; unless `coarse`, one whose refinement was not left out.
    #[must_use]
    pub fn find(&mut self, text: &str, coarse: bool) -> Option<Rc<Solution>> {
        let is_it =
            |(known, solution): &(String, Rc<Solution>)| known == text && (coarse || !solution.is_coarse);
        let found = self.solved.iter().position(is_it)?;
        let entry = self.solved.remove(found)?;
        let solution = Rc::clone(&entry.1);
        self.solved.push_front(entry);
        Some(solution)
    }

    /// Remembers a solution, in place of another of the same document.
    pub fn keep(&mut self, text: &str, solution: Solution) {
        self.solved.retain(|(known, _)| known != text);
        self.solved.push_front((text.to_owned(), Rc::new(solution)));
        self.solved.truncate(kept(self.solved.iter().map(|(_, solution)| weight(solution))));
    }
}

/// What a solution takes: the number of pairs of samples, of all spans.
fn weight(solution: &Solution) -> usize {
    let pairs = solution.model.samples().windows(2);
    pairs.map(|pair| pair[0].points.len() * pair[1].points.len()).sum::<usize>().max(LEAST)
}

/// How many solutions of some weights are kept, the one used last first.
fn kept(weights: impl Iterator<Item = usize>) -> usize {
    let mut sum = 0;
    let is_kept = |&(index, weight): &(usize, usize)| {
        sum += weight;
        index < KEPT || (index < KEPT_SMALL && sum <= SMALL)
    };
    weights.enumerate().take_while(is_kept).count()
}

#[cfg(test)]
mod tests {
    use super::super::{Solve, read_text};
    use super::*;
    use serde_json::json;
    use std::iter::repeat_n;

    #[test]
    fn many_small_solutions_are_kept_and_few_large_ones() {
        assert_eq!(kept(repeat_n(44 * 44, 100)), KEPT_SMALL);
        assert_eq!(kept(repeat_n(200 * 200, 100)), 10);
        assert_eq!(kept(repeat_n(1000 * 1000, 100)), KEPT);
        assert_eq!(kept(repeat_n(44 * 44, 20)), 20);
    }

    #[test]
    fn what_was_used_longest_ago_is_forgotten() {
        let solution = || {
            let ring = |r: f64| json!({"degree": 2, "form": "periodic", "points": [[r, 0], [0, r], [-r, 0], [0, -r]]});
            let document = json!({
                "directrix": 1, "kind": "curves", "curves": [ring(1.0), ring(3.0)],
                "sampling": {"counts": [12, 12]}, "matching": {"method": "greedy"},
            });
            let mut job = Solve::new(read_text(&document.to_string()).unwrap()).unwrap();
            job.step(&mut || true).unwrap()
        };
        let mut memory = Memory::default();
        for k in 0..KEPT_SMALL {
            memory.keep(&k.to_string(), solution());
        }
        assert!(memory.find("0", false).is_some());
        memory.keep("new", solution());
        assert!(memory.find("0", false).is_some() && memory.find("new", true).is_some());
        assert!(memory.find("1", false).is_none());
        memory.keep("new", solution());
        assert!(memory.find("2", false).is_some());
    }
}
