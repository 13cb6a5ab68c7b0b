/** Bodies of hyperpatches: cells on grids, certificates, sections, and the longest call of each question. */
import { load, renewSurface } from "../js/node.js";

const MATERIALS = ["#0072b2", "#e69f00", "#009e73", "#cc79a7"].map((color, n) => ({ name: `m${n}`, color }));

/** A number in [-1, 1) that depends on the seed alone. @param {number} seed */
function random(seed) {
  let z = Math.imul(seed ^ 0x9e3779b9, 0x85ebca6b);
  z = Math.imul(z ^ (z >>> 13), 0xc2b2ae35);
  return ((z ^ (z >>> 16)) >>> 0) / 2 ** 31 - 1;
}

/**
 * Cubes in a block, with all control points moved by at most `jitter`, the same where cells share them.
 *
 * @param {[number, number, number]} counts
 * @param {number} jitter
 * @param {number} [seed]
 */
function block(counts, jitter, seed = 0) {
  const cells = [];
  for (let n = 0; n < counts[0] * counts[1] * counts[2]; n++) {
    const start = [Math.floor(n / (counts[1] * counts[2])), Math.floor(n / counts[2]) % counts[1], n % counts[2]];
    const coefficients = Array.from({ length: 64 }, (_, at) => {
      const node = start.map((s, axis) => 3 * s + ((at >> (4 - 2 * axis)) & 3));
      const corner = [(at >> 5) & 1, (at >> 3) & 1, (at >> 1) & 1];
      const mix = MATERIALS.map((_, material) => (material === ((start[0] + corner[0] + 2 * corner[1]) & 3) ? 1 : 0));
      const offset = (/** @type {number} */ axis) => jitter * random(seed + axis + 3 * (node[0] + 1000 * (node[1] + 1000 * node[2])));
      return { position: node.map((k, axis) => Number((k / 3 + offset(axis)).toFixed(4))), mix };
    });
    cells.push({ coefficients });
  }
  return JSON.stringify({ directrix: 1, kind: "hyperpatch", materials: MATERIALS, operations: [{ op: "cells", cells }] });
}

/**
 * A ring of cells about the z axis: 8 sectors of 12 by 4 cells, as many as a tyre is made of. Its corners inside the body are smooth.
 *
 * @returns {import("../js/directrix.js").HyperpatchDocument}
 */
function tyre() {
  const kappa = (4 / 3) * Math.tan(Math.PI / 16);
  const cells = Array.from({ length: 384 }, (_, n) => {
    const [sector, column, layer] = [Math.floor(n / 48), Math.floor(n / 4) % 12, n % 4];
    const [[a, b], [c, d]] = [sector, (sector + 1) % 8].map((k) => [Math.cos((Math.PI * k) / 4), Math.sin((Math.PI * k) / 4)]);
    const arc = [[a, b], [a - kappa * b, b + kappa * a], [c + kappa * d, d - kappa * c], [c, d]];
    const coefficients = Array.from({ length: 64 }, (_, at) => {
      const [i, j, k] = [at >> 4, (at >> 2) & 3, at & 3];
      const radius = 6 - (3 * layer + j) / 6;
      const mix = MATERIALS.map((_, material) => (material === (layer + (j >> 1)) % 4 ? 1 : 0));
      return { position: /** @type {[number, number, number]} */ ([arc[i][0] * radius, arc[i][1] * radius, (3 * column + k) / 9]), mix };
    });
    return { coefficients };
  });
  return { directrix: 1, kind: "hyperpatch", materials: MATERIALS, operations: [{ op: "cells", cells }] };
}

/** The document with one more operation: a corner or another coefficient of a cell moved. @param {any} document @param {number} cell @param {number} by */
const moved = (document, cell, by) => ({ ...document, operations: [...document.operations, { op: "move", cell, at: [3, 0, 0], by: [by, by / 2, 0] }] });

/**
 * A frame of a drag as the page has it: the document with another last operation, its cells, their certificates, and the vertices that are new
 * put into the arrays of the surface.
 */
async function drag() {
  const dx = await load({ module: "full" });
  const document = tyre();
  const surface = dx.hyperpatch(document).surface();
  dx.hyperpatch(document).verdicts({ global: false });
  let frame = 0;
  return () => {
    const body = dx.hyperpatch(moved(document, 57, 1e-3 * (++frame % 200)));
    body.verdicts({ global: false });
    if (!renewSurface(surface, body.surface({ since: surface.id }))) throw new Error("the surface was made anew");
  };
}

/** Certificates of a thousand cells that were mirrored in another plane before, so that nothing is known of them: the longer of two turns. */
async function thousand() {
  const dx = await load({ module: "full" });
  const document = JSON.parse(block([10, 10, 10], 0.05));
  const cells = Array.from({ length: 1000 }, (_, n) => n);
  const ask = (/** @type {any} */ edited, /** @type {any} */ hyperpatch) => dx.job(edited, { hyperpatch }).step(Infinity);
  let run = 0;
  return function* () {
    const operation = { op: "mirror", cells, normal: [1, 0, 0], offset: ++run / 8, keep: false };
    const edited = { ...document, operations: [...document.operations, operation] };
    ask(edited, { question: "sample", rest: { cell: 0, at: [0, 0, 0] } });
    yield;
    ask(edited, { question: "verdicts", rest: { options: { global: false } } });
  };
}

/** The corner in which eight cells meet moved, and the cells certified: what an edit costs in the module. */
async function corner() {
  const dx = await load({ module: "full" });
  const document = JSON.parse(eight);
  let frame = 0;
  return () => {
    const edited = { ...document, operations: [...document.operations, { op: "move", cell: 0, at: [3, 3, 3], by: [1e-5 * (++frame % 1000), 0, 0] }] };
    return dx.job(edited, { hyperpatch: { question: "verdicts", rest: { options: { global: false } } } }).step(Infinity);
  };
}

/** The longest turn of reading 400 cells. The documents take turns, as the last four are remembered. */
async function reading() {
  const dx = await load({ module: "full" });
  const documents = Array.from({ length: 6 }, (_, n) => JSON.parse(block([8, 10, 5], 0.05, n)));
  const jobs = () => documents.map((document) => dx.job(document, { hyperpatch: { question: "amounts" } }));
  let waiting = jobs();
  return function* () {
    if (waiting.length === 0) waiting = jobs();
    const job = /** @type {import("../js/directrix.js").Job} */ (waiting.pop());
    while (!job.step(12).done) yield;
  };
}

/** The peer: `nurbs` 1.1.1, which evaluates splines of any dimension. It knows nothing of validity, continuity, sections or materials. */
async function peer() {
  const { default: nurbs } = await import("nurbs");
  const [{ coefficients }] = JSON.parse(eight).operations[0].cells;
  const values = (/** @type {number} */ at) => [...coefficients[at].position, ...coefficients[at].mix];
  const points = [0, 1, 2, 3].map((i) => [0, 1, 2, 3].map((j) => [0, 1, 2, 3].map((k) => values((i * 4 + j) * 4 + k))));
  const cell = nurbs({ points, degree: [3, 3, 3], boundary: ["clamped", "clamped", "clamped"] });
  const [[lo, hi]] = cell.domain;
  const dx = await load({ module: "full" });
  const expected = dx.hyperpatch(eight).sample(0, [0.25, 0.5, 0.75]).position;
  const place = (/** @type {number} */ t) => lo + (hi - lo) * t;
  const found = cell.evaluate([], place(0.25), place(0.5), place(0.75));
  if (expected.some((x, n) => Math.abs(x - found[n]) > 1e-9)) throw new Error("the peer has another point");
  /** @type {number[]} */
  const out = [];
  return () => {
    let sum = 0;
    for (let i = 0; i < 64; i++) {
      for (let j = 0; j < 64; j++) {
        for (let k = 0; k < 64; k++) sum += cell.evaluate(out, place(i / 63), place(j / 63), place(k / 63))[0];
      }
    }
    return sum;
  };
}

/**
 * A question about a body that is known. `texts` are documents of the same size, asked one after the other so that nothing is remembered of the
 * certificates.
 *
 * @param {string} text
 * @param {(body: any) => unknown} ask
 */
const on = (text, ask) => async () => {
  const dx = await load({ module: "full" });
  const body = dx.hyperpatch(text);
  return () => ask(body);
};

/**
 * The longest call of a question, as the worker asks it.
 *
 * @param {string} text
 * @param {string} question
 * @param {object} [rest]
 */
const longest = (text, question, rest = {}) => async () => {
  const dx = await load({ module: "full" });
  dx.hyperpatch(text);
  return function* () {
    const job = dx.job(text, { hyperpatch: { question: /** @type {any} */ (question), rest } });
    while (!job.step(12).done) yield;
  };
};

const eight = block([2, 2, 2], 0.05);
const layer = block([10, 10, 1], 0.05);
const many = block([8, 10, 5], 0.05);

/** @type {import("../scripts/lib/bench.mjs").Case[]} */
export default [
  { name: "hyperpatch, 64 x 64 x 64 points of 7 components", budget: 4, prepare: on(eight, (body) => body.grid(0, [64, 64, 64])) },
  { name: "hyperpatch, section of 100 crossed cells", budget: 30, prepare: on(layer, (body) => body.section({ normal: [0.1, 0.05, 1], offset: 1.1 })) },
  { name: "hyperpatch, 64 x 64 x 64 points of 7 components by the package nurbs 1.1.1", prepare: peer },
  { name: "hyperpatch, certificates of 1,000 cells", budget: 60, prepare: thousand },
  { name: "hyperpatch, 8 cells round a corner that is moved, certified", budget: 1, prepare: corner },
  { name: "hyperpatch, frame of a drag of a corner among 384 cells: edit, certificates, new vertices", budget: 16, prepare: drag },
  { name: "longest call of reading 400 cells", budget: 50, prepare: reading },
  { name: "longest call of the surface of 400 cells", budget: 50, prepare: longest(many, "surface") },
  { name: "longest call of the relations of 400 cells", budget: 50, prepare: longest(many, "relations") },
  { name: "longest call of a file of 400 cells for VTK", budget: 50, prepare: longest(many, "file", { options: { format: "vtu" } }) },
];
