use super::*;
use crate::curve::{BSpline, Form};
use crate::material::Composition;
use glam::{DVec2, dvec2};
use std::f64::consts::TAU;

/// A closed curve through the control points of a circle: one to a few parts in a hundred thousand.
fn circle(centre: DVec2, radius: f64) -> BSpline {
    let count = 64;
    let angle = TAU / f64::from(count);
    // A uniform cubic with control points at this radius has its knots on the circle.
    let control = radius * 3.0 / (2.0 + angle.cos());
    let points = (0..count).map(|k| centre + control * DVec2::from_angle(angle * f64::from(k)));
    BSpline::new(3, Form::Periodic, points.collect(), None).expect("a curve")
}

fn pure(outer: usize) -> impl Fn(usize, f64) -> Composition {
    move |curve, _| Composition::pure(usize::from(curve == outer), 2)
}

const FINE: Fineness = Fineness { segments: 200, lines: 44, stages: 5, tolerance: 1e-3 };

/// Enough for what holds at any fineness.
const ROUGH: Fineness = Fineness { segments: 80, lines: 24, stages: 3, tolerance: 3e-3 };

fn blend(curves: Vec<BSpline>, outer: usize, compose: &Compose<'_>) -> HarmonicBlend {
    made(curves, outer, compose, FINE)
}

fn made(curves: Vec<BSpline>, outer: usize, compose: &Compose<'_>, fineness: Fineness) -> HarmonicBlend {
    let rings = curves.iter().map(|curve| Ring::new(curve, fineness.segments)).collect();
    let rings = Rings::new(rings, outer);
    HarmonicWork::new(curves, rings, compose, fineness).expect("a boundary").run().expect("a solution")
}

#[test]
fn between_concentric_circles_the_potential_is_a_logarithm() {
    let curves = vec![circle(DVec2::ZERO, 1.0), circle(DVec2::ZERO, 3.0)];
    let found = blend(curves, 1, &pure(1));
    assert!((found.flux() * 3.0_f64.ln() / TAU - 1.0).abs() < 1e-3, "{}", found.flux());
    for k in 0..50 {
        let radius = 1.05 + 1.9 * f64::from(k) / 50.0;
        let at = radius * DVec2::from_angle(f64::from(k));
        let place = found.locate(at).expect("inside");
        let exact = radius.ln() / 3.0_f64.ln();
        assert!((place.potential - exact).abs() < 3e-4, "{} at {radius}, not {exact}", place.potential);
        let steep = 1.0 / (radius * 3.0_f64.ln());
        assert!((place.gradient - steep * at.normalize()).length() < 2e-3 * steep);
        assert!((place.composition.fractions()[1] - place.potential).abs() < 1e-12);
    }
    assert_eq!(found.levels().len(), 4);
    assert_eq!(found.levels()[1], found.level(0.4));
    for level in [0.2, 0.5, 0.8] {
        let loops = found.level(level);
        assert_eq!(loops.len(), 1);
        let radius = 3.0_f64.powf(level);
        assert!(loops[0].iter().all(|point| (point.length() / radius - 1.0).abs() < 5e-4));
    }
    assert_eq!((found.lines().len(), found.crossings(), found.lost()), (44, 0, 0));
    for line in found.lines() {
        let first = line.points[0].normalize();
        assert!(line.points.iter().all(|point| point.normalize().distance(first) < 2e-3));
    }
    let gaps = found
        .lines()
        .windows(2)
        .map(|pair| pair[0].points[0].normalize().dot(pair[1].points[0].normalize()).acos() * 44.0 / TAU);
    assert!(gaps.into_iter().all(|gap| (gap - 1.0).abs() < 0.02));
    // The integral of ln r / ln 3 over the ring, and what is left of its area.
    let log = 3.0_f64.ln();
    let [area, second] = [TAU * 4.0, TAU / log * (4.5 * log - 2.0)];
    assert!((found.area() / area - 1.0).abs() < 1e-4);
    for (amount, exact) in found.amounts().iter().zip([area - second, second]) {
        assert!((amount / exact - 1.0).abs() < 1e-3, "{amount}, not {exact}");
    }
    assert!(found.locate(DVec2::ZERO).is_none() && found.locate(dvec2(3.1, 0.0)).is_none());
}

/// Between eccentric circles the potential is a logarithm of the ratio of the distances from two points, each the image of the other in both circles
/// (bipolar coordinates).
#[test]
fn between_eccentric_circles_the_potential_is_that_of_two_poles() {
    let (c, r, big) = (0.7, 0.8, 2.0_f64);
    let found = blend(vec![circle(dvec2(c, 0.0), r), circle(DVec2::ZERO, big)], 1, &pure(1));
    let sum = (big * big + c * c - r * r) / c;
    let root = (sum * sum / 4.0 - big * big).sqrt();
    let [a, b] = [sum / 2.0 - root, sum / 2.0 + root];
    let ratio = |z: DVec2| (z.distance(dvec2(a, 0.0)) / z.distance(dvec2(b, 0.0))).ln();
    let (inner, outer) = (ratio(dvec2(c + r, 0.0)), ratio(dvec2(big, 0.0)));
    let exact = |z: DVec2| (ratio(z) - inner) / (outer - inner);
    assert!((found.flux() * (outer - inner) / TAU - 1.0).abs() < 1e-3);
    let mut worst: f64 = 0.0;
    for k in 0..400 {
        let z = 1.97
            * dvec2((f64::from(k) * 0.618).fract() * 2.0 - 1.0, (f64::from(k) * 0.414).fract() * 2.0 - 1.0);
        if let Some(place) = found.locate(z) {
            worst = worst.max((place.potential - exact(z)).abs());
        }
    }
    assert!(worst < 1e-3, "{worst}");
    // A line keeps to its circle through both poles: the angle under which they are seen is the same all along.
    let angle = |z: DVec2| (dvec2(a, 0.0) - z).angle_to(dvec2(b, 0.0) - z);
    for line in found.lines() {
        let along: Vec<f64> = line.points.iter().map(|point| angle(*point)).collect();
        assert!(along.iter().all(|own| (own - along[0]).sin().abs() < 1e-2), "{along:?}");
    }
    assert_eq!((found.crossings(), found.lost()), (0, 0));
    for point in found.level(0.4).concat() {
        assert!((exact(point) - 0.4).abs() < 1e-3);
    }
}

/// Three discs, one turned into the next by a third of a circle: so is the field.
#[test]
fn a_symmetric_arrangement_has_a_symmetric_field() {
    let turn = |k: usize| DVec2::from_angle(TAU * k as f64 / 3.0);
    let mut curves: Vec<BSpline> = (0..3).map(|k| circle(1.4 * turn(k), 0.6)).collect();
    curves.push(circle(DVec2::ZERO, 3.0));
    let compose = |curve: usize, _: f64| Composition::pure(curve, 4);
    let found = blend(curves, 3, &compose);
    assert_eq!((found.lines().len(), found.crossings(), found.lost()), (44, 0, 0));
    for k in 0..40 {
        let at = 2.9 * (f64::from(k) * 0.618).fract().sqrt() * DVec2::from_angle(2.4 * f64::from(k));
        let places: Vec<Option<HarmonicPlace>> = (0..3).map(|k| found.locate(turn(k).rotate(at))).collect();
        let [Some(one), Some(two), Some(three)] = &places[..] else { continue };
        for (k, other) in [(1, two), (2, three)] {
            assert!((one.potential - other.potential).abs() < 2e-4, "{one:?} {other:?}");
            assert!((turn(k).rotate(one.gradient) - other.gradient).length() < 1e-3);
            let (own, turned) = (one.composition.fractions(), other.composition.fractions());
            assert!((0..3).all(|m| (own[m] - turned[(m + k) % 3]).abs() < 5e-4));
        }
    }
    // The middle is the only saddle: no heat flows there. Below its level there is a loop round each disc, above it one round all.
    let middle = found.locate(DVec2::ZERO).expect("inside");
    assert!(middle.gradient.length() < 1e-3);
    assert_eq!(
        (found.level(0.8 * middle.potential).len(), found.level(1.2 * middle.potential).len()),
        (3, 1)
    );
}

/// A small generator of whole numbers (splitmix64), whose seed a failure names.
fn numbers(mut state: u64) -> impl FnMut() -> f64 {
    move || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) as f64 / 2.0_f64.powi(64)
    }
}

/// A star-shaped curve whose control points are between 0.7 and 1 of a radius from its centre.
fn star(number: &mut dyn FnMut() -> f64, centre: DVec2, radius: f64) -> BSpline {
    let count = 9;
    let point = |k: u32| {
        let angle = TAU * (f64::from(k) + 0.4 * number()) / f64::from(count);
        centre + radius * (0.7 + 0.3 * number()) * DVec2::from_angle(angle)
    };
    BSpline::new(3, Form::Periodic, (0..count).map(point).collect(), None).expect("a curve")
}

/// Whatever the shapes: fractions sum to 1 and keep within those of the curves, lines do not cross, heat is kept, and the triangles show the solution to
/// the stated tolerance.
#[test]
fn random_nested_curves_keep_what_is_promised() {
    for seed in 0..4_u64 {
        let mut number = numbers(seed);
        let count = 1 + (number() * 4.0) as usize;
        let radius = 0.25 + 0.5 / count as f64;
        let mut curves: Vec<BSpline> = (0..count)
            .map(|k| {
                let far = if count == 1 { 0.4 * number() } else { 1.3 };
                star(&mut number, far * DVec2::from_angle(TAU * k as f64 / count as f64), radius)
            })
            .collect();
        curves.push(star(&mut number, DVec2::ZERO, 3.2));
        let compose = |curve: usize, u: f64| {
            let share = 0.5 + 0.5 * (TAU * (u + 0.1 * curve as f64)).sin();
            let own = if curve == count {
                [0.0, 1.0 - share, share]
            } else {
                [1.0 - 0.3 * share, 0.3 * share, 0.0]
            };
            Composition::new(own.to_vec()).expect("a composition")
        };
        let found = made(curves, count, &compose, ROUGH);
        let balance = found.solution().flux_balance()[0].abs();
        assert!(balance < 1e-2, "seed {seed}: {balance}");
        assert_eq!((found.lines().len(), found.lost()), (24, 0), "seed {seed}");
        let lines: Vec<&Vec<DVec2>> = found.lines().iter().map(|line| &line.points).collect();
        for (i, one) in lines.iter().enumerate() {
            for other in &lines[..i] {
                let meets = one
                    .windows(2)
                    .any(|a| other.windows(2).any(|b| crate::geom::segments_meet(a[0], a[1], b[0], b[1])));
                assert!(!meets, "seed {seed}: lines {i} and another meet");
            }
        }
        assert_eq!(found.crossings(), 0, "seed {seed}");
        let field = found.field();
        let mut worst: f64 = 0.0;
        for corners in field.triangles.iter().step_by(7) {
            let middle = corners.iter().map(|k| field.points[*k as usize]).sum::<DVec2>() / 3.0;
            let Some(place) = found.locate(middle) else { continue };
            let fractions = place.composition.fractions();
            assert!((fractions.iter().sum::<f64>() - 1.0).abs() < 1e-12, "seed {seed}");
            assert!(fractions.iter().all(|own| (0.0..=1.0).contains(own)), "seed {seed}: {fractions:?}");
            for (quantity, exact) in std::iter::once(&place.potential).chain(fractions).enumerate() {
                let shown = corners.iter().map(|k| field.value(*k, quantity)).sum::<f64>() / 3.0;
                worst = worst.max((shown - exact).abs());
            }
        }
        assert!(worst < 1.5 * ROUGH.tolerance, "seed {seed}: {worst}");
        for level in [0.2, 0.6] {
            for point in found.level(level).concat() {
                let place = found.locate(point).expect("inside");
                assert!((place.potential - level).abs() < 1e-5, "seed {seed}: {}", place.potential);
            }
        }
    }
}

/// A hole that is small beside everything else has triangles of its own size round it.
#[test]
fn a_tiny_hole_is_shown_as_well_as_a_large_one() {
    let (r, big) = (2e-3, 3.0_f64);
    let found = made(vec![circle(DVec2::ZERO, r), circle(DVec2::ZERO, big)], 1, &pure(1), ROUGH);
    let field = found.field();
    for corners in &field.triangles {
        let middle = corners.iter().map(|k| field.points[*k as usize]).sum::<DVec2>() / 3.0;
        let exact = ((middle.length() / r).ln() / (big / r).ln()).max(0.0);
        let shown = corners.iter().map(|k| field.value(*k, 0)).sum::<f64>() / 3.0;
        assert!((shown - exact).abs() < 1.5 * ROUGH.tolerance, "{shown}, not {exact} at {middle}");
    }
    assert_eq!((found.crossings(), found.lost()), (0, 0));
}

/// Where few segments turn into the band their normals meet before lines have left them.
#[test]
fn lines_that_lie_close_do_not_cross_where_segments_turn() {
    let wave = |k: i32| {
        (3.0 + 1.2 * (f64::from(k) * TAU / 4.0).cos()) * DVec2::from_angle(f64::from(k) * TAU / 12.0)
    };
    let inner = BSpline::new(3, Form::Periodic, (0..12).map(wave).collect(), None).expect("a curve");
    let fineness = Fineness { segments: 24, lines: 300, stages: 2, tolerance: 1e-2 };
    let found = made(vec![inner, circle(DVec2::ZERO, 9.0)], 1, &pure(1), fineness);
    assert_eq!((found.lines().len(), found.crossings(), found.lost()), (300, 0, 0));
}

#[test]
fn lines_from_a_tiny_curve_do_not_cross() {
    let curves = vec![circle(dvec2(0.3, 0.0), 1e-8), circle(DVec2::ZERO, 1.0)];
    let found = made(curves, 1, &pure(1), Fineness { segments: 80, lines: 44, stages: 1, tolerance: 1e-2 });
    assert_eq!((found.lines().len(), found.crossings(), found.lost()), (44, 0, 0));
}
