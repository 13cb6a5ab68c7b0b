//! Heterogeneous objects: bodies whose material varies from point to point.
//!
//! # Conventions
//! Right-handed plane with y up; counter-clockwise means positive area; lengths in the unit of the document.

pub mod geom;
pub mod material;

#[cfg(feature = "curves")]
pub mod curve;
#[cfg(feature = "curves")]
pub mod document;
#[cfg(feature = "curves")]
pub mod matching;
#[cfg(feature = "curves")]
pub mod morph;
#[cfg(feature = "curves")]
pub mod picture;

#[cfg(all(feature = "curves", target_arch = "wasm32"))]
mod wasm;
