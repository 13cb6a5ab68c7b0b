//! Documents of boundary value problems: reading, the boundary with its conditions, and solutions that are known.
//!
//! [`read_laplace`] turns JSON into a [`LaplaceDocument`] or says which field is wrong. A [`BoundaryJob`] makes its [`BoundaryProblem`]: elements, the
//! condition of each, and whatever keeps the problem from being solved, with its place. [`Exact`] is the solution where it is known.

mod boundary;
mod condition;
mod diagnostic;
mod exact;
mod job;
mod known;
mod model;
mod read;
mod schema;
#[cfg(test)]
mod tests;

pub use boundary::{BoundaryProblem, SetRow, SharedCondition};
pub use diagnostic::BoundaryDiagnostic;
pub use exact::{Exact, ExactJob};
pub use job::BoundaryJob;
pub use known::BoundaryMemory;
pub use read::{MOST_GROUPS, read_laplace};
pub use schema::{
    BoundaryModel, ConditionSpec, Datum, GroupSpec, LaplaceDocument, SectionSpec, Selection, SolverSpec,
};
