//! Paths of curves whose matching is given.

use super::*;
use crate::curve::Form;
use glam::dvec2;

fn star(degree: usize, count: usize, radius: f64, depth: f64) -> BSpline {
    let point = |k: usize| {
        let turn = std::f64::consts::TAU * k as f64 / count as f64;
        DVec2::from_angle(turn) * radius * (1.0 + depth * (k as f64 * 1.7).sin())
    };
    BSpline::new(degree, Form::Periodic, (0..count).map(point).collect(), None).expect("a valid curve")
}

/// Unevenly spread places, some of which share an end.
fn places(count: usize) -> Vec<(f64, f64)> {
    (0..count)
        .map(|k| {
            let t = k as f64 / count as f64;
            let v = t - 0.2 + 0.4 * (std::f64::consts::TAU * t).sin() / std::f64::consts::TAU;
            (((t * 7.0).floor() / 7.0).max(t - 0.05), v)
        })
        .collect()
}

/// Point of a path at the share `x` of a command.
fn on(points: &[DVec2], command: usize, x: f64) -> DVec2 {
    cubic::point(&points[3 * command..=3 * command + 3], x)
}

/// Largest distance of dense points of a line from the polyline through dense points of another.
fn off(points: &[DVec2], line: &[DVec2]) -> f64 {
    let far = |p: &DVec2| {
        (0..line.len())
            .map(|i| {
                let (a, b) = (line[i], line[(i + 1) % line.len()]);
                let along = b - a;
                let t = if along == DVec2::ZERO { 0.0 } else { (*p - a).dot(along) / along.length_squared() };
                p.distance(a + along * t.clamp(0.0, 1.0))
            })
            .fold(f64::INFINITY, f64::min)
    };
    points.iter().map(far).fold(0.0, f64::max)
}

/// Even blends of the two paths against the band's own in-between curves, both ways.
#[test]
fn blends_of_the_paths_are_the_in_between_curves() {
    for (degrees, tolerance) in
        [([3, 3], 0.05), ([2, 3], 0.01), ([2, 2], 1e-4), ([3, 5], 0.01), ([7, 4], 1e-3)]
    {
        let curves = [star(degrees[0], 9, 1.0, 0.15), star(degrees[1], 13, 3.0, 0.1)];
        let places = places(30);
        let pair = path_pair(&curves, &places, tolerance).expect("paths");
        assert!(pair.error <= OF_THE_FIT * tolerance, "{} {tolerance}", pair.error);
        assert_eq!(pair.points[0].len(), 3 * pair.commands() + 1);
        assert_eq!(pair.points[1].len(), 3 * pair.commands() + 1);
        for points in &pair.points {
            assert_eq!(points[0], points[points.len() - 1]);
        }
        let pure = |curve: usize, _: f64| crate::material::Composition::pure(curve, 2);
        let band = super::super::Band::new(&curves, &places, pure, 40);
        for s in [0.0, 0.3, 0.75, 1.0] {
            let exact = band.in_between(s);
            let blended = |command: usize, x: f64| {
                on(&pair.points[0], command, x).lerp(on(&pair.points[1], command, x), s)
            };
            let mut blend = Vec::new();
            for command in 0..pair.commands() {
                blend.extend((0..60).map(|i| blended(command, f64::from(i) / 60.0)));
            }
            // What the chords between dense points add.
            let slack = 2e-4;
            let (there, back) = (off(&blend, &exact), off(&exact, &blend));
            assert!(
                there <= pair.error + slack && back <= pair.error + slack,
                "{there} {back} {}",
                pair.error
            );
        }
    }
}

#[test]
fn a_wider_tolerance_takes_fewer_commands_down_to_four() {
    let curves = [star(3, 9, 1.0, 0.1), star(3, 13, 3.0, 0.1)];
    let count = |tolerance: f64| path_pair(&curves, &places(44), tolerance).expect("paths").commands();
    let counts = [1e-8, 1e-3, 0.03, 3.0].map(count);
    assert!(counts.windows(2).all(|pair| pair[0] > pair[1]), "{counts:?}");
    assert!((4..=6).contains(&counts[3]), "{counts:?}");
    // Lines and knots of both curves, less cuts that coincide.
    assert!((44..=44 + 9 + 13).contains(&counts[0]), "{counts:?}");
}

#[test]
fn cubics_and_parabolas_are_exact() {
    let curves = [star(2, 8, 1.0, 0.1), star(3, 12, 3.0, 0.1)];
    let pair = path_pair(&curves, &places(20), 1e-8).expect("paths");
    for (command, &(u, v)) in pair.middles.iter().enumerate() {
        // With so small a tolerance no command spans more than one stretch, and its middle is that of the parameters.
        assert!(on(&pair.points[0], command, 0.5).distance(curves[0].point(u)) < 1e-8);
        assert!(on(&pair.points[1], command, 0.5).distance(curves[1].point(v)) < 1e-8);
    }
}

/// Open curves: from end to end, and not back.
#[test]
fn open_curves_give_open_paths() {
    let arc = |radius: f64, degree: usize| {
        let points =
            (0..8).map(|k| DVec2::from_angle(0.4 * f64::from(k)) * radius * (1.0 + 0.05 * f64::from(k % 3)));
        BSpline::new(degree, Form::Open, points.collect(), None).expect("a valid curve")
    };
    let curves = [arc(1.0, 3), arc(2.0, 4)];
    let even: Vec<_> = (0..=12).map(|k| f64::from(k) / 12.0).map(|t| (t, t * t)).collect();
    let pair = path_pair(&curves, &even, 1e-4).expect("paths");
    assert!(!pair.closed && pair.error <= 1e-4);
    for (points, curve) in pair.points.iter().zip(&curves) {
        let (first, last) = (curve.points()[0], curve.points()[7]);
        assert!(points[0].distance(first) < 1e-12 && points[points.len() - 1].distance(last) < 1e-12);
    }
    for (command, &(u, v)) in pair.middles.iter().enumerate() {
        for (curve, at) in [u, v].into_iter().enumerate() {
            let dense: Vec<DVec2> =
                (0..=200).map(|i| on(&pair.points[curve], command, f64::from(i) / 200.0)).collect();
            let nearest =
                dense.iter().map(|p| p.distance(curves[curve].point(at))).fold(f64::INFINITY, f64::min);
            assert!(nearest < 0.01, "{command} {curve} {nearest}");
        }
    }
    let ([text, _], _) = pair.svg();
    assert!(text.starts_with('M') && !text.ends_with('Z'));
}

#[test]
fn corners_stay_corners() {
    let square = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0), (1.0, 1.0)].map(DVec2::from);
    let knots = vec![0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0];
    let cornered = BSpline::new(2, Form::Clamped, square.to_vec(), Some(knots)).expect("a valid curve");
    let curves = [cornered.clone(), star(3, 12, 5.0, 0.0)];
    let even: Vec<_> = (0..7).map(|k| f64::from(k) / 7.0).map(|t| (t, t)).collect();
    let pair = path_pair(&curves, &even, 0.01).expect("paths");
    let corner = cornered.point(0.5);
    let nearest = pair.points[0].iter().step_by(3).map(|p| p.distance(corner)).fold(f64::INFINITY, f64::min);
    assert!(nearest < 1e-12, "a command ends at the corner: {nearest}");
}

#[test]
fn texts_keep_within_the_error_that_they_state() {
    let curves = [star(3, 9, 1.0, 0.1), star(3, 13, 3.0, 0.1)];
    for tolerance in [1e-6, 1e-3, 0.5] {
        let pair = path_pair(&curves, &places(20), tolerance).expect("paths");
        let (texts, error) = pair.svg();
        assert!(error <= tolerance, "{error} {tolerance}");
        for (text, points) in texts.iter().zip(&pair.points) {
            let numbers: Vec<f64> = text
                .split(|c: char| "MCZ ".contains(c))
                .filter(|part| !part.is_empty())
                .map(|part| part.parse().expect("a number"))
                .collect();
            assert_eq!(numbers.len(), 2 * points.len());
            let off = numbers.chunks(2).zip(points).map(|(n, p)| dvec2(n[0], -n[1]).distance(*p));
            assert!(off.fold(0.0, f64::max) <= error - pair.error + 1e-15);
            let letters: String = text.chars().filter(char::is_ascii_alphabetic).collect();
            assert_eq!(letters, format!("M{}Z", "C".repeat(pair.commands())));
        }
    }
}

#[test]
fn numbers_are_short() {
    let written = |value: f64, decimals: usize| {
        let mut text = String::from("M");
        number(&mut text, value, decimals);
        text
    };
    for (value, decimals, text) in
        [(1.5, 3, "M1.5"), (-0.0001, 2, "M0"), (20.0, 2, "M20"), (100.0, 0, "M100"), (-2.25, 2, "M-2.25")]
    {
        assert_eq!(written(value, decimals), text);
    }
}

#[test]
fn tolerances_out_of_range_are_refused() {
    let curves = [star(3, 9, 1.0, 0.1), star(3, 13, 3.0, 0.1)];
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-12, 100.0] {
        let error = path_pair(&curves, &places(20), tolerance).expect_err("refused");
        assert!(matches!(error, PathError::Tolerance { .. }), "{error}");
    }
}

/// Curves of the highest degree with the smallest tolerance stay within the limit or say so, in a moment.
#[test]
fn a_tolerance_out_of_reach_is_refused_in_bounded_time() {
    let curves = [star(32, 400, 1.0, 0.3), star(32, 700, 3.0, 0.2)];
    let start = std::time::Instant::now();
    match path_pair(&curves, &places(600), 2e-8) {
        Ok(pair) => assert!(pair.commands() <= MOST_COMMANDS && pair.error <= 2e-8),
        Err(error) => assert!(matches!(error, PathError::OutOfReach { .. }), "{error}"),
    }
    assert!(start.elapsed().as_secs_f64() < 5.0);
}
