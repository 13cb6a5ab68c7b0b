//! Unit cells and amounts of materials: closed forms on rings and strips, shoelaces, other quadratures, and rates of convergence.

use crate::support::seeded;
use directrix::curve::{BSpline, Form};
use directrix::document::{BandAmounts, Solution, Solve, amounts as amounts_of, read_text};
use directrix::geom::signed_area;
use directrix::material::{Composition, Profile};
use directrix::morph::{Amounts, Band, amounts, cell_amounts, unit_cells};
use glam::{DVec2, dvec2};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::f64::consts::{PI, TAU};
use std::fs;

/// Control points of the circle below.
const ROUND: usize = 256;

/// A circle about `center`, as a cubic spline that keeps to it within a billionth of the radius; its parameter is the angle in laps as exactly.
fn circle(radius: f64, center: DVec2) -> BSpline {
    let step = TAU / ROUND as f64;
    // With it the knots lie on the circle.
    let outside = radius * 3.0 / (2.0 + step.cos());
    let points = |turn: f64| {
        (0..ROUND).map(|k| center + outside * DVec2::from_angle(step * k as f64 + turn)).collect::<Vec<_>>()
    };
    let curve = |turn: f64| BSpline::new(3, Form::Periodic, points(turn), None).expect("a circle");
    let start = (curve(0.0).point(0.0) - center).to_angle();
    curve(-start)
}

fn pure(curve: usize, _: f64) -> Composition {
    Composition::pure(curve, 2)
}

/// As many lines at equal angles.
fn radial(lines: usize) -> Vec<(f64, f64)> {
    (0..lines).map(|k| (k as f64 / lines as f64, k as f64 / lines as f64)).collect()
}

#[track_caller]
fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found:.15} for {expected:.15}, within {tolerance:e}");
}

/// Area and amounts of a blend along the radius: the second material has the fraction (r - r1) / (r2 - r1).
fn ring(near: f64, far: f64) -> Amounts {
    let area = PI * (far * far - near * near);
    let second =
        TAU / (far - near) * ((far.powi(3) - near.powi(3)) / 3.0 - near * (far * far - near * near) / 2.0);
    Amounts { area, materials: vec![area - second, second] }
}

#[test]
fn amounts_of_a_ring_are_those_of_the_closed_form() {
    for (near, far) in [(1.0, 2.0), (3.0, 3.5), (0.1, 40.0)] {
        let curves = [circle(near, DVec2::ZERO), circle(far, DVec2::ZERO)];
        let expected = ring(near, far);
        // The spline is off the circle by less than a billionth.
        let tolerance = 1e-8 * far * far;
        for lines in [3, 17] {
            let (found, error) = amounts(&curves, &radial(lines), [&[], &[]], pure);
            assert!(found.difference(&expected) < tolerance, "{found:?} for {expected:?}");
            assert!(error < 1e-13 * far * far, "{error}");
            // The first curve may be the outer one.
            let swapped = [curves[1].clone(), curves[0].clone()];
            let (other, _) = amounts(&swapped, &radial(lines), [&[], &[]], pure);
            assert_near(other.area, found.area, 1e-13 * far * far);
            assert_near(other.materials[0], found.materials[1], 1e-13 * far * far);
        }
        // Cells are trapezia: both sides are chords of the same angle.
        let lines = 40;
        let (cells, folded) = cell_amounts(&Band::new(&curves, &radial(lines), pure, 1));
        let flat = (TAU / lines as f64).sin() * lines as f64 / TAU;
        assert_near(cells.area, flat * expected.area, tolerance);
        assert_near(cells.materials[1], flat * expected.materials[1], tolerance);
        assert_eq!(folded, 0);
    }
}

/// Scaled copies of any curve have the same closed form, up to rounding: with the factor k, areas are those of the curve times k² - 1
/// and (k - 1)(2k + 1) / 3.
#[test]
fn amounts_between_scaled_curves_are_exact() {
    let shape = [(3.0, 0.2), (1.5, 2.0), (-1.0, 2.5), (-2.5, 0.5), (-1.2, -2.0), (1.9, -1.7)];
    for (degree, tolerance) in [(2, 1e-14), (3, 1e-14), (5, 1e-14)] {
        let curve = |factor: f64, at: DVec2| {
            let points = shape.iter().map(|&point| DVec2::from(point) * factor + at).collect();
            BSpline::new(degree, Form::Periodic, points, None).expect("a closed curve")
        };
        for k in [1.25, 2.0, 9.0] {
            let at = dvec2(40.0, -70.0);
            let curves = [curve(1.0, at), curve(k, at)];
            let area = curve(1.0, DVec2::ZERO).signed_area();
            let second = area * (k - 1.0) * (2.0 * k + 1.0) / 3.0;
            let (found, error) = amounts(&curves, &radial(7), [&[], &[]], pure);
            let scale = k * k * area * 10.0;
            assert_near(found.area, area * (k * k - 1.0), tolerance * scale);
            assert_near(found.materials[1], second, tolerance * scale);
            assert!(error < 1e-14 * scale);
        }
    }
}

/// Where the wave below starts, in laps: at no knot and at no line.
const START: f64 = 0.003;

/// A composition that goes evenly from the first material to the second half a lap on, and back: with θ counted from the start,
/// 1/2 + 4/π² (cos θ + cos 3θ / 9 + …).
fn wave() -> (Profile, [f64; 2]) {
    let keys = [START, START + 0.5];
    let profile =
        Profile::new(vec![(keys[0], Composition::pure(0, 2)), (keys[1], Composition::pure(1, 2))], true);
    (profile.expect("two keys"), keys)
}

/// Between circles whose centres are apart by c, the Jacobian has a cosine, which meets that of the composition.
#[test]
fn heterogeneous_circles_off_centre_have_the_fourier_integral() {
    let (near, far, off) = (1.0, 3.0, 0.75);
    let curves = [circle(near, DVec2::ZERO), circle(far, off * DVec2::from_angle(TAU * START))];
    let (profile, keys) = wave();
    let compose = |curve: usize, u: f64| if curve == 0 { profile.at(u) } else { Composition::pure(1, 2) };
    // The Jacobian at either end is r (c cos θ + r2 - r1). The wave has the mean 1/2 and, with the cosine, the integral 4/π.
    let part = |radius: f64| radius * (off * 4.0 / PI + (far - near) * PI);
    let expected = part(near) / 3.0 + part(far) / 6.0;
    for lines in [5, 12] {
        let (found, error) = amounts(&curves, &radial(lines), [&keys, &[]], compose);
        assert_near(found.area, PI * (far * far - near * near), 1e-7);
        assert_near(found.materials[0], expected, 1e-7);
        assert!(error < 1e-13, "{error}");
        // Kinks inside a part cost accuracy, and the estimate says so.
        let (rough, doubt) = amounts(&curves, &radial(lines), [&[], &[]], compose);
        let off = rough.difference(&found);
        assert!(off > 1e-9 && off < 10.0 * doubt && doubt < 1e-4, "{off:e} and {doubt:e}");
    }
}

#[test]
fn cells_come_near_to_the_integral_with_the_square_of_the_lines() {
    let curves = [circle(1.0, DVec2::ZERO), circle(3.0, dvec2(0.75, -0.4))];
    let (profile, keys) = wave();
    let compose = |curve: usize, u: f64| if curve == 0 { profile.at(u) } else { Composition::pure(1, 2) };
    let (exact, _) = amounts(&curves, &radial(8), [&keys, &[]], compose);
    let missing = |lines: usize| {
        let (cells, _) = cell_amounts(&Band::new(&curves, &radial(lines), compose, 1));
        [
            exact.area - cells.area,
            exact.materials[0] - cells.materials[0],
            exact.materials[1] - cells.materials[1],
        ]
    };
    for lines in [16, 32, 64] {
        let (coarse, fine) = (missing(lines), missing(2 * lines));
        // The kinks of the composition lie between lines, now nearer to one and now to the other.
        for ((a, b), tolerance) in coarse.into_iter().zip(fine).zip([0.05, 0.2, 0.2]) {
            assert!(a > 0.0 && (a / b - 4.0).abs() < tolerance, "{lines} lines: {a} and {b}");
        }
    }
}

/// A trapezium: straight edges leave nothing between curve and chord.
#[test]
fn a_strip_between_straight_lines_is_exact_in_cells_too() {
    let straight = |from: DVec2, to: DVec2| {
        let points = (0..5).map(|k| from.lerp(to, f64::from(k) / 4.0)).collect();
        BSpline::new(3, Form::Open, points, None).expect("an open curve")
    };
    let curves = [straight(DVec2::ZERO, dvec2(4.0, 0.0)), straight(dvec2(1.0, 2.0), dvec2(3.0, 2.0))];
    let places: Vec<_> = (0..=4).map(|k| (f64::from(k) / 4.0, f64::from(k) / 4.0)).collect();
    let expected = Amounts { area: 6.0, materials: vec![10.0 / 3.0, 8.0 / 3.0] };
    let (found, error) = amounts(&curves, &places, [&[], &[]], pure);
    assert!(found.difference(&expected) < 1e-14 && error < 1e-14, "{found:?}");
    let band = Band::new(&curves, &places, pure, 1);
    let (cells, folded) = cell_amounts(&band);
    assert!(cells.difference(&expected) < 1e-14 && folded == 0, "{cells:?}");
    let cells = unit_cells(&band, 3);
    assert_eq!(cells.len(), 12, "no gap from the end to the start");
    assert_near(cells.iter().map(|cell| cell.area).sum(), 6.0, 1e-14);
}

/// Two lines with pure or mixed ends, and stages: random patches. Means are compared with the two by two points of Gauss, with which a
/// patch and its Jacobian are integrated exactly, and with the shoelace.
#[test]
fn means_of_a_cell_are_those_over_its_area() {
    let number = || -1.0..1.0_f64;
    let patch = (prop::array::uniform8(number()), prop::array::uniform4(0.0..1.0_f64), 1..4_usize);
    seeded(400, &patch, |(shift, mixes, stages)| {
        // A square whose corners wander by up to a third of it, which keeps it convex.
        let wander = |k: usize| dvec2(shift[2 * k], shift[2 * k + 1]) * 0.33;
        let corners = [DVec2::ZERO, DVec2::Y, DVec2::ONE, DVec2::X];
        let corners = [0, 1, 2, 3].map(|k| corners[k] * 2.0 - 1.0 + wander(k));
        let line = |from: DVec2, to: DVec2| {
            let points = (0..4).map(|k| from.lerp(to, f64::from(k) / 3.0)).collect();
            BSpline::new(3, Form::Open, points, None).expect("a line")
        };
        let curves = [line(corners[0], corners[3]), line(corners[1], corners[2])];
        let fraction = |curve: usize, u: f64| mixes[curve] * (1.0 - u) + mixes[curve + 2] * u;
        let compose = |curve: usize, u: f64| {
            let first = fraction(curve, u);
            Composition::new(vec![first, 1.0 - first]).expect("a mix")
        };
        let band = Band::new(&curves, &[(0.0, 0.0), (1.0, 1.0)], compose, 1);
        let root = 1.0 / 3.0_f64.sqrt();
        for cell in unit_cells(&band, stages) {
            let [a, b, c, d] = cell.corners;
            let (near, far) = (cell.stage as f64 / stages as f64, (cell.stage + 1) as f64 / stages as f64);
            let (mut area, mut moment, mut amount) = (0.0, DVec2::ZERO, 0.0);
            for (x, y) in [(-root, -root), (-root, root), (root, -root), (root, root)] {
                let (s, t) = (f64::midpoint(1.0, x), f64::midpoint(1.0, y));
                let across = (b - a).lerp(c - d, t);
                let along = (d - a).lerp(c - b, s);
                let weight = across.perp_dot(along).abs() / 4.0;
                let share = near + s * (far - near);
                area += weight;
                moment += weight * a.lerp(b, s).lerp(d.lerp(c, s), t);
                amount += weight * (fraction(0, t) * (1.0 - share) + fraction(1, t) * share);
            }
            prop_assert!(!cell.is_folded);
            prop_assert!(
                (cell.area - area).abs() < 1e-14 && (signed_area(&cell.corners).abs() - area).abs() < 1e-14
            );
            prop_assert!(cell.centroid.distance(moment / area) < 1e-13);
            prop_assert!((cell.composition.fractions()[0] - amount / area).abs() < 1e-13);
        }
        Ok(())
    });
}

/// Between circles turned against each other by an angle, the band is turned over where (1 - s) r1 (r2 cos δ - r1) + s r2 (r2 - r1 cos δ) is
/// negative: the inner part, for a wide angle.
#[test]
fn cells_that_are_turned_over_are_told() {
    let curves = [circle(1.0, DVec2::ZERO), circle(2.0, DVec2::ZERO)];
    let (lines, stages) = (180, 20);
    for (angle, folds) in [(0.9, false), (1.3, true)] {
        let places: Vec<_> = radial(lines).into_iter().map(|(u, v)| (u, v + angle / TAU)).collect();
        let band = Band::new(&curves, &places, pure, 1);
        let (near, far) = (2.0 * f64::cos(angle) - 1.0, 2.0 * (2.0 - f64::cos(angle)));
        let cells = unit_cells(&band, stages);
        for cell in &cells {
            let at = |stage: usize| stage as f64 / stages as f64;
            let jacobian = |s: f64| (1.0 - s) * near + s * far;
            let (inner, outer) = (jacobian(at(cell.stage)), jacobian(at(cell.stage + 1)));
            // Chords move the limit a little.
            if inner.abs() > 0.05 {
                assert_eq!(cell.is_folded, inner < 0.0, "{angle} {} {inner}", cell.stage);
            }
            if outer < -0.05 {
                assert!(cell.area < 0.0, "wholly turned over");
            }
            assert!(cell.composition.fractions().iter().all(|f| (0.0..=1.0).contains(f)));
        }
        assert_eq!(cells.iter().any(|cell| cell.is_folded), folds);
        let (sums, folded) = cell_amounts(&band);
        assert_eq!(folded, if folds { lines } else { 0 });
        // What is turned over is taken off again: the area stays that between the curves.
        let flat = (TAU / lines as f64).sin() * lines as f64 / TAU;
        assert_near(sums.area, flat * 3.0 * PI, 1e-7);
        assert_near(cells.iter().map(|cell| cell.area).sum(), sums.area, 1e-12);
        assert_near(amounts(&curves, &places, [&[], &[]], pure).0.area, 3.0 * PI, 1e-7);
    }
}

/// Above degree 7 the rule is not exact any more, and the estimate covers what it misses.
#[test]
fn the_error_of_a_high_degree_is_estimated() {
    let points = |radius: f64| {
        (0..24)
            .map(|k| radius * f64::from(1 + k % 3) * DVec2::from_angle(TAU * f64::from(k) / 24.0))
            .collect()
    };
    for degree in [7, 12, 20] {
        let curve =
            |radius: f64| BSpline::new(degree, Form::Periodic, points(radius), None).expect("a curve");
        let curves = [curve(1.0), curve(1.7)];
        let (found, error) = amounts(&curves, &radial(3), [&[], &[]], pure);
        let (fine, _) = amounts(&curves, &radial(96), [&[], &[]], pure);
        let off = found.difference(&fine);
        assert!(off <= error.max(1e-13) && error < 1e-9, "{degree}: {off:e} and {error:e}");
    }
}

fn solve(document: &Value) -> Solution {
    Solve::run(read_text(&document.to_string()).expect("fields in range")).expect("curves")
}

fn presets() -> Vec<Value> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("www/presets");
    let read = |name: &str| -> Value {
        let text = fs::read_to_string(folder.join(format!("{name}.json"))).expect("a file");
        serde_json::from_str(&text).expect("JSON")
    };
    let ids = read("index");
    ids.as_array().expect("a list").iter().map(|entry| read(entry["id"].as_str().expect("an id"))).collect()
}

#[test]
fn amounts_of_every_preset_add_up_and_are_the_limit_of_cells() {
    let mut seen = 0;
    for document in presets() {
        let solution = solve(&document);
        let (Some(((curves, _), band)), found) =
            (solution.model.pair().zip(solution.band()), amounts_of(&solution))
        else {
            assert_eq!(amounts_of(&solution), None, "no band, no amounts");
            continue;
        };
        let BandAmounts { exact, error, in_cells, folded } = found.expect("amounts of the band");
        let title = &document["title"];
        seen += 1;
        assert_near(exact.materials.iter().sum(), exact.area, 1e-12 * exact.area);
        assert!(
            error < 1e-11 * exact.area && exact.materials.iter().all(|&amount| amount > -1e-12 * exact.area),
            "{title}"
        );
        if curves[0].is_closed() {
            let between = (curves[0].signed_area() - curves[1].signed_area()).abs();
            assert_near(exact.area, between, 1e-12 * curves[0].signed_area().max(curves[1].signed_area()));
        }
        let off = in_cells.difference(&exact);
        assert!(off < 0.03 * exact.area, "{title}: {off} of {}", exact.area);
        let cells = unit_cells(band, solution.model.document().segments());
        assert_near(cells.iter().map(|cell| cell.area).sum(), in_cells.area, 1e-11 * exact.area);
        if folded == 0 {
            for (material, &amount) in in_cells.materials.iter().enumerate() {
                let sum = cells.iter().map(|cell| cell.area * cell.composition.fractions()[material]).sum();
                assert_near(sum, amount, 1e-11 * exact.area);
            }
        }
        // With as many rulings again and again between the lines, cells come near with the square of their number.
        let refined = |per_line: usize| {
            let fine = solution.band_with(per_line).expect("a band");
            let places: Vec<_> = fine.rulings().iter().map(|ruling| (ruling.u, ruling.v)).collect();
            let compose = |curve: usize, u: f64| solution.model.composition(curve, u);
            cell_amounts(&Band::new(curves, &places, compose, 1)).0.difference(&exact)
        };
        let (coarse, fine) = (refined(4), refined(32));
        assert!(
            fine < coarse / 25.0 + 1e-9 * exact.area && coarse < off / 5.0 + 1e-9 * exact.area,
            "{title}: {off} {coarse} {fine}"
        );
    }
    assert!(seen > 15);
}

/// The amounts are in the plane: heights do not change them.
#[test]
fn curves_at_heights_have_the_amounts_of_their_projection() {
    let document = |height: f64, composition: Value| {
        let ring = |radius: f64| {
            let at = |k: u32| (radius * DVec2::from_angle(TAU * f64::from(k) / 12.0)).to_array();
            (0..12).map(at).collect::<Vec<_>>()
        };
        json!({
            "directrix": 1, "kind": "curves", "matching": {"method": "exact", "lines": 24},
            "materials": [{"name": "steel", "color": "#0072b2"}, {"name": "air", "color": "#ffffff", "void": true}],
            "curves": [
                {"degree": 3, "form": "periodic", "points": ring(10.0), "composition": [{"at": 0, "mix": [1, 0]}]},
                {"degree": 3, "form": "periodic", "points": ring(20.0), "height": height, "composition": composition},
            ],
        })
    };
    let mix = json!([{"at": 0, "mix": [0, 1]}]);
    let flat = amounts_of(&solve(&document(0.0, mix.clone()))).expect("amounts");
    let raised = amounts_of(&solve(&document(30.0, mix))).expect("amounts");
    assert!(flat.exact.difference(&raised.exact) < 1e-9 * flat.exact.area);
    // Radial lines between scaled curves: 4/9 of the first material, 5/9 of the second.
    assert_near(flat.exact.materials[0] / flat.exact.area, 4.0 / 9.0, 1e-6);
    // Along a curve that is run through backwards, the keys are found at their places.
    let keys =
        json!([{"at": 0.1, "mix": [0, 1]}, {"at": 0.3, "mix": [1, 0]}, {"at": 0.4, "mix": [0.5, 0.5]}]);
    let forward = document(0.0, keys.clone());
    let mut backward = forward.clone();
    let points = backward["curves"][1]["points"].as_array_mut().expect("points");
    points.reverse();
    let keyed: Vec<Value> = keys.as_array().expect("keys").iter().rev().cloned().collect();
    backward["curves"][1]["composition"] = keyed
        .iter()
        .map(|key| json!({"at": 1.0 - key["at"].as_f64().expect("a number"), "mix": key["mix"]}))
        .collect();
    let (forward, backward) = (amounts_of(&solve(&forward)), amounts_of(&solve(&backward)));
    let (forward, backward) = (forward.expect("amounts"), backward.expect("amounts"));
    assert!(forward.error < 1e-12 * forward.exact.area, "{}", forward.error);
    assert!(backward.error < 1e-12 * backward.exact.area, "{}", backward.error);
    assert!(
        forward.exact.difference(&backward.exact) < 1e-9 * forward.exact.area,
        "{forward:?} {backward:?}"
    );
}
