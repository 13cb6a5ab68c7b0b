//! The point of a curve nearest to a given point.

use glam::DVec2;

use super::bezier::Bezier;
use super::bspline::BSpline;
use crate::geom::order_by_number;

/// Relative difference of squared distances that counts as rounding noise. Without it a point in the middle of
/// a nearly circular curve would have every piece halved to the end.
const NOISE: f64 = 1e-14;
/// Pieces shorter than this in their own parameter are not halved any more; there the squared distance is flat.
const SHORTEST: f64 = 1e-9;
/// Query points beyond this are moved to it, so that squares stay finite.
const FARTHEST: f64 = 1e100;

/// The nearest point of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// Parameter in the domain of the curve.
    pub u: f64,
    /// The point of the curve there.
    pub at: DVec2,
    /// Squared distance from the point asked for.
    pub distance_sq: f64,
}

impl BSpline {
    /// Finds the point of the curve nearest to `p`: the global minimum, not a local one.
    ///
    /// The distance is right to about 1e-13 of the size of the curve plus the distance. The parameter is right to
    /// about 1e-8 of the domain or better, unless several places are equally near; then it is one of them.
    /// For a `p` that is not a number the start of the curve is returned.
    ///
    /// The squared distance to each Bezier piece is written in Bernstein form: its smallest coefficient is a lower
    /// bound, and the sign changes of its differences tell how many extrema there can be. Pieces that can
    /// hold the minimum are halved until one extremum is left, which Newton's method finds.
    ///
    /// # References
    /// X.-D. Chen, Y. Zhou, Z. Shu, H. Su, J.-C. Paul, "Improved algebraic algorithm on point projection for Bezier
    /// curves", *IMSCCS* (2007), for the squared distance in Bernstein form.
    #[must_use]
    pub fn nearest(&self, p: DVec2) -> Nearest {
        let target = p.clamp(DVec2::splat(-FARTHEST), DVec2::splat(FARTHEST));
        let u = if p.is_nan() { self.domain().0 } else { self.wrap(nearest_of(self.pieces(target)).u) };
        let at = self.point(u);
        Nearest { u, at, distance_sq: at.distance_squared(p) }
    }
}

/// Parameter and squared distance of the candidate found so far.
#[derive(Debug, Clone, Copy)]
pub(super) struct Candidate {
    pub(super) u: f64,
    pub(super) distance_sq: f64,
}

impl Candidate {
    fn improve(&mut self, piece: &Bezier, t: f64) {
        let distance_sq = piece.point(t).length_squared();
        if distance_sq < self.distance_sq {
            *self = Self { u: piece.parameter(t), distance_sq };
        }
    }
}

/// A piece and the Bernstein coefficients of its squared distance from the origin.
struct Patch {
    piece: Bezier,
    distances: Vec<f64>,
    lower_bound: f64,
    depth: u32,
}

impl Patch {
    fn new(piece: Bezier, depth: u32) -> Self {
        let distances = squared_distances(&piece.points);
        let lower_bound = distances.iter().copied().fold(f64::INFINITY, f64::min);
        Self { piece, distances, lower_bound, depth }
    }
}

/// Finds the point nearest to the origin among the pieces, of which there is at least one.
pub(super) fn nearest_of(pieces: Vec<Bezier>) -> Candidate {
    let mut best = Candidate { u: pieces[0].lo, distance_sq: pieces[0].points[0].length_squared() };
    let deepest = (1.0 / SHORTEST).log2() as u32;
    let whole: Vec<_> = pieces.into_iter().map(|piece| Patch::new(piece, 0)).collect();
    for patch in &whole {
        best.improve(&patch.piece, 0.0);
        best.improve(&patch.piece, 1.0);
    }
    let order = order_by_number(whole.len(), |i| whole[i].lower_bound);
    let mut whole: Vec<Option<Patch>> = whole.into_iter().map(Some).collect();
    let mut open: Vec<Patch> = order.into_iter().rev().filter_map(|i| whole[i].take()).collect();
    while let Some(patch) = open.pop() {
        let noise = NOISE * patch.distances.iter().copied().fold(0.0, f64::max).min(best.distance_sq);
        if patch.lower_bound >= best.distance_sq - noise {
            continue;
        }
        match shape(&patch.distances, noise) {
            Shape::Monotone => {}
            Shape::Valley => best.improve(&patch.piece, valley(&patch.piece)),
            Shape::Unknown => {
                best.improve(&patch.piece, 0.5);
                if patch.depth < deepest {
                    let (left, right) = patch.piece.halves();
                    let (a, b) = (Patch::new(left, patch.depth + 1), Patch::new(right, patch.depth + 1));
                    let (far, near) = if a.lower_bound < b.lower_bound { (b, a) } else { (a, b) };
                    open.push(far);
                    open.push(near);
                }
            }
        }
    }
    best
}

/// Bernstein coefficients of the squared length of a Bezier curve, of twice its degree.
fn squared_distances(points: &[DVec2]) -> Vec<f64> {
    let n = points.len() - 1;
    let row = |n: usize| {
        let mut binomial = 1.0;
        (0..=n).map(move |i| {
            if i > 0 {
                binomial *= (n + 1 - i) as f64 / i as f64;
            }
            binomial
        })
    };
    let weighted: Vec<_> = points.iter().zip(row(n)).map(|(p, binomial)| *p * binomial).collect();
    let mut sums = vec![0.0; 2 * n + 1];
    for (i, a) in weighted.iter().enumerate() {
        for (j, b) in weighted.iter().enumerate() {
            sums[i + j] += a.dot(*b);
        }
    }
    sums.iter().zip(row(2 * n)).map(|(sum, binomial)| sum / binomial).collect()
}

/// What the sign changes of the differences of Bernstein coefficients tell about a polynomial.
enum Shape {
    /// No minimum inside: it rises, falls, or rises and then falls.
    Monotone,
    /// It falls and then rises.
    Valley,
    /// It may have several extrema.
    Unknown,
}

fn shape(coefficients: &[f64], noise: f64) -> Shape {
    let (mut last, mut changes, mut first) = (0.0_f64, 0, 0.0_f64);
    for pair in coefficients.windows(2) {
        let step = pair[1] - pair[0];
        if step.abs() <= noise {
            continue;
        }
        if last == 0.0 {
            first = step;
        } else if last.signum() != step.signum() {
            changes += 1;
        }
        last = step;
    }
    match changes {
        0 => Shape::Monotone,
        1 if first > 0.0 => Shape::Monotone,
        1 => Shape::Valley,
        _ => Shape::Unknown,
    }
}

/// The t at which the squared length of a piece, falling and then rising, is least.
fn valley(piece: &Bezier) -> f64 {
    let velocity = piece.hodograph();
    let acceleration = velocity.hodograph();
    let (mut low, mut high, mut t) = (0.0, 1.0, 0.5);
    for _ in 0..60 {
        let (c, d) = (piece.point(t), velocity.point(t));
        let slope = c.dot(d);
        if slope > 0.0 {
            high = t;
        } else {
            low = t;
        }
        let newton = t - slope / (d.length_squared() + c.dot(acceleration.point(t)));
        let next = if newton > low && newton < high { newton } else { low + (high - low) / 2.0 };
        let step = (next - t).abs();
        t = next;
        if step <= 1e-15 {
            break;
        }
    }
    t
}
