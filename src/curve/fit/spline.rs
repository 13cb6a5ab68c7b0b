//! Cubic splines while they are being fitted: knots that move, pieces that are evaluated by the thousand.

use glam::DVec2;

/// The breaks of a cubic spline over [0, length], open with clamped ends or closed.
#[derive(Debug, Clone)]
pub(super) struct Knots {
    /// Ends of the spans, ascending strictly from 0.
    pub(super) breaks: Vec<f64>,
    /// Whether the spans wrap round.
    pub(super) closed: bool,
    /// The breaks with three more knots on either side.
    extended: Vec<f64>,
}

impl Knots {
    /// Takes at least two breaks, or four for a closed spline.
    pub(super) fn new(breaks: Vec<f64>, closed: bool) -> Self {
        let spans = breaks.len() - 1;
        let length = breaks[spans];
        let count = spans as isize;
        let knot = |i: isize| {
            if closed {
                breaks[i.rem_euclid(count) as usize] + length * i.div_euclid(count) as f64
            } else {
                breaks[i.clamp(0, count) as usize]
            }
        };
        let mut extended: Vec<f64> = (-3..=count + 3).map(knot).collect();
        // Exact, where the sum above would round.
        extended[spans + 3] = length;
        Self { breaks, closed, extended }
    }

    pub(super) fn spans(&self) -> usize {
        self.breaks.len() - 1
    }

    /// Number of control points.
    pub(super) fn controls(&self) -> usize {
        if self.closed { self.spans() } else { self.spans() + 3 }
    }

    pub(super) fn length(&self) -> f64 {
        self.breaks[self.breaks.len() - 1]
    }

    /// Index of the control point that belongs to basis function `j` (0 to 3) of a span.
    pub(super) fn control(&self, span: usize, j: usize) -> usize {
        let index = span + j;
        if self.closed { index % self.spans() } else { index }
    }

    /// The span that holds `u`, looked for from an earlier one on.
    pub(super) fn span_from(&self, mut span: usize, u: f64) -> usize {
        while span + 1 < self.spans() && u >= self.breaks[span + 1] {
            span += 1;
        }
        span
    }

    /// The four basis functions of a span at `u`, by the recurrence of Cox and de Boor.
    pub(super) fn basis(&self, span: usize, u: f64) -> [f64; 4] {
        let t = &self.extended[span..span + 7];
        let mut values = [1.0, 0.0, 0.0, 0.0];
        for degree in 1..=3 {
            let mut saved = 0.0;
            for r in 0..degree {
                let (right, left) = (t[4 + r] - u, u - t[4 + r - degree]);
                let part = values[r] / (right + left);
                values[r] = saved + right * part;
                saved = left * part;
            }
            values[degree] = saved;
        }
        values
    }
}

/// A cubic piece over `[lo, hi]` in Bezier form.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub(super) lo: f64,
    pub(super) hi: f64,
    points: [DVec2; 4],
}

impl Piece {
    /// Value and the first two derivatives by u.
    pub(super) fn derivatives(&self, u: f64) -> (DVec2, DVec2, DVec2) {
        let width = self.hi - self.lo;
        let t = (u - self.lo) / width;
        let [a, b, c, d] = self.points;
        let (ab, bc, cd) = (a.lerp(b, t), b.lerp(c, t), c.lerp(d, t));
        let (abc, bcd) = (ab.lerp(bc, t), bc.lerp(cd, t));
        (abc.lerp(bcd, t), (bcd - abc) * (3.0 / width), (cd - bc * 2.0 + ab) * (6.0 / (width * width)))
    }

    pub(super) fn point(&self, u: f64) -> DVec2 {
        self.derivatives(u).0
    }

    /// Bezier points of the part over `[from, to]`.
    pub(super) fn part(&self, from: f64, to: f64) -> [DVec2; 4] {
        let width = self.hi - self.lo;
        let (x, y) = ((from - self.lo) / width, (to - self.lo) / width);
        let [a, b, c, d] = self.points;
        let at = |r: f64, s: f64, t: f64| {
            let (ab, bc, cd) = (a.lerp(b, r), b.lerp(c, r), c.lerp(d, r));
            ab.lerp(bc, s).lerp(bc.lerp(cd, s), t)
        };
        [at(x, x, x), at(x, x, y), at(x, y, y), at(y, y, y)]
    }

    /// The third derivative by u, constant on a piece.
    fn third(&self) -> DVec2 {
        let [a, b, c, d] = self.points;
        (d - a + (b - c) * 3.0) * (6.0 / (self.hi - self.lo).powi(3))
    }
}

/// A cubic spline: knots, control points, and its pieces.
#[derive(Debug, Clone)]
pub(super) struct Spline {
    pub(super) knots: Knots,
    pub(super) control: Vec<DVec2>,
    pub(super) pieces: Vec<Piece>,
}

impl Spline {
    /// Takes as many control points as the knots ask for.
    pub(super) fn new(knots: Knots, control: Vec<DVec2>) -> Self {
        let piece = |span: usize| {
            let t = &knots.extended[span..span + 7];
            let (a, b) = (t[3], t[4]);
            let [p, q, r, s] = [0, 1, 2, 3].map(|j| control[knots.control(span, j)]);
            let first = q.lerp(r, (a - t[2]) / (t[5] - t[2]));
            let second = q.lerp(r, (b - t[2]) / (t[5] - t[2]));
            let before = p.lerp(q, (a - t[1]) / (b - t[1]));
            let after = r.lerp(s, (b - a) / (t[6] - a));
            let start = before.lerp(first, (a - t[2]) / (b - t[2]));
            let end = second.lerp(after, (b - a) / (t[5] - a));
            Piece { lo: a, hi: b, points: [start, first, second, end] }
        };
        let pieces = (0..knots.spans()).map(piece).collect();
        Self { knots, control, pieces }
    }

    /// Size of the jump of the third derivative at the start of each span; zero at the ends of an open spline.
    pub(super) fn jumps(&self) -> Vec<f64> {
        let count = self.pieces.len();
        let jump = |span: usize| {
            if span == 0 && !self.knots.closed {
                return 0.0;
            }
            let before = &self.pieces[(span + count - 1) % count];
            before.third().distance(self.pieces[span].third())
        };
        (0..count).map(jump).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::{BSpline, Form};

    #[test]
    fn pieces_and_basis_are_those_of_the_checked_curve() {
        let points: Vec<_> =
            (0..6).map(|k| DVec2::from_angle(f64::from(k)) * (1.0 + 0.3 * f64::from(k % 2))).collect();
        let breaks = vec![0.0, 0.1, 0.35, 0.4, 0.7, 0.85, 1.0];
        let curve = BSpline::new(3, Form::Periodic, points.clone(), Some(breaks.clone())).unwrap();
        let spline = Spline::new(Knots::new(breaks, true), points);
        for i in 0..200 {
            let u = f64::from(i) / 200.0;
            let span = spline.knots.span_from(0, u);
            let derivatives = curve.derivatives(u, 3);
            let (value, first, second) = spline.pieces[span].derivatives(u);
            assert!(value.distance(derivatives[0]) < 1e-14);
            assert!(first.distance(derivatives[1]) < 1e-12);
            assert!(second.distance(derivatives[2]) < 1e-10);
            assert!(spline.pieces[span].third().distance(derivatives[3]) < 1e-8);
            let basis = spline.knots.basis(span, u);
            let sum = (0..4).map(|j| spline.control[spline.knots.control(span, j)] * basis[j]).sum::<DVec2>();
            assert!(sum.distance(value) < 1e-14);
            let part = spline.pieces[span].part(u, spline.pieces[span].hi);
            assert!(
                part[0].distance(value) < 1e-14
                    && part[3].distance(curve.point(spline.pieces[span].hi)) < 1e-14
            );
        }
    }

    #[test]
    fn an_open_spline_starts_and_ends_in_its_end_points() {
        let control: Vec<_> = (0..6).map(|k| DVec2::new(f64::from(k), f64::from(k * k))).collect();
        let spline = Spline::new(Knots::new(vec![0.0, 0.5, 0.75, 2.0], false), control.clone());
        assert!(spline.pieces[0].point(0.0).distance(control[0]) < 1e-14);
        assert!(spline.pieces[2].point(2.0).distance(control[5]) < 1e-14);
        assert_eq!(spline.jumps()[0], 0.0);
    }
}
