//! Selections and conditions of elements, ready to be evaluated.

use super::diagnostic::BoundaryDiagnostic;
use super::schema::{ConditionSpec, Datum, Selection};
use crate::field::Expression;
use crate::laplace::Panel;
use glam::DVec3;

/// What expressions speak of: coordinates, and the distance to the z axis, in the plane to the origin.
const VARIABLES: [&str; 4] = ["x", "y", "z", "r"];

/// How far an angle may be passed for rounding's sake, in its cosine.
const ROUNDING: f64 = 1e-12;

type Made<T> = Result<T, BoundaryDiagnostic>;

/// A selection whose expression can be evaluated.
#[derive(Debug, Clone)]
pub(super) struct Chosen {
    /// A direction with the least cosine of the angle to it.
    direction: Option<(DVec3, f64)>,
    bounds: Option<[DVec3; 2]>,
    positive: Option<Expression>,
    /// Runs that do not meet, in order.
    runs: Option<Vec<[usize; 2]>>,
}

/// A condition whose expressions can be evaluated.
#[derive(Debug, Clone)]
pub(super) struct Known {
    /// Whether values are known; else fluxes are.
    pub(super) is_value: bool,
    data: Vec<Part>,
}

#[derive(Debug, Clone)]
enum Part {
    Number(f64),
    Formula(Expression),
}

fn expression(text: &str, path: &str) -> Made<Expression> {
    Expression::new(text, &VARIABLES).map_err(|error| BoundaryDiagnostic {
        character: Some(error.at),
        ..BoundaryDiagnostic::new("expression", path, error.to_string())
    })
}

fn value(expression: &Expression, point: DVec3) -> f64 {
    expression.value(&[point.x, point.y, point.z, point.x.hypot(point.y)])
}

/// The same elements in runs that do not meet, in order.
fn joined(runs: &[[usize; 2]]) -> Vec<[usize; 2]> {
    let mut sorted = runs.to_vec();
    sorted.sort_unstable();
    let mut joined: Vec<[usize; 2]> = Vec::with_capacity(sorted.len());
    for [first, last] in sorted {
        match joined.last_mut() {
            Some(before) if first <= before[1] => before[1] = before[1].max(last),
            _ => joined.push([first, last]),
        }
    }
    joined
}

impl Chosen {
    /// Reads the expression of a selection.
    pub(super) fn new(spec: &Selection, path: &str) -> Made<Self> {
        let positive = spec.positive.as_ref();
        Ok(Self {
            direction: spec.direction.map(|(way, angle)| (way, angle.to_radians().cos() - ROUNDING)),
            bounds: spec.bounds,
            positive: positive.map(|text| expression(text, &format!("{path}.positive"))).transpose()?,
            runs: spec.elements.as_deref().map(joined),
        })
    }

    /// Whether an element belongs to it.
    pub(super) fn holds(&self, element: usize, panel: &Panel) -> bool {
        let is_in_run = |runs: &Vec<[usize; 2]>| {
            let after = runs.partition_point(|[first, _]| *first <= element);
            after > 0 && element <= runs[after - 1][1]
        };
        let is_within =
            |[low, high]: [DVec3; 2]| panel.centre.cmpge(low).all() && panel.centre.cmple(high).all();
        self.direction.is_none_or(|(way, least)| panel.normal.dot(way) >= least)
            && self.bounds.is_none_or(is_within)
            && self.runs.as_ref().is_none_or(is_in_run)
            && self.positive.as_ref().is_none_or(|positive| value(positive, panel.centre) > 0.0)
    }
}

impl Known {
    /// Reads the expressions of a condition.
    pub(super) fn new(spec: &ConditionSpec, path: &str) -> Made<Self> {
        let list = if spec.is_value { "value" } else { "flux" };
        let part = |(k, datum): (usize, &Datum)| match datum {
            Datum::Number(number) => Ok(Part::Number(*number)),
            Datum::Text(text) => expression(text, &format!("{path}.{list}[{k}]")).map(Part::Formula),
        };
        Ok(Self {
            is_value: spec.is_value,
            data: spec.data.iter().enumerate().map(part).collect::<Made<_>>()?,
        })
    }

    /// Whether it is the same everywhere.
    pub(super) fn is_constant(&self) -> bool {
        self.data.iter().all(|part| matches!(part, Part::Number(_)))
    }

    /// The number of each material at a point.
    pub(super) fn at(&self, point: DVec3) -> impl Iterator<Item = f64> {
        self.data.iter().map(move |part| match part {
            Part::Number(number) => *number,
            Part::Formula(formula) => value(formula, point),
        })
    }
}
