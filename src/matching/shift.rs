//! Matching by index.

use super::{Problem, RulingLine};

/// Joins vertex i of the first outline to vertex i + `shift` of the second, for outlines of equal counts.
///
/// The baseline of the paper (Fig. 8a and b): at 0 it matches by parameter. Visibility and crossings are not looked at; measure the
/// lines to learn of them.
///
/// # Panics
/// When the outlines have different numbers of vertices.
#[must_use]
pub fn shifted(problem: &Problem, shift: usize) -> Vec<RulingLine> {
    let (a, b) = problem.counts();
    assert_eq!(a, b, "a shift needs as many vertices on one outline as on the other");
    let line = |from: usize| {
        let to = (from + shift) % b;
        RulingLine { from, to, lifted: (from + shift % b) as i64, value: problem.value(from, to) }
    };
    (0..a).map(line).collect()
}

/// Returns the shift with the greatest sum of f among all shifts, the smallest of equal ones.
///
/// # Panics
/// When the outlines have different numbers of vertices.
#[must_use]
pub fn best_shift(problem: &Problem) -> usize {
    let sum = |shift: usize| shifted(problem, shift).iter().map(|line| line.value).sum::<f64>();
    let sums = (0..problem.counts().1).map(|shift| (shift, sum(shift)));
    sums.reduce(|best, next| if next.1 > best.1 { next } else { best }).map_or(0, |best| best.0)
}

#[cfg(test)]
mod tests {
    use super::super::Weights;
    use super::super::test_shapes::outline;
    use super::*;
    use glam::DVec2;
    use std::f64::consts::TAU;

    #[test]
    fn the_best_shift_undoes_a_turn_of_the_seam() {
        let ring = |radius: f64, turn: usize| {
            outline((0..24).map(|k| radius * DVec2::from_angle(TAU * (k + turn) as f64 / 24.0)).collect())
        };
        for turn in [0, 1, 5, 23] {
            let rings = [ring(1.0, turn), ring(3.0, 0)];
            let problem = Problem::new(rings, Weights::default(), 0.0).expect("one inside the other");
            assert_eq!(best_shift(&problem), turn);
            let lines = shifted(&problem, turn);
            let sum: f64 = lines.iter().map(|line| line.value).sum();
            assert!((sum - 24.0 / 4.0).abs() < 1e-12, "every line has the value 1 / 2^2: {sum}");
            assert!(lines.windows(2).all(|w| w[0].lifted < w[1].lifted));
        }
    }
}
