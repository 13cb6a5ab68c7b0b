/**
 * The plane on the screen: a centre and a scale, and what follows from them.
 *
 * @import { CurvesDocument, Point, Size, View } from "./types.js"
 */

/**
 * @param {View} view
 * @param {Size} size
 * @param {Point} at document units
 * @returns {Point} CSS pixels from the upper left corner
 */
export function toScreen(view, size, at) {
  return [
    size.width / 2 + (at[0] - view.center[0]) * view.scale,
    size.height / 2 - (at[1] - view.center[1]) * view.scale,
  ];
}

/**
 * @param {View} view
 * @param {Size} size
 * @param {Point} at CSS pixels
 * @returns {Point} document units
 */
export function toPlane(view, size, at) {
  return [
    view.center[0] + (at[0] - size.width / 2) / view.scale,
    view.center[1] - (at[1] - size.height / 2) / view.scale,
  ];
}

/**
 * Zooms so that the place under `about` stays under it.
 * @param {View} view
 * @param {Size} size
 * @param {Point} about CSS pixels
 * @param {number} factor
 * @param {{min: number, max: number}} limits of the scale
 * @returns {View}
 */
export function zoomed(view, size, about, factor, limits) {
  const scale = Math.min(limits.max, Math.max(limits.min, view.scale * factor));
  const fixed = toPlane(view, size, about);
  const center = /** @type {Point} */ ([
    fixed[0] - (about[0] - size.width / 2) / scale,
    fixed[1] + (about[1] - size.height / 2) / scale,
  ]);
  return { center, scale };
}

/**
 * @param {View} view
 * @param {Point} by CSS pixels
 * @returns {View}
 */
export function panned(view, by) {
  return { ...view, center: [view.center[0] - by[0] / view.scale, view.center[1] + by[1] / view.scale] };
}

/**
 * The largest of 1, 2 and 5 times a power of ten that is not above `value`.
 * @param {number} value
 */
export function niceBelow(value) {
  const decade = 10 ** Math.floor(Math.log10(value));
  const lead = value / decade;
  return decade * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1);
}

/** Least distance of grid lines in pixels, as the kernel draws them. */
const GRID = 48;

/**
 * The step of the grid: the smallest of 1, 2 and 5 times a power of ten that keeps its lines apart.
 * @param {number} scale pixels for one unit
 */
export function gridStep(scale) {
  const least = GRID / scale;
  const exponent = Math.floor(Math.log10(least));
  for (const power of [exponent, exponent + 1]) {
    for (const factor of [1, 2, 5]) {
      const step = power < 0 ? factor / 10 ** -power : factor * 10 ** power;
      if (step >= least) return step;
    }
  }
  return 10 ** (exponent + 2);
}

/**
 * The step of an arrow key: the power of ten nearest to a hundredth of the figure.
 * @param {CurvesDocument} document
 */
export function arrowStep(document) {
  const points = document.curves.flatMap((curve) => curve.points);
  const xs = points.map((p) => p[0]);
  const ys = points.map((p) => p[1]);
  const extent = Math.max(span(xs), span(ys));
  return extent > 0 ? 10 ** Math.round(Math.log10(extent / 100)) : 1;
}

/** @param {number[]} values */
function span(values) {
  let low = Infinity;
  let high = -Infinity;
  for (const value of values) {
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  return high - low;
}

/**
 * Rounds a dragged coordinate to the decimal place below a tenth of a pixel: no digits that nobody could aim at.
 * @param {number} value
 * @param {View} view
 */
export function aimed(value, view) {
  const places = Math.min(12, Math.max(0, Math.ceil(Math.log10(view.scale)) + 1));
  return Number(value.toFixed(places)) + 0;
}
