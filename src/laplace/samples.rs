//! Boundaries for problems whose solution is known, and those of the solver laboratory.

use super::mesh::Mesh;
use super::panel::Panel;
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// Quadrilaterals of a surface, as two triangles each.
#[derive(Default)]
struct Quads {
    vertices: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
}

impl Quads {
    /// A patch of `counts` quadrilaterals; `place` maps whole numbers along both sides to points, the first turned to the second counter-clockwise from outside.
    fn patch(&mut self, counts: [usize; 2], place: impl Fn(usize, usize) -> DVec3) {
        let start = self.vertices.len() as u32;
        let [nu, nv] = counts;
        for v in 0..=nv {
            for u in 0..=nu {
                self.vertices.push(place(u, v));
            }
        }
        let row = nu as u32 + 1;
        for v in 0..nv as u32 {
            for u in 0..nu as u32 {
                let a = start + v * row + u;
                let [b, c, d] = [a + 1, a + row + 1, a + row];
                // Diagonals run towards the middle of the patch, so that it is its own mirror image.
                let is_mirrored = (2 * u + 1 < nu as u32) != (2 * v + 1 < nv as u32);
                let halves = if is_mirrored { [[a, b, d], [b, c, d]] } else { [[a, b, c], [a, c, d]] };
                // Triangles that lost their area at a pole are left out.
                for triangle in halves {
                    let [p, q, r] = triangle.map(|vertex| self.vertices[vertex as usize]);
                    if p != q && q != r && r != p {
                        self.triangles.push(triangle);
                    }
                }
            }
        }
    }

    /// The six faces of a box whose edges are divided at these places.
    fn cuboid(&mut self, divisions: [&[f64]; 3], is_cavity: bool) {
        for axis in 0..3 {
            let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
            let [first, last] =
                [divisions[axis].first(), divisions[axis].last()].map(|end| *end.unwrap_or(&0.0));
            for is_end in [false, true] {
                let place = |along: f64, across: f64| {
                    let mut point = [0.0; 3];
                    point[axis] = if is_end { last } else { first };
                    point[u] = along;
                    point[v] = across;
                    DVec3::from_array(point)
                };
                let counts = [divisions[u].len() - 1, divisions[v].len() - 1];
                if is_end != is_cavity {
                    self.patch(counts, |i, j| place(divisions[u][i], divisions[v][j]));
                } else {
                    self.patch([counts[1], counts[0]], |j, i| place(divisions[u][i], divisions[v][j]));
                }
            }
        }
    }

    /// A surface about the z axis: the profile, radius and height, runs with the material on its left.
    fn revolved(&mut self, profile: &[DVec2], sectors: usize) {
        self.patch([sectors, profile.len() - 1], |i, j| {
            let DVec2 { x: radius, y: height } = profile[j];
            let (sin, cos) = (TAU * (i % sectors) as f64 / sectors as f64).sin_cos();
            DVec3::new(radius * cos, radius * sin, height)
        });
    }

    fn mesh(self) -> Mesh {
        let made = Mesh::solid(self.vertices, self.triangles);
        made.expect("samples have finite vertices and triangles with an area")
    }
}

fn even(from: f64, to: f64, count: usize) -> Vec<f64> {
    // Both ends are met exactly, so that an axis is one point.
    let place = |k: usize| if k == count { to } else { from + (to - from) * k as f64 / count as f64 };
    (0..=count).map(place).collect()
}

/// The unit cube with `m` steps along each edge: 12 m^2 triangles.
#[must_use]
pub fn cube(m: usize) -> Mesh {
    let steps = even(0.0, 1.0, m.max(1));
    let mut quads = Quads::default();
    quads.cuboid([&steps; 3], false);
    quads.mesh()
}

/// Values of the paper's cube on a panel of its faces: 1 above, one half below, 0 at the sides (Liu and others 2003, Fig. 13).
#[must_use]
pub fn cube_values(panel: &Panel) -> f64 {
    match panel.normal.z {
        z if z > 0.5 => 1.0,
        z if z < -0.5 => 0.5,
        _ => 0.0,
    }
}

/// The unit cube with a strip of slivers of this width round it, beside `m` even steps along z.
#[must_use]
pub fn sliver_cube(m: usize, width: f64) -> Mesh {
    let steps = even(0.0, 1.0, m.max(2));
    let mut heights = steps.clone();
    heights.insert(1 + m.max(2) / 2, steps[m.max(2) / 2] + width);
    let mut quads = Quads::default();
    quads.cuboid([&steps, &steps, &heights], false);
    quads.mesh()
}

/// The unit cube with a cavity that leaves walls of this thickness: 24 m^2 triangles.
#[must_use]
pub fn hollow_box(m: usize, wall: f64) -> Mesh {
    let mut quads = Quads::default();
    quads.cuboid([&even(0.0, 1.0, m.max(1)); 3], false);
    quads.cuboid([&even(wall, 1.0 - wall, m.max(1)); 3], true);
    quads.mesh()
}

/// A sphere about the origin: an icosahedron whose triangles are halved along their sides `level` times, 20 4^level of them.
#[must_use]
pub fn sphere(radius: f64, level: usize) -> Mesh {
    let mut quads = Quads::default();
    icosphere(&mut quads, radius, level, false);
    quads.mesh()
}

/// The space between two spheres about the origin, each of 20 4^level triangles.
#[must_use]
pub fn shell(inner: f64, outer: f64, level: usize) -> Mesh {
    let mut quads = Quads::default();
    icosphere(&mut quads, outer, level, false);
    icosphere(&mut quads, inner, level, true);
    quads.mesh()
}

fn icosphere(quads: &mut Quads, radius: f64, level: usize, is_cavity: bool) {
    let steps = 1 << level;
    // The corners of an icosahedron: the poles, and two rings of five, the lower turned by 36 degrees.
    let height = 1.0 / 5.0_f64.sqrt();
    let ring = |k: usize, is_upper: bool| {
        let turn = TAU * (k as f64 + if is_upper { 0.0 } else { 0.5 }) / 5.0;
        let flat = 2.0 * height;
        DVec3::new(flat * turn.cos(), flat * turn.sin(), if is_upper { height } else { -height })
    };
    let mut corners = Vec::with_capacity(20);
    for k in 0..5 {
        let [a, b] = [ring(k, true), ring((k + 1) % 5, true)];
        let [c, d] = [ring(k, false), ring((k + 1) % 5, false)];
        corners.extend([[DVec3::Z, a, b], [a, c, b], [b, c, d], [DVec3::NEG_Z, d, c]]);
    }
    for [a, b, c] in corners {
        // Weights in whole numbers, so that points on a common side are equal bit by bit whichever triangle asks.
        let point = |i: usize, j: usize| {
            let mut parts = [(a, steps - i - j), (b, i), (c, j)];
            parts.sort_by(|p, q| {
                p.0.to_array().partial_cmp(&q.0.to_array()).unwrap_or(std::cmp::Ordering::Equal)
            });
            parts.iter().fold(DVec3::ZERO, |sum, (corner, weight)| sum + *corner * *weight as f64).normalize()
                * radius
        };
        let mut push = |points: [DVec3; 3]| {
            let start = quads.vertices.len() as u32;
            quads.vertices.extend(points);
            quads.triangles.push(if is_cavity {
                [start, start + 2, start + 1]
            } else {
                [start, start + 1, start + 2]
            });
        };
        for i in 0..steps {
            for j in 0..steps - i {
                push([point(i, j), point(i + 1, j), point(i, j + 1)]);
                if i + j + 1 < steps {
                    push([point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)]);
                }
            }
        }
    }
}

/// A mug with a thick wall and without a handle, open above; radius 1, height 2. A strip of slivers of the width `sliver` runs round inside and outside, as
/// triangulations of CAD systems have them; 0 leaves it out. Its inner surface is where the radius is below 0.85 and the height above 0.2.
#[must_use]
pub fn mug(sectors: usize, sliver: f64) -> Mesh {
    let sectors = sectors.max(6);
    let rows = (sectors / 3).max(3);
    let (wall, floor) = (0.2, 0.25);
    let mut profile: Vec<DVec2> =
        even(0.0, 1.0, (rows / 2).max(2)).iter().map(|r| DVec2::new(*r, 0.0)).collect();
    let strip = |heights: Vec<f64>, downwards: bool| -> Vec<f64> {
        let mut list = heights;
        if sliver > 0.0 {
            let middle = list.len() / 2;
            let at = list[middle];
            list.insert(middle + 1, if downwards { at - sliver } else { at + sliver });
        }
        list
    };
    profile.extend(strip(even(0.0, 2.0, rows), false)[1..].iter().map(|h| DVec2::new(1.0, *h)));
    profile.push(DVec2::new(1.0 - wall, 2.0));
    profile.extend(strip(even(2.0, floor, rows), true)[1..].iter().map(|h| DVec2::new(1.0 - wall, *h)));
    profile.extend(even(1.0 - wall, 0.0, (rows / 2).max(2))[1..].iter().map(|r| DVec2::new(*r, floor)));
    let mut quads = Quads::default();
    quads.revolved(&profile, sectors);
    quads.mesh()
}

/// A cylinder of radius and height 1 about the z axis with `m` steps along both.
#[must_use]
pub fn cylinder(m: usize) -> Mesh {
    let m = m.max(2);
    let mut profile: Vec<DVec2> = even(0.0, 1.0, m).iter().map(|r| DVec2::new(*r, 0.0)).collect();
    profile.extend(even(0.0, 1.0, m)[1..].iter().map(|h| DVec2::new(1.0, *h)));
    profile.extend(even(1.0, 0.0, m)[1..].iter().map(|r| DVec2::new(*r, 1.0)));
    let mut quads = Quads::default();
    quads.revolved(&profile, 6 * m);
    quads.mesh()
}

/// The piece between two volumes that a material fillet joins: a block 2 by 1 by 1 about the origin whose ends along x are paraboloids, moved by
/// 0.3 (1 - 2 (y^2 + z^2)), so that the left one is hollow and the right one bulges; `m` steps along each short edge.
#[must_use]
pub fn fillet_block(m: usize) -> Mesh {
    let m = m.max(1);
    let bulge = |y: f64, z: f64| 0.3 * (1.0 - 2.0 * (y * y + z * z));
    let place = |u: f64, y: f64, z: f64| {
        let end = 1.0 + bulge(y, z);
        DVec3::new(-1.0 + bulge(y, z) + u * (end + 1.0 - bulge(y, z)), y, z)
    };
    let long = even(0.0, 1.0, 2 * m);
    let short = even(-0.5, 0.5, m);
    let mut quads = Quads::default();
    quads.cuboid([&long, &short, &short], false);
    for vertex in &mut quads.vertices {
        *vertex = place(vertex.x, vertex.y, vertex.z);
    }
    quads.mesh()
}

/// A closed polygon of segments, each side divided evenly.
fn polygon(vertices: &mut Vec<DVec2>, segments: &mut Vec<[u32; 2]>, points: impl Iterator<Item = DVec2>) {
    let start = vertices.len() as u32;
    vertices.extend(points);
    let count = vertices.len() as u32 - start;
    segments.extend((0..count).map(|k| [start + k, start + (k + 1) % count]));
}

fn plane(vertices: &[DVec2], segments: &[[u32; 2]]) -> Mesh {
    Mesh::plane(vertices, segments).expect("samples have finite vertices and segments with a length")
}

/// The unit square with `m` steps along each side.
#[must_use]
pub fn square(m: usize) -> Mesh {
    let m = m.max(1);
    let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
    let point = |n: usize| corners[n / m].lerp(corners[(n / m + 1) % 4], (n % m) as f64 / m as f64);
    let (mut vertices, mut segments) = (Vec::new(), Vec::new());
    polygon(&mut vertices, &mut segments, (0..4 * m).map(point));
    plane(&vertices, &segments)
}

/// The ring between two circles about the origin: `count` segments outside and half as many inside.
#[must_use]
pub fn annulus(inner: f64, outer: f64, count: usize) -> Mesh {
    let count = count.max(6);
    let (mut vertices, mut segments) = (Vec::new(), Vec::new());
    let ring = |radius: f64, count: usize, sign: f64| {
        (0..count).map(move |k| radius * DVec2::from_angle(sign * 2.0 * PI * k as f64 / count as f64))
    };
    polygon(&mut vertices, &mut segments, ring(outer, count, 1.0));
    polygon(&mut vertices, &mut segments, ring(inner, count.div_ceil(2), -1.0));
    plane(&vertices, &segments)
}
