//! Design rules.

use super::Grid;

/// An inequality on the fraction of a material, or on how fast it changes from place to place (Liu and others 2003, 3.1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DesignRule {
    /// Index of the material.
    pub material: usize,
    /// What is limited.
    pub of: Quantity,
    /// Least value that is allowed.
    pub least: f64,
    /// Greatest value that is allowed.
    pub most: f64,
}

/// What a rule limits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// The volume fraction.
    Fraction,
    /// The length of its gradient, per unit of length.
    Gradient,
}

/// Rounding that no rule minds.
const SLACK: f64 = 1e-6;

impl DesignRule {
    /// The voxels of the body that break the rule, of fractions on a grid, in ascending order. Gradients are by central differences between voxels of the body, one-sided at
    /// its surface: what happens within a voxel is not seen.
    #[must_use]
    pub fn violations(&self, grid: &Grid, is_inside: &[bool], fractions: &[f32]) -> Vec<u32> {
        let is_broken = |value: f64| value < self.least - SLACK || value > self.most + SLACK;
        let value = |index: usize| match self.of {
            Quantity::Fraction => f64::from(fractions[index]),
            Quantity::Gradient => gradient(grid, is_inside, fractions, index),
        };
        let count = grid.count().min(is_inside.len()).min(fractions.len());
        (0..count)
            .filter(|index| is_inside[*index] && is_broken(value(*index)))
            .map(|index| index as u32)
            .collect()
    }
}

/// The length of the gradient at a voxel of the body.
fn gradient(grid: &Grid, is_inside: &[bool], fractions: &[f32], index: usize) -> f64 {
    let [nx, ny, nz] = grid.size();
    let along = [(index % nx, nx, 1), (index / nx % ny, ny, nx), (index / (nx * ny), nz, nx * ny)];
    let slope = |((at, count, stride), step): ((usize, usize, usize), f64)| {
        let before = (at > 0).then(|| index - stride).filter(|other| is_inside[*other]);
        let after = (at + 1 < count).then(|| index + stride).filter(|other| is_inside[*other]);
        let steps = usize::from(before.is_some()) + usize::from(after.is_some());
        if steps == 0 {
            return 0.0;
        }
        let value = |other: Option<usize>| f64::from(fractions[other.unwrap_or(index)]);
        (value(after) - value(before)) / (steps as f64 * step)
    };
    along.into_iter().zip(grid.spacing()).map(slope).map(|slope| slope * slope).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_outside_their_limits_are_found_where_the_body_is() {
        let grid = Grid::new([5, 1, 1], [1.0; 3]).unwrap();
        let rule = DesignRule { material: 0, of: Quantity::Fraction, least: 0.2, most: 0.8 };
        let is_inside = [true, true, true, true, false];
        assert_eq!(rule.violations(&grid, &is_inside, &[0.1, 0.2, 0.8, 0.9, 1.0]), [0, 3]);
    }

    /// A linear field has the same gradient everywhere, up to the surface and whatever the spacing.
    #[test]
    fn the_gradient_of_a_linear_field_is_exact() {
        let (size, spacing) = ([6, 5, 4], [0.5, 0.25, 2.0]);
        let grid = Grid::new(size, spacing).unwrap();
        let slope = [0.3, -0.4, 0.05];
        let at = |index: usize| [index % 6, index / 6 % 5, index / 30];
        let value = |index: usize| -> f64 {
            (0..3).map(|axis| slope[axis] * spacing[axis] * at(index)[axis] as f64).sum()
        };
        let fractions: Vec<f32> = (0..grid.count()).map(|index| value(index) as f32).collect();
        let length = slope.iter().map(|x| x * x).sum::<f64>().sqrt();
        let rule = |most: f64| DesignRule { material: 0, of: Quantity::Gradient, least: 0.0, most };
        let is_inside = vec![true; grid.count()];
        assert!(rule(length + 1e-5).violations(&grid, &is_inside, &fractions).is_empty());
        assert_eq!(rule(length - 1e-5).violations(&grid, &is_inside, &fractions).len(), grid.count());
        let mut hollow = is_inside;
        hollow[31] = false;
        assert!(rule(length + 1e-5).violations(&grid, &hollow, &fractions).is_empty());
    }

    #[test]
    fn a_voxel_alone_has_no_gradient() {
        let grid = Grid::new([1, 1, 1], [1.0; 3]).unwrap();
        let rule = DesignRule { material: 0, of: Quantity::Gradient, least: 0.1, most: 1.0 };
        assert_eq!(rule.violations(&grid, &[true], &[0.5]), [0]);
    }
}
