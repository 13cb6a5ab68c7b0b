//! One quantity at a point, where the others are not asked for.

use super::cloud::{Values, sum_of};
use super::solution::{INSIDE, Solution};
use glam::DVec3;

impl Solution {
    /// The value of one quantity solved for at a point inside or on the boundary, as [`at`](Self::at) has it; `None` outside, and where there is no such
    /// quantity.
    #[must_use]
    pub fn quantity_at(&self, quantity: usize, point: DVec3) -> Option<f64> {
        let field = self.fields.get(quantity)?;
        let x = self.problem.scaling.inwards(point);
        let (mut sum, mut winding, mut values) = (0.0, 0.0, Values::default());
        for cluster in &self.panels.clusters {
            self.panels.layers(cluster, x, &mut values);
            let slots = cluster.slots.start..cluster.slots.start + values.single.len();
            sum += sum_of(&values, &field.flux_slots[slots.clone()], Some(&field.value_slots[slots]));
            winding += values.double_sum();
        }
        let value = field.outwards(sum / winding);
        (winding > INSIDE).then(|| field.range.map_or(value, |[low, high]| value.clamp(low, high)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laplace::{Conditions, LaplaceOptions, Problem, samples, solve};

    #[test]
    fn one_quantity_is_that_of_all() {
        let mesh = samples::annulus(0.4, 1.0, 80);
        let centres = || mesh.panels().into_iter().map(|panel| panel.centre);
        let data = vec![centres().map(|c| c.x).collect(), centres().map(|c| c.x * c.y).collect()];
        let conditions = Conditions { is_value: vec![true; mesh.panels().len()], data, are_fractions: false };
        let problem = Problem::new(mesh.clone(), conditions).unwrap();
        let solution = solve(problem, LaplaceOptions::default()).unwrap();
        for point in [DVec3::new(0.5, 0.1, 0.0), DVec3::new(-0.3, 0.8, 0.0), DVec3::new(0.41, 0.0, 0.0)] {
            let all = solution.at(point).unwrap().values;
            for (quantity, value) in all.iter().enumerate() {
                assert!((solution.quantity_at(quantity, point).unwrap() - value).abs() < 1e-12);
            }
        }
        assert_eq!(solution.quantity_at(0, DVec3::ZERO), None);
        assert_eq!(solution.quantity_at(2, DVec3::new(0.5, 0.1, 0.0)), None);
    }
}
