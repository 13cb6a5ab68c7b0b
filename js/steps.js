/** The greedy growth in steps: the document it belongs to, and names for the lists of numbers that the module gives. */
import { DirectrixError } from "./errors.js";
import { toText } from "./text.js";

/** @typedef {import("./pkg/directrix.js").Engine} Engine */

/** Rules of the growth that the steps take as repaired even where the document takes them as printed. */
const REPAIRED = ["order", "stop", "removal"];

/**
 * The text of a document as one of the method `greedy` with one-to-one lines, for the same weights.
 *
 * @param {Engine} engine
 * @param {import("./directrix.js").DocumentInput} document
 * @throws {DirectrixError} when the document is none
 */
export function greedyText(engine, document) {
  const { view: _, ...whole } = engine.defaults(toText(document));
  const { normalWeight, distanceWeight, alignmentWeight, negative, printed = [] } = whole.matching;
  const kept = printed.filter((/** @type {string} */ rule) => !REPAIRED.includes(rule));
  const weights = { normalWeight, distanceWeight, alignmentWeight, negative };
  return toText({ ...whole, matching: { method: "greedy", ...weights, oneToOne: true, printed: kept } });
}

/**
 * @param {Engine} engine
 * @param {import("./directrix.js").DocumentInput} document
 * @returns {import("./directrix.js").Steps}
 */
export function stepsOf(engine, document) {
  const text = greedyText(engine, document);
  const match = engine.match(text, false);
  /** @type {number[][][]} */
  const [growth, rejected, removed, inserted] = engine.steps(text);
  return {
    ...match,
    growth: growth.map(([from, to, value]) => ({ from, to, value })),
    rejected: rejected.map(([from, to, step, by]) => ({ from, to, step, by })),
    removed: removed.map(([line]) => line),
    inserted: inserted.map(([curve, vertex, x, y, value]) => ({ curve: curve === 0 ? 0 : 1, vertex, at: [x, y], value })),
  };
}

/**
 * @param {Engine} engine
 * @param {import("./directrix.js").DocumentInput} document
 * @param {import("./directrix.js").SetsOptions} options
 * @returns {import("./directrix.js").VertexSets}
 */
export function setsOf(engine, document, options) {
  const { step, curve = 0, vertex } = options ?? {};
  for (const [name, value] of Object.entries({ step, curve, vertex })) {
    if (Number.isInteger(value) && value >= 0 && value < 2 ** 32) continue;
    throw new DirectrixError("type", `options.${name}`, `${String(value)} was found; expected a whole number from 0`);
  }
  /** @type {number[][]} */
  const [valid, ...rows] = engine.sets(greedyText(engine, document), step, curve, vertex);
  const visible = rows.map(([vertex, value, candidate]) => ({ vertex, value, candidate: candidate === 1 }));
  return { visible, valid, best: visible.find(({ candidate }) => candidate)?.vertex ?? null };
}
