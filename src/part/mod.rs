//! Parts: bodies whose composition is a function of the distances to named features (Liu, Maekawa, Patrikalakis and others 2003, 3.2).
//!
//! A [`Shape`] is reference geometry in the plane, with exact distances. A [`Body`] is a [`Region`] with [`Feature`]s whose profiles an
//! [`Overlap`](crate::field::Overlap) composes; where none of them acts it has a default, or a [`Blend`] of what its boundary has. [`RasterJob`] evaluates a part on pixels in tiles; a point is evaluated without a grid.

mod archive;
mod blend;
mod blue_noise;
mod body;
mod dither;
mod frame;
mod isolines;
mod paint;
mod path;
mod png;
mod raster;
mod reference;
mod shape;
mod writer;

pub use blend::{
    Blend, BlendFault, BlendFaultKind, BlendJob, BlendMade, BlendMemory, BlendPlan, Condition, Edge, On,
    Overshoot,
};
pub use body::{Body, Composing, Feature, Part, Place, Region};
pub use dither::Dither;
pub use frame::{Frame, FrameError, MOST_MEMORY, MOST_PIXELS, MOST_PRINTED_PIXELS};
pub use isolines::{PartIsoline, isolines};
pub use paint::Palette;
pub use path::Path;
pub use raster::{Raster, RasterJob};
pub use reference::Reference;
pub use shape::Shape;
pub use writer::{PartFormat, Writer};
