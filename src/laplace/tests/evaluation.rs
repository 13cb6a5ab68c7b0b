//! Values near the boundary, on it and outside, gradients, and sections.

use super::*;
use crate::laplace::{Fault, Frame, SectionJob};
use glam::{DVec2, DVec3};

#[test]
fn values_keep_the_panels_accuracy_right_up_to_the_boundary() {
    let solution = cube(8);
    let h = 1.0 / 8.0;
    for depth in [0.001, 0.008, 0.08, 0.24, 0.48, 1.0] {
        let mut error: f64 = 0.0;
        for k in 0..49 {
            let [a, b] = [k % 7, k / 7].map(|k| 0.2 + 0.1 * f64::from(k));
            let d = depth * h;
            for p in [DVec3::new(a, b, 1.0 - d), DVec3::new(d, a, b), DVec3::new(a, b, d)] {
                error = error.max((value(&solution, p) - known::cube(p)).abs());
            }
        }
        assert!(error <= 8e-3, "{error} at {depth} panels below a face");
    }
}

#[test]
fn beyond_two_panels_from_jumps_nothing_overshoots() {
    for m in [4, 8, 12] {
        let solution = cube(m);
        let edge = |x: f64| x.min(1.0 - x);
        // The jumps are where the top and the bottom meet the sides.
        let is_far = |p: &DVec3| edge(p.x).min(edge(p.y)).hypot(edge(p.z)) > 2.0 / m as f64;
        let faces = inner(5).into_iter().flat_map(|p| [p.with_z(0.999), p.with_x(0.001)]);
        let places: Vec<DVec3> = inner(7).into_iter().chain(faces).filter(is_far).collect();
        assert!(places.len() > 10);
        let error = worst(&solution, &places, known::cube);
        assert!(error <= 1e-2, "{error} with {m} panels along an edge");
    }
}

#[test]
fn shown_values_keep_to_the_maximum_principle_and_clamps_are_told() {
    let solution = cube(4);
    assert_eq!(solution.ranges(), [Some([0.0, 1.0])]);
    let mut clamped = 0;
    for k in 0..1600 {
        let p = DVec3::new(0.01 + 0.024 * f64::from(k % 40), 0.002, 0.9995 - 0.006 * f64::from(k / 40));
        let found = solution.at(p).unwrap();
        assert!((0.0..=1.0).contains(&found.values[0]));
        clamped += usize::from(found.is_clamped);
    }
    assert!(clamped > 0, "beside a jump coarse panels overshoot");
}

#[test]
fn points_on_the_boundary_have_its_values_and_points_outside_none() {
    let solution = solved(samples::cube(6), |panel| Ok(panel.centre.x));
    for p in [
        DVec3::new(0.31, 0.42, 0.0),
        DVec3::new(1.0, 0.4, 0.6),
        DVec3::new(0.3, 0.0, 1.0),
        DVec3::new(0.5, 0.5, 0.5),
    ] {
        assert!((value(&solution, p) - p.x).abs() < 3e-2, "{} at {p}", value(&solution, p));
    }
    assert!(solution.at(DVec3::ONE).is_some() && solution.at(DVec3::ZERO).is_some(), "corners belong to it");
    for p in [DVec3::new(0.5, 0.5, 1.000_001), DVec3::splat(3.0), DVec3::new(-1e-6, 0.2, 0.2)] {
        assert_eq!(solution.at(p), None);
        assert_eq!(solution.gradient(p), None);
    }
    let ring = solved(samples::annulus(0.4, 1.0, 64), |panel| Ok(panel.centre.x));
    assert_eq!(ring.at(DVec3::ZERO), None, "the hole is outside");
}

#[test]
fn gradients_are_those_of_the_solution() {
    let of = |panel: &Panel| Ok(panel.centre.x * panel.centre.x - panel.centre.y * panel.centre.y);
    let solution = solved(samples::cube(8), of);
    for p in inner(4) {
        let found = solution.gradient(p).unwrap()[0];
        assert!(found.distance(DVec3::new(2.0 * p.x, -2.0 * p.y, 0.0)) < 4e-2, "{found} at {p}");
        let step = 1e-3;
        let along =
            (value(&solution, p + DVec3::X * step) - value(&solution, p - DVec3::X * step)) / (2.0 * step);
        assert!((found.x - along).abs() < 5e-3, "{} and {along}", found.x);
    }
    let ring = solved(samples::annulus(0.4, 1.0, 128), |panel| Ok(panel.centre.length().ln()));
    for p in [DVec3::new(0.7, 0.1, 0.0), DVec3::new(-0.2, 0.5, 0.0)] {
        let found = ring.gradient(p).unwrap()[0];
        assert!(found.distance(p / p.length_squared()) < 2e-2, "{found}");
    }
    let wall = solution.gradient(DVec3::new(1.0, 0.31, 0.52)).unwrap()[0];
    assert!((wall.x - 2.0).abs() < 0.2, "{wall} on the boundary");
}

#[test]
fn sections_are_what_points_say() {
    let cases = [
        (
            cube(6),
            Frame {
                origin: DVec3::new(-0.1, 0.5, -0.1),
                sides: [DVec3::X * 1.2, DVec3::Z * 1.2],
                size: [70, 45],
            },
        ),
        (cube(4), Frame { origin: DVec3::new(0.0, 0.0, 1.0), sides: [DVec3::X, DVec3::Y], size: [20, 20] }),
        (
            solved(samples::annulus(0.4, 1.0, 96), |panel| Ok(panel.centre.x * panel.centre.y)),
            Frame {
                origin: DVec3::new(-1.0, -1.0, 0.0),
                sides: [DVec3::X * 2.0, DVec3::Y * 2.0],
                size: [61, 50],
            },
        ),
    ];
    for (solution, frame) in cases {
        let section = SectionJob::new(&solution, frame).unwrap().run();
        let mut inside = 0;
        for j in 0..frame.size[1] {
            for i in 0..frame.size[0] {
                let at = |k: usize, axis: usize| (k as f64 + 0.5) / frame.size[axis] as f64;
                let p = frame.origin + frame.sides[0] * at(i, 0) + frame.sides[1] * at(j, 1);
                let shown = section.values[0][j * frame.size[0] + i];
                match solution.at(p) {
                    Some(found) => {
                        inside += 1;
                        assert!(
                            (f64::from(shown) - found.values[0]).abs() < 2e-3,
                            "{shown}, not {found:?}, at {p}"
                        );
                    }
                    None => assert!(shown.is_nan(), "{shown} at {p}"),
                }
            }
        }
        assert_eq!(section.inside, inside);
        assert!(inside > 300);
    }
}

/// The value at a point by exact integrals over all panels in double precision, and the share of the full angle.
fn summed(solution: &Solution, p: DVec3) -> (f64, f64) {
    let scaling = solution.problem().mesh().scaling();
    let x = scaling.inwards(p);
    let (values, fluxes) = (&solution.values()[0], &solution.fluxes()[0]);
    let (mut sum, mut winding) = (0.0, 0.0);
    for (number, panel) in solution.panels.list.iter().enumerate() {
        let layers = solution.panels.space.layers(panel, x);
        sum += layers.single * fluxes[number] / scaling.scale() + layers.double * values[number];
        winding += layers.double;
    }
    let value = sum / winding;
    let clamped = solution.ranges()[0].map_or(value, |[low, high]| value.clamp(low, high));
    (clamped, winding)
}

#[test]
fn sections_are_the_exact_integrals_to_a_part_in_a_hundred_thousand() {
    let frame = |origin: [f64; 3], u: DVec3, v: DVec3, size| Frame {
        origin: DVec3::from_array(origin),
        sides: [u, v],
        size,
    };
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let wave = |panel: &Panel| Ok(panel.centre.x * panel.centre.y + panel.centre.y);
    let mixed = |panel: &Panel| if panel.normal.z.abs() > 0.5 { faces(panel) } else { Err(0.0) };
    let annulus = frame([-1.05, -1.05, 0.0], 2.1 * x, 2.1 * y, [97, 97]);
    let cases = [
        ("annulus", solved(samples::annulus(0.4, 1.0, 120), wave), annulus),
        // More panels than pixels, and a boundary hardly longer than a pixel.
        ("fine annulus", solved(samples::annulus(0.4, 1.0, 900), wave), annulus),
        (
            "beside the inner circle",
            solved(samples::annulus(0.4, 1.0, 120), wave),
            frame([0.39, -0.02, 0.0], 0.04 * x, 0.04 * y, [64, 64]),
        ),
        ("square of four segments", solved(samples::square(1), wave), frame([0.0; 3], x, y, [64, 64])),
        ("cube", cube(6), frame([0.0, 0.45, 0.0], x, z, [80, 80])),
        ("aslant", solved(samples::cube(5), mixed), frame([0.0; 3], x + y, z + 0.2 * x, [60, 60])),
        (
            "beside the strip of slivers",
            solved(samples::sliver_cube(4, 1e-3), faces),
            frame([-0.01, 0.3, 0.45], 0.2 * x, 0.2 * z, [64, 64]),
        ),
    ];
    for (name, solution, frame) in cases {
        let section = SectionJob::new(&solution, frame).unwrap().run();
        let mut worst: f64 = 0.0;
        let mut inside = 0;
        for (pixel, shown) in section.values[0].iter().enumerate() {
            let at = |axis: usize, k: usize| (k as f64 + 0.5) / frame.size[axis] as f64;
            let [i, j] = [pixel % frame.size[0], pixel / frame.size[0]];
            let p = frame.origin + frame.sides[0] * at(0, i) + frame.sides[1] * at(1, j);
            let (value, winding) = summed(&solution, p);
            assert_eq!(shown.is_nan(), winding < 0.06, "{name} at {p}: {shown}, {winding}");
            if !shown.is_nan() {
                worst = worst.max((f64::from(*shown) - value).abs());
                inside += 1;
            }
        }
        let [low, high] = solution.ranges()[0].unwrap();
        assert!(worst < 1e-5 * (high - low) && inside > 1000, "{name}: {worst} on {inside} pixels");
    }
}

#[test]
fn sections_of_one_pixel_of_one_row_and_beside_the_body_are_made() {
    let ring = solved(samples::annulus(0.4, 1.0, 96), |panel| Ok(panel.centre.x));
    let made = |origin: DVec3, sides: [DVec3; 2], size| {
        let mut job = SectionJob::new(&ring, Frame { origin, sides, size }).unwrap();
        let mut shares = vec![job.progress()];
        while !job.step(&mut || false) {
            shares.push(job.progress());
        }
        assert!(shares.is_sorted() && shares[0] == 0.0 && job.progress() == 1.0, "{shares:?}");
        job.section()
    };
    let one = made(DVec3::new(0.69, -0.01, 0.0), [DVec3::X * 0.02, DVec3::Y * 0.02], [1, 1]);
    assert!((f64::from(one.values[0][0]) - value(&ring, DVec3::X * 0.7)).abs() < 1e-5);
    let row = made(DVec3::new(-1.0, 0.0, 0.0), [DVec3::X * 2.0, DVec3::Y * 1e-3], [1000, 1]);
    assert!((590..=610).contains(&row.inside), "{}", row.inside);
    for (pixel, shown) in row.values[0].iter().enumerate().filter(|(_, shown)| !shown.is_nan()) {
        let p = DVec3::new(-1.0 + 2e-3 * (pixel as f64 + 0.5), 5e-4, 0.0);
        assert!((f64::from(*shown) - value(&ring, p)).abs() < 1e-4, "{shown} at {p}");
    }
    for origin in [DVec3::splat(5.0).with_z(0.0), DVec3::new(-0.1, -0.1, 0.0)] {
        let beside = made(origin, [DVec3::X * 0.2, DVec3::Y * 0.2], [40, 30]);
        assert!(beside.inside == 0 && beside.values[0].iter().all(|shown| shown.is_nan()));
    }
}

#[test]
fn a_section_needs_pixels_in_a_plane() {
    let solution = cube(2);
    let frame = Frame { origin: DVec3::ZERO, sides: [DVec3::X, DVec3::Y], size: [8, 8] };
    for wrong in [
        Frame { size: [0, 8], ..frame },
        Frame { size: [1 << 12, 1 << 12], ..frame },
        Frame { sides: [DVec3::X, DVec3::X], ..frame },
        Frame { origin: DVec3::NAN, ..frame },
    ] {
        assert!(SectionJob::new(&solution, wrong).is_err());
    }
    let ring = solved(samples::annulus(0.4, 1.0, 12), |panel| Ok(panel.centre.x));
    assert!(SectionJob::new(&ring, Frame { sides: [DVec3::X, DVec3::Z], ..frame }).is_err());
    let whole = Frame::of_plane(&ring, 64);
    assert_eq!(whole.size, [64, 64]);
}

#[test]
fn bodies_of_any_size_have_sections() {
    for size in [1e-60, 1e90] {
        let mesh = samples::cube(1);
        let vertices = mesh.vertices().iter().map(|v| *v * size).collect();
        let mesh = Mesh::solid(vertices, mesh.elements().to_vec()).unwrap();
        let solution = solved(mesh, |panel| Ok(panel.centre.x / size));
        let frame = |sides: [DVec3; 2]| Frame { origin: DVec3::Z * (0.5 * size), sides, size: [8, 8] };
        let section = SectionJob::new(&solution, frame([DVec3::X * size, DVec3::Y * size])).unwrap().run();
        assert_eq!(section.inside, 64);
        let flat = SectionJob::new(&solution, frame([DVec3::X * size, DVec3::X * (2.0 * size)]));
        assert!(flat.is_err_and(|error| error.fault == Fault::Sides));
    }
}

/// Elements of a tiny hole are so near to each other that single precision does not tell them apart from where the outer boundary is.
#[test]
fn holes_may_be_a_hundred_millionth_of_the_body() {
    let (count, q, c) = (160, 1e-8, 0.3);
    let angle = |k: u32| std::f64::consts::TAU * f64::from(k) / f64::from(count);
    let outer = (0..count).map(|k| DVec2::from_angle(angle(k)));
    let hole = (0..count).map(|k| DVec2::new(c, 0.0) + q * DVec2::from_angle(-angle(k)));
    let points: Vec<DVec2> = outer.chain(hole).collect();
    let ring = |start: u32| (0..count).map(move |k| [start + k, start + (k + 1) % count]);
    let mesh = Mesh::plane(&points, &ring(0).chain(ring(count)).collect::<Vec<_>>()).unwrap();
    let solution =
        solved(mesh, |panel| Ok(f64::from(u8::from(panel.centre.distance(DVec3::X * c) < 2.0 * q))));
    assert!(solution.row_closure() < 1e-3, "{}", solution.row_closure());
    // Green's function of the unit disc.
    let at = |x: f64| ((1.0 - c * x) / (x - c)).abs().ln();
    let exact = at(-0.3) / at(c + q);
    assert!((value(&solution, DVec3::X * -0.3) - exact).abs() < 1e-4, "not {exact}");
}
