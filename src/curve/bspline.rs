//! The planar B-spline curve.

use glam::DVec2;

use super::basis::{MAX_DEGREE, Span};
use super::bezier::Bezier;
use super::error::CurveError;
use super::knots;
use crate::geom::{Bounds, GaussLegendre};

/// Most control points of a curve. It bounds the time of every query on a curve somebody else wrote.
const MAX_POINTS: usize = 2000;
/// Largest absolute value of a coordinate; products of four coordinates stay far from overflow.
const LARGEST_COORDINATE: f64 = 1e12;
/// A curve whose control points lie closer together than this, relative to their coordinates, is one point:
/// rounding would leave it fewer than four digits.
const SMALLEST_RELATIVE_SIZE: f64 = 1e-12;
/// Smallest size of a curve; below it squared lengths would underflow.
const SMALLEST_SIZE: f64 = 1e-60;

/// Whether and how a curve closes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Form {
    /// The control points wrap around; the seam is as smooth as every other knot.
    Periodic,
    /// The curve starts and ends in its first control point, which is repeated as the last one. The seam may be a corner.
    Clamped,
    /// The curve runs from its first control point to its last one and does not close.
    Open,
}

/// A planar B-spline curve, checked once and never changed; it closes unless its form is [`Form::Open`].
///
/// Guarantees: degree 2 to 32; at least degree + 1 and at most 2000 control points, finite, at most 1e12 in
/// absolute value, not all coincident; knots ascending, at most 1e12 in absolute value, over a domain of
/// positive length; no knot so often that the curve would have a gap. Corners are allowed and can be listed. It
/// may intersect itself; that is a separate question.
///
/// The parameter u lies in the knot domain `[lo, hi)`. A u outside is wrapped into it; one that is not finite
/// counts as lo. On an open curve it lies in `[lo, hi]`, and a u outside counts as the nearer end.
///
/// # Examples
/// ```
/// use directrix::curve::{BSpline, Form};
/// let square = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(glam::DVec2::from).to_vec();
/// let curve = BSpline::new(3, Form::Periodic, square, None)?;
/// assert!(curve.signed_area() > 0.0);
/// # Ok::<(), directrix::curve::CurveError>(())
/// ```
///
/// # References
/// C. de Boor, *A Practical Guide to Splines* (1978).
#[derive(Debug, Clone, PartialEq)]
pub struct BSpline {
    degree: usize,
    form: Form,
    /// Control points; a periodic curve repeats the first `degree` ones at the end.
    control: Vec<DVec2>,
    knots: Vec<f64>,
}

impl BSpline {
    /// Checks control points and knots and makes the curve.
    ///
    /// Periodic curves take their distinct control points, n of them, and either all n + 2 degree + 1 knots,
    /// whose spacing must repeat with the period, or the n + 1 knots of the domain. Clamped curves take m
    /// points, the last equal to the first, and m + degree + 1 knots, the first and the last degree + 1 of them
    /// equal. Open curves take the same, with the last point anywhere. `None` means uniform knots over the domain [0, 1]. Knots closer together than about 1e-10 of the
    /// domain become equal.
    ///
    /// # Errors
    /// The first rule that is broken; see [`CurveError`].
    pub fn new(
        degree: usize,
        form: Form,
        mut points: Vec<DVec2>,
        knots: Option<Vec<f64>>,
    ) -> Result<Self, CurveError> {
        if !(2..=MAX_DEGREE).contains(&degree) {
            return Err(CurveError::Degree { degree });
        }
        let count = points.len();
        check_points(degree, &points)?;
        if form == Form::Clamped && points[0] != points[count - 1] {
            return Err(CurveError::NotClosed { first: points[0], last: points[count - 1] });
        }
        let knots = match (form, knots) {
            (Form::Periodic, None) => knots::uniform_periodic(degree, count),
            (Form::Clamped | Form::Open, None) => knots::uniform_clamped(degree, count),
            (Form::Periodic, Some(given)) => knots::periodic(degree, count, &given)?,
            (Form::Clamped | Form::Open, Some(given)) => knots::clamped(degree, count, &given)?,
        };
        if form == Form::Periodic {
            points.extend_from_within(..degree);
        }
        Ok(Self { degree, form, control: points, knots })
    }

    /// Makes a curve from checked control points, given as to [`new`](Self::new), and its full knot vector.
    pub(super) fn from_checked(degree: usize, form: Form, mut points: Vec<DVec2>, knots: Vec<f64>) -> Self {
        if form == Form::Periodic {
            points.extend_from_within(..degree);
        }
        Self { degree, form, control: points, knots }
    }

    /// The curve with the same knots through as many other control points, which are not checked.
    #[cfg(feature = "solid")]
    pub(crate) fn with_points(&self, points: Vec<DVec2>) -> Self {
        Self::from_checked(self.degree, self.form, points, self.knots.clone())
    }

    /// Degree of the polynomial pieces.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Whether and how the curve closes.
    #[must_use]
    pub fn form(&self) -> Form {
        self.form
    }

    /// Tells whether the end of the domain is its start again.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.form != Form::Open
    }

    /// Control points as given: the distinct ones of a periodic curve, all of a clamped one.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        match self.form {
            Form::Periodic => &self.control[..self.control.len() - self.degree],
            Form::Clamped | Form::Open => &self.control,
        }
    }

    /// The full knot vector in use.
    #[must_use]
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// The knot domain: start, and end, which is the start again where the curve closes.
    #[must_use]
    pub fn domain(&self) -> (f64, f64) {
        (self.knots[self.degree], self.knots[self.control.len()])
    }

    /// Value at u.
    #[must_use]
    pub fn point(&self, u: f64) -> DVec2 {
        let u = self.wrap(u);
        self.span(self.span_index(u)).point(u)
    }

    /// First derivative by u; from the right at knots where it jumps.
    #[must_use]
    pub fn derivative(&self, u: f64) -> DVec2 {
        self.derivative_and_scale(u).0
    }

    /// Value, first derivative, and so on up to the given order, by u and from the right: `order + 1` vectors.
    ///
    /// Orders above the degree are zero. A high order on very short spans may leave the range of `f64`.
    #[must_use]
    pub fn derivatives(&self, u: f64, order: usize) -> Vec<DVec2> {
        let u = self.wrap(u);
        self.span(self.span_index(u)).derivatives(u, order)
    }

    /// Derivative at u, and the length of the largest control vector of the derivative on that span.
    pub(super) fn derivative_and_scale(&self, u: f64) -> (DVec2, f64) {
        let u = self.wrap(u);
        self.span(self.span_index(u)).derivative(u)
    }

    /// Signed area inside: positive when the curve runs counter-clockwise. Parts wound several times count as often.
    ///
    /// Green's theorem; the integrand is a polynomial of degree 2 p - 1 on each span, so Gauss quadrature with p
    /// nodes is exact up to rounding, about 1e-14 of the square of the size.
    #[must_use]
    pub fn signed_area(&self) -> f64 {
        let rule = GaussLegendre::new(self.degree);
        let sector = |piece: &Bezier| {
            let velocity = piece.hodograph();
            rule.integrate(0.0, 1.0, |t| piece.point(t).perp_dot(velocity.point(t)))
        };
        self.pieces(self.bounds().center()).iter().map(sector).sum::<f64>() / 2.0
    }

    /// The same curve run through the other way: the point at u is that of the original at lo + hi - u.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let (lo, hi) = self.domain();
        let mirror = |&u: &f64| {
            if u == lo {
                hi
            } else if u == hi {
                lo
            } else {
                lo + (hi - u)
            }
        };
        let knots = self.knots.iter().rev().map(mirror).collect();
        let control = self.control.iter().rev().copied().collect();
        Self { degree: self.degree, form: self.form, control, knots }
    }

    /// Box of the control points; it holds the curve.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        Bounds::around(self.control[0], self.control[1..].iter().copied())
    }

    /// The parameter in `[lo, hi)` of the same point; on an open curve the nearest one in `[lo, hi]`.
    pub(super) fn wrap(&self, u: f64) -> f64 {
        let (lo, hi) = self.domain();
        if !self.is_closed() {
            return if u.is_nan() { lo } else { u.clamp(lo, hi) };
        }
        if (lo..hi).contains(&u) {
            return u;
        }
        let wrapped = lo + (u - lo).rem_euclid(hi - lo);
        if (lo..hi).contains(&wrapped) { wrapped } else { lo }
    }

    /// Index of the knot at the start of the non-empty span that holds u in `[lo, hi)`; the last such span at hi.
    pub(super) fn span_index(&self, u: f64) -> usize {
        let inner = &self.knots[self.degree..=self.control.len()];
        let hi = inner[inner.len() - 1];
        self.degree + inner.partition_point(|&knot| knot <= u && knot < hi) - 1
    }

    /// The Bezier pieces of the non-empty spans in ascending order, relative to `origin`.
    pub(super) fn pieces(&self, origin: DVec2) -> Vec<Bezier> {
        (self.degree..self.control.len()).filter_map(|k| self.piece(k, origin)).collect()
    }

    /// The Bezier piece of the span that starts at knot `index` inside the domain, unless the span is empty.
    pub(super) fn piece(&self, index: usize, origin: DVec2) -> Option<Bezier> {
        let (lo, hi) = (self.knots[index], self.knots[index + 1]);
        (lo < hi).then(|| Bezier { points: self.span(index).bezier(origin), lo, hi })
    }

    fn span(&self, index: usize) -> Span<'_> {
        Span::new(self.degree, &self.knots, &self.control, index)
    }
}

/// Checks number, size and spread of the control points.
fn check_points(degree: usize, points: &[DVec2]) -> Result<(), CurveError> {
    let count = points.len();
    if count < degree + 1 {
        return Err(CurveError::TooFewPoints { count, needed: degree + 1 });
    }
    if count > MAX_POINTS {
        return Err(CurveError::TooManyPoints { count, limit: MAX_POINTS });
    }
    let mut largest = 0.0_f64;
    let mut spread = 0.0_f64;
    for (index, &point) in points.iter().enumerate() {
        if !point.is_finite() {
            return Err(CurveError::PointNotFinite { index, point });
        }
        let size = point.abs().max_element();
        if size > LARGEST_COORDINATE {
            return Err(CurveError::PointTooLarge { index, point, limit: LARGEST_COORDINATE });
        }
        largest = largest.max(size);
        spread = spread.max((point - points[0]).abs().max_element());
    }
    if spread <= SMALLEST_SIZE.max(SMALLEST_RELATIVE_SIZE * largest) {
        return Err(CurveError::ZeroLength { at: points[0] });
    }
    Ok(())
}

/// Whether one more control point is allowed.
pub(super) fn check_room(count: usize) -> Result<(), CurveError> {
    if count < MAX_POINTS {
        Ok(())
    } else {
        Err(CurveError::TooManyPoints { count: count + 1, limit: MAX_POINTS })
    }
}
