//! Laplace's equation on the cube of the paper; see `docs/benchmarks.md`.

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use directrix::laplace::{
    Conditions, Frame, LaplaceOptions, Method, Panel, Problem, SectionJob, samples, solve,
};
use glam::DVec3;
use std::hint::black_box;

fn faces(panel: &Panel) -> Result<f64, f64> {
    Ok(samples::cube_values(panel))
}

fn cube(m: usize) -> Problem {
    let mesh = samples::cube(m);
    let conditions = Conditions::single(mesh.panels().iter().map(faces));
    Problem::new(mesh, conditions).expect("the cube is closed")
}

fn laplace(c: &mut Criterion) {
    let mut group = c.benchmark_group("laplace cube");
    group.sample_size(10);
    let lu = LaplaceOptions { method: Method::Lu, ..LaplaceOptions::default() };
    let free = LaplaceOptions { most_dense: 0, ..LaplaceOptions::default() };
    let gmres = LaplaceOptions::default();
    for (name, m, options) in
        [("gmres", 9, gmres), ("gmres", 18, gmres), ("matrix-free", 18, free), ("lu", 9, lu)]
    {
        let problem = cube(m);
        group.bench_function(format!("{name} {}", 12 * m * m), |b| {
            b.iter_batched(
                || problem.clone(),
                |problem| solve(black_box(problem), options),
                BatchSize::PerIteration,
            )
        });
    }
    let solution = solve(cube(9), gmres).expect("the cube is solved");
    let frame = Frame { origin: DVec3::new(0.0, 0.5, 0.0), sides: [DVec3::X, DVec3::Z], size: [256, 256] };
    group.bench_function("section 256x256 of 972", |b| {
        b.iter(|| SectionJob::new(black_box(&solution), frame).map(SectionJob::run))
    });
    group.finish();
}

criterion_group!(benches, laplace);
criterion_main!(benches);
