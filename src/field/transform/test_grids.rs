//! Grids for tests, and distances by comparing all voxels with all features.

use crate::field::Grid;

/// Odd and even sizes, axes of one voxel, blocks that are not full.
pub(super) fn sizes() -> Vec<[usize; 3]> {
    vec![
        [1, 1, 1],
        [17, 1, 1],
        [1, 33, 1],
        [1, 1, 9],
        [19, 23, 1],
        [1, 16, 17],
        [35, 1, 6],
        [13, 18, 11],
        [16, 16, 16],
    ]
}

/// Features on about this share of the voxels, always the same ones for a seed.
pub(super) fn random_features(grid: &Grid, share: f64, seed: u64) -> Vec<u8> {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    (0..grid.count()).map(|_| u8::from(next() < share)).collect()
}

/// The squared distance to the nearest feature, in units of the grid, with its index; infinite where there is none.
pub(super) fn brute_force(grid: &Grid, features: &[u8]) -> Vec<(f64, usize)> {
    let ([nx, ny, _], spacing) = (grid.size(), grid.spacing());
    let at = |n: usize| [n % nx, n / nx % ny, n / nx / ny].map(|n| n as f64);
    let marked: Vec<usize> = (0..grid.count()).filter(|n| features[*n] != 0).collect();
    let nearest = |n: usize| {
        let level = |other: &usize| -> f64 {
            let pairs = at(n).into_iter().zip(at(*other)).zip(spacing);
            pairs.map(|((a, b), step)| ((a - b) * step).powi(2)).sum()
        };
        let pairs = marked.iter().map(|other| (level(other), *other));
        pairs.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::INFINITY, usize::MAX))
    };
    (0..grid.count()).map(nearest).collect()
}
