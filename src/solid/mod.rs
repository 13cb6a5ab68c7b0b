//! Surfaces and solids of matched curves in space: meshes, what certifies them, and the files they are written to.
//!
//! A [`Shell`] takes [`Row`]s, polylines across the rulings, and joins each to the next; caps close it at both ends. A [`Mesh`] is
//! checked by [`is_watertight`], measured by [`volume`] and [`area`], and shaded by [`Facets`].

mod angles;
mod cap;
mod check;
mod facets;
mod file;
mod mesh;
mod obj;
mod plane;
mod ply;
mod row;
mod shell;
#[cfg(feature = "hyperpatch")]
mod skin;
mod stl;
mod ties;

pub use angles::{flank_angle, twist_angle};
pub use cap::{Cap, CapError};
pub use check::{area, is_watertight, stored_volume, volume};
pub use facets::Facets;
pub use file::{FileJob, Format, Labels};
pub use mesh::{Group, Mesh, Part};
pub use plane::{Axes, best_axes, mean as mean_point};
pub use row::Row;
pub use shell::{Shell, Shelled};
#[cfg(feature = "hyperpatch")]
pub use skin::Skin;
