//! The transform by lower envelopes of parabolas, one axis after the other.

use super::lines::{BLOCK, Layer};
use super::seed::Seed;
use crate::field::Grid;

/// The transform by lower envelopes (Meijster, Roerdink and Hesselink 2000; Felzenszwalb and Huttenlocher 2012), in steps.
///
/// Along an axis the squared distance at p is the least of g_i + (p - p_i)^2 over the voxels i of the line, g_i being what the axes before have found. A parabola is
/// least somewhere just where its (p_i, g_i + p_i^2) is a corner of the lower convex hull of these points, which one walk finds without a division: time
/// and memory are linear in the number of voxels, whatever the shape. With the spacing 1 along every axis all numbers are whole, and
/// the result is exact for `f32` while squared distances stay below 2^24.
#[derive(Debug)]
pub struct Envelope<S> {
    size: [usize; 3],
    steps: [f64; 3],
    data: Vec<S>,
    scratch: Vec<S>,
    hull: Vec<Corner<S>>,
    stage: Stage,
}

/// What is done next.
#[derive(Debug, Clone, Copy)]
enum Stage {
    /// A batch of rows along x of a layer.
    Rows {
        layer: usize,
        batch: usize,
    },
    /// A block of lines along y of a layer.
    Columns {
        layer: usize,
        block: usize,
    },
    /// A block of lines along z of an upright layer.
    Pillars {
        layer: usize,
        block: usize,
    },
    Done,
}

/// A corner of the hull.
#[derive(Debug, Clone, Copy)]
struct Corner<S> {
    place: f64,
    level: f64,
    height: f64,
    seed: S,
}

impl<S: Seed> Envelope<S> {
    /// Starts the transform; `is_feature` tells of a voxel by its index whether it belongs to a feature. `steps` are the lengths in which
    /// distances are measured: the spacing, or 1 along each axis for distances in voxels.
    #[must_use]
    pub fn new(grid: &Grid, steps: [f64; 3], is_feature: impl Fn(usize) -> bool) -> Self {
        let seed = |index: usize| if is_feature(index) { S::feature(index as u32) } else { S::NONE };
        Self {
            size: grid.size(),
            steps,
            data: (0..grid.count()).map(seed).collect(),
            scratch: Vec::new(),
            hull: Vec::new(),
            stage: Stage::Rows { layer: 0, batch: 0 },
        }
    }

    /// Goes on while `may_go_on` says so, at least by a block of lines; returns whether it has come to its end.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> bool {
        loop {
            self.stage = self.advance();
            if matches!(self.stage, Stage::Done) {
                return true;
            }
            if !may_go_on() {
                return false;
            }
        }
    }

    /// Share of the work that is done.
    #[must_use]
    pub fn progress(&self) -> f64 {
        let [_, ny, nz] = self.size;
        match self.stage {
            Stage::Rows { layer, .. } | Stage::Columns { layer, .. } => 0.6 * layer as f64 / nz as f64,
            Stage::Pillars { layer, .. } => 0.6 + 0.4 * layer as f64 / ny as f64,
            Stage::Done => 1.0,
        }
    }

    /// What was found of every voxel, once [`step`](Self::step) has returned true.
    #[must_use]
    pub fn into_data(self) -> Vec<S> {
        self.data
    }

    fn advance(&mut self) -> Stage {
        let [nx, ny, _] = self.size;
        match self.stage {
            Stage::Rows { layer, batch } => {
                let first = layer * ny + batch * BLOCK;
                let count = BLOCK.min(ny - batch * BLOCK);
                for row in self.data[first * nx..(first + count) * nx].chunks_exact_mut(nx) {
                    first_pass(row, self.steps[0]);
                }
                match (batch + 1) * BLOCK < ny {
                    true => Stage::Rows { layer, batch: batch + 1 },
                    // The layer is still in the cache.
                    false if ny > 1 => Stage::Columns { layer, block: 0 },
                    false => self.next_layer(layer),
                }
            }
            Stage::Columns { layer, block } => {
                let lines = Layer::new(self.size, 1, layer);
                self.change(&lines, block, self.steps[1]);
                match block + 1 < lines.blocks() {
                    true => Stage::Columns { layer, block: block + 1 },
                    false => self.next_layer(layer),
                }
            }
            Stage::Pillars { layer, block } => {
                let lines = Layer::new(self.size, 2, layer);
                self.change(&lines, block, self.steps[2]);
                match (block + 1 < lines.blocks(), layer + 1 < ny) {
                    (true, _) => Stage::Pillars { layer, block: block + 1 },
                    (false, true) => Stage::Pillars { layer: layer + 1, block: 0 },
                    (false, false) => Stage::Done,
                }
            }
            Stage::Done => Stage::Done,
        }
    }

    fn next_layer(&self, layer: usize) -> Stage {
        match (layer + 1 < self.size[2], self.size[2] > 1) {
            (true, _) => Stage::Rows { layer: layer + 1, batch: 0 },
            (false, true) => Stage::Pillars { layer: 0, block: 0 },
            (false, false) => Stage::Done,
        }
    }

    fn change(&mut self, lines: &Layer, block: usize, step: f64) {
        let hull = &mut self.hull;
        lines.change(&mut self.data, block, &mut self.scratch, |line| envelope(line, step, hull));
    }
}

/// The first axis: each voxel is a feature or nothing, and the nearest one is the last that was passed from either side.
pub(super) fn first_pass<S: Seed>(line: &mut [S], step: f64) {
    let mut last: Option<(usize, S)> = None;
    for (place, value) in line.iter_mut().enumerate() {
        if value.level() == 0.0 {
            last = Some((place, *value));
        } else if let Some((from, seed)) = last {
            *value = seed.at(squared(place - from, step));
        }
    }
    let mut last: Option<(usize, S)> = None;
    for (place, value) in line.iter_mut().enumerate().rev() {
        if value.level() == 0.0 {
            last = Some((place, *value));
        } else if let Some((from, seed)) = last {
            let level = squared(from - place, step);
            if level < value.level() {
                *value = seed.at(level);
            }
        }
    }
}

fn squared(voxels: usize, step: f64) -> f64 {
    let length = voxels as f64 * step;
    length * length
}

/// The lower envelope of the parabolas of a line, at its voxels.
fn envelope<S: Seed>(line: &mut [S], step: f64, hull: &mut Vec<Corner<S>>) {
    find_hull(line, step, hull);
    let mut corners = hull.iter();
    let (Some(mut corner), mut following) = (corners.next(), corners.next()) else { return };
    for (n, value) in line.iter_mut().enumerate() {
        let place = n as f64 * step;
        while let Some(next) = following {
            if next.height - corner.height > 2.0 * place * (next.place - corner.place) {
                break;
            }
            corner = next;
            following = corners.next();
        }
        let along = place - corner.place;
        *value = corner.seed.at(corner.level + along * along);
    }
}

/// The lower convex hull of the points of a line.
fn find_hull<S: Seed>(line: &[S], step: f64, hull: &mut Vec<Corner<S>>) {
    hull.clear();
    for (n, seed) in line.iter().enumerate() {
        let level = seed.level();
        if level == f64::INFINITY {
            continue;
        }
        let place = n as f64 * step;
        let next = Corner { place, level, height: level + place * place, seed: *seed };
        while let [.., a, b] = hull.as_slice() {
            let is_above = (b.height - a.height) * (next.place - b.place)
                >= (next.height - b.height) * (b.place - a.place);
            if !is_above {
                break;
            }
            hull.pop();
        }
        hull.push(next);
    }
}

/// The envelope of a line of spacing 1, with the voxels whose parabolas are corners of the hull.
pub(super) fn traced(line: &mut [f32]) -> Vec<usize> {
    let mut hull = Vec::new();
    envelope(line, 1.0, &mut hull);
    hull.iter().map(|corner| corner.place as usize).collect()
}

#[cfg(test)]
mod tests {
    use super::super::Near;
    use super::super::test_grids::{brute_force, random_features, sizes};
    use super::*;

    fn run<S: Seed>(grid: &Grid, steps: [f64; 3], features: &[u8]) -> Vec<S> {
        let mut job = Envelope::new(grid, steps, |index| features[index] != 0);
        assert!(job.step(&mut || true));
        job.into_data()
    }

    #[test]
    fn squared_distances_in_voxels_are_those_of_all_pairs() {
        for (size, seed) in sizes().into_iter().zip(1..) {
            let grid = Grid::new(size, [1.0; 3]).unwrap();
            for share in [0.002, 0.05, 0.6] {
                let features = random_features(&grid, share, seed);
                let found: Vec<f32> = run(&grid, [1.0; 3], &features);
                let expected = brute_force(&grid, &features);
                assert!(
                    found.iter().zip(&expected).all(|(a, (b, _))| f64::from(*a) == *b),
                    "{size:?}, {share}"
                );
            }
        }
    }

    #[test]
    fn lengths_of_unequal_spacing_are_those_of_all_pairs() {
        let spacing = [0.3, 1.7, 0.9];
        for (size, seed) in sizes().into_iter().zip(100..) {
            let grid = Grid::new(size, spacing).unwrap();
            let features = random_features(&grid, 0.03, seed);
            let found: Vec<f64> = run(&grid, spacing, &features);
            for (a, (b, _)) in found.iter().zip(brute_force(&grid, &features)) {
                assert!(*a == b || (a - b).abs() <= 1e-12 * b, "{a}, not {b}");
            }
        }
    }

    /// The feature that is named is as near as any.
    #[test]
    fn the_nearest_voxel_is_named() {
        for (size, seed) in sizes().into_iter().zip(200..) {
            let grid = Grid::new(size, [1.0; 3]).unwrap();
            let features = random_features(&grid, 0.04, seed);
            let [nx, ny, _] = size;
            for (index, near) in run::<Near>(&grid, [1.0; 3], &features).into_iter().enumerate() {
                if near == Near::NONE {
                    assert!(features.iter().all(|feature| *feature == 0));
                    continue;
                }
                let other = near.feature as usize;
                assert_ne!(features[other], 0);
                let at = |n: usize| [n % nx, n / nx % ny, n / nx / ny].map(|n| n as f64);
                let [a, b] = [at(index), at(other)];
                let level: f64 = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum();
                assert_eq!(level, near.level);
            }
        }
    }

    #[test]
    fn a_grid_without_features_has_no_distances_and_one_of_features_only_zeros() {
        let grid = Grid::new([5, 4, 3], [1.0; 3]).unwrap();
        assert!(run::<f32>(&grid, [1.0; 3], &[0; 60]).iter().all(|level| *level == f32::INFINITY));
        assert!(run::<f32>(&grid, [1.0; 3], &[7; 60]).iter().all(|level| *level == 0.0));
    }

    #[test]
    fn it_can_be_stopped_after_every_block() {
        let grid = Grid::new([33, 20, 7], [1.0; 3]).unwrap();
        let features = random_features(&grid, 0.01, 5);
        let mut job = Envelope::<f32>::new(&grid, [1.0; 3], |index| features[index] != 0);
        let (mut steps, mut last) = (0, 0.0);
        while !job.step(&mut || false) {
            assert!(job.progress() >= last && job.progress() < 1.0);
            last = job.progress();
            steps += 1;
        }
        assert!(steps > 50, "{steps}");
        assert_eq!(job.into_data(), run::<f32>(&grid, [1.0; 3], &features));
    }
}
