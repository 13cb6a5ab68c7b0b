//! The composition of a body by its blend.

use super::super::Region;
use crate::laplace::{Conditions, Mesh, Solution};
use crate::material::Composition;
use glam::DVec2;
use std::collections::VecDeque;
use std::rc::Rc;

/// Blends that are kept.
const KEPT: usize = 32;

/// A solution of Laplace's equation in a body as its composition.
#[derive(Debug, Clone)]
pub struct Blend(Rc<Solved>);

#[derive(Debug)]
struct Solved {
    solution: Rc<Solution>,
    /// What was solved; the solution may have balanced fluxes.
    mesh: Mesh,
    conditions: Conditions,
    default: Composition,
    /// Whether gradients alone are given, so that the mean over the boundary is the default.
    is_floating: bool,
    /// The middle of each element, and its fractions.
    boundary: Vec<(DVec2, Vec<f64>)>,
}

impl PartialEq for Blend {
    fn eq(&self, other: &Self) -> bool {
        let (a, b) = (&self.0, &other.0);
        Rc::ptr_eq(a, b) || (a.mesh == b.mesh && a.conditions == b.conditions && a.default == b.default)
    }
}

impl Blend {
    pub(super) fn new(solution: Solution, mesh: Mesh, conditions: Conditions, default: Composition) -> Self {
        let is_floating = is_floating(&conditions);
        let mut solved = Solved {
            solution: Rc::new(solution),
            mesh,
            conditions,
            default,
            is_floating,
            boundary: Vec::new(),
        };
        let values = solved.solution.values();
        let boundary = solved.mesh.panels().into_iter().enumerate().map(|(element, panel)| {
            let mut fractions: Vec<f64> = values.iter().map(|list| list[element]).collect();
            solved.finish(&mut fractions);
            (panel.centre.truncate(), fractions)
        });
        let boundary = boundary.collect();
        solved.boundary = boundary;
        Self(Rc::new(solved))
    }

    /// What the solution is evaluated by, for many places at once; its values still have to be [finished](Self::finish).
    pub(in crate::part) fn solution(&self) -> &Rc<Solution> {
        &self.0.solution
    }

    /// Number of elements of the boundary.
    #[must_use]
    pub fn elements(&self) -> usize {
        self.0.mesh.elements().len()
    }

    /// Writes the fractions at a point of the body. Beyond the elements, which are chords of a curved outline, they are those of the nearest element.
    pub fn fractions(&self, point: DVec2, fractions: &mut [f64]) {
        match self.0.solution.at(point.extend(0.0)) {
            Some(value) => {
                fractions.copy_from_slice(&value.values);
                self.0.finish(fractions);
            }
            None => self.nearest(point, fractions),
        }
    }

    /// Writes the fractions of the element whose middle is nearest to a point.
    pub(in crate::part) fn nearest(&self, point: DVec2, fractions: &mut [f64]) {
        let to = |(middle, _): &&(DVec2, Vec<f64>)| middle.distance_squared(point);
        let nearest = self.0.boundary.iter().min_by(|a, b| to(a).total_cmp(&to(b)));
        let found = nearest.map_or(self.0.default.fractions(), |(_, fractions)| fractions);
        fractions.copy_from_slice(found);
    }

    /// Makes values of the solution fractions.
    pub(in crate::part) fn finish(&self, values: &mut [f64]) {
        self.0.finish(values);
    }

    /// The largest distance of a fraction from the range 0 to 1 that the boundary had before it was limited, with the material, the fraction and the place.
    pub(super) fn farthest(&self) -> Option<(usize, f64, DVec2)> {
        let values = self.0.solution.values();
        let base = |material: usize| {
            if self.0.is_floating { self.0.default.fractions()[material] } else { 0.0 }
        };
        let all = values.iter().enumerate().flat_map(|(material, list)| {
            let raw = list.iter().zip(&self.0.boundary).zip(&self.0.conditions.is_value);
            raw.filter(|(_, is_value)| !**is_value)
                .map(move |((value, (middle, _)), _)| (material, value + base(material), *middle))
        });
        let beyond = |value: f64| (value - 1.0).max(-value);
        all.filter(|(_, value, _)| beyond(*value) > 0.0).max_by(|a, b| beyond(a.1).total_cmp(&beyond(b.1)))
    }

    /// Whether it is the solution of this problem.
    fn is_of(&self, mesh: &Mesh, conditions: &Conditions, default: &Composition) -> bool {
        let solved = &self.0;
        let is_default = !solved.is_floating || solved.default == *default;
        is_default && solved.conditions == *conditions && solved.mesh == *mesh
    }
}

impl Solved {
    /// Makes values fractions: where gradients alone are given the default is added; what gradients drive out of 0 to 1 is limited, and the rest shares.
    fn finish(&self, values: &mut [f64]) {
        if self.is_floating {
            values.iter_mut().zip(self.default.fractions()).for_each(|(value, default)| *value += default);
        }
        values.iter_mut().for_each(|value| *value = value.clamp(0.0, 1.0));
        let sum: f64 = values.iter().sum();
        if sum > 0.0 {
            values.iter_mut().for_each(|value| *value /= sum);
        } else {
            values.copy_from_slice(self.default.fractions());
        }
    }
}

/// Whether no value is given, so that a constant is free.
pub(super) fn is_floating(conditions: &Conditions) -> bool {
    !conditions.is_value.contains(&true)
}

/// The blends that were used last, so that what did not change is not solved again.
#[derive(Debug, Default)]
pub struct BlendMemory(VecDeque<Blend>);

impl BlendMemory {
    /// The solution of a problem if it is known.
    pub(super) fn find(
        &mut self,
        mesh: &Mesh,
        conditions: &Conditions,
        default: &Composition,
    ) -> Option<Blend> {
        let found = self.0.iter().position(|blend| blend.is_of(mesh, conditions, default))?;
        let blend = self.0.remove(found)?;
        self.0.push_front(blend.clone());
        Some(blend)
    }

    /// Remembers a solution.
    pub(super) fn keep(&mut self, blend: Blend) {
        self.0.push_front(blend);
        self.0.truncate(KEPT);
    }
}

/// Whether a point lies in a region or on its boundary, to within a distance.
pub(super) fn touches(region: &Region, point: DVec2, within: f64) -> bool {
    region.contains(point) || region.rings().any(|ring| ring.distance(point) <= within)
}
