//! Binary STL (3D Systems, "StereoLithography interface specification", 1988).

use super::Mesh;
use super::file::{Labels, plain};
use super::mesh::stored;
use glam::Vec3;

/// Bytes of the text at the start.
const HEADER: usize = 80;

/// The header, which must not begin with the word that text files begin with, and the number of triangles.
pub(super) fn head(mesh: &Mesh, labels: &Labels) -> Vec<u8> {
    let text = format!("Directrix binary STL, unit {}, {}", plain(&labels.unit), plain(&labels.title));
    let mut bytes: Vec<u8> = text.into_bytes();
    bytes.resize(HEADER, b' ');
    bytes.extend((mesh.triangles.len() as u32).to_le_bytes());
    bytes.reserve(50 * mesh.triangles.len());
    bytes
}

/// Unit normal of the stored vertices, zero for a triangle without area; the three vertices; no attributes.
pub(super) fn triangle(bytes: &mut Vec<u8>, mesh: &Mesh, triangle: usize) {
    let corners = mesh.corners(mesh.triangles[triangle]).map(stored);
    let [a, b, c] = corners.map(|corner| Vec3::from(corner).as_dvec3());
    let normal = (b - a).cross(c - a).normalize_or_zero().as_vec3();
    let numbers = [normal.to_array()].into_iter().chain(corners).flatten();
    bytes.extend(numbers.flat_map(f32::to_le_bytes));
    bytes.extend([0, 0]);
}
