//! Triangles of boundary faces within a chord tolerance, without cracks.

use super::composite::{Body, CellId, Sharing};
use super::{Edge, Face, Net};
use glam::DVec3;
use std::collections::HashMap;
use std::error::Error;
use std::fmt;
use std::ops::{Deref, Range};

/// Most segments along a side of a face; a power of two.
pub const MOST_SEGMENTS: usize = 64;

/// Triangles of some faces of the cells of a body.
///
/// Vertices are not shared between faces, but along a shared edge both faces have the same points, bit by bit, so
/// nothing shows between them. Each has its parameters, so that the material there is exact.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Surface {
    /// Points.
    pub positions: Vec<DVec3>,
    /// Unit normals; they point out of the cell, also of a mirrored one.
    pub normals: Vec<DVec3>,
    /// Parameters of each point in its cell.
    pub parameters: Vec<DVec3>,
    /// Three indices of points each, counter-clockwise from outside the cell.
    pub triangles: Vec<[u32; 3]>,
    /// The faces, in the order in which they were asked for.
    pub patches: Vec<Patch>,
    /// No point of a face is farther than this from the triangles, by proof. It is above the tolerance where
    /// [`MOST_SEGMENTS`] are not enough.
    pub deviation: f64,
}

/// The part of a surface that belongs to one face.
#[derive(Debug, Clone, PartialEq)]
pub struct Patch {
    /// The cell.
    pub cell: CellId,
    /// Its face.
    pub face: Face,
    /// Its points.
    pub positions: Range<usize>,
    /// Its triangles.
    pub triangles: Range<usize>,
    /// Segments along its four edges, in the order of [`Face::edges`].
    pub segments: [usize; 4],
    /// No point of the face is farther than this from its triangles.
    pub deviation: f64,
}

/// A tolerance that is no positive number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToleranceError {
    /// The tolerance as given.
    pub tolerance: f64,
}

impl fmt::Display for ToleranceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the chord tolerance is {}; expected a finite number above 0", self.tolerance)
    }
}

impl Error for ToleranceError {}

/// Numbers of the control points of an edge, in the direction that comes first.
type EdgeKey = [u32; 4];

/// The job that triangulates faces: first how fine each must be, then, with every edge as fine as the finest face on
/// it, the triangles.
///
/// `B` and `S` are references to a body and to what its cells share, or shared ownership of them.
#[derive(Debug)]
pub struct Tessellation<B, S> {
    body: B,
    sharing: S,
    faces: Vec<(CellId, Face)>,
    tolerance: f64,
    measured: usize,
    meshed: usize,
    /// Segments along both axes of each face, and the deviation with them.
    counts: Vec<([usize; 2], f64)>,
    /// Segments of each edge.
    edges: HashMap<EdgeKey, usize>,
    /// Points of each edge in the direction of its key, once one of its faces has been triangulated.
    points: HashMap<EdgeKey, Vec<DVec3>>,
    surface: Surface,
}

impl<B: Deref<Target = Body>, S: Deref<Target = Sharing>> Tessellation<B, S> {
    /// The job for some faces, such as [`Sharing::outer_faces`]. The chord tolerance is a length. Faces of cells that
    /// the body does not have are left out.
    ///
    /// # Errors
    /// When the tolerance is no positive number.
    pub fn new(
        body: B,
        sharing: S,
        faces: Vec<(CellId, Face)>,
        tolerance: f64,
    ) -> Result<Self, ToleranceError> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(ToleranceError { tolerance });
        }
        let is_there = |(id, _): &(CellId, Face)| body.cell(*id).is_some() && sharing.points(*id).is_some();
        let faces: Vec<_> = faces.into_iter().filter(is_there).collect();
        Ok(Self {
            body,
            sharing,
            counts: Vec::with_capacity(faces.len()),
            faces,
            tolerance,
            measured: 0,
            meshed: 0,
            edges: HashMap::new(),
            points: HashMap::new(),
            surface: Surface::default(),
        })
    }

    /// The job for some faces of a surface that was triangulated before, with as many segments along their edges as there were then: so
    /// that new vertices can take the places of the old ones, and edges fit those of faces that have not changed. `segments` has those
    /// of all faces of the surface, of which `chosen` are triangulated.
    ///
    /// Returns `None` when an edge would have two numbers of segments, because cells share others than they did.
    pub fn held(
        body: B,
        sharing: S,
        segments: &[(CellId, Face, [usize; 4])],
        chosen: Vec<usize>,
    ) -> Option<Self> {
        let mut edges = HashMap::new();
        for (id, face, counts) in segments {
            let numbers = sharing.points(*id)?;
            for (edge, count) in face.edges().into_iter().zip(counts) {
                if *edges.entry(key(numbers, edge).0).or_insert(*count) != *count {
                    return None;
                }
            }
        }
        let (mut faces, mut counts) = (Vec::new(), Vec::new());
        for (id, face, [a, b, c, d]) in chosen.into_iter().map(|n| segments[n]) {
            let count = [a.min(b), c.min(d)];
            faces.push((id, face));
            counts.push((count, deviation(bends(&body.cell(id)?.net().face(face)), count)));
        }
        let deviation = counts.iter().map(|(_, deviation)| *deviation).fold(0.0, f64::max);
        let measured = faces.len();
        let surface = Surface { deviation, ..Surface::default() };
        let mut job = Self::new(body, sharing, Vec::new(), 1.0).ok()?;
        job.faces = faces;
        Some(Self { counts, edges, measured, surface, ..job })
    }

    /// Advances while `may_go_on` says so, by one face at least. Returns the surface when it is whole.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Surface> {
        while self.meshed < self.faces.len() {
            let index = if self.measured < self.faces.len() { self.measured } else { self.meshed };
            let (id, face) = self.faces[index];
            if let (Some(cell), Some(numbers)) = (self.body.cell(id), self.sharing.points(id)) {
                let (net, numbers) = (cell.net().clone(), *numbers);
                if index == self.measured {
                    self.measure(&net, &numbers, face);
                } else {
                    self.mesh(id, &net, &numbers, face);
                }
            }
            if self.measured < self.faces.len() {
                self.measured += 1
            } else {
                self.meshed += 1
            }
            if !may_go_on() {
                break;
            }
        }
        (self.meshed >= self.faces.len()).then(|| std::mem::take(&mut self.surface))
    }

    /// Runs the job to its end.
    #[must_use]
    pub fn run(mut self) -> Surface {
        loop {
            if let Some(surface) = self.step(&mut || true) {
                return surface;
            }
        }
    }

    /// Finds how many segments a face needs along both axes, and asks for as many on its edges.
    fn measure(&mut self, net: &Net, numbers: &[u32; 64], face: Face) {
        let bends = bends(&net.face(face));
        let mut counts = [1, 1];
        while deviation(bends, counts) > self.tolerance {
            let [a, b] = counts.map(|count| 1.0 / count as f64);
            let (first, second, twist) = (bends[0] * a * a, bends[2] * b * b, bends[1] * a * b);
            let axis = match counts.map(|count| count < MOST_SEGMENTS) {
                [false, false] => break,
                [true, false] => 0,
                [false, true] => 1,
                // Twist is reduced by either axis, so it is spread over both.
                [true, true] if (first - second).abs() <= twist => usize::from(counts[1] < counts[0]),
                [true, true] => usize::from(second > first),
            };
            counts[axis] *= 2;
        }
        let deviation = deviation(bends, counts);
        self.surface.deviation = self.surface.deviation.max(deviation);
        for (n, edge) in face.edges().into_iter().enumerate() {
            let count = self.edges.entry(key(numbers, edge).0).or_insert(1);
            *count = (*count).max(counts[n / 2]);
        }
        self.counts.push((counts, deviation));
    }

    /// Adds the triangles of a face: those of a grid that is as fine as its finest edges. On a coarser edge, points
    /// of the grid move to the nearest point of the edge, along it, and triangles that lose their area are left out.
    fn mesh(&mut self, id: CellId, net: &Net, numbers: &[u32; 64], face: Face) {
        let (own, deviation) = self.counts[self.meshed];
        let edges = face.edges();
        let sides = edges.map(|edge| self.edges.get(&key(numbers, edge).0).copied().unwrap_or(1));
        let [m, n] = [own[0].max(sides[0]).max(sides[1]), own[1].max(sides[2]).max(sides[3])];
        let lines = edges.map(|edge| self.line(id, numbers, edge));

        let starts = (self.surface.positions.len(), self.surface.triangles.len());
        let is_outward = face.is_outward() == (net.jacobian(DVec3::splat(0.5)) >= 0.0);
        let mut vertices: HashMap<(usize, usize), u32> = HashMap::new();
        let mut places = Vec::with_capacity((m + 1) * (n + 1));
        for i in 0..=m {
            for k in 0..=n {
                // Where the point of the grid goes, and which line has its position.
                let (place, position) = if k == 0 || k == n {
                    let (line, count) = (&lines[usize::from(k == n)], sides[usize::from(k == n)]);
                    let at = nearest(i, m, count);
                    ((at * (m / count), k), Some(line[at]))
                } else if i == 0 || i == m {
                    let (line, count) = (&lines[2 + usize::from(i == m)], sides[2 + usize::from(i == m)]);
                    let at = nearest(k, n, count);
                    ((i, at * (n / count)), Some(line[at]))
                } else {
                    ((i, k), None)
                };
                let surface = &mut self.surface;
                places.push(*vertices.entry(place).or_insert_with(|| {
                    let at = face.parameters(place.0 as f64 / m as f64, place.1 as f64 / n as f64);
                    surface.positions.push(position.unwrap_or_else(|| net.point(at)));
                    surface.normals.push(normal(net, face, at, is_outward));
                    surface.parameters.push(at);
                    surface.positions.len() as u32 - 1
                }));
            }
        }
        for i in 0..m {
            for k in 0..n {
                let [a, b, c, d] =
                    [(i, k), (i + 1, k), (i + 1, k + 1), (i, k + 1)].map(|(i, k)| places[i * (n + 1) + k]);
                // Diagonals start at the nearest corner, so that points that moved along two sides do not turn a
                // triangle over.
                let is_rising = (2 * i < m) == (2 * k < n);
                let halves = if is_rising { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
                for [a, b, c] in halves {
                    if a != b && b != c && c != a {
                        self.surface.triangles.push(if is_outward { [a, b, c] } else { [a, c, b] });
                    }
                }
            }
        }
        self.surface.patches.push(Patch {
            cell: id,
            face,
            positions: starts.0..self.surface.positions.len(),
            triangles: starts.1..self.surface.triangles.len(),
            segments: sides,
            deviation,
        });
    }

    /// Points along an edge of a cell from its start, the same for every cell on it: they are those of the first cell that has it, with
    /// corners of the first cells that have these, so that they depend on nothing else.
    fn line(&mut self, id: CellId, numbers: &[u32; 64], edge: Edge) -> Vec<DVec3> {
        let (key, is_backwards) = key(numbers, edge);
        let count = self.edges.get(&key).copied().unwrap_or(1);
        let (body, sharing) = (&self.body, &self.sharing);
        let line = self.points.entry(key).or_insert_with(|| {
            let (first, at) = sharing.at_edge(id, edge).first().copied().unwrap_or((id, edge));
            let (Some(cell), Some(numbers)) = (body.cell(first), sharing.points(first)) else {
                return vec![DVec3::ZERO; count + 1];
            };
            let (_, is_backwards) = self::key(numbers, at);
            let place = |n: usize| if is_backwards { (count - n) as f64 } else { n as f64 };
            let mut line: Vec<DVec3> =
                (0..=count).map(|n| cell.point(at.parameters(place(n) / count as f64))).collect();
            for (end, number) in [(0, key[0]), (count, key[3])] {
                let corner = sharing.at_corner(number).first();
                let corner = corner
                    .and_then(|(id, corner)| body.cell(*id).map(|cell| cell.net().0[corner.coefficient()]));
                line[end] = corner.unwrap_or(line[end]);
            }
            line
        });
        let mut line = line.clone();
        if is_backwards {
            line.reverse();
        }
        line
    }
}

/// The numbers of an edge in the direction that comes first, and whether that is backwards.
fn key(numbers: &[u32; 64], edge: Edge) -> (EdgeKey, bool) {
    let forwards = edge.coefficients().map(|at| numbers[at]);
    let mut backwards = forwards;
    backwards.reverse();
    if backwards < forwards { (backwards, true) } else { (forwards, false) }
}

/// The place among `count` segments that is nearest to place `at` among `fine` ones, a multiple.
fn nearest(at: usize, fine: usize, count: usize) -> usize {
    (2 * at * count + fine) / (2 * fine)
}

/// Bounds of the second derivatives of a bicubic surface: along the first axis, mixed, along the second.
fn bends(points: &[DVec3; 16]) -> [f64; 3] {
    let most = |values: &mut dyn Iterator<Item = DVec3>| values.map(|v| v.length()).fold(0.0, f64::max);
    let along = |step: usize, across: usize| {
        let bend = move |n: usize, m: usize| {
            let at = m * across + n * step;
            (points[at] + points[at + 2 * step] - points[at + step] * 2.0) * 6.0
        };
        most(&mut (0..2).flat_map(|n| (0..4).map(move |m| bend(n, m))))
    };
    let twist = |n: usize| {
        let at = n / 3 * 4 + n % 3;
        (points[at + 5] + points[at] - points[at + 4] - points[at + 1]) * 9.0
    };
    [along(4, 1), most(&mut (0..9).map(twist)), along(1, 4)]
}

/// Largest distance between a surface and the triangles of a grid.
///
/// # References
/// D. Filip, R. Magedson and R. Markot, "Surface algorithms using bounds on derivatives", *Computer Aided Geometric
/// Design* 3 (1986).
fn deviation(bends: [f64; 3], counts: [usize; 2]) -> f64 {
    let [a, b] = counts.map(|count| 1.0 / count as f64);
    (a * a * bends[0] + 2.0 * a * b * bends[1] + b * b * bends[2]) / 8.0
}

/// Unit normal of a face; at a point where the surface has none, that of a point a little further inside the face.
fn normal(net: &Net, face: Face, at: DVec3, is_outward: bool) -> DVec3 {
    let [first, second] = face.axis.others();
    let cross = |at: DVec3| {
        let derivatives = net.derivatives(at);
        derivatives[first as usize].cross(derivatives[second as usize]).normalize_or_zero()
    };
    let middle = face.parameters(0.5, 0.5);
    let here = cross(at);
    let normal = if here == DVec3::ZERO { cross(at.lerp(middle, 1e-3)) } else { here };
    if is_outward { normal } else { -normal }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::test_cells::{random_net, ring_cell, twisted};
    use crate::hyperpatch::{Axis, Cell, Jacobian};
    use crate::material::Composition;

    fn body(nets: impl IntoIterator<Item = Net>) -> Body {
        let mut body = Body::new(1);
        for net in nets {
            body.add(Cell::uniform(net, &Composition::pure(0, 1)).unwrap()).unwrap();
        }
        body
    }

    fn surface(body: &Body, tolerance: f64) -> Surface {
        let sharing = Sharing::new(body);
        Tessellation::new(body, &sharing, sharing.outer_faces(), tolerance).unwrap().run()
    }

    /// Every directed edge, by the bits of its ends, is met once in either direction.
    fn is_watertight(surface: &Surface) -> bool {
        let bits = |n: u32| surface.positions[n as usize].to_array().map(f64::to_bits);
        let mut edges: HashMap<[[u64; 3]; 2], i32> = HashMap::new();
        for [a, b, c] in &surface.triangles {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                *edges.entry([bits(*from), bits(*to)]).or_default() += 1;
            }
        }
        edges.iter().all(|([a, b], count)| *count == 1 && edges.get(&[*b, *a]) == Some(&1))
    }

    fn volume(surface: &Surface) -> f64 {
        let point = |n: u32| surface.positions[n as usize];
        surface.triangles.iter().map(|[a, b, c]| point(*a).cross(point(*b)).dot(point(*c)) / 6.0).sum()
    }

    #[test]
    fn a_box_is_twelve_triangles() {
        let found = surface(&body([Net::cuboid(DVec3::ZERO, DVec3::new(1.0, 2.0, 3.0))]), 1e-6);
        assert_eq!((found.triangles.len(), found.positions.len()), (12, 24));
        assert!(is_watertight(&found) && (volume(&found) - 6.0).abs() < 1e-12);
        assert!(found.deviation < 1e-12);
        for patch in &found.patches {
            assert_eq!((patch.positions.len(), patch.triangles.len()), (4, 2));
        }
    }

    /// Cells whose faces need different fineness, with parameters that run in all directions, some mirrored.
    #[test]
    fn bodies_are_watertight_at_every_tolerance() {
        let ring = (0..5).map(|n| {
            let net = ring_cell(5, n, 1.0, 1.4, 1.0);
            if n % 2 == 1 { net.reversed(Axis::ALL[n % 3]) } else { net }
        });
        let bodies = [
            body(ring),
            body([twisted(120.0)]),
            body([random_net(3, 0.1)]),
            body([ring_cell(4, 0, 1.0, 2.0, 1.0), ring_cell(16, 4, 1.0, 2.0, 1.0)]),
            body((0..6).map(|n| {
                let mut net =
                    Net::cuboid(DVec3::new(n as f64, 0.0, 0.0), DVec3::new(n as f64 + 1.0, 1.0, 1.0));
                if n == 2 {
                    net.0[super::super::flat(1, 0, 0)].z -= 0.8;
                }
                net
            })),
        ];
        for (n, body) in bodies.iter().enumerate() {
            let exact: f64 =
                body.cells().iter().map(|(_, cell)| Jacobian::new(cell.net()).volume().abs()).sum();
            for tolerance in [1.0, 0.1, 0.01, 1e-3] {
                let found = surface(body, tolerance);
                assert!(is_watertight(&found), "body {n}, tolerance {tolerance}");
                assert!(found.deviation <= tolerance);
                let area: f64 = 60.0;
                assert!(
                    (volume(&found) - exact).abs() <= area * tolerance,
                    "body {n}, tolerance {tolerance}"
                );
            }
            let (coarse, fine) = (surface(body, 1e-2), surface(body, 1e-3));
            assert!(fine.triangles.len() > coarse.triangles.len());
            assert!((volume(&fine) - exact).abs() < 2e-2, "body {n}: {} {exact}", volume(&fine));
        }
    }

    /// Points between the vertices, on the face at the mean of the parameters, are within the stated deviation of the
    /// triangle.
    #[test]
    fn the_deviation_is_kept() {
        let body = body([twisted(120.0), ring_cell(4, 0, 3.0, 5.0, 1.0)]);
        let found = surface(&body, 0.02);
        assert!(found.deviation <= 0.02 && found.deviation > 0.002);
        for patch in &found.patches {
            let net = body.cell(patch.cell).unwrap().net();
            for triangle in &found.triangles[patch.triangles.clone()] {
                let [a, b, c] = triangle.map(|n| found.positions[n as usize]);
                let [p, q, r] = triangle.map(|n| found.parameters[n as usize]);
                for weights in [[1.0 / 3.0; 3], [0.5, 0.5, 0.0], [0.5, 0.0, 0.5], [0.0, 0.5, 0.5]] {
                    let mean = |x: [DVec3; 3]| x[0] * weights[0] + x[1] * weights[1] + x[2] * weights[2];
                    assert!(
                        net.point(mean([p, q, r])).distance(mean([a, b, c]))
                            <= found.deviation * (1.0 + 1e-9)
                    );
                }
            }
        }
    }

    /// Normals and triangles point outwards, whichever way the parameters run.
    #[test]
    fn normals_point_outwards() {
        for axis in Axis::ALL {
            let body = body([ring_cell(6, 0, 1.0, 2.0, 1.0).reversed(axis)]);
            let found = surface(&body, 1e-3);
            let middle = body.cells()[0].1.point(DVec3::splat(0.5));
            for triangle in &found.triangles {
                let [a, b, c] = triangle.map(|n| found.positions[n as usize]);
                let flat = (b - a).cross(c - a).normalize();
                assert!(triangle.iter().all(|n| found.normals[*n as usize].dot(flat) > 0.9));
            }
            let outer = found.patches.iter().filter(|patch| patch.face.axis == Axis::W);
            for n in outer.flat_map(|patch| patch.positions.clone()) {
                assert!(found.normals[n].dot(found.positions[n] - middle) > 0.0);
            }
        }
    }

    #[test]
    fn collapsed_faces_and_wrong_tolerances_do_no_harm() {
        let cube = Net::cuboid(DVec3::ZERO, DVec3::ONE);
        let pinched = body([Net(cube.0.map(|p| DVec3::new(p.x * p.z, p.y * p.z, p.z)))]);
        let found = surface(&pinched, 1e-2);
        assert!((volume(&found) - 1.0 / 3.0).abs() < 1e-2);
        assert!(found.normals.iter().all(|n| n.is_finite()));
        let sharing = Sharing::new(&pinched);
        for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(Tessellation::new(&pinched, &sharing, Vec::new(), tolerance).is_err(), "{tolerance}");
        }
        let unknown = Face { axis: Axis::U, is_end: false };
        let job = Tessellation::new(&pinched, &sharing, vec![(CellId(9), unknown)], 1.0).unwrap();
        assert_eq!(job.run(), Surface::default());
        let mut job = Tessellation::new(&pinched, &sharing, sharing.outer_faces(), 1e-2).unwrap();
        let mut steps = 1;
        while job.step(&mut || false).is_none() {
            steps += 1;
        }
        assert_eq!(steps, 12, "a step to measure and one to triangulate each face");
    }

    /// What cannot be reached is said.
    #[test]
    fn a_tolerance_out_of_reach_is_not_claimed() {
        let found = surface(&body([ring_cell(4, 0, 1.0, 2.0, 1.0)]), 1e-9);
        assert!(found.deviation > 1e-9);
        let most = 2 * MOST_SEGMENTS * MOST_SEGMENTS;
        assert!(found.patches.iter().all(|patch| patch.triangles.len() <= most));
    }
}
