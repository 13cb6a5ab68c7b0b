/**
 * Freehand strokes: places that are far enough apart, points along them, and whether one goes once round.
 *
 * @import { Point } from "../types.js"
 */

/** Pixels between places of a stroke, and how far the fitted curve may lie from it. */
export const SPACING = 3;
export const TOLERANCE = 2.5;
/** Pixels of its least length and least size. */
const SHORTEST = 80;
const SMALLEST = 16;
/** Pixels of a stroke from one point of an open curve to the next, and most such points. */
const STRETCH = 36;
const MOST = 40;

/**
 * Points along a stroke, evenly spread, both ends among them; none of one that is too short.
 * @param {readonly Point[]} line document units
 * @param {number} scale pixels for one unit
 * @returns {Point[]}
 */
export function spread(line, scale) {
  const arcs = [0];
  for (let i = 1; i < line.length; i += 1) arcs.push(arcs[i - 1] + Math.hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]));
  const length = arcs[arcs.length - 1];
  if (length * scale < SHORTEST) return [];
  const count = Math.min(MOST, Math.max(4, Math.round((length * scale) / STRETCH)));
  return Array.from({ length: count }, (_, k) => {
    const arc = (length * k) / (count - 1);
    const i = Math.max(1, arcs.findIndex((each) => each >= arc));
    const t = (arc - arcs[i - 1]) / (arcs[i] - arcs[i - 1] || 1);
    return /** @type {Point} */ ([0, 1].map((axis) => line[i - 1][axis] + t * (line[i][axis] - line[i - 1][axis])));
  });
}

/**
 * Whether a line is long and wide enough to be a closed curve.
 * @param {readonly Point[]} line document units
 * @param {number} scale pixels for one unit
 */
export function isLoop(line, scale) {
  let length = 0;
  for (let i = 1; i < line.length; i += 1) length += Math.hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
  const span = (/** @type {0 | 1} */ axis) => {
    const values = line.map((at) => at[axis]);
    return Math.max(...values) - Math.min(...values);
  };
  return length * scale >= SHORTEST && Math.min(span(0), span(1)) * scale >= SMALLEST;
}
