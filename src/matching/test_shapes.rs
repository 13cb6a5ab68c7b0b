//! Random pairs of outlines for the unit tests.

use super::{Layout, Outline, Problem, Weights};
use glam::{DVec2, dvec2};
use std::f64::consts::TAU;

/// A small generator (Marsaglia's xorshift), so that cases repeat.
pub(super) struct Numbers(pub(super) u64);

impl Numbers {
    /// The next number, from 0 to 1.
    pub(super) fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number from `low` to `high`.
    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// A whole number from `low` to `high`, both included.
    pub(super) fn whole(&mut self, low: usize, high: usize) -> usize {
        low + ((high + 1 - low) as f64 * self.next()) as usize
    }
}

/// An outline with the normal of each vertex across the line between its neighbours.
pub(super) fn outline(points: Vec<DVec2>) -> Outline {
    let n = points.len();
    let normal = |i: usize| -(points[(i + 1) % n] - points[(i + n - 1) % n]).perp().normalize();
    let normals = (0..n).map(normal).collect();
    Outline::new(points, normals)
}

/// A lobed outline, unevenly sampled.
fn lobed(numbers: &mut Numbers, radius: f64, deepest: f64, count: usize, center: DVec2) -> Outline {
    let (lobes, depth) = (numbers.whole(1, 6) as f64, numbers.between(0.0, deepest));
    let (phase, turn) = (numbers.between(0.0, TAU), numbers.between(0.0, TAU));
    let jitter = numbers.between(0.0, 0.8);
    let point = |k: usize, numbers: &mut Numbers| {
        let t = TAU * (k as f64 + jitter * numbers.next()) / count as f64;
        center + radius * (1.0 + depth * (lobes * t + phase).cos()) * DVec2::from_angle(t + turn)
    };
    outline((0..count).map(|k| point(k, numbers)).collect())
}

/// A band bent to a C, whose inside is a pocket.
fn bent(numbers: &mut Numbers, count: usize, center: DVec2) -> Outline {
    let outer = count.div_ceil(2);
    let (width, opening) = (numbers.between(0.2, 0.7), numbers.between(0.1, 2.0));
    let turn = numbers.between(0.0, TAU);
    let angle =
        |k: usize, n: usize| turn + opening / 2.0 + (TAU - opening) * k as f64 / (n - 1).max(1) as f64;
    let out = (0..outer).map(|k| center + DVec2::from_angle(angle(k, outer)));
    let inner = count - outer;
    let back = (0..inner).rev().map(|k| center + (1.0 - width) * DVec2::from_angle(angle(k, inner)));
    outline(out.chain(back).collect())
}

/// A random pair, one outline inside the other, with vertex counts from `low` to `high`; either may be the inner one.
pub(super) fn random_problem(numbers: &mut Numbers, low: usize, high: usize) -> Problem {
    loop {
        let counts = [numbers.whole(low, high), numbers.whole(low, high)];
        let center = dvec2(numbers.between(-0.1, 0.1), numbers.between(-0.1, 0.1));
        let inner = if numbers.next() < 0.4 {
            bent(numbers, counts[0], center)
        } else {
            lobed(numbers, 0.9, 0.8, counts[0], center)
        };
        let outer = lobed(numbers, 2.4, 0.4, counts[1], DVec2::ZERO);
        let pair = if numbers.next() < 0.5 { [inner, outer] } else { [outer, inner] };
        let normal = if numbers.next() < 0.2 { 0.0 } else { 1.0 };
        if let Ok(problem) = Problem::new(pair, Weights { normal, ..Weights::default() }, 0.0) {
            return problem;
        }
    }
}

/// A random pair at different heights whose projections cross.
pub(super) fn random_crossing(numbers: &mut Numbers, low: usize, high: usize) -> Problem {
    loop {
        let counts = [numbers.whole(low, high), numbers.whole(low, high)];
        let center = dvec2(numbers.between(-0.4, 0.4), numbers.between(-0.4, 0.4));
        let pair =
            [lobed(numbers, 1.0, 0.5, counts[0], center), lobed(numbers, 1.2, 0.5, counts[1], DVec2::ZERO)];
        match Problem::new(pair, Weights::default(), 0.5) {
            Ok(problem) if problem.layout() == Layout::Crossing => return problem,
            Ok(_) | Err(_) => {}
        }
    }
}
