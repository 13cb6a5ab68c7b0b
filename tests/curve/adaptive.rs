//! Adaptive samples: what they promise, measured densely, and what they save.

use directrix::curve::{BSpline, Fineness, Form, Samples, Scheme, sample, sample_adaptively};
use glam::DVec2;

use super::support::{assert_near, curve, periodic, polygon, variety};

/// Distance of a point from a segment.
fn off_segment(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
    p.distance(if along.is_nan() { a } else { a.lerp(b, along) })
}

/// Greatest distance of 14 points of the curve between each two samples from their chord, and greatest difference in
/// degrees of the directions of the steps between them.
fn measured(curve: &BSpline, samples: &Samples) -> (f64, f64) {
    let n = samples.points.len();
    let mut worst = (0.0_f64, 0.0_f64);
    for i in 0..n {
        let (a, b) = (samples.points[i], samples.points[(i + 1) % n]);
        let end = if i + 1 < n { samples.parameters[i + 1] } else { curve.domain().1 };
        let start = samples.parameters[i];
        let points: Vec<DVec2> =
            (0..=14).map(|k| curve.point(start + (end - start) * f64::from(k) / 14.0)).collect();
        worst.0 = points.iter().fold(worst.0, |worst, &p| worst.max(off_segment(p, a, b)));
        let steps =
            || points.windows(2).map(|w| w[1] - w[0]).filter(|step| step.length() > 1e-9 * curve.length());
        let Some(first) = steps().next() else { continue };
        let turns = steps().map(|step| first.angle_to(step).to_degrees());
        let (low, high) = turns.fold((0.0_f64, 0.0_f64), |(l, h), turn| (l.min(turn), h.max(turn)));
        worst.1 = worst.1.max(high - low);
    }
    worst
}

#[test]
fn deviation_and_turn_keep_their_bounds_on_every_kind_of_curve() {
    for (k, curve) in variety().iter().enumerate() {
        for (share, max_turn, min_count) in
            [(1e-2, 90.0, 3), (1e-3, 15.0, 12), (1e-4, 40.0, 30), (1.0, 5.0, 3)]
        {
            let tolerance = share * curve.bounds().diagonal();
            let (samples, is_fine) = sample_adaptively(curve, Fineness { tolerance, max_turn, min_count });
            assert!(is_fine && samples.points.len() >= min_count, "curve {k}");
            assert!(samples.parameters.windows(2).all(|w| w[0] < w[1]), "curve {k}");
            assert!(samples.arc.windows(2).all(|w| w[0] < w[1]), "curve {k}");
            assert_eq!((samples.parameters[0], samples.arc[0]), (curve.domain().0, 0.0));
            let (deviation, turn) = measured(curve, &samples);
            assert!(deviation <= tolerance, "curve {k}: {deviation} > {tolerance}");
            assert!(turn <= max_turn * (1.0 + 1e-6), "curve {k}: {turn} > {max_turn}");
        }
    }
}

#[test]
fn uniform_samples_of_the_same_deviation_are_more() {
    // A long flat lens: two sharp bends and two almost straight sides.
    let lens =
        periodic(3, &[(50.0, 0.0), (45.0, 4.0), (0.0, 10.0), (-45.0, 4.0), (-50.0, 0.0), (0.0, -10.0)]);
    let fineness = Fineness { tolerance: 0.02, max_turn: 90.0, min_count: 3 };
    let (samples, _) = sample_adaptively(&lens, fineness);
    let (deviation, _) = measured(&lens, &samples);
    let count = samples.points.len();
    for n in [count, count * 3 / 2, count * 2] {
        let (uniform, _) = measured(&lens, &sample(&lens, Scheme::ArcLength, n));
        assert!(uniform > deviation, "{count} adaptive samples: {deviation}, {n} uniform ones: {uniform}");
    }
}

#[test]
fn corners_and_cusps_are_samples_and_straight_sides_need_no_more() {
    let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (2.0, 3.0), (0.0, 1.0)];
    for degree in 2..=5 {
        let house = polygon(degree, &corners);
        let (samples, is_fine) =
            sample_adaptively(&house, Fineness { tolerance: 1e-6, max_turn: 1.0, min_count: 3 });
        assert!(is_fine);
        for corner in corners {
            let nearest = samples.points.iter().map(|p| p.distance(corner.into())).fold(f64::MAX, f64::min);
            assert!(nearest < 1e-9, "degree {degree}, {corner:?}: {nearest}");
        }
        assert!(samples.points.len() <= 2 * corners.len(), "degree {degree}: {}", samples.points.len());
    }
    // A cusp inside a span: control points that go there and back, as in a semicubical parabola.
    let cusp = curve(
        3,
        Form::Clamped,
        &[(0.0, 0.0), (3.0, 3.0), (0.0, 3.0), (3.0, 0.0), (3.0, -1.0), (0.0, -1.0), (0.0, 0.0)],
        Some(&[0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0]),
    );
    let turning_back = cusp.corners().into_iter().find(|corner| corner.turn == 180.0).expect("a cusp");
    let (samples, is_fine) =
        sample_adaptively(&cusp, Fineness { tolerance: 1e-3, max_turn: 10.0, min_count: 3 });
    assert!(is_fine && samples.points.len() < 120, "{}", samples.points.len());
    let nearest = samples.points.iter().map(|p| p.distance(turning_back.at)).fold(f64::MAX, f64::min);
    assert!(nearest < 1e-9, "{nearest}");
}

#[test]
fn a_knot_where_curvature_jumps_is_preferred_to_the_middle() {
    // Straight sides and round ends that meet with one tangent in double knots.
    let points =
        [(0.0, 0.0), (2.0, 0.0), (7.0, 0.0), (9.0, 0.0), (12.0, 0.0), (12.0, 4.0), (9.0, 4.0), (7.0, 4.0)];
    let points: Vec<_> =
        points.iter().copied().chain([(2.0, 4.0), (0.0, 4.0), (-3.0, 4.0), (-3.0, 0.0)]).collect();
    let knots = [0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 5.0, 5.0, 6.0];
    let slot = curve(3, Form::Periodic, &points, Some(&knots));
    let (samples, _) = sample_adaptively(&slot, Fineness { tolerance: 0.2, max_turn: 90.0, min_count: 3 });
    let doubled: Vec<f64> = (0..6).map(f64::from).collect();
    let met = doubled.iter().filter(|u| samples.parameters.contains(u)).count();
    assert!(met >= 3, "{met} of the double knots are samples: {:?}", samples.parameters);
}

#[test]
fn samples_are_points_and_normals_of_the_curve() {
    for curve in variety() {
        let tolerance = 1e-3 * curve.bounds().diagonal();
        let (samples, _) = sample_adaptively(&curve, Fineness { tolerance, max_turn: 15.0, min_count: 12 });
        for (k, &u) in samples.parameters.iter().enumerate() {
            assert_near(samples.points[k], curve.point(u), 0.0);
            assert_near(samples.normals[k], curve.normal(u), 0.0);
            assert!((curve.arc_length().at(u) - samples.arc[k]).abs() < 1e-9 * samples.length);
        }
    }
}
