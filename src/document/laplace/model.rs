//! The elements of the bodies that documents name.

use super::schema::BoundaryModel;
use crate::laplace::{LaplaceError, Mesh, Space, samples};
use glam::DVec3;

/// The elements of a boundary, and why the solver refuses them if it does.
#[derive(Debug, Clone)]
pub(super) struct Surface {
    /// Whether it lies in the plane or in space.
    pub(super) space: Space,
    /// Where the vertices are; z is 0 in the plane.
    pub(super) vertices: Vec<DVec3>,
    /// The vertices of each element, the second of a segment twice.
    pub(super) elements: Vec<[u32; 3]>,
    /// The same as the solver has it.
    pub(super) mesh: Result<Mesh, LaplaceError>,
}

impl Surface {
    /// The elements of a body.
    pub(super) fn new(model: &BoundaryModel) -> Self {
        let mesh = match *model {
            BoundaryModel::Cube { divisions } => samples::cube(divisions),
            BoundaryModel::SliverCube { divisions, width } => samples::sliver_cube(divisions, width),
            BoundaryModel::HollowBox { divisions, wall } => samples::hollow_box(divisions, wall),
            BoundaryModel::Shell { inner, outer, level } => samples::shell(inner, outer, level),
            BoundaryModel::Sphere { radius, level } => samples::sphere(radius, level),
            BoundaryModel::Mug { sectors, sliver } => samples::mug(sectors, sliver),
            BoundaryModel::Cylinder { divisions } => samples::cylinder(divisions),
            BoundaryModel::FilletBlock { divisions } => samples::fillet_block(divisions),
            BoundaryModel::Square { divisions } => samples::square(divisions),
            BoundaryModel::Annulus { inner, outer, segments } => samples::annulus(inner, outer, segments),
            BoundaryModel::Mesh { ref vertices, ref triangles } => {
                let mesh = Mesh::solid(vertices.clone(), triangles.clone());
                // Elements of one that is refused are those of the document, so that the fault can be shown.
                let elements =
                    mesh.as_ref().map_or_else(|_| triangles.clone(), |mesh| mesh.elements().to_vec());
                return Self { space: Space::Solid, vertices: vertices.clone(), elements, mesh };
            }
        };
        Self {
            space: mesh.space(),
            vertices: mesh.vertices().to_vec(),
            elements: mesh.elements().to_vec(),
            mesh: Ok(mesh),
        }
    }
}
