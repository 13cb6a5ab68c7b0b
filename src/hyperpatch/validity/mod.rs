//! Whether the shape of a cell is sound: one point of space for every parameter, and none turned inside out.
//!
//! The paper asks for it (section 3.4) and refers to a condition on the positions of control points that it does not
//! print. Two conditions stand in for it. The **cone condition** proves that a cell meets itself nowhere, and is
//! sufficient, not necessary, as the paper's is. The **Jacobian certificate** decides whether the determinant is
//! positive everywhere, which is local: a bar may be bent through itself with a positive determinant. [`certify`]
//! runs both, after every edit; [`Injectivity`] is the job that decides what they leave open, and [`verdict`] runs
//! everything to its end.
//!
//! Everything here computes in `f64` from the coefficients, with bounds for what is rounded.

mod certificate;
mod cone;
mod injectivity;
mod report;
mod separation;

pub use certificate::{Certificate, Sign};
pub use cone::{REGULAR_MARGIN, is_axis_aligned, is_regular, margin};
pub(super) use injectivity::Piece;
pub use injectivity::{Finding, Injectivity};
pub use report::{Report, Verdict, Witness, certify, verdict};
pub(super) use separation::{are_separated, positive_direction};
