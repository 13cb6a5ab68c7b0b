//! Questions about hyperpatch documents, and the jobs that answer them.
//!
//! [`KnownBody`] is a document with its body made and with what was found about it; [`BodyMemory`] remembers the last ones.
//! [`BodyAsk`] is a question, [`BodyJob`] answers it in steps with an [`Answer`].

mod answer;
mod ask;
mod checks;
mod job;
mod known;
mod memory;
mod paint;
mod resurface;
mod summary;

pub use answer::{Answer, CellRow, Parts, Sample, SharedParts};
pub use ask::{BodyAsk, BodyFormat};
pub use checks::Checks;
pub use job::BodyJob;
pub use known::{Held, KnownBody};
pub use memory::{BodyMemory, DocumentKey};
pub use paint::{Boundary, Painted, Stretch};
pub use resurface::{KnownSurface, Renewal};
pub use summary::Summary;
