//! The harmonic blend of the preset with two curves, in its parts; see `docs/benchmarks.md`.

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use directrix::document::{Json, Solve, read_text};
use directrix::picture::{PictureOptions, figure, paint};
use std::hint::black_box;

fn harmonic(c: &mut Criterion) {
    let text = include_str!("../www/presets/warm-band.json");
    let document = read_text(text).expect("a preset");
    let mut group = c.benchmark_group("harmonic");
    group.sample_size(20);
    group.bench_function("solve 200 + 200", |b| {
        b.iter_batched(
            || document.clone(),
            |document| Solve::run(black_box(document)),
            BatchSize::PerIteration,
        )
    });
    let solution = Solve::run(document).expect("a blend");
    let options =
        Json::parse(r#"{"width": 512, "height": 512}"#).and_then(|json| PictureOptions::read(&json));
    let options = options.expect("options");
    let viewport = options.viewport(&solution.model);
    group.bench_function("paint 512 x 512", |b| {
        b.iter(|| {
            paint(&figure(black_box(&solution), &options.figure(&solution.model), &viewport), &viewport)
        })
    });
    group.finish();
}

criterion_group!(benches, harmonic);
criterion_main!(benches);
