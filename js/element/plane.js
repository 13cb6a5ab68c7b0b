/**
 * The plane in a figure: a centre, and a scale in CSS pixels per unit.
 *
 * @import { CurvesDocument, Point, View } from "../directrix.js"
 *
 * @typedef {{ width: number, height: number }} Size in CSS pixels
 */
import { planePoints } from "./in-space.js";

/**
 * @param {View} view
 * @param {Size} size
 * @param {Point} at document units
 * @returns {Point} CSS pixels from the upper left corner
 */
export function toScreen({ center, scale }, { width, height }, [x, y]) {
  return [width / 2 + (x - center[0]) * scale, height / 2 - (y - center[1]) * scale];
}

/**
 * @param {View} view
 * @param {Size} size
 * @param {Point} at CSS pixels
 * @returns {Point} document units, without digits below a tenth of a pixel, which nobody could aim at
 */
export function toPlane({ center, scale }, { width, height }, [x, y]) {
  const places = Math.min(12, Math.max(0, Math.ceil(Math.log10(scale)) + 1));
  const rounded = (/** @type {number} */ value) => Number(value.toFixed(places)) + 0;
  return [rounded(center[0] + (x - width / 2) / scale), rounded(center[1] - (y - height / 2) / scale)];
}

/**
 * The view that shows some points with room around them.
 *
 * @param {readonly Point[]} points
 * @param {Size} size
 * @param {number} margin CSS pixels on every side
 * @returns {View}
 */
export function fitting(points, size, margin) {
  if (points.length === 0) return { center: [0, 0], scale: Math.min(size.width, size.height) / 100 };
  const [left, right] = bounds(points.map(([x]) => x));
  const [bottom, top] = bounds(points.map(([, y]) => y));
  const room = (/** @type {number} */ side) => Math.max(side - 2 * margin, side / 2, 1);
  const scale = Math.min(room(size.width) / (right - left || 1), room(size.height) / (top - bottom || 1));
  return { center: [(left + right) / 2, (bottom + top) / 2], scale };
}

/**
 * The step of an arrow key: the power of ten nearest to a hundredth of the figure.
 *
 * @param {CurvesDocument} document
 */
export function arrowStep({ curves }) {
  const points = curves.flatMap(planePoints);
  const [left, right] = bounds(points.map(([x]) => x));
  const [bottom, top] = bounds(points.map(([, y]) => y));
  const extent = Math.max(right - left, top - bottom);
  return extent > 0 ? 10 ** Math.round(Math.log10(extent / 100)) : 1;
}

/** @param {number[]} values */
function bounds(values) {
  return [Math.min(...values), Math.max(...values)];
}
