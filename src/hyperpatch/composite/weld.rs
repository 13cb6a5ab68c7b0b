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
    /// How often each number was given and not given back.
    users: Vec<u32>,
    /// Numbers that were given back.
    free: Vec<u32>,
}

impl Weld {
    pub(in crate::hyperpatch) fn new(tolerance: f64, origin: DVec3) -> Self {
        let (points, users, free) = (Vec::new(), Vec::new(), Vec::new());
        Self { tolerance, origin, cubes: HashMap::new(), points, users, free }
    }

    /// The number of a point, which is one that no other point has for a new point.
    pub(in crate::hyperpatch) fn number(&mut self, point: DVec3) -> u32 {
        let number = self.find(point).unwrap_or_else(|| self.insert(point));
        self.users[number as usize] += 1;
        number
    }

    /// Gives a number back. When it was given back as often as it was given, there is no such point any more.
    pub(super) fn release(&mut self, number: u32) {
        let users = &mut self.users[number as usize];
        *users = users.saturating_sub(1);
        if *users > 0 {
            return;
        }
        let cube = self.cube(self.points[number as usize]);
        if let Some(list) = self.cubes.get_mut(&cube) {
            list.retain(|other| *other != number);
            if list.is_empty() {
                self.cubes.remove(&cube);
            }
        }
        self.free.push(number);
    }

    fn cube(&self, point: DVec3) -> [i64; 3] {
        ((point - self.origin) / (self.tolerance * 8.0)).floor().to_array().map(|x| x as i64)
    }

    fn find(&self, point: DVec3) -> Option<u32> {
        let (lo, hi) = (self.cube(point - self.tolerance), self.cube(point + self.tolerance));
        for x in lo[0]..=hi[0] {
            for y in lo[1]..=hi[1] {
                for z in lo[2]..=hi[2] {
                    let near = self.cubes.get(&[x, y, z]).into_iter().flatten();
                    let is_near = |n: &&u32| self.points[**n as usize].distance(point) <= self.tolerance;
                    if let Some(number) = near.copied().find(|n| is_near(&n)) {
                        return Some(number);
                    }
                }
            }
        }
        None
    }

    fn insert(&mut self, point: DVec3) -> u32 {
        let number = self.free.pop().unwrap_or_else(|| {
            self.points.push(point);
            self.users.push(0);
            self.points.len() as u32 - 1
        });
        self.points[number as usize] = point;
        self.cubes.entry(self.cube(point)).or_default().push(number);
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

    #[test]
    fn numbers_that_are_given_back_are_given_again() {
        let mut weld = Weld::new(1e-9, DVec3::ZERO);
        let points = [0, 1, 2].map(|n| DVec3::splat(f64::from(n)));
        let [a, b, _] = points.map(|point| weld.number(point));
        assert_eq!(weld.number(points[1]), b);
        weld.release(b);
        assert_eq!(weld.number(points[1]), b, "still used");
        weld.release(b);
        weld.release(b);
        assert_eq!(weld.number(DVec3::splat(9.0)), b);
        assert_ne!(weld.number(points[1]), b);
        assert_eq!(weld.number(points[0]), a);
    }
}
