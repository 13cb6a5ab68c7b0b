//! Points that are one within a tolerance.

use glam::DVec3;
use std::collections::HashMap;

/// Numbers points so that those within the tolerance of an earlier one get its number.
#[derive(Debug, Clone)]
pub(in crate::hyperpatch) struct Weld {
    tolerance: f64,
    /// A point nearby, from which cubes are counted.
    origin: DVec3,
    /// Numbered points by the cube that they lie in; cubes are eight tolerances wide, so a point is rarely near a
    /// side of one.
    cubes: HashMap<[i64; 3], Vec<u32>>,
    points: Vec<DVec3>,
}

impl Weld {
    pub(in crate::hyperpatch) fn new(tolerance: f64, origin: DVec3) -> Self {
        Self { tolerance, origin, cubes: HashMap::new(), points: Vec::new() }
    }

    /// The number of a point, which is the next one for a new point.
    pub(in crate::hyperpatch) fn number(&mut self, point: DVec3) -> u32 {
        let width = self.tolerance * 8.0;
        let cube = |p: DVec3| ((p - self.origin) / width).floor().to_array().map(|x| x as i64);
        let (lo, hi) = (cube(point - self.tolerance), cube(point + self.tolerance));
        for x in lo[0]..=hi[0] {
            for y in lo[1]..=hi[1] {
                for z in lo[2]..=hi[2] {
                    let near = self.cubes.get(&[x, y, z]).into_iter().flatten();
                    let is_near = |n: &&u32| self.points[**n as usize].distance(point) <= self.tolerance;
                    if let Some(number) = near.copied().find(|n| is_near(&n)) {
                        return number;
                    }
                }
            }
        }
        let number = self.points.len() as u32;
        self.points.push(point);
        self.cubes.entry(cube(point)).or_default().push(number);
        number
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::test_cells::random_place;

    #[test]
    fn near_points_are_one_wherever_the_cubes_lie() {
        let mut weld = Weld::new(1e-9, DVec3::splat(7.0));
        for seed in 0..2000 {
            let point = (random_place(seed) - 0.5) * 1e-3 + DVec3::splat(seed as f64);
            let number = weld.number(point);
            let near = point + (random_place(seed + 5000) - 0.5) * 1e-9;
            assert_eq!(weld.number(near), number);
            assert_ne!(weld.number(point + DVec3::X * 2e-9), number);
        }
        assert_eq!(weld.points.len(), 4000);
    }
}
