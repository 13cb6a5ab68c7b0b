//! Binary PLY (Greg Turk, "The PLY polygon file format", 1994), little-endian.

use super::Mesh;
use super::file::{Labels, plain};
use super::mesh::stored;
use crate::material::Color;

/// The head: coordinates, colours, fractions and, where the mesh has them, angles in degrees of each vertex, then the faces.
pub(super) fn head(mesh: &Mesh, labels: &Labels) -> Vec<u8> {
    let mut text = "ply\nformat binary_little_endian 1.0\n".to_owned();
    let mut line = |words: String| text.extend([words.as_str(), "\n"]);
    line(format!("comment Directrix: {}", plain(&labels.title)));
    line(format!("comment unit {}, z up", plain(&labels.unit)));
    for (k, name) in labels.materials.iter().enumerate() {
        line(format!("comment fraction_{k}: {}", plain(name)));
    }
    line(format!("element vertex {}", mesh.positions.len()));
    ["x", "y", "z"].iter().for_each(|name| line(format!("property float {name}")));
    ["red", "green", "blue"].iter().for_each(|name| line(format!("property uchar {name}")));
    (0..mesh.materials).for_each(|k| line(format!("property float fraction_{k}")));
    if !mesh.scalars.is_empty() {
        line("property float degrees".to_owned());
    }
    line(format!("element face {}", mesh.triangles.len()));
    line("property list uchar uint vertex_indices".to_owned());
    line("end_header".to_owned());
    let mut bytes = text.into_bytes();
    bytes.reserve((19 + 4 * mesh.materials) * mesh.positions.len() + 13 * mesh.triangles.len());
    bytes
}

/// A vertex with its properties in the order of the head.
pub(super) fn vertex(bytes: &mut Vec<u8>, mesh: &Mesh, vertex: usize, color: Color) {
    bytes.extend(stored(mesh.positions[vertex]).into_iter().flat_map(f32::to_le_bytes));
    bytes.extend([color.r, color.g, color.b]);
    let more = mesh.fractions_at(vertex).iter().chain(mesh.scalars.get(vertex));
    bytes.extend(more.flat_map(|&number| (number as f32).to_le_bytes()));
}

/// The number of vertices, which is 3, and their indices.
pub(super) fn triangle(bytes: &mut Vec<u8>, mesh: &Mesh, triangle: usize) {
    bytes.push(3);
    bytes.extend(mesh.triangles[triangle].into_iter().flat_map(u32::to_le_bytes));
}
