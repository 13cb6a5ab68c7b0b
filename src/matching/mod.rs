//! Matching of two closed curves by ruling lines.
//!
//! After Samanta, Ozbolat and Koc, *Optimized normal and distance matching for heterogeneous object modeling* (Computers &
//! Industrial Engineering, 2014), here called *the paper*. Both curves are sampled into polygons; a [`RulingLine`] joins a
//! vertex of the first to a vertex of the second. [`Greedy`] grows a set of lines of high value (the paper's Greedy Ruling
//! Line Construction) in which no line crosses another or leaves the band between the polygons, and
//! removes the redundant ones; [`Totals`] says what the set is worth and re-checks both constraints by brute force.
//!
//! [`Insertion`] then gives every line its own ends, by new vertices on the curves, and verifies all lines anew.
//!
//! The greedy set is a heuristic: it is feasible, and near the optimum, but not the optimum.

mod chain;
mod greedy;
mod insert;
mod measure;
mod outline;
mod problem;
mod prune;
mod quadrature;
mod row;
mod value;
mod visibility;

pub use greedy::{Greedy, Matching, RulingLine, greedy};
pub use insert::{FailedGap, Insertion, OneToOne};
pub use measure::{Bound, Totals, measure};
pub use outline::Outline;
pub use problem::{Layout, Problem, ProblemError};
pub use prune::prune;
pub use value::{NegativeProducts, Weights, round_to_40_bits};
pub use visibility::blocking_edge;
