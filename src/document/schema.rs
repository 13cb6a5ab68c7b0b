//! A curves document in memory, with all defaults filled in.
//!
//! Only what this release computes has a place here; values of the format that come later are refused while reading.

use super::ControlPoints;
use crate::curve::Fineness;
use crate::geom::Bounds;
use glam::DVec2;
use serde::Serialize;

/// Greatest absolute coordinate, height and length of a document.
pub(super) const LARGEST: f64 = 1e12;
/// Length across what a document without curves shows.
pub(super) const BLANK: f64 = 100.0;
/// Smallest tolerance of a document.
pub(super) const SMALLEST: f64 = 1e-12;

/// A curves document: two curves or a stack of more, all closed or all open, or fewer while they are being drawn, their materials, and how
/// to match and blend them.
///
/// Neighbours in the list are matched with each other: the pairs are called spans.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct CurvesDocument {
    /// Version of the format: 1.
    pub directrix: u32,
    /// Always `curves`.
    pub kind: Kind,
    /// Title, at most 200 characters.
    pub title: String,
    /// Unit of length, for display only.
    pub unit: String,
    /// Materials; a composition has one fraction for each.
    pub materials: Vec<MaterialSpec>,
    /// The directrices, in the order of the stack; two or more in a finished document, at most 16.
    pub curves: Vec<CurveSpec>,
    /// How the curves are sampled.
    pub sampling: Sampling,
    /// How the samples are matched.
    pub matching: MatchingSpec,
    /// How shape and material go over from one curve to the other.
    pub blend: Blend,
    /// What the page shows; never needed to compute.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub view: Option<View>,
}

impl CurvesDocument {
    /// Whether the blend is harmonic.
    #[must_use]
    pub fn is_harmonic(&self) -> bool {
        #[cfg(feature = "harmonic")]
        return self.blend.kind == BlendKind::Harmonic;
        #[cfg(not(feature = "harmonic"))]
        false
    }

    /// Number of equal parts into which the stages cut every ruling line: M, or M + 1 where M is taken as printed for the number of curves
    /// in between (the caption of Fig. 6 of the precursor). In a stack that is the number of parts of each span.
    #[must_use]
    pub fn segments(&self) -> usize {
        self.blend.stages + usize::from(self.counts_stages_back())
    }

    /// Whether stages are counted as printed, from the second curve: the parameter of Eq. 3 is 0 there.
    #[must_use]
    pub fn counts_stages_back(&self) -> bool {
        self.matching.is_printed(PrintedRule::Stages)
    }
}

/// Kinds of documents.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// Curves and their blend.
    Curves,
}

/// A material.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct MaterialSpec {
    /// Name, at most 100 characters.
    pub name: String,
    /// Display colour, `#rrggbb`.
    pub color: String,
    /// Whether the material stands for empty space.
    pub void: bool,
}

/// A B-spline, in a plane or in space.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct CurveSpec {
    /// Name for display.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Degree, 2 to 32.
    pub degree: usize,
    /// Whether and how the control points close.
    pub form: CurveForm,
    /// Control points.
    pub points: ControlPoints,
    /// Knots; uniform on [0, 1] when left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub knots: Option<Vec<f64>>,
    /// Height of the plane of the curve.
    pub height: f64,
    /// Composition along the curve.
    pub composition: Vec<CompositionKey>,
}

/// Whether and how a B-spline closes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CurveForm {
    /// The control points wrap round.
    Periodic,
    /// The last control point repeats the first.
    Clamped,
    /// The curve does not close.
    Open,
}

/// The composition at one place of a curve.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct CompositionKey {
    /// Fraction of the knot domain of the curve as drawn, in [0, 1); on an open curve in [0, 1].
    pub at: f64,
    /// Fraction of each material; they sum to 1.
    pub mix: Vec<f64>,
}

/// How the curves are sampled.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Sampling {
    /// Where the samples lie.
    pub scheme: SamplingScheme,
    /// Number of samples of each curve, 3 to 1000; adaptive samples ignore it.
    pub counts: Vec<usize>,
    /// Greatest distance of a curve from the chords between adaptive samples.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// Greatest turn of the tangent from one adaptive sample to the next, 1 to 90 degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_turn: Option<f64>,
    /// Fewest adaptive samples of each curve, 3 to 1000.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub min_count: Option<usize>,
}

/// Where samples lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SamplingScheme {
    /// Even in the parameter.
    Parameter,
    /// Even in arc length.
    ArcLength,
    /// As many as the shape needs.
    Adaptive,
}

/// How the samples are matched.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct MatchingSpec {
    /// Method; always written out.
    pub method: Method,
    /// What the method `exact` maximises; there with that method alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub objective: Option<ObjectiveName>,
    /// Price of a line with the objective `sum-less-price`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line_price: Option<f64>,
    /// Number of one-to-one lines of the method `exact`, 3 to 1000; as many as the larger number of samples without it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lines: Option<usize>,
    /// Number of samples by which the method `shift` is ahead on the second curve; the best one without it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shift: Option<Shift>,
    /// Exponent of the product of the normals, 0 to 100.
    pub normal_weight: f64,
    /// Exponent of the length, 0 to 100.
    pub distance_weight: f64,
    /// Exponent of the alignment of the line with the normals, 0 to 100.
    pub alignment_weight: f64,
    /// How negative products count.
    pub negative: NegativeMode,
    /// Whether vertices are inserted until every line has its own ends.
    pub one_to_one: bool,
    /// What to do where the constraints cannot hold.
    pub policy: Policy,
    /// What becomes of the ends of open curves; closed ones keep and ignore it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ends: Option<EndRule>,
    /// Pairs of places that the method `exact` must join.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub pins: Vec<Pin>,
    /// Rules that are taken as the papers print them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub printed: Vec<PrintedRule>,
}

impl MatchingSpec {
    /// Tells whether a rule is taken as printed.
    #[must_use]
    pub fn is_printed(&self, rule: PrintedRule) -> bool {
        self.printed.contains(&rule)
    }
}

/// What becomes of the ends of open curves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum EndRule {
    /// The first samples are joined, and the last ones.
    Tied,
    /// Samples at the ends of either curve may be left out.
    Free,
}

/// What the method `exact` maximises.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ObjectiveName {
    /// The integral J.
    Integral,
    /// The sum of the values.
    Sum,
    /// The sum of the values less a price for each line.
    SumLessPrice,
}

/// How far the method `shift` shifts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(untagged)]
pub enum Shift {
    /// By a number of samples, taken modulo their number.
    By(usize),
    /// By the number with the greatest sum.
    Best(BestShift),
}

/// The word `best`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum BestShift {
    /// Every shift is tried.
    Best,
}

/// A pair of places that a line must join.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Pin {
    /// Parameter on the first curve of the span as drawn.
    pub u: f64,
    /// Parameter on the second curve of the span as drawn.
    pub v: f64,
    /// Number of the span: that of its first curve.
    #[serde(skip_serializing_if = "is_first")]
    pub pair: usize,
}

fn is_first(pair: &usize) -> bool {
    *pair == 0
}

/// Rules that the papers print otherwise than they are repaired.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PrintedRule {
    /// The normal of the second curve points inwards: a perfect match has the product -1.
    Normals,
    /// Negative products keep their exponent: even ones reward opposed normals, fractional ones have no value.
    Negative,
    /// The growth stops when it finds the best line again, with one line.
    Stop,
    /// The lowest line of all is removed while any is redundant.
    Removal,
    /// Order is an interval of indices, without laps.
    Order,
    /// The heights do not count in lengths.
    Heights,
    /// The number of stages is that of the curves in between, which are counted from the second curve.
    Stages,
}

impl PrintedRule {
    /// Every rule.
    pub const ALL: [Self; 7] =
        [Self::Normals, Self::Negative, Self::Stop, Self::Removal, Self::Order, Self::Heights, Self::Stages];

    /// Their names in documents, in the same order.
    pub const NAMES: [&'static str; 7] =
        ["normals", "negative", "stop", "removal", "order", "heights", "stages"];
}

/// Matching methods.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// Greedy ruling line construction.
    Greedy,
    /// The exact optimum.
    Exact,
    /// The papers' dynamic programme: the greatest sum with at most one line a vertex.
    OnePerVertex,
    /// Vertex to vertex, shifted by an index.
    Shift,
    /// Vertex to vertex by index.
    Parameter,
}

/// How a negative product of normals counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum NegativeMode {
    /// With its sign.
    Signed,
    /// As zero.
    Clamp,
    /// By half the sum with one.
    Half,
}

/// What to do where the constraints cannot hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Policy {
    /// Say so, and keep the sound part.
    Strict,
    /// Reach every vertex with as few occluded lines as possible.
    Repair,
}

/// How shape and material go over from one curve to the other.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Blend {
    /// Kind of the blend.
    pub kind: BlendKind,
    /// Number M of steps from one curve to the next, 1 to 200; there are M - 1 in-between curves.
    pub stages: usize,
    /// Number of lines along the gradient of a harmonic blend, 1 to 400.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lines: Option<usize>,
    /// Number of segments of each curve of a harmonic blend, 16 to 1000.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub segments: Option<usize>,
}

/// Kinds of blends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum BlendKind {
    /// Linear along the ruling lines.
    Ruled,
    /// Through all curves of a stack without kinks at the inner ones; of two curves the same as ruled.
    Cubic,
    /// As heat flows from the outer curve to all others inside it.
    #[cfg(feature = "harmonic")]
    Harmonic,
}

/// What the page shows of a document.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct View {
    /// Layers shown.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub layers: Option<Vec<LayerName>>,
    /// Point in the middle of the picture.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub center: Option<[f64; 2]>,
    /// Length across the shorter side of the picture.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub span: Option<f64>,
    /// Place of the current in-between curve, from 0 on the first curve to 1 on the second.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub s: Option<f64>,
    /// Index of the material whose lines of equal fraction are shown.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub iso_material: Option<usize>,
    /// Whether hatches stand in for the colours of the materials.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub patterns: Option<bool>,
}

/// Layers of the picture. The two curves are always drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "camelCase")]
pub enum LayerName {
    /// The band, coloured by its mix of materials.
    Material,
    /// The band in flat unit cells: ruling lines by in-between curves.
    UnitCells,
    /// In-between curves.
    InBetweens,
    /// Ruling lines.
    RulingLines,
    /// Sampled points.
    Samples,
    /// Sampled points without a ruling line.
    Unconnected,
    /// Control polygons.
    ControlPoints,
    /// Normals of the samples.
    Normals,
    /// Grid.
    Grid,
    /// Ruling lines coloured by their value.
    Value,
    /// Lines of equal fraction of one material.
    IsoComposition,
    /// Where a harmonic blend differs from the ruled one.
    Difference,
}

impl LayerName {
    /// Every layer.
    pub const ALL: [Self; 12] = [
        Self::Material,
        Self::UnitCells,
        Self::InBetweens,
        Self::RulingLines,
        Self::Samples,
        Self::Unconnected,
        Self::ControlPoints,
        Self::Normals,
        Self::Grid,
        Self::Value,
        Self::IsoComposition,
        Self::Difference,
    ];

    /// Their names in documents, in the same order.
    pub const NAMES: [&'static str; 12] = [
        "material",
        "unitCells",
        "inBetweens",
        "rulingLines",
        "samples",
        "unconnected",
        "controlPoints",
        "normals",
        "grid",
        "value",
        "isoComposition",
        "difference",
    ];

    /// The layers shown when a document names none.
    pub const DEFAULT: [Self; 7] = [
        Self::Material,
        Self::InBetweens,
        Self::RulingLines,
        Self::Samples,
        Self::Unconnected,
        Self::ControlPoints,
        Self::Grid,
    ];
}

impl Default for Sampling {
    fn default() -> Self {
        Self {
            scheme: SamplingScheme::ArcLength,
            counts: vec![44, 44],
            tolerance: None,
            max_turn: None,
            min_count: None,
        }
    }
}

impl Sampling {
    /// The defaults for a number of curves; while they are being drawn there are counts for two.
    #[must_use]
    pub fn of(curves: usize) -> Self {
        Self { counts: vec![44; curves.max(2)], ..Self::default() }
    }

    /// How fine adaptive samples of these curves are: what is left out has the defaults of `docs/format.md`.
    #[must_use]
    pub fn fineness(&self, curves: &[CurveSpec]) -> Fineness {
        let size = || {
            let points = curves.iter().flat_map(|curve| curve.points.iter().copied().map(DVec2::from));
            Bounds::of(points).map_or(BLANK, |bounds| across(bounds.diagonal(), curves))
        };
        Fineness {
            tolerance: self.tolerance.unwrap_or_else(|| (1e-3 * size()).clamp(SMALLEST, LARGEST)),
            max_turn: self.max_turn.unwrap_or(15.0),
            min_count: self.min_count.unwrap_or(12),
        }
    }
}

/// Diagonal of the box of all control points, given that of its first two sides.
#[cfg(feature = "solid")]
fn across(diagonal: f64, curves: &[CurveSpec]) -> f64 {
    let points = curves.iter().filter_map(|curve| curve.points.in_space()).flatten();
    let ends = points.map(|point| (point.z, point.z)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
    ends.map_or(diagonal, |(low, high)| diagonal.hypot(high - low))
}

/// Plane curves alone are read here.
#[cfg(not(feature = "solid"))]
fn across(diagonal: f64, _: &[CurveSpec]) -> f64 {
    diagonal
}

impl Default for Blend {
    fn default() -> Self {
        Self { kind: BlendKind::Ruled, stages: 5, lines: None, segments: None }
    }
}
