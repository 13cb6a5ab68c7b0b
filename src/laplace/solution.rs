//! What was found on the boundary, and the solution inside.

use super::cloud::{Values, sum_of};
use super::cluster::Panels;
use super::gmres::Convergence;
use super::panel::Panel;
use super::problem::{Conditions, Problem};
use glam::DVec3;
use std::rc::Rc;

/// Share of the full angle under which the boundary is seen, above which a point is inside or on it: on a flat face it is 1/2, in a corner less.
pub(super) const INSIDE: f64 = 0.06;

/// Share of the full angle below which a point inside is on the boundary.
const ON_BOUNDARY: f64 = 0.75;

/// Diameters of a panel from its centre within which gradients of its integrals are exact, and beyond which one place stands for it.
const EXACT: f64 = 4.0;
const FAR: f64 = 20.0;

/// A solution of Laplace's equation in a body, for each material.
#[derive(Debug, Clone)]
pub struct Solution {
    pub(super) problem: Problem,
    pub(super) panels: Rc<Panels>,
    pub(super) fields: Vec<Field>,
    convergences: Vec<Convergence>,
    condition: Option<f64>,
    row_closure: f64,
}

/// What is known of a material on the boundary, in the units of computing.
#[derive(Debug, Clone)]
pub(super) struct Field {
    /// Values of the panels, less the shift and over the size.
    values: Vec<f64>,
    fluxes: Vec<f64>,
    /// The same for each slot.
    pub(super) value_slots: Vec<f32>,
    pub(super) flux_slots: Vec<f32>,
    /// Taken off the values.
    shift: f64,
    /// Values less the shift, and fluxes, are divided by it.
    size: f64,
    /// Least and greatest value inside by the maximum principle.
    pub(super) range: Option<[f64; 2]>,
}

impl Field {
    /// The value of a panel, less the shift and over the size.
    pub(super) fn value(&self, panel: usize) -> f64 {
        self.values[panel]
    }

    /// The flux of a panel, over the size.
    pub(super) fn flux(&self, panel: usize) -> f64 {
        self.fluxes[panel]
    }

    /// A value in the units of the data.
    pub(super) fn outwards(&self, value: f64) -> f64 {
        value * self.size + self.shift
    }
}

/// What is at a point inside.
#[derive(Debug, Clone, PartialEq)]
pub struct Value {
    /// Of each material.
    pub values: Vec<f64>,
    /// Whether one was out of the range that the boundary allows, and was taken back to it.
    pub is_clamped: bool,
}

impl Solution {
    pub(super) fn new(
        problem: Problem,
        panels: Rc<Panels>,
        solved: Vec<Vec<f64>>,
        convergences: Vec<Convergence>,
        condition: Option<f64>,
        row_closure: f64,
    ) -> Self {
        let given = problem.given();
        let field = |(material, mut unknown): (usize, Vec<f64>)| {
            if !given.is_value.contains(&true) {
                // Fluxes alone leave a constant free: the mean over the boundary is 0.
                let whole: f64 = panels.list.iter().map(|panel| panel.size).sum();
                let mean =
                    unknown.iter().zip(&panels.list).map(|(x, panel)| x * panel.size).sum::<f64>() / whole;
                unknown.iter_mut().for_each(|x| *x -= mean);
            }
            let (mut values, mut fluxes) = (given.data[material].clone(), unknown);
            for ((value, flux), is_value) in values.iter_mut().zip(&mut fluxes).zip(&given.is_value) {
                if !is_value {
                    std::mem::swap(value, flux);
                }
            }
            let slots = |list: &[f64]| -> Vec<f32> {
                panels
                    .order
                    .iter()
                    .map(|panel| list.get(*panel as usize).map_or(0.0, |x| *x as f32))
                    .collect()
            };
            let field = Field {
                value_slots: slots(&values),
                flux_slots: slots(&fluxes),
                range: None,
                values,
                fluxes,
                shift: problem.shifts[material],
                size: problem.sizes[material],
            };
            Field { range: range(&problem.conditions, material, &field), ..field }
        };
        let fields = solved.into_iter().enumerate().map(field).collect();
        Self { panels: Rc::clone(&panels), fields, convergences, condition, row_closure, problem }
    }

    /// What was solved.
    #[must_use]
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// Number of materials.
    #[must_use]
    pub fn materials(&self) -> usize {
        self.problem.conditions.data.len()
    }

    /// For each material that was solved for, how the residuals fell.
    #[must_use]
    pub fn convergences(&self) -> &[Convergence] {
        &self.convergences
    }

    /// An estimate of the condition number of the matrix in the 1-norm, where it was asked for.
    #[must_use]
    pub fn condition(&self) -> Option<f64> {
        self.condition
    }

    /// Largest difference between 1/2 and the sum over a row of the double layer: the error of quadrature.
    #[must_use]
    pub fn row_closure(&self) -> f64 {
        self.row_closure
    }

    /// For each material a value on each element.
    #[must_use]
    pub fn values(&self) -> Vec<Vec<f64>> {
        let field = |field: &Field| field.values.iter().map(|value| field.outwards(*value)).collect();
        self.completed(self.fields.iter().map(field).collect(), 1.0)
    }

    /// For each material the outward flux on each element. Beside jumps of given values it means nothing.
    #[must_use]
    pub fn fluxes(&self) -> Vec<Vec<f64>> {
        let scale = self.problem.scaling.scale();
        let field = |field: &Field| field.fluxes.iter().map(|flux| flux * field.size * scale).collect();
        self.completed(self.fields.iter().map(field).collect(), 0.0)
    }

    /// For each material the whole outward flux over its whole size; 0 but for the error of the method.
    #[must_use]
    pub fn flux_balance(&self) -> Vec<f64> {
        let balance = |field: &Field| {
            let flows = || field.fluxes.iter().zip(&self.panels.list).map(|(flux, panel)| flux * panel.size);
            let whole: f64 = flows().map(f64::abs).sum();
            if whole > 0.0 { flows().sum::<f64>() / whole } else { 0.0 }
        };
        self.fields.iter().map(balance).collect()
    }

    /// Least and greatest value inside of each material solved for, by the maximum principle; `None` where fluxes alone are given.
    #[must_use]
    pub fn ranges(&self) -> Vec<Option<[f64; 2]>> {
        self.fields.iter().map(|field| field.range).collect()
    }

    /// Adds the last of the fractions.
    fn completed(&self, mut lists: Vec<Vec<f64>>, sum: f64) -> Vec<Vec<f64>> {
        if self.problem.conditions.are_fractions {
            let rest = |element: usize| sum - lists.iter().map(|list| list[element]).sum::<f64>();
            let last = (0..self.panels.list.len()).map(rest).collect();
            lists.push(last);
        }
        lists
    }

    /// What is at a point inside or on the boundary; `None` outside.
    #[must_use]
    pub fn at(&self, point: DVec3) -> Option<Value> {
        let mut sums = vec![0.0; self.fields.len()];
        let winding = self.sums(self.problem.scaling.inwards(point), &mut sums);
        (winding > INSIDE).then(|| {
            let mut values = Vec::with_capacity(self.materials());
            let is_clamped = self.show(winding, sums, &mut values);
            Value { values, is_clamped }
        })
    }

    /// The gradient of each material at a point inside; on the boundary that just inside, `None` outside.
    #[must_use]
    pub fn gradient(&self, point: DVec3) -> Option<Vec<DVec3>> {
        let mut x = self.problem.scaling.inwards(point);
        let mut sums = vec![0.0; self.fields.len()];
        let mut winding = self.sums(x, &mut sums);
        if winding <= INSIDE {
            return None;
        }
        if winding < ON_BOUNDARY {
            let distance = |panel: &&Panel| panel.nearest(x).distance_squared(x);
            let nearest = self.panels.list.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
            x -= nearest.normal * (1e-4 * nearest.diameter);
            winding = self.sums(x, &mut sums);
        }
        let own: Vec<f64> = sums.iter().map(|sum| sum / winding).collect();
        let mut gradients = vec![DVec3::ZERO; self.fields.len()];
        for (number, panel) in self.panels.list.iter().enumerate() {
            let layers = self.gradients_of(panel, x);
            for ((gradient, field), own) in gradients.iter_mut().zip(&self.fields).zip(&own) {
                *gradient += layers[0] * field.fluxes[number] + layers[1] * (field.values[number] - own);
            }
        }
        let scale = self.problem.scaling.scale();
        gradients.iter_mut().zip(&self.fields).for_each(|(gradient, field)| *gradient *= field.size * scale);
        if self.problem.conditions.are_fractions {
            gradients.push(-gradients.iter().sum::<DVec3>());
        }
        Some(gradients)
    }

    fn gradients_of(&self, panel: &Panel, x: DVec3) -> [DVec3; 2] {
        let space = self.panels.space;
        let distance = panel.centre.distance(x) / panel.diameter;
        if distance < EXACT {
            let exact = space.gradients(panel, x);
            return [exact.single, exact.double];
        }
        if distance > FAR {
            return space.point_gradients(panel.centre - x, panel.normal, panel.size);
        }
        let count = space.places();
        (0..count).fold([DVec3::ZERO; 2], |[single, double], number| {
            let place = space.place(panel, number) - x;
            let part = space.point_gradients(place, panel.normal, panel.size / count as f64);
            [single + part[0], double + part[1]]
        })
    }

    /// The sum of both layers for each material at a point in the coordinates of computing; returns the share of the full angle under which the boundary is seen.
    pub(super) fn sums(&self, x: DVec3, sums: &mut [f64]) -> f64 {
        sums.fill(0.0);
        let mut winding = 0.0;
        let mut values = Values::default();
        for cluster in &self.panels.clusters {
            self.panels.layers(cluster, x, &mut values);
            winding += self.add(&values, cluster.slots.start, sums);
        }
        winding
    }

    /// Adds what a cluster does for each material; returns its share of the full angle.
    #[inline(always)]
    pub(super) fn add(&self, values: &Values, start: usize, sums: &mut [f64]) -> f64 {
        let slots = start..start + values.single.len();
        for (sum, field) in sums.iter_mut().zip(&self.fields) {
            *sum += sum_of(values, &field.flux_slots[slots.clone()], Some(&field.value_slots[slots.clone()]));
        }
        values.double_sum()
    }

    /// The values from sums and the share of the full angle; returns whether one was out of its range.
    ///
    /// Green's identity holds for the solution less its value at the point as well, which takes the error of the angle out: the value is the sum over the
    /// share. On the boundary itself the same holds with the part of the angle that is inside.
    pub(super) fn show(
        &self,
        winding: f64,
        sums: impl IntoIterator<Item = f64>,
        values: &mut Vec<f64>,
    ) -> bool {
        let mut is_clamped = false;
        values.clear();
        for (sum, field) in sums.into_iter().zip(&self.fields) {
            let value = field.outwards(sum / winding);
            let shown = field.range.map_or(value, |[low, high]| value.clamp(low, high));
            // What rounding does is not counted.
            is_clamped |= (shown - value).abs() > 1e-6 * field.range.map_or(0.0, |[low, high]| high - low);
            values.push(shown);
        }
        if self.problem.conditions.are_fractions {
            let sum: f64 = values.iter().sum();
            if sum > 1.0 {
                // Each is in its range and the last would be below 0: they share what there is.
                values.iter_mut().for_each(|value| *value /= sum);
            }
            values.push((1.0 - values.iter().sum::<f64>()).max(0.0));
        }
        is_clamped
    }
}

/// Least and greatest value by the maximum principle: those that are given, and those that were found where something flows in or out. Where nothing does,
/// there is no extreme value (Hopf). Fractions are none below 0 and above 1, whatever fluxes ask for.
fn range(conditions: &Conditions, material: usize, field: &Field) -> Option<[f64; 2]> {
    if !conditions.is_value.contains(&true) {
        return None;
    }
    let flows = |(_, (is_value, datum)): &(&f64, (&bool, &f64))| **is_value || **datum != 0.0;
    let data = conditions.is_value.iter().zip(&conditions.data[material]);
    let bounding = field
        .values
        .iter()
        .zip(data)
        .filter(flows)
        .map(|(value, (is_value, datum))| if *is_value { *datum } else { field.outwards(*value) });
    let (low, high) =
        bounding.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    let limit = |x: f64| if conditions.are_fractions { x.clamp(0.0, 1.0) } else { x };
    Some([limit(low), limit(high)])
}
