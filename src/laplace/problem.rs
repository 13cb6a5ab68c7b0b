//! What is to be solved: a boundary with conditions.

use super::assemble::Given;
use super::check::{Enclosed, enclosed};
use super::error::{Fault, LaplaceError};
use super::mesh::{Mesh, Scaling};

/// Most materials.
pub const MOST_MATERIALS: usize = 16;

/// How far fractions may be from the sum 1, and fluxes of fractions from the sum 0 over the largest of them.
const SUM: f64 = 1e-6;

/// Greatest size of a number of a condition; beyond, sums leave what numbers can hold.
const LARGEST: f64 = 1e100;

/// With fluxes alone: the share of the whole flux that may be missing, and is spread evenly.
const IMBALANCE: f64 = 0.02;

/// What is known on the boundary, for each element a value or an outward flux of every material.
#[derive(Debug, Clone, PartialEq)]
pub struct Conditions {
    /// Of each element whether the values are known; else the fluxes, derivatives along the outward normal, are.
    pub is_value: Vec<bool>,
    /// A list for each material, with a number for each element.
    pub data: Vec<Vec<f64>>,
    /// Whether the materials are fractions that sum to 1: then the last one follows from the others.
    pub are_fractions: bool,
}

/// A boundary that encloses one body, with conditions that determine one solution.
#[derive(Debug, Clone)]
pub struct Problem {
    pub(super) mesh: Mesh,
    pub(super) conditions: Conditions,
    pub(super) enclosed: Enclosed,
    pub(super) scaling: Scaling,
    /// For each material solved for, what is taken off its values: the middle of those that are given.
    pub(super) shifts: Vec<f64>,
    /// For each material solved for, what its data are divided by, about the largest of them, so that single precision holds them.
    pub(super) sizes: Vec<f64>,
    /// Largest share of the whole flux that was missing and spread.
    pub(super) imbalance: f64,
}

impl Conditions {
    /// A value (`Ok`) or a flux (`Err`) of one material for each element.
    #[must_use]
    pub fn single(data: impl IntoIterator<Item = Result<f64, f64>>) -> Self {
        let (is_value, data) =
            data.into_iter().map(|datum| (datum.is_ok(), datum.unwrap_or_else(|flux| flux))).unzip();
        Self { is_value, data: vec![data], are_fractions: false }
    }

    /// Number of materials solved for.
    #[must_use]
    pub fn solved(&self) -> usize {
        self.data.len() - usize::from(self.are_fractions)
    }

    fn check(&self, elements: usize) -> Result<(), LaplaceError> {
        let conditions = |message: String| LaplaceError::new(Fault::Conditions, message);
        if !(1..=MOST_MATERIALS).contains(&self.data.len()) || (self.are_fractions && self.data.len() < 2) {
            let least = if self.are_fractions { 2 } else { 1 };
            let message =
                format!("{} materials were found; expected {least} to {MOST_MATERIALS}", self.data.len());
            return Err(conditions(message));
        }
        let counts = self.data.iter().map(Vec::len).chain([self.is_value.len()]);
        if let Some(count) = counts.into_iter().find(|count| *count != elements) {
            return Err(conditions(format!(
                "{count} conditions were found; expected one for each of {elements} elements"
            )));
        }
        for element in 0..elements {
            let data = self.data.iter().map(|data| data[element]);
            let is_number = |datum: &f64| datum.is_finite() && datum.abs() <= LARGEST;
            if let Some(wrong) = data.clone().find(|datum| !is_number(datum)) {
                let message =
                    format!("{wrong:e} was found; expected a finite number up to {LARGEST:e} either way");
                return Err(conditions(message).of(element));
            }
            if !self.are_fractions {
                continue;
            }
            let (is_value, expected) = (self.is_value[element], f64::from(u8::from(self.is_value[element])));
            let is_fraction = |datum: &f64| !is_value || (-SUM..=1.0 + SUM).contains(datum);
            if let Some(wrong) = data.clone().find(|datum| !is_fraction(datum)) {
                return Err(
                    conditions(format!("{wrong} was found; expected a fraction from 0 to 1")).of(element)
                );
            }
            let sum: f64 = data.clone().sum();
            let largest = data.fold(0.0, |most: f64, datum| most.max(datum.abs()));
            if (sum - expected).abs() > SUM * if is_value { 1.0 } else { largest } {
                let what = if is_value { "values" } else { "fluxes" };
                let message = format!("the {what} of the materials sum to {sum}; expected {expected}");
                return Err(LaplaceError::new(Fault::Sum, message).of(element));
            }
        }
        Ok(())
    }
}

impl Problem {
    /// Checks the boundary and its conditions.
    ///
    /// # Errors
    /// When the boundary does not enclose one body; when there are not as many conditions as elements, one is not finite or too large, or fractions are none or do not sum to 1; when
    /// fluxes alone are given and more than a fiftieth of their size is missing to balance them.
    pub fn new(mesh: Mesh, conditions: Conditions) -> Result<Self, LaplaceError> {
        let n = mesh.elements().len();
        conditions.check(n)?;
        let enclosed = enclosed(&mesh)?;
        let shifts = (0..conditions.solved()).map(|material| middle(&conditions, material)).collect();
        let scaling = mesh.scaling();
        let mut problem =
            Self { mesh, conditions, enclosed, scaling, shifts, sizes: Vec::new(), imbalance: 0.0 };
        if !problem.conditions.is_value.contains(&true) {
            problem.balance()?;
        }
        problem.sizes = (0..problem.conditions.solved()).map(|material| problem.size(material)).collect();
        Ok(problem)
    }

    /// The boundary.
    #[must_use]
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The conditions; fluxes that are alone are balanced.
    #[must_use]
    pub fn conditions(&self) -> &Conditions {
        &self.conditions
    }

    /// What the boundary encloses.
    #[must_use]
    pub fn enclosed(&self) -> &Enclosed {
        &self.enclosed
    }

    /// With fluxes alone, the largest share of the whole flux of a material that was missing and was spread evenly.
    #[must_use]
    pub fn imbalance(&self) -> f64 {
        self.imbalance
    }

    /// With fluxes alone, what flows in must flow out: spreads what is missing evenly, or refuses it.
    fn balance(&mut self) -> Result<(), LaplaceError> {
        let sizes: Vec<f64> = self.mesh.panels().iter().map(|panel| panel.size).collect();
        let whole: f64 = sizes.iter().sum();
        for (material, fluxes) in self.conditions.data.iter_mut().enumerate() {
            let sum: f64 = fluxes.iter().zip(&sizes).map(|(flux, size)| flux * size).sum();
            let all: f64 = fluxes.iter().zip(&sizes).map(|(flux, size)| flux.abs() * size).sum();
            let missing = if all > 0.0 { sum.abs() / all } else { 0.0 };
            if missing > IMBALANCE {
                let message = format!(
                    "only fluxes are given, and those of material {material} leave {sum:e} in all where {all:e} goes in and out; expected 0, or a value on some element"
                );
                return Err(LaplaceError::new(Fault::Imbalance, message));
            }
            self.imbalance = self.imbalance.max(missing);
            fluxes.iter_mut().for_each(|flux| *flux -= sum / whole);
        }
        Ok(())
    }

    /// The data in the units of computing.
    pub(super) fn given(&self) -> Given {
        let of = |(material, size): (usize, &f64)| self.moved(material).map(|datum| datum / size).collect();
        let data = self.sizes.iter().enumerate().map(of).collect();
        Given { is_value: self.conditions.is_value.clone(), data }
    }

    /// The data of a material, values less the shift and fluxes by the lengths of computing.
    fn moved(&self, material: usize) -> impl Iterator<Item = f64> {
        let (shift, scale) = (self.shifts[material], self.scaling.scale());
        let data = self.conditions.data[material].iter().zip(&self.conditions.is_value);
        data.map(move |(datum, is_value)| if *is_value { datum - shift } else { datum / scale })
    }

    /// The power of 2 next below the largest of the data of a material, by which nothing is rounded; 1 where all are 0.
    fn size(&self, material: usize) -> f64 {
        let largest = self.moved(material).fold(0.0, |most: f64, datum| most.max(datum.abs()));
        if largest > 0.0 { largest.log2().floor().exp2() } else { 1.0 }
    }
}

/// The middle of the values that are given for a material.
fn middle(conditions: &Conditions, material: usize) -> f64 {
    let given = conditions.data[material].iter().zip(&conditions.is_value).filter(|(_, is_value)| **is_value);
    let (low, high) = given.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (value, _)| {
        (low.min(*value), high.max(*value))
    });
    if low <= high { low / 2.0 + high / 2.0 } else { 0.0 }
}
