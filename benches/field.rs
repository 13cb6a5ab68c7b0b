//! Distance transforms of features of different shapes and sizes; see `docs/benchmarks.md`.

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use directrix::field::Grid;
use directrix::field::transform::{DistanceJob, scan};
use distance_transform::{BoolGrid, dt2d};
use std::hint::black_box;

/// Whether a place of [-1, 1]^3 belongs to a feature.
type Shape = (&'static str, fn([f64; 3]) -> bool);

/// Distances are those inside the shapes: all else is feature.
const SHAPES: [Shape; 4] = [
    ("cube", |p| p.iter().any(|x| x.abs() > 0.9)),
    ("sphere", |p| p.iter().map(|x| x * x).sum::<f64>() > 0.81),
    ("cone", |[x, y, z]| x.hypot(z) > 0.45 * (1.0 - y)),
    ("random", |p| {
        let hash = p.iter().fold(0.0, |sum, x| (sum + x * 12.9898).sin() * 43758.5453);
        hash.rem_euclid(1.0) < 0.001
    }),
];

fn features(size: [usize; 3], is_feature: fn([f64; 3]) -> bool) -> (Grid, Vec<u8>) {
    let [nx, ny, _] = size;
    let grid = Grid::new(size, [1.0; 3]).expect("a grid");
    let place = |index: usize| {
        let along = [index % nx, index / nx % ny, index / nx / ny];
        [0, 1, 2].map(|axis| {
            if size[axis] == 1 { 0.0 } else { (2 * along[axis] + 1) as f64 / size[axis] as f64 - 1.0 }
        })
    };
    let found = (0..grid.count()).map(|index| u8::from(is_feature(place(index)))).collect();
    (grid, found)
}

fn transforms(c: &mut Criterion) {
    for (name, is_feature) in SHAPES {
        for size in [[1024, 1024, 1], [64; 3], [128; 3], [256; 3]] {
            let (grid, found) = features(size, is_feature);
            let [nx, ny, nz] = size;
            let mut group = c.benchmark_group(format!("distance {name} {nx}x{ny}x{nz}"));
            group.sample_size(10);
            for (method, limit) in [("envelope", None), ("window 16", Some(16.0))] {
                let start = || DistanceJob::new(&grid, &found, limit).expect("a job");
                group.bench_function(method, |b| {
                    b.iter_batched(start, DistanceJob::run, BatchSize::PerIteration)
                });
            }
            if nz == 1 {
                let mut peer = BoolGrid::new(nx, ny);
                for (x, y, value) in peer.iter_mut() {
                    *value = found[y * nx + x] != 0;
                }
                group.bench_function("crate distance-transform", |b| b.iter(|| dt2d(black_box(&peer))));
            }
            group.bench_function("scan", |b| b.iter(|| scan(&grid, black_box(&found))));
            group.finish();
        }
    }
}

criterion_group!(benches, transforms);
criterion_main!(benches);
