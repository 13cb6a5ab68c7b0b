//! Whether a cell whose determinant is positive meets itself.

use super::{are_separated, is_regular};
use crate::hyperpatch::bernstein::split;
use crate::hyperpatch::inversion::newton;
use crate::hyperpatch::{Differences, Face, Net};
use glam::DVec3;

/// Most pairs of pieces that are looked at; each takes some microseconds.
const MOST_PAIRS: usize = 200_000;

/// Pairs between two looks at the clock.
const PAIRS_A_STEP: usize = 16;

/// Size in parameters below which pieces are tried for a point that they share.
const SMALL: f64 = 0.26;

/// Distance in parameters above which two places are different ones.
const APART: f64 = 1e-6;

/// Distance of two points, over the size of the cell, below which they are one.
const ONE_POINT: f64 = 1e-11;

/// Rounding error of a point over its largest coordinate.
const ROUNDING: f64 = 1e-15;

/// What was found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Finding {
    /// No two parameters have one point.
    Injective,
    /// Two parameters have one point.
    Meeting {
        /// Parameters of the one, on the boundary.
        first: DVec3,
        /// Parameters of the other.
        second: DVec3,
    },
    /// Neither was proven within the budget, or what is left is closer than can be told.
    Unproven,
}

/// The job that decides whether a cell with a positive (or, mirrored, a negative) determinant meets itself.
///
/// A map that is continuous, locally injective in a closed cube and injective on its boundary is injective. So pairs
/// of pieces of the six faces are looked at: a pair is done with when a plane separates the two, or when the cell
/// meets the cone condition on the box of parameters that holds both. Others are halved.
///
/// # References
/// G. Meisters and C. Olech, "Locally one-to-one mappings and a classical theorem on schlicht functions", *Duke
/// Mathematical Journal* 30 (1963).
#[derive(Debug, Clone)]
pub struct Injectivity {
    net: Net,
    differences: Differences,
    pairs: Vec<[Piece; 2]>,
    left: usize,
    /// Distance below which two points are one.
    tolerance: f64,
}

/// A rectangle of parameters on a face, with the control points of the surface there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::hyperpatch) struct Piece {
    pub(in crate::hyperpatch) face: Face,
    pub(in crate::hyperpatch) lo: [f64; 2],
    pub(in crate::hyperpatch) hi: [f64; 2],
    pub(in crate::hyperpatch) points: [DVec3; 16],
}

impl Piece {
    /// A whole face.
    pub(in crate::hyperpatch) fn new(net: &Net, face: Face) -> Self {
        Self { face, lo: [0.0; 2], hi: [1.0; 2], points: net.face(face) }
    }

    /// The box of parameters of the cell; it is flat.
    pub(in crate::hyperpatch) fn range(&self) -> (DVec3, DVec3) {
        (self.face.parameters(self.lo[0], self.lo[1]), self.face.parameters(self.hi[0], self.hi[1]))
    }

    /// Parameters of the middle.
    pub(in crate::hyperpatch) fn middle(&self) -> DVec3 {
        let (lo, hi) = self.range();
        (lo + hi) / 2.0
    }

    /// Parameters of the middle and of the four corners.
    pub(in crate::hyperpatch) fn places(&self) -> [DVec3; 5] {
        let ([a, b], [c, d]) = (self.lo, self.hi);
        let corner = |s: f64, t: f64| self.face.parameters(s, t);
        [self.middle(), corner(a, b), corner(a, d), corner(c, b), corner(c, d)]
    }

    /// Length of the longer side, in parameters.
    pub(in crate::hyperpatch) fn size(&self) -> f64 {
        (self.hi[0] - self.lo[0]).max(self.hi[1] - self.lo[1])
    }

    /// Length of the diagonal of the box of its control points.
    pub(in crate::hyperpatch) fn extent(&self) -> f64 {
        let (lo, hi) =
            self.points.iter().fold((self.points[0], self.points[0]), |(lo, hi), &p| (lo.min(p), hi.max(p)));
        hi.distance(lo)
    }

    /// The two halves across the side that is longer in space, or in parameters where both are points.
    pub(in crate::hyperpatch) fn halves(&self) -> [Self; 2] {
        let length = |from: usize, step: usize| {
            (0..3)
                .map(|n| self.points[from + n * step].distance(self.points[from + (n + 1) * step]))
                .sum::<f64>()
        };
        let lengths =
            [(0..4).map(|n| length(n, 4)).sum::<f64>(), (0..4).map(|n| length(4 * n, 1)).sum::<f64>()];
        let sides = [0, 1].map(|n| (lengths[n], self.hi[n] - self.lo[n]));
        let axis = usize::from(sides[1] > sides[0]);
        let (step, across) = ([4, 1][axis], [1, 4][axis]);
        let mut halves = [*self, *self];
        for n in 0..4 {
            let mut first: [DVec3; 4] = std::array::from_fn(|m| self.points[n * across + m * step]);
            let mut second = first;
            split(&mut first, &mut second, 0.5);
            for m in 0..4 {
                halves[0].points[n * across + m * step] = first[m];
                halves[1].points[n * across + m * step] = second[m];
            }
        }
        let middle = (self.lo[axis] + self.hi[axis]) / 2.0;
        halves[0].hi[axis] = middle;
        halves[1].lo[axis] = middle;
        halves
    }
}

impl Injectivity {
    /// The job for a cell, which must have a positive determinant everywhere, or a negative one everywhere when it is
    /// mirrored.
    #[must_use]
    pub fn new(net: &Net, is_mirrored: bool) -> Self {
        let differences = net.differences();
        let differences = if is_mirrored { differences.reoriented() } else { differences };
        let pieces = Face::all().map(|face| Piece::new(net, face));
        let mut pairs: Vec<[Piece; 2]> =
            (0..6).flat_map(|a| (a..6).map(move |b| [pieces[a], pieces[b]])).collect();
        // The last one is looked at first: ends that are one face are found at once, before their edges are searched
        // for a gap.
        pairs.sort_by_key(|[a, b]| a.face.axis == b.face.axis && a.face != b.face);
        let (lo, hi) = net.bounds();
        let largest = lo.abs().max(hi.abs()).max_element();
        let tolerance = ONE_POINT * lo.distance(hi) + ROUNDING * largest;
        Self { net: net.clone(), differences, pairs, left: MOST_PAIRS, tolerance }
    }

    /// Advances while `may_go_on` says so, at least by a little. Returns what was found when it is.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Finding> {
        loop {
            for _ in 0..PAIRS_A_STEP {
                let Some([a, b]) = self.pairs.pop() else { return Some(Finding::Injective) };
                if self.left == 0 {
                    return Some(Finding::Unproven);
                }
                self.left -= 1;
                if let Some(found) = self.look(a, b) {
                    return Some(found);
                }
            }
            if !may_go_on() {
                return None;
            }
        }
    }

    /// Runs the job to its end.
    pub fn run(mut self) -> Finding {
        loop {
            if let Some(found) = self.step(&mut || true) {
                return found;
            }
        }
    }

    /// Is done with a pair, or halves it, or finds two places with one point.
    fn look(&mut self, a: Piece, b: Piece) -> Option<Finding> {
        if are_separated(&a.points, &b.points) {
            return None;
        }
        let ((low_a, high_a), (low_b, high_b)) = (a.range(), b.range());
        let (lo, hi) = (low_a.min(low_b), high_a.max(high_b));
        // On the whole cell the condition is known to fail, or this job would not be needed.
        if (lo, hi) != (DVec3::ZERO, DVec3::ONE) && is_regular(&self.differences.part(lo, hi)) {
            return None;
        }
        if a.size().max(b.size()) < SMALL && a != b {
            let first = a.middle();
            let point = self.net.point(first);
            let is_witness = |second: &DVec3| {
                let is_apart = (second - first).abs().max_element() > APART;
                is_apart && self.net.point(*second).distance(point) <= self.tolerance
            };
            if let Some(second) = newton(&self.net, point, b.middle()).filter(is_witness) {
                return Some(Finding::Meeting { first, second });
            }
        }
        if a == b {
            let [first, second] = a.halves();
            self.pairs.extend([[first, second], [first, first], [second, second]]);
        } else if a.extent() >= b.extent() {
            self.pairs.extend(a.halves().map(|half| [half, b]));
        } else {
            self.pairs.extend(b.halves().map(|half| [a, half]));
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::test_cells::{closed_bar, crossing_bar, quarter_ring, random_net, twisted};
    use crate::hyperpatch::validity::{Certificate, Sign};
    use crate::hyperpatch::{Axis, Jacobian};

    #[test]
    fn twisted_and_jittered_cells_are_injective() {
        for (net, most) in [
            (quarter_ring(1.0, 2.0, 1.0), 1000),
            (twisted(90.0), 2000),
            (twisted(150.0), 20_000),
            (random_net(5, 0.15), 5000),
        ] {
            let mut job = Injectivity::new(&net, false);
            let found = loop {
                if let Some(found) = job.step(&mut || true) {
                    break found;
                }
            };
            assert_eq!(found, Finding::Injective);
            let used = MOST_PAIRS - job.left;
            assert!(used < most, "{used} pairs");
            assert_eq!(Injectivity::new(&net.reversed(Axis::W), true).run(), Finding::Injective);
        }
    }

    #[test]
    fn a_bar_that_runs_through_itself_has_two_places_with_one_point() {
        let net = crossing_bar();
        assert_eq!(Certificate::new(&Jacobian::new(&net), false).sign, Sign::Positive, "locally it is sound");
        let Finding::Meeting { first, second } = Injectivity::new(&net, false).run() else {
            panic!("the bar meets itself")
        };
        assert!((net.point(first) - net.point(second)).length() < 1e-9);
        assert!((first.x - second.x).abs() > 0.3, "{first} and {second} are far apart along the bar");
    }

    #[test]
    fn a_cell_that_touches_its_other_end_is_not_injective() {
        let net = closed_bar();
        assert_eq!(Certificate::new(&Jacobian::new(&net), false).sign, Sign::Positive);
        let Finding::Meeting { first, second } = Injectivity::new(&net, false).run() else {
            panic!("its ends are one face")
        };
        assert!((net.point(first) - net.point(second)).length() < 1e-9);
        assert!((first.x - second.x).abs() > 0.9, "{first} and {second} are the two ends");
    }

    #[test]
    fn the_job_stops_when_it_is_told_to() {
        let mut job = Injectivity::new(&twisted(150.0), false);
        let mut steps = 1;
        while job.step(&mut || false).is_none() {
            steps += 1;
        }
        assert!(steps > 5, "{steps}");
    }
}
