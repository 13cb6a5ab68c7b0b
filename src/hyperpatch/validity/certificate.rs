//! Whether the Jacobian determinant of a cell is positive everywhere, decided with a bound on every rounding.

use crate::hyperpatch::bernstein::split;
use crate::hyperpatch::jacobian::{CORNERS, COUNT, SIZE};
use crate::hyperpatch::{Axis, Corner, Jacobian};
use glam::DVec3;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Width of the bounds on the least determinant, over the largest coefficient, from which on it counts as zero when
/// it may be.
const FLAT: f64 = 1e-9;

/// Most parts that are looked at; what is undecided then stays so. A part takes a few microseconds.
const MOST_PARTS: usize = 2000;

/// What is known of the sign of the Jacobian determinant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Sign {
    /// Certainly positive on the whole cell.
    Positive,
    /// Certainly negative at a place.
    Negative,
    /// Zero somewhere within the tolerance, or too close to it to be decided.
    Undecided,
}

/// Bounds of the least Jacobian determinant of a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Certificate {
    /// What they say.
    pub sign: Sign,
    /// The determinant is nowhere less.
    pub lower: f64,
    /// The determinant at `at`, the least value that was found.
    pub upper: f64,
    /// Parameters of the least value found.
    pub at: DVec3,
    /// Number of parts that were looked at.
    pub parts: usize,
}

/// A part of the cell with the coefficients of the determinant there.
struct Part {
    coefficients: Vec<f64>,
    lo: DVec3,
    size: DVec3,
    /// The least coefficient.
    least: f64,
    /// How far a coefficient may be from the exact one.
    error: f64,
}

impl Certificate {
    /// Decides the sign of the determinant, or of its opposite for a mirrored cell.
    ///
    /// The parts with the least coefficients are halved first, along the axis of the largest step between
    /// coefficients. It ends when every coefficient is positive by more than its error, when a value is negative by
    /// more than its error, or when the bounds are within 1e-9 of the largest coefficient of each other.
    #[must_use]
    pub fn new(jacobian: &Jacobian, is_mirrored: bool) -> Self {
        let sign = if is_mirrored { -1.0 } else { 1.0 };
        let coefficients: Vec<f64> = jacobian.coefficients().iter().map(|c| c * sign).collect();
        let largest = coefficients.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
        let whole = Part::new(coefficients, DVec3::ZERO, DVec3::ONE, jacobian.error());
        let (upper, at, _) = whole.least_corner();
        let mut found = Self { sign: Sign::Undecided, lower: f64::INFINITY, upper, at, parts: 1 };
        let mut proven = f64::INFINITY;
        let mut heap = BinaryHeap::from([whole]);
        while let Some(part) = heap.pop() {
            found.lower = proven.min(part.least - part.error);
            let (value, at, error) = part.least_corner();
            if value <= found.upper {
                (found.upper, found.at) = (value, at);
            }
            if value < -error {
                found.sign = Sign::Negative;
                return found;
            }
            if part.least > part.error {
                found.sign = Sign::Positive;
                return found;
            }
            if found.upper - found.lower <= FLAT * largest || found.parts >= MOST_PARTS {
                return found;
            }
            for half in part.halves(largest) {
                found.parts += 1;
                if half.least > half.error {
                    proven = proven.min(half.least - half.error);
                } else {
                    heap.push(half);
                }
            }
        }
        found.sign = Sign::Positive;
        found.lower = proven;
        found
    }
}

impl Part {
    fn new(coefficients: Vec<f64>, lo: DVec3, size: DVec3, error: f64) -> Self {
        let least = coefficients.iter().copied().fold(f64::INFINITY, f64::min);
        Self { coefficients, lo, size, least, error }
    }

    /// The least value at a corner, its parameters and its error.
    fn least_corner(&self) -> (f64, DVec3, f64) {
        let mut best = (f64::INFINITY, self.lo, self.error);
        for (place, corner) in CORNERS.into_iter().zip(Corner::all()) {
            if self.coefficients[place] < best.0 {
                best = (self.coefficients[place], self.lo + self.size * corner.parameters(), self.error);
            }
        }
        best
    }

    /// Largest difference of neighbouring coefficients along an axis.
    fn step(&self, axis: Axis) -> f64 {
        let stride = stride(axis);
        let inner = (0..COUNT).filter(|at| at / stride % SIZE < SIZE - 1);
        inner.map(|at| (self.coefficients[at + stride] - self.coefficients[at]).abs()).fold(0.0, f64::max)
    }

    /// The two halves across the axis of the largest step. A mean of two coefficients is rounded once, and there are
    /// 8 in a row.
    fn halves(&self, largest: f64) -> [Self; 2] {
        let steps = Axis::ALL.map(|axis| self.step(axis));
        let axis = Axis::ALL.into_iter().max_by(|a, b| steps[*a as usize].total_cmp(&steps[*b as usize]));
        let axis = axis.unwrap_or(Axis::U);
        let stride = stride(axis);
        let (mut before, mut after) = (self.coefficients.clone(), self.coefficients.clone());
        for start in (0..COUNT).filter(|at| (at / stride).is_multiple_of(SIZE)) {
            let mut first: [f64; SIZE] = std::array::from_fn(|n| self.coefficients[start + n * stride]);
            let mut second = first;
            split(&mut first, &mut second, 0.5);
            for n in 0..SIZE {
                before[start + n * stride] = first[n];
                after[start + n * stride] = second[n];
            }
        }
        let size = self.size - axis.unit() * (self.size[axis as usize] / 2.0);
        let error = self.error + 4.0 * f64::EPSILON * largest;
        let middle = self.lo + axis.unit() * size[axis as usize];
        [Self::new(before, self.lo, size, error), Self::new(after, middle, size, error)]
    }
}

/// How far apart neighbours along an axis are in a list of 729.
fn stride(axis: Axis) -> usize {
    [SIZE * SIZE, SIZE, 1][axis as usize]
}

impl PartialEq for Part {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Part {}

impl PartialOrd for Part {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Part {
    /// The part with the least coefficient is the greatest, so that it comes first from a heap.
    fn cmp(&self, other: &Self) -> Ordering {
        other.least.total_cmp(&self.least)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::Net;
    use crate::hyperpatch::test_cells::{folded, quarter_ring, random_net, twisted};

    fn certificate(net: &Net) -> Certificate {
        Certificate::new(&Jacobian::new(net), false)
    }

    #[test]
    fn sound_cells_are_positive_at_once() {
        for net in [Net::cuboid(DVec3::ZERO, DVec3::ONE), quarter_ring(1.0, 2.0, 1.0), random_net(1, 0.1)] {
            let found = certificate(&net);
            assert_eq!((found.sign, found.parts), (Sign::Positive, 1));
            assert!(0.0 < found.lower && found.lower <= found.upper);
        }
    }

    /// With f(u) of the control points 0, 1/3 + s, 2/3 - s, 1 in the middle and straight edges, J is 1 at all
    /// corners. On the line v = w = 1/2 it is `1 + (9/16) f'` with `f' = 3 s (1 - 6 u + 6 u^2)`, least at the middle:
    /// zero for s = 32/27.
    #[test]
    fn a_fold_with_good_corners_is_found_inside() {
        let critical = 32.0 / 27.0;
        for (shift, expected) in [
            (0.5, Sign::Positive),
            (critical * 0.9999, Sign::Positive),
            (critical * 1.0001, Sign::Negative),
            (3.0, Sign::Negative),
        ] {
            let net = folded(shift);
            for corner in Corner::all() {
                assert!((net.jacobian(corner.parameters()) - 1.0).abs() < 1e-12);
            }
            let found = certificate(&net);
            assert_eq!(found.sign, expected, "shift {shift}: {found:?}");
            if expected == Sign::Negative {
                assert!(net.jacobian(found.at) < 0.0, "the witness is one");
                assert!((net.jacobian(found.at) - found.upper).abs() < 1e-10);
            } else {
                assert!(net.jacobian(DVec3::splat(0.5)) >= found.lower);
            }
        }
        assert_eq!(certificate(&folded(critical)).sign, Sign::Undecided);
    }

    /// A box whose layers turn evenly by `a` has the determinant `8 |1 - w + w exp(i a / 3)|^6`, least in the middle:
    /// `8 cos(a / 6)^6`. It is zero for one and a half turns.
    #[test]
    fn bounds_hold_the_known_least_determinant_of_a_twist() {
        for degrees in (0..=480).step_by(20) {
            let degrees = f64::from(degrees);
            let found = certificate(&twisted(degrees));
            let least = 8.0 * (degrees / 6.0).to_radians().cos().powi(6);
            assert_eq!(found.sign, Sign::Positive, "{degrees} degrees: {found:?}");
            assert!(
                found.lower <= least + 1e-12 && least <= found.upper + 1e-12,
                "{degrees}: {least}, {found:?}"
            );
        }
        assert_eq!(certificate(&twisted(540.0)).sign, Sign::Undecided);
    }

    #[test]
    fn flat_places_are_undecided() {
        let cube = Net::cuboid(DVec3::ZERO, DVec3::ONE);
        let pinched = Net(cube.0.map(|p| DVec3::new(p.x * p.z, p.y * p.z, p.z)));
        let flat = cube.map(|p| DVec3::new(p.x, p.y, 0.0));
        for net in [pinched, flat, cube.map(|_| DVec3::ONE)] {
            let found = certificate(&net);
            assert_eq!(found.sign, Sign::Undecided, "{found:?}");
            assert!(found.parts < MOST_PARTS);
        }
    }

    #[test]
    fn mirrored_cells_are_positive_the_other_way_round() {
        let net = twisted(100.0);
        let (found, other) = (certificate(&net), Jacobian::new(&net.reversed(Axis::V)));
        assert_eq!(found.sign, Sign::Positive);
        assert_eq!(Certificate::new(&other, true).sign, Sign::Positive);
        assert_eq!(Certificate::new(&other, false).sign, Sign::Negative);
    }

    /// Against a dense sample: no value below the lower bound, and none of a positive cell below zero.
    #[test]
    fn bounds_hold_on_dense_samples() {
        let mut seen = [0, 0];
        for seed in 0..60 {
            let net = random_net(seed, 0.12 + 0.16 * seed as f64 / 60.0);
            let found = certificate(&net);
            let mut least = f64::INFINITY;
            for n in 0..11 * 11 * 11 {
                let at = DVec3::new((n / 121) as f64, (n / 11 % 11) as f64, (n % 11) as f64) / 10.0;
                least = least.min(net.jacobian(at));
            }
            match found.sign {
                Sign::Positive => {
                    seen[0] += 1;
                    assert!(least > 0.0 && least >= found.lower && found.lower > 0.0);
                }
                Sign::Negative => {
                    seen[1] += 1;
                    assert!(net.jacobian(found.at) < 0.0);
                }
                Sign::Undecided => panic!("seed {seed} is undecided: {found:?}"),
            }
        }
        assert!(seen[0] > 5 && seen[1] > 5, "{seen:?}");
    }
}
