/** Bodies of hyperpatches: cells on grids, certificates, sections, and the longest call of each question. */
import { load } from "../js/node.js";

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
  {
    name: "hyperpatch, 8 cells read and certified after an edit of one control point",
    budget: 16,
    prepare: async () => {
      const dx = await load({ module: "full" });
      let edit = 0;
      return () => {
        const document = JSON.parse(eight);
        document.operations[0].cells[0].coefficients[21].position[0] += (++edit % 1000) * 1e-5;
        return dx.hyperpatch(document).verdicts({ global: false });
      };
    },
  },
  { name: "longest call of the surface of 400 cells", budget: 50, prepare: longest(many, "surface") },
  { name: "longest call of the relations of 400 cells", budget: 50, prepare: longest(many, "relations") },
  { name: "longest call of a file of 400 cells for VTK", budget: 50, prepare: longest(many, "file", { options: { format: "vtu" } }) },
];
