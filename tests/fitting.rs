//! Fitting: known shapes, counts of control points and rates, corners, ends of strokes, and random input. Every error that is
//! reported is compared with distances found by brute force.

use crate::support::seeded;
use directrix::curve::{BSpline, CornerRule, EndRule, Fit, FitError, FitOptions, Form, MOST_FIT_POINTS, fit};
use glam::{DVec2, dvec2};
use proptest::prelude::*;
use std::f64::consts::TAU;

fn options(tolerance: f64) -> FitOptions {
    FitOptions {
        tolerance,
        corners: CornerRule::Keep,
        through: false,
        corner_indices: None,
        ends: EndRule::Join,
    }
}

fn smooth(tolerance: f64) -> FitOptions {
    FitOptions { corners: CornerRule::Smooth, ..options(tolerance) }
}

fn through() -> FitOptions {
    FitOptions { through: true, ..smooth(1e-3) }
}

fn closed(count: usize, point: impl Fn(f64) -> DVec2) -> Vec<DVec2> {
    (0..count).map(|k| point(k as f64 / count as f64)).collect()
}

fn circle(count: usize, radius: f64) -> Vec<DVec2> {
    closed(count, |t| radius * DVec2::from_angle(TAU * t))
}

fn star(count: usize) -> Vec<DVec2> {
    closed(2 * count, |t| {
        let k = (t * 2.0 * count as f64).round() as usize;
        DVec2::from_angle(TAU * t) * if k.is_multiple_of(2) { 10.0 } else { 5.0 }
    })
}

fn to_segment(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = b - a;
    let length_sq = along.length_squared();
    let t = if length_sq > 0.0 { ((p - a).dot(along) / length_sq).clamp(0.0, 1.0) } else { 0.0 };
    p.distance(a + along * t)
}

/// The largest distance of points of the one from the other, in both directions, by brute force.
fn gap(curve: &BSpline, polyline: &[DVec2]) -> f64 {
    let edges: Vec<_> =
        (0..polyline.len()).map(|i| (polyline[i], polyline[(i + 1) % polyline.len()])).collect();
    let dense: Vec<_> = curve.flatten(1e-5 * curve.bounds().diagonal()).into_iter().map(|(_, p)| p).collect();
    let forth =
        dense.iter().map(|&p| edges.iter().map(|&(a, b)| to_segment(p, a, b)).fold(f64::INFINITY, f64::min));
    let back =
        edges.iter().flat_map(|&(a, b)| [a, a.lerp(b, 0.5)]).map(|p| curve.nearest(p).distance_sq.sqrt());
    forth.chain(back).fold(0.0, f64::max)
}

/// Fits, and checks everything that holds for any input.
fn fitted(points: &[DVec2], options: &FitOptions) -> Fit {
    let result = fit(points, options).unwrap_or_else(|error| panic!("{error}"));
    let curve = &result.curve;
    assert_eq!((curve.degree(), curve.form(), curve.domain()), (3, Form::Periodic, (0.0, 1.0)));
    if result.trimmed == 0 {
        let size = curve.bounds().diagonal();
        let found = gap(curve, points);
        assert!(found <= result.error + 1e-12 * size, "error {} is understated: {found}", result.error);
        let away = curve.point(0.0).distance(points[0]);
        assert!(away <= result.error + 1e-12 * size, "starts {away} away from the first point");
    }
    if !options.through {
        assert!(result.error <= options.tolerance * (1.0 + 1e-9) || result.trimmed > 0);
    }
    assert_eq!(result.simple, curve.self_intersection().is_none());
    result
}

#[test]
fn a_circle_takes_control_points_like_the_fourth_root_of_the_tolerance() {
    let points = circle(20_000, 10.0);
    let count = |tolerance: f64| {
        let result = fitted(&points, &options(tolerance));
        assert!(result.corners.is_empty() && result.simple);
        // The error is that of the circle itself, whose polyline is 1e-7 away.
        let radii = (0..1000).map(|k| (result.curve.point(f64::from(k) / 1000.0).length() - 10.0).abs());
        let true_error = radii.fold(0.0, f64::max);
        assert!(true_error <= result.error + 2e-7, "{true_error} and {}", result.error);
        assert!(result.error <= 1.3 * true_error + 2e-6, "{true_error} and {}", result.error);
        result.curve.points().len()
    };
    let counts: Vec<_> = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5].map(count).to_vec();
    println!("control points of a circle: {counts:?}");
    assert!(counts[0] <= 6 && counts[4] <= 60, "{counts:?}");
    // Order four: a hundredth of the tolerance takes the root of ten as many, 3.16.
    let growth = counts[4] as f64 / counts[2] as f64;
    assert!((2.2..=3.6).contains(&growth), "{counts:?}");
}

#[test]
fn an_ellipse_keeps_its_area() {
    let points = closed(4000, |t| dvec2(30.0 * (TAU * t).cos(), 8.0 * (TAU * t).sin()));
    for (tolerance, most) in [(0.3, 10), (0.03, 16), (0.003, 28)] {
        let result = fitted(&points, &smooth(tolerance));
        let count = result.curve.points().len();
        println!("ellipse, tolerance {tolerance}: {count} control points, error {}", result.error);
        assert!(count <= most, "{count} control points for {tolerance}");
        let area = TAU / 2.0 * 240.0;
        assert!((result.curve.signed_area() - area).abs() < tolerance * 130.0);
    }
}

#[test]
fn the_shape_of_a_spline_is_recovered() {
    let control = closed(9, |t| DVec2::from_angle(TAU * t) * (10.0 + 4.0 * (2.0 * TAU * t).cos()));
    let original = BSpline::new(3, Form::Periodic, control, None).unwrap();
    let points: Vec<_> = original.flatten(1e-6).into_iter().map(|(_, p)| p).collect();
    let result = fitted(&points, &smooth(0.01));
    let count = result.curve.points().len();
    assert!(count <= 28, "{count} control points");
    for k in 0..500 {
        let p = original.point(f64::from(k) / 500.0);
        assert!(result.curve.nearest(p).distance_sq.sqrt() <= 0.01 + 1e-5);
    }
}

#[test]
fn a_square_keeps_its_corners_exactly_or_rounds_them() {
    let square = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)].map(DVec2::from).to_vec();
    let kept = fitted(&square, &options(0.1));
    assert_eq!((kept.corners.as_slice(), kept.curve.points().len()), ([0, 1, 2, 3].as_slice(), 12));
    assert!(kept.error < 1e-12, "{}", kept.error);
    let corners = kept.curve.corners();
    assert_eq!(corners.len(), 4, "{corners:?}");
    assert!(corners.iter().all(|corner| (corner.turn - 90.0).abs() < 1e-6));

    for tolerance in [1.0, 0.1, 0.01] {
        let rounded = fitted(&square, &smooth(tolerance));
        println!("rounded square, tolerance {tolerance}: {} control points", rounded.curve.points().len());
        assert!(rounded.curve.corners().is_empty() && rounded.simple && rounded.corners.is_empty());
        assert!(rounded.curve.points().len() <= 64);
    }
}

#[test]
fn a_start_between_corners_stays_the_start() {
    let mut points =
        vec![dvec2(5.0, 0.0), dvec2(10.0, 0.0), dvec2(10.0, 10.0), dvec2(0.0, 10.0), dvec2(0.0, 0.0)];
    let result = fitted(&points, &options(0.1));
    assert_eq!(result.corners, [1, 2, 3, 4]);
    assert!(result.curve.point(0.0).distance(points[0]) < 1e-9);
    assert_eq!(result.curve.corners().len(), 4);
    // Half a disc: two corners, one round side.
    points = (0..=100).map(|k| 10.0 * DVec2::from_angle(TAU / 2.0 * f64::from(k) / 100.0)).collect();
    points.rotate_left(30);
    let result = fitted(&points, &options(0.02));
    assert_eq!(result.corners.len(), 2);
    assert_eq!(result.curve.corners().len(), 2);
    assert!(result.curve.points().len() <= 16, "{}", result.curve.points().len());
}

#[test]
fn given_corners_are_taken_as_given() {
    let points = circle(200, 10.0);
    let one = FitOptions { corner_indices: Some(vec![50]), ..options(0.01) };
    let result = fitted(&points, &one);
    assert_eq!(result.corners, [50]);
    assert!(result.curve.nearest(points[50]).distance_sq.sqrt() < 1e-9);
    let outside = FitOptions { corner_indices: Some(vec![0, 200]), ..options(0.01) };
    assert_eq!(fit(&points, &outside), Err(FitError::CornerIndex { position: 1, index: 200, count: 200 }));
}

#[test]
fn a_star_keeps_ten_corners() {
    let result = fitted(&star(5), &options(0.05));
    assert_eq!((result.corners.len(), result.curve.points().len()), (10, 30));
    assert!(result.simple);
    let rounded = fitted(&star(5), &smooth(0.1));
    println!("rounded star: {} control points", rounded.curve.points().len());
    assert!(rounded.simple && rounded.curve.corners().is_empty());
}

#[test]
fn a_curve_through_points_meets_every_one() {
    for count in [3, 4, 5, 12, 300] {
        let points = closed(count, |t| DVec2::from_angle(TAU * t) * (10.0 + 2.0 * (3.0 * TAU * t).sin()));
        let result = fitted(&points, &through());
        assert_eq!(result.curve.points().len(), count.max(4));
        for &p in &points {
            let away = result.curve.nearest(p).distance_sq.sqrt();
            assert!(away < 1e-10, "{count} points: {away}");
        }
    }
    // Corners cut the curve; between them it is a line, a parabola or a cubic spline.
    let mut points =
        vec![dvec2(0.0, 0.0), dvec2(10.0, 0.0), dvec2(10.0, 10.0), dvec2(5.0, 12.0), dvec2(0.0, 10.0)];
    points.extend([dvec2(1.0, 8.0), dvec2(0.5, 6.0), dvec2(1.0, 4.0), dvec2(0.0, 2.0)]);
    let corners = FitOptions { through: true, corner_indices: Some(vec![0, 1, 2, 4]), ..options(1.0) };
    let result = fitted(&points, &corners);
    for &p in &points {
        assert!(result.curve.nearest(p).distance_sq.sqrt() < 1e-10);
    }
    let many = circle(2001, 1.0);
    assert_eq!(fit(&many, &through()), Err(FitError::TooManyToMeet { count: 2001, limit: 2000 }));
}

#[test]
fn repeated_points_count_once() {
    let plain = star(5);
    let mut repeated: Vec<_> = plain.iter().flat_map(|&p| [p, p]).collect();
    repeated.push(plain[0]);
    let (a, b) = (fitted(&plain, &options(0.05)), fitted(&repeated, &options(0.05)));
    assert_eq!(a.curve, b.curve);
    assert_eq!(b.corners, a.corners.iter().map(|k| 2 * k).collect::<Vec<_>>());
    let closing = FitOptions { corner_indices: Some(vec![repeated.len() - 1]), ..options(0.5) };
    assert_eq!(fitted(&repeated, &closing).corners, [0]);
}

#[test]
fn size_and_place_do_not_matter() {
    let plain = star(5);
    let reference = fitted(&plain, &options(0.05));
    for (scale, offset) in [(1e-6, 0.0), (1e10, 0.0), (1.0, 1e6), (1e-3, 1.0), (1e-63, 0.0)] {
        let offset = dvec2(offset, -offset);
        let points: Vec<_> = plain.iter().map(|p| *p * scale + offset).collect();
        let result = fit(&points, &options(0.05 * scale));
        if scale < 1e-60 {
            assert_eq!(result, Err(FitError::TooFewPoints { count: 1 }));
            continue;
        }
        let result = result.unwrap();
        assert_eq!(result.curve.points().len(), reference.curve.points().len(), "{scale}");
        for (a, b) in result.curve.points().iter().zip(reference.curve.points()) {
            assert!(a.distance(*b * scale + offset) < 1e-6 * scale, "{a} and {b}");
        }
    }
}

#[test]
fn what_is_no_outline_is_refused() {
    let two = vec![DVec2::ZERO, DVec2::X, DVec2::ZERO, DVec2::X, DVec2::X];
    for (points, error) in [
        (Vec::new(), FitError::TooFewPoints { count: 0 }),
        (vec![DVec2::ONE; 7], FitError::TooFewPoints { count: 1 }),
        (vec![DVec2::ZERO, DVec2::X, DVec2::ZERO], FitError::TooFewPoints { count: 2 }),
        (two, FitError::Flat { at: DVec2::ZERO }),
        (
            (0..50).map(|k| dvec2(0.1 * f64::from(k), 0.3 * f64::from(k))).collect(),
            FitError::Flat { at: DVec2::ZERO },
        ),
        (circle(MOST_FIT_POINTS + 1, 1.0), FitError::TooManyPoints { count: 20_001, limit: 20_000 }),
    ] {
        assert_eq!(fit(&points, &options(0.1)), Err(error));
    }
    let mut points = circle(10, 1.0);
    points[3].y = 1e300;
    assert!(matches!(fit(&points, &options(0.1)), Err(FitError::Point { index: 3, .. })));
    points[3].y = f64::NAN;
    assert!(matches!(fit(&points, &options(0.1)), Err(FitError::Point { index: 3, .. })));
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(fit(&circle(10, 1.0), &options(tolerance)), Err(FitError::Tolerance { .. })));
    }
    // A toothed ring of 1500 corners takes three points for each.
    assert!(matches!(fit(&star(750), &options(1e-4)), Err(FitError::OutOfReach { limit: 2000, .. })));
    assert!(matches!(fit(&star(5), &smooth(1e-12)), Err(FitError::OutOfReach { .. })));
}

#[test]
fn a_figure_eight_is_fitted_and_told_apart() {
    let points = closed(200, |t| dvec2((TAU * t).sin(), (2.0 * TAU * t).sin()) * 10.0);
    assert!(!fitted(&points, &smooth(0.05)).simple);
}

#[test]
fn two_legs_close_together_do_not_cross_at_a_tolerance_above_their_gap() {
    // A hairpin whose legs are 0.4 apart, with a tolerance of 1.
    let mut points: Vec<_> = (0..=60).map(|k| dvec2(f64::from(k), (f64::from(k) * 0.3).sin())).collect();
    points.extend((0..=60).rev().map(|k| dvec2(f64::from(k), (f64::from(k) * 0.3).sin() + 0.4)));
    let result = fitted(&points, &smooth(1.0));
    assert!(result.simple, "error {}", result.error);
}

/// Numbers in [0, 1) that repeat (Marsaglia's xorshift).
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// A stroke as a hand draws it: uneven steps, jitter, and an end that is not at the beginning.
fn stroke(seed: u64, count: usize, turns: f64, drift: f64) -> Vec<DVec2> {
    let mut random = numbers(seed);
    let mut t = 0.0;
    let mut points = Vec::new();
    while t < turns {
        let angle = TAU * t;
        let radius = 100.0 + 25.0 * (2.0 * angle).cos() + 10.0 * (5.0 * angle).sin() + drift * t;
        let jitter = dvec2(random() - 0.5, random() - 0.5) * 2.0;
        points.push(radius * DVec2::from_angle(angle) + jitter);
        t += (0.2 + 1.6 * random()) / count as f64;
    }
    points
}

#[test]
fn a_stroke_becomes_a_simple_curve_of_few_points() {
    let options = FitOptions { ends: EndRule::Trim, ..smooth(3.0) };
    for (turns, drift) in [(0.97, 0.0), (1.0, 6.0), (1.05, 0.0), (1.06, 8.0), (1.06, -8.0), (0.99, -5.0)] {
        for seed in 0..6 {
            let points = stroke(seed, 400, turns, drift);
            let result = fit(&points, &options).unwrap();
            let count = result.curve.points().len();
            assert!(result.simple, "seed {seed}, {turns} turns, drift {drift}");
            assert!(count <= 40, "seed {seed}, {turns} turns, drift {drift}: {count} control points");
            assert!(result.error < 12.0, "{}", result.error);
            if turns < 1.0 {
                assert_eq!(result.trimmed, 0);
            } else if turns > 1.04 {
                assert!(result.trimmed > 0, "seed {seed}, drift {drift}");
            }
            // One turn round: a rest of the overlap would wind twice.
            let area = result.curve.signed_area();
            assert!((30_000.0..37_000.0).contains(&area), "{area}");
        }
    }
}

#[test]
fn any_ring_is_fitted_within_the_tolerance() {
    let ring = (prop::collection::vec(0.3_f64..1.0, 3..60), 0.002_f64..0.2, any::<bool>(), -6_i32..9);
    seeded(96, &ring, |(radii, tolerance, keep, scale)| {
        let scale = 10.0_f64.powi(scale);
        let at = |k: usize| TAU * k as f64 / radii.len() as f64;
        let points: Vec<_> =
            radii.iter().enumerate().map(|(k, r)| scale * *r * DVec2::from_angle(at(k))).collect();
        let rule = if keep { options(tolerance * scale) } else { smooth(tolerance * scale) };
        let result = fitted(&points, &rule);
        prop_assert!(result.simple || tolerance > 0.01);
        Ok(())
    });
}

#[test]
fn any_list_is_fitted_or_refused() {
    let point = (-3_i32..=3, -3_i32..=3);
    let flags = (any::<bool>(), any::<bool>(), any::<bool>());
    let lists = (prop::collection::vec(point, 0..24), 0.01_f64..1.0, flags);
    seeded(400, &lists, |(points, tolerance, (through, keep, trim))| {
        let points: Vec<_> = points.iter().map(|&(x, y)| dvec2(f64::from(x), f64::from(y))).collect();
        let corners = if keep { CornerRule::Keep } else { CornerRule::Smooth };
        let ends = if trim { EndRule::Trim } else { EndRule::Join };
        let options = FitOptions { tolerance, corners, through, corner_indices: None, ends };
        match fit(&points, &options) {
            Ok(result) => prop_assert!(through || result.error <= tolerance + 1e-9 || result.trimmed > 0),
            Err(FitError::TooFewPoints { .. } | FitError::Flat { .. }) => {}
            Err(error) => prop_assert!(false, "{error}"),
        }
        Ok(())
    });
}
