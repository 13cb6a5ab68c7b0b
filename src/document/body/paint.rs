//! Triangles in cells with the material at their vertices.

use super::{Held, KnownBody};
use crate::hyperpatch::composite::{Body, CellId, Sharing};
use crate::hyperpatch::{Cell, Corner, Edge, Face, Section, Surface, cubic};
use crate::material::mix_fractions;
use glam::DVec3;
use std::collections::HashSet;
use std::ops::Range;
use std::rc::Rc;

/// The triangles, vertices and pieces of outline of one cell, or of one of its faces.
#[derive(Debug, Clone, PartialEq)]
pub struct Stretch {
    /// The cell.
    pub cell: CellId,
    /// The face, of a surface.
    pub face: Option<Face>,
    /// Its vertices.
    pub vertices: Range<usize>,
    /// Its triangles.
    pub triangles: Range<usize>,
    /// Its pieces of outline, of a section.
    pub outlines: Range<usize>,
    /// Segments along the edges of the face.
    pub segments: [usize; 4],
    /// No point of the face is farther than this from its triangles.
    pub deviation: f64,
}

/// Triangles with all that is drawn of them, for each vertex.
#[derive(Debug, Clone, Default)]
pub struct Painted {
    /// Points.
    pub positions: Vec<DVec3>,
    /// Unit normals, of a surface.
    pub normals: Vec<DVec3>,
    /// Parameters in the cell.
    pub parameters: Vec<DVec3>,
    /// Number of the cell.
    pub cells: Vec<u32>,
    /// Fractions of all materials.
    pub fractions: Vec<f64>,
    /// Colour of the mixture as sRGB, and 255.
    pub colors: Vec<u8>,
    /// Three vertices each.
    pub triangles: Vec<[u32; 3]>,
    /// Two vertices each.
    pub outlines: Vec<[u32; 2]>,
    /// What belongs to which cell.
    pub stretches: Vec<Stretch>,
    /// Of a surface: no point of a face is farther than this from the triangles.
    pub deviation: f64,
}

/// Boundary curves and corners of a surface, each once.
#[derive(Debug, Clone, Default)]
pub struct Boundary {
    /// Points of all curves.
    pub points: Vec<DVec3>,
    /// The curves: a cell and its edge, the number of cells that have it, and its points.
    pub edges: Vec<(CellId, Edge, usize, Range<usize>)>,
    /// The corners: a cell and its corner, the number of cells that have it, and its position.
    pub corners: Vec<(CellId, Corner, usize, DVec3)>,
}

/// The job that finds fractions and colours of triangles.
#[derive(Debug)]
pub(super) struct Painter {
    body: Held,
    painted: Painted,
    /// Number of stretches that are done.
    next: usize,
    /// Of a surface: its curves.
    outliner: Option<Outliner>,
}

/// Finds the boundary curves and corners of a surface.
#[derive(Debug)]
pub(super) struct Outliner {
    sharing: Rc<Sharing>,
    pub(super) boundary: Boundary,
    edges: HashSet<(CellId, Edge)>,
    corners: HashSet<(CellId, Corner)>,
}

impl Painter {
    pub(super) fn of_section(known: &KnownBody, section: Section) -> Self {
        let stretch = |cut: crate::hyperpatch::Cut| Stretch {
            cell: cut.cell,
            face: None,
            vertices: cut.positions,
            triangles: cut.triangles,
            outlines: cut.outlines,
            segments: [0; 4],
            deviation: 0.0,
        };
        Self::new(
            known,
            Painted {
                positions: section.positions,
                parameters: section.parameters,
                triangles: section.triangles,
                outlines: section.outlines,
                stretches: section.cells.into_iter().map(stretch).collect(),
                ..Painted::default()
            },
        )
    }

    pub(super) fn of_surface(known: &KnownBody, surface: Surface, sharing: Rc<Sharing>) -> Self {
        Self { outliner: Some(Outliner::new(sharing)), ..Self::of_faces(known, surface) }
    }

    /// Of some faces of a surface, without its curves.
    pub(super) fn of_faces(known: &KnownBody, surface: Surface) -> Self {
        let stretch = |patch: crate::hyperpatch::Patch| Stretch {
            cell: patch.cell,
            face: Some(patch.face),
            vertices: patch.positions,
            triangles: patch.triangles,
            outlines: 0..0,
            segments: patch.segments,
            deviation: patch.deviation,
        };
        let painted = Painted {
            positions: surface.positions,
            normals: surface.normals,
            parameters: surface.parameters,
            triangles: surface.triangles,
            stretches: surface.patches.into_iter().map(stretch).collect(),
            deviation: surface.deviation,
            ..Painted::default()
        };
        Self::new(known, painted)
    }

    fn new(known: &KnownBody, painted: Painted) -> Self {
        Self { body: known.held(), painted, next: 0, outliner: None }
    }

    /// Share of the work that is done, from 0 to 1.
    pub(super) fn progress(&self) -> f64 {
        self.next as f64 / self.painted.stretches.len().max(1) as f64
    }

    /// Advances while `may_go_on` says so, by one stretch at least; returns the triangles when all are done.
    pub(super) fn step(
        &mut self,
        known: &KnownBody,
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> Option<(Painted, Boundary)> {
        while let Some(stretch) = self.painted.stretches.get(self.next).cloned() {
            if let Some(cell) = self.body.cell(stretch.cell) {
                paint(&mut self.painted, known, cell, &stretch);
            }
            if let Some(outliner) = &mut self.outliner {
                outliner.add(&self.body, &self.painted, &stretch);
            }
            self.next += 1;
            if !may_go_on() {
                break;
            }
        }
        if self.next < self.painted.stretches.len() {
            return None;
        }
        let boundary = self.outliner.take().map_or_else(Boundary::default, |outliner| outliner.boundary);
        Some((std::mem::take(&mut self.painted), boundary))
    }
}

impl Outliner {
    pub(super) fn new(sharing: Rc<Sharing>) -> Self {
        let (edges, corners) = (HashSet::new(), HashSet::new());
        Self { sharing, boundary: Boundary::default(), edges, corners }
    }

    /// Collects the boundary curves and corners of a face that no face before had. The vertices of a face lie on them exactly.
    pub(super) fn add(&mut self, body: &Body, painted: &Painted, stretch: &Stretch) {
        let Some(face) = stretch.face else { return };
        let (sharing, boundary) = (&self.sharing, &mut self.boundary);
        for edge in face.edges() {
            let users = sharing.at_edge(stretch.cell, edge);
            if !users.first().is_some_and(|first| self.edges.insert(*first)) {
                continue;
            }
            let axis = edge.axis as usize;
            let line = edge.parameters(0.0);
            let is_on = |at: DVec3| (0..3).all(|n| n == axis || at[n] == line[n]);
            let mut vertices: Vec<usize> =
                stretch.vertices.clone().filter(|&vertex| is_on(painted.parameters[vertex])).collect();
            let place = |vertex: usize| painted.parameters[vertex][axis];
            vertices.sort_by(|&a, &b| place(a).total_cmp(&place(b)));
            let start = boundary.points.len();
            boundary.points.extend(vertices.iter().map(|&vertex| painted.positions[vertex]));
            boundary.edges.push((stretch.cell, edge, users.len(), start..boundary.points.len()));
        }
        let Some((cell, numbers)) = body.cell(stretch.cell).zip(sharing.points(stretch.cell)) else {
            return;
        };
        for corner in Corner::all().into_iter().filter(|corner| corner.faces().contains(&face)) {
            let users = sharing.at_corner(numbers[corner.coefficient()]);
            if users.first().is_some_and(|first| self.corners.insert(*first)) {
                let position = cell.net().0[corner.coefficient()];
                boundary.corners.push((stretch.cell, corner, users.len(), position));
            }
        }
    }
}

/// Adds what the vertices of a stretch hold.
fn paint(painted: &mut Painted, known: &KnownBody, cell: &Cell, stretch: &Stretch) {
    let first = painted.fractions.len();
    let materials = cell.materials();
    for vertex in stretch.vertices.clone() {
        painted.cells.push(stretch.cell.0);
        let [u, v, w] = painted.parameters[vertex].to_array().map(cubic);
        let across: [f64; 16] = std::array::from_fn(|n| v[n / 4] * w[n % 4]);
        for list in cell.fractions() {
            let layer = |n: usize| -> f64 {
                list[16 * n..16 * n + 16]
                    .iter()
                    .zip(&across)
                    .map(|(fraction, weight)| fraction * weight)
                    .sum()
            };
            let value: f64 = (0..4).map(|n| u[n] * layer(n)).sum();
            painted.fractions.push(value.clamp(0.0, 1.0));
        }
    }
    for mix in painted.fractions[first..].chunks_exact(materials.max(1)) {
        let color = mix_fractions(known.colors(), mix).to_color();
        painted.colors.extend([color.r, color.g, color.b, u8::MAX]);
    }
}
