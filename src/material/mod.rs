//! Materials, compositions (points of the simplex), the mixing of colours, and the colours of scalars.

mod color;
mod composition;
mod mixing;
mod profile;
mod scalar;

pub use color::{Color, ColorError, Oklab};
pub use composition::{Composition, CompositionError};
pub use mixing::{Material, mix_colors, mix_fractions};
pub use profile::{Profile, ProfileError};
pub use scalar::viridis;
