/**
 * Which of the shapes that were read are taken at first, and in which order they become curves.
 *
 * @import { Shape } from "../../../js/directrix.js"
 * @import { Point } from "../types.js"
 */

/** A document holds so many curves. */
export const MOST = 16;

/** So many are taken at first where none lies in another. */
const PAIR = 2;

/**
 * Indices of the shapes to take: the largest one that encloses another, with the largest that it encloses; else the two largest.
 * @param {readonly Shape[]} shapes
 * @returns {number[]} at most two, the inner one first
 */
export function firstChoice(shapes) {
  const order = shapes.map((_, index) => index).sort((a, b) => shapes[b].area - shapes[a].area);
  for (const outer of order) {
    const inner = order.find((index) => index !== outer && encloses(shapes[outer], shapes[index]));
    if (inner !== undefined) return [inner, outer];
  }
  return order.slice(0, PAIR).reverse();
}

/**
 * Whether shapes lie in each other as the curves of a stack do, rather than side by side in one.
 * @param {readonly Shape[]} shapes the smallest first
 */
export const isNest = (shapes) => shapes.every((shape, k) => k === 0 || encloses(shape, shapes[k - 1]));

/**
 * Whether all vertices of one shape lie inside another.
 * @param {Shape} outer
 * @param {Shape} inner
 */
function encloses(outer, inner) {
  if (inner.area >= outer.area) return false;
  const [a, b] = [boxOf(outer.points), boxOf(inner.points)];
  const within = [0, 1].every((k) => a.low[k] <= b.low[k] && b.high[k] <= a.high[k]);
  // Some vertices tell enough for a choice that the person may change.
  const step = Math.ceil(inner.points.length / 32);
  return within && inner.points.every((at, i) => i % step !== 0 || isInside(outer.points, at));
}

/** Whether a place lies within a closed chain. @param {readonly Point[]} ring @param {Point} at */
export function isInside(ring, [x, y]) {
  let inside = false;
  let [ax, ay] = ring[ring.length - 1];
  for (const [bx, by] of ring) {
    if (ay > y !== by > y && x < ax + (bx - ax) * ((y - ay) / (by - ay))) inside = !inside;
    [ax, ay] = [bx, by];
  }
  return inside;
}

/**
 * The box round points.
 * @param {readonly Point[]} points
 */
export function boxOf(points) {
  /** @type {Point} */
  const low = [Infinity, Infinity];
  /** @type {Point} */
  const high = [-Infinity, -Infinity];
  for (const at of points) {
    for (const k of [0, 1]) {
      low[k] = Math.min(low[k], at[k]);
      high[k] = Math.max(high[k], at[k]);
    }
  }
  return { low, high };
}

/** The length that tolerances refer to: the diagonal of the box. @param {readonly Point[]} points */
export function sizeOf(points) {
  const { low, high } = boxOf(points);
  return Math.hypot(high[0] - low[0], high[1] - low[1]);
}
