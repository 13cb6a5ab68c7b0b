//! Values, derivatives, area, reversal, refinement, polygons and samples.

use directrix::curve::{BSpline, Form, Scheme, sample};
use glam::DVec2;

use super::support::{
    assert_close, assert_near, blob, curve, periodic, polygon, slow_point, spread, variety,
};

#[test]
fn values_are_those_of_the_recursion() {
    for curve in variety().iter().filter(|c| c.degree() <= 7) {
        for u in spread(curve, 60).chain([curve.domain().0]) {
            assert_near(curve.point(u), slow_point(curve, u), 2e-14 * 8.0);
        }
    }
}

#[test]
fn periodic_points_may_have_any_knots_over_the_domain() {
    let points = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
    let short = curve(2, Form::Periodic, &points, Some(&[0.0, 1.0, 2.0, 3.0, 4.0]));
    // The middle of a span of a uniform quadratic is (a + 6 b + c) / 8; its ends are the middles of the legs.
    assert_eq!(short.point(0.0), DVec2::new(2.0, 0.0));
    assert_near(short.point(0.5), DVec2::new(3.5, 0.5), 1e-15);
    assert_eq!(short.domain(), (0.0, 4.0));
    let full = curve(2, Form::Periodic, &points, Some(short.knots()));
    assert_eq!(full, short);
}

#[test]
fn parameters_wrap_round() {
    for curve in variety() {
        let (lo, hi) = curve.domain();
        let period = hi - lo;
        assert_eq!(curve.point(hi), curve.point(lo));
        assert_eq!(curve.point(f64::NAN), curve.point(lo));
        for u in spread(&curve, 5) {
            assert_near(curve.point(u + 3.0 * period), curve.point(u), 1e-10);
            assert_near(curve.point(u - 2.0 * period), curve.point(u), 1e-10);
        }
        assert_near(curve.point(hi - 1e-12 * period), curve.point(lo), 1e-9);
    }
}

#[test]
fn a_clamped_curve_starts_in_its_first_point() {
    let points = [(0.1, 0.7), (1.0, 0.0), (2.0, 2.0), (0.3, 1.9), (0.1, 0.7)];
    let clamped = curve(3, Form::Clamped, &points, None);
    assert_eq!(clamped.point(0.0), DVec2::new(0.1, 0.7));
    assert_eq!(clamped.points().len(), 5);
}

#[test]
fn derivatives_match_differences_of_the_one_below() {
    for curve in variety() {
        let (lo, hi) = curve.domain();
        let h = 1e-5 * (hi - lo);
        // Differences are meaningful where no knot is near.
        let clear = |u: &f64| curve.knots().iter().all(|k| (k - u).abs() > 2.0 * h);
        for u in spread(&curve, 23).filter(clear) {
            let order = curve.degree().min(4);
            let (values, before, after) = (
                curve.derivatives(u, order),
                curve.derivatives(u - h, order),
                curve.derivatives(u + h, order),
            );
            assert_eq!(values[0], curve.point(u));
            assert_near(values[1], curve.derivative(u), 1e-12 * values[1].length());
            for k in 0..order {
                let difference = (after[k] - before[k]) / (2.0 * h);
                let next = (1..=order).map(|j| values[j].length() * h.powi(j as i32)).sum::<f64>();
                // Truncation h^2 times a higher derivative, and rounding eps / h.
                let allowed = (1e-4 * next / h.powi(k as i32 + 1)).max(1e-9);
                assert_near(values[k + 1], difference, allowed);
            }
        }
        let beyond = curve.derivatives(lo, curve.degree() + 2);
        assert_eq!(beyond[curve.degree() + 1..], [DVec2::ZERO; 2]);
    }
}

#[test]
fn area_is_that_of_a_fine_polygon() {
    for curve in variety() {
        let (lo, hi) = curve.domain();
        let n = 20_000;
        let at = |i: usize| curve.point(lo + (hi - lo) * i as f64 / n as f64);
        let fine: f64 = (0..n).map(|i| at(i).perp_dot(at(i + 1))).sum::<f64>() / 2.0;
        // The error of an inscribed polygon is below length^3 times curvature over 12 n^2.
        assert_close(curve.signed_area(), fine, 2e-6 * curve.bounds().diagonal().powi(2));
    }
    let square = polygon(3, &[(1e6, 1e6), (1e6 + 2.0, 1e6), (1e6 + 2.0, 1e6 + 1.0), (1e6, 1e6 + 1.0)]);
    assert_close(square.signed_area(), 2.0, 1e-13);
}

#[test]
fn reversal_turns_everything_round() {
    for curve in variety() {
        let back = curve.reversed();
        let (lo, hi) = curve.domain();
        assert_eq!((back.domain(), back.form()), (curve.domain(), curve.form()));
        assert_eq!(back.points().len(), curve.points().len());
        assert_close(back.signed_area(), -curve.signed_area(), 1e-12);
        for u in spread(&curve, 40) {
            assert_near(back.point(lo + hi - u), curve.point(u), 1e-13);
            assert_near(back.normal(lo + hi - u), -curve.normal(u), 1e-8);
        }
        assert_eq!(back.reversed().points(), curve.points());
        let rebuilt =
            BSpline::new(back.degree(), back.form(), back.points().to_vec(), Some(back.knots().to_vec()));
        assert_near(rebuilt.unwrap().point(0.3), back.point(0.3), 1e-13);
    }
}

#[test]
fn refinement_keeps_area_length_and_meetings() {
    for curve in variety() {
        let (lo, hi) = curve.domain();
        let refined = (0..9).fold(curve.clone(), |c, i| {
            c.insert_knot(lo + (hi - lo) * (0.31 + 0.617 * f64::from(i)).fract()).unwrap()
        });
        assert_eq!(refined.points().len(), curve.points().len() + 9);
        assert_close(refined.signed_area(), curve.signed_area(), 1e-12);
        assert_close(refined.length(), curve.length(), 1e-11);
        assert_eq!(refined.self_intersection().is_some(), curve.self_intersection().is_some());
        assert_eq!(refined.corners().len(), curve.corners().len());
    }
}

#[test]
fn normals_point_outward_on_a_counter_clockwise_curve() {
    let blob = BSpline::new(3, Form::Periodic, blob(1.0, DVec2::ZERO), None).unwrap();
    for u in spread(&blob, 200) {
        let normal = blob.normal(u);
        assert_close(normal.length(), 1.0, 1e-14);
        assert_close(normal.dot(blob.derivative(u)), 0.0, 1e-12);
        assert!(normal.dot(blob.point(u)) > 0.0);
    }
}

#[test]
fn flattened_curves_stay_within_the_tolerance() {
    for curve in variety() {
        let size = curve.bounds().diagonal();
        let mut counts = Vec::new();
        for tolerance in [1e9, 0.1, 1e-2, 1e-3, 1e-5].map(|t| t * size) {
            let vertices = curve.flatten(tolerance);
            counts.push(vertices.len());
            assert!(vertices.len() >= 3);
            assert_eq!(vertices[0].0, curve.domain().0);
            assert!(vertices.is_sorted_by(|a, b| a.0 < b.0) && vertices.last().unwrap().0 < curve.domain().1);
            for (i, &(u, a)) in vertices.iter().enumerate() {
                let (next, b) = vertices.get(i + 1).copied().unwrap_or((curve.domain().1, vertices[0].1));
                for k in 0..=8 {
                    let p = curve.point(u + (next - u) * f64::from(k) / 8.0);
                    let chord = b - a;
                    let t =
                        if chord == DVec2::ZERO { 0.0 } else { (p - a).dot(chord) / chord.length_squared() };
                    assert!(p.distance(a + chord * t.clamp(0.0, 1.0)) <= tolerance * (1.0 + 1e-9));
                }
            }
        }
        assert!(counts.is_sorted());
    }
}

#[test]
fn samples_start_at_the_seam_and_are_evenly_spread() {
    for curve in variety() {
        let (lo, hi) = curve.domain();
        for count in [3, 4, 44, 301] {
            let even = sample(&curve, Scheme::Parameter, count);
            assert_eq!(even.parameters[0], lo);
            assert_close(even.parameters[count - 1], hi - (hi - lo) / count as f64, 1e-12 * (hi - lo));
            let by_length = sample(&curve, Scheme::ArcLength, count);
            assert_eq!((by_length.parameters[0], by_length.arc[0]), (lo, 0.0));
            assert!(by_length.parameters.is_sorted_by(|a, b| a < b));
            for samples in [even, by_length] {
                assert_eq!([samples.points.len(), samples.normals.len(), samples.arc.len()], [count; 3]);
                assert!(samples.parameters.iter().all(|u| (lo..hi).contains(u)));
                assert!(samples.arc.is_sorted() && samples.arc[count - 1] < samples.length);
                for i in 0..count {
                    assert_eq!(samples.points[i], curve.point(samples.parameters[i]));
                    assert_eq!(samples.normals[i], curve.normal(samples.parameters[i]));
                }
            }
        }
    }
}

#[test]
fn arc_length_samples_of_a_square_meet_its_corners() {
    // Seam in the middle of a stretch at a standstill or at a corner; 4 and 8 samples must hit the corners.
    let square = polygon(3, &[(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)]);
    let start = square.point(square.domain().0);
    assert_near(start.abs(), DVec2::ONE, 1e-15);
    let samples = sample(&square, Scheme::ArcLength, 8);
    for i in 0..8 {
        let expected = if i % 2 == 0 { 2.0_f64.sqrt() } else { 1.0 };
        assert_close(samples.points[i].length(), expected, 1e-12);
        assert_near(samples.normals[i], samples.points[i].normalize(), 1e-9);
    }
}

#[test]
#[should_panic(expected = "at least 3 samples")]
fn two_samples_are_too_few() {
    let triangle = periodic(2, &[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]);
    let _ = sample(&triangle, Scheme::Parameter, 2);
}
