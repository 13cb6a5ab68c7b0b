//! What is asked of the exact solver.

use super::path::Rule;

/// What the exact solver maximises over all sets of visible lines that leave no vertex without a line and do not cross.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Objective {
    /// J: the integral of f along the matching, by the trapezoid rule; independent of the number of lines.
    #[default]
    Integral,
    /// The sum of f. With positive values it saturates at as many lines as there are vertices in all.
    Sum,
    /// The sum of f less a price for every line.
    SumLessPrice(f64),
}

impl Objective {
    pub(super) fn rule(self) -> Rule {
        match self {
            Self::Integral => Rule::Cover { cells: 0.0, steps: 1.0, price: 0.0 },
            Self::Sum => Rule::Cover { cells: 1.0, steps: 0.0, price: 0.0 },
            Self::SumLessPrice(price) => Rule::Cover { cells: 1.0, steps: 0.0, price },
        }
    }
}

/// What the exact solver does when visible lines cannot reach every vertex.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Policy {
    /// It says why.
    #[default]
    Strict,
    /// It adds as few occluded lines as possible (for J, as little occluded arc length), then maximises the objective. The
    /// lines still ascend together round the band, but occluded ones may cross others.
    Repair,
}

/// How to solve exactly.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ExactOptions {
    /// What to maximise.
    pub objective: Objective,
    /// What to do when visible lines cannot reach every vertex.
    pub policy: Policy,
    /// Lines that the matching must hold, by their vertices on the first and the second outline.
    pub pins: Vec<(usize, usize)>,
}
