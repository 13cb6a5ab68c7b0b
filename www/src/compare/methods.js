/**
 * The methods that are compared, as settings of a document.
 *
 * @import { CurvesDocument, Match, Matching, Totals } from "../types.js"
 *
 * @typedef {object} Method
 * @property {string} name
 * @property {Partial<Matching>} settings
 */

/**
 * In the order of the pictures. Where a method has its own way to one-to-one lines it takes it; the largest sum keeps its fans,
 * which are the point of it.
 * @type {readonly Method[]}
 */
export const METHODS = [
  { name: "parameter", settings: { method: "parameter", oneToOne: true } },
  { name: "shift", settings: { method: "shift", shift: "best", oneToOne: true } },
  { name: "one-per-vertex", settings: { method: "one-per-vertex", oneToOne: true } },
  { name: "sum", settings: { method: "exact", objective: "sum", oneToOne: false } },
  { name: "greedy", settings: { method: "greedy", oneToOne: true } },
  { name: "exact", settings: { method: "exact", objective: "integral", oneToOne: true } },
];

/**
 * The document with a method in place of its own. Weights, policy and number of lines stay; pins stay with the exact methods,
 * the others know none.
 * @param {CurvesDocument} document
 * @param {Method} method
 * @returns {CurvesDocument}
 */
export function withMethod(document, { settings }) {
  const { pins, ...matching } = document.matching;
  const kept = settings.method === "exact" && pins ? { pins } : {};
  return { ...document, matching: { ...matching, ...settings, ...kept } };
}

/**
 * The document whose J and eta are compared: of one-to-one lines in every method, so that all are integrals over the curves.
 * @param {CurvesDocument} document
 */
export const measured = (document) =>
  document.matching.oneToOne ? document : { ...document, matching: { ...document.matching, oneToOne: true } };

/**
 * The method of a document, or -1 when it has settings that none of these has.
 * @param {Matching} matching
 */
export function methodOf({ method, objective = "integral", shift = "best" }) {
  return METHODS.findIndex(
    ({ settings }) =>
      settings.method === method &&
      (settings.objective === undefined || settings.objective === objective) &&
      (settings.shift === undefined || settings.shift === shift),
  );
}

/**
 * What keeps a result from being one, as counts; all zero for a good one.
 * @param {Match} match
 */
export function faultsOf({ ok, totals, diagnostics }) {
  const shown = totals.pairs ?? totals.lines;
  const [a, b] = totals.pairs ? [[], []] : (totals.lines?.uncovered ?? [[], []]);
  const occluded = diagnostics.filter(({ code }) => code === "occluded").flatMap(({ lines = [] }) => lines).length;
  return {
    feasible: ok,
    crossings: shown?.crossings ?? 0,
    blocked: shown?.blocked ?? 0,
    uncovered: /** @type {[number, number]} */ ([a.length, b.length]),
    occluded,
  };
}

/**
 * The best of the results that keep the constraints: the index of the greatest eta, or -1.
 * @param {({feasible: boolean, eta: number | null} | null)[]} results
 */
export function bestOf(results) {
  return results.reduce(
    (best, result, i) =>
      result?.feasible && result.eta !== null && (best < 0 || result.eta > (results[best]?.eta ?? -Infinity)) ? i : best,
    -1,
  );
}

/** @param {readonly number[]} values @returns {number | null} */
export function median(values) {
  if (values.length === 0) return null;
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/**
 * J and eta on the curves, and how large J can be.
 * @param {Match} match of `measured`
 * @returns {{eta: number | null, integral: number | null, bound: number | null}}
 */
export function qualityOf({ totals }) {
  const pairs = /** @type {Totals | null} */ (totals.pairs);
  return { eta: pairs?.eta ?? null, integral: pairs?.integral ?? null, bound: pairs?.bound ?? null };
}
