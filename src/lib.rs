//! Heterogeneous objects: bodies whose material varies from point to point.
//!
//! A tour in the order a reader works. A [`curve::ClosedBSpline`] is checked once and then answers questions about its
//! points, normals and arc length. Two sampled curves make a [`matching::Problem`]; [`matching::greedy`] joins their samples
//! by ruling lines, and [`matching::Totals`] says what the lines are worth and whether they keep the constraints. A
//! [`morph::Band`] carries shape and composition from one curve to the other. A whole document, from JSON to a
//! picture:
//!
//! ```
//! use directrix::document::{Json, Solve, read_text};
//! use directrix::picture::{PictureOptions, figure, paint};
//!
//! let document = read_text(
//!     r#"{"directrix": 1, "kind": "curves", "matching": {"method": "greedy"}, "curves": [
//!         {"degree": 3, "form": "periodic", "points": [[10, 0], [0, 10], [-10, 0], [0, -10]]},
//!         {"degree": 3, "form": "periodic", "points": [[30, 0], [0, 30], [-30, 0], [0, -30]]}]}"#,
//! )?;
//! let solution = Solve::run(document)?;
//! assert!(solution.is_complete());
//!
//! let options = PictureOptions::read(&Json::parse(r#"{"width": 320, "height": 240}"#)?)?;
//! let viewport = options.viewport(&solution.model);
//! let list = figure(&solution, &options.figure(&solution.model), &viewport);
//! let rgba = paint(&list, &viewport)?;
//! assert_eq!(rgba.len(), 320 * 240 * 4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Conventions
//! - Right-handed axes, y up, z the height of a curve's plane. Counter-clockwise means positive area. Angles in degrees.
//! - Normals point to the right of the direction of travel: outwards on a counter-clockwise curve.
//! - Lengths are in the unit of the document; pixels have y down and start at the upper left corner.
//! - Kernels compute in `f64`; `f32` appears in colours and pixels alone.
//! - A composition is a list of volume fractions, none negative, with the sum 1. Fractions are mixed, then coloured.
//! - Library functions do not panic on anything that a document can hold.

pub mod geom;
pub mod material;

#[cfg(feature = "curves")]
pub mod curve;
#[cfg(feature = "curves")]
pub mod document;
#[cfg(feature = "import")]
pub mod import;
#[cfg(feature = "curves")]
pub mod matching;
#[cfg(feature = "curves")]
pub mod morph;
#[cfg(feature = "curves")]
pub mod picture;

#[cfg(all(feature = "curves", target_arch = "wasm32"))]
mod wasm;
