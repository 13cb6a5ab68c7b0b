//! Part documents: reading, the part that they make, questions about it, and the jobs that answer them.
//!
//! [`read_part`] turns JSON into a [`PartDocument`] or says which field is wrong. [`PartModel`] makes what can be made of it and says of the rest
//! why not. [`PartAsk`] is a question, [`PartJob`] solves the blends and answers it in steps with a [`PartAnswer`]; [`PartMemory`] remembers the last parts.

mod ask;
#[cfg(test)]
mod blend_tests;
mod blends;
mod diagnostic;
mod job;
mod known;
mod model;
mod plan;
mod read;
mod read_blend;
mod schema;
#[cfg(test)]
mod tests;

pub use ask::PartAsk;
pub use diagnostic::PartDiagnostic;
pub use job::{Along, LeafRow, PartAmounts, PartAnswer, PartJob};
pub use known::{KnownPart, PartMemory};
pub use model::PartModel;
pub use read::{
    MOST_BLENDS, MOST_BODIES, MOST_PART_FEATURES, MOST_PART_POINTS, MOST_PART_RULES, MOST_SHAPES, read_part,
};
pub use read_blend::MOST_BOUNDARIES;
pub use schema::{
    BodySpec, BoundarySpec, ComposingRule, CourseKey, CourseSpec, FeatureSpec, Geometry, PartBlendKind,
    PartBlendSpec, PartDocument, PartKind, PartRuleSpec, ReferenceSpec, RuleQuantity, ShapeSpec, SourceSpec,
};
