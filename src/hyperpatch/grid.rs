//! Points and compositions of a cell on a regular grid of its parameters.

use super::Cell;
use super::bernstein::cubic;
use std::error::Error;
use std::fmt;

/// Largest number of points of a grid along one axis.
pub const LARGEST_GRID: usize = 512;

/// How many lines forward differencing runs side by side, so that additions need not wait for each other.
const SIDE_BY_SIDE: usize = 8;

/// Evaluates cells on a grid of parameters, one list of `f32` for each component: x, y, z, then the fraction of each
/// material. The last parameter runs fastest; the first and the last point of an axis are its ends.
///
/// The buffers are used again from cell to cell. It serves pictures and exports: checks of validity and continuity
/// work on the coefficients.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    counts: [usize; 3],
    /// The four cubic polynomials at the parameters of each axis, one list for each polynomial.
    weights: [[Vec<f64>; 4]; 3],
    components: Vec<Vec<f32>>,
}

/// A grid with fewer than 2 points along an axis, or more than [`LARGEST_GRID`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GridError {
    /// Points along each axis, as given.
    pub counts: [usize; 3],
}

impl fmt::Display for GridError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b, c] = self.counts;
        write!(f, "a grid of {a} x {b} x {c} points; expected 2 to {LARGEST_GRID} along each axis")
    }
}

impl Error for GridError {}

impl Grid {
    /// A grid of the given numbers of points along u, v and w.
    ///
    /// # Errors
    /// When a number is below 2 or above [`LARGEST_GRID`].
    pub fn new(counts: [usize; 3]) -> Result<Self, GridError> {
        if counts.iter().any(|count| !(2..=LARGEST_GRID).contains(count)) {
            return Err(GridError { counts });
        }
        let weights = counts.map(|count| {
            let at = |n: usize, step: usize| cubic(step as f64 / (count - 1) as f64)[n];
            std::array::from_fn(|n| (0..count).map(|step| at(n, step)).collect())
        });
        Ok(Self { counts, weights, components: Vec::new() })
    }

    /// Numbers of points along u, v and w.
    #[must_use]
    pub fn counts(&self) -> [usize; 3] {
        self.counts
    }

    /// What was evaluated last: x, y, z and the fraction of each material at every point.
    #[must_use]
    pub fn components(&self) -> &[Vec<f32>] {
        &self.components
    }

    /// Evaluates a cell by tensor contraction: the sum over i once for each u, that over j once for each (u, v), and
    /// that over k for each point.
    pub fn evaluate(&mut self, cell: &Cell) {
        let weights =
            &self.weights[2].each_ref().map(|list| list.iter().map(|&w| w as f32).collect::<Vec<f32>>());
        self.fill(cell, |lines, out| {
            for (line, row) in lines.iter().zip(out.chunks_exact_mut(weights[0].len())) {
                let [a, b, c, d] = line.map(|value| value as f32);
                let [w0, w1, w2, w3] = weights.each_ref().map(|list| &list[..row.len()]);
                for (k, value) in row.iter_mut().enumerate() {
                    *value = a * w0[k] + b * w1[k] + c * w2[k] + d * w3[k];
                }
            }
        });
    }

    /// Evaluates a cell by forward differences along w: three additions a point. They run in `f64`, so the drift at
    /// the end of a line stays below what `f32` resolves.
    pub fn difference(&mut self, cell: &Cell) {
        let count = self.counts[2];
        let h = 1.0 / (count - 1) as f64;
        self.fill(cell, |lines, out| {
            for (lines, rows) in lines.chunks(SIDE_BY_SIDE).zip(out.chunks_mut(SIDE_BY_SIDE * count)) {
                let mut state = [[0.0; SIDE_BY_SIDE]; 4];
                for (n, &[a, b, c, d]) in lines.iter().enumerate() {
                    let (c1, c2, c3) = (3.0 * (b - a), 3.0 * (a - 2.0 * b + c), d - a + 3.0 * (b - c));
                    state[0][n] = a;
                    state[1][n] = h * (c1 + h * (c2 + h * c3));
                    state[2][n] = h * h * (2.0 * c2 + 6.0 * h * c3);
                    state[3][n] = 6.0 * h * h * h * c3;
                }
                let [value, first, second, third] = &mut state;
                for k in 0..count {
                    for (row, value) in rows.chunks_exact_mut(count).zip(&*value) {
                        row[k] = *value as f32;
                    }
                    for n in 0..SIDE_BY_SIDE {
                        value[n] += first[n];
                        first[n] += second[n];
                        second[n] += third[n];
                    }
                }
            }
        });
    }

    /// Contracts the first two axes of every component and hands the cubics that are left for each u, one for each v,
    /// to `run` with the values to fill in.
    fn fill(&mut self, cell: &Cell, run: impl Fn(&[[f64; 4]], &mut [f32])) {
        let [nu, nv, nw] = self.counts;
        let component = |n: usize| match n {
            0..3 => cell.net().0.map(|point| point[n]),
            _ => cell.fractions()[n - 3],
        };
        self.components.resize_with(3 + cell.materials(), Vec::new);
        let [weights_u, weights_v, _] = &self.weights;
        let mut lines = vec![[0.0; 4]; nv];
        for (n, out) in self.components.iter_mut().enumerate() {
            out.resize(nu * nv * nw, 0.0);
            let net = component(n);
            for (a, plane) in out.chunks_exact_mut(nv * nw).enumerate() {
                let u: [f64; 4] = std::array::from_fn(|i| weights_u[i][a]);
                let layer: [f64; 16] = std::array::from_fn(|m| {
                    net[m] * u[0] + net[m + 16] * u[1] + net[m + 32] * u[2] + net[m + 48] * u[3]
                });
                for (b, line) in lines.iter_mut().enumerate() {
                    let v: [f64; 4] = std::array::from_fn(|j| weights_v[j][b]);
                    *line = std::array::from_fn(|k| {
                        layer[k] * v[0] + layer[k + 4] * v[1] + layer[k + 8] * v[2] + layer[k + 12] * v[3]
                    });
                }
                run(&lines, plane);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::Corner;
    use crate::hyperpatch::test_cells::{random, random_net};
    use crate::material::Composition;
    use glam::DVec3;

    fn cell() -> Cell {
        let corners = Corner::all().map(|corner| {
            let share = random(corner.coefficient() as u64);
            Composition::new(vec![share / 2.0, share / 2.0, 1.0 - share]).unwrap()
        });
        Cell::with_corner_mixes(random_net(1, 0.3), &corners).unwrap()
    }

    /// Every point and fraction within a few roundings of `f32` of what the cell says, by either method.
    #[test]
    fn grids_hold_what_the_cell_says() {
        let cell = cell();
        let counts = [5, 11, 65];
        let mut grid = Grid::new(counts).unwrap();
        for method in [Grid::evaluate, Grid::difference] {
            method(&mut grid, &cell);
            assert_eq!(grid.components().len(), 6);
            for a in 0..5 {
                for b in 0..11 {
                    for c in 0..65 {
                        let at = DVec3::new(a as f64 / 4.0, b as f64 / 10.0, c as f64 / 64.0);
                        let (point, mix) = (cell.point(at), cell.composition(at));
                        let expected = point.to_array().into_iter().chain(mix.fractions().iter().copied());
                        for (component, value) in grid.components().iter().zip(expected) {
                            let found = f64::from(component[(a * 11 + b) * 65 + c]);
                            assert!((found - value).abs() < 4e-7, "{found}, expected {value}, at {at}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn a_grid_fits_itself_to_the_next_cell() {
        let mut grid = Grid::new([2, 2, 2]).unwrap();
        grid.evaluate(&cell());
        let one = Cell::uniform(random_net(2, 0.1), &Composition::pure(0, 1)).unwrap();
        grid.evaluate(&one);
        assert_eq!(grid.components().len(), 4);
        assert_eq!(grid.components()[3], [1.0; 8]);
        let corners = one.net().corners().map(|corner| corner.x as f32);
        assert_eq!(grid.components()[0], corners);
    }

    #[test]
    fn grids_too_small_or_too_large_are_refused() {
        for counts in [[1, 5, 5], [5, 0, 5], [5, 5, LARGEST_GRID + 1]] {
            assert_eq!(Grid::new(counts), Err(GridError { counts }));
        }
        assert!(GridError { counts: [1, 5, 5] }.to_string().contains("1 x 5 x 5"));
    }
}
