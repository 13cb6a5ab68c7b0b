//! The transform within a limit, by windows along the axes.

use crate::field::Grid;

/// Longest limit, in voxels.
pub const LONGEST_WINDOW: usize = 120;

/// Stands for more than any limit; with the square of the longest one added it still fits.
const FAR: i16 = 16_383;

/// Squared distances in voxels up to a limit, exactly; whatever lies farther is far. In steps.
///
/// Along an axis each voxel takes the least of what the voxels within the limit have found plus the square of their distance. All lines that lie side by side do so
/// at once, in numbers of 16 bits, so that the time is proportional to the limit, whatever the shape. Rows that cannot give anything are skipped.
#[derive(Debug)]
pub struct Window {
    size: [usize; 3],
    /// Whole voxels within the limit.
    reach: usize,
    /// The greatest square within it.
    most: i16,
    data: Vec<i16>,
    /// A layer as the axes before have left it, row by row.
    layer: Vec<i16>,
    /// The least number of each of its rows.
    least: Vec<i16>,
    axis: usize,
    at: usize,
    row: usize,
}

impl Window {
    /// Starts the transform up to `limit` voxels, [`LONGEST_WINDOW`] at most.
    #[must_use]
    pub fn new(grid: &Grid, limit: f64, is_feature: impl Fn(usize) -> bool) -> Self {
        let data = (0..grid.count()).map(|index| if is_feature(index) { 0 } else { FAR }).collect();
        let limit = limit.min(LONGEST_WINDOW as f64);
        let (reach, most) = (limit as usize, (limit * limit) as i16);
        Self {
            size: grid.size(),
            reach,
            most,
            data,
            layer: Vec::new(),
            least: Vec::new(),
            axis: 0,
            at: 0,
            row: 0,
        }
    }

    /// Goes on while `may_go_on` says so, at least by a row; returns whether it has come to its end.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> bool {
        while self.axis < 3 {
            self.advance();
            if !may_go_on() {
                return self.axis == 3;
            }
        }
        true
    }

    /// Share of the work that is done.
    #[must_use]
    pub fn progress(&self) -> f64 {
        let [_, ny, nz] = self.size;
        let layers = if self.axis == 2 { ny } else { nz };
        (self.axis as f64 + self.at as f64 / layers as f64) / 3.0
    }

    /// Number of voxels.
    #[must_use]
    pub fn count(&self) -> usize {
        self.data.len()
    }

    /// Stands for what lies beyond the limit: one more than the greatest square within it.
    #[must_use]
    pub fn beyond(&self) -> usize {
        usize::from(self.most.unsigned_abs()) + 1
    }

    /// The squared distance of so many voxels from the first one named on, or [`beyond`](Self::beyond), once [`step`](Self::step) has returned true.
    pub fn levels(&self, first: usize, count: usize) -> impl Iterator<Item = usize> + '_ {
        let end = self.data.len().min(first + count);
        let beyond = self.most + 1;
        self.data[first..end].iter().map(move |level| usize::from((*level).min(beyond).unsigned_abs()))
    }

    fn advance(&mut self) {
        let [nx, ny, nz] = self.size;
        match self.axis {
            0 => {
                let start = (self.at * ny + self.row) * nx;
                first_pass(&mut self.data[start..start + nx], self.reach);
            }
            axis => {
                let rows = if axis == 1 { ny } else { nz };
                if self.row == 0 {
                    self.keep_layer(rows);
                }
                let start = self.start(self.row);
                gather(
                    &mut self.data[start..start + nx],
                    &self.layer,
                    &self.least,
                    self.row,
                    self.reach,
                    self.most,
                );
            }
        }
        self.row += 1;
        let (rows, layers) = if self.axis == 2 { (nz, ny) } else { (ny, nz) };
        if self.row == rows {
            (self.row, self.at) = (0, self.at + 1);
        }
        if self.at == layers {
            let is_long = |axis: &usize| self.size.get(*axis).is_none_or(|count| *count > 1);
            (self.at, self.axis) = (0, (self.axis + 1..=3).find(is_long).unwrap_or(3));
        }
    }

    /// Where a row of the present layer starts.
    fn start(&self, row: usize) -> usize {
        let [nx, ny, _] = self.size;
        nx * if self.axis == 1 { self.at * ny + row } else { row * ny + self.at }
    }

    fn keep_layer(&mut self, rows: usize) {
        let nx = self.size[0];
        self.layer.clear();
        for row in 0..rows {
            let start = self.start(row);
            self.layer.extend_from_slice(&self.data[start..start + nx]);
        }
        self.least.clear();
        self.least.extend(self.layer.chunks_exact(nx).map(|row| row.iter().copied().min().unwrap_or(FAR)));
    }
}

/// The first axis, from the last feature on either side.
fn first_pass(row: &mut [i16], reach: usize) {
    let square = |voxels: usize| if voxels > reach { FAR } else { (voxels * voxels) as i16 };
    let mut last = usize::MAX;
    for (n, value) in row.iter_mut().enumerate() {
        if *value == 0 {
            last = n;
        } else if last != usize::MAX {
            *value = square(n - last);
        }
    }
    last = usize::MAX;
    for (n, value) in row.iter_mut().enumerate().rev() {
        if *value == 0 {
            last = n;
        } else if last != usize::MAX {
            *value = (*value).min(square(last - n));
        }
    }
}

/// A row from those of its layer within the limit, four of them at a time, so that it is read and written once for four.
fn gather(row: &mut [i16], layer: &[i16], least: &[i16], at: usize, reach: usize, most: i16) {
    let nx = row.len();
    let mut near = [(0, 0); 2 * LONGEST_WINDOW];
    let mut count = 0;
    for away in 1..=reach {
        let square = (away * away) as i16;
        let both = [at.checked_sub(away), at.checked_add(away).filter(|other| *other < least.len())];
        for other in both.into_iter().flatten() {
            if least[other] <= most - square {
                near[count] = (other, square);
                count += 1;
            }
        }
    }
    for four in near[..count].chunks(4) {
        // The last of fewer than four counts again, which changes nothing.
        let [a, b, c, d] = [0, 1, 2, 3].map(|n: usize| four[n.min(four.len() - 1)]);
        let of = |(other, _): (usize, i16)| &layer[other * nx..][..nx];
        for ((((value, from_a), from_b), from_c), from_d) in
            row.iter_mut().zip(of(a)).zip(of(b)).zip(of(c)).zip(of(d))
        {
            let nearer = (*from_a + a.1).min(*from_b + b.1);
            let farther = (*from_c + c.1).min(*from_d + d.1);
            *value = (*value).min(nearer).min(farther);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::test_grids::{brute_force, random_features, sizes};
    use super::*;

    fn run(grid: &Grid, limit: f64, features: &[u8]) -> Vec<Option<usize>> {
        let mut job = Window::new(grid, limit, |index| features[index] != 0);
        assert!(job.step(&mut || true));
        found(&job)
    }

    /// None beyond the limit.
    fn found(job: &Window) -> Vec<Option<usize>> {
        job.levels(0, job.count()).map(|level| Some(level).filter(|it| *it < job.beyond())).collect()
    }

    #[test]
    fn distances_up_to_the_limit_are_those_of_all_pairs_and_the_rest_is_far() {
        for (size, seed) in sizes().into_iter().zip(1..) {
            let grid = Grid::new(size, [1.0; 3]).unwrap();
            for (limit, share) in [
                (0.0, 0.1),
                (1.0, 0.1),
                (1.5, 0.1),
                (5.4, 0.02),
                (16.0, 0.004),
                (LONGEST_WINDOW as f64, 0.003),
            ] {
                let features = random_features(&grid, share, seed);
                let within = |level: f64| (level <= limit * limit).then_some(level as usize);
                let expected: Vec<_> =
                    brute_force(&grid, &features).into_iter().map(|(level, _)| within(level)).collect();
                assert_eq!(run(&grid, limit, &features), expected, "{size:?}, {limit}");
            }
        }
    }

    /// The largest sum that is formed: no number overflows.
    #[test]
    fn the_longest_window_reaches_its_end_and_no_farther() {
        let grid = Grid::new([1, 260, 1], [1.0; 3]).unwrap();
        let mut features = vec![0; 260];
        features[0] = 1;
        let found = run(&grid, LONGEST_WINDOW as f64, &features);
        assert_eq!((found[120], found[121], found[259]), (Some(14_400), None, None));
    }

    #[test]
    fn it_can_be_stopped_after_every_row() {
        let grid = Grid::new([20, 9, 5], [1.0; 3]).unwrap();
        let features = random_features(&grid, 0.02, 9);
        let mut job = Window::new(&grid, 6.3, |index| features[index] != 0);
        let mut steps = 1;
        while !job.step(&mut || false) {
            assert!((0.0..1.0).contains(&job.progress()));
            steps += 1;
        }
        assert_eq!(steps, 3 * 45);
        assert_eq!(found(&job), run(&grid, 6.3, &features));
    }
}
