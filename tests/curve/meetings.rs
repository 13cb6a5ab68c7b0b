//! Where a curve meets itself or another.

use directrix::curve::{BSpline, Form, Meeting};
use glam::DVec2;

use super::support::{assert_near, blob, curve, periodic, polygon, variety};

/// Checks that the meeting is a place of both curves.
#[track_caller]
fn assert_meets(a: &BSpline, b: &BSpline, meeting: Option<Meeting>) -> Meeting {
    let meeting = meeting.expect("the curves meet");
    let allowed = 2e-9 * a.bounds().union(b.bounds()).diagonal();
    assert_near(a.point(meeting.u), meeting.at, allowed);
    assert_near(b.point(meeting.v), meeting.at, allowed);
    meeting
}

fn spline(points: Vec<DVec2>) -> BSpline {
    BSpline::new(3, Form::Periodic, points, None).unwrap()
}

#[test]
fn simple_curves_do_not_meet_themselves() {
    for (i, curve) in variety().iter().enumerate().filter(|(_, c)| c.degree() < 32) {
        assert_eq!(curve.self_intersection(), None, "curve {i} of degree {}", curve.degree());
    }
    for scale in [1e-40, 1e-9, 1e9] {
        assert_eq!(spline(blob(scale, DVec2::ZERO)).self_intersection(), None);
    }
    assert_eq!(spline(blob(1.0, DVec2::new(1e7, -1e7))).self_intersection(), None);
}

#[test]
fn a_figure_eight_crosses_in_the_middle() {
    for degree in 2..=5 {
        let eight = [
            (0.0, 0.0),
            (2.0, 2.0),
            (4.0, 0.0),
            (2.0, -2.0),
            (0.0, 0.0),
            (-2.0, 2.0),
            (-4.0, 0.0),
            (-2.0, -2.0),
        ];
        let eight = periodic(degree, &eight);
        let meeting = assert_meets(&eight, &eight, eight.self_intersection());
        assert_near(meeting.at, DVec2::ZERO, 1e-8);
        assert!(meeting.u < meeting.v);
        assert!((meeting.v - meeting.u - 0.5).abs() < 1e-6);
    }
    // Without symmetry the crossing is nowhere special.
    let skew = periodic(
        3,
        &[(0.0, 0.3), (2.0, 2.0), (4.1, 0.0), (2.0, -2.0), (-2.0, 2.2), (-4.0, 0.0), (-2.3, -2.0)],
    );
    assert_meets(&skew, &skew, skew.self_intersection());
}

#[test]
fn tiny_loops_are_found() {
    // A loop of the given size on the side of a large rectangle.
    for size in [1e-1, 1e-3, 1e-5, 1e-7] {
        let mut points = vec![DVec2::new(-5.0, 5.0), DVec2::new(-5.0, -1.0)];
        let legs = [(-6.0, 0.0), (6.0, 0.5), (2.0, 4.0), (-2.0, 4.0), (-6.0, 0.5), (6.0, 0.0)];
        points.extend(legs.map(|p| DVec2::from(p) * size));
        points.extend([DVec2::new(5.0, -1.0), DVec2::new(5.0, 5.0)]);
        let curve = spline(points);
        let meeting = assert_meets(&curve, &curve, curve.self_intersection());
        assert!(meeting.at.length() < 10.0 * size, "{meeting:?}");
    }
}

/// A dumb-bell whose waist has the given width: its two sides run towards each other round y = 0.
fn dumb_bell(waist: f64) -> BSpline {
    // At a point of symmetry a uniform cubic is (a + 4 b + a) / 6 there, so the waist is exact.
    let h = waist / 2.0;
    let (side, middle) = (1.0, (6.0 * h - 2.0) / 4.0);
    let upper = [(3.0, 2.0), (1.0, side), (0.0, middle), (-1.0, side), (-3.0, 2.0)];
    let lower = upper.iter().rev().map(|&(x, y)| (x, -y));
    let points: Vec<_> =
        upper.iter().copied().chain([(-5.0, 0.0)]).chain(lower).chain([(5.0, 0.0)]).collect();
    periodic(3, &points)
}

#[test]
fn near_touches_are_apart_and_touches_are_not() {
    let diagonal = dumb_bell(0.1).bounds().diagonal();
    for gap in [1e-1, 1e-3, 1e-6, 1e-8] {
        assert_eq!(dumb_bell(gap * diagonal).self_intersection(), None, "gap {gap}");
    }
    for overlap in [0.0, 1e-12, -1e-8, -1e-6, -1e-3] {
        let curve = dumb_bell(overlap * diagonal);
        let meeting = assert_meets(&curve, &curve, curve.self_intersection());
        assert!(meeting.at.y.abs() < 1e-7 * diagonal + overlap.abs() * diagonal);
    }
}

#[test]
fn spikes_and_curves_that_go_back_are_found() {
    let line = curve(2, Form::Clamped, &[(0.0, 0.0), (1.0, 0.0), (0.0, 0.0)], None);
    assert_meets(&line, &line, line.self_intersection());
    let flat = periodic(3, &[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0), (1.5, 1.5)]);
    assert_meets(&flat, &flat, flat.self_intersection());
    // A square with a hair of length 1 and no width.
    let hair =
        polygon(3, &[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (3.0, 1.0), (2.0, 1.0), (2.0, 2.0), (0.0, 2.0)]);
    let meeting = assert_meets(&hair, &hair, hair.self_intersection());
    assert!(meeting.at.x >= 2.0 - 1e-8);
    // The same with a width: simple, however sharp its tip.
    for width in [1e-2, 1e-4, 1e-6] {
        let tip = [
            (0.0, 0.0),
            (2.0, 0.0),
            (2.0, 1.0 - width),
            (3.0, 1.0),
            (2.0, 1.0 + width),
            (2.0, 2.0),
            (0.0, 2.0),
        ];
        assert_eq!(polygon(3, &tip).self_intersection(), None, "width {width}");
    }
    // Twice round the same blob.
    let twice = spline([blob(1.0, DVec2::ZERO), blob(1.0, DVec2::ZERO)].concat());
    assert_meets(&twice, &twice, twice.self_intersection());
}

#[test]
fn a_cusp_is_no_intersection() {
    let cusp = [(1.0, -1.0), (-1.0 / 3.0, 1.0), (-1.0 / 3.0, -1.0), (1.0, 1.0)];
    let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0];
    let closing = [(3.0, 1.0), (3.0, -1.0), (1.0, -1.0)];
    let with_cusp = |lean: f64| {
        let mut points = cusp.to_vec();
        points[1].1 += lean;
        points[2].1 -= lean;
        points.extend(closing);
        curve(3, Form::Clamped, &points, Some(&knots))
    };
    assert_eq!(with_cusp(0.0).self_intersection(), None);
    // Legs that cross a little more make a loop, legs that cross less a round nose.
    let looped = with_cusp(0.05);
    assert_meets(&looped, &looped, looped.self_intersection());
    assert_eq!(with_cusp(-0.05).self_intersection(), None);
}

#[test]
fn nested_and_distant_curves_have_no_contact() {
    let outer = spline(blob(1.0, DVec2::ZERO));
    for scale in [0.5, 0.99, 1.0 - 1e-4, 1.0 - 1e-6] {
        assert_eq!(outer.contact(&spline(blob(scale, DVec2::ZERO))), None, "scale {scale}");
    }
    assert_eq!(outer.contact(&spline(blob(1.0, DVec2::new(10.0, 0.0)))), None);
    assert_eq!(outer.contact(&spline(blob(1e-7, DVec2::ZERO))), None);
}

#[test]
fn crossing_curves_have_contact() {
    let a = spline(blob(1.0, DVec2::ZERO));
    for shift in [DVec2::new(0.5, 0.2), DVec2::new(0.0, -1.7), DVec2::new(1e-3, 1e-3)] {
        let b = spline(blob(1.0, shift));
        assert_meets(&a, &b, a.contact(&b));
        assert_meets(&b, &a, b.contact(&a));
        assert_meets(&a, &b.reversed(), a.contact(&b.reversed()));
    }
}

#[test]
fn identical_curves_have_contact() {
    for curve in variety() {
        assert_meets(&curve, &curve, curve.contact(&curve));
        let copy = curve.clone();
        assert_meets(&curve, &copy, curve.contact(&copy));
        let (lo, hi) = curve.domain();
        let refined = curve.insert_knot(lo + 0.123 * (hi - lo)).unwrap().reversed();
        assert_meets(&curve, &refined, curve.contact(&refined));
    }
}

#[test]
fn tangent_curves_have_contact_and_nearly_tangent_ones_do_not() {
    // Convex quadratics whose flat tops meet at (0, 1): the middle of the uppermost leg.
    let box_points = [(-2.0, 1.0), (-2.0, -1.0), (2.0, -1.0), (2.0, 1.0)];
    let lower = periodic(2, &box_points);
    let upper = |gap: f64| {
        let mirrored: Vec<_> = box_points.iter().map(|&(x, y)| (0.7 * x, 2.0 + gap - y)).collect();
        periodic(2, &mirrored)
    };
    let touching = upper(0.0);
    let meeting = assert_meets(&lower, &touching, lower.contact(&touching));
    assert!((meeting.at.y - 1.0).abs() < 1e-8);
    for gap in [1e-3, 1e-6, 1e-7] {
        assert_eq!(lower.contact(&upper(gap)), None, "gap {gap}");
        let overlapping = upper(-gap);
        assert_meets(&lower, &overlapping, lower.contact(&overlapping));
    }
    // Squares that share part of a side, and squares that share a corner.
    let square = polygon(3, &[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    let beside = polygon(3, &[(1.0, 0.5), (2.0, 0.5), (2.0, 3.0), (1.0, 3.0)]);
    assert_meets(&square, &beside, square.contact(&beside));
    let diagonal = polygon(2, &[(1.0, 1.0), (2.0, 1.5), (1.5, 2.0)]);
    let meeting = assert_meets(&square, &diagonal, square.contact(&diagonal));
    assert_near(meeting.at, DVec2::ONE, 1e-8);
}

#[test]
fn dense_sampling_agrees_about_crossings() {
    // Polygons of 4000 vertices cross where the curves do, unless it is by less than their own error.
    let segments_cross = |a: DVec2, b: DVec2, c: DVec2, d: DVec2| {
        let side = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p) > 0.0;
        side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b)
    };
    let mut crossing = 0;
    for seed in 0..60_u32 {
        let random = |k: u32| (f64::from(seed * 37 + k * 11 + 5) * 0.754_877_666_246_692_7).fract();
        let count = if seed % 2 == 0 { 5 } else { 7 };
        let points = (0..count).map(|k| DVec2::new(random(k), random(7 * k + 100))).collect();
        let curve = spline(points);
        let n = 500;
        let polygon: Vec<_> = (0..=n).map(|i| curve.point(f64::from(i) / f64::from(n))).collect();
        let brute = (0..n as usize).any(|i| {
            (i + 2..n as usize)
                .filter(|&j| (j + 1) % n as usize != i)
                .any(|j| segments_cross(polygon[i], polygon[i + 1], polygon[j], polygon[j + 1]))
        });
        crossing += u32::from(brute);
        assert_eq!(curve.self_intersection().is_some(), brute, "seed {seed}");
    }
    assert!((5..55).contains(&crossing), "{crossing} of 60 curves cross themselves, so the test says little");
}

#[test]
fn curves_of_many_points_are_answered() {
    let ring = |radius: f64| {
        let point = |i: u32| DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 2000.0) * radius;
        spline((0..2000).map(point).collect())
    };
    let outer = ring(1.0);
    assert_eq!(outer.self_intersection(), None);
    assert_eq!(outer.contact(&ring(1.0 - 1e-4)), None);
    assert_meets(&outer, &outer, outer.contact(&outer));
    // Along a gap of about the tolerance the work ends with a place that is close, if not closer than that.
    let inner = ring(1.0 - 4e-9);
    if let Some(meeting) = outer.contact(&inner) {
        assert_near(outer.point(meeting.u), inner.point(meeting.v), 1e-2);
    }
}
