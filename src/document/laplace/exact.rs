//! Solutions that are known exactly.

use super::boundary::BoundaryProblem;
use super::schema::BoundaryModel;
use crate::laplace::{Fault, LaplaceError, MOST_POINTS, Panel, Space, faces};
use glam::DVec3;
use std::rc::Rc;

/// How far the data of a linear solution may be from it, over the size of fractions.
const LINEAR: f64 = 1e-9;
/// Smallest pivot of the equations for a linear solution, over the greatest.
const SINGULAR: f64 = 1e-12;
/// How far a point may lie beyond the body for rounding's sake, over its size.
const BEYOND: f64 = 1e-12;

/// A solution that is known at every point.
#[derive(Debug, Clone, PartialEq)]
pub enum Exact {
    /// For each material a linear function: what belongs to 1, x, y and z.
    Linear(Vec<[f64; 4]>),
    /// Fractions on the lower and the upper end of each axis of the unit square or cube.
    Faces {
        /// Which of both it is.
        space: Space,
        /// Fractions of the materials on each.
        data: [[Vec<f64>; 2]; 3],
    },
    /// For each material A + B/r between spheres or A + B ln r between circles.
    Radial {
        /// Which of both it is.
        space: Space,
        /// Inner and outer radius.
        radii: [f64; 2],
        /// For each material A and B.
        terms: Vec<[f64; 2]>,
    },
}

impl Exact {
    /// The solution of a boundary whose elements all have conditions, where it is known. `at` gives the numbers of the condition of an element at a point.
    pub(super) fn of(
        boundary: &BoundaryProblem,
        panels: &[Panel],
        at: impl Fn(usize, DVec3) -> Option<Vec<f64>>,
    ) -> Option<Self> {
        linear(boundary, panels, at).or_else(|| match boundary.document.model {
            BoundaryModel::Cube { .. } | BoundaryModel::SliverCube { .. } | BoundaryModel::Square { .. } => {
                of_faces(boundary, panels)
            }
            BoundaryModel::Shell { inner, outer, .. } | BoundaryModel::Annulus { inner, outer, .. } => {
                radial(boundary, panels, [inner, outer])
            }
            _ => None,
        })
    }

    /// What it is called: `constant`, `linear`, `square`, `cube`, `annulus` or `shell`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Linear(terms) if terms.iter().all(|[_, slope @ ..]| slope.iter().all(|x| *x == 0.0)) => {
                "constant"
            }
            Self::Linear(_) => "linear",
            Self::Faces { space: Space::Plane, .. } => "square",
            Self::Faces { space: Space::Solid, .. } => "cube",
            Self::Radial { space: Space::Plane, .. } => "annulus",
            Self::Radial { space: Space::Solid, .. } => "shell",
        }
    }

    /// The fraction of each material at a point; `None` outside of a cube, a square, a shell or an annulus. Linear functions go on everywhere.
    #[must_use]
    pub fn at(&self, point: DVec3) -> Option<Vec<f64>> {
        match self {
            Self::Linear(terms) => {
                let value = |[a, x, y, z]: &[f64; 4]| a + x * point.x + y * point.y + z * point.z;
                Some(terms.iter().map(value).collect())
            }
            Self::Faces { space, data } => {
                let dimension = space.dimension();
                let inside = |x: &f64| (-BEYOND..=1.0 + BEYOND).contains(x);
                if !point.to_array()[..dimension].iter().all(inside) {
                    return None;
                }
                let shares = faces::leaving(point.clamp(DVec3::ZERO, DVec3::ONE), dimension);
                let mut values = vec![0.0; data[0][0].len()];
                for (share, data) in shares[..dimension].iter().flatten().zip(data.iter().flatten()) {
                    values.iter_mut().zip(data).for_each(|(value, datum)| *value += share * datum);
                }
                Some(values)
            }
            Self::Radial { space, radii: [inner, outer], terms } => {
                let r = point.length();
                let is_inside = r >= inner * (1.0 - BEYOND) && r <= outer * (1.0 + BEYOND);
                let f = if *space == Space::Plane { r.ln() } else { 1.0 / r };
                is_inside.then(|| terms.iter().map(|[a, b]| a + b * f).collect())
            }
        }
    }
}

/// The linear solution, if all data are those of one, at the corners of elements too.
fn linear(
    boundary: &BoundaryProblem,
    panels: &[Panel],
    at: impl Fn(usize, DVec3) -> Option<Vec<f64>>,
) -> Option<Exact> {
    let materials = boundary.document.materials.len();
    let condition = |element: usize| &boundary.conditions[boundary.groups[element] as usize];
    if !(0..panels.len()).any(|element| condition(element).is_value) {
        return None;
    }
    let corners = || panels.iter().flat_map(|panel| panel.corners);
    let (low, high) =
        corners().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(a, b), p| (a.min(p), b.max(p)));
    let (centre, size) = ((low + high) / 2.0, (high - low).length());
    // What belongs to the four unknowns: coordinates about the centre over the size of the body, so that fluxes count by that size.
    let row = |is_value: bool, point: DVec3, normal: DVec3| {
        let v = if is_value { (point - centre) / size } else { normal };
        [if is_value { 1.0 } else { 0.0 }, v.x, v.y, v.z]
    };
    let scaled = |is_value: bool, datum: f64| if is_value { datum } else { datum * size };
    let mut equations = Equations::new(materials);
    for (element, panel) in panels.iter().enumerate() {
        let condition = condition(element);
        let data = condition.data.iter().map(|datum| scaled(condition.is_value, *datum));
        equations.add(row(condition.is_value, panel.centre, panel.normal), data);
    }
    if boundary.space == Space::Plane {
        equations.add([0.0, 0.0, 0.0, 1.0], std::iter::repeat_n(0.0, materials));
    }
    let terms = equations.solve()?;
    for (element, panel) in panels.iter().enumerate() {
        let is_value = condition(element).is_value;
        for corner in panel.corners {
            let row = row(is_value, corner, panel.normal);
            for (term, datum) in terms.iter().zip(at(element, corner)?) {
                let value: f64 = term.iter().zip(row).map(|(x, part)| x * part).sum();
                let datum = scaled(is_value, datum);
                // A number that is none differs as well.
                if !((value - datum).abs() <= LINEAR * (1.0 + datum.abs())) {
                    return None;
                }
            }
        }
    }
    let term = |[a, slope @ ..]: [f64; 4]| {
        // What rounding left of a slope is none.
        let [x, y, z] = slope.map(|part| if part.abs() < LINEAR { 0.0 } else { part / size });
        [a - DVec3::new(x, y, z).dot(centre), x, y, z]
    };
    Some(Exact::Linear(terms.into_iter().map(term).collect()))
}

/// Normal equations for four unknowns of several materials.
struct Equations {
    matrix: [[f64; 4]; 4],
    sides: Vec<[f64; 4]>,
}

impl Equations {
    fn new(materials: usize) -> Self {
        Self { matrix: [[0.0; 4]; 4], sides: vec![[0.0; 4]; materials] }
    }

    fn add(&mut self, row: [f64; 4], data: impl Iterator<Item = f64>) {
        for (i, a) in row.iter().enumerate() {
            for (j, b) in row.iter().enumerate() {
                self.matrix[i][j] += a * b;
            }
        }
        for (side, datum) in self.sides.iter_mut().zip(data) {
            for (sum, a) in side.iter_mut().zip(row) {
                *sum += a * datum;
            }
        }
    }

    /// By Gauss' elimination; `None` where they determine nothing.
    fn solve(mut self) -> Option<Vec<[f64; 4]>> {
        let greatest = self.matrix.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        for k in 0..4 {
            let pivot =
                (k..4).max_by(|a, b| self.matrix[*a][k].abs().total_cmp(&self.matrix[*b][k].abs()))?;
            self.matrix.swap(k, pivot);
            self.sides.iter_mut().for_each(|side| side.swap(k, pivot));
            let upper = self.matrix[k];
            // A number that is none is refused as well.
            if !(upper[k].abs() > SINGULAR * greatest) {
                return None;
            }
            for i in k + 1..4 {
                let factor = self.matrix[i][k] / upper[k];
                self.matrix[i].iter_mut().zip(upper).for_each(|(x, above)| *x -= factor * above);
                self.sides.iter_mut().for_each(|side| side[i] -= factor * side[k]);
            }
        }
        for side in &mut self.sides {
            for k in (0..4).rev() {
                let known: f64 = (k + 1..4).map(|j| self.matrix[k][j] * side[j]).sum();
                side[k] = (side[k] - known) / self.matrix[k][k];
            }
        }
        Some(self.sides)
    }
}

/// The solution for values that are constant on each face of the unit square or cube.
fn of_faces(boundary: &BoundaryProblem, panels: &[Panel]) -> Option<Exact> {
    let mut data: [[Vec<f64>; 2]; 3] = Default::default();
    for (panel, group) in panels.iter().zip(&boundary.groups) {
        let condition = &boundary.conditions[*group as usize];
        let axis = panel.normal.abs().max_position();
        let face = &mut data[axis][usize::from(panel.normal[axis] > 0.0)];
        if face.is_empty() {
            face.clone_from(&condition.data);
        }
        if !condition.is_value || *face != condition.data {
            return None;
        }
    }
    Some(Exact::Faces { space: boundary.space, data })
}

/// The solution for a constant on each of two concentric circles or spheres.
fn radial(boundary: &BoundaryProblem, panels: &[Panel], radii: [f64; 2]) -> Option<Exact> {
    let mut sides: [Option<(bool, &Vec<f64>)>; 2] = [None; 2];
    for (panel, group) in panels.iter().zip(&boundary.groups) {
        let condition = &boundary.conditions[*group as usize];
        let own = (condition.is_value, &condition.data);
        let side = &mut sides[usize::from(panel.normal.dot(panel.centre) > 0.0)];
        if *side.get_or_insert(own) != own {
            return None;
        }
    }
    let [Some(inner), Some(outer)] = sides else { return None };
    let is_plane = boundary.space == Space::Plane;
    // The equation of a side: what belongs to A and to B. Normals point inwards on the inner one.
    let row = |side: usize, is_value: bool| {
        let r = radii[side];
        let sign = if side == 0 { -1.0 } else { 1.0 };
        match (is_value, is_plane) {
            (true, true) => [1.0, r.ln()],
            (true, false) => [1.0, 1.0 / r],
            (false, true) => [0.0, sign / r],
            (false, false) => [0.0, -sign / (r * r)],
        }
    };
    let [[a, b], [c, d]] = [row(0, inner.0), row(1, outer.0)];
    let determinant = a * d - b * c;
    let terms: Vec<[f64; 2]> = inner
        .1
        .iter()
        .zip(outer.1)
        .map(|(p, q)| [(p * d - b * q) / determinant, (a * q - p * c) / determinant])
        .collect();
    let is_known = terms.iter().flatten().all(|x| x.is_finite());
    is_known.then_some(Exact::Radial { space: boundary.space, radii, terms })
}

/// A known solution at points, in steps.
#[derive(Debug)]
pub struct ExactJob {
    boundary: Rc<BoundaryProblem>,
    points: Vec<DVec3>,
    numbers: Vec<f64>,
    done: usize,
}

impl ExactJob {
    /// A question about points.
    ///
    /// # Errors
    /// When there are more than [`MOST_POINTS`] points, or one is not finite.
    pub fn new(boundary: Rc<BoundaryProblem>, points: Vec<DVec3>) -> Result<Self, LaplaceError> {
        if points.len() > MOST_POINTS {
            let message = format!("{} points were found; expected {MOST_POINTS} at most", points.len());
            return Err(LaplaceError::new(Fault::Points, message));
        }
        if let Some(wrong) = points.iter().position(|point| !point.is_finite()) {
            let message = "a coordinate that is not finite was found; expected finite ones";
            return Err(LaplaceError::new(Fault::Points, message).of(wrong));
        }
        Ok(Self { boundary, points, numbers: Vec::new(), done: 0 })
    }

    /// Goes on while it may, at least by a point; `true` once all points have their fractions.
    ///
    /// # Errors
    /// When a point lies outside of a body whose solution ends there.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Result<bool, LaplaceError> {
        let Some(exact) = &self.boundary.exact else { return Ok(true) };
        while let Some(point) = self.points.get(self.done) {
            let Some(fractions) = exact.at(*point) else {
                let message = "the point lies outside of the body; expected points inside or on its boundary";
                return Err(LaplaceError::new(Fault::Outside, message).of(self.done).at(*point));
            };
            self.numbers.extend(fractions);
            self.done += 1;
            if !may_go_on() {
                break;
            }
        }
        Ok(self.done == self.points.len())
    }

    /// Share of the points that are done.
    #[must_use]
    pub fn progress(&self) -> f64 {
        if self.points.is_empty() { 1.0 } else { self.done as f64 / self.points.len() as f64 }
    }

    /// For each point a fraction of each material.
    #[must_use]
    pub fn numbers(self) -> Vec<f64> {
        self.numbers
    }
}
