//! What holds after any sequence of operations.

use super::test_bodies::{at_point, block, check_body, fan, random_mix, random_vector, ring, shuffled};
use super::{
    Change, Extrusion, Normals, OperationError, Reach, Slope, Start, copy, delete, extrude, mirror,
    mix_cells, mix_coefficient, mix_corner, move_coefficient, moves, neighbourhood, reorient, set_continuity,
    slope, subdivide,
};
use crate::hyperpatch::composite::{Body, CellId, Match, Sharing, Side};
use crate::hyperpatch::test_cells::random;
use crate::hyperpatch::{Axis, Corner, Face, Jacobian};
use glam::DVec3;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};

/// Cells from which on a sequence adds no more.
const MANY: usize = 40;

/// Runs a property on sequences of seeds; where it fails, the seed of the runner and the sequence are printed.
fn run(seed: u64, cases: u32, property: impl Fn(Vec<u64>) -> Result<(), TestCaseError>) {
    let config = Config {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(seed),
        max_shrink_iters: 200,
        ..Config::default()
    };
    let sequences = proptest::collection::vec(0..1_000_000_u64, 1..40);
    if let Err(failure) = TestRunner::new(config).run(&sequences, property) {
        panic!("seed {seed}: {failure}");
    }
}

fn start(seed: u64) -> Body {
    match seed % 4 {
        0 => shuffled(&block([2, 2, 2]), seed),
        1 => ring(6),
        2 => shuffled(&fan(5), seed),
        _ => block([3, 2, 1]),
    }
}

/// One operation that depends on the seed alone.
fn operate(body: &mut Body, seed: u64, first: CellId) -> Result<Change, OperationError> {
    let pick = |n: u64, most: usize| (random(seed * 17 + n) * most as f64) as usize;
    let ids: Vec<CellId> = body.cells().iter().map(|(id, _)| *id).collect();
    let id = ids[pick(0, ids.len())];
    let some: Vec<CellId> = ids.iter().copied().filter(|id| random(seed + u64::from(id.0)) < 0.4).collect();
    let (at, corner) = (pick(1, 64), Corner::all()[pick(2, 8)]);
    let (axis, face) = (Axis::ALL[pick(3, 3)], Face::all()[pick(4, 6)]);
    let by = random_vector(seed) * [0.02, 0.1, 1e3][pick(5, 3)];
    let wanted = |n: u64| [None, Some(Match::None), Some(Match::Block), Some(Match::C1)][pick(n, 4)];
    let has_room = ids.len() < MANY;
    match pick(6, 24) {
        0..=4 => move_coefficient(body, id, at, by, Reach::Block),
        5 => move_coefficient(body, id, at, by * 0.1, Reach::Single),
        6..=10 => set_continuity(body, id, face, None, wanted(7), wanted(8)),
        11 => mix_corner(body, id, corner, &random_mix(seed), None),
        12 => mix_corner(body, id, corner, &random_mix(seed), Some(&some)),
        13 => mix_cells(body, &some, &random_mix(seed)),
        14 => mix_coefficient(body, id, at, &random_mix(seed)),
        15 => slope(body, id, corner, Slope::Flat),
        16 | 17 => slope(body, id, corner, Slope::Natural),
        18 if has_room => subdivide(body, id, axis, [0.5, 0.25, 0.7][pick(9, 3)], first),
        19 if has_room => {
            let start = [Start::C1, Start::Free][pick(10, 2)];
            let normals = [Normals::Mean, Normals::Surface][pick(11, 2)];
            let mix = if pick(12, 2) == 0 { None } else { Some(random_mix(seed)) };
            extrude(body, &Extrusion { faces: vec![(id, face)], by: 0.4, start, normals, mix }, first)
        }
        20 if has_room => copy(body, &some, by * 100.0, first),
        21 if has_room => mirror(body, &some, by, 1.5, pick(13, 2) == 0, first),
        22 => reorient(body, &some),
        23 if ids.len() > 4 => delete(body, &[id]),
        _ => move_coefficient(body, id, corner.coefficient(), by, Reach::Block),
    }
}

/// Whatever is done in whatever order: what is marked holds within 1e-12, every composition is in the simplex, what is
/// refused changes nothing, and moves of regular corners break no mark.
#[test]
fn marks_hold_and_compositions_stay_in_the_simplex_after_any_sequence() {
    run(2017, 120, |seeds| {
        let mut body = start(seeds[0]);
        for (n, &seed) in seeds.iter().enumerate() {
            let before = body.clone();
            let result = operate(&mut body, seed, CellId(10_000 * (n as u32 + 1)));
            check_body(&body);
            match result {
                Err(error) => {
                    prop_assert_eq!(&body, &before, "{}", error);
                    prop_assert!(!error.to_string().is_empty());
                }
                Ok(change) => {
                    prop_assert!(change.made.iter().all(|id| body.cell(*id).is_some()));
                    prop_assert!(change.removed.iter().all(|id| body.cell(*id).is_none()));
                    let known = |id: &CellId| change.touched.contains(id) || change.made.contains(id);
                    for (id, cell) in body.cells().iter().filter(|(id, _)| !known(id)) {
                        prop_assert_eq!(before.cell(*id), Some(cell), "cell {} was not said to change", id);
                    }
                    for ((_, cell), bounds) in body.cells().iter().zip(body.boxes()) {
                        prop_assert_eq!(cell.net().bounds(), *bounds);
                    }
                }
            }
        }
        Ok(())
    });
}

/// What is wanted of a face is brought about and marked, whatever else is wanted at its corners, and comes to nothing only
/// where it is refused.
#[test]
fn what_is_wanted_is_brought_about() {
    run(2021, 60, |seeds| {
        let mut body = start(seeds[0]);
        for (n, &seed) in seeds.iter().enumerate() {
            let _ = operate(&mut body, seed, CellId(10_000 * (n as u32 + 1)));
            let (id, _) = body.cells()[(random(seed + 5) * body.cells().len() as f64) as usize];
            let face = Face::all()[(random(seed + 6) * 6.0) as usize];
            let wanted = [Some(Match::None), Some(Match::Block), Some(Match::C1)];
            let [shape, material] = [7, 8].map(|m| wanted[(random(seed + m) * 3.0) as usize]);
            match set_continuity(&mut body, id, face, None, shape, material) {
                Ok(change) => {
                    prop_assert!(change.touched.contains(&id));
                    let corners =
                        Corner::all().into_iter().filter(|c| c.0[face.axis as usize] == face.is_end);
                    for corner in corners {
                        let mark = body.marks().get(Side { cell: id, corner, axis: face.axis });
                        let marked = mark.map(|mark| (mark.shape, mark.material));
                        prop_assert_eq!(marked, Some((shape, material)), "cell {}, corner {}", id, corner);
                    }
                    check_body(&body);
                }
                Err(error) => prop_assert!(
                    matches!(error, OperationError::Outer { .. } | OperationError::Irregular { .. }),
                    "{}",
                    error
                ),
            }
        }
        Ok(())
    });
}

/// Regular corners that are marked stay smooth in moves of any size, there and back, and so do not lose their marks.
#[test]
fn moves_of_regular_corners_keep_their_marks() {
    run(2018, 40, |seeds| {
        let mut body = shuffled(&block([2, 2, 2]), seeds[0]);
        let faces: Vec<_> = Sharing::new(&body).shared_faces();
        for face in faces {
            let (id, face) = face.sides[0];
            set_continuity(&mut body, id, face, None, Some(Match::C1), None).unwrap();
        }
        let marks = body.marks().clone();
        prop_assert_eq!(marks.iter().count(), 48);
        for seed in seeds {
            let (id, at) = ((random(seed) * 8.0) as u32, (random(seed + 1) * 64.0) as usize);
            let by = random_vector(seed) * [1e-3, 0.1, 1e7][seed as usize % 3];
            move_coefficient(&mut body, CellId(id), at, by, Reach::Block).unwrap();
            if by.length() > 1.0 {
                // Far away and back leaves the rounding of large numbers in small ones.
                move_coefficient(&mut body, CellId(id), at, -by, Reach::Block).unwrap();
            }
            prop_assert_eq!(body.marks(), &marks);
            check_body(&body);
            let sharing = Sharing::new(&body);
            for face in sharing.shared_faces() {
                let [p, q] = face.sides.map(|(id, face)| body.cell(id).unwrap().net().face(face));
                prop_assert!((0..16).all(|n| p[n] == q[face.matching.coefficient(n)]));
            }
        }
        Ok(())
    });
}

/// A move and the opposite one leave everything where it was, up to rounding.
#[test]
fn moving_back_undoes_a_move() {
    run(2019, 40, |seeds| {
        let mut body = start(seeds[0]);
        for (n, &seed) in seeds.iter().enumerate().take(12) {
            let _ = operate(&mut body, seed, CellId(10_000 * (n as u32 + 1)));
            let before = body.clone();
            let (id, _) = &before.cells()[(random(seed) * before.cells().len() as f64) as usize];
            let at = (random(seed + 2) * 64.0) as usize;
            let by = random_vector(seed + 3) * 0.02;
            let there = moves(&body, *id, at, Reach::Block).unwrap();
            move_coefficient(&mut body, *id, at, by, Reach::Block).unwrap();
            prop_assert_eq!(moves(&body, *id, at, Reach::Block).unwrap(), there, "the same moves back");
            move_coefficient(&mut body, *id, at, -by, Reach::Block).unwrap();
            let size = before.size() + before.bounds().1.abs().max_element();
            for ((_, now), (_, was)) in body.cells().iter().zip(before.cells()) {
                for (p, q) in now.net().0.iter().zip(&was.net().0) {
                    prop_assert!(p.distance(*q) <= 1e-13 * size, "{} {}", p, q);
                }
            }
            body = before;
        }
        Ok(())
    });
}

/// A block of eight whose middle is moved about and cut in all ways: volume and amounts stay, faces meet whole.
#[test]
fn cuts_keep_volume_and_amounts_and_faces_whole() {
    run(2020, 25, |seeds| {
        let mut body = shuffled(&block([2, 2, 1]), seeds[0]);
        for (n, &seed) in seeds.iter().enumerate().take(8) {
            let (id, _) = body.cells()[(random(seed) * body.cells().len() as f64) as usize];
            let at = (random(seed + 1) * 64.0) as usize;
            move_coefficient(&mut body, id, at, random_vector(seed) * 0.05, Reach::Block).unwrap();
            mix_coefficient(&mut body, id, at, &random_mix(seed)).unwrap();
            if body.cells().len() > MANY {
                break;
            }
            let (volume, amounts) = (absolute_volume(&body), body.amounts());
            let t = 0.1 + 0.8 * random(seed + 2);
            subdivide(&mut body, id, Axis::ALL[seed as usize % 3], t, CellId(10_000 * (n as u32 + 1)))
                .unwrap();
            prop_assert!((absolute_volume(&body) - volume).abs() < 1e-12);
            for (now, was) in body.amounts().into_iter().zip(amounts) {
                prop_assert!((now - was).abs() < 1e-12);
            }
            let sharing = Sharing::new(&body);
            prop_assert!(sharing.contacts(&body).is_empty());
            // The outside is that of a block: every face is shared by two cells or lies on the outside.
            let sides = sharing.shared_faces().len() * 2 + sharing.outer_faces().len();
            prop_assert_eq!(sides, body.cells().len() * 6);
            let inside = |(id, face): (CellId, Face)| {
                let points = body.cell(id).unwrap().net().face(face);
                // Inner faces lie near the two middle planes, and outer ones far from them or across.
                points
                    .iter()
                    .all(|p| p.x > 0.2 && p.x < 1.8 && p.y > 0.2 && p.y < 1.8 && p.z > 0.2 && p.z < 0.8)
            };
            prop_assert!(!sharing.outer_faces().into_iter().any(inside));
        }
        Ok(())
    });
}

fn absolute_volume(body: &Body) -> f64 {
    body.cells().iter().map(|(_, cell)| Jacobian::new(cell.net()).volume().abs()).sum()
}

/// An edit at one of 384 cells looks at the boxes of the others and no further; it must not take long, whatever the
/// machine.
#[test]
fn an_edit_in_a_large_body_is_local() {
    let mut body = block([8, 8, 6]);
    let middle = DVec3::splat(3.0);
    let id = body.cells().iter().find(|(_, cell)| cell.net().0[0] == middle).unwrap().0;
    let at = at_point(&body, id.0, middle + DVec3::X / 3.0);
    let each = timed(|| {
        for n in 0..200 {
            let by = random_vector(n) * 1e-3;
            let change = move_coefficient(&mut body, id, at, by, Reach::Block).unwrap();
            assert_eq!(change.touched.len(), 8);
        }
    }) / 200;
    println!("{each:?} for the move of a neighbour in a body of {} cells", body.cells().len());
    assert!(each.as_micros() < 5000, "{each:?}");
    let found = neighbourhood(&body, id, Corner([false; 3])).unwrap();
    assert!(found.joints.iter().all(|joint| joint.shape == Match::C1));

    // Near the limit of cells.
    let mut body = block([20, 20, 22]);
    let at = Corner([true; 3]).coefficient();
    let (id, by) = (CellId(4000), DVec3::X * 1e-3);
    let move_time = timed(|| drop(move_coefficient(&mut body, id, at, by, Reach::Block).unwrap()));
    let face = Face { axis: Axis::W, is_end: true };
    let faces = (0..400).map(|n| (CellId(n * 22 + 21), face)).collect();
    let (start, normals) = (Start::C1, Normals::Surface);
    let what = Extrusion { faces, by: 0.5, start, normals, mix: None };
    let extrude_time = timed(|| drop(extrude(&mut body, &what, CellId(20_000)).unwrap()));
    let cut_time = timed(|| drop(subdivide(&mut body, id, Axis::W, 0.5, CellId(30_000)).unwrap()));
    println!(
        "{move_time:?} to move, {extrude_time:?} to extrude, {cut_time:?} to cut 400 of {}",
        body.cells().len()
    );
    assert_eq!(body.cells().len(), 9600);
    assert!((move_time + extrude_time + cut_time).as_millis() < 3000);
}

fn timed(work: impl FnOnce()) -> std::time::Duration {
    let start = std::time::Instant::now();
    work();
    start.elapsed()
}
