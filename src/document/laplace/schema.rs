//! The types of a document of a boundary value problem.

use super::super::MaterialSpec;
use crate::laplace::{LaplaceOptions, Method, Preconditioner, Space};
use glam::DVec3;
use serde::Serialize;

/// A document of a boundary value problem in memory, with all defaults filled in.
#[derive(Debug, Clone, PartialEq)]
pub struct LaplaceDocument {
    /// Title, at most 200 characters.
    pub title: String,
    /// Unit of length, for display only.
    pub unit: String,
    /// Two materials or more, whose fractions are solved for.
    pub materials: Vec<MaterialSpec>,
    /// The body by its boundary.
    pub model: BoundaryModel,
    /// Sets of elements with their conditions.
    pub groups: Vec<GroupSpec>,
    /// The condition of elements in no group.
    pub rest: Option<ConditionSpec>,
    /// How the equations are solved.
    pub options: LaplaceOptions,
    /// A plane through a body in space, for display only.
    pub section: Option<SectionSpec>,
}

/// The boundary of a body.
#[derive(Debug, Clone, PartialEq)]
pub enum BoundaryModel {
    /// The unit cube: 12 triangles times the square of the divisions.
    Cube {
        /// Steps along each edge, 1 to 51.
        divisions: usize,
    },
    /// The unit cube with a strip of slivers round it.
    SliverCube {
        /// Steps along each edge, 2 to 50.
        divisions: usize,
        /// Width of the strip, 1e-8 to half of a step.
        width: f64,
    },
    /// The unit cube with a cavity.
    HollowBox {
        /// Steps along each edge, 1 to 36.
        divisions: usize,
        /// Thickness of the walls, 0.001 to 0.45.
        wall: f64,
    },
    /// The space between two spheres about the origin.
    Shell {
        /// Inner radius.
        inner: f64,
        /// Outer radius.
        outer: f64,
        /// How often the triangles of an icosahedron are divided into four, 0 to 4.
        level: usize,
    },
    /// A sphere about the origin.
    Sphere {
        /// Radius.
        radius: f64,
        /// How often the triangles of an icosahedron are divided into four, 0 to 5.
        level: usize,
    },
    /// A mug without a handle, with its radius 1 and its height 2.
    Mug {
        /// Steps round it, 6 to 120.
        sectors: usize,
        /// Width of the strips of slivers inside and outside, 0 without them.
        sliver: f64,
    },
    /// A cylinder about the z axis with radius and height 1.
    Cylinder {
        /// Steps along both, 2 to 29.
        divisions: usize,
    },
    /// A block 2 by 1 by 1 about the origin whose ends along x are paraboloids.
    FilletBlock {
        /// Steps along each short edge, 1 to 40.
        divisions: usize,
    },
    /// The unit square.
    Square {
        /// Steps along each side, 1 to 8000.
        divisions: usize,
    },
    /// The space between two circles about the origin.
    Annulus {
        /// Inner radius.
        inner: f64,
        /// Outer radius.
        outer: f64,
        /// Segments outside, 6 to 20 000; half as many inside.
        segments: usize,
    },
    /// Triangles, counter-clockwise as seen from outside.
    Mesh {
        /// Where the vertices are.
        vertices: Vec<DVec3>,
        /// The vertices of each triangle.
        triangles: Vec<[u32; 3]>,
    },
}

impl BoundaryModel {
    /// Whether it lies in the plane or in space.
    #[must_use]
    pub fn space(&self) -> Space {
        match self {
            Self::Square { .. } | Self::Annulus { .. } => Space::Plane,
            _ => Space::Solid,
        }
    }
}

/// A set of elements with a condition.
#[derive(Debug, Clone, PartialEq)]
pub struct GroupSpec {
    /// Name for display.
    pub name: String,
    /// Which elements belong to it.
    pub selection: Selection,
    /// What is known on them.
    pub condition: ConditionSpec,
}

/// Which elements are meant: those for which everything that is given holds.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Selection {
    /// A direction, and by how many degrees the outward normal may differ from it.
    pub direction: Option<(DVec3, f64)>,
    /// Two opposite corners of a box that holds the centroid.
    pub bounds: Option<[DVec3; 2]>,
    /// An expression that is above 0 at the centroid.
    pub positive: Option<String>,
    /// First and last index of runs of elements.
    pub elements: Option<Vec<[usize; 2]>>,
}

/// What is known on elements.
#[derive(Debug, Clone, PartialEq)]
pub struct ConditionSpec {
    /// Whether the fractions are known; else their outward fluxes are.
    pub is_value: bool,
    /// For each material a number or an expression.
    pub data: Vec<Datum>,
}

/// A number, or how it follows from the place.
#[derive(Debug, Clone, PartialEq)]
pub enum Datum {
    /// The same everywhere.
    Number(f64),
    /// An expression in x, y, z and r, the distance to the z axis, in the plane to the origin.
    Text(String),
}

/// A plane through a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionSpec {
    /// A point of it.
    pub origin: DVec3,
    /// Its normal, of any length but 0.
    pub normal: DVec3,
}

/// How the equations are solved, as it is written.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct SolverSpec {
    /// `gmres` or `lu`.
    pub method: &'static str,
    /// `none`, `jacobi` or `ssor`; there with `gmres` alone, as all below but the last two.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub preconditioner: Option<&'static str>,
    /// Parameter of `ssor`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub omega: Option<f64>,
    /// Iterations after which GMRES starts anew.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub restart: Option<usize>,
    /// True residual over the right-hand side at which to stop.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// Most iterations.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_iterations: Option<usize>,
    /// Whether the condition number is estimated.
    pub condition: bool,
    /// Most elements whose matrix is kept.
    pub dense: usize,
}

impl From<LaplaceOptions> for SolverSpec {
    fn from(options: LaplaceOptions) -> Self {
        let LaplaceOptions { method, with_condition: condition, most_dense: dense } = options;
        let Method::Gmres(gmres) = method else {
            return Self {
                method: "lu",
                preconditioner: None,
                omega: None,
                restart: None,
                tolerance: None,
                max_iterations: None,
                condition,
                dense,
            };
        };
        let (preconditioner, omega) = match gmres.preconditioner {
            Preconditioner::None => ("none", None),
            Preconditioner::Jacobi => ("jacobi", None),
            Preconditioner::Ssor(omega) => ("ssor", Some(omega)),
        };
        Self {
            method: "gmres",
            preconditioner: Some(preconditioner),
            omega,
            restart: Some(gmres.restart),
            tolerance: Some(gmres.tolerance),
            max_iterations: Some(gmres.most_iterations),
            condition,
            dense,
        }
    }
}
