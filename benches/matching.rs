//! Greedy and exact matching of two wavy rings, visibility included, over the number of samples.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use directrix::curve::{BSpline, Form};
use directrix::matching::{ExactOptions, Outline, Problem, Refine, Weights, exact, greedy, one_per_vertex};
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
        let problem = rings(count);
        group.bench_function(BenchmarkId::from_parameter(count), |bencher| {
            bencher.iter(|| greedy(black_box(&problem)));
        });
    }
    group.finish();
    let mut group = criterion.benchmark_group("exact");
    for count in COUNTS {
        let problem = rings(count);
        group.bench_function(BenchmarkId::from_parameter(count), |bencher| {
            bencher.iter(|| exact(black_box(&problem), ExactOptions::default()));
        });
    }
    let problem = rings(64);
    let optimum = exact(&problem, ExactOptions::default()).expect("the rings see each other");
    let pins = optimum.lines.iter().step_by(20).map(|line| (line.from, line.to)).collect();
    let options = ExactOptions { pins, ..ExactOptions::default() };
    group.bench_function("pinned/64", |bencher| {
        bencher.iter(|| exact(black_box(&problem), options.clone()));
    });
    group.bench_function("one-per-vertex/200", |bencher| {
        let problem = rings(200);
        bencher.iter(|| one_per_vertex(black_box(&problem)));
    });
    group.sample_size(10);
    group.bench_function("refined", |bencher| {
        let curves = [curve(10.0, 5.0), curve(20.0, 7.0)];
        bencher.iter(|| {
            let mut job = Refine::new(curves.clone(), Weights::default(), 0.0);
            loop {
                if let Some(refined) = job.step(&mut || true) {
                    break refined;
                }
            }
        });
    });
    group.finish();
}

/// Two wavy rings, one inside the other.
fn rings(count: usize) -> Problem {
    let outlines = [ring(1.0, 5.0, count), ring(2.0, 7.0, count)];
    Problem::new(outlines, Weights::default(), 0.0).expect("the rings lie inside each other")
}

/// A wavy curve through 40 control points.
fn curve(radius: f64, waves: f64) -> BSpline {
    let points = ring(radius, waves, 40).points;
    BSpline::new(3, Form::Periodic, points, None).expect("a closed curve")
}

criterion_group!(benches, matching);
criterion_main!(benches);
