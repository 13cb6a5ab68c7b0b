/**
 * Numbers that the text of a lesson may state, each with what the kernel says about the figure of the step. The tests hold every stated
 * number against it.
 *
 * @import { Directrix } from "../../js/directrix.js"
 *
 * @typedef {object} Question What a fact is asked about.
 * @property {Directrix} dx
 * @property {any} document of the figure, with its changes
 * @property {"figure" | "steps" | "body" | "part" | "grid" | "laplace"} view
 *
 * @typedef {object} FactKind
 * @property {number} arguments numbers behind its name
 * @property {string} meaning
 * @property {(question: Question, ...numbers: number[]) => number} of
 */
import { pieces } from "../../www/src/lessons/certificate.js";
import { errorsOf, marksOf, measured } from "../../www/src/lessons/grid-known.js";
import { circleOf, farthest, inputOf, probes, summed, withSteps } from "../../www/src/lessons/laplace-known.js";
import { COURSES, distanceOf, placesOf, RULES, sampled, voxels, withFeature, withRule } from "../../www/src/lessons/part-known.js";

/** What the figure shows: of the greedy growth where it shows that. @param {Question} question */
const result = ({ dx, document, view }) => (view === "steps" ? dx.steps(document) : dx.match(document));

/** @param {Question} question */
const totals = (question) => {
  const { pairs, lines } = result(question).totals;
  return /** @type {any} */ (pairs ?? lines);
};

/** η by another method, with everything else the same. @param {string} method @returns {FactKind} */
const eta = (method) => ({
  arguments: 0,
  meaning: `η of the same curves by the method ${method}`,
  of: ({ dx, document }) => totals({ dx, document: { ...document, matching: { ...document.matching, method } }, view: "figure" }).eta,
});

/** A line of the growth, counted from 1. @param {Question} question @param {number} number */
function grown({ dx, document }, number) {
  const line = dx.steps(document).growth[number - 1];
  if (!line) throw new RangeError(`the growth has no line ${number}`);
  return line;
}

/** What the start of line number `number` sees and may have just before it is accepted. @param {Question} question @param {number} number */
const setsOf = (question, number) =>
  question.dx.sets(question.document, { step: number - 1, vertex: grown(question, number).from });

/**
 * The fraction of a material at the share s of every line, if it is the same on all of them.
 * @param {Question} question
 * @param {number} material from 1
 * @param {number} s
 */
function fraction({ dx, document }, material, s) {
  const all = dx.match(document).pairs.map(({ from, to }) => {
    const place = dx.probe(document, [from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])]);
    return place?.fractions[material - 1] ?? NaN;
  });
  const [first = NaN] = all;
  if (!all.every((each) => Math.abs(each - first) < 1e-6)) throw new RangeError(`the fraction of material ${material} differs along s = ${s}`);
  return first;
}

/** Fractions at points of a boundary value problem. @param {Question} question @param {number[]} points */
const solvedAt = ({ dx, document }, points) => dx.solveLaplace(inputOf(dx.boundary(document))).at(points).values;

/**
 * The fraction of a material (from 1) at a place, with one of both blends.
 * @param {"ruled" | "harmonic"} kind
 * @returns {FactKind}
 */
const blended = (kind) => ({
  arguments: 3,
  meaning: `fraction of a material (from 1) at x and y, with the blend ${kind}`,
  of: ({ dx, document }, material, x, y) => dx.probe({ ...document, blend: { ...document.blend, kind } }, [x, y])?.fractions[material - 1] ?? NaN,
});

/** How far the harmonic blend of two curves is from the ruled one. @param {Question} question */
const difference = ({ dx, document }) =>
  dx.harmonic({ ...document, blend: { ...document.blend, kind: "harmonic" } }, { difference: true }).difference ?? { largest: NaN, mean: NaN };

/** The harmonic blend of a figure in numbers. @param {Question} question */
const flow = ({ dx, document }) => dx.match(document).harmonic ?? { lines: NaN, crossings: NaN };

/** The body of a figure. @param {Question} question */
const cellOf = ({ dx, document }) => dx.hyperpatch(document);

/** Parameters at which a cubic is known from four of its values. */
const NODES = [0, 1 / 3, 2 / 3, 1];

/**
 * The derivative at t of the cubic through four values at the nodes: exact for what is cubic along its parameter.
 * @param {number[]} values
 * @param {number} t
 */
function slope(values, t) {
  return values.reduce((sum, value, n) => {
    const others = NODES.filter((_, m) => m !== n);
    const below = others.reduce((product, node) => product * (NODES[n] - node), 1);
    const [a, b, c] = others.map((node) => t - node);
    return sum + (value * (a * b + b * c + a * c)) / below;
  }, 0);
}

/** The Jacobian determinant, from positions that the kernel gives. @param {Question} question @param {number[]} uvw */
function jacobian(question, uvw) {
  const body = cellOf(question);
  const tangents = [0, 1, 2].map((axis) => {
    const along = NODES.map((node) => body.sample(0, /** @type {[number, number, number]} */ (uvw.map((own, k) => (k === axis ? node : own)))).position);
    return [0, 1, 2].map((k) => slope(along.map((position) => position[k]), uvw[axis]));
  });
  const [a, b, c] = tangents;
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/**
 * The weight of a coefficient at a place: how far the place goes when the coefficient goes by 1, which is asked of the kernel.
 * @param {Question} question
 * @param {number} i
 * @param {number} j
 * @param {number} k
 * @param {...number} uvw
 */
function weight({ dx, document }, i, j, k, ...uvw) {
  const moved = structuredClone(document);
  moved.operations[0].cells[0].coefficients[(4 * i + j) * 4 + k].position[0] += 1;
  const [x, before] = [moved, document].map((each) => dx.hyperpatch(each).sample(0, /** @type {[number, number, number]} */ (uvw)).position[0]);
  return x - before;
}

/** The cells of a body after all operations. @param {Question} question */
const cellsOf = (question) => /** @type {any} */ (cellOf(question).cellsDocument().operations[0]).cells;

/** The Bernstein polynomials of degree 8 at t. @param {number} t */
const bernstein8 = (t) => [1, 8, 28, 56, 70, 56, 28, 8, 1].map((count, n) => count * t ** n * (1 - t) ** (8 - n));

/** The inverse of a square matrix, by Gauss and Jordan with the largest pivots. @param {number[][]} matrix */
function inverse(matrix) {
  const size = matrix.length;
  const rows = matrix.map((row, n) => [...row, ...row.map((_, m) => (m === n ? 1 : 0))]);
  for (let n = 0; n < size; n += 1) {
    const pivot = rows.slice(n).reduce((best, row, k) => (Math.abs(row[n]) > Math.abs(rows[best][n]) ? n + k : best), n);
    [rows[n], rows[pivot]] = [rows[pivot], rows[n]];
    rows[n] = rows[n].map((value) => value / rows[n][n]);
    rows.forEach((row, k) => {
      if (k !== n) rows[k] = row.map((value, m) => value - row[n] * rows[n][m]);
    });
  }
  return rows.map((row) => row.slice(size));
}

/**
 * The 729 Bernstein coefficients of the Jacobian, from its values at 9 x 9 x 9 places, which follow from positions that the kernel gives: not
 * the way that the page finds them.
 * @param {Question} question
 */
export function numbersOf(question) {
  const body = cellOf(question);
  const nodes = Array.from({ length: 9 }, (_, n) => n / 8);
  const places = NODES.flatMap((u) => NODES.flatMap((v) => NODES.map((w) => body.sample(0, [u, v, w]).position)));
  const values = NODES.map((_, n) => (/** @type {number} */ t) => NODES.reduce((product, node, m) => (m === n ? product : (product * (t - node)) / (NODES[n] - node)), 1));
  const slopes = NODES.map((_, n) => (/** @type {number} */ t) => slope(NODES.map((_, m) => (m === n ? 1 : 0)), t));
  const at = (/** @type {number[]} */ uvw) => {
    const [a, b, c] = [0, 1, 2].map((axis) => {
      const [p, q, r] = uvw.map((t, k) => (k === axis ? slopes : values).map((one) => one(t)));
      return [0, 1, 2].map((k) => places.reduce((sum, place, n) => sum + p[n >> 4] * q[(n >> 2) & 3] * r[n & 3] * place[k], 0));
    });
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  let numbers = nodes.flatMap((u) => nodes.flatMap((v) => nodes.map((w) => at([u, v, w]))));
  const back = inverse(nodes.map(bernstein8));
  for (const stride of [81, 9, 1]) {
    numbers = numbers.map((_, n) => {
      const own = Math.floor(n / stride) % 9;
      return back[own].reduce((sum, weight, m) => sum + weight * numbers[n + (m - own) * stride], 0);
    });
  }
  return numbers;
}

/** Joints at a corner of a cell. @param {Question} question @param {number} cell @param {number[]} corner */
const jointsOf = (question, cell, corner) => cellOf(question).neighbourhood(cell, /** @type {any} */ (corner)).joints;

/** Where a cell meets itself: both parameters. @param {Question} question */
function meetingOf(question) {
  const witness = cellOf(question).verdicts()[0]?.witness;
  if (witness?.kind !== "meeting") throw new RangeError("the cell meets itself nowhere");
  return witness;
}

/** The distance between the places of two cells. @param {Question} question @param {[number, number[]][]} places */
function apart(question, places) {
  const body = cellOf(question);
  const [a, b] = places.map(([cell, uvw]) => body.sample(cell, /** @type {any} */ (uvw)).position);
  return Math.hypot(...a.map((each, axis) => each - b[axis]));
}

/** The fraction of a material (from 1) at a place of a part. @param {Directrix} dx @param {any} document @param {number} material @param {number[]} at */
const fractionAt = (dx, document, material, at) => dx.part(document).probe(/** @type {any} */ (at))?.fractions?.[material - 1] ?? NaN;

/** The same by a rule (from 1), of the voxel by the printed one. @param {Question} question @param {number} rule @param {number} material */
function byRule({ dx, document }, rule, material) {
  const part = dx.part(withRule(document, RULES[rule - 1]));
  if (RULES[rule - 1] !== "printed" || !part.box) return (/** @type {any} */ at) => part.probe(at)?.fractions?.[material - 1] ?? NaN;
  return sampled(part.evaluate({ size: voxels(part.box) }), material - 1);
}

/** The pixels of the features of a grid, and the transform as it can be watched. @param {Question} question @param {number} [pixels] */
function gridOf({ dx, document }, pixels = 16) {
  const marks = marksOf(document, dx.part(document).box ?? [[0, 0], [1, 1]], pixels);
  return { marks, steps: dx.transformSteps({ size: marks.size, features: marks.features }) };
}

/** How far digital distances are off at most, in edges. @param {Question} question @param {number} pixels @param {boolean} isAnywhere */
function worstError(question, pixels, isAnywhere) {
  const { dx, document } = question;
  const { marks } = gridOf(question, pixels);
  const digital = dx.distanceTransform({ size: marks.size, features: marks.features });
  const ruler = dx.part(document).evaluate({ size: measured(marks, isAnywhere) });
  const { worst } = errorsOf(marks, digital, ruler.fractions[1], document.bodies[0].features[0].to, isAnywhere);
  return { worst, edge: marks.edge };
}

/** Of the searches of a column (from 1), or of all where it is 0. @param {Question} question @param {number} column @param {"reach" | "count"} key */
const searched = (question, column, key) =>
  gridOf(question)
    .steps.columns.filter((_, n) => column === 0 || n === column - 1)
    .flatMap(({ searches }) => searches)
    .reduce((sum, each) => sum + each[key], 0);

/** @type {{[name: string]: FactKind}} */
export const FACTS = {
  samples: { arguments: 1, meaning: "samples of curve 1 or 2", of: (question, curve) => result(question).samples[curve - 1]?.points.length ?? NaN },
  materials: { arguments: 0, meaning: "materials of the document", of: ({ document }) => document.materials.length },
  stages: { arguments: 0, meaning: "steps from one curve to the other", of: ({ document }) => document.blend.stages },
  "in-betweens": { arguments: 0, meaning: "in-between curves", of: ({ document }) => document.blend.stages - 1 },
  fraction: { arguments: 2, meaning: "fraction of a material (from 1) at a share s of every line", of: fraction },
  lines: { arguments: 0, meaning: "ruling lines", of: (question) => totals(question).count },
  crossings: { arguments: 0, meaning: "crossings of lines", of: (question) => totals(question).crossings },
  blocked: { arguments: 0, meaning: "lines that run through a curve", of: (question) => totals(question).blocked },
  eta: { arguments: 0, meaning: "η", of: (question) => totals(question).eta },
  gap: { arguments: 0, meaning: "how far J stays below the optimum", of: (question) => result(question).gap ?? NaN },
  "ruled-at": blended("ruled"),
  "harmonic-at": blended("harmonic"),
  "difference-largest": { arguments: 0, meaning: "largest difference of the harmonic blend from the ruled one", of: (question) => difference(question).largest },
  "difference-mean": { arguments: 0, meaning: "mean difference of the harmonic blend from the ruled one", of: (question) => difference(question).mean },
  "gradient-lines": { arguments: 0, meaning: "lines along the gradient", of: (question) => flow(question).lines },
  "gradient-crossings": { arguments: 0, meaning: "crossings of lines along the gradient", of: (question) => flow(question).crossings },
  curves: { arguments: 0, meaning: "curves of the document", of: ({ document }) => document.curves.length },
  "eta-parameter": eta("parameter"),
  "eta-shift": eta("shift"),
  "eta-greedy": eta("greedy"),
  "eta-exact": eta("exact"),
  growth: { arguments: 0, meaning: "lines that the growth accepts", of: ({ dx, document }) => dx.steps(document).growth.length },
  before: { arguments: 1, meaning: "lines accepted before this one", of: (question, number) => (grown(question, number), number - 1) },
  removed: { arguments: 0, meaning: "redundant lines that are removed", of: ({ dx, document }) => dx.steps(document).removed.length },
  "lines-left": { arguments: 0, meaning: "lines after the removal", of: ({ dx, document }) => dx.steps(document).lines.length },
  inserted: { arguments: 0, meaning: "ends that move to new vertices", of: ({ dx, document }) => dx.steps(document).inserted.length },
  f: { arguments: 1, meaning: "f of a line of the growth", of: (question, number) => grown(question, number).value },
  from: { arguments: 1, meaning: "vertex where a line of the growth starts", of: (question, number) => grown(question, number).from },
  to: { arguments: 1, meaning: "vertex where a line of the growth ends", of: (question, number) => grown(question, number).to },
  visible: { arguments: 1, meaning: "size of V where a line of the growth starts", of: (question, number) => setsOf(question, number).visible.length },
  valid: { arguments: 1, meaning: "size of R there", of: (question, number) => setsOf(question, number).valid.length },
  coefficients: { arguments: 0, meaning: "coefficients of the cell", of: ({ document }) => document.operations[0].cells[0].coefficients.length },
  weight: { arguments: 6, meaning: "weight of the coefficient i, j, k at u, v, w", of: weight },
  position: { arguments: 4, meaning: "coordinate (1 to 3) of the place u, v, w", of: (question, axis, ...uvw) => cellOf(question).sample(0, /** @type {any} */ (uvw)).position[axis - 1] },
  mix: { arguments: 4, meaning: "fraction of a material (from 1) at u, v, w", of: (question, material, ...uvw) => cellOf(question).sample(0, /** @type {any} */ (uvw)).mix[material - 1] },
  jacobian: { arguments: 3, meaning: "J at u, v, w", of: (question, ...uvw) => jacobian(question, uvw) },
  "jacobian-corners": {
    arguments: 0,
    meaning: "least J at the eight corners",
    of: (question) => Math.min(...Array.from({ length: 8 }, (_, n) => jacobian(question, [n >> 2, (n >> 1) & 1, n & 1]))),
  },
  "jacobian-least": { arguments: 0, meaning: "what J is proven to be at least", of: (question) => cellOf(question).verdicts()[0]?.leastJacobianBound ?? NaN },
  regularity: { arguments: 0, meaning: "regularity, -1 to 1", of: (question) => cellOf(question).verdicts()[0]?.margin ?? NaN },
  volume: { arguments: 0, meaning: "volume of the body", of: (question) => cellOf(question).volume() },
  amount: { arguments: 1, meaning: "amount of a material (from 1)", of: (question, material) => cellOf(question).amounts()[material - 1] },
  "share-of": { arguments: 1, meaning: "amount of a material over the volume", of: (question, material) => cellOf(question).amounts()[material - 1] / cellOf(question).volume() },
  thirds: {
    arguments: 0,
    meaning: "least J at the 64 places whose parameters are thirds",
    of: (question) => Math.min(...NODES.flatMap((u) => NODES.flatMap((v) => NODES.map((w) => jacobian(question, [u, v, w]))))),
  },
  numbers: { arguments: 0, meaning: "Bernstein coefficients of J", of: (question) => numbersOf(question).length },
  "least-number": { arguments: 0, meaning: "least of the Bernstein coefficients of J", of: (question) => Math.min(...numbersOf(question)) },
  "mean-number": { arguments: 0, meaning: "mean of the Bernstein coefficients of J", of: (question) => numbersOf(question).reduce((sum, each) => sum + each, 0) / 729 },
  "negative-numbers": { arguments: 0, meaning: "negative ones among them", of: (question) => numbersOf(question).filter((each) => each < 0).length },
  halved: { arguments: 1, meaning: "least of them after so many halvings", of: (question, count) => pieces(cellsOf(question)[0], count)[0].least },
  meeting: { arguments: 1, meaning: "parameter 1 to 3 where a cell meets itself, and 4 to 6 the other one", of: (question, number) => [meetingOf(question)].flatMap(({ at, other }) => [...at, ...other])[number - 1] },
  "meeting-apart": { arguments: 0, meaning: "distance of both places in the body", of: (question) => [meetingOf(question)].map(({ at, other }) => apart(question, [[0, at], [0, other]]))[0] },
  moves: {
    arguments: 3,
    meaning: "places that move with the coefficient i, j, k of cell 0, by the repaired rule",
    of: (question, ...at) => {
      const cells = cellsOf(question);
      return new Set(cellOf(question).moves(0, /** @type {any} */ (at)).map(({ cell, at: [i, j, k] }) => String(cells[cell].coefficients[(4 * i + j) * 4 + k].position))).size;
    },
  },
  joints: { arguments: 4, meaning: "faces between cells at the corner (0 or 1 each) of a cell", of: (question, cell, ...corner) => jointsOf(question, cell, corner).length },
  "smooth-joints": { arguments: 4, meaning: "those of them across which the shape is C1", of: (question, cell, ...corner) => jointsOf(question, cell, corner).filter(({ shape }) => shape === "C1").length },
  "gap-at": { arguments: 1, meaning: "distance of cells 0 and 1 on their face at v = t, w = 0", of: (question, t) => apart(question, [[0, [1, t, 0]], [1, [0, t, 0]]]) },
  "gap-ratio": {
    arguments: 1,
    meaning: "that distance over the one at t / 2",
    of: (question, t) => [t, t / 2].map((each) => apart(question, [[0, [1, each, 0]], [1, [0, each, 0]]])).reduce((a, b) => a / b),
  },
  "mix-of": { arguments: 5, meaning: "fraction of a material (from 1) in a cell at u, v, w", of: (question, material, cell, ...uvw) => cellOf(question).sample(cell, /** @type {any} */ (uvw)).mix[material - 1] },
  "mix-at": { arguments: 3, meaning: "fraction of a material (from 1) at the coefficient i, 0, 0 of a cell", of: (question, material, cell, i) => cellsOf(question)[cell].coefficients[16 * i].mix[material - 1] },
  reflected: {
    arguments: 1,
    meaning: "fraction of a material (from 1) that is as far beyond the middle joint of a row as it is before it",
    of: (question, material) => [cellsOf(question)[1].coefficients].map((own) => 2 * own[48].mix[material - 1] - own[32].mix[material - 1])[0],
  },
  "fraction-at": { arguments: 3, meaning: "fraction of a material (from 1) of a part at x, y", of: ({ dx, document }, material, ...at) => fractionAt(dx, document, material, at) },
  "distance-to": {
    arguments: 3,
    meaning: "distance of the place x, y of a part to a feature (from 1)",
    of: ({ dx, document }, feature, ...at) => distanceOf(dx.part(document).probe(/** @type {any} */ (at)), feature - 1),
  },
  "by-course": {
    arguments: 4,
    meaning: "fraction of a material at x, y if the first feature had a course: 1 linear, 2 smoothstep, 3 power, 4 exponential, 5 periodic",
    of: ({ dx, document }, course, material, ...at) => fractionAt(dx, withFeature(document, [0, 0], { course: Object.values(COURSES)[course - 1] }), material, at),
  },
  "by-limit": {
    arguments: 4,
    meaning: "fraction of a material at x, y if the first feature had a limit",
    of: ({ dx, document }, to, material, ...at) => fractionAt(dx, withFeature(document, [0, 0], { to }), material, at),
  },
  "by-rule": { arguments: 4, meaning: "fraction of a material at x, y by a rule: 1 repaired, 2 depth, 3 printed", of: (question, rule, material, ...at) => byRule(question, rule, material)(/** @type {any} */ (at)) },
  "least-by-rule": {
    arguments: 6,
    meaning: "least fraction of a material along the line from x, y to x, y by a rule",
    of: (question, rule, material, ...line) => placesOf(line).map(byRule(question, rule, material)).filter(Number.isFinite).reduce((a, b) => Math.min(a, b), Infinity),
  },
  leaves: { arguments: 0, meaning: "leaves of the subdivision of a part", of: ({ dx, document }) => dx.part(document).leaves().length },
  "grid-pixels": { arguments: 0, meaning: "pixels of a grid", of: (question) => gridOf(question).marks.features.length },
  "row-number": { arguments: 2, meaning: "number of the pixel in a column and a row (from 1) after the rows", of: (question, x, y) => [gridOf(question)].map(({ marks, steps }) => steps.rows[(y - 1) * marks.size[0] + x - 1])[0] },
  number: { arguments: 2, meaning: "number of that pixel at the end", of: (question, x, y) => [gridOf(question)].map(({ marks, steps }) => steps.levels[(y - 1) * marks.size[0] + x - 1])[0] },
  parabolas: { arguments: 1, meaning: "pixels of a column (from 1) that have a number after the rows", of: (question, x) => [gridOf(question)].map(({ marks, steps }) => [...steps.rows].filter((level, n) => n % marks.size[0] === x - 1 && Number.isFinite(level)).length)[0] },
  corners: { arguments: 1, meaning: "parabolas on the lower envelope of a column", of: (question, x) => gridOf(question).steps.columns[x - 1].corners.length },
  searches: { arguments: 1, meaning: "searches of the scan in a column", of: (question, x) => gridOf(question).steps.columns[x - 1].searches.length },
  allowed: { arguments: 1, meaning: "pixels that the bound of these searches allows; of all columns with 0", of: (question, x) => searched(question, x, "reach") },
  compared: { arguments: 1, meaning: "pixels that they compare; of all columns with 0", of: (question, x) => searched(question, x, "count") },
  "worst-at-centers": { arguments: 1, meaning: "largest error of digital distances of centres in edges, with so many pixels along a side", of: (question, pixels) => worstError(question, pixels, false).worst },
  "worst-anywhere": { arguments: 1, meaning: "that of 25 places of each pixel", of: (question, pixels) => worstError(question, pixels, true).worst },
  "worst-length": { arguments: 1, meaning: "that in the unit of the document", of: (question, pixels) => [worstError(question, pixels, true)].map(({ worst, edge }) => worst * edge)[0] },
  elements: { arguments: 0, meaning: "elements of a boundary", of: ({ dx, document }) => dx.boundary(document).groups.length },
  "matrix-numbers": { arguments: 0, meaning: "numbers of the matrix of a boundary", of: ({ dx, document }) => dx.boundary(document).groups.length ** 2 },
  "solved-at": { arguments: 3, meaning: "fraction of a material (from 1) in the plane at x, y, as solved", of: (question, material, x, y) => solvedAt(question, [x, y])[material - 1] },
  "exact-at": { arguments: 3, meaning: "that fraction exactly", of: ({ dx, document }, material, x, y) => dx.exact(document, [x, y])[material - 1] },
  "mean-around": {
    arguments: 4,
    meaning: "mean of a fraction on the circle about x, y with a radius",
    of: (question, material, x, y, radius) => summed(solvedAt(question, circleOf([x, y], radius)), question.document.materials.length, material - 1).mean,
  },
  "boundary-error": {
    arguments: 1,
    meaning: "largest error at places inside, with so many panels along a side",
    of({ dx, document }, steps) {
      const boundary = dx.boundary(withSteps(document, steps));
      const points = probes(boundary.dimension);
      const { values } = dx.solveLaplace(inputOf(boundary, { ...boundary.solver, tolerance: 1e-9 })).at(points);
      return farthest(values, dx.exact(document, points));
    },
  },
  candidates: {
    arguments: 1,
    meaning: "size of V ∩ R there",
    of: (question, number) => setsOf(question, number).visible.filter(({ candidate }) => candidate).length,
  },
};

/**
 * Whether a number as it stands in a text is what the kernel says, to the digits that are shown.
 * @param {string} shown such as `0.969`, `2.9 %` or `44`
 * @param {number} value
 */
export function isTrue(shown, value) {
  const found = /^(-?\d+)(?:\.(\d+))?( %)?$/.exec(shown.replace("\u2212", "-").replace("\u00a0", " "));
  if (!found) return false;
  const [, whole = "", decimals = "", percent] = found;
  const stated = Number(`${whole}.${decimals || "0"}`) / (percent ? 100 : 1);
  const isCount = decimals === "" && !percent;
  return Math.abs(stated - value) <= (isCount ? 0 : 0.5001 * 10 ** -(decimals.length + (percent ? 2 : 0)));
}
