//! The transform in the plane as it can be watched.

use super::envelope::{first_pass, traced};
use super::scan::{Search, search};
use crate::field::Grid;

/// Most pixels of a transform that is watched: 128 x 128.
pub const MOST_TRACED: usize = 1 << 14;

/// What both methods do in the plane, pass by pass. Squared distances are in pixels, and infinite without a feature.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    /// Squared distance of each pixel to the nearest feature in its row: g of the paper.
    pub rows: Vec<f32>,
    /// The second pass, column by column.
    pub columns: Vec<ColumnTrace>,
    /// Squared distance of each pixel to the nearest feature.
    pub levels: Vec<f32>,
}

/// What happens in a column.
#[derive(Debug, Clone, PartialEq)]
pub struct ColumnTrace {
    /// The rows whose parabolas are corners of the lower convex hull, ascending: each is least somewhere, at pixels or between them, or along
    /// with its neighbours.
    pub corners: Vec<usize>,
    /// The searches of the scan, in their order.
    pub searches: Vec<Search>,
}

/// Follows the transform of a grid of one layer, and the scan of the paper.
///
/// # Panics
/// When the grid has several layers, or there are not as many features as pixels.
#[must_use]
pub fn trace(grid: &Grid, features: &[u8]) -> Trace {
    let [nx, ny, nz] = grid.size();
    assert!(nz == 1 && features.len() == grid.count(), "a plane with a number for each pixel");
    let seed = |feature: &u8| if *feature == 0 { f32::INFINITY } else { 0.0 };
    let mut rows: Vec<f32> = features.iter().map(seed).collect();
    for row in rows.chunks_exact_mut(nx) {
        first_pass(row, 1.0);
    }
    let mut levels = rows.clone();
    let mut column = |x: usize| {
        let before: Vec<f32> = (0..ny).map(|y| rows[y * nx + x]).collect();
        let (mut line, mut scanned, mut searches) = (before.clone(), before.clone(), Vec::new());
        let corners = traced(&mut line);
        search(&mut scanned, &before, |each| searches.push(each));
        line.iter().enumerate().for_each(|(y, level)| levels[y * nx + x] = *level);
        ColumnTrace { corners, searches }
    };
    let columns = (0..nx).map(&mut column).collect();
    Trace { rows, columns, levels }
}

#[cfg(test)]
mod tests {
    use super::super::scan;
    use super::super::test_grids::{brute_force, random_features};
    use super::*;

    #[test]
    fn what_is_watched_is_what_is_found() {
        for (size, share, seed) in
            [([1, 1], 0.5, 1), ([37, 23], 0.02, 2), ([24, 40], 0.2, 3), ([1, 30], 0.1, 4), ([9, 9], 0.0, 5)]
        {
            let grid = Grid::new([size[0], size[1], 1], [1.0; 3]).unwrap();
            let features = random_features(&grid, share, seed);
            let found = trace(&grid, &features);
            let expected = brute_force(&grid, &features);
            let is_same = |(a, (b, _)): (&f32, &(f64, usize))| f64::from(*a) == *b;
            assert!(found.levels.iter().zip(&expected).all(is_same), "{size:?}");
            let all = found.columns.iter().flat_map(|column| &column.searches);
            assert_eq!(all.map(|each| each.count as u64).sum::<u64>(), scan(&grid, &features).extra);
            let is_within = |each: &Search| each.count >= 1 && each.count <= each.reach;
            assert!(found.columns.iter().flat_map(|column| &column.searches).all(is_within));
            for (x, column) in found.columns.iter().enumerate() {
                let at = |y: usize| found.rows[y * size[0] + x];
                let level = |y: usize, from: &usize| at(*from) + y.abs_diff(*from).pow(2) as f32;
                for y in 0..size[1] {
                    let least =
                        column.corners.iter().map(|from| level(y, from)).fold(f32::INFINITY, f32::min);
                    assert_eq!(found.levels[y * size[0] + x], least, "the envelope of the corners alone");
                }
            }
        }
    }

    /// One pixel in the middle of a row below nothing: its parabola alone, and a search that goes all the way.
    #[test]
    fn a_column_without_a_choice_has_one_parabola() {
        let grid = Grid::new([3, 5, 1], [1.0; 3]).unwrap();
        let mut features = vec![0; 15];
        features[1] = 1;
        let found = trace(&grid, &features);
        assert_eq!(found.columns[0].corners, [0]);
        assert_eq!(found.columns[0].searches, [Search { from: 0, is_forward: true, reach: 4, count: 4 }]);
        assert_eq!(found.levels[12..], [17.0, 16.0, 17.0]);
    }
}
