//! Greedy matching of two wavy rings, visibility included, over the number of samples.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use directrix::matching::{Outline, Problem, Weights, greedy};
use glam::DVec2;
use std::f64::consts::TAU;
use std::hint::black_box;

/// Number of samples on each ring.
const COUNTS: [usize; 3] = [44, 100, 200];

/// A ring about the origin whose radius swings `waves` times by a tenth.
fn ring(radius: f64, waves: f64, count: usize) -> Outline {
    let point = |angle: f64| DVec2::from_angle(angle) * radius * (1.0 + 0.1 * (waves * angle).cos());
    let slope = |angle: f64| point(angle + 1e-6) - point(angle - 1e-6);
    let angles = || (0..count).map(move |i| TAU * i as f64 / count as f64);
    let normals = angles().map(|angle| -slope(angle).perp().normalize()).collect();
    Outline::new(angles().map(point).collect(), normals)
}

fn matching(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("greedy");
    for count in COUNTS {
        let outlines = [ring(1.0, 5.0, count), ring(2.0, 7.0, count)];
        let problem =
            Problem::new(outlines, Weights::default(), 0.0).expect("the rings lie inside each other");
        group.bench_function(BenchmarkId::from_parameter(count), |bencher| {
            bencher.iter(|| greedy(black_box(&problem)));
        });
    }
    group.finish();
}

criterion_group!(benches, matching);
criterion_main!(benches);
