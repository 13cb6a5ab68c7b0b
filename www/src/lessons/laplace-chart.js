/**
 * Charts of boundary elements: what panels do to one, the matrix, errors and residuals.
 *
 * @import { Matrix } from "./laplace-known.js"
 */
import { h, svg } from "../dom.js";
import { significantText } from "../format.js";
import { label } from "./chart-label.js";
import { words } from "./words-laplace.js";

/** Units of the view: the chart, room for figures on the left and below. */
const WIDTH = 560;
const HEIGHT = 150;
const LEFT = 66;
const BELOW = 40;
const ABOVE = 10;
const RIGHT = 10;
/** CSS pixels of the picture of a matrix. */
const MATRIX = 280;

/** @param {number} share */
const across = (share) => LEFT + (WIDTH - LEFT - RIGHT) * share;
/** @param {number} share from below */
const up = (share) => ABOVE + HEIGHT * (1 - share);
/** @param {number} x @param {number} y shares */
const at = (x, y) => `${across(x).toFixed(1)} ${up(y).toFixed(1)}`;

/** @param {string} name for who does not see it @param {string} axis @param {(SVGElement | string)[]} parts */
function framed(name, axis, parts) {
  const picture = svg(
    "svg",
    { class: "laplace-chart", viewBox: `0 0 ${WIDTH} ${ABOVE + HEIGHT + BELOW}`, role: "img", "aria-label": name },
    ...parts,
    svg("path", { class: "chart-axis", d: `M${at(0, 1)}L${at(0, 0)}L${at(1, 0)}` }),
    label(axis, across(0.5), up(0) + 36, "middle"),
  );
  return h("div", { class: "laplace-scroll" }, /** @type {any} */ (picture));
}

/** Powers of ten on the left: their places, and a few of their names. @param {number} low @param {number} high exponents */
function powers(low, high) {
  const every = Math.max(1, Math.ceil((high - low) / 4));
  const share = (/** @type {number} */ exponent) => (exponent - low) / (high - low);
  const exponents = Array.from({ length: high - low + 1 }, (_, n) => low + n);
  return exponents.flatMap((exponent) => [
    svg("path", { class: "laplace-rule", d: `M${at(0, share(exponent))}L${at(1, share(exponent))}` }),
    ...((exponent - low) % every === 0 ? [label(exponent === 0 ? "1" : `1e${String(exponent).replace("-", "−")}`, LEFT - 8, up(share(exponent)) + 4, "end")] : []),
  ]);
}

/** Bars of one row of a matrix. @param {Matrix} matrix @param {number} row */
export function rowChart({ matrix, count }, row) {
  const own = Array.from(matrix.subarray(row * count, (row + 1) * count));
  const [low, high] = [Math.min(0, ...own), Math.max(0, ...own)];
  const share = (/** @type {number} */ value) => (value - low) / (high - low || 1);
  const bar = (/** @type {number} */ value, /** @type {number} */ n) => {
    const [x, w] = [across((n + 0.12) / count), ((WIDTH - LEFT - RIGHT) * 0.76) / count];
    const [top, bottom] = [Math.max(share(value), share(0)), Math.min(share(value), share(0))];
    return svg("rect", { class: n === row ? "laplace-bar chosen" : "laplace-bar", x: x.toFixed(1), y: up(top).toFixed(1), width: w.toFixed(1), height: Math.max(0.5, HEIGHT * (top - bottom)).toFixed(1) });
  };
  const every = Math.ceil(count / 16);
  return framed(words.influence.picture(row + 1), words.influence.axis, [
    ...own.map(bar),
    ...own.flatMap((_, n) => (n % every === 0 ? [label(String(n + 1), across((n + 0.5) / count), up(0) + 17, "middle")] : [])),
    label(significantText(high), LEFT - 8, up(1) + 8, "end"),
    label(significantText(low), LEFT - 8, up(0) + 4, "end"),
  ]);
}

/**
 * The matrix as a picture: a square for each number, in the accent colour as strong as the number is large.
 * @param {Matrix} matrix
 * @param {number} row that is marked
 * @param {string} color
 */
export function matrixPicture({ matrix, count }, row, color) {
  const ratio = Math.min(3, window.devicePixelRatio || 1);
  const cell = Math.max(1, Math.floor((MATRIX * ratio) / count));
  const canvas = h("canvas", { class: "laplace-matrix", role: "img", "aria-label": words.matrix.picture(count), width: cell * count, height: cell * count });
  const context = canvas.getContext("2d");
  if (context) {
    const largest = matrix.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
    context.fillStyle = color;
    matrix.forEach((x, n) => {
      context.globalAlpha = 0.02 + (0.98 * Math.abs(x)) / largest;
      context.fillRect((n % count) * cell, Math.floor(n / count) * cell, cell, cell);
    });
    context.globalAlpha = 1;
    context.strokeStyle = color;
    context.lineWidth = Math.max(1, ratio);
    context.strokeRect(context.lineWidth / 2, row * cell, cell * count - context.lineWidth, cell);
  }
  return canvas;
}

/**
 * Errors by numbers of panels, in powers of ten both.
 * @param {readonly {panels: number, error: number}[]} rows from few panels to many
 * @param {number} now panels of the figure
 */
export function errorChart(rows, now) {
  const logs = rows.map(({ error }) => Math.log10(error));
  const [low, high] = [Math.floor(Math.min(...logs)), Math.ceil(Math.max(...logs))];
  const [first, last] = [Math.log10(rows[0].panels), Math.log10(rows[rows.length - 1].panels)];
  const x = (/** @type {number} */ panels) => 0.03 + (0.94 * (Math.log10(panels) - first)) / (last - first || 1);
  const points = rows.map(({ panels }, n) => at(x(panels), (logs[n] - low) / (high - low || 1)));
  return framed(words.error.picture, words.error.axis, [
    ...powers(low, Math.max(high, low + 1)),
    svg("path", { class: "laplace-line jacobi", d: `M${points.join("L")}` }),
    svg("path", { class: "laplace-dots", d: points.map((point) => `M${point}h.01`).join("") }),
    svg("path", { class: "laplace-dots chosen", d: rows.flatMap(({ panels }, n) => (panels === now ? [`M${points[n]}h.01`] : [])).join("") }),
    ...rows.map(({ panels }) => label(String(panels), across(x(panels)), up(0) + 17, "middle")),
  ]);
}

/**
 * Residuals by iterations, in powers of ten.
 * @param {readonly {name: string, residuals: ArrayLike<number>}[]} rows
 * @param {number} tolerance
 */
export function residualChart(rows, tolerance) {
  const most = Math.max(10, ...rows.map(({ residuals }) => residuals.length - 1));
  const low = Math.floor(Math.log10(tolerance));
  const y = (/** @type {number} */ residual) => Math.max(0, Math.min(1, (Math.log10(Math.max(residual, 1e-300)) - low) / -low));
  const step = [1, 2, 5, 10, 20, 50, 100].find((each) => most / each <= 8) ?? 200;
  const ticks = Array.from({ length: Math.floor(most / step) + 1 }, (_, n) => n * step);
  const line = (/** @type {{name: string, residuals: ArrayLike<number>}} */ { name, residuals }) =>
    svg("path", { class: `laplace-line ${name}`, d: `M${Array.from(residuals, (residual, n) => at(n / most, y(residual))).join("L")}` });
  return framed(words.residuals.picture, words.residuals.axis, [
    ...powers(low, 0),
    ...rows.map(line),
    ...ticks.map((tick) => label(String(tick), across(tick / most), up(0) + 17, "middle")),
  ]);
}
