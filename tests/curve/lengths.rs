//! Arc length and its inverse.

use directrix::curve::Form;

use super::support::{assert_close, assert_near, curve, periodic, polygon, variety};

/// Length between parameters by Romberg's scheme on the speed, knot span by knot span, with the one-sided
/// derivative taken just inside: independent of Gauss nodes and of the pieces the library uses.
fn romberg_length(curve: &directrix::curve::BSpline, a: f64, b: f64) -> f64 {
    let mut cuts: Vec<f64> = curve.knots().iter().copied().filter(|k| a < *k && *k < b).collect();
    cuts.insert(0, a);
    cuts.push(b);
    cuts.dedup();
    let speed = |u: f64| curve.derivative(u).length();
    cuts.windows(2)
        .map(|w| {
            let (a, b) = (w[0], w[1] - 1e-15 * (w[1].abs() + (w[1] - w[0])));
            let mut row = vec![(b - a) * (speed(a) + speed(b)) / 2.0];
            for level in 1..=11 {
                let n = 1_usize << level;
                let h = (b - a) / n as f64;
                let odd: f64 = (1..n).step_by(2).map(|i| speed(a + h * i as f64)).sum();
                let mut next = vec![row[0] / 2.0 + h * odd];
                for (k, before) in row.iter().enumerate() {
                    let factor = 4_f64.powi(k as i32 + 1);
                    next.push((factor * next[k] - before) / (factor - 1.0));
                }
                row = next;
            }
            row[row.len() - 1]
        })
        .sum()
}

#[test]
fn polygons_have_the_length_of_their_sides() {
    for degree in 2..=5 {
        let square = polygon(degree, &[(0.0, 0.0), (3.0, 0.0), (3.0, 4.0)]);
        assert_close(square.length(), 12.0, 1e-12);
    }
    // Far from the origin nothing is lost.
    let far = polygon(3, &[(1e9, 0.0), (1e9 + 3.0, 0.0), (1e9 + 3.0, 4.0)]);
    assert_close(far.length(), 12.0, 1e-11);
}

#[test]
fn a_parabola_has_its_known_length() {
    // One clamped quadratic piece and two straight ones. (2 t - 1, (2 t - 1)^2): length sqrt(5) + asinh(2) / 2.
    let points = [(-1.0, 1.0), (0.0, -1.0), (1.0, 1.0), (0.5, 2.0), (0.0, 3.0), (-0.5, 2.0), (-1.0, 1.0)];
    let knots = [0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 3.0];
    let curve = curve(2, Form::Clamped, &points, Some(&knots));
    let parabola = 5.0_f64.sqrt() + 2.0_f64.asinh() / 2.0;
    let length = curve.arc_length();
    assert_close(length.at(1.0), parabola, 1e-13);
    assert_close(length.total(), parabola + 2.0 * 5.0_f64.sqrt(), 1e-13);
    assert_close(length.parameter(parabola / 2.0), 0.5, 1e-13);
    assert_close(
        length.at(0.75) - length.at(0.5),
        (2.0_f64.sqrt() / 2.0 + 1.0_f64.asinh() / 2.0) / 2.0,
        1e-13,
    );
}

#[test]
fn cusps_lose_no_length() {
    // (t^2, t^3) for t in [-1, 1]: twice (13 sqrt(13) - 8) / 27, with a cusp that no knot marks.
    let cusp = [(1.0, -1.0), (-1.0 / 3.0, 1.0), (-1.0 / 3.0, -1.0), (1.0, 1.0)];
    let mut points = cusp.to_vec();
    points.extend([(1.0, 0.5), (1.0, -0.5), (1.0, -1.0)]);
    let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0];
    let curve = curve(3, Form::Clamped, &points, Some(&knots));
    let exact = 2.0 * (13.0 * 13.0_f64.sqrt() - 8.0) / 27.0;
    assert_close(curve.arc_length().at(1.0), exact, 1e-12);
}

#[test]
fn lengths_agree_with_independent_quadrature() {
    for curve in variety() {
        let (lo, hi) = curve.domain();
        let length = curve.arc_length();
        assert_close(length.total(), romberg_length(&curve, lo, hi), 2e-11 * length.total());
        let middle = lo + 0.61 * (hi - lo);
        assert_close(length.at(middle), romberg_length(&curve, lo, middle), 2e-11 * length.total());
        assert_close(curve.length(), length.total(), 0.0);
    }
}

#[test]
fn the_inverse_finds_the_parameter() {
    for curve in variety() {
        let (lo, hi) = curve.domain();
        let length = curve.arc_length();
        assert_eq!((length.at(lo), length.at(hi)), (0.0, length.total()));
        assert_eq!((length.parameter(0.0), length.parameter(length.total())), (lo, hi));
        let mut before = lo;
        for i in 1..500 {
            let s = length.total() * f64::from(i) / 500.0;
            let u = length.parameter(s);
            assert!(before < u && u < hi, "{before} {u}");
            before = u;
            assert_close(length.at(u), s, 1e-12 * length.total());
        }
    }
}

#[test]
fn whole_turns_are_counted() {
    let curve = periodic(3, &[(3.0, 0.5), (1.0, 2.0), (-2.0, 1.5), (-2.5, -1.0), (0.5, -2.0)]);
    let length = curve.arc_length();
    let (total, s) = (length.total(), 0.3 * length.total());
    assert_close(length.at(0.4 + 2.0), length.at(0.4) + 2.0 * total, 1e-12);
    assert_close(length.at(0.4 - 1.0), length.at(0.4) - total, 1e-12);
    assert_close(length.parameter(s + total), length.parameter(s) + 1.0, 1e-12);
    assert_close(length.parameter(s - 3.0 * total), length.parameter(s) - 3.0, 1e-12);
    assert_near(curve.point(length.parameter(s + total)), curve.point(length.parameter(s)), 1e-11);
}
