//! Blends of bodies: their compositions solve Laplace's equation, with values and gradients on the boundary (Liu, Maekawa, Patrikalakis and others 2003, 3.3).
//!
//! A [`BlendPlan`] says what is known on which piece of the boundary. A [`BlendJob`] divides the boundary into elements, asks neighbours and features what
//! they have there, and solves; the [`Blend`] that it makes has a composition at every place of the body. [`BlendMemory`] keeps the last ones, so that an edit that
//! changes neither boundary nor conditions costs no solving.

mod division;
mod job;
mod ring;
mod solved;

pub use job::{BlendFault, BlendFaultKind, BlendJob, BlendMade, Overshoot};
pub use solved::{Blend, BlendMemory};

use super::{Feature, Shape};
use crate::field::DistanceProfile;
use crate::material::Composition;

/// What is known on the boundary of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct BlendPlan {
    /// About how many elements the boundary is divided into, 1 or more.
    pub elements: usize,
    /// Pieces of the boundary. What is in none of them has no gradient across it.
    pub edges: Vec<Edge>,
}

/// A piece of the boundary with what is known on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Edge {
    /// Which piece it is.
    pub on: On,
    /// What is known.
    pub condition: Condition,
}

/// A piece of a boundary.
#[derive(Debug, Clone, PartialEq)]
pub enum On {
    /// What other pieces leave of the outline (0), or of a hole (1 and more).
    Ring(usize),
    /// What lies within a distance of a shape, or within a ten-thousandth of the size of the body where that is more.
    Near(Shape, f64),
}

/// What is known on a piece of a boundary.
#[derive(Debug, Clone, PartialEq)]
pub enum Condition {
    /// The composition.
    Value(Composition),
    /// Of each material how its fraction changes outwards across the boundary, per unit of length; the sum is 0.
    Flux(Vec<f64>),
    /// The composition is that of another body, by its index.
    Body(usize),
    /// The composition is that of a profile of the distance.
    Profile(Box<(DistanceProfile, Feature)>),
}
