//! Evaluation of a B-spline on one knot span.
//!
//! # References
//! C. de Boor, *A Practical Guide to Splines* (1978), chapter X; W. Boehm, "Inserting new knots into B-spline
//! curves", *Computer-Aided Design* 12 (1980), from which the Bezier form of a span follows.

use glam::DVec2;

/// Largest degree; it bounds the size of the working arrays on the stack.
pub(super) const MAX_DEGREE: usize = 32;

/// The part of a B-spline that decides its values on one knot span.
#[derive(Debug, Clone, Copy)]
pub(super) struct Span<'a> {
    degree: usize,
    /// All knots.
    knots: &'a [f64],
    /// Index of the knot at the start of the span; the next knot is larger.
    index: usize,
    /// The degree + 1 control points of the span.
    points: &'a [DVec2],
}

impl<'a> Span<'a> {
    /// The span from `knots[index]` to `knots[index + 1]`; `control` are all control points, wrapped ones included.
    pub(super) fn new(degree: usize, knots: &'a [f64], control: &'a [DVec2], index: usize) -> Self {
        Self { degree, knots, index, points: &control[index - degree..=index] }
    }

    /// Value of the curve at `u` in the span.
    pub(super) fn point(&self, u: f64) -> DVec2 {
        let mut work = self.load();
        self.evaluate(&mut work, 0, u)
    }

    /// First derivative at `u`, and the largest length among the control vectors of the derivative.
    pub(super) fn derivative(&self, u: f64) -> (DVec2, f64) {
        let mut work = self.load();
        self.differentiate(&mut work, 1);
        let largest = work[1..=self.degree].iter().fold(0.0_f64, |m, v| m.max(v.length_squared())).sqrt();
        (self.evaluate(&mut work, 1, u), largest)
    }

    /// Value and derivatives at `u` up to `order`; those above the degree are zero.
    pub(super) fn derivatives(&self, u: f64, order: usize) -> Vec<DVec2> {
        let mut control = self.load();
        let mut result = vec![DVec2::ZERO; order + 1];
        for (k, value) in result.iter_mut().enumerate().take(self.degree + 1) {
            if k > 0 {
                self.differentiate(&mut control, k);
            }
            *value = self.evaluate(&mut control.clone(), k, u);
        }
        result
    }

    /// Bezier control points of the span, relative to `origin`.
    ///
    /// With the blossom f, the control points are f(u_(i+1), ..., u_(i+p)). A first pass moves all knots left of
    /// the span to its start a, a second one all knots right of it to its end b, which leaves f(a, .., a, b, .., b).
    /// Every step is a convex combination.
    pub(super) fn bezier(&self, origin: DVec2) -> Vec<DVec2> {
        let (p, k) = (self.degree, self.index);
        let (a, b) = (self.knots[k], self.knots[k + 1]);
        let mut work = self.load();
        work[..=p].iter_mut().for_each(|point| *point -= origin);
        let mut left = vec![work[p]; p + 1];
        for r in 1..=p {
            self.step(&mut work, 0, r, a);
            left[p - r] = work[p];
        }
        for r in 0..p {
            for j in (r + 1..=p).rev() {
                let t = (b - a) / (self.knots[k + j - r] - a);
                left[j] = left[j - 1] * (1.0 - t) + left[j] * t;
            }
        }
        left
    }

    fn load(&self) -> [DVec2; MAX_DEGREE + 1] {
        let mut work = [DVec2::ZERO; MAX_DEGREE + 1];
        work[..=self.degree].copy_from_slice(self.points);
        work
    }

    /// Turns the control points of derivative `order - 1`, at `order - 1..=degree`, into those of derivative `order`.
    fn differentiate(&self, work: &mut [DVec2], order: usize) {
        let p = self.degree;
        for j in (order..=p).rev() {
            let i = self.index - p + j;
            let width = self.knots[i + p + 1 - order] - self.knots[i];
            work[j] = (work[j] - work[j - 1]) * ((p + 1 - order) as f64 / width);
        }
    }

    /// De Boor's algorithm on the control points of derivative `order`.
    fn evaluate(&self, work: &mut [DVec2], order: usize, u: f64) -> DVec2 {
        for r in 1..=self.degree - order {
            self.step(work, order, r, u);
        }
        work[self.degree]
    }

    /// Step `r` of de Boor's algorithm on the control points of derivative `order`.
    fn step(&self, work: &mut [DVec2], order: usize, r: usize, u: f64) {
        let p = self.degree;
        for j in (order + r..=p).rev() {
            let i = self.index - p + j;
            let t = (u - self.knots[i]) / (self.knots[i + p + 1 - order - r] - self.knots[i]);
            work[j] = work[j - 1] * (1.0 - t) + work[j] * t;
        }
    }
}
