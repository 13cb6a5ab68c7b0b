/** Solids, of documents whose matching is known. */
import { readFile } from "node:fs/promises";
import { load } from "../js/node.js";

const amoeba = JSON.parse(await readFile(new URL("../www/presets/amoeba.json", import.meta.url), "utf8"));

/** The amoeba with its outer curve lifted and so many lines. @param {number} lines */
function lifted(lines) {
  const document = structuredClone(amoeba);
  document.curves[1].height = 40;
  document.matching = { method: "exact", oneToOne: true, lines };
  return document;
}

/**
 * A job that is stepped as the worker does it.
 *
 * @param {any} dx
 * @param {object} document
 * @param {object} goal
 */
function* inSteps(dx, document, goal) {
  const job = dx.job(document, goal);
  while (!job.step(12).done) yield;
}

/**
 * @param {number} lines
 * @param {(dx: any, document: object) => unknown} work
 */
const on = (lines, work) => async () => {
  const dx = await load({ module: "full" });
  const document = lifted(lines);
  dx.match(document);
  return () => work(dx, document);
};

/** @type {import("../scripts/lib/bench.mjs").Case[]} */
export default [
  { name: "solid, 200 lines x 40 stages", budget: 20, prepare: on(200, (dx, document) => dx.solid(document, { stages: 40 })) },
  {
    name: "solid, 200 lines x 40 stages, map of angles",
    budget: 20,
    prepare: on(200, (dx, document) => dx.solid(document, { stages: 40, color: "flank" })),
  },
  {
    name: "longest call of the largest solid, 1000 lines x 200 stages",
    budget: 50,
    prepare: on(1000, (dx, document) => inSteps(dx, document, { solid: { stages: 200 } })),
  },
  {
    name: "longest call of its file as OBJ",
    budget: 50,
    prepare: on(1000, (dx, document) => inSteps(dx, document, { solidFile: { stages: 200, format: "obj" } })),
  },
];
