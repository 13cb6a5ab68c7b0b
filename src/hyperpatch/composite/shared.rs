//! Proofs that two cells meet only in a face, an edge or a corner that they share.

use super::sharing::Matching;
use crate::hyperpatch::validity::positive_direction;
use crate::hyperpatch::{Axis, Corner, Differences, Edge, Face};
use glam::DVec3;

/// A part that two cells share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Feature {
    /// A face of each, and how the second lies on the first.
    Face { sides: [Face; 2], matching: Matching },
    /// An edge of each, and whether the second runs backwards.
    Edge { sides: [Edge; 2], is_reversed: bool },
    /// A corner of each.
    Corner { sides: [Corner; 2] },
}

/// A box of parameters.
type Range = (DVec3, DVec3);

/// What two cells share, by the numbers of their control points: faces, edges that are on none of these, corners that
/// are on none of either.
pub(super) fn features(first: &[u32; 64], second: &[u32; 64]) -> Vec<Feature> {
    let mut found = Vec::new();
    // Most neighbours share corners; those that share none share nothing.
    let corners = |numbers: &[u32; 64]| Corner::all().map(|corner| numbers[corner.coefficient()]);
    let (corners_a, corners_b) = (corners(first), corners(second));
    if !corners_a.iter().any(|number| corners_b.contains(number)) {
        return found;
    }
    let mut covered: Vec<usize> = Vec::new();
    for a in Face::all() {
        let numbers = a.coefficients().map(|at| first[at]);
        for b in Face::all() {
            let others = b.coefficients().map(|at| second[at]);
            let fits = |m: &Matching| (0..16).all(|place| numbers[place] == others[m.coefficient(place)]);
            if let Some(matching) = Matching::all().into_iter().find(fits) {
                covered.extend(a.coefficients());
                found.push(Feature::Face { sides: [a, b], matching });
            }
        }
    }
    for a in Edge::all() {
        let places = a.coefficients();
        let numbers = places.map(|at| first[at]);
        for b in Edge::all() {
            let mut others = b.coefficients().map(|at| second[at]);
            let runs_on = others == numbers;
            others.reverse();
            if (runs_on || others == numbers) && !places.iter().all(|at| covered.contains(at)) {
                found.push(Feature::Edge { sides: [a, b], is_reversed: !runs_on });
                covered.extend(places);
            }
        }
    }
    for (a, number) in Corner::all().into_iter().zip(corners_a) {
        for (b, other) in Corner::all().into_iter().zip(corners_b) {
            if number == other && !covered.contains(&a.coefficient()) {
                found.push(Feature::Corner { sides: [a, b] });
            }
        }
    }
    found
}

impl Feature {
    /// Whether the parts of two cells on boxes of parameters, drawn out to the feature, are proven to meet in the
    /// feature alone.
    ///
    /// A point of the first part is one of the feature plus steps along derivatives that lead into the cell, and so
    /// is one of the second. If both are one point, steps along the feature, into the first cell and out of the
    /// second sum to zero. That is impossible when a direction has a positive product with all of them; it is looked
    /// for with each sign of the steps along the feature, as either point may be ahead.
    pub(super) fn is_all(&self, differences: [&Differences; 2], ranges: [Range; 2]) -> bool {
        let (places, along) = self.draw_out(ranges);
        let parts = [0, 1].map(|n| differences[n].part(places[n].0, places[n].1));
        let mut into = Vec::with_capacity(6 * 48);
        for (n, part) in parts.iter().enumerate() {
            for (axis, is_end) in self.across(n) {
                // Differences lead away from the start of an axis; out of the second cell they count with a minus.
                let sign = if is_end == (n == 1) { 1.0 } else { -1.0 };
                into.extend(part.0[axis as usize].iter().map(|d| *d * sign));
            }
        }
        let feature = differences[0].part(along.0, along.1);
        let axes = self.axes();
        (0..1 << axes.len()).all(|signs| {
            let mut vectors = into.clone();
            for (n, axis) in axes.iter().enumerate() {
                let sign = if signs & (1 << n) == 0 { 1.0 } else { -1.0 };
                vectors.extend(feature.0[*axis as usize].iter().map(|d| *d * sign));
            }
            positive_direction(&vectors).is_some()
        })
    }

    /// Axes of the first cell along the feature.
    fn axes(&self) -> Vec<Axis> {
        match self {
            Self::Face { sides, .. } => sides[0].axis.others().to_vec(),
            Self::Edge { sides, .. } => vec![sides[0].axis],
            Self::Corner { .. } => Vec::new(),
        }
    }

    /// Axes of a cell across the feature, and whether the feature lies at their ends.
    fn across(&self, n: usize) -> Vec<(Axis, bool)> {
        match self {
            Self::Face { sides, .. } => vec![(sides[n].axis, sides[n].is_end)],
            Self::Edge { sides, .. } => sides[n].axis.others().into_iter().zip(sides[n].ends).collect(),
            Self::Corner { sides } => Axis::ALL.into_iter().zip(sides[n].0).collect(),
        }
    }

    /// The boxes drawn out to the feature, over the stretch of it that either of them lies beside; and that stretch
    /// in the first cell.
    fn draw_out(&self, mut ranges: [Range; 2]) -> ([Range; 2], Range) {
        match self {
            Self::Face { sides, matching } => {
                let flat = |n: usize, p: DVec3| sides[n].axis.others().map(|axis| p[axis as usize]);
                let (lo, hi) = (flat(0, ranges[0].0), flat(0, ranges[0].1));
                let (a, b) = (matching.parameters(lo[0], lo[1]), matching.parameters(hi[0], hi[1]));
                let (other_lo, other_hi) = (flat(1, ranges[1].0), flat(1, ranges[1].1));
                let lo = [a.0.min(b.0).min(other_lo[0]), a.1.min(b.1).min(other_lo[1])];
                let hi = [a.0.max(b.0).max(other_hi[0]), a.1.max(b.1).max(other_hi[1])];
                let back = |s: f64, t: f64| {
                    let turn = |x: f64, n: usize| if matching.is_reversed[n] { 1.0 - x } else { x };
                    let (s, t) = (turn(s, 0), turn(t, 1));
                    if matching.is_swapped { [t, s] } else { [s, t] }
                };
                let (first, last) = (back(lo[0], lo[1]), back(hi[0], hi[1]));
                for (n, axis) in sides[0].axis.others().into_iter().enumerate() {
                    ranges[0].0[axis as usize] = first[n].min(last[n]);
                    ranges[0].1[axis as usize] = first[n].max(last[n]);
                }
                for (n, axis) in sides[1].axis.others().into_iter().enumerate() {
                    ranges[1].0[axis as usize] = lo[n];
                    ranges[1].1[axis as usize] = hi[n];
                }
            }
            Self::Edge { sides, is_reversed } => {
                let axes = [0, 1].map(|n| sides[n].axis as usize);
                let (a, b) = (
                    (ranges[0].0[axes[0]], ranges[0].1[axes[0]]),
                    (ranges[1].0[axes[1]], ranges[1].1[axes[1]]),
                );
                let turned = if *is_reversed { (1.0 - b.1, 1.0 - b.0) } else { b };
                let (lo, hi) = (a.0.min(turned.0), a.1.max(turned.1));
                (ranges[0].0[axes[0]], ranges[0].1[axes[0]]) = (lo, hi);
                let back = if *is_reversed { (1.0 - hi, 1.0 - lo) } else { (lo, hi) };
                (ranges[1].0[axes[1]], ranges[1].1[axes[1]]) = back;
            }
            Self::Corner { .. } => {}
        }
        let mut along = ranges[0];
        for (n, range) in ranges.iter_mut().enumerate() {
            for (axis, is_end) in self.across(n) {
                let (axis, end) = (axis as usize, if is_end { 1.0 } else { 0.0 });
                range.0[axis] = range.0[axis].min(end);
                range.1[axis] = range.1[axis].max(end);
                if n == 0 {
                    (along.0[axis], along.1[axis]) = (end, end);
                }
            }
        }
        (ranges, along)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::Net;
    use crate::hyperpatch::test_cells::ring_cell;

    const WHOLE: Range = (DVec3::ZERO, DVec3::ONE);

    #[test]
    fn cells_of_a_fine_ring_are_proven_as_wholes_and_of_a_coarse_one_in_parts() {
        let sides = [Face { axis: Axis::U, is_end: true }, Face { axis: Axis::U, is_end: false }];
        let matching = Matching { is_swapped: false, is_reversed: [false; 2] };
        let feature = Feature::Face { sides, matching };
        let proven = |count: usize, ranges: [Range; 2]| {
            let cells = [0, 1].map(|n| ring_cell(count, n, 1.0, 2.0, 1.0).differences());
            feature.is_all([&cells[0], &cells[1]], ranges)
        };
        assert!(proven(12, [WHOLE, WHOLE]));
        assert!(!proven(3, [WHOLE, WHOLE]));
        let near = [(DVec3::new(0.9, 0.0, 0.0), DVec3::ONE), (DVec3::ZERO, DVec3::new(0.1, 1.0, 1.0))];
        assert!(proven(3, near));
    }

    /// Folded back over the shared face, a cell is not proven to be apart.
    #[test]
    fn a_cell_on_the_same_side_is_not_proven() {
        let sides = [Face { axis: Axis::U, is_end: false }; 2];
        let feature =
            Feature::Face { sides, matching: Matching { is_swapped: false, is_reversed: [false; 2] } };
        let [a, b] = [1.0, 2.0].map(|x| Net::cuboid(DVec3::ZERO, DVec3::new(x, 1.0, 1.0)).differences());
        assert!(!feature.is_all([&a, &b], [WHOLE, WHOLE]));
        let away = Net::cuboid(DVec3::ZERO, DVec3::new(-1.0, 1.0, 1.0)).differences();
        assert!(feature.is_all([&a, &away], [WHOLE, WHOLE]));
    }
}
