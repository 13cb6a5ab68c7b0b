/**
 * Numbers that the text of a lesson may state, each with what the kernel says about the figure of the step. The tests hold every stated
 * number against it.
 *
 * @import { Directrix } from "../../js/directrix.js"
 *
 * @typedef {object} Question What a fact is asked about.
 * @property {Directrix} dx
 * @property {any} document of the figure, with its changes
 * @property {"figure" | "steps" | "body"} view
 *
 * @typedef {object} FactKind
 * @property {number} arguments numbers behind its name
 * @property {string} meaning
 * @property {(question: Question, ...numbers: number[]) => number} of
 */

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

/** The only cell of a body. @param {Question} question */
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
