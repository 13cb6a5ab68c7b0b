//! Meshes as files, written in steps.

use super::{Mesh, obj, ply, stl};
use crate::material::Color;

/// Formats of files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Binary STL: triangles alone.
    Stl,
    /// Binary PLY, little-endian: with colours, fractions and angles.
    Ply,
    /// Wavefront OBJ: text, with groups, and colours after the coordinates.
    Obj,
}

/// What a file says besides the mesh.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Labels {
    /// Title of the document.
    pub title: String,
    /// Unit of length.
    pub unit: String,
    /// Names of the materials.
    pub materials: Vec<String>,
}

/// Vertices or triangles that are written between two looks at the clock.
const BATCH: usize = 4096;

/// A file under way. Vertices are those of the mesh: the rim of a cap is that of the surface.
#[derive(Debug)]
pub struct FileJob {
    format: Format,
    mesh: Mesh,
    colors: Vec<Color>,
    bytes: Vec<u8>,
    /// Vertices written, then triangles.
    done: usize,
}

impl FileJob {
    /// Begins a file of a mesh with a colour for each vertex.
    ///
    /// # Panics
    /// When there is another number of colours.
    #[must_use]
    pub fn new(format: Format, mesh: Mesh, colors: Vec<Color>, labels: &Labels) -> Self {
        assert_eq!(colors.len(), mesh.positions.len(), "one colour for each vertex");
        let bytes = match format {
            Format::Stl => stl::head(&mesh, labels),
            Format::Ply => ply::head(&mesh, labels),
            Format::Obj => obj::head(&mesh, labels),
        };
        Self { format, mesh, colors, bytes, done: 0 }
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the file when it is written, and nothing more ever after.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Vec<u8>> {
        let (vertices, all) = (self.mesh.positions.len(), self.items());
        loop {
            for item in self.done..all.min(self.done + BATCH) {
                if item < vertices {
                    self.vertex(item);
                } else {
                    self.triangle(item - vertices);
                }
            }
            self.done = all.min(self.done + BATCH);
            if self.done == all {
                return Some(std::mem::take(&mut self.bytes));
            }
            if !may_go_on() {
                return None;
            }
        }
    }

    /// Share of the file that is written, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.done as f64 / self.items().max(1) as f64
    }

    fn items(&self) -> usize {
        self.mesh.positions.len() + self.mesh.triangles.len()
    }

    fn vertex(&mut self, vertex: usize) {
        match self.format {
            Format::Stl => {}
            Format::Ply => ply::vertex(&mut self.bytes, &self.mesh, vertex, self.colors[vertex]),
            Format::Obj => obj::vertex(&mut self.bytes, &self.mesh, vertex, self.colors[vertex]),
        }
    }

    fn triangle(&mut self, triangle: usize) {
        match self.format {
            Format::Stl => stl::triangle(&mut self.bytes, &self.mesh, triangle),
            Format::Ply => ply::triangle(&mut self.bytes, &self.mesh, triangle),
            Format::Obj => obj::triangle(&mut self.bytes, &self.mesh, triangle),
        }
    }
}

/// A text in one line of printable ASCII, for the heads of files that have no other letters.
pub(super) fn plain(text: &str) -> String {
    text.chars().map(|c| if c == ' ' || c.is_ascii_graphic() { c } else { '?' }).collect()
}
