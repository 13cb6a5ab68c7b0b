/**
 * A tricubic cell by its 64 coefficients (i, j, k), at the place (4 i + j) 4 + k: points, compositions, boundary curves. The kernel has
 * the same as bulk work; here it is for single places.
 *
 * @import { Cell } from "./document.js"
 * @import { Vector } from "../space/vector.js"
 */

/** Segments of a boundary curve as it is drawn. */
const SEGMENTS = 16;

/** The four cubic Bernstein polynomials. @param {number} t 0 to 1 @returns {number[]} */
export function bernstein(t) {
  const s = 1 - t;
  return [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t];
}

/** The place of a coefficient in the list. @param {number} i @param {number} j @param {number} k */
export const placeOf = (i, j, k) => (4 * i + j) * 4 + k;

/**
 * Position and composition at parameters.
 * @param {Cell} cell
 * @param {readonly number[]} uvw 0 to 1 each
 * @param {number} materials how many there are
 * @returns {{position: Vector, mix: number[]}}
 */
export function sampleAt({ coefficients }, [u, v, w], materials) {
  const [bu, bv, bw] = [u, v, w].map(bernstein);
  /** @type {Vector} */
  const position = [0, 0, 0];
  const mix = Array.from({ length: materials }, () => 0);
  coefficients.forEach((coefficient, n) => {
    const weight = bu[n >> 4] * bv[(n >> 2) & 3] * bw[n & 3];
    for (const axis of /** @type {const} */ ([0, 1, 2])) position[axis] += weight * coefficient.position[axis];
    for (let m = 0; m < materials; m += 1) mix[m] += weight * (coefficient.mix?.[m] ?? (m === 0 ? 1 : 0));
  });
  return { position, mix };
}

/**
 * The four boundary curves of a face, as separate segments.
 * @param {Cell} cell
 * @param {import("../../../js/directrix.js").FaceName} face
 * @returns {number[]} six numbers a segment
 */
export const faceSegments = (cell, face) => edgeSegments(cell, { axis: "uvw".indexOf(face[0]), end: Number(face[1]) });

/**
 * The twelve boundary curves of a cell as separate segments.
 * @param {Cell} cell
 * @param {{axis: number, end: number}} [face] of which alone they are wanted
 * @returns {number[]} six numbers a segment
 */
export function edgeSegments({ coefficients }, face) {
  /** @type {number[]} */
  const segments = [];
  for (const axis of [0, 1, 2]) {
    for (const ends of [0, 1, 2, 3]) {
      const others = [ends >> 1, ends & 1].map((end) => 3 * end);
      const isOfFace = !face || (axis !== face.axis && others[face.axis - Number(face.axis > axis)] === 3 * face.end);
      if (!isOfFace) continue;
      const points = [0, 1, 2, 3].map((along) => {
        const index = [...others];
        index.splice(axis, 0, along);
        return coefficients[placeOf(index[0], index[1], index[2])].position;
      });
      const curve = Array.from({ length: SEGMENTS + 1 }, (_, n) => {
        const weights = bernstein(n / SEGMENTS);
        return [0, 1, 2].map((k) => points.reduce((sum, point, p) => sum + weights[p] * point[k], 0));
      });
      for (let n = 0; n < SEGMENTS; n += 1) segments.push(...curve[n], ...curve[n + 1]);
    }
  }
  return segments;
}
