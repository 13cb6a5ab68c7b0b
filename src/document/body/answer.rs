//! Answers to questions about a body.

use super::{Checks, KnownSurface, Painted, Renewal, Summary};
use crate::hyperpatch::composite::{Body, CellId, Contact, FaceContinuity, Relation, Sharing};
use crate::hyperpatch::operation::Neighbourhood;
use crate::hyperpatch::validity::Report;
use crate::hyperpatch::{Corner, Edge, Face, Grid};
use glam::DVec3;
use std::rc::Rc;

/// An answer to a [question](super::BodyAsk).
#[derive(Debug, Clone)]
pub enum Answer {
    /// The cells in their order.
    Cells(Vec<CellRow>),
    /// What would move: cells, places in their lists of 64, and shares of the displacement.
    Moves(Vec<(CellId, usize, f64)>),
    /// What there is round a corner.
    Neighbourhood(Box<Neighbourhood>),
    /// The checks of the cells that an operation made.
    Checks(Box<Checks>),
    /// The cells as they would be written out.
    CellsDocument,
    /// What a cell holds at parameters.
    Sample(Sample),
    /// What is known of each cell, in their order.
    Verdicts(Vec<(CellId, Report)>),
    /// What is to be said about the body.
    Summary(Box<Summary>),
    /// Volumes.
    Amounts {
        /// Volume of all cells.
        volume: f64,
        /// Volume of each material.
        amounts: Vec<f64>,
    },
    /// What a plane cuts out, with its area.
    Section(Box<Painted>, f64),
    /// The boundary in triangles with its edges and corners, and what of it differs from an earlier one.
    Surface(Rc<KnownSurface>, Option<Renewal>),
    /// What the body holds at a point, if it lies in it.
    Probe(Option<Sample>),
    /// Every pair of cells that is not disjoint.
    Relations(Vec<([CellId; 2], Relation)>),
    /// How cells continue each other, across the faces that they share and where they share corners alone.
    Continuity(Vec<FaceContinuity>, Vec<Contact>),
    /// What cells share.
    Sharing(Box<Parts>),
    /// x, y, z and the fraction of each material on a grid; w runs fastest.
    Grid(Box<Grid>),
    /// The bytes of a file.
    File(Vec<u8>),
}

/// A cell in short.
#[derive(Debug, Clone)]
pub struct CellRow {
    /// The cell.
    pub cell: CellId,
    /// Its corners.
    pub corners: [DVec3; 8],
    /// How regular it is, from -1 to 1.
    pub margin: f64,
    /// Its volume; negative where it is mirrored.
    pub volume: f64,
}

/// What a cell holds at a place.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// The cell.
    pub cell: CellId,
    /// Parameters.
    pub at: DVec3,
    /// The point.
    pub position: DVec3,
    /// Fraction of each material.
    pub mix: Vec<f64>,
}

impl Sample {
    /// The place in a cell, or `None` when the body does not have it.
    #[must_use]
    pub fn new(body: &Body, cell: CellId, at: DVec3) -> Option<Self> {
        let found = body.cell(cell)?;
        Some(Self { cell, at, position: found.point(at), mix: found.composition(at).fractions().to_vec() })
    }
}

/// Parts of cells of one kind, each with every cell that has it.
#[derive(Debug, Clone)]
pub struct SharedParts<P> {
    /// The cells of all parts, one part after the other.
    pub users: Vec<(CellId, P)>,
    /// Number of cells of each part.
    pub counts: Vec<usize>,
}

/// All corners, edges and faces of a body.
#[derive(Debug, Clone)]
pub struct Parts {
    /// Corners.
    pub corners: SharedParts<Corner>,
    /// Positions of the corners.
    pub positions: Vec<DVec3>,
    /// Edges.
    pub edges: SharedParts<Edge>,
    /// Faces.
    pub faces: SharedParts<Face>,
}

impl Parts {
    /// Collects the parts, in the order of the first cell that has each.
    #[must_use]
    pub fn new(body: &Body, sharing: &Sharing) -> Self {
        let corner = |id, corner: Corner| {
            sharing.points(id).map_or(&[][..], |numbers| sharing.at_corner(numbers[corner.coefficient()]))
        };
        let corners = collected(body, &Corner::all(), corner);
        let mut first = 0;
        let positions = corners.counts.iter().filter_map(|count| {
            let (id, corner) = corners.users[first];
            first += count;
            body.cell(id).map(|cell| cell.net().0[corner.coefficient()])
        });
        Self {
            positions: positions.collect(),
            corners,
            edges: collected(body, &Edge::all(), |id, edge| sharing.at_edge(id, edge)),
            faces: collected(body, &Face::all(), |id, face| sharing.at_face(id, face)),
        }
    }
}

fn collected<'a, P: Copy + PartialEq + 'a>(
    body: &Body,
    all: &[P],
    users: impl Fn(CellId, P) -> &'a [(CellId, P)],
) -> SharedParts<P> {
    let mut parts = SharedParts { users: Vec::new(), counts: Vec::new() };
    for (id, _) in body.cells() {
        for part in all {
            let here = users(*id, *part);
            if here.first() == Some(&(*id, *part)) {
                parts.users.extend_from_slice(here);
                parts.counts.push(here.len());
            }
        }
    }
    parts
}
