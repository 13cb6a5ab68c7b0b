/**
 * Vectors of three numbers, as far as cameras, planes and picking need them.
 *
 * @typedef {[number, number, number]} Vector
 *
 * @typedef {object} Bounds
 * @property {Vector} min
 * @property {Vector} max
 */

/** @param {readonly number[]} a @param {readonly number[]} b @returns {Vector} */
export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];

/** @param {readonly number[]} a @param {readonly number[]} b @returns {Vector} */
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** @param {readonly number[]} a @param {number} factor @returns {Vector} */
export const scaled = (a, factor) => [a[0] * factor, a[1] * factor, a[2] * factor];

/** @param {readonly number[]} a @param {readonly number[]} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @param {readonly number[]} a @param {readonly number[]} b @returns {Vector} */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** @param {readonly number[]} a @returns {Vector} */
export function unit(a) {
  return scaled(a, 1 / Math.hypot(a[0], a[1], a[2]));
}

/** @param {readonly number[]} a @param {readonly number[]} b @param {number} t 0 at a, 1 at b @returns {Vector} */
export const between = (a, b, t) => add(a, scaled(subtract(b, a), t));

/** @param {Bounds} bounds @returns {Vector} */
export const middleOf = ({ min, max }) => between(min, max, 0.5);

/** The length of the diagonal of a box. @param {Bounds} bounds */
export const diagonalOf = ({ min, max }) => Math.hypot(...subtract(max, min));

/** The eight corners of a box. @param {Bounds} bounds @returns {Vector[]} */
export function cornersOf({ min, max }) {
  return [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1 ? max[0] : min[0], i & 2 ? max[1] : min[1], i & 4 ? max[2] : min[2]]);
}

/** Flat numbers as points. @param {Float32Array} points @returns {Vector[]} */
export function triples(points) {
  return Array.from({ length: points.length / 3 }, (_, i) => [points[3 * i], points[3 * i + 1], points[3 * i + 2]]);
}
