//! Solving a blend in steps.

use super::division::{Division, Element};
use super::solved::{Blend, BlendMemory, is_floating, touches};
use super::{BlendPlan, Condition};
use crate::laplace::{Conditions, LaplaceError, LaplaceJob, LaplaceOptions, Mesh, Problem};
use crate::material::Composition;
use crate::part::{Composing, Part, Region};
use glam::DVec2;
use std::error::Error;
use std::fmt;

/// Share of the size of a body within which another one touches it.
const TOUCHING: f64 = 1e-3;
/// How far gradients may drive a fraction out of 0 to 1 before it is said.
const OVERSHOOT: f64 = 0.01;

/// Why there is no blend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BlendFaultKind {
    /// Parts of the boundary meet each other, or another body is not there.
    Apart,
    /// A piece is nowhere on the boundary.
    Nothing,
    /// Two conditions are given at one place.
    Conflict,
    /// There are more corners than elements.
    Limit,
    /// Gradients alone are given, and they do not sum to nothing.
    Imbalance,
    /// The equations cannot be solved.
    Unsolved,
}

/// Why there is no blend, with the piece of the plan and the place.
#[derive(Debug, Clone, PartialEq)]
pub struct BlendFault {
    /// Kind of the fault.
    pub kind: BlendFaultKind,
    /// The piece of the plan that it concerns.
    pub edge: Option<usize>,
    /// Where it is.
    pub at: Option<DVec2>,
    /// What was found and what was expected.
    pub message: String,
}

impl BlendFault {
    pub(super) fn new(kind: BlendFaultKind, message: impl Into<String>) -> Self {
        Self { kind, edge: None, at: None, message: message.into() }
    }

    pub(super) fn of(self, edge: usize) -> Self {
        Self { edge: Some(edge), ..self }
    }

    pub(super) fn at(self, place: DVec2) -> Self {
        Self { at: Some(place), ..self }
    }

    pub(super) fn of_solver(error: &LaplaceError) -> Self {
        use crate::laplace::Fault;
        let kind = match error.fault {
            Fault::Imbalance => BlendFaultKind::Imbalance,
            Fault::Meeting | Fault::Open | Fault::Inverted | Fault::Apart => BlendFaultKind::Apart,
            _ => BlendFaultKind::Unsolved,
        };
        Self { at: error.at.map(|at| at.truncate()), ..Self::new(kind, error.message.clone()) }
    }
}

impl fmt::Display for BlendFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl Error for BlendFault {}

/// A fraction that gradients drive out of 0 to 1, where it is farthest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overshoot {
    /// The material.
    pub material: usize,
    /// The fraction before it was limited.
    pub fraction: f64,
    /// Where that is.
    pub at: DVec2,
}

/// A blend, and what is to be said about it.
#[derive(Debug, Clone)]
pub struct BlendMade {
    /// The blend; `None` where nothing is known on the boundary but that nothing flows, so that the default is the solution.
    pub blend: Option<Blend>,
    /// Where gradients ask for more than there is.
    pub overshoot: Option<Overshoot>,
}

/// A blend being made.
#[derive(Debug)]
pub struct BlendJob {
    region: Region,
    plan: BlendPlan,
    default: Composition,
    work: Work,
}

#[derive(Debug)]
enum Work {
    Starting,
    /// The piece of the plan whose ends are found next.
    Marking(Division, usize),
    Giving(Given),
    Solving(Box<LaplaceJob>, Mesh, Conditions),
    Done,
}

/// Elements being given their conditions.
#[derive(Debug)]
struct Given {
    mesh: Mesh,
    elements: Vec<Element>,
    is_value: Vec<bool>,
    data: Vec<Vec<f64>>,
}

impl BlendJob {
    /// The blend of a region; gradients alone leave a constant free, with which the mean over the boundary is the default.
    #[must_use]
    pub fn new(region: Region, plan: BlendPlan, default: Composition) -> Self {
        Self { region, plan, default, work: Work::Starting }
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the blend when it is there. Other bodies are asked for their compositions as they are now.
    ///
    /// # Errors
    /// When a piece of the plan is nowhere on the boundary or contradicts another one, a body that is to be asked does not touch, parts of the boundary meet, or gradients
    /// are not balanced.
    pub fn step(
        &mut self,
        part: &Part,
        memory: &mut BlendMemory,
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Option<BlendMade>, BlendFault> {
        loop {
            let work = std::mem::replace(&mut self.work, Work::Done);
            self.work = match work {
                Work::Starting => Work::Marking(Division::new(&self.region, &self.plan)?, 0),
                Work::Marking(mut division, edge) if edge < self.plan.edges.len() => {
                    division.mark(&self.plan, edge)?;
                    Work::Marking(division, edge + 1)
                }
                Work::Marking(division, _) => {
                    let (mesh, elements) = division.divide(&self.plan)?;
                    let data = vec![Vec::with_capacity(elements.len()); part.materials];
                    Work::Giving(Given { mesh, elements, is_value: Vec::new(), data })
                }
                Work::Giving(mut given) => match given.elements.get(given.is_value.len()) {
                    Some(element) => {
                        let (is_value, fractions) = self.known_at(*element, part)?;
                        given.is_value.push(is_value);
                        given.data.iter_mut().zip(fractions).for_each(|(list, datum)| list.push(datum));
                        Work::Giving(given)
                    }
                    None => match self.begin(given, memory)? {
                        Ok(work) => work,
                        Err(made) => return Ok(Some(made)),
                    },
                },
                Work::Solving(mut job, mesh, conditions) => {
                    match job.step(may_go_on).map_err(|error| BlendFault::of_solver(&error))? {
                        None => Work::Solving(job, mesh, conditions),
                        Some(solution) => {
                            let blend = Blend::new(solution, mesh, conditions, self.default.clone());
                            memory.keep(blend.clone());
                            return Ok(Some(made(blend)));
                        }
                    }
                }
                Work::Done => Work::Done,
            };
            if !may_go_on() {
                return Ok(None);
            }
        }
    }

    /// Share of the work that is done, below 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        match &self.work {
            Work::Starting => 0.0,
            Work::Marking(_, edge) => 0.1 * *edge as f64 / self.plan.edges.len().max(1) as f64,
            Work::Giving(given) => 0.1 + 0.1 * given.is_value.len() as f64 / given.elements.len() as f64,
            Work::Solving(job, ..) => 0.2 + 0.8 * job.progress(),
            Work::Done => 0.999,
        }
    }

    /// Begins to solve, or has the blend already.
    fn begin(&self, given: Given, memory: &mut BlendMemory) -> Result<Result<Work, BlendMade>, BlendFault> {
        let Given { mesh, is_value, data, .. } = given;
        // With gradients alone all materials are solved for, because what is solved are no fractions yet.
        let are_fractions = is_value.contains(&true) && data.len() > 1;
        let conditions = Conditions { is_value, data, are_fractions };
        if is_floating(&conditions) && conditions.data.iter().flatten().all(|flux| *flux == 0.0) {
            return Ok(Err(BlendMade { blend: None, overshoot: None }));
        }
        if let Some(blend) = memory.find(&mesh, &conditions, &self.default) {
            return Ok(Err(made(blend)));
        }
        let of_solver = |error: LaplaceError| BlendFault::of_solver(&error);
        let problem = Problem::new(mesh.clone(), conditions.clone()).map_err(of_solver)?;
        let job = LaplaceJob::new(problem, LaplaceOptions::default()).map_err(of_solver)?;
        Ok(Ok(Work::Solving(Box::new(job), mesh, conditions)))
    }

    /// Whether the composition is known at an element, else its gradient, and the numbers.
    fn known_at(&self, element: Element, part: &Part) -> Result<(bool, Vec<f64>), BlendFault> {
        let Some(edge) = element.edge else { return Ok((false, vec![0.0; part.materials])) };
        let point = element.middle;
        let fault = |message: &str| Err(BlendFault::new(BlendFaultKind::Apart, message).of(edge).at(point));
        match &self.plan.edges[edge].condition {
            Condition::Value(mix) => Ok((true, mix.fractions().to_vec())),
            Condition::Flux(flux) => Ok((false, flux.clone())),
            Condition::Profile(of) => {
                let (profile, feature) = &**of;
                let mut fractions = vec![0.0; part.materials];
                profile.fractions(feature.distance(point), &mut fractions);
                Ok((true, fractions))
            }
            Condition::Body(number) => {
                let Some(Some(body)) = part.bodies.get(*number) else {
                    return fault("the body that the composition is taken from cannot be made");
                };
                if body.composing == Composing::Printed {
                    return fault(
                        "the composition is taken from a body by the printed rule, which has none at a point; expected another rule",
                    );
                }
                if !touches(&body.region, point, TOUCHING * self.region.bounds().diagonal()) {
                    return fault(
                        "the body that the composition is taken from is not here; expected one that touches all of this boundary",
                    );
                }
                body.place(point)
                    .fractions
                    .map_or_else(|| fault("it has no composition here"), |all| Ok((true, all)))
            }
        }
    }
}

fn made(blend: Blend) -> BlendMade {
    let farthest = blend.farthest().filter(|(_, value, _)| (value - 1.0).max(-value) > OVERSHOOT);
    let overshoot = farthest.map(|(material, fraction, at)| Overshoot { material, fraction, at });
    BlendMade { blend: Some(blend), overshoot }
}
