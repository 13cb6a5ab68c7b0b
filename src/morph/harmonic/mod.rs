//! The harmonic blend of nested curves: heat flows from the outer curve to those inside it.
//!
//! The potential solves Laplace's equation between the curves, 1 on the outer one and 0 on the others, and so does every fraction, with the compositions of the
//! curves as boundary values (boundary elements, [`crate::laplace`]). Level curves of the potential are the stages; lines along its gradient take the
//! place of ruling lines, and cannot cross.

mod blend;
mod boundary;
mod field;
mod flow;
mod level;
mod ring;
mod thread;

pub use blend::{Compose, Fineness, HarmonicBlend, HarmonicPlace, HarmonicWork};
pub use boundary::Rings;
pub use field::Field;
pub use ring::Ring;
pub use thread::{GradientLine, crossings};

#[cfg(test)]
mod tests;
