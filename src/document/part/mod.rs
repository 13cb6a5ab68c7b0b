//! Part documents: reading, the part that they make, questions about it, and the jobs that answer them.
//!
//! [`read_part`] turns JSON into a [`PartDocument`] or says which field is wrong. [`PartModel`] makes what can be made of it and says of the rest
//! why not. [`PartAsk`] is a question, [`PartJob`] answers it in steps with a [`PartAnswer`]; [`PartMemory`] remembers the last parts.

mod ask;
mod diagnostic;
mod job;
mod known;
mod model;
mod read;
mod schema;
#[cfg(test)]
mod tests;

pub use ask::PartAsk;
pub use diagnostic::PartDiagnostic;
pub use job::{Along, LeafRow, PartAmounts, PartAnswer, PartJob};
pub use known::{KnownPart, PartMemory};
pub use model::PartModel;
pub use read::{MOST_BODIES, MOST_PART_FEATURES, MOST_PART_POINTS, MOST_PART_RULES, MOST_SHAPES, read_part};
pub use schema::{
    BodySpec, ComposingRule, CourseKey, CourseSpec, FeatureSpec, Geometry, PartDocument, PartKind,
    PartRuleSpec, ReferenceSpec, RuleQuantity, ShapeSpec,
};
