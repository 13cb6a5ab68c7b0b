//! Sections of the presets of parts; see `docs/benchmarks.md`.

use criterion::{Criterion, criterion_group, criterion_main};
use directrix::document::{Json, PartModel, read_part};
use directrix::part::{Frame, RasterJob};
use std::hint::black_box;

fn sections(c: &mut Criterion) {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("www/presets/part");
    let mut group = c.benchmark_group("section 512x512");
    group.sample_size(20);
    for name in ["rectangle", "base", "lens", "scaffold", "tool"] {
        let text = std::fs::read_to_string(folder.join(format!("{name}.json"))).expect("a preset");
        let document = Json::parse(&text).and_then(|json| read_part(&json)).expect("a document");
        let model = PartModel::new(document).expect("a part");
        let frame = Frame::new(model.part().bounds().expect("a body"), [512, 512]).expect("a frame");
        let raster = || RasterJob::new(&**model.part(), black_box(frame)).expect("a job").run();
        group.bench_function(name, |b| b.iter(raster));
    }
    group.finish();
}

criterion_group!(benches, sections);
criterion_main!(benches);
