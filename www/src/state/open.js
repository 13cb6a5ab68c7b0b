/**
 * Two open curves beside each other: what lies between them, for marks and fills of the page.
 *
 * @import { Curve, Point } from "../types.js"
 */
import { outline, signedArea } from "../spline.js";

/**
 * The ring along one chain and back along another one, from whichever end is nearer.
 * @param {readonly Point[]} first
 * @param {readonly Point[]} second
 * @returns {Point[]}
 */
export function joined(first, second) {
  const far = (/** @type {Point} */ a, /** @type {Point} */ b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
  const [start, end] = [first[0], first[first.length - 1]];
  const [other, last] = [second[0], second[second.length - 1]];
  const alike = far(start, other) + far(end, last) <= far(start, last) + far(end, other);
  return [...first, ...(alike ? [...second].reverse() : second)];
}

/**
 * On which side of an open curve as drawn the other one lies: 1 to the right, where its normal points, -1 to the left.
 * @param {readonly Curve[]} curves
 * @param {number} index
 */
export function sideOf(curves, index) {
  const [own, other] = [curves[index], curves[1 - index]].map((curve) => (curve ? outline(curve).map(({ at }) => at) : []));
  return other.length > 0 && signedArea(joined(own, other)) > 0 ? -1 : 1;
}
