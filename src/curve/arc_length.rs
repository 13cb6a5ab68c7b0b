//! Arc length of a curve and its inverse.

use glam::DVec2;

use super::bezier::Bezier;
use super::bspline::BSpline;
use crate::geom::GAUSS_16;

/// An interval is halved until 16 Gauss nodes on it and on its halves agree to this part of the length of the
/// control polygon. Tighter would chase rounding noise; looser would show in equal spacing.
const PANEL_TOLERANCE: f64 = 1e-14;
/// Most halvings of a knot span. Only cusps need more than a few, and there the length left over is below
/// 2^-40 of the span.
const MAX_DEPTH: usize = 40;
/// Most Newton or bisection steps of the inverse; bisection alone would be down to rounding by then.
const MAX_STEPS: usize = 60;

/// Arc length along a [`BSpline`], from the start of its domain, and the inverse function.
///
/// Lengths are within about 1e-12 of the total; the parameter returned has an arc length within about 1e-12 of
/// the one asked for, relative to the total.
///
/// # References
/// B. Guenter and R. Parent, "Computing the arc length of parametric curves", *IEEE Computer Graphics and
/// Applications* 10 (1990): adaptive Gauss quadrature, kept as a table, and Newton's method. Changed here: a
/// bracket guards Newton's method.
#[derive(Debug, Clone)]
pub struct ArcLength {
    lo: f64,
    hi: f64,
    total: f64,
    /// Velocity by u of each knot span.
    velocities: Vec<Velocity>,
    /// Intervals on which one application of the Gauss rule is accurate, ascending.
    panels: Vec<Panel>,
}

#[derive(Debug, Clone, Copy)]
struct Panel {
    /// Start in parameters of the curve; the next panel starts where this one ends.
    start: f64,
    end: f64,
    /// Arc length at the start.
    length_before: f64,
    /// Index of its velocity.
    span: usize,
}

/// Derivative of a Bezier piece with the binomial coefficients multiplied in.
#[derive(Debug, Clone)]
struct Velocity {
    lo: f64,
    width: f64,
    weighted: Vec<DVec2>,
}

impl Velocity {
    fn of(piece: &Bezier) -> Self {
        let width = piece.hi - piece.lo;
        let hodograph = piece.hodograph();
        let n = hodograph.degree();
        let mut binomial = 1.0;
        let weigh = |(i, point): (usize, &DVec2)| {
            if i > 0 {
                binomial *= (n + 1 - i) as f64 / i as f64;
            }
            *point * (binomial / width)
        };
        Self { lo: piece.lo, width, weighted: hodograph.points.iter().enumerate().map(weigh).collect() }
    }

    /// Speed by u.
    fn speed(&self, u: f64) -> f64 {
        let t = (u - self.lo) / self.width;
        let s = 1.0 - t;
        let (mut sum, mut power) = (self.weighted[0], 1.0);
        for point in &self.weighted[1..] {
            power *= t;
            sum = sum * s + *point * power;
        }
        sum.length()
    }

    fn length(&self, a: f64, b: f64) -> f64 {
        GAUSS_16.integrate(a, b, |u| self.speed(u))
    }
}

impl ArcLength {
    fn new(curve: &BSpline) -> Self {
        let (lo, hi) = curve.domain();
        let pieces = curve.pieces(curve.bounds().center());
        let polygon = |piece: &Bezier| piece.points.windows(2).map(|w| w[0].distance(w[1])).sum::<f64>();
        let tolerance = PANEL_TOLERANCE * pieces.iter().map(polygon).sum::<f64>();
        let velocities: Vec<_> = pieces.iter().map(Velocity::of).collect();
        let (mut panels, mut total) = (Vec::with_capacity(2 * pieces.len()), 0.0);
        for (span, (piece, velocity)) in pieces.iter().zip(&velocities).enumerate() {
            let mut open = vec![(piece.lo, piece.hi, velocity.length(piece.lo, piece.hi), 0)];
            while let Some((start, end, length, depth)) = open.pop() {
                let middle = start + (end - start) / 2.0;
                let (first, second) = (velocity.length(start, middle), velocity.length(middle, end));
                if (first + second - length).abs() <= tolerance || depth == MAX_DEPTH {
                    panels.push(Panel { start, end, length_before: total, span });
                    total += first + second;
                } else {
                    open.push((middle, end, second, depth + 1));
                    open.push((start, middle, first, depth + 1));
                }
            }
        }
        Self { lo, hi, total, velocities, panels }
    }

    /// Length of the whole curve.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.total
    }

    /// Arc length from lo to u, in the direction of growing u; the total at u = hi.
    ///
    /// Not wrapped: beyond the domain whole turns are counted, forwards and backwards.
    #[must_use]
    pub fn at(&self, u: f64) -> f64 {
        let period = self.hi - self.lo;
        let turns = ((u - self.lo) / period).floor();
        let inside = (u - turns * period).clamp(self.lo, self.hi);
        let index = self.panels.partition_point(|panel| panel.start <= inside).max(1) - 1;
        turns * self.total + self.length_in(index, inside)
    }

    /// Parameter at which the arc length from lo is `s`; lo at 0 and hi at the total.
    ///
    /// Not wrapped: beyond the total whole periods are counted, forwards and backwards. Where the curve stands
    /// still the first such parameter is meant, up to rounding.
    #[must_use]
    pub fn parameter(&self, s: f64) -> f64 {
        if s == self.total {
            return self.hi;
        }
        let turns = (s / self.total).floor();
        let inside = (s - turns * self.total).clamp(0.0, self.total);
        let index = self.panels.partition_point(|panel| panel.length_before < inside).max(1) - 1;
        turns * (self.hi - self.lo) + self.parameter_in(index, inside)
    }

    /// Arc length at u in the panel.
    fn length_in(&self, index: usize, u: f64) -> f64 {
        let panel = self.panels[index];
        if u >= panel.end {
            return self.length_after(index);
        }
        panel.length_before + self.velocities[panel.span].length(panel.start, u)
    }

    fn length_after(&self, index: usize) -> f64 {
        self.panels.get(index + 1).map_or(self.total, |next| next.length_before)
    }

    /// Newton's method on the arc length in a panel, with bisection whenever a step leaves the bracket.
    fn parameter_in(&self, index: usize, s: f64) -> f64 {
        let Panel { start, end, length_before, span } = self.panels[index];
        let length = self.length_after(index) - length_before;
        let wanted = s - length_before;
        // Knots are met exactly, so that a sample on a corner is on it.
        let tolerance = 1e-15 * self.total;
        if wanted <= tolerance {
            return start;
        }
        if length - wanted <= tolerance {
            return end;
        }
        let velocity = &self.velocities[span];
        let (mut low, mut high) = (start, end);
        let mut u = start + (end - start) * (wanted / length);
        for _ in 0..MAX_STEPS {
            let error = velocity.length(start, u) - wanted;
            if error.abs() <= tolerance {
                break;
            }
            if error > 0.0 {
                high = u;
            } else {
                low = u;
            }
            let newton = u - error / velocity.speed(u);
            let next = if newton > low && newton < high { newton } else { low + (high - low) / 2.0 };
            if next == u {
                break;
            }
            let settled = (next - u).abs() <= 1e-8 * (end - start) && next == newton;
            u = next;
            // Newton's error squares: after a step this small the next one would be below rounding.
            if settled {
                break;
            }
        }
        u
    }
}

impl BSpline {
    /// Length of the curve, within about 1e-12 of itself.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.arc_length().total()
    }

    /// Prepares arc length and its inverse: a table of a few entries for each knot span.
    #[must_use]
    pub fn arc_length(&self) -> ArcLength {
        ArcLength::new(self)
    }
}
