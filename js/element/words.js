/** Everything that a figure says to a person. */

/** @param {number} count @param {string} one @param {string} many */
const plural = (count, one, many) => `${count} ${count === 1 ? one : many}`;

export const words = {
  figure: "Figure of two matched curves",
  show: "Show the figure",
  open: "Open in Directrix",
  opens: "Open this figure in Directrix, in a new tab",
  result: {
    lines: (/** @type {number} */ count) => (count === 1 ? "line" : "lines"),
    counted: (/** @type {number} */ count) => plural(count, "line", "lines"),
    noCrossing: "none crossing",
    crossing: (/** @type {number} */ count) => `${count} crossing`,
    crossings: "crossings",
    blocked: (/** @type {number} */ count) => `${count} through a curve`,
    uncovered: (/** @type {number} */ count) => `${plural(count, "sample", "samples")} without a line`,
    eta: (/** @type {string} */ value) => `η ${value}`,
    gap: (/** @type {string} */ value) => `heuristic, gap ${value} %`,
    incomplete: "Unfinished: a figure needs two curves",
    problems: "not verified",
    noLines: "The curves cannot be matched as they lie",
  },
  morph: {
    play: "Play",
    pause: "Pause",
    step: "Next stage",
    slider: "Place between the curves",
    place: (/** @type {string} */ s) => `s ${s}`,
  },
  growth: {
    slider: "Steps of the greedy growth",
    step: (/** @type {number} */ step, /** @type {number} */ steps) => `Step ${step} of ${steps} of the greedy growth`,
  },
  handles: {
    help:
      "Arrow keys move the point, with Shift ten times as far, with Alt a tenth. Page up and page down go to the previous and the next " +
      "point, Escape takes the move back.",
    group: (/** @type {string} */ curve) => `Control points of ${curve}`,
    curve: (/** @type {number} */ index) => (index === 0 ? "the first curve" : "the second curve"),
    name: (/** @type {number} */ curve, /** @type {number} */ point) => `${curve === 0 ? "A" : "B"}${point + 1}`,
    point: (/** @type {string} */ name, /** @type {string} */ x, /** @type {string} */ y) => `${name}, x ${x}, y ${y}`,
    restored: "Move taken back",
  },
  layers: {
    button: "Layers",
    names: /** @type {Record<string, string>} */ ({
      material: "Material",
      rulingLines: "Ruling lines",
      inBetweens: "In-between curves",
      samples: "Samples",
      grid: "Grid",
    }),
  },
  errors: {
    noWasm: "This figure needs WebAssembly with SIMD, which this browser does not offer or has switched off.",
    blocked: (/** @type {string} */ reason) => `The figure cannot be computed here: ${reason}`,
    at: (/** @type {string} */ path, /** @type {string} */ message) => (path ? `${path}: ${message}` : message),
    document: (/** @type {string} */ text) => `This document cannot be shown. ${text}`,
    edit: (/** @type {string} */ text) => `Not possible here. ${text}`,
    preset: (/** @type {string} */ name) => `"${name}" was found; expected the name of a preset, of small letters, digits and hyphens`,
    address: (/** @type {string} */ text) => `"${text}" was found; expected an address`,
    status: (/** @type {number} */ status) => `the server answered ${status}`,
    unreachable: "the address cannot be read; it may be wrong, or its server does not allow other pages to read it",
    tooLarge: "expected at most 4 MiB",
  },
};

/**
 * A number with a fixed count of decimals, with a true minus and never a negative zero.
 *
 * @param {number} value
 * @param {number} decimals
 */
export function fixed(value, decimals) {
  const text = Math.abs(value).toFixed(decimals);
  return value < 0 && Number(text) !== 0 ? `\u2212${text}` : text;
}
