//! Nearest points against a dense search.

use directrix::curve::{BSpline, Form};
use glam::DVec2;

use super::support::{assert_close, assert_near, blob, polygon, variety};

/// Distance to the curve by dense sampling and golden section round every local minimum of the samples.
fn brute_force(curve: &BSpline, p: DVec2) -> f64 {
    let (lo, hi) = curve.domain();
    let (n, step) = (3000, (hi - lo) / 3000.0);
    let distance = |u: f64| curve.point(u).distance(p);
    let samples: Vec<f64> = (0..=n).map(|i| distance(lo + step * f64::from(i))).collect();
    let mut best = f64::INFINITY;
    for i in 0..n as usize {
        let before = samples[(i + n as usize - 1) % n as usize];
        if samples[i] > before || samples[i] > samples[i + 1] {
            continue;
        }
        let (mut a, mut b) = (lo + step * (i as f64 - 1.0), lo + step * (i as f64 + 1.0));
        for _ in 0..90 {
            let (c, d) = (b - 0.618_033_988_75 * (b - a), a + 0.618_033_988_75 * (b - a));
            if distance(c) < distance(d) { b = d } else { a = c }
        }
        best = best.min(distance(a)).min(samples[i]);
    }
    best
}

#[test]
fn distances_are_those_of_a_dense_search() {
    for curve in variety() {
        let bounds = curve.bounds();
        let size = bounds.max - bounds.min;
        for i in 0..40 {
            let fraction = DVec2::new((f64::from(i) * 0.7549).fract(), (f64::from(i) * 0.5698).fract());
            let p = bounds.min + size * (fraction * 1.6 - 0.3);
            let nearest = curve.nearest(p);
            assert_eq!(nearest.at, curve.point(nearest.u));
            assert_close(nearest.distance_sq, nearest.at.distance_squared(p), 0.0);
            let brute = brute_force(&curve, p);
            // Golden section ends where the distance is flat to rounding, so it may be above by about 1e-8.
            let found = nearest.distance_sq.sqrt();
            assert!(found <= brute + 1e-12, "{p}: {found} but {brute} by search");
            assert!(found >= brute - 1e-7, "{p}: {found} but {brute} by search");
        }
    }
}

#[test]
fn points_of_the_curve_are_found_again() {
    for curve in variety() {
        let (lo, hi) = curve.domain();
        for i in 0..60 {
            let u = lo + (hi - lo) * (f64::from(i) + 0.5) / 60.0;
            let nearest = curve.nearest(curve.point(u));
            assert!(nearest.distance_sq.sqrt() < 1e-12 * curve.bounds().diagonal());
        }
    }
}

#[test]
fn the_middle_of_a_circle_has_a_nearest_point() {
    // A nearly exact circle: every point is as near as any other, up to about 1e-9.
    let circle = (0..64).map(|i| DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 64.0)).collect();
    let circle = BSpline::new(5, Form::Periodic, circle, None).unwrap();
    for p in [DVec2::ZERO, DVec2::new(1e-13, 0.0), DVec2::new(0.0, 1e-7)] {
        let nearest = circle.nearest(p);
        assert_close(nearest.distance_sq.sqrt(), brute_force(&circle, p), 1e-12);
    }
}

#[test]
fn corners_far_points_and_odd_points() {
    let square = polygon(3, &[(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)]);
    assert_near(square.nearest(DVec2::new(2.0, 3.0)).at, DVec2::ONE, 1e-14);
    assert_near(square.nearest(DVec2::new(0.2, 7.0)).at, DVec2::new(0.2, 1.0), 1e-12);
    assert_near(square.nearest(DVec2::new(0.3, 1e6)).at, DVec2::new(0.3, 1.0), 1e-4);
    assert_near(square.nearest(DVec2::new(1e200, 0.0)).at.abs(), DVec2::ONE, 1.0);
    assert!(square.nearest(DVec2::NAN).at.is_finite());
    assert!(square.nearest(DVec2::INFINITY).at.is_finite());
    let far = blob(1.0, DVec2::new(1e8, -1e8));
    let far = BSpline::new(3, Form::Periodic, far, None).unwrap();
    let p = DVec2::new(1e8 + 0.3, -1e8);
    assert_close(far.nearest(p).distance_sq.sqrt(), brute_force(&far, p), 1e-7);
}
