//! The harmonic blend of nested curves: potential, composition, level curves, lines along the gradient.

use super::field::FieldWork;
use super::flow::Flow;
use super::thread::{Start, Tracer, crossings, starts};
use super::{Field, GradientLine, Rings};
use crate::curve::BSpline;
use crate::laplace::{Conditions, LaplaceError, LaplaceJob, LaplaceOptions, Problem, Solution};
use crate::material::Composition;
use crate::morph::IsoLine;
use glam::{DVec2, DVec3};

/// Steps of Newton's method by which a point is brought to its level, and a difference from it after which the next step leaves none to speak of.
const NEWTON: usize = 4;
const CLOSE: f64 = 1e-4;
/// Most points of a level curve, about.
const MOST_POINTS: usize = 600;

/// How fine a blend is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fineness {
    /// Segments of each curve, about; at least 3.
    pub segments: usize,
    /// Lines along the gradient, at least one from each inner curve.
    pub lines: usize,
    /// Equal parts of the potential, between which there are level curves.
    pub stages: usize,
    /// Greatest difference of the potential and of every fraction from the solution, where it is shown linear on triangles.
    pub tolerance: f64,
}

/// Points that are brought to their level at a time.
const AT_ONCE: usize = 64;

/// What is known of a material without solving for it.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Recipe {
    /// Constant on the outer curve and on all others: its fraction where the potential is 0, and the change from there to 1.
    Linear(f64, f64),
    /// The quantity of that number.
    Solved(usize),
    /// What the others leave.
    Rest,
}

/// The blend between an outer curve, where the potential is 1, and the curves inside it, where it is 0.
#[derive(Debug, Clone)]
pub struct HarmonicBlend {
    rings: Rings,
    solution: Solution,
    flow: Flow,
    recipes: Vec<Recipe>,
    field: Field,
    lines: Vec<GradientLine>,
    /// The level curves between two stages, from the first one on.
    levels: Vec<Vec<Vec<DVec2>>>,
    crossings: usize,
    /// Lines that were begun and did not come to the outer curve.
    lost: usize,
    flux: f64,
    area: f64,
}

/// What the blend holds at a point.
#[derive(Debug, Clone, PartialEq)]
pub struct HarmonicPlace {
    /// 0 on the inner curves to 1 on the outer one.
    pub potential: f64,
    /// Its gradient, per unit of length.
    pub gradient: DVec2,
    /// The composition.
    pub composition: Composition,
}

impl HarmonicBlend {
    /// The curves as rings of segments.
    #[must_use]
    pub fn rings(&self) -> &Rings {
        &self.rings
    }

    /// The solution of Laplace's equation whose first quantity is the potential.
    #[must_use]
    pub fn solution(&self) -> &Solution {
        &self.solution
    }

    /// The potential and the fractions of all materials on triangles.
    #[must_use]
    pub fn field(&self) -> &Field {
        &self.field
    }

    /// Lines along the gradient.
    #[must_use]
    pub fn lines(&self) -> &[GradientLine] {
        &self.lines
    }

    /// The level curves between two stages, from the one next to the inner curves on: each of them may be several loops.
    #[must_use]
    pub fn levels(&self) -> &[Vec<Vec<DVec2>>] {
        &self.levels
    }

    /// Number of pairs of lines that meet: 0, since lines along a gradient cannot.
    #[must_use]
    pub fn crossings(&self) -> usize {
        self.crossings
    }

    /// Lines that did not come to the outer curve, and are left out.
    #[must_use]
    pub fn lost(&self) -> usize {
        self.lost
    }

    /// What flows from the outer curve to the inner ones: the integral of the derivative of the potential along the outward normal.
    #[must_use]
    pub fn flux(&self) -> f64 {
        self.flux
    }

    /// Area between the curves themselves.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.area
    }

    /// How much of each material is between the curves, by area: the mean over the triangles, which leave out what is between curves and chords, times the area.
    #[must_use]
    pub fn amounts(&self) -> Vec<f64> {
        let field = &self.field;
        let (mut whole, mut sums) = (0.0, vec![0.0; self.recipes.len()]);
        for corners in &field.triangles {
            let [a, b, c] = corners.map(|k| field.points[k as usize]);
            let size = (b - a).perp_dot(c - a) / 2.0;
            whole += size;
            for (material, sum) in sums.iter_mut().enumerate() {
                let own: f64 = corners.iter().map(|k| field.value(*k, 1 + material)).sum();
                *sum += size * own / 3.0;
            }
        }
        sums.iter().map(|sum| if whole > 0.0 { sum / whole * self.area } else { 0.0 }).collect()
    }

    /// What is at a point between the curves; `None` elsewhere.
    #[must_use]
    pub fn locate(&self, point: DVec2) -> Option<HarmonicPlace> {
        let numbers = self.numbers(point)?;
        Some(HarmonicPlace {
            potential: numbers[0],
            gradient: self.flow.gradient(point),
            composition: Composition::rounded(numbers[1..].to_vec()),
        })
    }

    /// The same blend shown on triangles that may be farther from the solution, for files that would be long.
    #[must_use]
    pub fn lightened(&self, tolerance: f64) -> Self {
        let values = (0..self.rings.count()).flat_map(|k| self.field.at(k)).copied().collect();
        let mut work = FieldWork::new(&self.rings, values, self.field.width, tolerance);
        work.step(&|point| self.numbers(point), &mut || true);
        Self { field: work.finish(), ..self.clone() }
    }

    /// The closed curves on which the potential has a value above 0 and below 1, each point on it to rounding.
    #[must_use]
    pub fn level(&self, potential: f64) -> Vec<Vec<DVec2>> {
        let mut loops = self.loops(potential);
        for points in &mut loops {
            points.iter_mut().for_each(|point| *point = self.onto(*point, potential));
        }
        loops
    }

    /// The same on the triangles, thinned.
    fn loops(&self, potential: f64) -> Vec<Vec<DVec2>> {
        let lines: Vec<IsoLine> =
            self.field.iso_lines(0, potential).into_iter().filter(|line| line.closed).collect();
        let count: usize = lines.iter().map(|line| line.points.len()).sum();
        let least = 0.25_f64.max(count as f64 / MOST_POINTS as f64 - 0.5);
        lines.into_iter().map(|line| thinned(line.points, least)).filter(|points| points.len() > 2).collect()
    }

    /// Lines of equal fraction of a material.
    ///
    /// # Panics
    /// When there is no such material.
    #[must_use]
    pub fn iso_lines(&self, material: usize, level: f64) -> Vec<IsoLine> {
        self.field.iso_lines(1 + material, level)
    }

    /// Brings a point that is near to a level onto it.
    fn onto(&self, start: DVec2, potential: f64) -> DVec2 {
        let mut point = start;
        for _ in 0..NEWTON {
            let Some(value) = self.solution.quantity_at(0, point.extend(0.0)) else { return start };
            let gradient = self.flow.gradient(point);
            let miss = potential - value;
            let step = gradient * (miss / gradient.length_squared());
            if !step.is_finite() {
                return start;
            }
            point += step;
            if miss.abs() < CLOSE {
                break;
            }
        }
        point
    }

    /// The potential and all fractions at a point.
    fn numbers(&self, point: DVec2) -> Option<Vec<f64>> {
        numbers(&self.solution, &self.recipes, point)
    }
}

/// A closed line without points that are nearer to the one before than a share of what most are: the edges of triangles cut it unevenly.
fn thinned(points: Vec<DVec2>, share: f64) -> Vec<DVec2> {
    let count = points.len();
    let length: f64 = (0..count).map(|k| points[k].distance(points[(k + 1) % count])).sum();
    let least = share * length / count.max(1) as f64;
    let mut kept: Vec<DVec2> = Vec::with_capacity(count);
    for point in points {
        if kept.last().is_none_or(|last| last.distance(point) >= least) {
            kept.push(point);
        }
    }
    kept
}

fn numbers(solution: &Solution, recipes: &[Recipe], point: DVec2) -> Option<Vec<f64>> {
    let found = solution.at(DVec3::new(point.x, point.y, 0.0))?.values;
    let mut numbers = Vec::with_capacity(1 + recipes.len());
    numbers.push(found[0]);
    numbers.extend(recipes.iter().map(|recipe| match recipe {
        Recipe::Linear(from, change) => from + change * found[0],
        Recipe::Solved(quantity) => found[*quantity],
        Recipe::Rest => 0.0,
    }));
    let sum: f64 = numbers[1..].iter().sum();
    if sum > 1.0 {
        // Each is in its range and the last would be below 0: they share what there is.
        numbers[1..].iter_mut().for_each(|fraction| *fraction /= sum);
    }
    if let Some(rest) = recipes.iter().position(|recipe| *recipe == Recipe::Rest) {
        numbers[1 + rest] = (1.0 - sum).max(0.0);
    }
    Some(numbers)
}

/// The composition along a curve, by the number of the curve and the parameter, which may lie beyond the end of the domain.
pub type Compose<'a> = dyn Fn(usize, f64) -> Composition + 'a;

/// A blend on its way.
#[derive(Debug)]
pub struct HarmonicWork {
    curves: Vec<BSpline>,
    rings: Rings,
    fineness: Fineness,
    recipes: Vec<Recipe>,
    /// The potential and the fractions at all vertices of the rings.
    at_vertices: Vec<f64>,
    state: State,
}

#[derive(Debug)]
enum State {
    Solving(Box<LaplaceJob>),
    Spreading { solution: Box<Solution>, work: Box<FieldWork> },
    Following { blend: Box<HarmonicBlend>, starts: Vec<Start>, next: usize },
    Levelling { blend: Box<HarmonicBlend>, level: Option<Vec<Vec<DVec2>>>, ring: usize, next: usize },
    Over,
}

impl HarmonicWork {
    /// Begins with counter-clockwise curves that do not meet, of which one contains all others, none of which contains another, and with their rings.
    ///
    /// # Errors
    /// When the segments are not the boundary of one region: too few of them for the shapes.
    pub fn new(
        curves: Vec<BSpline>,
        rings: Rings,
        compose: &Compose<'_>,
        fineness: Fineness,
    ) -> Result<Self, LaplaceError> {
        let outer = rings.outer();
        let potential = |ring: usize| f64::from(u8::from(ring == outer));
        let row = |place: (usize, usize), t: f64| {
            let (ring, own) = place;
            let mix = compose(ring, rings.list()[ring].parameter(own, t));
            let mut row = vec![potential(ring)];
            row.extend(mix.fractions());
            row
        };
        let at_vertices: Vec<f64> = (0..rings.count()).flat_map(|k| row(rings.place(k), 0.0)).collect();
        let on_segments: Vec<Vec<f64>> = (0..rings.count()).map(|k| row(rings.place(k), 0.5)).collect();
        let width = on_segments.first().map_or(1, Vec::len);
        let (mut recipes, mut data) =
            (Vec::new(), vec![on_segments.iter().map(|row| row[0]).collect::<Vec<f64>>()]);
        for material in 1..width {
            let recipe = if material + 1 == width {
                Recipe::Rest
            } else if let Some((from, change)) = linear(&rings, &at_vertices, &on_segments, width, material) {
                Recipe::Linear(from, change)
            } else {
                data.push(on_segments.iter().map(|row| row[material]).collect());
                Recipe::Solved(data.len() - 1)
            };
            recipes.push(recipe);
        }
        let conditions = Conditions { is_value: vec![true; rings.count()], data, are_fractions: false };
        let problem = Problem::new(rings.mesh()?, conditions)?;
        let job = LaplaceJob::new(problem, LaplaceOptions::default())?;
        let state = State::Solving(Box::new(job));
        Ok(Self { curves, rings, fineness, recipes, at_vertices, state })
    }

    /// Share of the work that is done, below 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        match &self.state {
            State::Solving(job) => 0.3 * job.progress(),
            State::Spreading { work, .. } => 0.3 + 0.4 * work.progress(),
            State::Following { starts, next, .. } => 0.7 + 0.2 * *next as f64 / starts.len().max(1) as f64,
            State::Levelling { blend, .. } => {
                0.9 + 0.09 * blend.levels.len() as f64 / self.fineness.stages as f64
            }
            State::Over => 0.999,
        }
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the blend when it is there.
    ///
    /// # Errors
    /// When Laplace's equation cannot be solved.
    pub fn step(
        &mut self,
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Option<HarmonicBlend>, LaplaceError> {
        loop {
            match &mut self.state {
                State::Solving(job) => {
                    if let Some(solution) = job.step(may_go_on)? {
                        let values = std::mem::take(&mut self.at_vertices);
                        let width = 1 + self.recipes.len();
                        let work = FieldWork::new(&self.rings, values, width, self.fineness.tolerance);
                        self.state = State::Spreading { solution: Box::new(solution), work: Box::new(work) };
                    }
                }
                State::Spreading { solution, work } => {
                    let solve = |point: DVec2| numbers(solution, &self.recipes, point);
                    if work.step(&solve, may_go_on) {
                        self.state = self.spread();
                    }
                }
                State::Following { blend, starts, next } => {
                    let fluxes = first(blend.solution.fluxes());
                    let (low, high) = blend.solution.problem().mesh().bounds();
                    let size = (high - low).length();
                    let tracer = Tracer::new(&self.rings, &self.curves, &blend.flow, &fluxes, size);
                    while *next < starts.len() {
                        match tracer.line(starts[*next]) {
                            Some(line) => blend.lines.push(line),
                            None => blend.lost += 1,
                        }
                        *next += 1;
                        if !may_go_on() && *next < starts.len() {
                            return Ok(None);
                        }
                    }
                    let State::Following { mut blend, .. } = std::mem::replace(&mut self.state, State::Over)
                    else {
                        return Ok(None);
                    };
                    let points: Vec<Vec<DVec2>> =
                        blend.lines.iter().map(|line| line.points.clone()).collect();
                    blend.crossings = crossings(&points);
                    self.state = State::Levelling { blend, level: None, ring: 0, next: 0 };
                }
                State::Levelling { blend, level, ring, next } => {
                    let number = blend.levels.len() + 1;
                    let potential = number as f64 / self.fineness.stages as f64;
                    match level {
                        None if number < self.fineness.stages => *level = Some(blend.loops(potential)),
                        None => {
                            let over = std::mem::replace(&mut self.state, State::Over);
                            let State::Levelling { blend, .. } = over else { return Ok(None) };
                            return Ok(Some(*blend));
                        }
                        Some(loops) => match loops.get_mut(*ring) {
                            Some(points) if *next < points.len() => {
                                let until = points.len().min(*next + AT_ONCE);
                                for point in &mut points[*next..until] {
                                    *point = blend.onto(*point, potential);
                                }
                                *next = until;
                            }
                            Some(_) => (*ring, *next) = (*ring + 1, 0),
                            None => {
                                blend.levels.extend(level.take());
                                (*ring, *next) = (0, 0);
                            }
                        },
                    }
                }
                State::Over => return Ok(None),
            }
            if !may_go_on() {
                return Ok(None);
            }
        }
    }

    /// From the finished field to the lines.
    fn spread(&mut self) -> State {
        let State::Spreading { solution, work } = std::mem::replace(&mut self.state, State::Over) else {
            return State::Over;
        };
        let fluxes = first(solution.fluxes());
        let lengths: Vec<f64> = solution.problem().mesh().panels().iter().map(|panel| panel.size).collect();
        let starts = starts(&self.rings, &fluxes, &lengths, self.fineness.lines);
        let outer = self.rings.start(self.rings.outer());
        let own = outer..outer + self.rings.list()[self.rings.outer()].len();
        let flux = own.map(|k| fluxes[k] * lengths[k]).sum();
        let areas = self.curves.iter().map(|curve| curve.signed_area().abs());
        let area = 2.0 * self.curves[self.rings.outer()].signed_area().abs() - areas.sum::<f64>();
        let blend = HarmonicBlend {
            rings: self.rings.clone(),
            flow: Flow::new(&solution),
            solution: *solution,
            recipes: self.recipes.clone(),
            field: work.finish(),
            lines: Vec::with_capacity(starts.len()),
            levels: Vec::new(),
            crossings: 0,
            lost: 0,
            flux,
            area,
        };
        State::Following { blend: Box::new(blend), starts, next: 0 }
    }

    /// Runs the work to its end.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn run(mut self) -> Result<HarmonicBlend, LaplaceError> {
        loop {
            if let Some(blend) = self.step(&mut || true)? {
                return Ok(blend);
            }
        }
    }
}

fn first(lists: Vec<Vec<f64>>) -> Vec<f64> {
    lists.into_iter().next().unwrap_or_default()
}

/// The fraction of a material where the potential is 0 and its change to 1, where it is constant on the outer curve and the same on all others.
fn linear(
    rings: &Rings,
    at_vertices: &[f64],
    on_segments: &[Vec<f64>],
    width: usize,
    material: usize,
) -> Option<(f64, f64)> {
    let mut ends: [Option<f64>; 2] = [None; 2];
    for (k, row) in on_segments.iter().enumerate() {
        let end = &mut ends[usize::from(rings.place(k).0 == rings.outer())];
        for fraction in [row[material], at_vertices[k * width + material]] {
            if (fraction - *end.get_or_insert(fraction)).abs() > 1e-12 {
                return None;
            }
        }
    }
    let [from, to] = ends;
    from.zip(to).map(|(from, to)| (from, to - from))
}
