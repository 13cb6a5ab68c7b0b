/** A point [x, y] in document units, y up. */
export type Point = [number, number];

/** A material of a document. */
export interface Material {
  name: string;
  /** `#rrggbb` */
  color: string;
  /** Whether it stands for empty space; default false. */
  void?: boolean;
}

/** The composition at one place of a curve. */
export interface CompositionKey {
  /** Fraction of the knot domain of the curve as drawn, in [0, 1), on an open curve in [0, 1]. */
  at: number;
  /** One fraction for each material; they sum to 1. */
  mix: number[];
}

/** A B-spline in the plane or, in the module `full`, in space. */
export interface Curve {
  name?: string;
  /** 2 to 32. */
  degree: number;
  form: "periodic" | "clamped" | "open";
  /** All of two coordinates, or all of three. */
  points: Point[] | SpacePoint[];
  knots?: number[];
  height?: number;
  composition?: CompositionKey[];
}

export type LayerName =
  | "material"
  | "unitCells"
  | "inBetweens"
  | "rulingLines"
  | "samples"
  | "unconnected"
  | "controlPoints"
  | "normals"
  | "grid"
  | "value"
  | "isoComposition"
  | "difference";

/** A curves document; docs/format.md defines every field. */
export interface CurvesDocument {
  directrix: 1;
  kind: "curves";
  title?: string;
  unit?: string;
  materials?: Material[];
  /** Two, or a stack of up to 16, of which neighbours are matched; fewer while they are being drawn. */
  curves: Curve[];
  sampling?: {
    scheme?: "parameter" | "arc-length" | "adaptive";
    /** Samples of each curve; adaptive samples ignore it. */
    counts?: number[];
    /** Of adaptive samples: greatest distance of a curve from the chords. */
    tolerance?: number;
    /** Of adaptive samples: degrees. */
    maxTurn?: number;
    /** Of adaptive samples: fewest of each curve. */
    minCount?: number;
  };
  matching: {
    method: "exact" | "greedy" | "one-per-vertex" | "shift" | "parameter";
    /** Of the method `exact`. */
    objective?: "integral" | "sum" | "sum-less-price";
    /** Of the objective `sum-less-price`. */
    linePrice?: number;
    /** Number of one-to-one lines of the method `exact`. */
    lines?: number;
    /** Of the method `shift`. */
    shift?: number | "best";
    normalWeight?: number;
    distanceWeight?: number;
    alignmentWeight?: number;
    negative?: "signed" | "clamp" | "half";
    oneToOne?: boolean;
    policy?: "strict" | "repair";
    /** Of open curves. */
    ends?: "tied" | "free";
    /** `pair` is the span of a stack that the pin belongs to: the number of its first curve. */
    pins?: { u: number; v: number; pair?: number }[];
    printed?: ("normals" | "negative" | "stop" | "removal" | "order" | "heights" | "stages")[];
  };
  blend?: {
    kind?: "ruled" | "cubic" | "harmonic";
    stages?: number;
    /** Of the kind `harmonic`: number of lines along the gradient. */
    lines?: number;
    /** Of the kind `harmonic`: segments of each curve. */
    segments?: number;
  };
  view?: { layers?: LayerName[]; center?: Point; span?: number; s?: number; isoMaterial?: number; patterns?: boolean };
}

/** A point [x, y, z] in document units, z up. */
export type SpacePoint = [number, number, number];

/** A curves document whose control points all lie in space; the module `full` reads it. */
export interface SpaceDocument extends Omit<CurvesDocument, "curves"> {
  curves: (Omit<Curve, "points" | "height"> & { points: SpacePoint[] })[];
}

/** A document as an object, or its JSON text. */
/** A hyperpatch document; docs/format.md defines every field. Operations that this release does not know are refused. */
export interface HyperpatchDocument {
  directrix: 1;
  kind: "hyperpatch";
  title?: string;
  unit?: string;
  materials?: Material[];
  /** What makes the body, in order. An operation that is the same object as before is taken as the same operation. */
  operations: HyperpatchOperation[];
}

/** A coefficient of a cell that is written out; without a mix it is all of the first material. */
export interface CellCoefficient {
  position: Triple;
  mix?: number[];
}

/** How cells are to continue each other at a corner of a face: not at all, with a common block, with common slopes as well. */
export type MarkName = "none" | "C0" | "C1";

/** An operation on a body; docs/format.md says what each does. `id` is by default one more than the largest before it. */
export type HyperpatchOperation = { id?: number } & (
  | { op: "cells"; cells: { coefficients: CellCoefficient[] }[] }
  | { op: "move"; cell: number; at: Triple; by: Triple; reach?: Reach }
  | { op: "continuity"; cell: number; face: FaceName; corner?: Triple; shape?: MarkName; material?: MarkName }
  | { op: "mix"; mix: number[]; cells: number[] }
  | { op: "mix"; mix: number[]; cell: number; corner: Triple; within?: number[] }
  | { op: "mix"; mix: number[]; cell: number; at: Triple }
  | { op: "slope"; cell: number; corner: Triple; rule: "flat" | "natural" }
  | { op: "delete"; cells: number[] }
  | { op: "copy"; cells: number[]; by: Triple }
  | { op: "mirror"; cells: number[]; normal: Triple; offset?: number; keep?: boolean }
  | { op: "reorient"; cells: number[] }
  | { op: "extrude"; faces: { cell: number; face: FaceName }[]; by: number; start?: "C1" | "free"; normals?: "mean" | "surface"; mix?: number[] }
  | { op: "subdivide"; cell: number; axis: "u" | "v" | "w"; at?: number }
);

/** What a move takes along: what has to follow, or equal copies in other cells alone. */
export type Reach = "block" | "single";

/** What came of an operation. */
export interface OperationResult {
  id: number;
  op: HyperpatchOperation["op"];
  /** False where it does not apply to the body as it is then; the body goes on as if it were not there. */
  applied: boolean;
  /** Why it does not apply. */
  reason: string | null;
  /** Cells that it changed, made and took away. */
  touched: number[];
  made: number[];
  removed: number[];
}

/** A part document; docs/format.md defines every field. */
export interface PartDocument {
  directrix: 1;
  kind: "part";
  title?: string;
  unit?: string;
  materials?: Material[];
  /** Reference geometry, by its names. */
  shapes?: ({ name: string } & PartShape)[];
  /** A later one lies over an earlier one. */
  bodies: PartBody[];
  rules?: { name?: string; material: number; of?: "fraction" | "gradient"; least?: number; most?: number }[];
}

export type PartShape =
  | { kind: "point"; at: Point }
  | { kind: "line"; through: Point; direction: Point }
  | { kind: "segment"; from: Point; to: Point }
  | { kind: "circle"; center: Point; radius: number }
  | { kind: "polygon" | "polyline"; points: Point[] }
  | { kind: "curve"; degree: number; form: "periodic" | "clamped" | "open"; points: Point[]; knots?: number[] };

export interface PartBody {
  name: string;
  /** Name of a closed shape. */
  outline: string;
  /** Names of closed shapes that are cut out. */
  holes?: string[];
  /** Composition where no feature acts. */
  default?: number[];
  /** What stands in for the default in the interior. */
  blend?: PartBlend;
  rule?: "repaired" | "depth" | "printed";
  features?: PartFeature[];
}

/** A composition that solves Laplace's equation in a body, from what its boundary has; see docs/format.md. */
export interface PartBlend {
  kind: "laplace";
  /** About how many elements the boundary is divided into, 32 to 2000; 300 by default. */
  elements?: number;
  /** Up to 32; nothing flows across what is in none of them. */
  boundaries?: PartBoundary[];
}

/** A piece of a boundary with what is known on it: a composition, a gradient, what another has there, or that nothing flows across it. */
export interface PartBoundary {
  /** Name of the outline or of a hole, or of a shape that the boundary lies on. */
  on: string;
  /** How far the boundary may be from that shape. */
  within?: number;
  value?: number[];
  /** Of each material how its fraction changes outwards, per unit of length; the sum is 0. */
  flux?: number[];
  from?: { body: string } | { feature: string };
}

/** The name of a shape, or the boundary of a body without what lies on some shapes. */
export type PartReference = string | { boundary: string; except?: string[] };

/** Composition as a function of the distance to `reference`, or of `distance`, an expression in the distances to `references`. */
export interface PartFeature {
  name?: string;
  hidden?: boolean;
  reference?: PartReference;
  references?: { [name: string]: PartReference };
  distance?: string;
  from?: number;
  to: number;
  /** Required, but for a `piecewise` course. */
  start?: number[];
  end?: number[];
  /** The materials that `start`, `end` and `keys` speak of; the others have the fraction 0. */
  materials?: number[];
  course?: PartCourse;
}

export type PartCourse =
  | { kind: "linear" | "smoothstep" }
  | { kind: "power"; power: number }
  | { kind: "exponential"; rate: number }
  | { kind: "periodic"; waves: number }
  | { kind: "piecewise"; keys: { at: number; mix: number[] }[] }
  | { kind: "expression"; text: string };

export type DocumentInput = CurvesDocument | SpaceDocument | string;

/** What the matching of curves in space takes for granted: they are seen along one direction, each as lying at its mean height. */
export interface Projection {
  /** The point of the plane of the first curve that is nearest to the origin of the document. */
  origin: SpacePoint;
  /** Unit vector along which the curves are seen, normal of the planes. */
  normal: SpacePoint;
  /** Unit vectors along x and y of the plane in which results speak. */
  axes: [SpacePoint, SpacePoint];
  /** Mean height of each curve along the normal, which stands for the height of a plane curve. */
  heights: number[];
  /** Greatest distance of a curve from its mean height. */
  deviation: number;
  /** What is assumed, in words. */
  assumed: string;
}

/** A remark on the geometry, or why there is no complete matching. */
export interface Diagnostic {
  code: "several-inner" | "open-curves" | "curves-meet" | "no-outer" | "nested" | "heights-ignored" | "no-field" | "lost-lines" | "no-ruled-blend" | "incomplete" | "corner" | "sample-limit" | "opposed-normals" | "orphan" | "stuck" | "solvable" | "jammed" | "pins" | "ends" | "left-out" | "occluded" | "unverified" | "unverified-gap" | "disjoint" | "crossing" | "coarse-sampling" | "order" | "overlap" | "no-thread" | "flat" | "open-sheet" | "uncapped" | "rounded";
  message: string;
  /** Of a stack: the span that the remark is about, whose lines and vertices it numbers. */
  span?: number;
  curve?: number;
  /** Several curves that it concerns. */
  curves?: number[];
  vertices?: number[];
  lines?: number[];
  /** Indices of pins. */
  pins?: number[];
  /** Of pins that cannot be kept: one meets a curve, two cross, or they leave no room for the lines beside or between them. */
  reason?: "blocked" | "cross" | "no-room";
  parameter?: number;
  /** Degrees. */
  turn?: number;
  /** Of a corner: the bisector that stands in for the normal, of length 1, outward on a closed curve. */
  normal?: Point;
  at?: Point;
}

/** Samples of one curve, closed ones counter-clockwise, by ascending parameter; the vertex at the seam counts once. */
export interface Samples {
  parameters: number[];
  points: Point[];
  /** Unit normals to the right of the curve, outward on a closed one. */
  normals: Point[];
}

/** A ruling line from a sample of the first curve to one of the second. */
export interface Line {
  from: number;
  to: number;
  /** f */
  value: number;
  /** Whether it meets no edge of either polygon, checked edge by edge. */
  visible: boolean;
}

/** A one-to-one line; at a gap where such lines could not be verified, a line of the matching between samples. */
export interface Pair {
  /** Parameter on the first counter-clockwise curve. */
  u: number;
  /** Parameter on the second one, ascending beyond the end of its domain. */
  v: number;
  /** f */
  value: number;
  /** Whether it meets no edge of the refined polygons and crosses no other pair, checked edge by edge and pair by pair. */
  verified: boolean;
  from: Point;
  to: Point;
}

/** What a set of lines is worth. */
export interface LineTotals {
  count: number;
  sum: number;
  /** null without lines. */
  mean: number | null;
  /** J; null when a sample has no line. */
  integral: number | null;
  /** Upper bound of J; null where eta is. */
  bound: number | null;
  /** J over its upper bound; null when J is, or when the bound is not positive. */
  eta: number | null;
  /** Sum of f over as many lines, evenly spread along the correspondence; null without lines. */
  spreadSum: number | null;
  /** Smallest product of normals; null without lines. */
  leastCosine: number | null;
  /** Length of the longest line; null without lines. */
  longest: number | null;
  crossings: number;
  blocked: number;
  /** Samples of each curve without a line. */
  uncovered: [number[], number[]];
}

export interface Match {
  /** Whether every sample has a line, none cross and none is blocked. */
  ok: boolean;
  diagnostics: Diagnostic[];
  /** Of each curve that is there: whether it was drawn clockwise; on those u becomes lo + hi - u. */
  reversed: boolean[];
  /** Of each curve that is there. */
  samples: Samples[];
  /** In cyclic order. */
  lines: Line[];
  /** Lines with ends of their own, in cyclic order; empty unless the document asks for them and `ok`. */
  pairs: Pair[];
  /** Parameters [u, v] of every line, or pair where there are pairs, ascending beyond the ends of their domains; empty unless `ok`. */
  reparameterisation: [number, number][];
  totals: {
    /** Every line that the growth of the method `greedy` accepted, before redundant ones are removed. */
    growth: { count: number; sum: number } | null;
    lines: LineTotals | null;
    pairs: LineTotals | null;
  };
  /** How far J of the lines stays below the optimum: 1 - J/J*; null where that is not known. */
  gap: number | null;
  /** Whether the optimum is that on the curves themselves, a supremum on these that one-to-one lines only come near, or that between the same samples. */
  gapKind: "refined" | "supremum" | "lattice" | null;
  /** J*, which the gap is measured against. */
  optimum: number | null;
  /** Relative change of J* on the curves when the samples were last made finer; null where it is not on the curves. */
  optimumChange: number | null;
  /** Whether the refinement on the curves was left out, which a call without `coarse` does. */
  coarse: boolean;
  /** Of a stack alone: the result of every pair of neighbours, as of a document of its own. */
  spans?: Match[];
  /** Of a stack alone: the place s of every curve, from 0 to 1; empty unless `ok`. */
  knots?: number[];
  /** Of a stack alone: the parameters of every thread on every curve, ascending beyond the ends of the domains; empty unless `ok`. */
  threads?: number[][];
  /** Of a harmonic blend alone, which has no ruling lines: its numbers. */
  harmonic?: HarmonicNumbers & { lines: number };
  /** Of curves in space. */
  projection?: Projection;
}

export interface MatchOptions {
  /**
   * Leaves out the refinement of the method `exact` on the curves themselves, unless it has been done: for documents that change from
   * frame to frame. Default false.
   */
  coarse?: boolean;
}

/** Another line at one end of a ruling line. */
export interface Rival {
  from: Point;
  to: Point;
  /** Index of the sample at its other end; where there are pairs, of the pair that ends there. */
  other: number;
  /** f */
  value: number;
  /** It is a ruling line too; it meets a curve; it crosses the ruling line `line`; or nothing forbids it, but the whole is worth more without it. */
  fate: "taken" | "blocked" | "crosses" | "free";
  line: number | null;
}

/** Where a ruling line stands among the lines from one of its ends: to all samples, or to the ends of all pairs where there are pairs. */
export interface Standing {
  /** Rank by value among those that meet no curve, from 1; null when the line itself meets one. */
  rank: number | null;
  /** How many meet no curve. */
  visible: number;
  /** The best of the others, best first, at most 4. */
  rivals: Rival[];
}

/** A ruling line, the parts of its value, and its rivals. */
export interface Explanation {
  /** Index among the pairs where there are pairs. */
  line: number;
  from: Point;
  to: Point;
  /** f, the product of the factors. */
  value: number;
  /** Product of the unit normals at its ends. */
  cosine: number;
  length: number;
  /** Product of the cosines between the line and either normal. */
  alignment: number;
  /** Of the normals, of the length and of the alignment. */
  factors: [number, number, number];
  /** At its end on the first curve and at that on the second. */
  ends: [Standing, Standing];
}

/** A polyline at the share s of the way from the first curve to the last one, closed where the curves are. */
export interface Stage {
  s: number;
  points: Point[];
}

/** The quadrilateral between two ruling lines and two stages: a bilinear patch. */
export interface UnitCell {
  line: number;
  stage: number;
  /** Along the line to the next stage, then on the next line back: counter-clockwise where the first curve is the inner one. */
  corners: [Point, Point, Point, Point];
  /** In the square of the unit; parts that are turned over against the band as a whole count as negative. */
  area: number;
  /** Centre of the area; of a folded cell the mean of the corners. */
  centroid: Point;
  /** Mean fraction of each material over the area; of a folded cell over the corners. */
  fractions: number[];
  /** Whether the cell is turned over, in part or as a whole. */
  folded: boolean;
}

/** What a band holds of one material. */
export interface MaterialAmount {
  name: string;
  /** Whether it is empty space. */
  void: boolean;
  /** Integral of its fraction over the area, in the square of the unit. */
  amount: number;
  /** Share of the whole band, empty space included. */
  share: number;
}

/** Areas in the plane, of curves at different heights those of the projection, in the square of the unit. */
export interface Amounts {
  /** The unit of the document. */
  unit: string;
  /** Area of the band between the curves themselves. */
  area: number;
  /** The same without what is empty space. */
  body: number;
  /** Estimated error of the area and of every amount. */
  error: number;
  materials: MaterialAmount[];
  /** The same in the unit cells, whose sides are chords of the curves. */
  cells: {
    area: number;
    amounts: number[];
    /** Largest difference of the area or an amount from the exact one. */
    difference: number;
    /** Number of lines from which to the next one the band is turned over, at least in part. */
    folded: number;
  };
  /** Difference of the heights of the curves. */
  rise: number;
}

/** The lines that part the places with at least a fraction of one material from the others. */
export interface Isoline {
  level: number;
  /** Polylines; a closed one does not repeat its first point, an open one ends on the curves. */
  lines: Point[][];
  /** Whether each of the lines is closed. */
  closed: boolean[];
}

export interface IsolineOptions {
  /** Index of the material whose fraction has the levels. Default 0. */
  material?: number;
  /** 1 to 100 fractions, 0 to 1. Default: every tenth, 0.1 to 0.9. */
  levels?: number[];
}

/** What the band holds at a point. */
export interface Probe {
  /** Of a stack alone: the span that holds the point, to which `line`, `u` and `v` belong. */
  span?: number;
  /** Index of the nearest ruling line: among the pairs where there are pairs. */
  line: number;
  s: number;
  u: number;
  v: number;
  at: Point;
  /** Fraction of each material at the point. */
  fractions: number[];
  /** Value f of the nearest line. */
  value: number;
  /** Product of the unit normals at its ends. */
  cosine: number;
  length: number;
  from: Point;
  to: Point;
  /**
   * Of a harmonic blend alone: the gradient of the potential, per unit of length. There `s` is the potential, 0 on the inner curves to 1 on the outer one;
   * `line` is the nearest line along the gradient, whose ends `u`, `v`, `from` and `to` are, and `length` that of the curved line; `value` is the length of
   * the gradient.
   */
  gradient?: Point;
}

/**
 * The greedy growth for the weights of a document, whatever its method, with the rules as repaired, and the two passes of vertex insertion.
 * The fields of `match` are those of the method `greedy` with one-to-one lines; replaying the steps leads to its `lines`, and to its `pairs`
 * but for the gaps that keep their lines.
 */
export interface Steps extends Match {
  /** Lines in the order in which they are accepted, from the best on. */
  growth: { from: number; to: number; value: number }[];
  /** Visible lines that are passed over before the accepted line `growth[step]`, because they cross `growth[by]`. */
  rejected: { from: number; to: number; step: number; by: number }[];
  /** Indices into `growth` of the redundant lines, in the order in which they are removed. */
  removed: number[];
  /**
   * What the passes insert: the first (`curve` 0) moves the first end of the one line that sample `vertex` of the second curve has; the
   * second moves the second end of the one line that is then left at sample `vertex` of the first. Empty unless every sample has a line.
   */
  inserted: InsertedEnd[];
}

/** A new vertex on a curve, and the end of a line that moves there. */
export interface InsertedEnd {
  curve: 0 | 1;
  /** The sample of the other curve at which the line keeps its other end. */
  vertex: number;
  at: Point;
  /** f of the line from there. */
  value: number;
}

export interface SetsOptions {
  /** Number of accepted lines that are there, 0 to the length of `growth`. */
  step: number;
  /** Default 0. */
  curve?: 0 | 1;
  /** A sample of that curve. */
  vertex: number;
}

/** What one sample sees and may have at one step of the greedy growth; vertices are samples of the other curve. */
export interface VertexSets {
  /** V, the best line first. A candidate is in R as well, crosses no accepted line and is none. */
  visible: { vertex: number; value: number; candidate: boolean }[];
  /** R: what its lines may end in without crossing those that are there, ascending round the curve. */
  valid: number[];
  /** The end of the best candidate. */
  best: number | null;
}

/** The point in the middle of a picture, and its scale in CSS pixels per unit. */
export interface View {
  center: Point;
  scale: number;
}

export interface PictureSize {
  /** Device pixels, 1 to 4096. */
  width: number;
  /** Device pixels, 1 to 4096. */
  height: number;
  /** Device pixels per CSS pixel, 0.1 to 16; strokes grow with it. Default 1. */
  pixelRatio?: number;
}

export interface PictureOptions extends PictureSize, MatchOptions {
  /** Default: the document's view, else the one that shows everything. */
  view?: View;
  /** Default: the document's layers, else all but normals, values and unit cells. */
  layers?: LayerName[];
  theme?: "light" | "dark";
  /** Whether the canvas is filled; else it is transparent. Default true. */
  background?: boolean;
  /** Place of the current in-between curve, 0 to 1; null hides it. Default: the document's. */
  s?: number | null;
  /** Index of a ruling line to lift out: among the pairs where there are pairs. */
  line?: number | null;
  /** Index of the material whose lines of equal fraction the layer `isoComposition` shows. Default: the document's, else 0. */
  isoMaterial?: number | null;
  /** Whether hatches stand in for the colours of the materials. Default: the document's, else false. */
  patterns?: boolean | null;
}

/** Straight RGBA pixels, row by row from the top. */
export interface Picture {
  width: number;
  height: number;
  data: Uint8ClampedArray;
  view: View;
}

/** How far a job has come. */
export interface Progress {
  /** The share done, 0 to 1. */
  progress: number;
  done: boolean;
  /** Of a job that paints, when it is done. */
  picture?: Picture;
  /** Of a job that builds a solid, when it is done. */
  solid?: Solid;
  /** Of a job that writes a file, when it is done. */
  file?: Uint8Array;
  /** Of a job that asks for a harmonic blend, when it is done. */
  harmonic?: Harmonic;
  /** Of a job that answers a question about a body, when it is done: what the method of that name returns. */
  answer?: any;
  /** Of a distance transform, when it is done. */
  distances?: Float32Array;
}

/** The solution of a document, and its picture if asked for, in steps: for hosts that must stay responsive. */
export interface Job {
  /** Works for about so many milliseconds. When done, the other functions answer from the result. */
  step(budget: number): Progress;
}

/** A closed outline that was read; y up. */
export interface Shape {
  name: string;
  /** Whether it was drawn closed; else a straight edge joins its ends. */
  closed: boolean;
  /** Vertices in order, the first one not repeated; curves are resolved into them. */
  points: Point[];
  /** Indices of vertices that were drawn as corners; empty for lists of points. */
  corners: number[];
  /** Area inside. */
  area: number;
  /** Length of the outline. */
  length: number;
}

/** What was read, and what was found and could not be. */
export interface ShapeList {
  shapes: Shape[];
  skipped: { name: string; reason: string }[];
}

export interface FitOptions {
  /** Largest distance between the curve and the polyline through the points, above 0. */
  tolerance: number;
  /** Whether corners stay or are rounded within the tolerance. Default `keep`. */
  corners?: "keep" | "smooth";
  /** Whether the curve meets every point; the tolerance then only tells which corners there are. Default false. */
  through?: boolean;
  /** Corners that are kept, as indices of the points. Default: found by the angle, from 40 degrees, on the scale of the tolerance. */
  cornerIndices?: number[];
  /**
   * What becomes of the ends of a list whose last point does not repeat the first: a straight edge joins them, and `trim`
   * leaves out what they overlap, as the ends of a drawn stroke do. Default `trim`; `join` where corners are given or points are met.
   */
  ends?: "trim" | "join";
}

/** A curve near a list of points. */
export interface FittedCurve {
  /** Periodic and cubic over [0, 1], from the first point on; fit for a document. */
  curve: { degree: number; form: "periodic"; points: Point[]; knots: number[] };
  /** Bound of the distance between the curve and the polyline through the points, in both directions. */
  error: number;
  /** Indices of the points that are corners of the curve. */
  corners: number[];
  /** Whether the curve does not meet itself. */
  simple: boolean;
  /** Number of points left out at the ends. */
  trimmed: number;
}

export interface MorphPathsOptions {
  /**
   * Largest distance of either path from its curve, at places that the matching joins; 1e-9 to 1 times the diagonal of the box of both
   * curves. Default: 1e-4 times it.
   */
  tolerance?: number;
}

/**
 * The two matched curves as SVG paths with the same commands, y down: `M`, then cubics `C`, then `Z` where they are closed. Blending the numbers of both evenly
 * gives the in-between curves.
 */
export interface MorphPaths {
  /** The first curve. */
  from: string;
  /** The second curve. */
  to: string;
  /** Number of cubics of either path. */
  commands: number;
  /** Whether the curves are closed. */
  closed: boolean;
  /** Bound of the distance of either path from its curve, and of an even blend from the in-between curve. */
  error: number;
  /** x, y, width and height of a box with y down that holds both. */
  viewBox: [number, number, number, number];
  /** Of each curve, of each command, the fraction of each material in its middle. */
  fractions: [number[][], number[][]];
}

export interface SolidOptions {
  /** Number of steps from curve to curve, 1 to 200. Default: that of the document. */
  stages?: number;
  /** Whether the rims of closed curves get caps. Default true. */
  caps?: boolean;
  /**
   * What the colours say: the mix of materials, the fraction of one by its index, the twist of the ruling lines, or the angle between the normals of
   * the surface at both ends of a line. Default `material`.
   */
  color?: "material" | { material: number } | "twist" | "flank";
}

export interface SolidFileOptions extends SolidOptions {
  /** Binary STL; binary PLY with colours and fractions; OBJ with groups and colours. */
  format: "stl" | "ply" | "obj";
}

/** What a job does besides solving: one thing at most. */
export interface HarmonicOptions extends MatchOptions {
  /** Whether a blend of two curves is compared with the ruled one that `matching` describes. */
  difference?: boolean;
}

/** The harmonic blend of nested curves. Without one `ok` is false, `outer` null and the lists are empty; `diagnostics` say why. */
export interface Harmonic extends HarmonicNumbers {
  ok: boolean;
  diagnostics: Diagnostic[];
  /** As `Match.coarse`. */
  coarse: boolean;
  /** The in-between curves of the stages: closed, x and y of each point; a level may be several loops. */
  levels: { value: number; loops: Float64Array[] }[];
  /** Lines along the gradient from the inner curves to the outer one: x and y of each point. */
  lines: Float64Array[];
  /** The inner curve of each line. */
  lineCurves: Uint32Array;
  /** Of each line the parameter on its inner curve and that on the outer one, on the counter-clockwise curves. */
  lineParameters: Float64Array;
  /** null unless asked for, of two curves whose ruled blend is complete. */
  difference: HarmonicDifference | null;
}

/** Half the sum over the materials of the differences of the fractions, 0 to 1. */
export interface HarmonicDifference {
  largest: number;
  /** Where it is largest. */
  at: Point;
  /** Mean over the area. */
  mean: number;
}

/** Numbers of a harmonic blend. */
export interface HarmonicNumbers {
  /** The curve that contains the others. */
  outer: number | null;
  /** Segments of all curves. */
  segments: number;
  /** Pairs of lines that meet; lines that did not come to the outer curve and are left out. */
  crossings: number;
  lost: number;
  /** Most iterations for a quantity, and the largest residual over the right-hand side. */
  iterations: number;
  residual: number;
  /** What flows from the outer curve to the others, and the share of it that is missing on one side. */
  flux: number;
  fluxBalance: number;
  /** Area between the curves, and how much of each material is there. */
  area: number;
  amounts: number[];
  /** What the picture is made of. */
  vertices: number;
  triangles: number;
}

export interface JobOptions extends MatchOptions {
  paint?: PictureOptions;
  solid?: SolidOptions;
  solidFile?: SolidFileOptions;
  /** The options of `harmonic`: the last step has that. */
  harmonic?: HarmonicOptions;
  /** A question about a hyperpatch document: the name of a method of `Hyperpatch`, or `cells`, and its arguments by their names. */
  hyperpatch?: { question: Exclude<keyof Hyperpatch, "operations">; rest?: object };
  /** A question about a part document: the name of a method of `Part`, or `part`, and its arguments by their names. */
  part?: { question: Exclude<keyof Part, "bodies" | "diagnostics" | "box"> | "part"; rest?: object };
  greedy?: boolean;
  /** A distance transform; the document is left aside. */
  distanceTransform?: TransformInput;
  /** The boundary of a document of a boundary value problem, or with `points` the exact fractions there. */
  boundary?: { points?: Float64Array | number[] };
  /** A problem of Laplace's equation, whatever the document: `answer` is its solution. */
  solveLaplace?: LaplaceInput;
  /** A question about a solution: the name of one of its methods and the arguments of it. */
  laplace?: { solution: LaplaceSolution; question: "at" | "gradientAt" | "section"; first: any; options?: any };
}

/** What is known on an element: a value or an outward flux; with several materials a number for each. */
export type LaplaceCondition = { value: number | number[] } | { flux: number | number[] };

/** How the equations are solved; docs/api.md. */
export interface LaplaceSolver {
  /** `lu` up to 2000 elements. Default `gmres`. */
  method?: "gmres" | "lu";
  /** Default `jacobi`. `ssor` up to 8000 elements. */
  preconditioner?: "none" | "jacobi" | "ssor";
  /** Parameter of `ssor`, 0.01 to 1.99. Default 0.5. */
  omega?: number;
  /** Iterations after which GMRES starts anew, 1 to 1000. Default 100. */
  restart?: number;
  /** The true residual over the right-hand side at which to stop, 1e-12 to 0.1. Default 1e-6. */
  tolerance?: number;
  /** 1 to 5000. Default 500. */
  maxIterations?: number;
  /** Whether the condition number is estimated, up to 2000 elements. Default false. */
  condition?: boolean;
  /** Most elements whose matrix is kept, 0 to 8000; of more what is nearby is kept, and clusters far away are expanded in every product. Default 8000. */
  dense?: number;
}

/** A boundary with conditions. */
export interface LaplaceInput {
  dimension: 2 | 3;
  /** As many numbers a vertex as there are dimensions. Vertices with equal coordinates are one. */
  vertices: Float64Array | number[];
  /** As many vertices an element: segments with the material on their left, triangles counter-clockwise from outside of it. */
  elements: Uint32Array | number[];
  /** One for each element, or for each group. */
  conditions: LaplaceCondition[];
  /** Of each element the index of its condition. Default: each has its own. */
  groups?: Uint32Array | number[];
  /** Whether the materials are fractions that sum to 1. Default false. */
  composition?: boolean;
  solver?: LaplaceSolver;
}

/** Triangles as they were read from a file. */
export interface ReadMesh {
  /** Three coordinates each; those that are equal are one vertex. */
  vertices: Float64Array;
  /** Three vertices each, at most 32 000 triangles. */
  triangles: Uint32Array;
  /** Triangles with two equal vertices, which were left out. */
  dropped: number;
  format: "binary" | "text";
}

/** A document of a boundary value problem; docs/format.md defines every field. */
export interface LaplaceDocument {
  directrix: 1;
  kind: "laplace";
  title?: string;
  unit?: string;
  /** Two or more; their fractions are solved for. */
  materials?: Material[];
  model: LaplaceModel;
  /** Sets of elements with their conditions. */
  groups?: { name: string; where: LaplaceSelection; condition: LaplaceDatum }[];
  /** The condition of elements in no group. */
  rest?: LaplaceDatum;
  solver?: LaplaceSolver;
  /** A plane through a body in space, for display only. */
  section?: { origin: SpacePoint; normal: SpacePoint };
}

/** The body by its boundary: one that its numbers make, or triangles counter-clockwise as seen from outside. */
export type LaplaceModel =
  | { kind: "cube" | "cylinder" | "fillet-block" | "square"; divisions?: number }
  | { kind: "sliver-cube"; divisions?: number; width?: number }
  | { kind: "hollow-box"; divisions?: number; wall?: number }
  | { kind: "shell"; inner?: number; outer?: number; level?: number }
  | { kind: "sphere"; radius?: number; level?: number }
  | { kind: "mug"; sectors?: number; sliver?: number }
  | { kind: "annulus"; inner?: number; outer?: number; segments?: number }
  | { kind: "mesh"; vertices: SpacePoint[]; triangles: [number, number, number][] };

/** Which elements are meant: those for which everything that is given holds. Vectors have two coordinates in the plane. */
export interface LaplaceSelection {
  /** The outward normal is within `angle` degrees of it. */
  direction?: number[];
  /** Default 10. */
  angle?: number;
  /** Two opposite corners; the centroid lies between them. */
  box?: [number[], number[]];
  /** An expression in x, y, z and r that is above 0 at the centroid. */
  positive?: string;
  /** First and last index of runs of elements. */
  elements?: [number, number][];
}

/** For each material a number, or an expression in x, y, z and r, the distance to the z axis. */
export type LaplaceDatum = { value: (number | string)[] } | { flux: (number | string)[] };

/** The boundary that a document makes. Its first seven fields are what `solveLaplace` takes. */
export interface LaplaceBoundary {
  dimension: 2 | 3;
  vertices: Float64Array;
  elements: Uint32Array;
  /** Of each element the index of its condition; their number where it has none. */
  groups: Uint32Array;
  conditions: ({ value: number[] } | { flux: number[] })[];
  composition: true;
  /** With all defaults spelt out. */
  solver: LaplaceSolver;
  /** Of each condition the name of its set, and the length or area of its elements. */
  names: string[];
  measures: Float64Array;
  /** The groups of the document, and `rest` where it is there. A set with expressions has many conditions. */
  sets: { name: string; known: "value" | "flux"; count: number; measure: number }[];
  /** Of each element the index of its set; their number where it is in none. */
  members: Uint32Array;
  /** The solution where `exact` knows it. */
  exact: "constant" | "linear" | "cube" | "square" | "shell" | "annulus" | null;
  /** Whether nothing keeps it from being solved. */
  ready: boolean;
  diagnostics: LaplaceDiagnostic[];
}

/** What keeps a problem from being solved, or a remark; docs/api.md lists the codes. */
export interface LaplaceDiagnostic {
  code: string;
  /** Whether it can be solved all the same. */
  remark: boolean;
  /** Path of the field of the document; empty where it is the boundary. */
  path: string;
  message: string;
  /** Index of the first element that it concerns, where that is, and how many there are. */
  element?: number;
  place?: number[];
  count?: number;
  /** Of an expression: the character at fault, from 0. */
  character?: number;
}

/** What is said about a solution. Lists with an entry for each material leave out the last one of a composition, except `values` and `fluxes`. */
export interface LaplaceSummary {
  dimension: 2 | 3;
  elements: number;
  materials: number;
  /** Whether the tolerance was reached for every material. */
  converged: boolean;
  /** Iterations for each material; 0 with `lu`. */
  iterations: number[];
  /** For each material |b - A x|/|b| after each iteration, from 1 on; with `lu` once. */
  residuals: Float64Array[];
  /** The same of the preconditioned residual. */
  preconditionedResiduals: Float64Array[];
  /** An estimate of the condition number in the 1-norm, from below; null unless asked for. */
  condition: number | null;
  /** Milliseconds. */
  times: { assembly: number; solve: number };
  /** For each material a value on each element, and the outward flux; beside jumps of given values fluxes mean nothing. */
  values: Float64Array[];
  fluxes: Float64Array[];
  /** Connected parts of the boundary: 1, and one for each cavity. */
  parts: number;
  /** Area or volume. */
  measure: number;
  /** Largest share of the full angle that is missing where the boundary is seen from inside or from an element. */
  closure: number;
  /** For each material the whole outward flux over its size. */
  fluxBalance: number[];
  /** With fluxes alone, the largest share of the whole flux that was missing and was spread evenly; else 0. */
  imbalance: number;
  /** Least and greatest value inside, for each material; null where fluxes alone are given. */
  ranges: ([number, number] | null)[];
}

/** What is at points. */
export interface LaplacePoints {
  /** A number for each material, of gradients one for each dimension as well, one point after the other; NaN outside. */
  values: Float64Array;
  /** Points where a value was taken back to the range. */
  clamped: number;
  outside: number;
}

/** Pixels: a corner, two sides, along which pixels and rows run, and their numbers; in the plane `longest` alone gives the box of the boundary. */
export type LaplaceFrame = { origin: number[]; sides: [number[], number[]]; size: [number, number] } | { longest: number };

/** What is on pixels. */
export interface LaplaceSection {
  size: [number, number];
  /** For each material the value in the middle of each pixel, row by row; NaN outside. */
  values: Float32Array[];
  /** Pixels inside. */
  inside: number;
  /** Pixels where a value was taken back to the range. */
  clamped: number;
}

/** A solution of Laplace's equation. */
export interface LaplaceSolution extends LaplaceSummary {
  /** Coordinates one point after the other. A point outside throws the code `outside`, or with `skip` has no numbers. */
  at(points: Float64Array | number[], options?: { outside?: "refuse" | "skip" }): LaplacePoints;
  gradientAt(points: Float64Array | number[], options?: { outside?: "refuse" | "skip" }): LaplacePoints;
  section(frame: LaplaceFrame): LaplaceSection;
}

/** The same over a connection. */
export type RemoteLaplaceSolution = LaplaceSummary & {
  [K in "at" | "gradientAt" | "section"]: Asynchronous<LaplaceSolution[K]>;
};

/** A grid with features; docs/api.md. */
export interface TransformInput {
  /** Voxels along x, y and z, or pixels along x and y. */
  size: [number, number] | [number, number, number];
  /** Lengths between neighbouring centres. Default: 1 each. */
  spacing?: [number, number] | [number, number, number];
  /** A number for each voxel, x fastest: other than 0 where it belongs to a feature. */
  features: Uint8Array;
  /** Distances above it are Infinity. Default: Infinity. */
  limit?: number;
}

/** What both methods do in the plane. Squared distances are in pixels, and Infinity without a feature; x runs fastest. */
export interface TransformSteps {
  /** Squared distance of each pixel to the nearest feature in its row. */
  rows: Float32Array;
  /** Squared distance of each pixel to the nearest feature. */
  levels: Float32Array;
  columns: {
    /** The rows whose parabolas make up the lower envelope, ascending. */
    corners: number[];
    /** The searches of the paper's scan: of `reach` pixels that the bound allows, after `from` or before it, `count` were compared. */
    searches: { from: number; forward: boolean; reach: number; count: number }[];
  }[];
}

/** A point [x, y, z], z up, or parameters [u, v, w]. */
export type Triple = [number, number, number];

/** A face of a cell: where one parameter is 0 or 1. */
export type FaceName = "u0" | "u1" | "v0" | "v1" | "w0" | "w1";

/** From best to worst: see docs/api.md. */
export type VerdictName = "regular" | "valid" | "locally-valid" | "degenerate" | "invalid";

/** A cell of a body in short. */
export interface CellSummary {
  /** Its number, which no later deletion of another cell changes. */
  id: number;
  /** Its corners, w fastest, then v. */
  corners: Triple[];
  /** How regular it is, -1 to 1. */
  margin: number;
  /** Negative where the cell is mirrored. */
  volume: number;
}

/** The verdict on a cell. */
export interface CellVerdict {
  cell: number;
  verdict: VerdictName;
  /** How regular it is, -1 to 1; above 0 the cone condition holds. */
  margin: number;
  /** The least Jacobian determinant that was found; of a mirrored cell that of the reoriented one. */
  leastJacobian: number;
  /** It is proven to be nowhere less. */
  leastJacobianBound: number;
  /** What shows that the cell is invalid or degenerate: a place where the determinant is not positive, or two parameters with one point. */
  witness: { kind: "folded"; at: Triple; jacobian: number; point: Triple } | { kind: "meeting"; at: Triple; other: Triple; point: Triple } | null;
  mirrored: boolean;
}

/** How two cells lie to each other; pairs that are not listed are disjoint. */
export interface CellRelation {
  /** The lower number first. */
  cells: [number, number];
  relation: "shares" | "overlaps" | "touches" | "not-proven";
  /** Of `shares`: exactly so many faces, edges that are on none of them, and corners that are on neither. */
  faces?: number;
  edges?: number;
  corners?: number;
  /** Of `overlaps`: a point inside both. */
  point?: Triple;
  /** Of `overlaps`: its parameters in both cells; of `touches`: a place in the first. */
  at?: Triple[];
}

/** What is to be said about a body as a whole. */
export interface BodySummary {
  /** Number of cells. */
  cells: number;
  /** Number of cells with each verdict. */
  verdicts: Record<VerdictName, number>;
  mirrored: number;
  /** The cell with the worst verdict and, of those, the least margin; null without cells. */
  worst: CellVerdict | null;
  /** Pairs that overlap, touch besides what they share, or of which nothing was proven. */
  pairs: CellRelation[];
  sharedFaces: number;
  outerFaces: number;
  /** Largest difference between 1 and the sum of the fractions, of all coefficients and so of all points. */
  sumError: number;
}

/** Triangles in cells, with the material at their vertices. */
interface BodyTriangles {
  /** Three numbers a vertex. Vertices are not shared between cells or faces. */
  positions: Float32Array;
  /** Three numbers a vertex: u, v, w in its cell. */
  parameters: Float32Array;
  /** The number of the cell of each vertex. */
  cells: Uint32Array;
  /** As many numbers a vertex as there are materials. */
  fractions: Float32Array;
  /** Four numbers a vertex: sRGB, mixed in Oklab, and 255. */
  colors: Uint8Array;
  /** Three vertices a triangle. */
  indices: Uint32Array;
}

/** What belongs to one cell, or to one of its faces. */
interface BodyPatch {
  cell: number;
  vertexStart: number;
  vertexCount: number;
  /** Of the first one in `indices`. */
  start: number;
  /** In `indices`. */
  count: number;
}

/** What a plane cuts out of a body. Triangles run counter-clockwise against the normal. */
export interface BodySection extends BodyTriangles {
  /** Two vertices a piece: where cells end. */
  outline: Uint32Array;
  area: number;
  patches: (BodyPatch & { outlineStart: number; outlineCount: number })[];
}

/** The boundary of a body: the faces that one cell alone has. Triangles run counter-clockwise from outside. */
export interface BodySurface extends BodyTriangles {
  /** The number of the surface, to be given as `since` when the next one is asked for. */
  id: number;
  /**
   * null: all of it is here. Else the number of the surface to which this is what differs: all lists hold only what is new, one after the other, and
   * `vertexStart`, `start` and `index` say where it belongs in those of that surface, whose other places stay as they are. `renewSurface` puts it there.
   */
  since: number | null;
  /** Three numbers a vertex: unit normals, outwards. */
  normals: Float32Array;
  patches: (BodyPatch & { face: FaceName })[];
  /** No point of a face is farther than this from the triangles. */
  deviation: number;
  /** Three numbers a point: the boundary curves, one after the other. */
  edgePositions: Float32Array;
  /**
   * Each boundary curve once: a cell and its edge, along `axis` and at the start (0) or the end (1) of both other axes; how many cells have it; its
   * points in `edgePositions`.
   */
  edges: { index: number; cell: number; axis: "u" | "v" | "w"; ends: number[]; cells: number; start: number; count: number }[];
  /** Each corner once: a cell and its corner, 0 or 1 along u, v and w; how many cells have it. */
  corners: { index: number; cell: number; corner: number[]; cells: number; position: Triple }[];
}

/** Places of a surface with new values: where each stretch starts and how long it is, in vertices, in `indices`, and in points of curves. */
export interface SurfaceRanges {
  vertices: [number, number][];
  indices: [number, number][];
  edges: [number, number][];
}

/** How cells continue each other, in shape and in material apart. */
export interface BodyContinuity {
  /** Across each face that two cells share: of the whole face, and of the block at each of its corners (as those of the first cell). */
  faces: {
    sides: { cell: number; face: FaceName }[];
    /** How the parameters of the first face become those of the second: they change places, then each may run backwards. */
    swapped: boolean;
    reversed: boolean[];
    shape: "C0" | "C1";
    material: "none" | "C0" | "C1";
    corners: { corner: number[]; shape: "C0" | "C1"; material: "none" | "C0" | "C1" }[];
  }[];
  /** Faces that have corners in common, with their blocks, and part from there: with the largest distance between them. */
  contacts: {
    sides: { cell: number; face: FaceName }[];
    swapped: boolean;
    reversed: boolean[];
    /** Those that are common, as corners of the first cell. */
    corners: number[][];
    gap: number;
  }[];
}

/** All corners, edges and faces of a body, each with every cell that has it. */
export interface BodySharing {
  corners: { position: Triple; sides: { cell: number; corner: number[] }[] }[];
  edges: { sides: { cell: number; axis: "u" | "v" | "w"; ends: number[] }[] }[];
  faces: { sides: { cell: number; face: FaceName }[] }[];
  /** How many of each two or more cells have. */
  shared: { corners: number; edges: number; faces: number };
}

/** Points on a grid of parameters of a cell, w fastest, then v. */
export interface CellGrid {
  /** Along u, v and w. */
  counts: Triple;
  x: Float32Array;
  y: Float32Array;
  z: Float32Array;
  /** One array for each material. */
  fractions: Float32Array[];
}

/** The cells and coefficients round a corner. */
export interface CornerNeighbourhood {
  /** Every cell at the point, each with the corner that lies there. */
  cells: { cell: number; corner: number[] }[];
  /** Whether the cells lie in a grid of two by two by two, which may have gaps; else the corner is a crease. */
  regular: boolean;
  /** The coefficients of the blocks there, equal ones once, the corner among them: up to 27 where eight cells meet. */
  points: {
    /** Along the axes of the cell that was asked about, -1, 0 or 1 each, towards the end of the axis positive; null where there is no grid. */
    offset: Triple | null;
    position: Triple;
    mix: number[];
    /** Whether some cells have another mix there. */
    jumps: boolean;
    /** The cells that have it, each with its place. */
    users: { cell: number; at: Triple }[];
  }[];
  /** The faces between cells at the corner: what holds there, or what is marked. */
  joints: {
    sides: { cell: number; face: FaceName; corner: number[] }[];
    shape: MarkName;
    material: MarkName;
    shapeMarked: boolean;
    materialMarked: boolean;
  }[];
}

/** What is to be known of cells that an operation made, each with a message in words. */
export interface AdditionChecks {
  /** Those that are still there. */
  cells: number[];
  /** Whether each is proven to meet itself nowhere and is the right way round; `verdicts` has those that are not. */
  injective: { ok: boolean; verdicts: CellVerdict[]; message: string };
  /** Whether they are proven to meet others only in corners, edges and faces; `pairs` has those that are not. */
  meetings: { ok: boolean; pairs: CellRelation[]; message: string };
  /** At how many corners of the faces that they share the shape, and the material, run on. */
  continuity: { faces: number; corners: number; shape: number; material: number; message: string };
}

/** A body of hyperpatches. All methods throw `DirectrixError`. */
export interface Hyperpatch {
  readonly cells: CellSummary[];
  /** What came of each operation, in their order. */
  readonly operations: OperationResult[];
  /** What would move with a coefficient, itself among them, each with its share of the displacement. */
  moves(cell: number, at: Triple, reach?: Reach): { cell: number; at: Triple; share: number }[];
  /** The cells and coefficients round a corner: what a person who edits it sees. */
  neighbourhood(cell: number, corner: Triple): CornerNeighbourhood;
  /** The three checks of the cells that an operation made, in the body as it is. */
  checks(operation: number): AdditionChecks;
  /** The body as a document with one operation, which writes all cells out; their numbers begin anew. */
  cellsDocument(): HyperpatchDocument;
  /** The coefficients of all cells, in their order and that of the format: three numbers each, and one number for each material. */
  coefficients(): { positions: Float64Array; mixes: Float64Array };
  sample(cell: number, uvw: Triple): { position: Triple; mix: number[] };
  /** With `global: false` only the certificates: a cell may then be `locally-valid`. Default true. */
  verdicts(options?: { global?: boolean }): CellVerdict[];
  summary(): BodySummary;
  volume(): number;
  /** Volume of each material. */
  amounts(): number[];
  /** `steps` along each axis of a cell, 1 to 64, default 8. */
  section(plane: { normal: Triple; offset?: number; point?: Triple }, options?: { steps?: number }): BodySection;
  /** Default of the chord tolerance: a thousandth of the diagonal of the body. With `faces: "all"` the faces between cells follow, once for each cell. */
  surface(options?: { tolerance?: number; faces?: "outer" | "all"; since?: number }): BodySurface;
  /** null outside; on what several cells share the one with the lowest number answers. */
  probe(point: Triple): { cell: number; uvw: Triple; mix: number[] } | null;
  relations(): CellRelation[];
  continuity(): BodyContinuity;
  sharing(): BodySharing;
  /** 2 to 512 points along each axis, at most 2 097 152. */
  grid(cell: number, counts: Triple): CellGrid;
  /** The surface as binary STL, binary PLY with colours and fractions, OBJ with colours; the cells as an unstructured grid of VTK. */
  file(options: { format: "stl" | "ply" | "obj" | "vtu"; tolerance?: number }): Uint8Array;
}

/** A body whose questions a worker answers. */
export type RemoteHyperpatch = Pick<Hyperpatch, "cells" | "operations"> & {
  [K in Exclude<keyof Hyperpatch, "cells" | "operations">]: Asynchronous<Hyperpatch[K]>;
};

/** What there is to say about a part document that could be read; docs/api.md lists the codes. */
export interface PartDiagnostic {
  code: string;
  /** Whether what stands at `path` is left out; a remark else. */
  skipped: boolean;
  path: string;
  message: string;
  body?: number;
  feature?: number;
  /** Index of the piece of the boundary in the blend of the body. */
  boundary?: number;
  /** Of an expression: the character at fault, from 0. */
  character?: number;
  at?: Point;
}

/** Two opposite corners. */
export type Box = [Point, Point];

/** The pixels of a raster. Default: the box of all bodies, and 256 along its longer side. */
export interface RasterOptions {
  box?: Box;
  size?: [number, number];
  /** In place of `size` the width of square pixels, as a printer has them; the box grows evenly to whole ones. */
  pitch?: number;
}

/** What a file of a part is. A `png` of one `material` is grey, and `slices` are a ZIP archive with such a picture of each material. */
export type PartFileOptions = RasterOptions &
  ({ format: "csv" | "vti" | "nrrd" } | { format: "png"; material?: number; dither?: Dither } | { format: "slices"; dither?: Dither });

/** How fractions become pixels that have one material each: not, by error diffusion, or by a mask of blue noise. */
export type Dither = "none" | "diffusion" | "blue-noise";

/** Pixels in rows from the top, evaluated at their centres. */
export interface PartRaster {
  size: [number, number];
  box: Box;
  /** 0 outside, else one more than the index of the body. */
  body: Uint8Array;
  /** One array for each material. */
  fractions: Float32Array[];
  /** Which features hold a pixel: bit k for the feature k of the body. */
  leaves: Uint32Array;
  /** Straight RGBA, transparent outside. */
  colors?: Uint8Array;
}

export interface PartPlace {
  body: number;
  /** null in a body by the rule `printed`, which needs a raster. */
  fractions: number[] | null;
  leaf: number;
  /** Of each feature that takes part: what its profile is a function of, and whether its band holds that. */
  distances: { feature: number; name: string; distance: number; holds: boolean }[];
  /** The feature with the least distance. */
  nearest: number | null;
}

/** A part. All methods throw `DirectrixError`. */
export interface Part {
  readonly bodies: {
    name: string;
    rule: "repaired" | "depth" | "printed";
    /** Whether it could be made. */
    made: boolean;
    box: Box | null;
    /** Number of elements of its blend; null without one. */
    blend: number | null;
    /** Which take part: those that are not hidden and have no fault. */
    features: { name: string; active: boolean }[];
  }[];
  readonly diagnostics: PartDiagnostic[];
  readonly box: Box | null;
  evaluate(options?: RasterOptions & { colors?: boolean }): PartRaster;
  /** null outside all bodies. */
  probe(point: Point): PartPlace | null;
  /** At 2 to 10 000 places from one point to another. Fractions are NaN outside, and in bodies by the rule `printed`. */
  along(ends: [Point, Point], count: number): { body: Uint8Array; fractions: Float64Array[]; leaves: Uint32Array };
  /** `pixels` has bit k where rule k is broken. */
  violations(options?: RasterOptions): {
    size: [number, number];
    box: Box;
    rules: { rule: number; name: string; count: number; area: number }[];
    pixels: Uint32Array;
  };
  /** As seen from above: of bodies that lie over each other the later one counts. */
  amounts(options?: RasterOptions): { area: number; amounts: number[]; bodies: { area: number; amounts: number[] }[] };
  /** At most 1 048 576 pixels. Default: the first material, every tenth. */
  isolines(options?: RasterOptions & { material?: number; levels?: number[] }): Isoline[];
  /** The leaves of the subdivision that there are, each with the features that hold it. */
  leaves(options?: RasterOptions): { body: number; leaf: number; features: number[]; names: string[]; area: number }[];
  /** At most 4 194 304 pixels. */
  file(options: PartFileOptions): Uint8Array;
  /** The document with every default spelt out. */
  defaults(): PartDocument;
}

/** A part whose questions a worker answers. */
export type RemotePart = Pick<Part, "bodies" | "diagnostics" | "box"> & {
  [K in Exclude<keyof Part, "bodies" | "diagnostics" | "box">]: Asynchronous<Part[K]>;
};

/** Triangles of one part of a solid. */
export interface SolidGroup {
  name: "surface" | "cap";
  /** Of a cap: the number of its curve. */
  curve?: number;
  /** Of the first one in `indices`. */
  start: number;
  /** In `indices`. */
  count: number;
}

/** The ruled surface of a document in space, in the unit of the document, z up; empty where there is none. */
export interface Solid {
  /** Whether the matching is complete and there is a surface, which is watertight unless it is open or caps were not asked for. */
  ok: boolean;
  diagnostics: Diagnostic[];
  /** Three numbers a vertex. Vertices at creases and rims are there once for each side. */
  positions: Float32Array;
  /** Three numbers a vertex: unit normals, outwards. */
  normals: Float32Array;
  /** Four numbers a vertex: sRGB and 255. */
  colors: Uint8Array;
  /** As many numbers a vertex as there are materials. */
  fractions: Float32Array;
  /** With the colours `twist` and `flank`: degrees at each vertex. */
  scalar: Float32Array | null;
  /** What the ends of the map of colours stand for: fractions or degrees; null with the colours `material`. */
  range: [number, number] | null;
  /** Three vertices a triangle, counter-clockwise from outside. */
  indices: Uint32Array;
  groups: SolidGroup[];
  /** Six numbers a line of the matching: its ends on the first and the second curve. */
  rulings: Float32Array;
  /** In-between curves j = 0 to M from the first curve on: polylines x, y, z over all rulings, closed between closed curves. */
  stages: Float32Array[];
  /** The two curves, as such polylines. */
  curves: Float32Array[];
  /** null where there is no surface. */
  bounds: { min: [number, number, number]; max: [number, number, number] } | null;
  /** Whether every edge belongs to two triangles that run along it in opposite directions, where vertices with the same position are one. */
  watertight: boolean;
  /** Volume inside; null unless `watertight`. */
  volume: number | null;
  area: number;
  /** Of curves in space; else null. */
  projection: Projection | null;
}

/** The functions of a module. All throw `DirectrixError`. */
export interface Directrix {
  match(document: DocumentInput, options?: MatchOptions): Match;
  stages(document: DocumentInput, options?: { refine?: number }): Stage[];
  /** In the module `full` alone; that of `figure` throws with the code `not-in-module`. */
  cells(document: DocumentInput): UnitCell[];
  /** One entry for each level, in the order asked for; empty unless the matching is complete. */
  isolines(document: DocumentInput, options?: IsolineOptions): Isoline[];
  probe(document: DocumentInput, point: Point): Probe | null;
  steps(document: DocumentInput): Steps;
  sets(document: DocumentInput, options: SetsOptions): VertexSets;
  paint(document: DocumentInput, options: PictureOptions): Picture;
  /** In the module `full` alone; that of `figure` throws with the code `not-in-module`. */
  svg(document: DocumentInput, options: PictureOptions): string;
  fit(document: DocumentInput, options: PictureSize): View;
  /** In the module `full` alone; that of `figure` throws with the code `not-in-module`. */
  insertPoint(document: DocumentInput, curve: number, u: number): CurvesDocument;
  defaults(document: DocumentInput): CurvesDocument;
  /** The document of two neighbours of a stack, curve `span` and the next, for functions that take two curves. */
  span(document: DocumentInput, span: number): CurvesDocument;
  /** null where there is no such line. In the module `full` alone; that of `figure` throws with the code `not-in-module`. */
  explain(document: DocumentInput, line: number): Explanation | null;
  /** In the module `full` alone; that of `figure` throws with the code `not-in-module`. */
  readShapes(text: string, options?: { format?: "svg" | "points" | "auto" }): ShapeList;
  /** In the module `full` alone; that of `figure` throws with the code `not-in-module`. */
  fitCurve(points: Point[], options: FitOptions): FittedCurve;
  /**
   * null unless the matching is complete or repaired. In the module `full` alone; that of `figure` throws with the code `not-in-module`.
   */
  morphPaths(document: DocumentInput, options?: MorphPathsOptions): MorphPaths | null;
  /** The blend of a document of the kind `harmonic`. In the module `full` alone; that of `figure` throws with the code `not-in-module`. */
  harmonic(document: DocumentInput, options?: HarmonicOptions): Harmonic;
  /**
   * null unless the matching is complete or repaired. In the module `full` alone; that of `figure` throws with the code `not-in-module`.
   */
  amounts(document: DocumentInput): Amounts | null;
  /** In the module `full` alone; that of `figure` throws with the code `not-in-module`. */
  solid(document: DocumentInput, options?: SolidOptions): Solid;
  /**
   * The bytes of a file of the solid. Throws with the code `no-solid` where there is none. In the module `full` alone; that of `figure` throws with
   * the code `not-in-module`.
   */
  solidFile(document: DocumentInput, options: SolidFileOptions): Uint8Array;
  /** In the module `full` alone; that of `figure` throws with the code `not-in-module`. */
  hyperpatch(document: HyperpatchDocument | string): Hyperpatch;
  /** A document with the cells of another one after its own operations. Materials of the same name and colour are one, others are appended. */
  merge(document: HyperpatchDocument | string, other: HyperpatchDocument | string): HyperpatchDocument;
  /** In the module `full` alone; that of `figure` throws with the code `not-in-module`. */
  part(document: PartDocument | string): Part;
  /** Laplace's equation by boundary elements. In the module `full` alone; that of `figure` throws with the code `not-in-module`. */
  solveLaplace(input: LaplaceInput): LaplaceSolution;
  /** The triangles of an STL file, binary or text, of at most 16 MiB. In the module `full` alone; that of `figure` throws with the code `not-in-module`. */
  readMesh(bytes: Uint8Array | ArrayBuffer): ReadMesh;
  /** The boundary that a document makes, with the condition of each element. In the module `full` alone; that of `figure` throws with the code `not-in-module`. */
  boundary(document: LaplaceDocument | string): LaplaceBoundary;
  /**
   * Exact fractions at points, coordinate after coordinate, where the solution is known: a number for each material, point after point. Throws with the code
   * `no-exact` where it is not, and with `outside` for a point where it ends. In the module `full` alone; that of `figure` throws with the code `not-in-module`.
   */
  exact(document: LaplaceDocument | string, points: Float64Array | number[]): Float64Array;
  /** The distance from the centre of every voxel to the nearest centre of a feature; Infinity where there is none. Module `full`. */
  distanceTransform(input: TransformInput): Float32Array;
  /** The transform of a plane of at most 16 384 square pixels as it can be watched, without a limit. Module `full`. */
  transformSteps(input: TransformInput): TransformSteps;
  /**
   * With `paint`, its option `coarse` counts; with `greedy` it solves what `steps` and `sets` ask for; `solid` and `solidFile` are the options of
   * these functions; `hyperpatch` and `part` are questions about documents of these kinds.
   */
  job(document: DocumentInput | HyperpatchDocument | PartDocument | LaplaceDocument | null, options?: JobOptions): Job;
}

export interface LoadOptions {
  /** Default `full`. */
  module?: "figure" | "full";
  /** Where the module is, or its bytes. Default: beside the package's own files. */
  wasm?: URL | string | BufferSource;
}

export interface ConnectOptions {
  module?: "figure" | "full";
  wasm?: string | BufferSource;
}

/** Last argument of every function of a connection. */
export interface Control {
  /** Aborts the call: its promise rejects with the signal's reason. */
  signal?: AbortSignal;
  /** Called with the share done, 0 to 1, while a document is being solved. */
  onprogress?: (progress: number) => void;
  /** Called with the milliseconds that the worker spent on solving, and on painting for a picture; next to none for a document that is remembered. */
  onsolved?: (milliseconds: number) => void;
}

type Asynchronous<F> = F extends (...args: infer A) => infer R ? (...args: [...A, control?: Control]) => Promise<R> : never;

/** The functions of a module in a worker, as promises. */
export type Connection = { [K in Exclude<keyof Directrix, "job" | "hyperpatch" | "part" | "solveLaplace">]: Asynchronous<Directrix[K]> } & {
  hyperpatch(document: HyperpatchDocument | string, control?: Control): Promise<RemoteHyperpatch>;
  part(document: PartDocument | string, control?: Control): Promise<RemotePart>;
  solveLaplace(input: LaplaceInput, control?: Control): Promise<RemoteLaplaceSolution>;
  /** Ends the worker. */
  close(): void;
  /** The worker of the page's own origin, or one made on the page because the package comes from another. */
  readonly runsIn: "worker" | "blob worker";
  /** Called when a new worker has taken over from one whose module trapped. */
  onrestart: (() => void) | undefined;
};

/** Loads a module once. Rejects when it cannot be loaded. */
export function load(options?: LoadOptions): Promise<Directrix>;

/** Starts a worker; browsers only. */
export function connect(options?: ConnectOptions): Promise<Connection>;

/**
 * What a matching is worth in one sentence, for captions and screen readers: `44 lines, none crossing, none blocked, eta 0.981`. It speaks of
 * one-to-one lines where there are such, and counts what fails.
 */
export function describe(match: Match): string;

/** The curves of a document in a sentence each: degree, control points, size, materials. */
export function describeCurves(document: CurvesDocument): string;

/**
 * What is known of a body in one sentence: `8 cells, all regular, none overlapping, materials sum to 1`. It counts what fails and says what holds once.
 */
export function describeBody(summary: BodySummary): string;

/** What is known of a part, in a sentence: its bodies and features, what it is made of, and the design rules that are broken. */
export function describePart(
  part: Pick<Part, "bodies" | "diagnostics">,
  found: { materials: readonly { name: string }[]; amounts: { area: number; amounts: number[] }; rules?: readonly { name: string; count: number }[] },
): string;

/**
 * Puts what `surface({ since: surface.id })` brought into the arrays of that surface, and says which places have new values. null, and nothing is changed,
 * when it is no change of that surface: then it is a whole one and takes its place.
 */
export function renewSurface(surface: BodySurface, change: BodySurface): SurfaceRanges | null;

/** What a link says: the document it leads to, and how that is shown. Of `document`, `preset` and `url` at most one is there. */
export interface Link {
  /** Carried whole by the link. */
  document?: CurvesDocument;
  /** The name of a preset, such as `amoeba`. */
  preset?: string;
  /** The address of a document, from which it is fetched once a person agrees. */
  url?: string;
  /** Default `figure`. */
  view?: "figure" | "steps" | "compare" | "solid";
  /** Of the view `steps`: a whole number from 1. */
  step?: number;
  /** Default `full`. */
  controls?: "full" | "minimal" | "none";
  /** Default `auto`, which follows the system. */
  theme?: "auto" | "light" | "dark";
  /** Of an embedded figure: whether it loads by itself or when a person asks for it. Default `auto`. */
  reveal?: "auto" | "interaction";
}

export type ErrorCode =
  | "syntax"
  | "missing"
  | "unknown-field"
  | "type"
  | "range"
  | "non-finite"
  | "version"
  | "kind"
  | "not-yet"
  | "limit"
  | "points"
  | "knots"
  | "zero-length"
  | "self-intersection"
  | "contact"
  | "no-solid"
  | "no-exact"
  | "mesh"
  | "outside"
  | "not-in-module"
  | "link"
  | "trap"
  | "closed"
  | "no-worker"
  | "failed";

export class DirectrixError extends Error {
  constructor(code: string, path: string, message: string, at?: Point, place?: number[]);
  readonly code: ErrorCode | (string & {});
  readonly path: string;
  readonly at: Point | undefined;
  /** All coordinates of the place, of problems in the plane or in space. */
  readonly place: number[] | undefined;
}
