//! A square of pixels on which what panels away from it do is interpolated between Chebyshev's places.

use super::single::LANES;
use std::f64::consts::PI;

/// Places along a side, as many as are worked on together.
pub(super) const NODES: usize = LANES;

/// Numbers at the places of a square, row by row.
pub(super) type Grid = [[f64; NODES]; NODES];

/// Weights by which numbers at the places give those between: of each pixel along the side of a square, for one place after the other.
#[derive(Debug, Clone)]
pub(super) struct Weights {
    side: usize,
    list: Vec<f64>,
}

impl Weights {
    /// Those of a square of so many pixels.
    pub(super) fn new(side: usize) -> Self {
        let mut list = vec![0.0; NODES * side];
        for pixel in 0..side {
            let weights = weights(2.0 * (pixel as f64 + 0.5) / side as f64 - 1.0);
            for (node, weight) in weights.into_iter().enumerate() {
                list[node * side + pixel] = weight;
            }
        }
        Self { side, list }
    }

    /// Numbers between rows of places, on a row of pixels.
    pub(super) fn row(&self, grid: &Grid, pixel: usize) -> [f64; NODES] {
        let mut row = [0.0; NODES];
        for (node, numbers) in grid.iter().enumerate() {
            let weight = self.list[node * self.side + pixel];
            row.iter_mut().zip(numbers).for_each(|(sum, number)| *sum += weight * number);
        }
        row
    }

    /// Numbers of pixels from one on, of such a row.
    #[inline(always)]
    pub(super) fn pixels(&self, row: &[f64; NODES], first: usize) -> [f64; LANES] {
        let mut sums = [0.0; LANES];
        for (node, number) in row.iter().enumerate() {
            let weights = &self.list[node * self.side + first..][..LANES];
            sums.iter_mut().zip(weights).for_each(|(sum, weight)| *sum += weight * number);
        }
        sums
    }
}

/// A place of Chebyshev's in [-1, 1].
pub(super) fn place(number: usize) -> f64 {
    -(PI * (number as f64 + 0.5) / NODES as f64).cos()
}

/// Lagrange's polynomials of these places at x.
fn weights(x: f64) -> [f64; NODES] {
    std::array::from_fn(|own| {
        let factor = |other: usize| (x - place(other)) / (place(own) - place(other));
        (0..NODES).filter(|other| *other != own).map(factor).product()
    })
}

/// Of a place of each half of a square, the weights of the places of the whole.
pub(super) fn halves() -> [[[f64; NODES]; NODES]; 2] {
    [-0.5, 0.5].map(|middle| std::array::from_fn(|node| weights(middle + 0.5 * place(node))))
}

/// The numbers at the places of a quarter, from those of the whole square and the weights of the halves along both sides.
pub(super) fn quarter(grid: &Grid, across: &[[f64; NODES]; NODES], along: &[[f64; NODES]; NODES]) -> Grid {
    std::array::from_fn(|row| {
        let mut between = [0.0; NODES];
        for (weight, numbers) in along[row].iter().zip(grid) {
            between.iter_mut().zip(numbers).for_each(|(sum, number)| *sum += weight * number);
        }
        std::array::from_fn(|column| {
            across[column].iter().zip(&between).map(|(weight, number)| weight * number).sum()
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of degree 7 in each of its variables.
    fn polynomial(x: f64, y: f64) -> f64 {
        (x - 0.3).powi(7) * (y + 0.2).powi(6) + 2.0 * x * y.powi(7) - y
    }

    fn of(middle: [f64; 2], half: f64) -> Grid {
        std::array::from_fn(|row| {
            std::array::from_fn(|column| {
                polynomial(middle[0] + half * place(column), middle[1] + half * place(row))
            })
        })
    }

    #[test]
    fn polynomials_are_met_on_pixels_and_in_quarters() {
        let grid = of([0.0; 2], 1.0);
        let weights = Weights::new(16);
        for j in 0..16 {
            let row = weights.row(&grid, j);
            for first in [0, 8] {
                for (lane, found) in weights.pixels(&row, first).into_iter().enumerate() {
                    let [x, y] = [first + lane, j].map(|k| (k as f64 + 0.5) / 8.0 - 1.0);
                    assert!((found - polynomial(x, y)).abs() < 1e-12);
                }
            }
        }
        let halves = halves();
        for (right, up) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let found = quarter(&grid, &halves[right], &halves[up]);
            let exact = of([right, up].map(|half| half as f64 - 0.5), 0.5);
            for (found, exact) in found.iter().flatten().zip(exact.iter().flatten()) {
                assert!((found - exact).abs() < 1e-12, "{found}, not {exact}");
            }
        }
    }
}
