//! Hyperpatches: cells on grids.

use criterion::{Criterion, criterion_group, criterion_main};
use directrix::hyperpatch::{Cell, Corner, Grid, Net};
use directrix::material::Composition;
use glam::DVec3;
use std::hint::black_box;

/// A box whose control points are moved by at most `jitter` along each axis, by the seed alone.
fn jittered(seed: u64, jitter: f64) -> Net {
    let cube = Net::cuboid(DVec3::ZERO, DVec3::ONE);
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut random = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    Net(cube.0.map(|point| point + DVec3::new(random(), random(), random()) * jitter))
}

/// Four materials, so that a point has seven components.
fn cell() -> Cell {
    let mixes = Corner::all().map(|corner| Composition::pure(corner.coefficient() % 4, 4));
    Cell::with_corner_mixes(jittered(1, 0.1), &mixes).expect("a sound cell")
}

fn grids(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("grid/64");
    let (cell, mut grid) = (cell(), Grid::new([64; 3]).expect("a sound grid"));
    group.bench_function("contraction", |bencher| bencher.iter(|| grid.evaluate(black_box(&cell))));
    group.bench_function("differences", |bencher| bencher.iter(|| grid.difference(black_box(&cell))));
    group.finish();
}

criterion_group!(benches, grids);
criterion_main!(benches);
