/**
 * What stands below a figure of a boundary value problem: means, extremes, influences, the matrix, errors or residuals.
 *
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 * @import { Known, Run, Solved } from "./laplace-solver.js"
 */
import { h } from "../dom.js";
import { fixed, significant } from "../format.js";
import { errorChart, matrixPicture, residualChart, rowChart } from "./laplace-chart.js";
import { FOLLOWED, summed } from "./laplace-known.js";
import { fact } from "./parameter.js";
import { words } from "./words-laplace.js";

/** Numbers of panels between which errors follow a power: more than a few, and not so many that single precision ends it. */
const STEADY = [16, 64];

/** A number with its power of ten raised. @param {number} value @returns {(string | HTMLElement)[]} */
function powered(value) {
  const { mantissa, exponent } = significant(value);
  return exponent === null ? [mantissa] : [`${mantissa} × 10`, h("sup", {}, exponent)];
}

/**
 * What stands below the picture.
 * @param {Figure} figure
 * @param {Known} now
 * @param {number} panel the chosen one
 * @param {string} color accent
 * @returns {HTMLElement[]}
 */
export function readingOf(figure, now, panel, color) {
  const { solved, found, around } = now;
  const materials = solved.document.materials ?? [];
  const { matrix } = solved;
  if (figure.reading === "mean" && found) {
    if (!around) return [h("p", { class: "cell-label" }, words.mean.beyond)];
    const { mean, least, greatest } = summed(around, materials.length, 0);
    return [
      h("p", { class: "cell-label" }, words.mean.of(materials[0].name)),
      h("dl", {}, ...fact(words.mean.at, "own", fixed(found[0], 4)), ...fact(words.mean.around, "mean", fixed(mean, 4)), ...fact(words.mean.least, "least", fixed(least, 4)), ...fact(words.mean.greatest, "greatest", fixed(greatest, 4))),
    ];
  }
  if (figure.reading === "extremes") return [extremesTable(solved)];
  if (figure.reading === "fractions" && found && !found.some(Number.isNaN)) {
    const rows = materials.flatMap(({ name }, k) => fact(name, `share-${k}`, fixed(found[k], 4)));
    return [h("dl", {}, ...rows, ...fact(words.fractions.sum, "sum", fixed(found.reduce((sum, each) => sum + each, 0), 4)))];
  }
  if (figure.reading === "influence" && matrix) {
    const own = matrix.matrix.subarray(panel * matrix.count, (panel + 1) * matrix.count);
    const at = (/** @type {number} */ n) => powered(own[(panel + n) % matrix.count]);
    const far = Math.floor(matrix.count / 2);
    return [rowChart(matrix, panel), h("dl", {}, ...fact(words.influence.own, "own", ...at(0)), ...fact(words.influence.next, "next", ...at(1)), ...fact(words.influence.far, "far", ...at(far)))];
  }
  if (figure.reading === "matrix" && matrix) {
    const sizes = Array.from(matrix.matrix, Math.abs);
    return [
      matrixPicture(matrix, panel, color),
      h(
        "dl",
        {},
        ...fact(words.matrix.size, "size", String(sizes.length)),
        ...fact(words.matrix.largest, "largest", ...powered(Math.max(...sizes))),
        ...fact(words.matrix.least, "least", ...powered(Math.min(...sizes))),
        ...fact(words.matrix.zeros, "zeros", String(sizes.filter((size) => size === 0).length)),
      ),
    ];
  }
  if (figure.reading === "error" && solved.errors.length > 1) {
    const count = solved.boundary.groups.length;
    const own = solved.errors.find(({ panels }) => panels === count);
    const [from, to] = STEADY.map((panels) => solved.errors.find((each) => each.panels === panels) ?? solved.errors[0]);
    const power = Math.log(to.error / from.error) / Math.log(to.panels / from.panels);
    return [
      errorChart(solved.errors, count),
      h("dl", {}, ...fact(words.error.panels, "count", String(count)), ...fact(words.error.largest, "error", ...powered(own?.error ?? NaN)), ...fact(words.error.falls(from.panels, to.panels), "power", fixed(power, 1))),
    ];
  }
  if (figure.reading === "residuals" && now.runs.length > 0) {
    const { condition } = solved;
    const own = condition === null ? [] : [h("dl", {}, ...fact(words.residuals.condition, "condition", ...powered(condition)))];
    return [residualChart(now.runs, FOLLOWED.tolerance), runTable(now.runs, now.job.omega), ...own];
  }
  return [];
}

/** Least and greatest of every material: on the boundary as given, and inside as found. @param {Solved} solved */
function extremesTable({ document, boundary, section }) {
  const materials = document.materials ?? [];
  const cell = (/** @type {number} */ value, /** @type {string} */ own) => h("td", { class: "number", "data-lesson": own }, fixed(value, 3));
  const rows = materials.flatMap(({ name }, k) => {
    const given = boundary.conditions.flatMap((condition) => ("value" in condition ? [condition.value[k]] : []));
    const inside = section.values[k].filter((value) => !Number.isNaN(value));
    const [low, high] = inside.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]);
    return [
      h("tr", {}, h("th", { scope: "row" }, `${name}, ${words.extremes.boundary}`), cell(Math.min(...given), `given-least-${k}`), cell(Math.max(...given), `given-greatest-${k}`)),
      h("tr", {}, h("th", { scope: "row" }, `${name}, ${words.extremes.inside(fixed(inside.length, 0))}`), cell(low, `least-${k}`), cell(high, `greatest-${k}`)),
    ];
  });
  const heads = [words.extremes.where, words.extremes.least, words.extremes.greatest].map((text) => h("th", { scope: "col" }, text));
  return h("table", {}, h("thead", {}, h("tr", {}, ...heads)), h("tbody", {}, ...rows));
}

/** @param {readonly Run[]} runs @param {number} omega */
function runTable(runs, omega) {
  const titles = { none: words.residuals.none, jacobi: words.residuals.jacobi, ssor: words.residuals.ssor(fixed(omega, 1)) };
  const row = (/** @type {Run} */ { name, residuals, iterations, converged, time }) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, h("span", { class: `laplace-key ${name}`, "aria-hidden": "true" }), titles[name]),
      h("td", { class: "number", "data-lesson": `iterations-${name}` }, converged ? String(iterations) : words.residuals.more(iterations)),
      h("td", { class: "number", "data-lesson": `residual-${name}` }, ...powered(residuals[residuals.length - 1])),
      h("td", { class: "number", "data-lesson": `time-${name}` }, words.residuals.ms(fixed(time, 0))),
    );
  const heads = [words.residuals.method, words.residuals.iterations, words.residuals.residual, words.residuals.time].map((text) => h("th", { scope: "col" }, text));
  return h("table", {}, h("thead", {}, h("tr", {}, ...heads)), h("tbody", {}, ...runs.map(row)));
}
