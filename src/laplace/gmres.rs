//! Restarted generalized minimal residuals with a left preconditioner (Saad and Schultz 1986; Liu and others 2003, appendix, whose line 6 is to read
//! h = (w, v_i)): Arnoldi's process by modified Gram-Schmidt, Givens rotations.
//!
//! What is made small is the preconditioned residual. The products A v are kept, so that the true residual costs no further product; it decides when to stop.

use super::matrix::{Matrix, Spread, dot, norm};
use super::precondition::{Preconditioner, Sweep};

/// How to solve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GmresOptions {
    /// What the residual is made even by.
    pub preconditioner: Preconditioner,
    /// Iterations after which the process starts anew from what it has, at least 1.
    pub restart: usize,
    /// The true residual over the right-hand side at which to stop, above 0.
    pub tolerance: f64,
    /// Iterations after which to give up.
    pub most_iterations: usize,
}

impl Default for GmresOptions {
    fn default() -> Self {
        Self { preconditioner: Preconditioner::Jacobi, restart: 100, tolerance: 1e-6, most_iterations: 500 }
    }
}

/// How the residuals fell. Both lists start with 1 at no iteration.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Convergence {
    /// |b - A x| over |b|.
    pub residuals: Vec<f64>,
    /// |M^-1 (b - A x)| over |M^-1 b|.
    pub preconditioned: Vec<f64>,
    /// Whether the tolerance was reached.
    pub is_converged: bool,
}

impl Convergence {
    /// Number of iterations.
    #[must_use]
    pub fn iterations(&self) -> usize {
        self.residuals.len().saturating_sub(1)
    }
}

/// A system being solved.
#[derive(Debug)]
pub(super) struct Gmres {
    options: GmresOptions,
    b: Vec<f64>,
    x: Vec<f64>,
    /// The true residual at the last start.
    residual: Vec<f64>,
    /// Orthonormal basis, and what the matrix makes of it.
    basis: Vec<Vec<f64>>,
    images: Vec<Vec<f64>>,
    /// Columns of the triangle that the rotations make of Hessenberg's matrix.
    triangle: Vec<Vec<f64>>,
    rotations: Vec<[f64; 2]>,
    /// The rotated right-hand side of the small problem.
    right: Vec<f64>,
    /// |b| and |M^-1 b|.
    scales: [f64; 2],
    found: Convergence,
    work: Work,
}

#[derive(Debug)]
enum Work {
    /// Rows of A x that are done, with what they have in common.
    Residual(usize, Option<Spread>, Vec<f64>),
    Start(Sweep, Vec<f64>),
    /// Rows of A v that are done.
    Product(usize, Option<Spread>, Vec<f64>),
    Iterate(Sweep, Vec<f64>),
    Done,
}

impl Gmres {
    pub(super) fn new(options: GmresOptions, b: Vec<f64>) -> Self {
        let n = b.len();
        let scale = norm(&b);
        let mut found = Convergence { residuals: vec![1.0], preconditioned: vec![1.0], is_converged: false };
        let work = if scale == 0.0 {
            found = Convergence { residuals: vec![0.0], preconditioned: vec![0.0], is_converged: true };
            Work::Done
        } else {
            Work::Start(Sweep::new(options.preconditioner), b.clone())
        };
        Self {
            x: vec![0.0; n],
            residual: b.clone(),
            b,
            basis: Vec::new(),
            images: Vec::new(),
            triangle: Vec::new(),
            rotations: Vec::new(),
            right: Vec::new(),
            scales: [scale, 0.0],
            found,
            work,
            options,
        }
    }

    /// Goes on while `may_go_on` says so; returns whether it is at an end.
    pub(super) fn step(&mut self, matrix: &Matrix, may_go_on: &mut dyn FnMut() -> bool) -> bool {
        loop {
            let work = std::mem::replace(&mut self.work, Work::Done);
            self.work = self.advance(matrix, work, may_go_on);
            if matches!(self.work, Work::Done) {
                return true;
            }
            if !may_go_on() {
                return false;
            }
        }
    }

    /// Iterations done, and the true residual over the right-hand side.
    pub(super) fn state(&self) -> (usize, f64) {
        (self.found.iterations(), self.found.residuals.last().copied().unwrap_or(1.0))
    }

    /// The solution and how it was reached.
    pub(super) fn finish(self) -> (Vec<f64>, Convergence) {
        (self.x, self.found)
    }

    fn advance(&mut self, matrix: &Matrix, work: Work, may_go_on: &mut dyn FnMut() -> bool) -> Work {
        match work {
            Work::Residual(row, spread, mut y) => {
                let spread = spread.unwrap_or_else(|| matrix.spread(&self.x));
                let end = multiply(matrix, &self.x, &spread, row, &mut y, may_go_on);
                if end < y.len() {
                    return Work::Residual(end, Some(spread), y);
                }
                y.iter_mut().zip(&self.b).for_each(|(y, b)| *y = b - *y);
                self.residual.clone_from(&y);
                Work::Start(Sweep::new(self.options.preconditioner), y)
            }
            Work::Start(mut sweep, mut z) => {
                if !sweep.step(matrix, &mut z, may_go_on) {
                    return Work::Start(sweep, z);
                }
                let length = norm(&z);
                if self.scales[1] == 0.0 {
                    self.scales[1] = length;
                }
                if !(length > 0.0 && length.is_finite()) {
                    return Work::Done;
                }
                z.iter_mut().for_each(|z| *z /= length);
                self.right = vec![length];
                self.basis = vec![z];
                self.images.clear();
                self.triangle.clear();
                self.rotations.clear();
                Work::Product(0, None, vec![0.0; self.b.len()])
            }
            Work::Product(row, spread, mut y) => {
                let v = &self.basis[self.basis.len() - 1];
                let spread = spread.unwrap_or_else(|| matrix.spread(v));
                let end = multiply(matrix, v, &spread, row, &mut y, may_go_on);
                if end < y.len() {
                    return Work::Product(end, Some(spread), y);
                }
                self.images.push(y.clone());
                Work::Iterate(Sweep::new(self.options.preconditioner), y)
            }
            Work::Iterate(mut sweep, mut w) => {
                if !sweep.step(matrix, &mut w, may_go_on) {
                    return Work::Iterate(sweep, w);
                }
                self.iterate(w)
            }
            Work::Done => Work::Done,
        }
    }

    /// Makes the next column orthogonal and asks how small the residuals are.
    fn iterate(&mut self, mut w: Vec<f64>) -> Work {
        let before = norm(&w);
        let mut column = Vec::with_capacity(self.basis.len() + 1);
        for v in &self.basis {
            let h = dot(&w, v);
            w.iter_mut().zip(v).for_each(|(w, v)| *w -= h * v);
            column.push(h);
        }
        let length = norm(&w);
        for (k, [cos, sin]) in self.rotations.iter().enumerate() {
            let [a, b] = [column[k], column[k + 1..].first().copied().unwrap_or(0.0)];
            column[k] = cos * a + sin * b;
            if let Some(next) = column.get_mut(k + 1) {
                *next = cos * b - sin * a;
            }
        }
        let last = column.len() - 1;
        let radius = column[last].hypot(length);
        let is_exhausted = length <= 1e-14 * before;
        if radius > 0.0 {
            let [cos, sin] = [column[last] / radius, length / radius];
            self.rotations.push([cos, sin]);
            column[last] = radius;
            let right = self.right[last];
            self.right[last] = cos * right;
            self.right.push(-sin * right);
            self.triangle.push(column);
        } else {
            // The matrix maps the new direction to those before: nothing is gained by it.
            self.images.pop();
        }
        let steps = self.small();
        let residual = self.residual_after(&steps);
        let true_residual = norm(&residual) / self.scales[0];
        let preconditioned = self.right.last().map_or(0.0, |right| right.abs()) / self.scales[1];
        self.found.residuals.push(true_residual);
        self.found.preconditioned.push(preconditioned);
        self.found.is_converged = true_residual <= self.options.tolerance;
        let is_over = self.found.is_converged || self.found.iterations() >= self.options.most_iterations;
        if !is_over && !is_exhausted && self.triangle.len() < self.options.restart {
            w.iter_mut().for_each(|w| *w /= length);
            self.basis.push(w);
            return Work::Product(0, None, vec![0.0; self.b.len()]);
        }
        for (step, v) in steps.iter().zip(&self.basis) {
            self.x.iter_mut().zip(v).for_each(|(x, v)| *x += step * v);
        }
        if is_over || (is_exhausted && self.triangle.len() < 2) {
            return Work::Done;
        }
        Work::Residual(0, None, vec![0.0; self.b.len()])
    }

    /// The steps along the basis that make the preconditioned residual least.
    fn small(&self) -> Vec<f64> {
        let count = self.triangle.len();
        let mut steps = self.right[..count].to_vec();
        for k in (0..count).rev() {
            steps[k] /= self.triangle[k][k];
            let step = steps[k];
            for (other, entry) in steps[..k].iter_mut().zip(&self.triangle[k]) {
                *other -= step * entry;
            }
        }
        steps
    }

    fn residual_after(&self, steps: &[f64]) -> Vec<f64> {
        let mut residual = self.residual.clone();
        for (step, image) in steps.iter().zip(&self.images) {
            residual.iter_mut().zip(image).for_each(|(r, image)| *r -= step * image);
        }
        residual
    }
}

/// Multiplies from a row on while `may_go_on` says so; returns the next row.
fn multiply(
    matrix: &Matrix,
    x: &[f64],
    spread: &Spread,
    mut row: usize,
    y: &mut [f64],
    may_go_on: &mut dyn FnMut() -> bool,
) -> usize {
    while row < y.len() {
        let end = (row + matrix.batch()).min(y.len());
        matrix.multiply(x, spread, row..end, y);
        row = end;
        if !may_go_on() {
            break;
        }
    }
    row
}
