//! The types of a part document.

use super::super::{CurveForm, MaterialSpec};
use serde::Serialize;
use std::collections::BTreeMap;

/// A part document in memory, with all defaults filled in.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct PartDocument {
    /// Version of the format: 1.
    pub directrix: u32,
    /// Always `part`.
    pub kind: PartKind,
    /// Title, at most 200 characters.
    pub title: String,
    /// Unit of length, for display only.
    pub unit: String,
    /// Materials; a mix has one fraction for each.
    pub materials: Vec<MaterialSpec>,
    /// Reference geometry, by its names.
    pub shapes: Vec<ShapeSpec>,
    /// Bodies; a later one lies over an earlier one.
    pub bodies: Vec<BodySpec>,
    /// Design rules.
    pub rules: Vec<PartRuleSpec>,
}

/// The kind of a part document.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PartKind {
    /// Bodies with composition features.
    Part,
}

/// A shape with its name.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ShapeSpec {
    /// Name, which no other shape has.
    pub name: String,
    /// What it is.
    #[serde(flatten)]
    pub geometry: Geometry,
}

/// Reference geometry in the plane.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Geometry {
    /// A point.
    Point {
        /// Where it is.
        at: [f64; 2],
    },
    /// A line without ends.
    Line {
        /// One of its points.
        through: [f64; 2],
        /// Its direction, of any length but 0.
        direction: [f64; 2],
    },
    /// A piece of a line.
    Segment {
        /// Where it starts.
        from: [f64; 2],
        /// Where it ends.
        to: [f64; 2],
    },
    /// A circle.
    Circle {
        /// Its centre.
        center: [f64; 2],
        /// Its radius, above 0.
        radius: f64,
    },
    /// A closed chain of segments, 3 points or more.
    Polygon {
        /// Its vertices.
        points: Vec<[f64; 2]>,
    },
    /// An open chain of segments, 2 points or more.
    Polyline {
        /// Its vertices.
        points: Vec<[f64; 2]>,
    },
    /// A B-spline, as in curves documents.
    Curve {
        /// Degree, 2 to 32.
        degree: usize,
        /// Whether and how it closes.
        form: CurveForm,
        /// Control points.
        points: Vec<[f64; 2]>,
        /// Knots; uniform on [0, 1] when left out.
        #[serde(skip_serializing_if = "Option::is_none")]
        knots: Option<Vec<f64>>,
    },
}

/// A body.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BodySpec {
    /// Name, which no other body has.
    pub name: String,
    /// Name of a closed shape.
    pub outline: String,
    /// Names of closed shapes that are cut out.
    pub holes: Vec<String>,
    /// Composition where no feature acts.
    pub default: Vec<f64>,
    /// What stands in for the default in the interior.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blend: Option<PartBlendSpec>,
    /// How features share where they overlap.
    pub rule: ComposingRule,
    /// The queue of composition features.
    pub features: Vec<FeatureSpec>,
}

/// A composition that is blended over a body from what its boundary has.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PartBlendSpec {
    /// How it is blended.
    pub kind: PartBlendKind,
    /// About how many elements the boundary is divided into, 32 to 2000.
    pub elements: usize,
    /// What is known on which pieces of the boundary; nothing flows across the rest.
    pub boundaries: Vec<BoundarySpec>,
}

/// How a composition is blended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PartBlendKind {
    /// Each fraction solves Laplace's equation.
    Laplace,
}

/// A piece of a boundary with what is known on it: one of the three, or that nothing flows across it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BoundarySpec {
    /// Name of the outline or of a hole, as far as no other piece has it, or of a shape that the boundary lies on.
    pub on: String,
    /// How far the boundary may be from that shape.
    pub within: f64,
    /// The composition.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<Vec<f64>>,
    /// Of each material how its fraction changes outwards, per unit of length; the sum is 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flux: Option<Vec<f64>>,
    /// What has the composition.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub from: Option<SourceSpec>,
}

/// What a boundary takes its composition from.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SourceSpec {
    /// Another body, by its name.
    Body(String),
    /// The first feature of this name in the own queue, hidden or not.
    Feature(String),
}

/// How features share where they overlap.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ComposingRule {
    /// Inverse-distance weights that end at the limits.
    Repaired,
    /// Weights by the depth within the band.
    Depth,
    /// Eq. 2 as printed, on the grid of a raster.
    Printed,
}

/// Composition as a function of distance.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FeatureSpec {
    /// Name for display.
    pub name: String,
    /// Whether it is left out.
    pub hidden: bool,
    /// What the distance is measured to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reference: Option<ReferenceSpec>,
    /// What several distances are measured to, by the names that `distance` has for them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub references: Option<BTreeMap<String, ReferenceSpec>>,
    /// An expression in the distances to `references`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub distance: Option<String>,
    /// The nearer limit.
    pub from: f64,
    /// The farther limit.
    pub to: f64,
    /// Composition at the nearer limit.
    pub start: Vec<f64>,
    /// Composition at the farther limit.
    pub end: Vec<f64>,
    /// How the composition goes from one to the other.
    pub course: CourseSpec,
}

/// What a distance is measured to.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ReferenceSpec {
    /// A shape by its name.
    Shape(String),
    /// The boundary of a body.
    Boundary {
        /// Name of the body.
        boundary: String,
        /// Names of shapes: what of the boundary lies on them is left out.
        except: Vec<String>,
    },
}

/// How a composition goes from `start` to `end`.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum CourseSpec {
    /// In proportion.
    Linear,
    /// By a power of the share of the way.
    Power {
        /// The power, above 0, at most 100.
        power: f64,
    },
    /// By an exponential function.
    Exponential {
        /// Its rate, -100 to 100, not 0.
        rate: f64,
    },
    /// With level ends.
    Smoothstep,
    /// To and fro.
    Periodic {
        /// How often it is at the end composition, 1 to 1000.
        waves: usize,
    },
    /// Linear between keys.
    Piecewise {
        /// 1 to 1000 keys, their places ascending.
        keys: Vec<CourseKey>,
    },
    /// By an expression in the distance d and the share t of the way.
    Expression {
        /// Its text.
        text: String,
    },
}

/// A composition at a share of the way.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CourseKey {
    /// The share, 0 to 1.
    pub at: f64,
    /// The composition.
    pub mix: Vec<f64>,
}

/// An inequality on a fraction or on its gradient.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PartRuleSpec {
    /// Name for display.
    pub name: String,
    /// Index of the material.
    pub material: usize,
    /// What is limited.
    pub of: RuleQuantity,
    /// Least value allowed.
    pub least: f64,
    /// Greatest value allowed.
    pub most: f64,
}

/// What a design rule limits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum RuleQuantity {
    /// The volume fraction.
    Fraction,
    /// The length of its gradient, per unit of length.
    Gradient,
}
