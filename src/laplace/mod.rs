//! Laplace's equation in a body, from values and fluxes on its boundary: boundary elements (Liu, Maekawa, Patrikalakis and others 2003, 3.3).
//!
//! A [`Mesh`] is the boundary: straight segments in the plane, flat triangles in space. With [`Conditions`] it makes a [`Problem`], which a [`LaplaceJob`]
//! solves: for each panel the equation at its middle, with values and fluxes constant on panels (direct formulation, collocation). Integrals over panels
//! are exact nearby and by quadrature far away. [`Solution::at`] then evaluates anywhere inside, to the panels' own accuracy right up to the boundary,
//! and a [`SectionJob`] on pixels.
//!
//! A problem in the plane is not the section of one in space, unless the body and its conditions go on and on across the plane.

mod ask;
mod assemble;
mod check;
mod cloud;
mod cluster;
mod error;
mod expansion;
pub mod faces;
mod gmres;
mod job;
mod lanes;
mod lu;
mod matrix;
mod mesh;
mod panel;
mod precondition;
mod problem;
mod quantity;
pub mod samples;
mod section;
mod segment;
mod single;
mod solution;
mod tile;
mod triangle;

pub use ask::{Found, MOST_POINTS, PointsJob, Quantity};
pub use check::{Enclosed, MOST_PARTS, enclosed};
pub use error::{Fault, LaplaceError};
pub use gmres::{Convergence, GmresOptions};
pub use job::{LaplaceJob, LaplaceOptions, Method, Stage, solve};
pub use lu::MOST_LU;
pub use matrix::MOST_DENSE;
pub use mesh::{MOST_ELEMENTS, Mesh, Scaling};
pub use panel::{LayerGradients, Layers, Panel, Space};
pub use precondition::Preconditioner;
pub use problem::{Conditions, MOST_MATERIALS, Problem};
pub use section::{Frame, MOST_PIXELS, Section, SectionJob};
pub use solution::{Solution, Value};

#[cfg(test)]
mod tests;
