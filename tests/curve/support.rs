//! Curves to test with, and slow independent evaluation.

use directrix::curve::{BSpline, CurveError, Form};
use glam::DVec2;

/// Makes a curve from pairs of numbers.
pub(crate) fn try_curve(
    degree: usize,
    form: Form,
    points: &[(f64, f64)],
    knots: Option<&[f64]>,
) -> Result<BSpline, CurveError> {
    let points = points.iter().copied().map(DVec2::from).collect();
    BSpline::new(degree, form, points, knots.map(<[f64]>::to_vec))
}

/// A curve whose numbers are known to be right.
pub(crate) fn curve(degree: usize, form: Form, points: &[(f64, f64)], knots: Option<&[f64]>) -> BSpline {
    try_curve(degree, form, points, knots).unwrap()
}

/// A periodic curve with uniform knots.
pub(crate) fn periodic(degree: usize, points: &[(f64, f64)]) -> BSpline {
    curve(degree, Form::Periodic, points, None)
}

/// A clamped curve with the corners of a polygon for control points, each as often as the degree: the polygon itself.
pub(crate) fn polygon(degree: usize, corners: &[(f64, f64)]) -> BSpline {
    let repeated: Vec<_> = corners.iter().flat_map(|&c| vec![c; degree]).collect();
    periodic(degree, &repeated)
}

/// Fourteen points round an irregular blob, counter-clockwise, scaled and moved.
pub(crate) fn blob(scale: f64, shift: DVec2) -> Vec<DVec2> {
    let radii = [1.0, 1.2, 0.9, 1.1, 1.4, 1.0, 0.8, 1.1, 1.3, 0.9, 1.0, 1.2, 0.7, 0.9];
    let turn = std::f64::consts::TAU / radii.len() as f64;
    let point = |(i, r): (usize, &f64)| shift + DVec2::from_angle(turn * i as f64) * (scale * r);
    radii.iter().enumerate().map(point).collect()
}

/// Different kinds of curves: both forms, several degrees, even and uneven knots, corners.
pub(crate) fn variety() -> Vec<BSpline> {
    let ring = [(3.0, 0.5), (1.0, 2.0), (-2.0, 1.5), (-2.5, -1.0), (0.5, -2.0), (2.0, -1.5), (2.5, -1.0)];
    let closed: Vec<_> = ring.iter().chain(&ring[..1]).copied().collect();
    let uneven = [2.0, 2.5, 2.5, 3.5, 5.0, 5.25, 6.0, 8.0];
    let clamped_knots = [-1.0, -1.0, -1.0, -1.0, 0.0, 0.5, 0.5, 0.5, 2.0, 2.0, 2.0, 2.0];
    let mut curves: Vec<_> = (2..=6).map(|degree| periodic(degree, &ring)).collect();
    curves.extend((2..=7).map(|degree| curve(degree, Form::Clamped, &closed, None)));
    curves.extend((2..=6).map(|degree| curve(degree, Form::Periodic, &ring, Some(&uneven))));
    curves.push(curve(3, Form::Clamped, &closed, Some(&clamped_knots)));
    curves.push(polygon(3, &[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)]));
    curves.push(BSpline::new(12, Form::Periodic, blob(2.0, DVec2::new(5.0, -3.0)), None).unwrap());
    let many = (0..40).map(|i| DVec2::from_angle(f64::from(i) * 0.157) * (2.0 + f64::from(i % 3))).collect();
    curves.push(BSpline::new(32, Form::Periodic, many, None).unwrap());
    curves
}

/// Basis function of Cox and de Boor by their recursion, with 0/0 = 0; `last` is the end of the domain.
pub(crate) fn basis(knots: &[f64], i: usize, degree: usize, u: f64) -> f64 {
    if degree == 0 {
        return f64::from(knots[i] <= u && u < knots[i + 1]);
    }
    let part = |a: f64, b: f64| if b == 0.0 { 0.0 } else { a / b };
    part(u - knots[i], knots[i + degree] - knots[i]) * basis(knots, i, degree - 1, u)
        + part(knots[i + degree + 1] - u, knots[i + degree + 1] - knots[i + 1])
            * basis(knots, i + 1, degree - 1, u)
}

/// Value of a curve as the sum of all its basis functions times its control points.
pub(crate) fn slow_point(curve: &BSpline, u: f64) -> DVec2 {
    let (knots, points) = (curve.knots(), curve.points());
    let count = knots.len() - curve.degree() - 1;
    (0..count).map(|i| points[i % points.len()] * basis(knots, i, curve.degree(), u)).sum()
}

/// Parameters spread over the domain that avoid its ends.
pub(crate) fn spread(curve: &BSpline, count: usize) -> impl Iterator<Item = f64> + use<> {
    let (lo, hi) = curve.domain();
    (0..count).map(move |i| lo + (hi - lo) * (i as f64 + 0.37) / count as f64)
}

/// Fails unless the points are closer than `allowed`, and says by how much.
#[track_caller]
pub(crate) fn assert_near(a: DVec2, b: DVec2, allowed: f64) {
    let gap = a.distance(b);
    assert!(gap <= allowed, "{a} and {b} differ by {gap:e}, allowed {allowed:e}");
}

/// Fails unless the numbers differ by at most `allowed`, and says by how much.
#[track_caller]
pub(crate) fn assert_close(a: f64, b: f64, allowed: f64) {
    let gap = (a - b).abs();
    assert!(gap <= allowed, "{a} and {b} differ by {gap:e}, allowed {allowed:e}");
}
