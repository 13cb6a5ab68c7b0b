//! Materials, compositions (points of the simplex) and the mixing of colours.

mod color;
mod composition;
mod mixing;
mod profile;

pub use color::{Color, ColorError, Oklab};
pub use composition::{Composition, CompositionError};
pub use mixing::{Material, mix_colors};
pub use profile::{Profile, ProfileError};
