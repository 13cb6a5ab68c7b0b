//! The document format: reading, checking, defaults, and the solution of a document.
//!
//! A document holds exact geometry and composition rules; everything shown is computed from it. [`read`] turns JSON into a
//! [`CurvesDocument`] or says which field is wrong; [`Model`] holds its curves ready for evaluation; [`Solve`] is
//! the job that matches them. The format itself is described in `docs/format.md`.

#[cfg(feature = "amounts")]
mod amounts;
#[cfg(feature = "hyperpatch")]
mod body;
mod control_points;
mod diagnostic;
mod direction;
mod error;
mod fields;
#[cfg(feature = "harmonic")]
mod harmonic;
#[cfg(feature = "hyperpatch")]
mod hyperpatch;
#[cfg(feature = "edit")]
mod insert_point;
mod iso_options;
mod json;
#[cfg(feature = "laplace")]
mod laplace;
#[cfg(feature = "laplace")]
mod laplace_options;
mod memory;
mod model;
mod node;
#[cfg(feature = "part")]
mod part;
#[cfg(feature = "paths")]
mod paths;
#[cfg(feature = "solid")]
mod projection;
mod read;
mod schema;
#[cfg(feature = "solid")]
mod solid;
#[cfg(feature = "solid")]
mod solid_job;
#[cfg(feature = "solid")]
mod solid_options;
mod solve;
#[cfg(feature = "solid")]
mod space;
#[cfg(feature = "stack")]
mod stack;
#[cfg(feature = "field")]
mod transform_options;
mod work;

#[cfg(feature = "amounts")]
pub use amounts::{BandAmounts, amounts};
#[cfg(feature = "hyperpatch")]
pub use body::{
    Answer, BodyAsk, BodyFormat, BodyJob, BodyMemory, Boundary, CellRow, Checks, DocumentKey, Held,
    KnownBody, KnownSurface, Painted, Parts, Renewal, Sample, SharedParts, Stretch, Summary,
};
pub use control_points::ControlPoints;
pub use diagnostic::Diagnostic;
pub use error::{Code, DocumentError};
pub(crate) use fields::layers;
#[cfg(feature = "harmonic")]
pub use harmonic::{Comparing, Difference, Harmonic, lightened};
#[cfg(feature = "hyperpatch")]
pub use hyperpatch::{
    Action, CellSpec, FaceSpec, HyperpatchDocument, HyperpatchHead, HyperpatchKind, HyperpatchModel,
    MixTarget, Operation, OperationReading, OperationRow, Replay, Stage, check_cells, check_operations,
    read_hyperpatch,
};
#[cfg(feature = "edit")]
pub use insert_point::insert_point;
pub use iso_options::IsoOptions;
pub use json::Json;
#[cfg(feature = "laplace")]
pub use laplace::{
    BoundaryDiagnostic, BoundaryJob, BoundaryMemory, BoundaryModel, BoundaryProblem, ConditionSpec, Datum,
    Exact, ExactJob, GroupSpec, LaplaceDocument, MOST_GROUPS, SectionSpec, Selection, SetRow,
    SharedCondition, SolverSpec, read_laplace,
};
#[cfg(feature = "laplace")]
pub use laplace_options::{LaplaceInput, LaplaceLists, read_frame};
pub use memory::Memory;
pub use model::Model;
pub(crate) use node::Node;
#[cfg(feature = "part")]
pub use part::{
    Along, BodySpec, BoundarySpec, ComposingRule, CourseKey, CourseSpec, FeatureSpec, Geometry, KnownPart,
    LeafRow, MOST_BLENDS, MOST_BODIES, MOST_BOUNDARIES, MOST_PART_FEATURES, MOST_PART_POINTS,
    MOST_PART_RULES, MOST_SHAPES, PartAmounts, PartAnswer, PartAsk, PartBlendKind, PartBlendSpec,
    PartDiagnostic, PartDocument, PartJob, PartKind, PartMemory, PartModel, PartRuleSpec, ReferenceSpec,
    RuleQuantity, ShapeSpec, SourceSpec, read_part,
};
#[cfg(feature = "paths")]
pub use paths::{PathOptions, paths};
#[cfg(feature = "solid")]
pub use projection::Projection;
pub use read::{LONGEST_TEXT, check_length, read};
#[cfg(not(target_arch = "wasm32"))]
pub use read::{read_text, write_text};
pub use schema::{
    BestShift, Blend, BlendKind, CompositionKey, CurveForm, CurveSpec, CurvesDocument, Kind, LayerName,
    MatchingSpec, MaterialSpec, Method, NegativeMode, ObjectiveName, Pin, Policy, PrintedRule, Sampling,
    SamplingScheme, Shift, View,
};
#[cfg(feature = "solid")]
pub use solid::{Solid, SolidRemark, flat, why_no_solid};
#[cfg(feature = "solid")]
pub use solid_job::{MOST_VERTICES, SolidJob};
#[cfg(feature = "solid")]
pub use solid_options::{SolidColor, SolidOptions};
pub use solve::{Gap, GapKind, Outcome, Solution, Solve};
#[cfg(feature = "stack")]
pub use stack::{Stacked, span_document};
#[cfg(feature = "field")]
pub use transform_options::TransformOptions;
