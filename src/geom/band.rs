//! Symmetric systems whose entries lie near the diagonal.

use glam::DVec2;

/// A pivot below this part of its diagonal entry is rounding noise: the matrix is singular for all that can be told.
const SINGULAR: f64 = 1e-13;

/// A symmetric positive definite matrix whose entries lie within `width` places of the diagonal, which may wrap round.
///
/// The last `width` rows of a matrix that wraps are kept in full, since elimination fills them; the others take `width` + 1
/// entries. Time and memory grow linearly with the order.
#[derive(Debug, Clone)]
pub struct BandMatrix {
    width: usize,
    /// Rows kept as a band; the rows after them are kept in full.
    banded: usize,
    order: usize,
    /// Entry (i, j) with i - width <= j <= i of the banded rows, at `i * (width + 1) + width + j - i`.
    band: Vec<f64>,
    /// Entry (i, j) of the full rows, at `(i - banded) * order + j`.
    full: Vec<f64>,
}

impl BandMatrix {
    /// A matrix of zeros.
    #[must_use]
    pub fn new(order: usize, width: usize, wraps: bool) -> Self {
        let banded = match wraps {
            true if order > 2 * width => order - width,
            true => 0,
            false => order,
        };
        let full = vec![0.0; (order - banded) * order];
        Self { width, banded, order, band: vec![0.0; banded * (width + 1)], full }
    }

    /// Adds to the entry in row `i` and column `j`, which is not above the diagonal (`j` is at most `i`).
    ///
    /// # Panics
    /// When the entry lies above the diagonal or outside the band.
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        *self.entry(i, j) += value;
    }

    /// Solves for two right-hand sides at once, by Cholesky's method; `None` when the matrix is not positive definite.
    ///
    /// # Panics
    /// When there are fewer right-hand sides than rows.
    #[must_use]
    pub fn solve(mut self, mut right: Vec<DVec2>) -> Option<Vec<DVec2>> {
        self.factor()?;
        for i in 0..self.order {
            let sum = (self.first(i)..i).map(|j| right[j] * self.at(i, j)).sum::<DVec2>();
            right[i] = (right[i] - sum) / self.at(i, i);
        }
        for i in (0..self.order).rev() {
            right[i] /= self.at(i, i);
            for j in self.first(i)..i {
                let value = right[i];
                right[j] -= value * self.at(i, j);
            }
        }
        Some(right)
    }

    /// Replaces the matrix by its lower triangular factor.
    fn factor(&mut self) -> Option<()> {
        for i in 0..self.order {
            for j in self.first(i)..=i {
                let start = self.first(i).max(self.first(j));
                let dot: f64 = (start..j).map(|k| self.at(i, k) * self.at(j, k)).sum();
                let value = self.at(i, j) - dot;
                if j < i {
                    *self.entry(i, j) = value / self.at(j, j);
                } else if value > SINGULAR * self.at(i, i) {
                    *self.entry(i, i) = value.sqrt();
                } else {
                    return None;
                }
            }
        }
        Some(())
    }

    /// The first column of a row that holds an entry.
    fn first(&self, i: usize) -> usize {
        if i < self.banded { i.saturating_sub(self.width) } else { 0 }
    }

    fn at(&self, i: usize, j: usize) -> f64 {
        if i < self.banded {
            self.band[i * (self.width + 1) + self.width + j - i]
        } else {
            self.full[(i - self.banded) * self.order + j]
        }
    }

    fn entry(&mut self, i: usize, j: usize) -> &mut f64 {
        assert!(j <= i && j >= self.first(i), "({i}, {j}) is outside the band");
        if i < self.banded {
            &mut self.band[i * (self.width + 1) + self.width + j - i]
        } else {
            &mut self.full[(i - self.banded) * self.order + j]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

    /// The product with a matrix given by its entries, for the comparison.
    fn product(order: usize, entries: &[(usize, usize, f64)], x: &[DVec2]) -> Vec<DVec2> {
        let mut result = vec![DVec2::ZERO; order];
        for &(i, j, value) in entries {
            result[i] += x[j] * value;
            if i != j {
                result[j] += x[i] * value;
            }
        }
        result
    }

    #[test]
    fn solves_what_was_multiplied_whether_it_wraps_or_not() {
        for (order, wraps) in
            [(1, false), (2, true), (5, true), (6, true), (7, true), (40, true), (40, false)]
        {
            let width = 3;
            let mut entries = Vec::new();
            for i in 0..order {
                entries.push((i, i, 4.0 + (i % 3) as f64));
                for d in 1..=width.min(order - 1) {
                    let j = i + d;
                    if j >= order && (!wraps || 2 * d >= order) {
                        continue;
                    }
                    let (row, column) = (i.max(j % order), i.min(j % order));
                    entries.push((row, column, 0.5 / d as f64 - 0.1 * (i % 2) as f64));
                }
            }
            let mut matrix = BandMatrix::new(order, width, wraps);
            for &(i, j, value) in &entries {
                matrix.add(i, j, value);
            }
            let x: Vec<_> = (0..order).map(|i| dvec2((i as f64).sin(), 1.0 / (1.0 + i as f64))).collect();
            let solved = matrix.solve(product(order, &entries, &x)).expect("positive definite");
            for (a, b) in solved.iter().zip(&x) {
                assert!(a.distance(*b) < 1e-12, "order {order}, wraps {wraps}");
            }
        }
    }

    #[test]
    fn a_singular_matrix_is_refused() {
        let mut matrix = BandMatrix::new(3, 1, false);
        for (i, j, value) in [(0, 0, 1.0), (1, 0, 1.0), (1, 1, 1.0), (2, 2, 1.0)] {
            matrix.add(i, j, value);
        }
        assert_eq!(matrix.solve(vec![DVec2::ONE; 3]), None);
        assert_eq!(BandMatrix::new(2, 3, true).solve(vec![DVec2::ONE; 2]), None, "a matrix of zeros");
    }
}
