/**
 * The certificate of a cell step by step: the 729 Bernstein coefficients of its Jacobian determinant, and what comes of halving. Pure
 * functions; the kernel has the same as bulk work, and the tests hold one against the other.
 *
 * J = det(dB/du, dB/dv, dB/dw) has degree 8 along each parameter, and is a mean of its coefficients with Bernstein weights. So it is nowhere below
 * the least of them, and has the values of those at the corners there (A. Johnen, J.-F. Remacle, C. Geuzaine, Geometrical validity of
 * curvilinear finite elements, J. Comput. Phys. 233, 2013).
 *
 * @import { Cell } from "../hyperpatch/document.js"
 * @import { Vector } from "../space/vector.js"
 *
 * @typedef {{numbers: Float64Array, least: number, corner: number}} Piece 729 numbers at the place (9 p + q) 9 + r; the least of all, and of those at
 *   the eight corners
 */
import { cross, dot, subtract } from "../space/vector.js";
import { placeOf } from "../hyperpatch/cell.js";

/** Degree along each parameter, and numbers along it. */
const DEGREE = 8;
const COUNT = DEGREE + 1;
const STRIDES = [COUNT * COUNT, COUNT, 1];

/** Rows of Pascal's triangle. @param {number} n @returns {number[]} */
const binomials = (n) => Array.from({ length: n + 1 }, (_, k) => Array.from({ length: k }, (_, m) => (n - m) / (m + 1)).reduce((a, b) => a * b, 1));
const [TWO, THREE, EIGHT] = [2, 3, 8].map(binomials);

/**
 * The differences of neighbouring coefficients along an axis, each times its binomials.
 * @param {Cell} cell
 * @param {number} axis
 * @returns {{at: number[], vector: Vector}[]} 48
 */
function differences({ coefficients }, axis) {
  const found = [];
  const ends = [0, 1, 2].map((k) => (k === axis ? 3 : 4));
  for (let i = 0; i < ends[0]; i += 1) {
    for (let j = 0; j < ends[1]; j += 1) {
      for (let k = 0; k < ends[2]; k += 1) {
        const at = [i, j, k];
        const [a, b, c] = at.map((each, n) => each + (n === axis ? 1 : 0));
        const weight = at.reduce((product, each, n) => product * (n === axis ? TWO : THREE)[each], 1);
        const by = subtract(coefficients[placeOf(a, b, c)].position, coefficients[placeOf(i, j, k)].position);
        found.push({ at, vector: /** @type {Vector} */ (by.map((each) => each * weight)) });
      }
    }
  }
  return found;
}

/** The 729 coefficients of the Jacobian determinant. @param {Cell} cell @returns {Float64Array} */
export function jacobianNumbers(cell) {
  const [along, across, up] = [0, 1, 2].map((axis) => differences(cell, axis));
  // Normals first: they have degrees 5, 5 and 6.
  /** @type {Map<number, {at: number[], vector: Vector}>} */
  const normals = new Map();
  for (const { at, vector } of along) {
    for (const other of across) {
      const place = at.map((each, n) => each + other.at[n]);
      const key = (place[0] * 7 + place[1]) * 7 + place[2];
      const by = cross(vector, other.vector);
      const sum = normals.get(key);
      if (sum) for (const k of /** @type {const} */ ([0, 1, 2])) sum.vector[k] += by[k];
      else normals.set(key, { at: place, vector: by });
    }
  }
  const numbers = new Float64Array(COUNT ** 3);
  for (const { at, vector } of normals.values()) {
    for (const other of up) {
      const [p, q, r] = at.map((each, n) => each + other.at[n]);
      numbers[(p * COUNT + q) * COUNT + r] += dot(vector, other.vector);
    }
  }
  return numbers.map((sum, n) => (27 * sum) / (EIGHT[Math.floor(n / 81)] * EIGHT[Math.floor(n / 9) % 9] * EIGHT[n % 9]));
}

/** @param {Float64Array} numbers @returns {Piece} */
function piece(numbers) {
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((n) => DEGREE * (STRIDES[0] * (n >> 2) + STRIDES[1] * ((n >> 1) & 1) + (n & 1)));
  return { numbers, least: numbers.reduce((a, b) => Math.min(a, b)), corner: Math.min(...corners.map((n) => numbers[n])) };
}

/** The axis along which neighbouring numbers differ most. @param {Float64Array} numbers */
function steepest(numbers) {
  const most = STRIDES.map((stride) => {
    let found = 0;
    for (let n = 0; n + stride < numbers.length; n += 1) {
      if (Math.floor(n / stride) % COUNT < DEGREE) found = Math.max(found, Math.abs(numbers[n + stride] - numbers[n]));
    }
    return found;
  });
  return most.indexOf(Math.max(...most));
}

/** Both halves of a piece along an axis, by de Casteljau. @param {Float64Array} numbers @param {number} axis */
function halved(numbers, axis) {
  const stride = STRIDES[axis];
  const [low, high] = [numbers.slice(), numbers.slice()];
  for (let start = 0; start < numbers.length; start += 1) {
    if (Math.floor(start / stride) % COUNT !== 0) continue;
    const line = Array.from({ length: COUNT }, (_, n) => numbers[start + n * stride]);
    for (let n = 0; n < COUNT; n += 1) {
      low[start + n * stride] = line[0];
      high[start + (DEGREE - n) * stride] = line[DEGREE - n];
      for (let m = 0; m < DEGREE - n; m += 1) line[m] = (line[m] + line[m + 1]) / 2;
    }
  }
  return [low, high];
}

/**
 * The pieces of a cell after so many halvings, each of the piece with the least number, along the axis in which it changes most.
 * @param {Cell} cell
 * @param {number} count
 * @returns {Piece[]} count + 1, that with the least number first
 */
export function pieces(cell, count) {
  const all = [piece(jacobianNumbers(cell))];
  for (let n = 0; n < count; n += 1) {
    const [worst] = all;
    all.splice(0, 1, ...halved(worst.numbers, steepest(worst.numbers)).map(piece));
    all.sort((a, b) => a.least - b.least);
  }
  return all;
}
