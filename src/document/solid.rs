//! The ruled surface of a document in space, and the solid that it encloses.

use super::space::Space;
use super::{Code, DocumentError, Solution};
use crate::geom::ShownPlace;
use crate::material::Color;
use crate::solid::{FileJob, Format, Labels, Mesh};
use glam::{DVec2, DVec3};
use std::fmt;

/// The ruled surface of a document in space.
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    /// The triangles; closed by caps where that was asked for and the curves are closed.
    pub mesh: Mesh,
    /// Colour of each vertex.
    pub colors: Vec<Color>,
    /// Least and greatest number on the map of colours, where they are one.
    pub range: Option<(f64, f64)>,
    /// The ruling lines of the matching.
    pub rulings: Vec<[DVec3; 2]>,
    /// In-between curves j = 0 to M from the first curve on, polylines over all rulings.
    pub stages: Vec<Vec<DVec3>>,
    /// The curves, as polylines.
    pub curves: Vec<Vec<DVec3>>,
    /// Whether the curves are closed.
    pub is_closed: bool,
    /// Whether the mesh is not to be watertight: of open curves, or without caps.
    pub may_be_open: bool,
    /// Whether the mesh is watertight.
    pub is_watertight: bool,
    /// Volume inside, of a watertight mesh.
    pub volume: Option<f64>,
    /// Area of all triangles.
    pub area: f64,
    /// What there is to say of the solid.
    pub remarks: Vec<SolidRemark>,
}

/// Something about a solid that a person should know, or why there is none.
#[derive(Debug, Clone, PartialEq)]
pub enum SolidRemark {
    /// The curves lie in one plane, so that there is no solid.
    Flat {
        /// Its height, of plane curves.
        height: Option<f64>,
    },
    /// The curves are open, so that there is a surface but no solid.
    OpenSheet,
    /// The rim at a curve meets itself, so that it has no cap.
    Uncapped {
        /// Number of the curve.
        curve: usize,
        /// Where it meets itself, in the plane.
        at: Option<DVec2>,
    },
    /// The 32 bits in which vertices are stored do not hold them apart, or change the shape.
    Rounded,
}

impl SolidRemark {
    /// Name of the kind, stable across releases.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Flat { .. } => "flat",
            Self::OpenSheet => "open-sheet",
            Self::Uncapped { .. } => "uncapped",
            Self::Rounded => "rounded",
        }
    }
}

impl fmt::Display for SolidRemark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flat { height: None } => {
                write!(
                    f,
                    "a solid needs curves that do not lie in one plane; give the points of one of them another z"
                )
            }
            Self::Flat { height: Some(height) } => write!(
                f,
                "a solid needs curves at different heights, and both are at {height}; give one of them another `height`"
            ),
            Self::OpenSheet => {
                write!(
                    f,
                    "between open curves the surface is a sheet, which has no caps and encloses nothing"
                )
            }
            Self::Uncapped { curve, at } => {
                write!(f, "the rim at curve {curve} meets itself")?;
                at.iter().try_for_each(|at| write!(f, " near {}", ShownPlace(*at)))?;
                write!(f, ", so that it has no cap; take more lines")
            }
            Self::Rounded => write!(
                f,
                "vertices are stored in 32 bits, which are too few for this shape at this place; move the curves nearer to the origin, or their heights farther apart"
            ),
        }
    }
}

impl Solid {
    /// Tells whether the mesh is what it is to be: watertight, unless it may be open, and hardly changed by being stored in 32 bits.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        let is_rounded = self.remarks.contains(&SolidRemark::Rounded);
        (self.is_watertight || self.may_be_open) && !is_rounded
    }

    /// Begins a file of the solid of a solution.
    #[must_use]
    pub fn into_file(self, format: Format, solution: &Solution) -> FileJob {
        let document = solution.model.document();
        let labels = Labels {
            title: document.title.clone(),
            unit: document.unit.clone(),
            materials: document.materials.iter().map(|material| material.name.clone()).collect(),
        };
        FileJob::new(format, self.mesh, self.colors, &labels)
    }
}

/// Tells where both curves of a solution lie in one plane.
#[must_use]
pub fn flat(solution: &Solution) -> Option<SolidRemark> {
    let model = &solution.model;
    let height = model.document().curves.first()?.height;
    let is_flat = Space::of(model)?.is_flat();
    is_flat.then(|| SolidRemark::Flat { height: model.projection().is_none().then_some(height) })
}

/// Why a solution has no solid.
#[must_use]
pub fn why_no_solid(solution: &Solution) -> DocumentError {
    let flat = flat(solution);
    let path = match flat {
        None => "",
        Some(SolidRemark::Flat { height: None }) => "curves[1].points",
        Some(_) => "curves[1].height",
    };
    let model = &solution.model;
    if flat.is_none() && model.curves().len() > 2 && solution.is_complete() && model.projection().is_some() {
        let message =
            "a solid of more than two curves needs plane curves; give points x and y, and curves heights";
        return DocumentError::new(Code::NoSolid, "curves[0].points", message);
    }
    let reason = || solution.diagnostics.last().map(ToString::to_string);
    let message = flat.map(|flat| flat.to_string()).or_else(reason);
    let message = message.unwrap_or_else(|| "the matching is not complete".to_owned());
    DocumentError::new(Code::NoSolid, path, message)
}
