/**
 * More and fewer points of a shape.
 *
 * @import { Point } from "../../types.js"
 * @import { WholePart } from "../document.js"
 */
import { fewestOf, handleCount, hasList, keptPoint } from "../shapes/geometry.js";
import { removePoints as removeFromCurve } from "../../state/edits.js";
import { changeShape, countAll, MOST_POINTS, shapeOf } from "./shapes.js";

/**
 * Why a shape cannot have one more point, or null: it has no list, or the document has as many as it can.
 * @param {WholePart} document
 * @param {string} name
 * @returns {"kind" | "points" | null}
 */
export function whyNotInsert(document, name) {
  const shape = shapeOf(document, name);
  if (!shape || !hasList(shape)) return "kind";
  return countAll(document) >= MOST_POINTS ? "points" : null;
}

/**
 * Puts a point into a polygon or a chain of segments. A point of a curve comes with a knot, which is for the kernel to place.
 * @param {WholePart} document
 * @param {string} name
 * @param {number} index that it has then
 * @param {Point} at
 */
export function insertPoint(document, name, index, at) {
  if (whyNotInsert(document, name)) return document;
  return changeShape(document, name, (shape) =>
    shape.kind === "polygon" || shape.kind === "polyline" ? { ...shape, points: shape.points.toSpliced(index, 0, keptPoint(at)) } : shape,
  );
}

/**
 * The place of a point that comes after another: half-way to the next, and past the end of an open chain as far as the last one came.
 * @param {readonly Point[]} points
 * @param {boolean} closed
 * @param {number} after
 * @returns {Point}
 */
export function placeAfter(points, closed, after) {
  const from = points[after];
  const next = points[after + 1] ?? (closed ? points[0] : null);
  if (next) return [(from[0] + next[0]) / 2, (from[1] + next[1]) / 2];
  const before = points[after - 1] ?? from;
  return [2 * from[0] - before[0], 2 * from[1] - before[1]];
}

/**
 * Whether a shape can spare points.
 * @param {WholePart} document
 * @param {string} name
 * @param {number} [count]
 */
export function canRemove(document, name, count = 1) {
  const shape = shapeOf(document, name);
  return shape !== undefined && hasList(shape) && handleCount(shape) - count >= fewestOf(shape);
}

/**
 * Takes points away, of a curve each with the knot that belonged to it; all of them, or none where too few would be left.
 * @param {WholePart} document
 * @param {string} name
 * @param {readonly number[]} points
 */
export function removePoints(document, name, points) {
  if (points.length === 0 || !canRemove(document, name, points.length)) return document;
  return changeShape(document, name, (shape) => {
    if (shape.kind === "curve") return onCurve(shape, (curves) => removeFromCurve(curves, 0, points));
    return hasList(shape) ? { ...shape, points: shape.points.filter((_, i) => !points.includes(i)) } : shape;
  });
}

/**
 * An edit of documents of curves, on one curve by itself.
 * @template {object} Curve
 * @param {Curve} curve
 * @param {(document: import("../../types.js").CurvesDocument) => import("../../types.js").CurvesDocument} edit
 * @returns {Curve}
 */
function onCurve(curve, edit) {
  const [next] = edit(/** @type {any} */ ({ curves: [curve] })).curves;
  return /** @type {Curve} */ (/** @type {unknown} */ (next));
}
