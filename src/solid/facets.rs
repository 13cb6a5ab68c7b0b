//! A mesh as it is shaded.

use super::mesh::stored;
use super::{Mesh, Part};
use glam::DVec3;

/// Angle in degrees between the normals of two triangles from which on the edge between them is a crease.
const CREASE: f64 = 35.0;

/// The triangles of a mesh with a normal at each vertex: a vertex on a crease, or on the rim of a cap, is there once for each side.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Facets {
    /// For each vertex, that of the mesh.
    pub vertices: Vec<u32>,
    /// Unit normals, outwards; the mean over the triangles of its side, weighted by area.
    pub normals: Vec<DVec3>,
    /// Indices of the vertices of each triangle, in the order of the mesh.
    pub triangles: Vec<[u32; 3]>,
}

/// A vertex in the making: one side of a crease.
#[derive(Clone, Copy)]
struct Side {
    vertex: u32,
    part: Part,
    /// Unit normal of the first triangle that had an area.
    first: DVec3,
    sum: DVec3,
}

impl Facets {
    /// Parts the vertices of a mesh along its creases.
    #[must_use]
    pub fn new(mesh: &Mesh) -> Self {
        let limit = CREASE.to_radians().cos();
        // The sides of each vertex are a chain.
        const END: u32 = u32::MAX;
        let mut heads = vec![END; mesh.positions.len()];
        let mut sides: Vec<(Side, u32)> = Vec::with_capacity(mesh.positions.len());
        let mut triangles = Vec::with_capacity(mesh.triangles.len());
        for group in &mesh.groups {
            for triangle in &mesh.triangles[group.triangles.clone()] {
                let [a, b, c] = mesh.corners(*triangle);
                let normal = (b - a).cross(c - a);
                let unit = normal.normalize_or_zero();
                triangles.push(triangle.map(|vertex| {
                    let mut index = heads[vertex as usize];
                    while let Some((side, next)) = sides.get_mut(index as usize) {
                        let is_flat = side.first == DVec3::ZERO || unit == DVec3::ZERO;
                        if side.part == group.part && (is_flat || side.first.dot(unit) >= limit) {
                            if side.first == DVec3::ZERO {
                                side.first = unit;
                            }
                            side.sum += normal;
                            return index;
                        }
                        index = *next;
                    }
                    let side = Side { vertex, part: group.part, first: unit, sum: normal };
                    sides.push((side, heads[vertex as usize]));
                    heads[vertex as usize] = sides.len() as u32 - 1;
                    heads[vertex as usize]
                }));
            }
        }
        Self {
            vertices: sides.iter().map(|(side, _)| side.vertex).collect(),
            normals: sides.iter().map(|(side, _)| side.sum.normalize_or(side.first)).collect(),
            triangles,
        }
    }

    /// The positions of the vertices as they are stored.
    #[must_use]
    pub fn positions(&self, mesh: &Mesh) -> Vec<f32> {
        self.vertices.iter().flat_map(|&vertex| stored(mesh.positions[vertex as usize])).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::Composition;
    use crate::solid::{Row, Shell};
    use std::f64::consts::TAU;

    /// A prism with so many sides: with four every edge is a crease, with sixty only the rims.
    fn prism(sides: u32) -> (Mesh, Facets) {
        let mut shell = Shell::new(true, 1, [DVec3::X, DVec3::Y]);
        for z in [0.0, 1.0, 2.0] {
            let corner = |k| glam::DVec2::from_angle(TAU * f64::from(k) / f64::from(sides)).extend(z);
            let compositions = vec![Composition::pure(0, 1); sides as usize];
            shell.push(&Row { points: (0..sides).map(corner).collect(), compositions }, &[]);
        }
        let mesh = shell.finish(true).mesh;
        let facets = Facets::new(&mesh);
        (mesh, facets)
    }

    #[test]
    fn creases_part_vertices_and_smooth_sides_do_not() {
        let (mesh, facets) = prism(4);
        assert_eq!((mesh.positions.len(), facets.vertices.len()), (12, 2 * 12 + 2 * 4));
        let (mesh, facets) = prism(60);
        assert_eq!((mesh.positions.len(), facets.vertices.len()), (180, 180 + 120));
        for (&vertex, normal) in facets.vertices.iter().zip(&facets.normals) {
            let position = mesh.positions[vertex as usize];
            let radial = position.truncate().extend(0.0).normalize();
            assert!((normal.length() - 1.0).abs() < 1e-12);
            assert!(normal.z.abs() > 1.0 - 1e-12 || normal.dot(radial) > 0.998, "{normal} at {position}");
        }
    }

    #[test]
    fn triangles_are_those_of_the_mesh() {
        let (mesh, facets) = prism(7);
        let back: Vec<[u32; 3]> =
            facets.triangles.iter().map(|t| t.map(|corner| facets.vertices[corner as usize])).collect();
        assert_eq!(back, mesh.triangles);
        assert_eq!(facets.positions(&mesh).len(), 3 * facets.vertices.len());
    }
}
