//! Matching of two curves by ruling lines: closed ones, one inside the other, or open ones.
//!
//! After Samanta, Ozbolat and Koc, *Optimized normal and distance matching for heterogeneous object modeling* (Computers &
//! Industrial Engineering, 2014), here called *the paper*. Both curves are sampled into polygons; a [`RulingLine`] joins a
//! vertex of the first to a vertex of the second. [`Greedy`] grows a set of lines of high value (the paper's Greedy Ruling
//! Line Construction) in which no line crosses another or leaves the band between the polygons, and
//! removes the redundant ones; [`Totals`] says what the set is worth and re-checks both constraints by brute force.
//!
//! [`Insertion`] then gives every line its own ends, by new vertices on the curves, and verifies all lines anew.
//!
//! The greedy set is a heuristic: it is feasible, and near the optimum, but not the optimum. [`Exact`] finds that between the same
//! samples, and [`Refine`] that of the integral J on the curves themselves; [`even_places`] and [`Placing`] make one-to-one lines of it.
//! [`OnePerVertex`], [`best_shift`], [`irredundant`] and [`best_mean`] are there for comparison.

mod chain;
mod course;
mod details;
mod even;
mod even_open;
mod exact;
mod greedy;
mod insert;
mod irredundant;
mod join;
mod keep;
mod lattice;
mod level;
mod mean;
mod measure;
mod objective;
mod obstacle;
mod outline;
mod parts;
mod passes;
mod path;
mod pins;
mod place;
mod problem;
mod prune;
mod quadrature;
mod refine;
mod refine_open;
mod rivals;
mod rounds;
mod row;
mod shift;
mod single;
mod spacing;
mod stretch;
#[cfg(test)]
mod test_shapes;
mod trace;
mod value;
mod visibility;

pub use details::{Details, details, integral_on_curves};
pub use even::hold_places;
pub use exact::{Exact, Infeasible, Optimum, exact};
pub use greedy::{Greedy, Matching, Printed, RulingLine, greedy};
pub use insert::{FailedGap, Inserted, Insertion, OneToOne};
pub use irredundant::irredundant;
pub use keep::Spread;
pub use mean::best_mean;
pub use measure::{Bound, Totals, broken, left_out, measure};
pub use objective::{ExactOptions, Objective, Policy};
pub use obstacle::Obstacle;
pub use outline::Outline;
pub use place::{Placing, places_of, places_of_pairs};
pub use problem::{Ends, Layout, Problem, ProblemError};
pub use prune::{prune, prune_as_printed};
pub use refine::{Refine, Refined, even_places};
pub use rivals::{Fate, Rival, Standing, standings};
pub use shift::{best_shift, shifted};
pub use single::{OnePerVertex, SingleLines, fill_in, one_per_vertex};
pub use stretch::Stretch;
pub use trace::{Rejection, Seen, Trace, VertexSets, trace, vertex_sets};
pub use value::{NegativeProducts, Weights, round_to_40_bits};
pub use visibility::blocking_edge;
