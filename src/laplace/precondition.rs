//! Left preconditioners: M z = r.

use super::error::{Fault, LaplaceError};
use super::matrix::{Matrix, product};

/// What the residual is made even by.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Preconditioner {
    /// Nothing: M = I.
    None,
    /// The diagonal: M = D.
    #[default]
    Jacobi,
    /// Symmetric successive overrelaxation, M = (D + wL) D^-1 (D + wU) with 0 < w < 2; the factor 1/(w(2 - w)) changes nothing and is left out.
    Ssor(f64),
}

impl Preconditioner {
    /// # Errors
    /// When the parameter is out of range, or a whole matrix is needed and there is none.
    pub(super) fn check(self, is_dense: bool, most: usize) -> Result<(), LaplaceError> {
        let Self::Ssor(omega) = self else { return Ok(()) };
        if !(omega > 0.0 && omega < 2.0) {
            let message = format!("omega is {omega}; expected a number above 0 and below 2");
            return Err(LaplaceError::new(Fault::Method, message));
        }
        if is_dense {
            return Ok(());
        }
        let message = format!(
            "`ssor` needs the whole matrix, which is kept up to {most} elements; expected `jacobi` or `none` for more"
        );
        Err(LaplaceError::new(Fault::Method, message))
    }
}

/// A preconditioner at work on a vector, in place.
#[derive(Debug)]
pub(super) struct Sweep {
    kind: Preconditioner,
    /// Rows done, those of the sweep back after those of the sweep forth.
    done: usize,
}

impl Sweep {
    pub(super) fn new(kind: Preconditioner) -> Self {
        Self { kind, done: 0 }
    }

    /// Turns r into z while `may_go_on` says so; returns whether it is done.
    pub(super) fn step(
        &mut self,
        matrix: &Matrix,
        z: &mut [f64],
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> bool {
        let n = z.len();
        let omega = match self.kind {
            Preconditioner::None => return true,
            Preconditioner::Jacobi => {
                z.iter_mut().zip(&matrix.diagonal).for_each(|(z, d)| *z /= d);
                return true;
            }
            Preconditioner::Ssor(omega) => omega,
        };
        while self.done < 2 * n {
            let end = (self.done + matrix.batch()).min(2 * n);
            for at in self.done..end {
                // (D + wL) y = r downwards, then (I + w D^-1 U) z = y upwards.
                let is_back = at >= n;
                let row = if is_back { 2 * n - 1 - at } else { at };
                let Some(entries) = matrix.row(row) else { return true };
                let columns = if is_back { row + 1..n } else { 0..row };
                let sum = omega * product(&entries[columns.clone()], &z[columns]);
                z[row] = if is_back {
                    z[row] - sum / matrix.diagonal[row]
                } else {
                    (z[row] - sum) / matrix.diagonal[row]
                };
            }
            self.done = end;
            if !may_go_on() {
                break;
            }
        }
        self.done == 2 * n
    }
}
