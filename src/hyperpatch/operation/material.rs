//! Compositions that run on and stay in the simplex (section 6 of the notes on the paper's section 3.5).

use super::OperationError;
use super::draft::Draft;
use super::nearest::{Conditions, nearest};
use super::star::{Star, Weave};
use crate::hyperpatch::composite::Body;

/// The step t nearest to a given one for which both a - t and a + t are compositions when a is: its parts sum to zero,
/// and none is larger than the fraction of a.
///
/// Eq. 8 of the paper, applied to compositions, leaves the simplex: from (0.5, 0.5) over (0.2, 0.8) to (-0.1, 1.1).
/// With the nearest step, `t_i = clamp(t0_i - lambda, -a_i, a_i)` with the lambda for which they sum to zero, it does
/// not. A pure composition has the step zero alone, which is the paper's own rule.
#[must_use]
pub fn pair(a: &[f64], step: &[f64]) -> Vec<f64> {
    let at = |lambda: f64| step.iter().zip(a).map(move |(t, a)| (t - lambda).clamp(-a.abs(), a.abs()));
    // The sum falls from above zero to below it between the outermost breakpoints.
    let mut breaks: Vec<f64> = step.iter().zip(a).flat_map(|(t, a)| [t - a.abs(), t + a.abs()]).collect();
    breaks.sort_unstable_by(f64::total_cmp);
    let (Some(&first), Some(&last)) = (breaks.first(), breaks.last()) else { return Vec::new() };
    let (mut lo, mut hi) = (first, last);
    for &lambda in &breaks {
        if at(lambda).sum::<f64>() >= 0.0 {
            lo = lo.max(lambda);
        } else {
            hi = hi.min(lambda);
        }
    }
    let (above, below) = (at(lo).sum::<f64>(), at(hi).sum::<f64>());
    let lambda = if above > below { lo + (hi - lo) * (above / (above - below)) } else { lo };
    at(lambda).collect()
}

/// Fractions of each material in each class of a star.
pub(super) struct Fractions {
    lists: Vec<Vec<f64>>,
}

impl Fractions {
    /// What they are.
    pub(super) fn new(star: &Star<'_>, weave: &Weave) -> Self {
        let materials = star.cells.first().map_or(0, |(_, _, cell)| cell.materials());
        let list = |material| weave.members.iter().map(|list| star.fraction(list[0], material)).collect();
        Self { lists: (0..materials).map(list).collect() }
    }

    /// The composition of a class.
    pub(super) fn get(&self, class: usize) -> Vec<f64> {
        self.lists.iter().map(|list| list[class]).collect()
    }

    pub(super) fn set(&mut self, class: usize, mix: Vec<f64>) {
        self.lists.iter_mut().zip(mix).for_each(|(list, fraction)| list[class] = fraction);
    }

    /// Half of what a class has more than another one.
    pub(super) fn half_difference(&self, from: usize, to: usize) -> Vec<f64> {
        self.lists.iter().map(|list| (list[to] - list[from]) / 2.0).collect()
    }

    /// Gives a class the mean of two coefficients.
    pub(super) fn set_mean(&mut self, star: &Star<'_>, class: usize, [a, b]: [usize; 2]) {
        for (material, list) in self.lists.iter_mut().enumerate() {
            list[class] = (star.fraction(a, material) + star.fraction(b, material)) / 2.0;
        }
    }

    /// Changes what is not fixed as little as possible to fulfil conditions; fractions may leave the simplex.
    pub(super) fn fit(&mut self, conditions: &Conditions, is_fixed: &[bool]) {
        self.lists.iter_mut().for_each(|list| nearest(list, conditions, is_fixed));
    }

    /// Draws classes towards the composition of one, all by the same factor and as little as needed for them to be in
    /// the simplex. What runs on goes on doing so.
    pub(super) fn draw_in(&mut self, middle: usize, is_drawn: &[bool]) {
        let mut scale = 1.0_f64;
        for list in &self.lists {
            for (value, _) in list.iter().zip(is_drawn).filter(|(_, is_drawn)| **is_drawn) {
                if *value < 0.0 {
                    scale = scale.min(list[middle] / (list[middle] - value));
                }
            }
        }
        if scale < 1.0 {
            for list in &mut self.lists {
                let centre = list[middle];
                for (value, _) in list.iter_mut().zip(is_drawn).filter(|(_, is_drawn)| **is_drawn) {
                    *value = centre + (*value - centre) * scale;
                }
            }
        }
    }

    /// Writes the compositions that have changed; what rounding has brought below 0 is 0.
    pub(super) fn write(
        &self,
        body: &Body,
        star: &Star<'_>,
        weave: &Weave,
        draft: &mut Draft,
    ) -> Result<(), OperationError> {
        for (class, members) in weave.members.iter().enumerate() {
            let mix: Vec<f64> = self.lists.iter().map(|list| list[class].max(0.0)).collect();
            for &member in members {
                if mix.iter().enumerate().any(|(material, f)| star.fraction(member, material) != *f) {
                    let (id, at) = star.coefficient(member);
                    draft.fill(body, id, at, &mix)?;
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::test_bodies::{random_mix, random_vector};
    use super::*;
    use crate::material::Composition;

    /// No other feasible step is nearer; both sides are compositions.
    #[test]
    fn the_nearest_pair_is_nearest_and_in_the_simplex() {
        for seed in 0..200 {
            let a = match seed % 4 {
                0 => Composition::pure(1, 3),
                1 => Composition::new(vec![0.0, 0.3, 0.7]).unwrap(),
                _ => random_mix(seed),
            };
            let a = a.fractions();
            let wanted = (random_vector(seed) * 0.8).to_array();
            let step = pair(a, &wanted);
            assert!(step.iter().sum::<f64>().abs() < 1e-15);
            assert!(step.iter().zip(a).all(|(t, a)| t.abs() <= *a));
            let distance = |t: &[f64]| t.iter().zip(&wanted).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
            for n in 0..200 {
                let v = random_vector(1000 + n);
                let other = [v.x * a[0], v.y * a[1], -(v.x * a[0] + v.y * a[1])];
                if other[2].abs() <= a[2] {
                    assert!(
                        distance(&step) <= distance(&other) + 1e-12,
                        "{a:?} {wanted:?} {step:?} {other:?}"
                    );
                }
            }
        }
    }

    /// The paper's counter-example: half and half beside one to four.
    #[test]
    fn what_eq_8_takes_out_of_the_simplex_stays_in_it() {
        let step = pair(&[0.2, 0.8], &[-0.3, 0.3]);
        assert!((step[0] + 0.2).abs() < 1e-15 && (step[1] - 0.2).abs() < 1e-15, "{step:?}");
        assert!(pair(&[1.0, 0.0], &[-0.3, 0.3]).iter().all(|t| t.abs() < 1e-15), "a pure one has no step");
        let free = pair(&[0.5, 0.5], &[-0.3, 0.3]);
        assert!((free[0] + 0.3).abs() < 1e-15, "{free:?}");
    }
}
