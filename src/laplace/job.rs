//! Solving in steps.

use super::assemble::{Assembly, Equations};
use super::cluster::Panels;
use super::error::{Fault, LaplaceError};
use super::gmres::{Convergence, Gmres, GmresOptions};
use super::lu::{Estimate, Lu, MOST_LU};
use super::matrix::{MOST_DENSE, norm};
use super::problem::Problem;
use super::solution::Solution;
use std::rc::Rc;

/// How the equations are solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// By generalized minimal residuals.
    Gmres(GmresOptions),
    /// By Gauss' elimination, up to [`MOST_LU`] elements.
    Lu,
}

/// What is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LaplaceOptions {
    /// How the equations are solved.
    pub method: Method,
    /// Whether the condition number of the matrix is estimated, by its elimination.
    pub with_condition: bool,
    /// Most elements for which the matrix is kept, at most [`MOST_DENSE`].
    pub most_dense: usize,
}

impl Default for LaplaceOptions {
    fn default() -> Self {
        Self { method: Method::Gmres(GmresOptions::default()), with_condition: false, most_dense: MOST_DENSE }
    }
}

/// What is being done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// The equations are made.
    Assembling,
    /// They are solved, or the condition number is estimated.
    Solving,
}

/// A problem being solved.
#[derive(Debug)]
pub struct LaplaceJob {
    problem: Problem,
    options: LaplaceOptions,
    panels: Rc<Panels>,
    equations: Option<Equations>,
    lu: Option<Lu>,
    solved: Vec<Vec<f64>>,
    convergences: Vec<Convergence>,
    condition: Option<f64>,
    work: Work,
}

#[derive(Debug)]
enum Work {
    Assembling(Box<Assembly>),
    Eliminating(Lu),
    Estimating(Estimate),
    Solving(Box<Gmres>),
    /// It is to be decided what comes next.
    Between,
    Done,
}

impl LaplaceJob {
    /// # Errors
    /// When the method cannot be used for so many elements or an option is out of range, and when there is no memory for the matrix.
    pub fn new(problem: Problem, options: LaplaceOptions) -> Result<Self, LaplaceError> {
        let n = problem.mesh.elements().len();
        let most = options.most_dense.min(MOST_DENSE);
        let method = |message: String| Err(LaplaceError::new(Fault::Method, message));
        match options.method {
            Method::Lu if n > MOST_LU.min(most) => {
                return method(format!(
                    "`lu` was asked for with {n} elements; expected {} at most, because its time grows as the cube of their number",
                    MOST_LU.min(most)
                ));
            }
            Method::Lu => {}
            Method::Gmres(gmres) => {
                gmres.preconditioner.check(n <= most, most)?;
                if !(gmres.tolerance > 0.0 && gmres.restart > 0) {
                    return method(format!(
                        "the tolerance {} and the restart {} were found; expected numbers above 0",
                        gmres.tolerance, gmres.restart
                    ));
                }
            }
        }
        if options.with_condition && n > MOST_LU.min(most) {
            return method(format!(
                "the condition number was asked for with {n} elements; expected {} at most, because it needs elimination",
                MOST_LU.min(most)
            ));
        }
        let scaling = problem.scaling;
        let space = problem.mesh.space();
        let corners = |element| problem.mesh.corners(element).map(|corner| scaling.inwards(corner));
        let panels =
            Rc::new(Panels::new(space, (0..n).map(|element| space.panel(corners(element))).collect()));
        let assembly = Assembly::new(Rc::clone(&panels), problem.given(), options.most_dense)?;
        Ok(Self {
            problem,
            options,
            panels,
            equations: None,
            lu: None,
            solved: Vec::new(),
            convergences: Vec::new(),
            condition: None,
            work: Work::Assembling(Box::new(assembly)),
        })
    }

    /// Advances while `may_go_on` says so and the [stage](Self::stage) is the same, at least by a little; returns the solution when it is there.
    ///
    /// # Errors
    /// When the boundary meets itself, or the matrix is singular.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Result<Option<Solution>, LaplaceError> {
        let stage = self.stage();
        loop {
            let work = std::mem::replace(&mut self.work, Work::Done);
            self.work = self.advance(work, may_go_on)?;
            if matches!(self.work, Work::Done) {
                return Ok(self.equations.take().map(|equations| self.solution(&equations)));
            }
            if self.stage() != stage || !may_go_on() {
                return Ok(None);
            }
        }
    }

    /// Runs the job to its end.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn run(mut self) -> Result<Solution, LaplaceError> {
        loop {
            if let Some(solution) = self.step(&mut || true)? {
                return Ok(solution);
            }
        }
    }

    /// What is being done.
    #[must_use]
    pub fn stage(&self) -> Stage {
        if matches!(self.work, Work::Assembling(_)) { Stage::Assembling } else { Stage::Solving }
    }

    /// Iterations done for the material being solved for, and its true residual over the right-hand side.
    #[must_use]
    pub fn iteration(&self) -> Option<(usize, f64)> {
        if let Work::Solving(gmres) = &self.work { Some(gmres.state()) } else { None }
    }

    /// Share of the work that is done, below 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        let materials = self.problem.shifts.len() as f64;
        // Elimination takes longest where it is asked for.
        let eliminated = if self.needs_lu() { 0.9 } else { 0.3 };
        let solved =
            |more: f64| eliminated + (1.0 - eliminated) * (self.solved.len() as f64 + more) / materials;
        let share = match &self.work {
            Work::Assembling(assembly) => 0.3 * assembly.progress(),
            Work::Eliminating(lu) => 0.3 + 0.6 * lu.progress(),
            Work::Estimating(_) => eliminated,
            Work::Between if self.needs_lu() && self.lu.is_none() => 0.3,
            Work::Solving(gmres) => {
                let tolerance = match self.options.method {
                    Method::Gmres(options) => options.tolerance.min(0.5),
                    Method::Lu => 0.5,
                };
                // Residuals fall about evenly on a logarithmic scale.
                solved((gmres.state().1.max(tolerance).ln() / tolerance.ln()).clamp(0.0, 0.99))
            }
            Work::Between | Work::Done => solved(0.0),
        };
        share.min(0.999)
    }

    fn advance(&mut self, work: Work, may_go_on: &mut dyn FnMut() -> bool) -> Result<Work, LaplaceError> {
        match work {
            Work::Assembling(mut assembly) => {
                let is_done = assembly.step(may_go_on).map_err(|error| self.in_place(error))?;
                if !is_done {
                    return Ok(Work::Assembling(assembly));
                }
                self.equations = Some(assembly.finish());
                Ok(Work::Between)
            }
            Work::Eliminating(mut lu) => {
                if !lu.step(may_go_on) {
                    return Ok(Work::Eliminating(lu));
                }
                if lu.is_singular() && self.options.method == Method::Lu {
                    let message = "the matrix is singular to rounding; expected a boundary whose elements differ in size by less";
                    return Err(LaplaceError::new(Fault::Method, message));
                }
                self.lu = Some(lu);
                Ok(Work::Between)
            }
            Work::Estimating(mut estimate) => {
                self.condition = self.lu.as_ref().and_then(|lu| estimate.step(lu));
                Ok(if self.condition.is_none() && self.lu.is_some() {
                    Work::Estimating(estimate)
                } else {
                    Work::Between
                })
            }
            Work::Solving(mut gmres) => {
                let Some(equations) = &self.equations else { return Ok(Work::Done) };
                if !gmres.step(&equations.matrix, may_go_on) {
                    return Ok(Work::Solving(gmres));
                }
                let (x, convergence) = gmres.finish();
                self.solved.push(x);
                self.convergences.push(convergence);
                Ok(Work::Between)
            }
            Work::Between => Ok(self.next()),
            Work::Done => Ok(Work::Done),
        }
    }

    fn next(&mut self) -> Work {
        let Some(equations) = &self.equations else { return Work::Done };
        let Some(lu) = &self.lu else {
            let lu = if self.needs_lu() { Lu::new(&equations.matrix) } else { None };
            return lu.map_or_else(|| self.iterate(), Work::Eliminating);
        };
        if self.options.with_condition && self.condition.is_none() {
            return Work::Estimating(Estimate::new(lu));
        }
        if self.options.method != Method::Lu {
            return self.iterate();
        }
        let Some(side) = equations.sides.get(self.solved.len()) else { return Work::Done };
        let x = lu.solve(side);
        let mut image = vec![0.0; x.len()];
        equations.matrix.multiply(&x, &equations.matrix.spread(&x), 0..side.len(), &mut image);
        image.iter_mut().zip(side).for_each(|(image, side)| *image = side - *image);
        let scale = norm(side);
        let residual = if scale > 0.0 { norm(&image) / scale } else { 0.0 };
        self.convergences.push(Convergence {
            residuals: vec![residual],
            preconditioned: vec![residual],
            is_converged: true,
        });
        self.solved.push(x);
        Work::Between
    }

    fn needs_lu(&self) -> bool {
        self.options.with_condition || self.options.method == Method::Lu
    }

    fn iterate(&self) -> Work {
        let side = self.equations.as_ref().and_then(|equations| equations.sides.get(self.solved.len()));
        match (side, self.options.method) {
            (Some(side), Method::Gmres(options)) => {
                Work::Solving(Box::new(Gmres::new(options, side.clone())))
            }
            _ => Work::Done,
        }
    }

    /// An error with its place in the coordinates of the boundary.
    fn in_place(&self, error: LaplaceError) -> LaplaceError {
        LaplaceError { at: error.at.map(|at| self.problem.scaling.outwards(at)), ..error }
    }

    fn solution(&mut self, equations: &Equations) -> Solution {
        Solution::new(
            self.problem.clone(),
            Rc::clone(&self.panels),
            std::mem::take(&mut self.solved),
            std::mem::take(&mut self.convergences),
            self.condition,
            equations.closure,
        )
    }
}

/// Solves a problem.
///
/// # Errors
/// As [`LaplaceJob::new`] and [`LaplaceJob::step`].
pub fn solve(problem: Problem, options: LaplaceOptions) -> Result<Solution, LaplaceError> {
    LaplaceJob::new(problem, options)?.run()
}
