//! Sections of a body by a plane, found in the parameters of its cells.

use super::Net;
use super::bernstein::{contract, cubic};
use super::composite::{Body, CellId};
use glam::DVec3;
use std::error::Error;
use std::fmt;
use std::ops::{Deref, Range};

/// Largest number of lattice steps along an axis of a cell.
pub const FINEST_SECTION: usize = 64;

/// Distance from the plane, over the size of the cell and its largest coordinate, that counts as none.
const ON_PLANE: f64 = 1e-13;

/// Most steps towards the plane along an edge of the lattice; three are typical.
const MOST_STEPS: usize = 30;

/// No vertex on an edge of the lattice yet.
const NONE: u32 = u32::MAX;

/// A plane: the points whose product with the normal is the offset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    normal: DVec3,
    offset: f64,
}

/// Why there is no section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SectionError {
    /// The normal has no direction, or a number is not finite.
    Plane {
        /// The normal as given.
        normal: DVec3,
        /// The offset as given.
        offset: f64,
    },
    /// The number of lattice steps is out of range.
    Steps {
        /// The number as given.
        steps: usize,
    },
}

impl fmt::Display for SectionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Plane { normal, offset } => write!(
                f,
                "the plane has the normal ({}, {}, {}) and the offset {offset}; expected finite numbers and a direction",
                normal.x, normal.y, normal.z
            ),
            Self::Steps { steps } => write!(f, "{steps} steps along a cell; expected 1 to {FINEST_SECTION}"),
        }
    }
}

impl Error for SectionError {}

impl Plane {
    /// The plane of all points whose product with `normal`, which may have any length, is `offset`.
    ///
    /// # Errors
    /// When the normal has no direction, or a number is not finite.
    pub fn new(normal: DVec3, offset: f64) -> Result<Self, SectionError> {
        let length = normal.length();
        match normal.try_normalize() {
            Some(unit) if (offset / length).is_finite() => Ok(Self { normal: unit, offset: offset / length }),
            _ => Err(SectionError::Plane { normal, offset }),
        }
    }

    /// The plane through a point.
    ///
    /// # Errors
    /// As [`Plane::new`].
    pub fn through(point: DVec3, normal: DVec3) -> Result<Self, SectionError> {
        Self::new(normal, normal.dot(point))
    }

    /// Unit normal.
    #[must_use]
    pub fn normal(&self) -> DVec3 {
        self.normal
    }

    /// Distance of a point, positive on the side of the normal.
    #[must_use]
    pub fn distance(&self, point: DVec3) -> f64 {
        self.normal.dot(point) - self.offset
    }
}

/// What a plane cuts out of a body: triangles in the plane, counter-clockwise against its normal, and where cells end.
///
/// Vertices are not shared between cells. Each has its parameters, so that material there is exact, and lies on the
/// plane up to rounding.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Section {
    /// Points.
    pub positions: Vec<DVec3>,
    /// Parameters of each point in its cell.
    pub parameters: Vec<DVec3>,
    /// Three indices of points each.
    pub triangles: Vec<[u32; 3]>,
    /// Pieces of the outlines of cells: two indices of points each.
    pub outlines: Vec<[u32; 2]>,
    /// The cells that are cut, by identifier, with their triangles and their pieces of outline.
    pub cells: Vec<Cut>,
}

/// The part of a section that belongs to one cell.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cut {
    /// The cell.
    pub cell: CellId,
    /// Its points.
    pub positions: Range<usize>,
    /// Its triangles.
    pub triangles: Range<usize>,
    /// Its pieces of outline.
    pub outlines: Range<usize>,
}

impl Section {
    /// Area of all triangles.
    #[must_use]
    pub fn area(&self) -> f64 {
        let point = |n: u32| self.positions[n as usize];
        let area = |[a, b, c]: &[u32; 3]| (point(*b) - point(*a)).cross(point(*c) - point(*a)).length() / 2.0;
        self.triangles.iter().map(area).sum()
    }
}

/// The job that cuts a body, cell by cell.
///
/// The distance of a cell from the plane is a tricubic polynomial of one component. It is evaluated on a lattice of
/// the parameters; every cube of the lattice is divided into six tetrahedra, whose edges are cut where the polynomial
/// is zero. Pieces of the section that no edge of the lattice runs through are missed.
///
/// `B` is a reference to a body, or shared ownership of one.
#[derive(Debug)]
pub struct Sectioning<B> {
    body: B,
    plane: Plane,
    lattice: Lattice,
    next: usize,
    section: Section,
}

impl<B: Deref<Target = Body>> Sectioning<B> {
    /// The job with a number of lattice steps along each axis of a cell, 1 to [`FINEST_SECTION`].
    ///
    /// # Errors
    /// When the number of steps is out of range.
    pub fn new(body: B, plane: Plane, steps: usize) -> Result<Self, SectionError> {
        if !(1..=FINEST_SECTION).contains(&steps) {
            return Err(SectionError::Steps { steps });
        }
        Ok(Self { body, plane, lattice: Lattice::new(steps), next: 0, section: Section::default() })
    }

    /// Advances while `may_go_on` says so, by one cell at least. Returns the section when it is whole.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Section> {
        while let Some((id, cell)) = self.body.cells().get(self.next) {
            self.lattice.cut(*id, cell.net(), self.plane, &mut self.section);
            self.next += 1;
            if !may_go_on() {
                break;
            }
        }
        (self.next >= self.body.cells().len()).then(|| std::mem::take(&mut self.section))
    }
}

/// The section of a body by a plane, with a number of lattice steps along each axis of a cell, 1 to [`FINEST_SECTION`].
///
/// # Errors
/// When the number of steps is out of range.
pub fn section(body: &Body, plane: Plane, steps: usize) -> Result<Section, SectionError> {
    let mut job = Sectioning::new(body, plane, steps)?;
    loop {
        if let Some(section) = job.step(&mut || true) {
            return Ok(section);
        }
    }
}

/// Distances from the plane on a lattice, with the vertices that edges of the lattice have got. Used again from cell
/// to cell.
#[derive(Debug)]
struct Lattice {
    steps: usize,
    weights: Vec<[f64; 4]>,
    values: Vec<f64>,
    /// The vertex of each edge of the lattice: seven edges go out from each node, towards higher indices.
    vertices: Vec<u32>,
}

/// Corners of the six tetrahedra of a cube: each goes from the corner 0 to the corner 7 along one axis after the
/// other. Bits of a corner are steps along w (1), v (2) and u (4).
const TETRAHEDRA: [[usize; 4]; 6] =
    [[0, 4, 6, 7], [0, 4, 5, 7], [0, 2, 6, 7], [0, 2, 3, 7], [0, 1, 5, 7], [0, 1, 3, 7]];

/// A cell that is being cut.
struct Cutting<'a> {
    net: &'a Net,
    distances: [f64; 64],
    plane: Plane,
    /// Distance that counts as none.
    noise: f64,
}

impl Lattice {
    fn new(steps: usize) -> Self {
        let count = (steps + 1).pow(3);
        let weights = (0..=steps).map(|n| cubic(n as f64 / steps as f64)).collect();
        Self { steps, weights, values: vec![0.0; count], vertices: vec![NONE; 7 * count] }
    }

    /// Adds what the plane cuts out of a cell.
    fn cut(&mut self, id: CellId, net: &Net, plane: Plane, section: &mut Section) {
        let distances = net.0.map(|point| plane.distance(point));
        let (lo, hi) = net.bounds();
        let noise = ON_PLANE * (lo.abs().max(hi.abs()).max_element() + plane.offset.abs());
        let is_above = distances.iter().all(|d| *d >= -noise);
        if is_above || distances.iter().all(|d| *d < -noise) {
            return;
        }
        let cutting = Cutting { net, distances, plane, noise };
        let start = [section.positions.len(), section.triangles.len(), section.outlines.len()];
        self.evaluate(&cutting);
        self.vertices.fill(NONE);
        let size = self.steps;
        for n in 0..size.pow(3) {
            let node = [n / (size * size), n / size % size, n % size];
            let corners: [usize; 8] = std::array::from_fn(|corner| self.place(step_from(node, corner)));
            let below = corners.map(|at| self.values[at] < 0.0);
            if below.iter().all(|b| *b == below[0]) {
                continue;
            }
            for tetrahedron in TETRAHEDRA {
                self.cut_tetrahedron(node, tetrahedron, &below, &cutting, section);
            }
        }
        if section.triangles.len() > start[1] {
            section.cells.push(Cut {
                cell: id,
                positions: start[0]..section.positions.len(),
                triangles: start[1]..section.triangles.len(),
                outlines: start[2]..section.outlines.len(),
            });
        } else {
            // The plane only touches the cell: its points belong to no triangle.
            section.positions.truncate(start[0]);
            section.parameters.truncate(start[0]);
            section.outlines.truncate(start[2]);
        }
    }

    fn place(&self, [i, j, k]: [usize; 3]) -> usize {
        (i * (self.steps + 1) + j) * (self.steps + 1) + k
    }

    fn evaluate(&mut self, cutting: &Cutting) {
        let net = &cutting.distances;
        let mut values = self.values.iter_mut();
        for u in &self.weights {
            let layer: [f64; 16] = std::array::from_fn(|n| {
                net[n] * u[0] + net[n + 16] * u[1] + net[n + 32] * u[2] + net[n + 48] * u[3]
            });
            for v in &self.weights {
                let line: [f64; 4] = std::array::from_fn(|n| {
                    layer[n] * v[0] + layer[n + 4] * v[1] + layer[n + 8] * v[2] + layer[n + 12] * v[3]
                });
                for (w, value) in self.weights.iter().zip(&mut values) {
                    let distance = line[0] * w[0] + line[1] * w[1] + line[2] * w[2] + line[3] * w[3];
                    *value = if distance.abs() <= cutting.noise { 0.0 } else { distance };
                }
            }
        }
    }

    /// Adds the triangle or the two triangles of a tetrahedron.
    fn cut_tetrahedron(
        &mut self,
        node: [usize; 3],
        tetrahedron: [usize; 4],
        below: &[bool; 8],
        cutting: &Cutting,
        section: &mut Section,
    ) {
        let (mut low, mut high) = ([0; 4], [0; 4]);
        let (mut lows, mut highs) = (0, 0);
        for corner in tetrahedron {
            if below[corner] {
                low[lows] = corner;
                lows += 1;
            } else {
                high[highs] = corner;
                highs += 1;
            }
        }
        let mut vertex = |a: usize, b: usize| self.vertex(node, a, b, cutting, section);
        match (lows, highs) {
            (1, 3) => {
                let corners = [vertex(low[0], high[0]), vertex(low[0], high[1]), vertex(low[0], high[2])];
                self.add(&corners, cutting.plane, section);
            }
            (3, 1) => {
                let corners = [vertex(low[0], high[0]), vertex(low[1], high[0]), vertex(low[2], high[0])];
                self.add(&corners, cutting.plane, section);
            }
            (2, 2) => {
                let corners = [(0, 0), (0, 1), (1, 1), (1, 0)].map(|(a, b)| vertex(low[a], high[b]));
                self.add(&corners, cutting.plane, section);
            }
            _ => {}
        }
    }

    /// Adds a polygon as a fan, and those of its sides that lie on faces of the cell.
    fn add(&self, corners: &[u32], plane: Plane, section: &mut Section) {
        let point = |n: u32| section.positions[n as usize];
        let mut triangles = Vec::with_capacity(2);
        for n in 1..corners.len() - 1 {
            let [a, b, c] = [corners[0], corners[n], corners[n + 1]];
            let turn = (point(b) - point(a)).cross(point(c) - point(a)).dot(plane.normal);
            match turn {
                turn if turn > 0.0 => triangles.push([a, b, c]),
                turn if turn < 0.0 => triangles.push([a, c, b]),
                _ => {}
            }
        }
        section.triangles.extend(triangles);
        for (n, &a) in corners.iter().enumerate() {
            let b = corners[(n + 1) % corners.len()];
            let (p, q) = (section.parameters[a as usize], section.parameters[b as usize]);
            let is_on_face = (0..3).any(|axis| p[axis] == q[axis] && (p[axis] == 0.0 || p[axis] == 1.0));
            if is_on_face && point_differs(section, a, b) {
                section.outlines.push([a, b]);
            }
        }
    }

    /// The vertex on the edge between two corners of a cube, made when it is asked for the first time.
    fn vertex(
        &mut self,
        node: [usize; 3],
        a: usize,
        b: usize,
        cutting: &Cutting,
        section: &mut Section,
    ) -> u32 {
        let (from, to) = (a.min(b), a.max(b));
        // On the way from 0 to 7 bits are only added, so the difference is a direction.
        let key = self.place(step_from(node, from)) * 7 + (to - from) - 1;
        if self.vertices[key] == NONE {
            let [start, end] = [from, to].map(|corner| step_from(node, corner));
            let values = [start, end].map(|node| self.values[self.place(node)]);
            let [start, end] =
                [start, end].map(|node| DVec3::from_array(node.map(|n| n as f64 / self.steps as f64)));
            let at = cutting.zero(start, end, values);
            self.vertices[key] = section.positions.len() as u32;
            section.positions.push(cutting.net.point(at));
            section.parameters.push(at);
        }
        self.vertices[key]
    }
}

impl Cutting<'_> {
    /// Where the distance is zero between two parameters at which it has different signs: the secant rule, in which
    /// an end that stays twice counts by half, so that both ends come near.
    fn zero(&self, start: DVec3, end: DVec3, values: [f64; 2]) -> DVec3 {
        let (mut lo, mut hi) = ((0.0, values[0]), (1.0, values[1]));
        if lo.1 == 0.0 {
            return start;
        }
        if hi.1 == 0.0 {
            return end;
        }
        let (mut t, mut stayed) = (0.5, 0);
        for _ in 0..MOST_STEPS {
            t = (lo.0 * hi.1 - hi.0 * lo.1) / (hi.1 - lo.1);
            let at = start + (end - start) * t;
            let value = contract(&self.distances, &at.to_array().map(cubic));
            if value.abs() <= self.noise {
                break;
            }
            if (value < 0.0) == (lo.1 < 0.0) {
                lo = (t, value);
                hi.1 = if stayed == 1 { hi.1 / 2.0 } else { hi.1 };
                stayed = 1;
            } else {
                hi = (t, value);
                lo.1 = if stayed == -1 { lo.1 / 2.0 } else { lo.1 };
                stayed = -1;
            }
        }
        start + (end - start) * t
    }
}

/// A node of the lattice, a step on for each bit of a corner.
fn step_from([i, j, k]: [usize; 3], corner: usize) -> [usize; 3] {
    [i + (corner >> 2 & 1), j + (corner >> 1 & 1), k + (corner & 1)]
}

/// Whether two points of a section are different ones.
fn point_differs(section: &Section, a: u32, b: u32) -> bool {
    section.positions[a as usize] != section.positions[b as usize]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::GaussLegendre;
    use crate::hyperpatch::Cell;
    use crate::hyperpatch::test_cells::{random_net, random_place, ring_cell};
    use crate::material::Composition;

    fn body(nets: impl IntoIterator<Item = Net>) -> Body {
        let mut body = Body::new(1);
        for net in nets {
            body.add(Cell::uniform(net, &Composition::pure(0, 1)).unwrap()).unwrap();
        }
        body
    }

    fn cut(body: &Body, normal: DVec3, offset: f64, steps: usize) -> Section {
        section(body, Plane::new(normal, offset).unwrap(), steps).unwrap()
    }

    #[test]
    fn sections_of_a_box_have_their_areas() {
        let body = body([Net::cuboid(DVec3::ZERO, DVec3::new(1.0, 2.0, 3.0))]);
        for steps in [1, 5] {
            assert!((cut(&body, DVec3::Z, 1.1, steps).area() - 2.0).abs() < 1e-12);
            // Through the diagonal of the floor, upright.
            let diagonal = cut(&body, DVec3::new(2.0, -1.0, 0.0), 0.0, steps);
            assert!((diagonal.area() - 3.0 * 5.0_f64.sqrt()).abs() < 1e-12, "{}", diagonal.area());
            let hexagon = cut(&body.clone(), DVec3::new(1.0, 0.5, 1.0 / 3.0), 1.5, steps);
            // Half of the box scaled to a cube has a regular hexagon of area 3 sqrt(3) / 4; the map turns the normal.
            let scale = 6.0 * DVec3::new(1.0, 0.5, 1.0 / 3.0).length() / 3.0_f64.sqrt();
            assert!((hexagon.area() - 0.75 * 3.0_f64.sqrt() * scale).abs() < 1e-12, "{}", hexagon.area());
            assert!(cut(&body, DVec3::Z, 3.1, steps).triangles.is_empty());
        }
    }

    /// A plane that two cells share cuts one of them, over the whole face.
    #[test]
    fn a_plane_on_shared_faces_is_covered_once() {
        let cube = |x: f64| Net::cuboid(DVec3::new(x, 0.0, 0.0), DVec3::new(x + 1.0, 1.0, 1.0));
        let body = body([cube(0.0), cube(1.0)]);
        for offset in [1.0, 1.0 + 1e-15, 1.0 - 1e-15] {
            assert!((cut(&body, DVec3::X, offset, 4).area() - 1.0).abs() < 1e-12, "offset {offset}");
        }
    }

    /// A cell that the plane only touches leaves no points, so that every point belongs to the cut of a cell.
    #[test]
    fn every_point_belongs_to_a_cell() {
        let cube = |n: usize| {
            let min = DVec3::new((n / 4) as f64, (n / 2 % 2) as f64, (n % 2) as f64);
            Net::cuboid(min, min + 1.0)
        };
        let body = body((0..8).map(cube));
        for (normal, offset) in [(DVec3::ONE, 3.0), (DVec3::ONE, 2.0), (DVec3::new(1.0, 1.0, 0.0), 2.0)] {
            let found = cut(&body, normal, offset, 8);
            let mut next = 0;
            for cut in &found.cells {
                assert_eq!(cut.positions.start, next);
                next = cut.positions.end;
            }
            assert_eq!((next, next), (found.positions.len(), found.parameters.len()), "{normal} {offset}");
        }
    }

    /// Points lie on the plane and are those of their parameters; triangles turn against the normal.
    #[test]
    fn vertices_are_exact() {
        let body = body([random_net(1, 0.2)]);
        for seed in 0..20 {
            let normal = random_place(seed) - 0.5;
            let plane = Plane::through(DVec3::splat(0.5), normal).unwrap();
            let found = section(&body, plane, 8).unwrap();
            assert!(!found.triangles.is_empty());
            for (position, at) in found.positions.iter().zip(&found.parameters) {
                assert!(plane.distance(*position).abs() < 1e-12);
                assert_eq!(body.cells()[0].1.point(*at), *position);
            }
            for [a, b, c] in found.triangles.iter().map(|t| t.map(|n| found.positions[n as usize])) {
                assert!((b - a).cross(c - a).dot(plane.normal()) > 0.0);
            }
            // The outline closes: every point of it ends as many pieces as it begins.
            let mut ends = std::collections::HashMap::new();
            for end in found.outlines.iter().flatten() {
                *ends.entry(found.positions[*end as usize].to_array().map(f64::to_bits)).or_insert(0) += 1;
            }
            assert!(ends.values().all(|count| count % 2 == 0));
        }
    }

    /// Areas of a ring against pi (R^2 - r^2) and a chord section against its rectangle, converging with the square
    /// of the steps.
    #[test]
    fn sections_of_a_ring_converge() {
        let body = body((0..12).map(|n| ring_cell(12, n, 1.0, 2.0, 1.0)));
        let exact = 3.0 * std::f64::consts::PI;
        let error = |steps: usize| (cut(&body, DVec3::Z, 0.5, steps).area() - exact).abs();
        let (coarse, fine) = (error(4), error(8));
        assert!(coarse < 3e-2 && (3.5..4.5).contains(&(coarse / fine)), "{coarse} {fine}");
        let upright = cut(&body, DVec3::X, 0.0, 8);
        assert!((upright.area() - 2.0).abs() < 1e-5, "{}", upright.area());
        assert!(upright.cells.iter().all(|cut| [2, 3, 8, 9].contains(&cut.cell.0)));
    }

    /// Areas of parallel sections integrate to the volume.
    #[test]
    fn areas_integrate_to_the_volume() {
        let body = body((0..8).map(|n| ring_cell(8, n, 1.0, 2.0, 1.0)));
        let normal = DVec3::new(0.3, -0.2, 1.0).normalize();
        let (lo, hi) = (-2.0, 2.0);
        let rule = GaussLegendre::new(16);
        let integral: f64 = (0..8)
            .map(|n| {
                let [a, b] = [n, n + 1].map(|n| lo + (hi - lo) * f64::from(n) / 8.0);
                rule.integrate(a, b, |offset| cut(&body, normal, offset, 10).area())
            })
            .sum();
        assert!((integral / body.volume() - 1.0).abs() < 3e-3, "{integral}, volume {}", body.volume());
    }

    #[test]
    fn wrong_planes_and_steps_are_refused() {
        for (normal, offset) in [(DVec3::ZERO, 0.0), (DVec3::NAN, 0.0), (DVec3::X, f64::INFINITY)] {
            assert!(matches!(Plane::new(normal, offset), Err(SectionError::Plane { .. })));
        }
        let plane = Plane::new(DVec3::X, 0.0).unwrap();
        for steps in [0, FINEST_SECTION + 1] {
            assert_eq!(section(&Body::new(1), plane, steps), Err(SectionError::Steps { steps }));
        }
        assert_eq!(section(&Body::new(1), plane, 4), Ok(Section::default()));
        let mut job =
            Sectioning::new(&Body::new(1), plane, 4).map(|mut job| job.step(&mut || false).is_some());
        assert_eq!(job.as_mut().copied(), Ok(true));
    }
}
