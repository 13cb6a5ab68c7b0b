//! The transform as the paper has it, for comparison.

use super::envelope::first_pass;
use super::lines::Layer;
use crate::field::Grid;

/// What a scan has found, and how long it looked.
#[derive(Debug, Clone, PartialEq)]
pub struct Scan {
    /// Squared distance of each voxel, in voxels; infinite without a feature.
    pub levels: Vec<f32>,
    /// How often a voxel was compared beyond the once that every voxel needs along each axis.
    pub extra: u64,
}

/// The scan of Saito and Toriwaki (1994) with the bound that the paper gives to its searches (Liu and others 2003, 3.2.1 and 4.1): where a
/// number is larger than the one before, what the one before says is tried for (g_j - g_(j-1) - 1) / 2 voxels, and no further than it
/// loses. Exact; how long it takes depends on the shape: linear on a cube, V^(4/3) on a cone.
#[must_use]
pub fn scan(grid: &Grid, features: &[u8]) -> Scan {
    let size @ [nx, ny, nz] = grid.size();
    let seed = |feature: &u8| if *feature == 0 { f32::INFINITY } else { 0.0 };
    let mut levels: Vec<f32> = features.iter().take(grid.count()).map(seed).collect();
    levels.resize(grid.count(), f32::INFINITY);
    for row in levels.chunks_exact_mut(nx) {
        first_pass(row, 1.0);
    }
    let (mut scratch, mut before, mut extra) = (Vec::new(), Vec::new(), 0);
    for (axis, layers, length) in [(1, nz, ny), (2, ny, nz)] {
        for layer in (0..layers).filter(|_| length > 1) {
            let lines = Layer::new(size, axis, layer);
            for block in 0..lines.blocks() {
                lines.change(&mut levels, block, &mut scratch, |line| {
                    before.clear();
                    before.extend_from_slice(line);
                    extra += search(line, &before, |_| {});
                });
            }
        }
    }
    Scan { levels, extra }
}

/// A search along a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Search {
    /// The voxel whose number is tried.
    pub from: usize,
    /// Whether voxels after it are compared, else those before it.
    pub is_forward: bool,
    /// Voxels that the bound allows.
    pub reach: usize,
    /// Voxels that were compared: the last one is not improved where that are fewer, or where the line ends.
    pub count: usize,
}

/// Improves a line by what it was before, forwards and backwards; returns the number of comparisons.
pub(super) fn search(line: &mut [f32], before: &[f32], mut told: impl FnMut(Search)) -> u64 {
    let last = line.len() - 1;
    let mut count = 0;
    for is_forward in [true, false] {
        let place = |n: usize| if is_forward { n } else { last - n };
        for j in 1..line.len() {
            let (here, from) = (before[place(j)], before[place(j - 1)]);
            if here <= from + 1.0 {
                continue;
            }
            let reach = (((here - from - 1.0) / 2.0) as usize).min(last - j);
            let start = count;
            for n in 0..=reach {
                count += 1;
                let level = from + ((n + 1) * (n + 1)) as f32;
                let at = place(j + n);
                if before[at] <= level {
                    break;
                }
                line[at] = line[at].min(level);
            }
            let compared = (count - start) as usize;
            told(Search { from: place(j - 1), is_forward, reach: reach + 1, count: compared });
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::super::test_grids::{brute_force, random_features, sizes};
    use super::*;

    #[test]
    fn it_finds_what_comparing_all_pairs_finds() {
        for (size, seed) in sizes().into_iter().zip(1..) {
            let grid = Grid::new(size, [1.0; 3]).unwrap();
            for share in [0.002, 0.05, 0.6] {
                let features = random_features(&grid, share, seed);
                let found = scan(&grid, &features).levels;
                let expected = brute_force(&grid, &features);
                assert!(
                    found.iter().zip(&expected).all(|(a, (b, _))| f64::from(*a) == *b),
                    "{size:?}, {share}"
                );
            }
        }
    }

    /// How the extra comparisons inside a shape grow from one size to twice that size, as a power of the number of voxels.
    fn power(is_inside: impl Fn([f64; 3]) -> bool) -> f64 {
        let extra = |n: usize| {
            let grid = Grid::new([n; 3], [1.0; 3]).unwrap();
            let at = |index: usize| {
                [index % n, index / n % n, index / n / n].map(|i| (2 * i + 1) as f64 / n as f64 - 1.0)
            };
            let features: Vec<u8> = (0..grid.count()).map(|index| u8::from(!is_inside(at(index)))).collect();
            scan(&grid, &features).extra as f64
        };
        (extra(96) / extra(48)).log2() / 3.0
    }

    /// The paper: linear on a cube, since longer searches happen next to its faces only; V^(4/3) on a cone; the sphere between them (4.1).
    #[test]
    fn the_searches_of_a_cone_grow_faster_than_those_of_a_cube() {
        let cube = power(|p| p.iter().all(|x| x.abs() < 0.9));
        let cone = power(|[x, y, z]| x.hypot(z) < 0.45 * (1.0 - y));
        let sphere = power(|p| p.iter().map(|x| x * x).sum::<f64>() < 0.81);
        assert!((cube - 1.0).abs() < 0.06, "cube {cube}");
        assert!((cone - 4.0 / 3.0).abs() < 0.06, "cone {cone}");
        assert!(sphere > 1.1 && sphere < 4.0 / 3.0 + 0.06, "sphere {sphere}");
    }
}
