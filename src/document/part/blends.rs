//! Solving all blends of a part, in steps.

use super::diagnostic::PartDiagnostic;
use super::model::PartModel;
use super::plan::PlannedBlend;
use crate::part::{BlendFault, BlendFaultKind, BlendJob, BlendMade, BlendMemory, Part};
use std::rc::Rc;

/// The blends of a part being solved: each when those bodies have theirs whose compositions it takes.
#[derive(Debug)]
pub(super) struct BlendsJob {
    part: Part,
    names: Vec<String>,
    waiting: Vec<PlannedBlend>,
    current: Option<(usize, BlendJob)>,
    count: usize,
    diagnostics: Vec<PartDiagnostic>,
}

impl BlendsJob {
    pub(super) fn new(model: &PartModel) -> Self {
        Self {
            part: (**model.part()).clone(),
            names: model.materials().iter().map(|material| material.name.clone()).collect(),
            waiting: model.blends().to_vec(),
            current: None,
            count: model.blends().len(),
            diagnostics: Vec::new(),
        }
    }

    /// Advances while `may_go_on` says so, at least by a little; returns whether all are solved.
    pub(super) fn step(&mut self, memory: &mut BlendMemory, may_go_on: &mut dyn FnMut() -> bool) -> bool {
        loop {
            let Some((body, mut job)) = self.current.take().or_else(|| self.next()) else {
                self.refuse_circles();
                return true;
            };
            match job.step(&self.part, memory, may_go_on) {
                Ok(None) => self.current = Some((body, job)),
                Ok(Some(made)) => self.keep(body, made),
                Err(fault) => self.diagnostics.push(diagnostic(body, fault)),
            }
            if !may_go_on() {
                return false;
            }
        }
    }

    /// Share of the work that is done, below 1.
    pub(super) fn progress(&self) -> f64 {
        let current = self.current.as_ref();
        let done = self.count - self.waiting.len() - usize::from(current.is_some());
        (done as f64 + current.map_or(0.0, |(_, job)| job.progress())) / (self.count + 1) as f64
    }

    /// The part with its blends, and what is to be said about these.
    pub(super) fn finish(self) -> (Rc<Part>, Vec<PartDiagnostic>) {
        (Rc::new(self.part), self.diagnostics)
    }

    /// The first blend that waits for no other one.
    fn next(&mut self) -> Option<(usize, BlendJob)> {
        let is_free = |plan: &PlannedBlend| !self.waiting.iter().any(|other| plan.needs(other.body));
        let PlannedBlend { body, plan, default } =
            self.waiting.remove(self.waiting.iter().position(is_free)?);
        let region = self.part.bodies[body].as_ref()?.region.clone();
        Some((body, BlendJob::new(region, plan, default)))
    }

    /// What still waits, waits for itself.
    fn refuse_circles(&mut self) {
        for plan in std::mem::take(&mut self.waiting) {
            let message = "bodies take their compositions from each other in a circle; expected one that does not wait for another";
            let fault = PartDiagnostic::new("circle", format!("bodies[{}].blend", plan.body), message);
            self.diagnostics.push(PartDiagnostic { body: Some(plan.body as u32), ..fault });
        }
    }

    fn keep(&mut self, number: usize, made: BlendMade) {
        let path = format!("bodies[{number}].blend");
        let mut remark = |code: &'static str, message: String, at: Option<[f64; 2]>| {
            let said = PartDiagnostic::new(code, &path, message).remark();
            self.diagnostics.push(PartDiagnostic { body: Some(number as u32), at, ..said });
        };
        if made.blend.is_none() {
            let message = "no boundary has a composition or a gradient, so that the blend is the default";
            remark("insulated", message.to_owned(), None);
        }
        if let Some(over) = made.overshoot {
            let [x, y] = over.at.to_array();
            let message = format!(
                "gradients ask for the fraction {:.3} of {} at ({x:.6}, {y:.6}); fractions are limited to 0 to 1",
                over.fraction, self.names[over.material]
            );
            remark("clamped", message, Some([x, y]));
        }
        if let Some(body) = &mut self.part.bodies[number] {
            body.blend = made.blend;
        }
    }
}

fn diagnostic(body: usize, fault: BlendFault) -> PartDiagnostic {
    let code = match fault.kind {
        BlendFaultKind::Apart => "apart",
        BlendFaultKind::Nothing => "empty",
        BlendFaultKind::Conflict => "conflict",
        BlendFaultKind::Limit => "limit",
        BlendFaultKind::Imbalance => "imbalance",
        BlendFaultKind::Unsolved => "unsolved",
    };
    let path = fault.edge.map_or_else(String::new, |edge| format!(".boundaries[{edge}]"));
    let said = PartDiagnostic::new(code, format!("bodies[{body}].blend{path}"), fault.message);
    PartDiagnostic {
        body: Some(body as u32),
        boundary: fault.edge.map(|edge| edge as u8),
        at: fault.at.map(|at| at.to_array()),
        ..said
    }
}
