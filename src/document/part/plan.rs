//! What the blends of a document ask for.

use super::diagnostic::PartDiagnostic;
use super::model::{Builder, Made, build_profile};
use super::schema::{BodySpec, BoundarySpec, ComposingRule, PartBlendSpec, SourceSpec};
use crate::material::Composition;
use crate::part::{BlendPlan, Condition, Edge, On, Region};

/// The blend of a body that is to be solved.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PlannedBlend {
    /// Index of the body.
    pub(super) body: usize,
    /// What is known on its boundary.
    pub(super) plan: BlendPlan,
    /// Composition where nothing is known.
    pub(super) default: Composition,
}

impl PlannedBlend {
    /// Whether the composition of a body has to be there first.
    pub(super) fn needs(&self, body: usize) -> bool {
        self.plan.edges.iter().any(|edge| edge.condition == Condition::Body(body))
    }
}

impl Builder<'_> {
    /// The blends of all bodies that are made.
    pub(super) fn plans(&mut self, regions: &[Option<Region>]) -> Vec<PlannedBlend> {
        let document = self.document;
        let mut plans = Vec::new();
        for (number, spec) in document.bodies.iter().enumerate() {
            if let (Some(region), Some(blend)) = (&regions[number], &spec.blend) {
                plans.extend(self.planned(number, spec, blend, region, regions));
            }
        }
        plans
    }

    /// `None` where a fault was noted.
    fn planned(
        &mut self,
        number: usize,
        spec: &BodySpec,
        blend: &PartBlendSpec,
        region: &Region,
        regions: &[Option<Region>],
    ) -> Option<PlannedBlend> {
        let path = format!("bodies[{number}].blend");
        let of_body = |fault: PartDiagnostic| PartDiagnostic { body: Some(number as u32), ..fault };
        if spec.rule == ComposingRule::Printed {
            let message = "a body by the printed rule has no blend; expected another rule";
            self.diagnostics.push(of_body(PartDiagnostic::new("limit", path, message)));
            return None;
        }
        let mut edges = Vec::new();
        let mut is_whole = true;
        for (k, boundary) in blend.boundaries.iter().enumerate() {
            let at = format!("{path}.boundaries[{k}]");
            let of_boundary =
                |fault: PartDiagnostic| PartDiagnostic { boundary: Some(k as u8), ..of_body(fault) };
            let on = self.on(boundary, spec, region, &at).map_err(of_boundary);
            let condition = self.condition(boundary, number, spec, regions, &at).map_err(of_boundary);
            let (on, condition) = (self.kept(on), self.kept(condition));
            match on.zip(condition) {
                Some((on, condition)) => edges.push(Edge { on, condition }),
                None => is_whole = false,
            }
        }
        let default = Composition::new(spec.default.clone()).ok()?;
        let plan = BlendPlan { elements: blend.elements, edges };
        is_whole.then_some(PlannedBlend { body: number, plan, default })
    }

    fn on(&self, spec: &BoundarySpec, body: &BodySpec, region: &Region, path: &str) -> Made<On> {
        let path = format!("{path}.on");
        let (_, shape) = self.shape(&spec.on, &path)?;
        if body.outline != spec.on && !body.holes.contains(&spec.on) {
            return Ok(On::Near(shape.clone(), spec.within));
        }
        let ring = region.rings().position(|ring| ring == shape);
        ring.map(On::Ring).ok_or_else(|| {
            let message = format!("the hole \"{}\" cannot be made", spec.on);
            PartDiagnostic::new("shape", path, message)
        })
    }

    fn condition(
        &self,
        spec: &BoundarySpec,
        number: usize,
        body: &BodySpec,
        regions: &[Option<Region>],
        path: &str,
    ) -> Made<Condition> {
        if let Some(mix) = &spec.value {
            let made = Composition::new(mix.clone());
            let fault = |error: String| PartDiagnostic::new("shape", format!("{path}.value"), error);
            return made.map(Condition::Value).map_err(|error| fault(error.to_string()));
        }
        let unknown = |field: &str, message: String| {
            Err(PartDiagnostic::new("unknown-name", format!("{path}.from.{field}"), message))
        };
        match &spec.from {
            None => {
                let nothing = || vec![0.0; self.document.materials.len()];
                Ok(Condition::Flux(spec.flux.clone().unwrap_or_else(nothing)))
            }
            Some(SourceSpec::Body(name)) => {
                match self.document.bodies.iter().position(|body| body.name == *name) {
                    Some(other) if other == number => {
                        let message = "the body takes its composition from itself; expected another one";
                        Err(PartDiagnostic::new("circle", format!("{path}.from.body"), message))
                    }
                    Some(other) if regions[other].is_none() => {
                        let message = format!("the body \"{name}\" cannot be made, see bodies[{other}]");
                        Err(PartDiagnostic::new("shape", format!("{path}.from.body"), message))
                    }
                    Some(other) => Ok(Condition::Body(other)),
                    None => unknown("body", format!("there is no body \"{name}\"")),
                }
            }
            Some(SourceSpec::Feature(name)) => {
                let Some(k) = body.features.iter().position(|feature| feature.name == *name) else {
                    return unknown("feature", format!("the body has no feature \"{name}\""));
                };
                let at = format!("bodies[{number}].features[{k}]");
                let wrong = |fault: PartDiagnostic| {
                    let message = format!("the feature \"{name}\" cannot be made: {}", fault.message);
                    PartDiagnostic::new("shape", format!("{path}.from.feature"), message)
                };
                let profile = build_profile(&body.features[k], &at).map_err(wrong)?;
                let feature = self.feature(&body.features[k], &at, regions).map_err(wrong)?;
                Ok(Condition::Profile(Box::new((profile, feature))))
            }
        }
    }
}
