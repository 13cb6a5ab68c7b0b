/**
 * One tricubic cell written out: the weights of its 64 coefficients at a place, what they sum to, and the Jacobian determinant there. Pure
 * functions; the kernel has the same as bulk work, and the tests hold one against the other.
 *
 * @import { Cell } from "../hyperpatch/document.js"
 * @import { Vector } from "../space/vector.js"
 *
 * @typedef {[number, number, number]} Index of a coefficient, 0 to 3 each
 */
import { bernstein, placeOf } from "../hyperpatch/cell.js";
import { cross, dot } from "../space/vector.js";

/** All coefficients in their order. @type {readonly Index[]} */
export const INDICES = Array.from({ length: 64 }, (_, n) => /** @type {Index} */ ([n >> 4, (n >> 2) & 3, n & 3]));

/** The eight corners, as parameters. @type {readonly Vector[]} */
const CORNERS = Array.from({ length: 8 }, (_, n) => /** @type {Vector} */ ([n >> 2, (n >> 1) & 1, n & 1]));

/** The derivatives of the four cubic Bernstein polynomials. @param {number} t 0 to 1 @returns {number[]} */
function slopes(t) {
  const s = 1 - t;
  return [-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t];
}

/**
 * The weight of every coefficient, B_i(u) B_j(v) B_k(w); their sum is 1.
 * @param {readonly number[]} uvw 0 to 1 each
 * @returns {number[]} 64, in the order of the coefficients
 */
export function weightsAt(uvw) {
  const [bu, bv, bw] = uvw.map(bernstein);
  return INDICES.map(([i, j, k]) => bu[i] * bv[j] * bw[k]);
}

/**
 * det(dB/du, dB/dv, dB/dw): how many times larger, in volume, a small box of parameters becomes; negative where it is turned inside out.
 * @param {Cell} cell
 * @param {readonly number[]} uvw 0 to 1 each
 */
export function jacobianAt({ coefficients }, uvw) {
  const values = uvw.map(bernstein);
  const tangents = [0, 1, 2].map((axis) => {
    const factors = values.map((own, k) => (k === axis ? slopes(uvw[k]) : own));
    /** @type {Vector} */
    const sum = [0, 0, 0];
    for (const [i, j, k] of INDICES) {
      const weight = factors[0][i] * factors[1][j] * factors[2][k];
      const { position } = coefficients[placeOf(i, j, k)];
      for (let n = 0; n < 3; n += 1) sum[n] += weight * position[n];
    }
    return sum;
  });
  return dot(cross(tangents[0], tangents[1]), tangents[2]);
}

/** The least Jacobian at the eight corners. @param {Cell} cell */
export const leastAtCorners = (cell) => Math.min(...CORNERS.map((corner) => jacobianAt(cell, corner)));
