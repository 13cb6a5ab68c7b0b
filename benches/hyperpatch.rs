//! Hyperpatches: cells on grids, certificates, relations, sections and surfaces, with the sizes of the budgets.

use criterion::{Criterion, criterion_group, criterion_main};
use directrix::document::{
    Action, Answer, BodyAsk, BodyJob, BodyMemory, DocumentKey, HyperpatchModel, MaterialSpec, Operation,
};
use directrix::hyperpatch::composite::{Body, CellId, Pairs, Probe, Sharing};
use directrix::hyperpatch::operation::Reach;
use directrix::hyperpatch::validity::{Verdict, certify, verdict};
use directrix::hyperpatch::{Cell, Corner, Grid, Jacobian, Net, Plane, Tessellation, flat, section};
use directrix::material::Composition;
use glam::{DMat2, DVec2, DVec3};
use std::f64::consts::TAU;
use std::hint::black_box;
use std::rc::Rc;
use std::sync::Arc;

/// A unit cube at a place, whose control points are moved by at most `jitter` along each axis, by the seed alone.
fn jittered(min: DVec3, seed: u64, jitter: f64) -> Net {
    let cube = Net::cuboid(min, min + 1.0);
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut random = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    Net(cube.0.map(|point| point + DVec3::new(random(), random(), random()) * jitter))
}

/// A cell of a ring of `count` about the z axis, `level` storeys up.
fn ring_cell(count: usize, index: usize, level: usize) -> Net {
    let angle = TAU / count as f64;
    let kappa = 4.0 / 3.0 * (angle / 4.0).tan();
    let [start, end] = [index, index + 1].map(|n| DVec2::from_angle(angle * n as f64));
    let arc = [start, start + start.perp() * kappa, end - end.perp() * kappa, end];
    let mut points = [DVec3::ZERO; 64];
    for (i, direction) in arc.into_iter().enumerate() {
        for j in 0..4 {
            for k in 0..4 {
                let radius = 2.0 - j as f64 / 3.0;
                points[flat(i, j, k)] = (direction * radius).extend(level as f64 + k as f64 / 3.0);
            }
        }
    }
    Net(points)
}

/// A cell of four materials, so that a point has seven components.
fn cell(net: Net) -> Cell {
    let mixes = Corner::all().map(|corner| Composition::pure(corner.coefficient() % 4, 4));
    Cell::with_corner_mixes(net, &mixes).expect("a sound cell")
}

/// Rings of eight cells on top of each other.
fn tower(levels: usize) -> Body {
    let mut body = Body::new(4);
    for n in 0..8 * levels {
        body.add(cell(ring_cell(8, n % 8, n / 8))).expect("few cells");
    }
    body
}

/// A box twisted by 150 degrees: sound, but not regular.
fn twisted() -> Net {
    let cube = Net::cuboid(DVec3::new(-1.0, -1.0, 0.0), DVec3::new(1.0, 1.0, 2.0));
    Net(std::array::from_fn(|n| {
        let turn = DMat2::from_angle(150_f64.to_radians() * (n % 4) as f64 / 3.0);
        (turn * cube.0[n].truncate()).extend(cube.0[n].z)
    }))
}

fn grids(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("hyperpatch/grid/64");
    let (cell, mut grid) = (cell(jittered(DVec3::ZERO, 1, 0.1)), Grid::new([64; 3]).expect("a sound grid"));
    group.bench_function("contraction", |bencher| bencher.iter(|| grid.evaluate(black_box(&cell))));
    group.bench_function("differences", |bencher| bencher.iter(|| grid.difference(black_box(&cell))));
    group.finish();
}

fn certificates(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("hyperpatch/certify");
    group.sample_size(20);
    let thousands: [(&str, Vec<Net>); 3] = [
        ("1000-ring", (0..1000).map(|n| ring_cell(8, n % 8, n / 8)).collect()),
        ("1000-jittered-05", (0..1000).map(|n| jittered(DVec3::ZERO, n, 0.05)).collect()),
        ("1000-jittered-10", (0..1000).map(|n| jittered(DVec3::ZERO, n, 0.1)).collect()),
    ];
    let count = |nets: &[Net]| nets.iter().filter(|net| certify(net).verdict == Verdict::Regular).count();
    for (name, nets) in &thousands {
        group.bench_function(*name, |bencher| bencher.iter(|| count(black_box(nets))));
    }
    let corner: Vec<Net> = (0..8).map(|n| jittered(DVec3::ZERO, n, 0.05)).collect();
    group.bench_function("8-round-a-corner", |bencher| bencher.iter(|| count(black_box(&corner))));
    let one = jittered(DVec3::ZERO, 1, 0.1);
    group.bench_function("jacobian", |bencher| bencher.iter(|| Jacobian::new(black_box(&one))));
    let twisted = twisted();
    group.bench_function("verdict-twisted-150", |bencher| bencher.iter(|| verdict(black_box(&twisted))));
    group.finish();
}

fn bodies(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("hyperpatch/body");
    group.sample_size(10);
    let tower = tower(50);
    group.bench_function("sharing-400", |bencher| bencher.iter(|| Sharing::new(black_box(&tower))));
    group.bench_function("pairs-400", |bencher| bencher.iter(|| Pairs::new(black_box(&tower)).run()));
    let sharing = Sharing::new(&tower);
    group.bench_function("tessellate-400", |bencher| {
        bencher.iter(|| {
            let faces = sharing.outer_faces();
            Tessellation::new(&tower, &sharing, faces, 1e-3).expect("a sound tolerance").run()
        });
    });
    // Upright through the axis: four cells of each of 25 storeys.
    let low = self::tower(25);
    let plane = Plane::new(DVec3::new(0.3, 1.0, 0.0), 0.0).expect("a plane");
    group.bench_function("section-100-of-16", |bencher| bencher.iter(|| section(black_box(&low), plane, 16)));
    let probe = Probe::new(&low);
    group.bench_function("probe-128x128", |bencher| {
        bencher.iter(|| {
            let place =
                |n: usize| DVec3::new((n / 128) as f64 / 32.0 - 2.0, (n % 128) as f64 / 32.0 - 2.0, 7.3);
            (0..128 * 128).filter(|&n| probe.place(place(n)).is_some()).count()
        });
    });
    group.finish();
}

/// A frame of the drag of a corner among 384 cells: the edit, its certificates, and the vertices that are new.
fn drags(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("hyperpatch/drag");
    let material =
        |n: usize| MaterialSpec { name: format!("m{n}"), color: "#808080".to_owned(), void: false };
    let base = HyperpatchModel::document_of(
        "Tower".to_owned(),
        "mm".to_owned(),
        (0..4).map(material).collect(),
        &tower(48),
    );
    let mut memory = BodyMemory::default();
    let (mut frame, mut since) = (0_u32, 0);
    group.bench_function("384", |bencher| {
        bencher.iter(|| {
            frame += 1;
            let by = [f64::from(frame % 200) * 1e-4, 0.0, 0.0];
            let action = Action::Move { cell: CellId(57), at: [3, 0, 0], by, reach: Reach::Block };
            let mut document = base.clone();
            document.operations.push((1, Arc::new(Operation { id: None, action, materials: 4 })));
            let model = HyperpatchModel::after(document, memory.models()).expect("sound colours");
            let key = DocumentKey { head: String::new(), operations: vec![0, frame] };
            let known = memory.keep(key, model);
            let certified = BodyJob::new(Rc::clone(&known), BodyAsk::Verdicts { is_global: false }).run();
            let ask = BodyAsk::Surface { tolerance: None, has_inner: false, since: Some(since) };
            let surface = BodyJob::new(known, ask).run();
            if let Some(Answer::Surface(surface, _)) = &surface {
                since = surface.id;
            }
            (certified.is_some(), surface.is_some())
        });
    });
    group.finish();
}

criterion_group!(benches, grids, certificates, bodies, drags);
criterion_main!(benches);
