//! Wavefront OBJ, with the colours of vertices after their coordinates, as MeshLab and Blender read them.

use super::file::{Labels, plain};
use super::mesh::stored;
use super::{Mesh, Part};
use crate::material::Color;
use std::io::Write;

/// Remarks that name the document.
pub(super) fn head(mesh: &Mesh, labels: &Labels) -> Vec<u8> {
    let mut bytes =
        format!("# Directrix: {}\n# unit {}, z up\n", plain(&labels.title), plain(&labels.unit)).into_bytes();
    bytes.reserve(48 * mesh.positions.len() + 22 * mesh.triangles.len());
    bytes
}

/// A vertex: coordinates in the fewest digits that tell the stored ones, then red, green and blue from 0 to 1.
pub(super) fn vertex(bytes: &mut Vec<u8>, mesh: &Mesh, vertex: usize, color: Color) {
    let [x, y, z] = stored(mesh.positions[vertex]);
    let [r, g, b] = [color.r, color.g, color.b].map(|channel| f32::from(channel) / 255.0);
    // Writing to a list of bytes cannot fail.
    let _ = writeln!(bytes, "v {x} {y} {z} {r:.4} {g:.4} {b:.4}");
}

/// A triangle by the numbers of its vertices, from 1; before the first one of a part the name of its group.
pub(super) fn triangle(bytes: &mut Vec<u8>, mesh: &Mesh, triangle: usize) {
    let starts_here = mesh.groups.iter().filter(|group| group.triangles.start == triangle);
    for group in starts_here.filter(|group| !group.triangles.is_empty()) {
        let _ = match group.part {
            Part::Surface => writeln!(bytes, "g surface"),
            Part::Cap(curve) => writeln!(bytes, "g cap_{curve}"),
        };
    }
    let [a, b, c] = mesh.triangles[triangle].map(|vertex| vertex + 1);
    let _ = writeln!(bytes, "f {a} {b} {c}");
}
