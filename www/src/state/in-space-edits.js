/**
 * Edits of curves in space along the axes of the document, as pure functions.
 *
 * @import { Curve, Point } from "../types.js"
 */
import { tidy } from "./edits.js";

/**
 * The mean of some control points along an axis of the document.
 * @param {Curve} curve
 * @param {readonly number[]} points
 * @param {number} axis
 */
export const meanAlong = ({ points: all }, points, axis) => points.reduce((sum, i) => sum + all[i][axis] / points.length, 0);

/**
 * Moves some control points of a curve in space along an axis of the document.
 * @param {Curve} curve
 * @param {readonly number[]} points
 * @param {number} axis
 * @param {number} by
 * @returns {Curve}
 */
export function movedAlong(curve, points, axis, by) {
  if (by === 0) return curve;
  const chosen = new Set(points);
  if (curve.form === "clamped" && chosen.has(0)) chosen.add(curve.points.length - 1);
  const next = curve.points.map((at, i) =>
    chosen.has(i) ? at.map((value, k) => (k === axis ? tidy(value + by) : value)) : at,
  );
  return { ...curve, points: /** @type {Point[]} */ (next) };
}
