//! Pictures: a display list in document units, painted on pixels or written as SVG.
//!
//! Geometry is in document units with y up; stroke widths, radii and dashes are in CSS pixels, so they keep their size when the
//! view is zoomed. One [`DisplayList`] serves both painters, so a picture and its SVG export show the same things.

mod blend;
mod clip;
mod coverage;
mod dash;
mod error;
mod figure;
mod grid;
#[cfg(feature = "harmonic")]
mod harmonic;
mod hatch;
mod lines;
mod list;
mod mesh;
mod options;
mod painting;
mod shade;
mod shape;
#[cfg(feature = "stack")]
mod stack;
mod strip;
#[cfg(feature = "svg")]
mod svg;
#[cfg(feature = "svg")]
mod svg_hatch;
#[cfg(feature = "svg")]
mod svg_shade;
mod theme;
mod viewport;
mod window;

pub use error::PaintError;
pub use figure::{FigureOptions, figure};
pub use grid::{GridStep, grid_step};
pub use hatch::Blends;
pub use list::{DisplayList, Item, Layer, Mesh, Path, StrokeStyle};
pub use options::PictureOptions;
pub use painting::{Painting, paint};
#[cfg(feature = "svg")]
pub use svg::to_svg;
pub use theme::{Cased, Theme};
pub use viewport::{Margins, Viewport};
