//! Outlines with known normals: circles and lobed shapes, alone and one inside the other.

use directrix::matching::Outline;
use glam::{DVec2, dvec2};
use proptest::prelude::*;
use std::f64::consts::TAU;
use std::ops::RangeInclusive;

/// A star-shaped outline r(t) = 1 + depth cos(lobes t + phase), turned by `turn` radians.
#[derive(Debug, Clone, Copy)]
pub struct Shape {
    pub lobes: u32,
    pub depth: f64,
    pub phase: f64,
    pub turn: f64,
}

impl Shape {
    /// Samples the shape evenly by angle, counter-clockwise, scaled and moved.
    pub fn outline(&self, scale: f64, count: usize, center: DVec2) -> Outline {
        let (points, normals) = (0..count)
            .map(|k| {
                let t = TAU * k as f64 / count as f64;
                let lobes = f64::from(self.lobes);
                let radius = 1.0 + self.depth * (lobes * t + self.phase).cos();
                let slope = -self.depth * lobes * (lobes * t + self.phase).sin();
                let outward = DVec2::from_angle(t + self.turn);
                let tangent = slope * outward + radius * outward.perp();
                (center + scale * radius * outward, -tangent.perp().normalize())
            })
            .unzip();
        Outline::new(points, normals)
    }
}

/// A circle, sampled from angle 0 on.
pub fn circle(radius: f64, count: usize, center: DVec2) -> Outline {
    Shape { lobes: 1, depth: 0.0, phase: 0.0, turn: 0.0 }.outline(radius, count, center)
}

/// Two lobed outlines, the first inside the second, with counts from `counts`; some are tame, some have deep pockets.
pub fn random_pair(counts: RangeInclusive<usize>) -> impl Strategy<Value = ([Shape; 2], Outline, Outline)> {
    let shape = |deepest: f64| {
        (1_u32..7, 0.0..deepest, 0.0..TAU, 0.0..TAU).prop_map(|(lobes, depth, phase, turn)| Shape {
            lobes,
            depth,
            phase,
            turn,
        })
    };
    (shape(0.75), shape(0.3), counts.clone(), counts, -0.1..0.1, -0.1..0.1).prop_filter_map(
        "one polygon inside the other",
        |(inner, outer, a, b, x, y)| {
            let first = inner.outline(1.0, a, dvec2(x, y));
            let second = outer.outline(2.9, b, DVec2::ZERO);
            let nested = directrix::matching::Problem::new(
                [first.clone(), second.clone()],
                directrix::matching::Weights::default(),
                0.0,
            );
            nested.is_ok().then_some(([inner, outer], first, second))
        },
    )
}
