/** Every word of the comparison of methods. */
import { plural } from "../strings.js";

/** @type {{[method: string]: {name: string, line: string}}} */
const methods = {
  parameter: { name: "Same parameter", line: "sample to sample as drawn" },
  shift: { name: "Best shift", line: "one rotation for all lines" },
  "one-per-vertex": { name: "One per vertex", line: "dynamic programme of the papers" },
  sum: { name: "Largest sum", line: "exact, one vertex may have many" },
  greedy: { name: "Greedy", line: "grown best-first, heuristic" },
  exact: { name: "Exact", line: "maximises the integral" },
};

export const words = {
  methods,
  group: "Methods",
  hint: "one pointer, six pictures: the line nearest to it is lit in each",
  hintTouch: "slide to light the nearest line in each; tap to work with one",
  help:
    "Arrow keys go from picture to picture. Page down and page up light the next and the previous line, Escape none. " +
    "Enter goes on working with the method.",
  shifted: (/** @type {number} */ by) => `one rotation for all lines, k = ${by}`,
  pinned: (/** @type {number} */ pins) => `${plural(pins, "pin", "pins")} kept`,
  pinless: "without the pins",
  gaps: (/** @type {number} */ gaps) => plural(gaps, "gap keeps its fan", "gaps keep their fans"),
  crossings: (/** @type {number} */ count) => plural(count, "crossing", "crossings"),
  blocked: (/** @type {number} */ count) => `${count} blocked`,
  uncovered: (/** @type {number} */ a, /** @type {number} */ b) => `${a} + ${b} vertices not covered`,
  occluded: (/** @type {number} */ count) => `${plural(count, "line goes", "lines go")} through a curve`,
  noBlend: (/** @type {string[]} */ faults) => `${faults.join(", ")}: no blend drawn`,
  none: "no lines",
  infeasible: "infeasible",
  sound: "none crossing, none blocked",
  current: "chosen in this document",
  needsTwo: "A comparison of methods needs two curves.",

  spokenPicture: (/** @type {string[]} */ parts) => `, ${parts.filter(Boolean).join(", ")}`,
  spokenLine: (/** @type {string} */ method, /** @type {number} */ line, /** @type {number} */ of, /** @type {string} */ value) =>
    `${method}: line ${line} of ${of}, f ${value}`,
  spokenCount: (/** @type {number} */ count) => plural(count, "line", "lines"),
  chosen: (/** @type {string} */ method) => `Working with ${method}`,
  result: (/** @type {string | null} */ best, /** @type {string} */ eta, /** @type {number} */ failing, /** @type {number} */ of) =>
    `${best === null ? "No method keeps its constraints" : `Best: ${best}, eta ${eta}`}. ${words.failing(failing, of)}`,

  bars: "Measures of the methods",
  method: "Method",
  eta: "Quality",
  etaNote: "1 = every point gets its best partner",
  integral: "Integral",
  mean: "Mean",
  count: "Lines",
  crossed: "Crossings",
  hit: "Blocked",
  time: "Time",
  timeNote: (/** @type {number} */ low, /** @type {number} */ high) =>
    high === 1 ? "ms" : low === high ? `ms, median of ${high}` : `ms, median of ${low} to ${high}`,
  missing: "not defined, because some vertices have no line",
  unranked: "breaks a constraint, so it is not ranked",
  note: "Quality and integral are taken on the curves, of one-to-one lines along each matching; the largest sum has them spread evenly.",

  methodCount: (/** @type {number} */ count) => ({ number: String(count), text: "methods" }),
  sampling: "sampling",
  weights: "weights",
  best: "best",
  noneFeasible: "no method keeps its constraints",
  inAll: "ms in all",
  failing: (/** @type {number} */ failing, /** @type {number} */ of) =>
    failing === 0 ? "Every certificate holds" : `${failing} of ${of} ${failing === 1 ? "fails its certificate" : "fail their certificates"}`,
};
