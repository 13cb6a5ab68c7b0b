/**
 * What is chosen on the canvas: a whole curve, or some of its control points. Everything outside reads a selection
 * through these functions.
 *
 * @import { CurvesDocument, Point, Selection } from "../types.js"
 */
import { handleCount } from "./edits.js";
import { seen } from "./in-space.js";

/**
 * A whole curve.
 * @param {number} curve
 * @returns {Selection}
 */
export const whole = (curve) => ({ curve, points: [] });

/**
 * One control point.
 * @param {number} curve
 * @param {number} point
 * @returns {Selection}
 */
export const only = (curve, point) => ({ curve, points: [point] });

/**
 * Several control points in ascending order, each once. No point is the whole curve.
 * @param {number} curve
 * @param {Iterable<number>} points
 * @returns {Selection}
 */
export const several = (curve, points) => ({ curve, points: [...new Set(points)].sort((a, b) => a - b) });

/**
 * Every control point of a curve, each by itself.
 * @param {CurvesDocument} document
 * @param {number} curve
 * @returns {Selection}
 */
export const allPoints = (document, curve) => several(curve, Array(handleCount(document.curves[curve])).keys());

/**
 * Whether a whole curve is chosen.
 * @param {Selection | null} selection
 */
export const isWhole = (selection) => selection?.points.length === 0;

/**
 * The one chosen point, or null when it is none or several.
 * @param {Selection | null} selection
 */
export const singlePoint = (selection) => (selection?.points.length === 1 ? selection.points[0] : null);

/**
 * @param {Selection | null} selection
 * @param {number} curve
 * @param {number} point
 */
export const includes = (selection, curve, point) => selection?.curve === curve && selection.points.includes(point);

/**
 * Adds a point to the selection or takes it out. A point of the other curve, and one beside a whole curve, starts anew;
 * the last point stays, so that a selection of points never turns into one of the curve by accident.
 * @param {Selection | null} selection
 * @param {number} curve
 * @param {number} point
 * @returns {Selection}
 */
export function toggle(selection, curve, point) {
  if (selection?.curve !== curve || isWhole(selection)) return only(curve, point);
  const { points } = selection;
  if (!points.includes(point)) return several(curve, [...points, point]);
  return points.length > 1 ? several(curve, points.filter((other) => other !== point)) : selection;
}

/**
 * The selection as far as the document has it: points past the end are dropped; the last point of the curve stands in
 * for them when none is left.
 * @param {Selection | null} selection
 * @param {CurvesDocument} document
 * @returns {Selection | null}
 */
export function within(selection, document) {
  if (!selection) return null;
  const curve = document.curves[selection.curve];
  if (!curve) return document.curves.length > 0 ? whole(0) : null;
  if (isWhole(selection)) return selection;
  const count = handleCount(curve);
  const points = selection.points.filter((point) => point < count);
  if (points.length === selection.points.length) return selection;
  return points.length > 0 ? several(selection.curve, points) : only(selection.curve, count - 1);
}

/**
 * Indices of the control points that the selection moves: those it names, or all of the curve.
 * @param {CurvesDocument} document
 * @param {Selection} selection
 * @returns {number[]}
 */
export function movedPoints(document, selection) {
  return isWhole(selection) ? allPoints(document, selection.curve).points : selection.points;
}

/**
 * The mean of the control points that the selection moves, on the canvas.
 * @param {CurvesDocument} document
 * @param {Selection} selection
 * @returns {Point}
 */
export function middleOf(document, selection) {
  const { points } = seen(document.curves[selection.curve]);
  const moved = movedPoints(document, selection);
  let [x, y] = [0, 0];
  for (const index of moved) {
    x += points[index][0] / moved.length;
    y += points[index][1] / moved.length;
  }
  return [x, y];
}
