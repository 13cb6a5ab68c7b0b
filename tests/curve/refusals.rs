//! Every refusal, with its message.

use directrix::curve::{BSpline, CurveError, Form};
use glam::DVec2;

use super::support::try_curve;

const SQUARE: [(f64, f64); 4] = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
const CLOSED: [(f64, f64); 5] = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0), (1.0, 1.0)];

/// The message of the refusal, after a check that the debug form names the variant.
#[track_caller]
fn refusal(variant: &str, degree: usize, form: Form, points: &[(f64, f64)], knots: Option<&[f64]>) -> String {
    let error = try_curve(degree, form, points, knots).unwrap_err();
    assert!(format!("{error:?}").starts_with(variant), "{error:?}");
    error.to_string()
}

#[test]
fn degrees_and_numbers_of_points() {
    for degree in [0, 1, 33, usize::MAX] {
        let message = refusal("Degree", degree, Form::Periodic, &SQUARE, None);
        assert_eq!(message, format!("degree is {degree}; expected 2 to 32"));
    }
    for count in 0..=3 {
        let message = refusal("TooFewPoints", 3, Form::Periodic, &SQUARE[..count], None);
        assert_eq!(message, format!("{count} control points; expected at least degree + 1 = 4"));
        refusal("TooFewPoints", 3, Form::Clamped, &SQUARE[..count], None);
    }
    assert!(try_curve(3, Form::Periodic, &SQUARE, None).is_ok());
    let many: Vec<_> = (0..2001).map(|i| (f64::from(i), 0.0)).collect();
    let message = refusal("TooManyPoints", 3, Form::Periodic, &many, None);
    assert_eq!(message, "2001 control points; expected at most 2000");
}

#[test]
fn coordinates() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut points = SQUARE;
        points[2].1 = bad;
        let message = refusal("PointNotFinite", 2, Form::Periodic, &points, None);
        assert_eq!(message, format!("control point 2 is (-1, {bad}); expected finite coordinates"));
    }
    let mut points = SQUARE;
    points[1].0 = 2e12;
    let message = refusal("PointTooLarge", 2, Form::Periodic, &points, None);
    assert_eq!(
        message,
        "control point 1 is (2e12, 1); expected coordinates of at most 1e12 in absolute value"
    );
}

#[test]
fn zero_length() {
    for point in [(0.0, 0.0), (2.5, -1.0)] {
        let message = refusal("ZeroLength", 3, Form::Periodic, &[point; 6], None);
        let place = format!("({}, {})", point.0, point.1);
        assert_eq!(
            message,
            format!("all control points lie at {place}; expected a curve of positive length")
        );
    }
    let nearly = [(1e6, 1.0), (1e6 + 1e-8, 1.0), (1e6, 1.0 + 1e-8)];
    refusal("ZeroLength", 2, Form::Clamped, &nearly, None);
}

#[test]
fn ends_of_clamped_curves() {
    let message = refusal("NotClosed", 3, Form::Clamped, &SQUARE, None);
    assert_eq!(
        message,
        "the last control point is (1, -1); expected the first one, (1, 1), since the curve is clamped"
    );
    let knots = [0.0, 0.0, 0.1, 0.5, 0.7, 1.0, 1.0, 1.0];
    let message = refusal("KnotsNotClamped", 2, Form::Clamped, &CLOSED, Some(&knots));
    assert_eq!(message, "knot 0 is 0; expected 0.1, the end of the domain of a clamped curve");
    let knots = [0.0, 0.0, 0.0, 0.5, 0.7, 1.0, 1.0, 1.5];
    let message = refusal("KnotsNotClamped", 2, Form::Clamped, &CLOSED, Some(&knots));
    assert_eq!(message, "knot 7 is 1.5; expected 1, the end of the domain of a clamped curve");
}

#[test]
fn numbers_of_knots() {
    let message = refusal("KnotCount", 2, Form::Periodic, &SQUARE, Some(&[0.0, 1.0, 2.0]));
    assert_eq!(message, "3 knots; expected 9, or the 5 knots of the domain");
    let message = refusal("KnotCount", 2, Form::Clamped, &CLOSED, Some(&[]));
    assert_eq!(message, "0 knots; expected 8");
}

#[test]
fn values_of_knots() {
    for (bad, shown) in [(f64::NAN, "NaN"), (f64::INFINITY, "inf"), (1e13, "1e13")] {
        let knots = [0.0, 1.0, 2.0, bad, 4.0];
        let message = refusal("KnotNotFinite", 2, Form::Periodic, &SQUARE, Some(&knots));
        assert_eq!(
            message,
            format!("knot 3 is {shown}; expected a number of at most 1e12 in absolute value")
        );
    }
    let message = refusal("KnotsDecrease", 2, Form::Periodic, &SQUARE, Some(&[0.0, 2.0, 1.0, 3.0, 4.0]));
    assert_eq!(message, "knot 2 is 1; expected at least the knot before it, 2");
    let message = refusal("EmptyDomain", 2, Form::Periodic, &SQUARE, Some(&[5.0; 5]));
    assert_eq!(message, "the knots span the domain [5, 5]; expected a length of at least 5e-6");
    refusal("EmptyDomain", 2, Form::Clamped, &CLOSED, Some(&[0.0; 8]));
    refusal("EmptyDomain", 2, Form::Periodic, &SQUARE, Some(&[0.0, 1e-14, 2e-14, 3e-14, 4e-14]));
    let mut knots = [-2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.5];
    let message = refusal("KnotsNotPeriodic", 2, Form::Periodic, &SQUARE, Some(&knots));
    assert_eq!(message, "knot 8 is 6.5; expected 6, since the spacing repeats with the period");
    knots[8] = 6.0;
    knots[1] = -1.25;
    let message = refusal("KnotsNotPeriodic", 2, Form::Periodic, &SQUARE, Some(&knots));
    assert_eq!(message, "knot 1 is -1.25; expected -1, since the spacing repeats with the period");
}

#[test]
fn multiplicity_above_the_degree() {
    let five = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (0.0, -2.0), (1.0, -1.0)];
    let inside = [0.0, 0.5, 0.5, 0.5, 0.7, 1.0];
    let message = refusal("Multiplicity", 2, Form::Periodic, &five, Some(&inside));
    assert_eq!(message, "knot 1, 0.5, occurs 3 times; expected at most 2 times");
    // The two ends of the domain are one knot.
    let seam = [0.0, 0.0, 0.5, 0.7, 1.0, 1.0];
    let message = refusal("Multiplicity", 2, Form::Periodic, &five, Some(&seam));
    assert_eq!(message, "knot 0, 0, occurs 3 times; expected at most 2 times");
    let full_seam = [0.0, 0.0, 0.3, 0.5, 0.7, 1.0];
    assert!(try_curve(2, Form::Periodic, &five, Some(&full_seam)).is_ok());
    let closed = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (0.0, -2.0), (1.0, -1.0), (1.0, 1.0)];
    let inside = [0.0, 0.0, 0.0, 0.5, 0.5, 0.5, 1.0, 1.0, 1.0];
    let message = refusal("Multiplicity", 2, Form::Clamped, &closed, Some(&inside));
    assert_eq!(message, "knot 3, 0.5, occurs 3 times; expected at most 2 times");
    let end = [0.0, 0.0, 0.0, 0.0, 0.5, 0.6, 1.0, 1.0, 1.0];
    let message = refusal("Multiplicity", 2, Form::Clamped, &closed, Some(&end));
    assert_eq!(message, "knot 0, 0, occurs 4 times; expected at most 3 times");
}

#[test]
fn knots_that_cannot_be_inserted() {
    let square = try_curve(2, Form::Periodic, &SQUARE, None).unwrap();
    let message = square.insert_knot(f64::INFINITY).unwrap_err().to_string();
    assert_eq!(message, "the parameter is inf; expected a finite number");
    let full = square.insert_knot(0.25).unwrap();
    let message = full.insert_knot(0.25 + 1e-13).unwrap_err().to_string();
    assert_eq!(message, "the knot 0.25 is there 2 times; expected fewer than the degree, 2, for another one");
    let circle = (0..2000).map(|i| DVec2::from_angle(f64::from(i) / 320.0)).collect();
    let full = BSpline::new(2, Form::Periodic, circle, None).unwrap();
    assert_eq!(full.insert_knot(0.3), Err(CurveError::TooManyPoints { count: 2001, limit: 2000 }));
}

#[test]
fn errors_are_errors() {
    fn takes_error(_: &dyn std::error::Error) {}
    takes_error(&try_curve(1, Form::Periodic, &SQUARE, None).unwrap_err());
}
