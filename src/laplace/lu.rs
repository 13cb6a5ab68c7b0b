//! Gauss' elimination with partial pivoting, as a reference, and the condition number that it allows to estimate.

use super::matrix::{Matrix, dot};

/// Most unknowns: the time grows as their cube.
pub const MOST_LU: usize = 2_000;

/// Estimates of the inverse's norm are better than a third in practice, and end after so many solutions.
const MOST_ESTIMATES: usize = 5;

/// A matrix as the product of a lower and an upper triangle, made column by column.
#[derive(Debug)]
pub(super) struct Lu {
    n: usize,
    /// Row by row: the factors below the diagonal, the upper triangle from it on.
    entries: Vec<f64>,
    /// Which row of the matrix stands in each row.
    order: Vec<usize>,
    /// Largest sum of the sizes of a column: the 1-norm.
    norm: f64,
    /// The next column.
    column: usize,
    is_singular: bool,
}

impl Lu {
    /// Of a whole matrix; `None` where there is none.
    pub(super) fn new(matrix: &Matrix) -> Option<Self> {
        let n = matrix.len();
        let mut entries = Vec::with_capacity(n * n);
        let mut sums = vec![0.0; n];
        for row in 0..n {
            entries.extend(matrix.row(row)?.iter().map(|entry| f64::from(*entry)));
            entries[row * n + row] = matrix.diagonal[row];
            sums.iter_mut().zip(&entries[row * n..]).for_each(|(sum, entry)| *sum += entry.abs());
        }
        let norm = sums.into_iter().fold(0.0, f64::max);
        Some(Self { n, entries, order: (0..n).collect(), norm, column: 0, is_singular: false })
    }

    /// Eliminates columns while `may_go_on` says so; returns whether all are.
    pub(super) fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> bool {
        while self.column < self.n {
            self.eliminate();
            if !may_go_on() {
                break;
            }
        }
        self.column == self.n
    }

    /// Share of the work that is done.
    pub(super) fn progress(&self) -> f64 {
        1.0 - (1.0 - self.column as f64 / self.n.max(1) as f64).powi(3)
    }

    /// Whether a pivot was 0.
    pub(super) fn is_singular(&self) -> bool {
        self.is_singular
    }

    fn eliminate(&mut self) {
        let (n, k) = (self.n, self.column);
        self.column += 1;
        let size = |row: &usize| self.entries[row * n + k].abs();
        let pivot = (k..n).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(k);
        if pivot != k {
            self.order.swap(k, pivot);
            let (above, below) = self.entries.split_at_mut(pivot * n);
            above[k * n..(k + 1) * n].swap_with_slice(&mut below[..n]);
        }
        let (above, below) = self.entries.split_at_mut((k + 1) * n);
        let own = &above[k * n + k..];
        if own[0] == 0.0 {
            self.is_singular = true;
            return;
        }
        for row in below.chunks_exact_mut(n) {
            let factor = row[k] / own[0];
            row[k] = factor;
            if factor != 0.0 {
                row[k + 1..].iter_mut().zip(&own[1..]).for_each(|(entry, above)| *entry -= factor * above);
            }
        }
    }

    /// The solution of A x = b.
    pub(super) fn solve(&self, b: &[f64]) -> Vec<f64> {
        let n = self.n;
        let mut x: Vec<f64> = self.order.iter().map(|row| b[*row]).collect();
        for k in 0..n {
            x[k] -= dot(&self.entries[k * n..k * n + k], &x[..k]);
        }
        for k in (0..n).rev() {
            let row = &self.entries[k * n..(k + 1) * n];
            x[k] = (x[k] - dot(&row[k + 1..], &x[k + 1..])) / row[k];
        }
        x
    }

    /// The solution of A^T x = b.
    fn solve_transposed(&self, b: &[f64]) -> Vec<f64> {
        let n = self.n;
        let mut y = b.to_vec();
        for k in 0..n {
            let row = &self.entries[k * n..(k + 1) * n];
            y[k] /= row[k];
            let part = y[k];
            y[k + 1..].iter_mut().zip(&row[k + 1..]).for_each(|(y, entry)| *y -= part * entry);
        }
        for k in (0..n).rev() {
            let part = y[k];
            y[..k].iter_mut().zip(&self.entries[k * n..]).for_each(|(y, entry)| *y -= part * entry);
        }
        let mut x = vec![0.0; n];
        for (row, y) in self.order.iter().zip(y) {
            x[*row] = y;
        }
        x
    }
}

/// An estimate, from below, of the condition number in the 1-norm (Hager 1984, Higham 1988), one solution after the other.
#[derive(Debug)]
pub(super) struct Estimate {
    x: Vec<f64>,
    inverse: f64,
    tries: usize,
}

impl Estimate {
    pub(super) fn new(lu: &Lu) -> Self {
        Self { x: vec![1.0 / lu.n as f64; lu.n], inverse: 0.0, tries: 0 }
    }

    /// Goes on by a few solutions; returns the estimate when it is there.
    pub(super) fn step(&mut self, lu: &Lu) -> Option<f64> {
        let n = lu.n;
        let size = |x: &[f64]| x.iter().map(|x| x.abs()).sum::<f64>();
        if lu.is_singular {
            return Some(f64::INFINITY);
        }
        if self.tries < MOST_ESTIMATES {
            self.tries += 1;
            let y = lu.solve(&self.x);
            let found = size(&y);
            let signs: Vec<f64> = y.iter().map(|y| 1.0_f64.copysign(*y)).collect();
            let z = lu.solve_transposed(&signs);
            let largest = (0..n).max_by(|a, b| z[*a].abs().total_cmp(&z[*b].abs())).unwrap_or(0);
            if found <= self.inverse || z[largest].abs() <= dot(&z, &self.x) {
                self.tries = MOST_ESTIMATES;
            } else {
                self.x.fill(0.0);
                self.x[largest] = 1.0;
            }
            self.inverse = self.inverse.max(found);
            return None;
        }
        // Higham's second try catches what cancels in the first.
        let even = 1.0 / (n.max(2) - 1) as f64;
        let slope = |k: usize| (1.0 + k as f64 * even) * if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        let other = lu.solve(&(0..n).map(slope).collect::<Vec<_>>());
        Some(lu.norm * self.inverse.max(2.0 * size(&other) / (3.0 * n as f64)))
    }
}
