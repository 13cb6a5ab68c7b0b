//! Questions about a body, as they arrive in JSON.

use super::super::hyperpatch::names;
use super::super::node::Node;
use super::super::{Code, DocumentError, HyperpatchModel, Json};
use crate::hyperpatch::composite::CellId;
use crate::hyperpatch::operation::Reach;
use crate::hyperpatch::{Corner, FINEST_SECTION, LARGEST_COORDINATE, LARGEST_GRID, Plane, flat};
use crate::solid::Format;
use glam::DVec3;

/// Steps of a section along each axis of a cell that is not told another number.
const STEPS: usize = 8;

/// Most points of a grid: 128 x 128 x 128.
const MOST_POINTS: usize = 1 << 21;

/// A file of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BodyFormat {
    /// Of its boundary surface.
    Surface(Format),
    /// Of its cells: an unstructured grid of VTK.
    Vtk,
}

/// A question about a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BodyAsk {
    /// Every cell with its corners, its margin and its volume.
    Cells,
    /// What would move with a coefficient.
    Moves {
        /// The cell.
        cell: CellId,
        /// Place of the coefficient in the list of 64.
        at: usize,
        /// How far the move reaches.
        reach: Reach,
    },
    /// The cells and coefficients round a corner.
    Neighbourhood {
        /// A cell with the corner.
        cell: CellId,
        /// The corner.
        corner: Corner,
    },
    /// The checks of the cells that an operation made.
    Checks {
        /// Its place in the list.
        place: usize,
    },
    /// The body as a document of one operation.
    CellsDocument,
    /// Position and composition at parameters of a cell.
    Sample {
        /// The cell.
        cell: CellId,
        /// Its parameters.
        at: DVec3,
    },
    /// The verdict on each cell.
    Verdicts {
        /// Whether every check runs to its end.
        is_global: bool,
    },
    /// What is to be said about the body as a whole.
    Summary,
    /// Volume of each material.
    Amounts,
    /// What a plane cuts out.
    Section {
        /// The plane.
        plane: Plane,
        /// Lattice steps along each axis of a cell.
        steps: usize,
    },
    /// The boundary.
    Surface {
        /// Chord tolerance; without one a thousandth of the size of the body.
        tolerance: Option<f64>,
        /// Whether the faces between cells follow, once for each cell.
        has_inner: bool,
        /// The number of an earlier surface, of which only differences are wanted.
        since: Option<u32>,
    },
    /// Cell, parameters and composition at a point.
    Probe(DVec3),
    /// How every two cells lie to each other.
    Relations,
    /// How cells continue each other.
    Continuity,
    /// Corners, edges and faces with the cells that have them.
    Sharing,
    /// Points and compositions on a grid of parameters of a cell.
    Grid {
        /// The cell.
        cell: CellId,
        /// Points along u, v and w.
        counts: [usize; 3],
    },
    /// A file.
    File {
        /// Its format.
        format: BodyFormat,
        /// Chord tolerance of a surface, as above.
        tolerance: Option<f64>,
    },
}

impl BodyAsk {
    /// Reads a question by its name with what belongs to it.
    ///
    /// # Errors
    /// The first thing that is wrong, with its path: such as `options.tolerance`, `cell` or `point`.
    pub fn read(name: &str, rest: &Json, model: &HyperpatchModel) -> Result<Self, DocumentError> {
        let root = Node::root(rest, "");
        let options = root.get("options")?;
        let known = |fields: &[&str]| options.as_ref().map_or(Ok(()), |options| options.only(fields));
        let tolerance = || {
            let node = options.as_ref().map_or(Ok(None), |options| options.get("tolerance"))?;
            node.map(|node| tolerance(&node)).transpose()
        };
        Ok(match name {
            "cells" | "body" => Self::Cells,
            "moves" => {
                let [i, j, k] = names::coefficient(&root.need("at")?)?;
                let reach = root.get("reach")?.map_or(Ok(Reach::Block), |node| names::reach(&node))?;
                Self::Moves { cell: cell(&root, model)?, at: flat(i, j, k), reach }
            }
            "neighbourhood" => {
                let corner = names::corner(&root.need("corner")?)?;
                Self::Neighbourhood { cell: cell(&root, model)?, corner }
            }
            "checks" => {
                let node = root.need("operation")?;
                let id = node.count()?;
                let place = model.stages().iter().position(|stage| stage.row().id as usize == id);
                Self::Checks {
                    place: place.ok_or_else(|| {
                        let message = format!("{id} was found; expected the number of an operation");
                        node.error(Code::Range, message)
                    })?,
                }
            }
            "cellsDocument" => Self::CellsDocument,
            "sample" => Self::Sample { cell: cell(&root, model)?, at: triple(&root.need("at")?, 0.0, 1.0)? },
            "verdicts" => {
                known(&["global"])?;
                let node = options.as_ref().map_or(Ok(None), |options| options.get("global"))?;
                Self::Verdicts { is_global: node.map_or(Ok(true), |node| node.flag())? }
            }
            "summary" => Self::Summary,
            "amounts" => Self::Amounts,
            "section" => {
                let options = root.need("options")?;
                options.only(&["normal", "offset", "point", "steps"])?;
                Self::Section {
                    plane: plane(&options)?,
                    steps: options
                        .get("steps")?
                        .map_or(Ok(STEPS), |node| node.count_within(1..=FINEST_SECTION))?,
                }
            }
            "surface" => {
                known(&["tolerance", "faces", "since"])?;
                let option = |name| options.as_ref().map_or(Ok(None), |options| options.get(name));
                let faces = option("faces")?;
                let has_inner = faces.map_or(Ok(0), |node| node.choice(&["outer", "all"]))? == 1;
                let since = option("since")?.map(|node| node.count()).transpose()?;
                // What is no number of a surface is that of one that is not known.
                let since = since.map(|id| u32::try_from(id).unwrap_or(0));
                Self::Surface { tolerance: tolerance()?, has_inner, since }
            }
            "probe" => Self::Probe(triple(&root.need("point")?, -LARGEST_COORDINATE, LARGEST_COORDINATE)?),
            "relations" => Self::Relations,
            "continuity" => Self::Continuity,
            "sharing" => Self::Sharing,
            "grid" => Self::Grid { cell: cell(&root, model)?, counts: counts(&root.need("counts")?)? },
            "file" => {
                let options = root.need("options")?;
                options.only(&["format", "tolerance"])?;
                let format = match options.need("format")?.choice(&["stl", "ply", "obj", "vtu"])? {
                    0 => BodyFormat::Surface(Format::Stl),
                    1 => BodyFormat::Surface(Format::Ply),
                    2 => BodyFormat::Surface(Format::Obj),
                    _ => BodyFormat::Vtk,
                };
                Self::File { format, tolerance: tolerance()? }
            }
            _ => return Err(root.error(Code::Range, format!("\"{name}\" is no question about a body"))),
        })
    }
}

/// The identifier of a cell that is there.
fn cell(root: &Node<'_>, model: &HyperpatchModel) -> Result<CellId, DocumentError> {
    let node = root.need("cell")?;
    let number = node.count()?;
    let id = u32::try_from(number).map(CellId).ok().filter(|id| model.body().cell(*id).is_some());
    id.ok_or_else(|| {
        node.error(Code::Range, format!("{number} was found; expected the number of a cell of the body"))
    })
}

fn triple(node: &Node<'_>, low: f64, high: f64) -> Result<DVec3, DocumentError> {
    node.triple(low..=high).map(DVec3::from_array)
}

/// Numbers of points along three axes.
fn counts(list: &Node<'_>) -> Result<[usize; 3], DocumentError> {
    let items = list.items()?;
    list.check_count(items.len(), " numbers", 3..=3)?;
    let mut counts = [0; 3];
    for (count, item) in counts.iter_mut().zip(&items) {
        *count = item.count_within(2..=LARGEST_GRID)?;
    }
    list.check_count(counts.iter().product(), " points", 8..=MOST_POINTS)?;
    Ok(counts)
}

fn tolerance(node: &Node<'_>) -> Result<f64, DocumentError> {
    let value = node.number()?;
    if value > 0.0 {
        return Ok(value);
    }
    Err(node.error(Code::Range, format!("{value} was found; expected a number above 0")))
}

/// A plane by its normal and either its offset or one of its points; through the origin without either.
fn plane(options: &Node<'_>) -> Result<Plane, DocumentError> {
    let node = options.need("normal")?;
    let normal = triple(&node, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
    let (offset, point) = (options.get("offset")?, options.get("point")?);
    let made = match (&offset, &point) {
        (Some(offset), Some(_)) => {
            return Err(
                offset.error(Code::Range, "expected either an offset or a point, not both".to_owned())
            );
        }
        (Some(offset), None) => Plane::new(normal, offset.number()?),
        (None, Some(point)) => {
            Plane::through(triple(point, -LARGEST_COORDINATE, LARGEST_COORDINATE)?, normal)
        }
        (None, None) => Plane::new(normal, 0.0),
    };
    made.map_err(|error| node.error(Code::Range, error.to_string()))
}
