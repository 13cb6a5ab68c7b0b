//! Answers to questions about bodies, as values of the host.
//!
//! What is many goes out as arrays of numbers, which `js/body.js` names.

use super::results::to_value;
use crate::document::{
    Answer, Boundary, CellRow, Checks, HyperpatchModel, KnownBody, Painted, Parts, Renewal, Sample,
    SharedParts, Stage, Stretch, Summary,
};
use crate::hyperpatch::composite::{CellId, Contact, FaceContinuity, Matching, Relation};
use crate::hyperpatch::operation::{JointState, Neighbour, Neighbourhood};
use crate::hyperpatch::validity::{Report, Witness};
use crate::hyperpatch::{Axis, Corner, Edge, Face};
use glam::DVec3;
use js_sys::{Array, Float32Array, Float64Array, Object, Reflect, Uint8Array, Uint32Array};
use std::ops::Range;
use std::rc::Rc;
use wasm_bindgen::prelude::JsValue;

/// An answer as a value of the host.
pub(super) fn written(answer: &Answer, known: &KnownBody) -> Result<JsValue, JsValue> {
    let bag = Bag::new();
    match answer {
        Answer::Cells(rows) => {
            cells(&bag, rows)?;
            operations(&bag, known.model().stages())?;
        }
        Answer::Moves(list) => {
            let rows = list.iter().flat_map(|(id, at, share)| [f64::from(id.0), *at as f64, *share]);
            bag.doubles("moves", &rows.collect::<Vec<_>>())?;
        }
        Answer::CellsDocument => coefficients(&bag, known.model())?,
        Answer::Neighbourhood(found) => around(&bag, found)?,
        Answer::Checks(checks) => checked(&bag, known, checks)?,
        Answer::Sample(sample) => return found(sample),
        Answer::Probe(sample) => return sample.as_ref().map_or(Ok(JsValue::NULL), found),
        Answer::Verdicts(reports) => verdicts(&bag, known, reports)?,
        Answer::Summary(summary) => summed(&bag, known, summary)?,
        Answer::Amounts { volume, amounts } => {
            bag.number("volume", *volume)?;
            bag.doubles("amounts", amounts)?;
        }
        Answer::Section(painted, area) => {
            drawn(&bag, painted, known.model().materials().len(), None)?;
            bag.set("outline", Uint32Array::from(painted.outlines.as_flattened()).into())?;
            bag.number("area", *area)?;
        }
        Answer::Surface(surface, renewal) => {
            let stretches = renewal.as_ref().map(|renewal| &renewal.stretches[..]);
            drawn(&bag, &surface.painted, known.model().materials().len(), stretches)?;
            bag.number("deviation", surface.painted.deviation)?;
            bag.number("id", f64::from(surface.id))?;
            if let Some(renewal) = renewal {
                bag.number("since", f64::from(renewal.since))?;
            }
            edges(&bag, &surface.boundary, renewal.as_ref())?;
        }
        Answer::Relations(relations) => bag.doubles("relations", &related(relations))?,
        Answer::Continuity(faces, contacts) => {
            bag.doubles("faces", &faces.iter().flat_map(continued).collect::<Vec<_>>())?;
            bag.doubles("contacts", &contacts.iter().flat_map(contact).collect::<Vec<_>>())?;
        }
        Answer::Sharing(parts) => shared(&bag, parts)?,
        Answer::Grid(found) => grid(&bag, found.components())?,
        Answer::File(bytes) => return Ok(Uint8Array::from(bytes.as_slice()).into()),
    }
    Ok(bag.0.into())
}

/// An object that is filled.
struct Bag(Object);

impl Bag {
    fn new() -> Self {
        Self(Object::new())
    }

    fn set(&self, name: &str, value: JsValue) -> Result<(), JsValue> {
        Reflect::set(&self.0, &name.into(), &value).map(|_| ())
    }

    fn number(&self, name: &str, value: f64) -> Result<(), JsValue> {
        self.set(name, value.into())
    }

    fn floats(&self, name: &str, values: &[f32]) -> Result<(), JsValue> {
        self.set(name, Float32Array::from(values).into())
    }

    fn doubles(&self, name: &str, values: &[f64]) -> Result<(), JsValue> {
        self.set(name, Float64Array::from(values).into())
    }

    fn counts(&self, name: &str, values: &[u32]) -> Result<(), JsValue> {
        self.set(name, Uint32Array::from(values).into())
    }
}

fn numbers(points: &[DVec3]) -> Vec<f32> {
    points.iter().flat_map(|point| point.as_vec3().to_array()).collect()
}

fn cells(bag: &Bag, rows: &[CellRow]) -> Result<(), JsValue> {
    bag.counts("ids", &rows.iter().map(|row| row.cell.0).collect::<Vec<_>>())?;
    let corners: Vec<f64> = rows.iter().flat_map(|row| row.corners).flat_map(|p| p.to_array()).collect();
    bag.doubles("corners", &corners)?;
    bag.doubles("margins", &rows.iter().map(|row| row.margin).collect::<Vec<_>>())?;
    bag.doubles("volumes", &rows.iter().map(|row| row.volume).collect::<Vec<_>>())
}

/// Of each operation: its number, its place in the list of names, whether it applies, and how many cells it touched, made and removed; these
/// cells one after the other; and why those that do not apply do not.
fn operations(bag: &Bag, stages: &[Rc<Stage>]) -> Result<(), JsValue> {
    let (mut rows, mut ids, reasons) = (Vec::with_capacity(6 * stages.len()), Vec::new(), Array::new());
    for row in stages.iter().map(|stage| stage.row()) {
        let lists = [&row.touched, &row.made, &row.removed];
        rows.extend([row.id, row.op as u32, u32::from(row.reason.is_none())]);
        rows.extend(lists.map(|list| list.len() as u32));
        ids.extend(lists.into_iter().flatten().map(|id| id.0));
        if let Some(reason) = &row.reason {
            reasons.push(&reason.into());
        }
    }
    bag.counts("operations", &rows)?;
    bag.counts("operationCells", &ids)?;
    bag.set("reasons", reasons.into())
}

/// The cells with their corners; whether they lie in a grid; of each point whether its offset is known, that, whether materials jump there and how many
/// coefficients it is, with the cells and places of these one after the other; and the joints.
fn around(bag: &Bag, found: &Neighbourhood) -> Result<(), JsValue> {
    let cells = found.cells.iter().flat_map(|(id, corner)| [id.0, corner_number(*corner)]);
    bag.counts("cells", &cells.collect::<Vec<_>>())?;
    bag.set("regular", found.is_regular.into())?;
    let point = |point: &Neighbour| {
        let [a, b, c] = point.offset.unwrap_or_default().map(f64::from);
        let [x, y, z] = point.position.to_array();
        let flags = [point.offset.is_some(), point.jumps].map(|flag| f64::from(u8::from(flag)));
        [flags[0], a, b, c, x, y, z, flags[1], point.users.len() as f64]
    };
    bag.doubles("points", &found.points.iter().flat_map(point).collect::<Vec<_>>())?;
    let mixes = found.points.iter().flat_map(|point| point.mix.fractions());
    bag.doubles("mixes", &mixes.copied().collect::<Vec<_>>())?;
    let users = found.points.iter().flat_map(|point| &point.users);
    bag.counts("users", &users.flat_map(|(id, at)| [id.0, *at as u32]).collect::<Vec<_>>())?;
    let joint = |joint: &JointState| {
        let [a, b] =
            joint.sides.map(|side| [side.cell.0, face_number(side.face()), corner_number(side.corner)]);
        let marks = [joint.is_shape_marked, joint.is_material_marked].map(u32::from);
        [a[0], a[1], a[2], b[0], b[1], b[2], joint.shape as u32, joint.material as u32, marks[0], marks[1]]
    };
    bag.counts("joints", &found.joints.iter().flat_map(joint).collect::<Vec<_>>())
}

fn checked(bag: &Bag, known: &KnownBody, checks: &Checks) -> Result<(), JsValue> {
    bag.counts("cells", &checks.cells.iter().map(|id| id.0).collect::<Vec<_>>())?;
    verdicts(bag, known, &checks.doubtful)?;
    bag.doubles("relations", &related(&checks.meetings))?;
    let counts = [checks.faces, checks.corners, checks.smooth_shape, checks.smooth_material];
    bag.counts("counts", &counts.map(|count| count as u32))
}

/// Title, unit and materials, and positions and fractions of all coefficients.
fn coefficients(bag: &Bag, model: &HyperpatchModel) -> Result<(), JsValue> {
    let head = &model.document().head;
    bag.set("title", head.title.as_str().into())?;
    bag.set("unit", head.unit.as_str().into())?;
    bag.set("materials", to_value(&head.materials)?)?;
    let cells = model.body().cells();
    let points = cells.iter().flat_map(|(_, cell)| cell.net().0).flat_map(|point| point.to_array());
    bag.doubles("positions", &points.collect::<Vec<_>>())?;
    let mixes = cells.iter().flat_map(|(_, cell)| {
        (0..64).flat_map(move |at| cell.fractions().iter().map(move |fractions| fractions[at]))
    });
    bag.doubles("mixes", &mixes.collect::<Vec<_>>())
}

fn found(sample: &Sample) -> Result<JsValue, JsValue> {
    let bag = Bag::new();
    let list = |values: &[f64]| values.iter().map(|value| JsValue::from(*value)).collect::<Array>();
    bag.number("cell", f64::from(sample.cell.0))?;
    bag.set("uvw", list(&sample.at.to_array()).into())?;
    bag.set("position", list(&sample.position.to_array()).into())?;
    bag.set("mix", list(&sample.mix).into())?;
    Ok(bag.0.into())
}

/// Of each cell: number, verdict, whether mirrored, margin, least determinant found and proven, kind of the witness, its parameters (two
/// places), the determinant there, the point.
fn verdicts(bag: &Bag, known: &KnownBody, reports: &[(CellId, Report)]) -> Result<(), JsValue> {
    let list: Vec<f64> = reports.iter().flat_map(|(id, report)| judged(known, *id, report)).collect();
    bag.doubles("verdicts", &list)
}

fn judged(known: &KnownBody, id: CellId, report: &Report) -> [f64; 17] {
    let (kind, first, second, jacobian) = match report.witness {
        None => (0.0, DVec3::ZERO, DVec3::ZERO, 0.0),
        Some(Witness::Folded { at, jacobian }) => (1.0, at, at, jacobian),
        Some(Witness::Meeting { first, second }) => (2.0, first, second, 0.0),
    };
    let point = known.model().body().cell(id).map_or(DVec3::ZERO, |cell| cell.point(first));
    [
        f64::from(id.0),
        report.verdict as usize as f64,
        f64::from(u8::from(report.is_mirrored)),
        report.margin,
        known.least_determinant(id, report),
        report.certificate.lower,
        kind,
        first.x,
        first.y,
        first.z,
        second.x,
        second.y,
        second.z,
        jacobian,
        point.x,
        point.y,
        point.z,
    ]
}

fn summed(bag: &Bag, known: &KnownBody, summary: &Summary) -> Result<(), JsValue> {
    let counts = summary.verdicts.map(|count| count as u32);
    bag.counts("counts", &counts)?;
    bag.number("mirrored", summary.mirrored as f64)?;
    bag.number("sharedFaces", summary.shared_faces as f64)?;
    bag.number("outerFaces", summary.outer_faces as f64)?;
    bag.number("sumError", summary.sum_error)?;
    bag.doubles("relations", &related(&summary.doubtful))?;
    verdicts(bag, known, summary.worst.as_slice())
}

/// Of each pair: the cells, the relation, numbers of shared faces, edges and corners, the point, parameters in both cells.
fn related(relations: &[([CellId; 2], Relation)]) -> Vec<f64> {
    let row = |(cells, relation): &([CellId; 2], Relation)| -> [f64; 15] {
        let mut row = [0.0; 15];
        row[..2].copy_from_slice(&cells.map(|id| f64::from(id.0)));
        match relation {
            Relation::Disjoint => {}
            Relation::Shares { faces, edges, corners } => {
                row[2..6].copy_from_slice(&[1.0, *faces as f64, *edges as f64, *corners as f64]);
            }
            Relation::Overlaps { point, at } => {
                row[2] = 2.0;
                row[6..9].copy_from_slice(&point.to_array());
                row[9..12].copy_from_slice(&at[0].to_array());
                row[12..].copy_from_slice(&at[1].to_array());
            }
            Relation::Touches { at } => {
                row[2] = 3.0;
                row[9..12].copy_from_slice(&at.to_array());
            }
            Relation::Unproven => row[2] = 4.0,
        }
        row
    };
    relations.iter().flat_map(row).collect()
}

/// What a section and a surface have in common, of all stretches or of some.
fn drawn(bag: &Bag, painted: &Painted, materials: usize, chosen: Option<&[usize]>) -> Result<(), JsValue> {
    let all: Vec<usize>;
    let chosen = match chosen {
        Some(chosen) => chosen,
        None => {
            all = (0..painted.stretches.len()).collect();
            &all
        }
    };
    let stretches = || chosen.iter().map(|n| &painted.stretches[*n]);
    let vertices = || stretches().map(|stretch| stretch.vertices.clone());
    let points =
        |list: &[DVec3]| -> Vec<f32> { vertices().flat_map(|range| numbers(&list[range])).collect() };
    bag.floats("positions", &points(&painted.positions))?;
    bag.floats("parameters", &points(&painted.parameters))?;
    if !painted.normals.is_empty() {
        bag.floats("normals", &points(&painted.normals))?;
    }
    bag.counts("cells", &vertices().flat_map(|range| &painted.cells[range]).copied().collect::<Vec<_>>())?;
    let wide = |range: Range<usize>, width: usize| range.start * width..range.end * width;
    let fractions = vertices().flat_map(|range| &painted.fractions[wide(range, materials)]);
    bag.floats("fractions", &fractions.map(|&part| part as f32).collect::<Vec<_>>())?;
    let colors = vertices().flat_map(|range| &painted.colors[wide(range, 4)]).copied();
    bag.set("colors", Uint8Array::from(colors.collect::<Vec<_>>().as_slice()).into())?;
    let triangles = stretches().flat_map(|stretch| &painted.triangles[stretch.triangles.clone()]);
    bag.counts("indices", &triangles.flatten().copied().collect::<Vec<_>>())?;
    bag.counts("patches", &stretches().flat_map(stretch).collect::<Vec<_>>())
}

/// Cell, face, and where vertices, indices and indices of outlines start and how many there are.
fn stretch(stretch: &Stretch) -> [u32; 8] {
    let [a, b] = range(&stretch.vertices, 1);
    let [c, d] = range(&stretch.triangles, 3);
    let [e, f] = range(&stretch.outlines, 2);
    [stretch.cell.0, stretch.face.map_or(0, face_number), a, b, c, d, e, f]
}

fn range(range: &Range<usize>, times: usize) -> [u32; 2] {
    [range.start, range.len()].map(|count| (count * times) as u32)
}

fn face_number(face: Face) -> u32 {
    2 * face.axis as u32 + u32::from(face.is_end)
}

fn edge_number(edge: Edge) -> u32 {
    4 * edge.axis as u32 + 2 * u32::from(edge.ends[0]) + u32::from(edge.ends[1])
}

fn corner_number(corner: Corner) -> u32 {
    corner.0.iter().fold(0, |number, &is_end| 2 * number + u32::from(is_end))
}

/// Boundary curves: place in the list of all, cell, edge, number of cells, and where its points start and how many there are. Corners: place,
/// cell, corner, number of cells. Points of the curves and corners that are listed come one after the other.
fn edges(bag: &Bag, boundary: &Boundary, renewal: Option<&Renewal>) -> Result<(), JsValue> {
    let chosen =
        |some: Option<&Vec<usize>>, count: usize| some.cloned().unwrap_or_else(|| (0..count).collect());
    let curves = chosen(renewal.map(|renewal| &renewal.edges), boundary.edges.len());
    let edge = |n: usize| {
        let (cell, edge, users, points) = &boundary.edges[n];
        let (edge, users) = (edge_number(*edge), *users as u32);
        [n as u32, cell.0, edge, users, points.start as u32, points.len() as u32]
    };
    let points = curves.iter().flat_map(|n| numbers(&boundary.points[boundary.edges[*n].3.clone()]));
    bag.floats("edgePositions", &points.collect::<Vec<_>>())?;
    bag.counts("edges", &curves.iter().flat_map(|n| edge(*n)).collect::<Vec<_>>())?;
    let corners = chosen(renewal.map(|renewal| &renewal.corners), boundary.corners.len());
    let corner = |n: usize| {
        let (cell, corner, users, _) = &boundary.corners[n];
        [n as u32, cell.0, corner_number(*corner), *users as u32]
    };
    bag.counts("corners", &corners.iter().flat_map(|n| corner(*n)).collect::<Vec<_>>())?;
    let positions = corners.iter().flat_map(|n| boundary.corners[*n].3.to_array());
    bag.doubles("cornerPositions", &positions.collect::<Vec<_>>())
}

fn side((cell, face): (CellId, Face)) -> [f64; 2] {
    [f64::from(cell.0), f64::from(face_number(face))]
}

fn matched(matching: Matching) -> f64 {
    let [a, b] = matching.is_reversed.map(u8::from);
    f64::from(4 * u8::from(matching.is_swapped) + 2 * a + b)
}

/// Both cells with their faces, how these lie on each other, continuity of shape and of material, and the four corners with theirs.
fn continued(found: &FaceContinuity) -> Vec<f64> {
    let mut row: Vec<f64> = found.face.sides.into_iter().flat_map(side).collect();
    row.extend([matched(found.face.matching), found.shape as usize as f64, found.material as usize as f64]);
    for corner in found.corners {
        row.push(f64::from(corner_number(corner.corner)));
        row.extend([corner.shape as usize as f64, corner.material as usize as f64]);
    }
    row
}

/// Both cells with their faces, how these lie on each other, the gap, and which corners of the first cell are common, by bits.
fn contact(found: &Contact) -> Vec<f64> {
    let mut row: Vec<f64> = found.sides.into_iter().flat_map(side).collect();
    let bits = found.corners.iter().fold(0, |bits, corner| bits | 1_u32 << corner_number(*corner));
    row.extend([matched(found.matching), found.gap, f64::from(bits)]);
    row
}

fn shared(bag: &Bag, parts: &Parts) -> Result<(), JsValue> {
    listed(bag, "corner", &parts.corners, corner_number)?;
    listed(bag, "edge", &parts.edges, edge_number)?;
    listed(bag, "face", &parts.faces, face_number)?;
    let positions: Vec<f64> = parts.positions.iter().flat_map(DVec3::to_array).collect();
    bag.doubles("positions", &positions)
}

/// Numbers of cells of each part, and these cells each with the number of the part in it.
fn listed<P: Copy>(
    bag: &Bag,
    name: &str,
    parts: &SharedParts<P>,
    number: fn(P) -> u32,
) -> Result<(), JsValue> {
    bag.counts(
        &format!("{name}Counts"),
        &parts.counts.iter().map(|count| *count as u32).collect::<Vec<_>>(),
    )?;
    bag.counts(
        &format!("{name}Users"),
        &parts.users.iter().flat_map(|(id, part)| [id.0, number(*part)]).collect::<Vec<_>>(),
    )
}

/// Positions as they stand one after the other, and a column for each material.
fn grid(bag: &Bag, components: &[Vec<f32>]) -> Result<(), JsValue> {
    let (places, fractions) = components.split_at(3.min(components.len()));
    let names = Axis::ALL.map(|axis| ["x", "y", "z"][axis as usize]);
    for (name, column) in names.into_iter().zip(places) {
        bag.floats(name, column)?;
    }
    let columns = fractions.iter().map(|column| Float32Array::from(column.as_slice())).collect::<Array>();
    bag.set("fractions", columns.into())
}
