//! Parts of the way from one line to the next, for integrals along one-to-one lines.

use super::spacing::corner_shares;
use crate::curve::{ArcLength, BSpline};

/// Parts into which the way from each line to the next is cut.
pub(super) const PARTS: usize = 8;
/// Parts shorter than this share of the way are not made.
const SHORTEST: f64 = 1e-6;

/// Cuts the ways between lines into parts in which the values are smooth.
#[derive(Debug, Clone)]
pub(super) struct Parts {
    /// Corners of both curves in shares of arc length, from 0 to 1.
    corners: [Vec<f64>; 2],
}

impl Parts {
    pub(super) fn new(curves: &[BSpline; 2], arc_lengths: &[ArcLength; 2]) -> Self {
        Self { corners: [0, 1].map(|axis| corner_shares(&curves[axis], &arc_lengths[axis])) }
    }

    /// Shares of the way between two places, in shares of arc length on both curves, from 0 to 1: equal steps, but the nearest one to each
    /// corner on the way lies at the corner.
    pub(super) fn cuts(&self, from: [f64; 2], to: [f64; 2]) -> [f64; PARTS + 1] {
        let mut cuts: [f64; PARTS + 1] = std::array::from_fn(|k| k as f64 / PARTS as f64);
        let mut is_taken = [false; PARTS + 1];
        for axis in 0..2 {
            let way = to[axis] - from[axis];
            for corner in &self.corners[axis] {
                let on = (corner - from[axis]).rem_euclid(1.0);
                if on <= SHORTEST * way || on >= (1.0 - SHORTEST) * way {
                    continue;
                }
                let at = on / way;
                let off = |k: &usize| (cuts[*k] - at).abs();
                let free = (1..PARTS).filter(|&k| !is_taken[k]);
                if let Some(k) = free.min_by(|i, k| off(i).total_cmp(&off(k))) {
                    (cuts[k], is_taken[k]) = (at, true);
                }
            }
        }
        cuts.sort_unstable_by(f64::total_cmp);
        cuts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_cut_to_each_corner_lies_at_it() {
        let parts = Parts { corners: [vec![0.0, 0.3], vec![0.9]] };
        let cuts = parts.cuts([0.25, 0.5], [0.35, 0.7]);
        let even: Vec<f64> = (0..=PARTS).map(|k| k as f64 / PARTS as f64).collect();
        assert_eq!(cuts.len(), even.len());
        assert!((cuts[4] - 0.5).abs() < 1e-12, "the corner at 0.3 is half way");
        assert!((0..=PARTS).filter(|&k| k != 4).all(|k| cuts[k] == even[k]));
        // Across the seam, and on the other curve a lap on.
        let cuts = parts.cuts([0.96, 1.85], [1.06, 1.95]);
        assert!(
            cuts.iter().any(|cut| (cut - 0.4).abs() < 1e-9)
                && cuts.iter().any(|cut| (cut - 0.5).abs() < 1e-9)
        );
        assert!(cuts.windows(2).all(|w| w[0] < w[1]) && cuts[0] == 0.0 && cuts[PARTS] == 1.0);
    }

    #[test]
    fn more_corners_than_cuts_and_a_way_without_length_do_no_harm() {
        let parts = Parts { corners: [(0..20).map(|k| f64::from(k) / 100.0).collect(), vec![0.5]] };
        let cuts = parts.cuts([0.0, 0.5], [0.2, 0.5]);
        assert!(cuts.windows(2).all(|w| w[0] <= w[1]) && cuts.iter().all(|cut| (0.0..=1.0).contains(cut)));
    }
}
