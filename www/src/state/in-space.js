/**
 * Curves in space as the canvas shows them: projected along the direction in which the kernel matches them. Everything that places,
 * finds or moves control points on the canvas goes through here; a plane curve is its own projection.
 *
 * @import { CurvesDocument, Point, Shape } from "../types.js"
 *
 * @typedef {[number, number, number]} Vector
 */

/** Axes of the plane of the last result: that of the picture on the canvas. @type {readonly Vector[]} */
let axes = [[1, 0, 0], [0, 1, 0]];
/** Curves that were projected on it: one is never changed in place. @type {WeakMap<Shape, Shape>} */
let known = new WeakMap();

/** Significant digits of a coordinate that a move along slanting axes ends in. */
const DIGITS = 10;

/** Whether the control points of a curve lie in space. @param {Shape | undefined} curve */
export const isInSpace = (curve) => (curve?.points[0]?.length ?? 2) > 2;

/** Whether a document has curves in space. @param {Pick<CurvesDocument, "curves">} document */
export const hasSpace = ({ curves }) => curves.some(isInSpace);

/**
 * Takes over the plane of a result.
 * @param {{axes: readonly Vector[]} | null | undefined} projection
 */
export function seenAlong(projection) {
  if (!projection || String(projection.axes) === String(axes)) return;
  axes = projection.axes;
  known = new WeakMap();
}

/**
 * A curve as it is seen: its control points are those on the plane.
 * @template {Shape} T
 * @param {T} curve
 * @returns {T}
 */
export function seen(curve) {
  if (!isInSpace(curve)) return curve;
  const found = known.get(curve) ?? { ...curve, points: curve.points.map(projected) };
  known.set(curve, found);
  return /** @type {T} */ (found);
}

/** @param {Point} at @returns {Point} */
function projected(at) {
  const [x, y, z] = /** @type {Vector} */ (/** @type {unknown} */ (at));
  return /** @type {any} */ ([0, 1].map((k) => axes[k][0] * x + axes[k][1] * y + axes[k][2] * z));
}

/**
 * A control point after it was moved on the canvas. In space it keeps its distance from the plane.
 * @param {Point} from in the document
 * @param {Point} was on the plane
 * @param {Point} to on the plane
 * @returns {Point}
 */
export function moved(from, was, to) {
  if (from.length === 2) return [to[0], to[1]];
  return /** @type {any} */ (
    from.map((value, k) => {
      const by = axes[0][k] * (to[0] - was[0]) + axes[1][k] * (to[1] - was[1]);
      return by === 0 ? value : Number((value + by).toPrecision(DIGITS));
    })
  );
}
