//! The solution on triangles that are fine where it bends.
//!
//! A tree of squares covers the rings. A square is cut in four while it is large beside its distance from the boundary, or while some quantity in it
//! is not linear enough; its nine places, corners, middles of sides and centre, become vertices, together with those of the rings. The constrained Delaunay
//! triangulation joins them.

use super::Rings;
use crate::geom::Bounds;
use glam::DVec2;
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};
use std::collections::HashMap;
use std::rc::Rc;

/// Places of the finest squares along a side of the box.
const LATTICE: u32 = 1 << 18;
/// Side of the squares at the start, in places.
const START: u32 = LATTICE / 4;
/// Most vertices inside.
const MOST_INSIDE: usize = 12_000;
/// Side of a square on the boundary over the length of the segments there, and of others over their distance from it.
const BESIDE: f64 = 2.5;
const AWAY: f64 = 2.0;
/// Distance from the boundary below which there are no vertices inside, over the length of the segments there.
const CLEAR: f64 = 0.35;

/// Quantities at vertices, linear on triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Vertices: those of the rings, then those inside.
    pub points: Vec<DVec2>,
    /// Numbers at each vertex, one vertex after the other.
    pub values: Vec<f64>,
    /// Numbers of a vertex.
    pub width: usize,
    /// Counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
}

impl Field {
    /// One quantity at a vertex.
    #[must_use]
    pub fn value(&self, vertex: u32, quantity: usize) -> f64 {
        self.values[vertex as usize * self.width + quantity]
    }

    /// The numbers of a vertex.
    #[must_use]
    pub fn at(&self, vertex: usize) -> &[f64] {
        &self.values[vertex * self.width..(vertex + 1) * self.width]
    }
}

/// A square, and the segments that may be nearest to a place in it.
#[derive(Debug)]
struct Square {
    corner: [u32; 2],
    side: u32,
    near: Rc<Vec<u32>>,
}

/// A field being made.
#[derive(Debug)]
pub(super) struct FieldWork {
    rings: Rings,
    ends: Vec<[DVec2; 2]>,
    origin: DVec2,
    /// Length from one place of the lattice to the next.
    step: f64,
    /// What may be between a quantity and a straight line through it.
    tolerance: f64,
    width: usize,
    open: Vec<Square>,
    /// Vertices inside by their place; those outside and beside the boundary have none.
    known: HashMap<[u32; 2], Option<u32>>,
    points: Vec<DVec2>,
    values: Vec<f64>,
    /// Squares looked at, of those that are known so far.
    done: usize,
}

impl FieldWork {
    /// Begins with values of `width` numbers at the vertices of the rings.
    pub(super) fn new(rings: &Rings, values: Vec<f64>, width: usize, tolerance: f64) -> Self {
        let points = rings.points();
        let bounds =
            Bounds::of(points.iter().copied()).unwrap_or(Bounds { min: DVec2::ZERO, max: DVec2::ONE });
        let side = (bounds.max - bounds.min).max_element() * 1.001;
        let place = |vertex: u32| points[vertex as usize];
        let ends: Vec<[DVec2; 2]> = rings.segments().iter().map(|ends| ends.map(place)).collect();
        let all: Rc<Vec<u32>> = Rc::new((0..ends.len() as u32).collect());
        let starts =
            (0..LATTICE / START).flat_map(|row| (0..LATTICE / START).map(move |column| [column, row]));
        Self {
            rings: rings.clone(),
            ends,
            origin: bounds.center() - DVec2::splat(side / 2.0),
            step: side / f64::from(LATTICE),
            tolerance,
            width,
            open: starts
                .map(|at| Square { corner: at.map(|k| k * START), side: START, near: Rc::clone(&all) })
                .collect(),
            known: HashMap::new(),
            points,
            values,
            done: 0,
        }
    }

    /// Share of the squares that are done.
    pub(super) fn progress(&self) -> f64 {
        self.done as f64 / (self.done + 2 * self.open.len()).max(1) as f64
    }

    /// Looks at squares while `may_go_on` says so, at least at one; returns whether all are done. `solve` gives the numbers at a place, none outside.
    pub(super) fn step(
        &mut self,
        solve: &dyn Fn(DVec2) -> Option<Vec<f64>>,
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> bool {
        while let Some(square) = self.open.pop() {
            self.look(&square, solve);
            self.done += 1;
            if !may_go_on() {
                break;
            }
        }
        self.open.is_empty()
    }

    fn place(&self, [column, row]: [u32; 2]) -> DVec2 {
        self.origin + self.step * DVec2::new(f64::from(column), f64::from(row))
    }

    fn look(&mut self, square: &Square, solve: &dyn Fn(DVec2) -> Option<Vec<f64>>) {
        let half = square.side / 2;
        let [column, row] = square.corner;
        let (side, centre) = (f64::from(square.side) * self.step, [column + half, row + half]);
        let middle = self.place(centre);
        let reach = side * std::f64::consts::FRAC_1_SQRT_2;
        let distances: Vec<f64> =
            square.near.iter().map(|&k| distance(self.ends[k as usize], middle)).collect();
        let nearest = distances.iter().copied().fold(f64::INFINITY, f64::min);
        // A segment that is nearest to some place of the square is not farther from its middle.
        let near: Rc<Vec<u32>> = Rc::new(
            square
                .near
                .iter()
                .zip(&distances)
                .filter(|(_, d)| **d <= nearest + 2.0 * reach)
                .map(|(k, _)| *k)
                .collect(),
        );
        let own = square.near.iter().zip(&distances).min_by(|a, b| a.1.total_cmp(b.1));
        let length = own.map_or(0.0, |(&k, _)| self.ends[k as usize][0].distance(self.ends[k as usize][1]));
        if nearest > reach && self.vertex(centre, &near, solve).is_none() {
            return;
        }
        let is_full = self.points.len() >= MOST_INSIDE + self.rings.count();
        let may_split = half >= 2 && !is_full;
        let is_large = side > (BESIDE * length).max(AWAY * nearest);
        if may_split && is_large {
            self.split(square, &near);
            return;
        }
        let at = |i: u32, j: u32| [column + i * half, row + j * half];
        let places: [Option<u32>; 9] =
            std::array::from_fn(|k| self.vertex(at(k as u32 % 3, k as u32 / 3), &near, solve));
        if may_split && side > 0.2 * length && self.is_bent(&places) {
            self.split(square, &near);
        }
    }

    fn split(&mut self, square: &Square, near: &Rc<Vec<u32>>) {
        let half = square.side / 2;
        for (i, j) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let corner = [square.corner[0] + i * half, square.corner[1] + j * half];
            self.open.push(Square { corner, side: half, near: Rc::clone(near) });
        }
    }

    /// Whether some quantity differs from a straight line by more than the tolerance after one more halving, which divides the difference by four.
    fn is_bent(&self, places: &[Option<u32>; 9]) -> bool {
        const LINES: [[usize; 3]; 8] =
            [[0, 1, 2], [3, 4, 5], [6, 7, 8], [0, 3, 6], [1, 4, 7], [2, 5, 8], [0, 4, 8], [2, 4, 6]];
        LINES.iter().any(|line| {
            let [Some(a), Some(b), Some(c)] = line.map(|k| places[k]) else { return false };
            let [a, b, c] = [a, b, c].map(|vertex| vertex as usize * self.width);
            (0..self.width).any(|q| {
                let bend = (self.values[a + q] + self.values[c + q]) / 2.0 - self.values[b + q];
                bend.abs() > 4.0 * self.tolerance
            })
        })
    }

    /// The vertex at a place of the lattice; `None` outside and close to the boundary.
    fn vertex(
        &mut self,
        at: [u32; 2],
        near: &[u32],
        solve: &dyn Fn(DVec2) -> Option<Vec<f64>>,
    ) -> Option<u32> {
        if let Some(known) = self.known.get(&at) {
            return *known;
        }
        let place = self.place(at);
        let is_clear = near.iter().all(|&k| {
            let ends = self.ends[k as usize];
            distance(ends, place) > CLEAR * ends[0].distance(ends[1])
        });
        let found = if is_clear { solve(place) } else { None };
        let vertex = found.map(|numbers| {
            self.points.push(place);
            self.values.extend(numbers);
            (self.points.len() - 1) as u32
        });
        self.known.insert(at, vertex);
        vertex
    }

    /// The field, once all squares are done.
    pub(super) fn finish(self) -> Field {
        let triangles = triangulate(&self.rings, &self.points, self.origin, self.step * f64::from(LATTICE));
        Field { points: self.points, values: self.values, width: self.width, triangles }
    }
}

/// The triangles inside the rings; none where the rings meet.
fn triangulate(rings: &Rings, points: &[DVec2], origin: DVec2, side: f64) -> Vec<[u32; 3]> {
    let unit = |point: &DVec2| {
        let scaled = ((*point - origin) / side).map(|x| if x.abs() < 1e-40 { 0.0 } else { x });
        Point2::new(scaled.x, scaled.y)
    };
    let segments = rings.segments();
    let edges = segments.iter().map(|ends| ends.map(|end| end as usize)).collect();
    let Ok(net) = ConstrainedDelaunayTriangulation::<Point2<f64>>::try_bulk_load_cdt(
        points.iter().map(unit).collect(),
        edges,
        |_| {},
    ) else {
        return Vec::new();
    };
    let forward: HashMap<usize, usize> = segments.iter().map(|&[a, b]| (a as usize, b as usize)).collect();
    let mut is_inside = vec![false; net.num_all_faces()];
    let mut open = Vec::new();
    for edge in net.directed_edges().filter(|edge| edge.is_constraint_edge()) {
        let [from, to] = edge.vertices().map(|vertex| vertex.index());
        if forward.get(&from) == Some(&to) {
            open.extend(edge.face().as_inner());
        }
    }
    let mut triangles = Vec::with_capacity(2 * points.len());
    while let Some(face) = open.pop() {
        if std::mem::replace(&mut is_inside[face.index()], true) {
            continue;
        }
        triangles.push(face.vertices().map(|vertex| vertex.index() as u32));
        for edge in face.adjacent_edges().into_iter().filter(|edge| !edge.is_constraint_edge()) {
            open.extend(edge.rev().face().as_inner());
        }
    }
    triangles
}

/// Distance of a point from a segment.
pub(super) fn distance([a, b]: [DVec2; 2], point: DVec2) -> f64 {
    let along = b - a;
    let t = ((point - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    (a + t * along).distance(point)
}
