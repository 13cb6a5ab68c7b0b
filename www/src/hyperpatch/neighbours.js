/**
 * The coefficients round a corner: of each of its cells the seven others of its block of 2 x 2 x 2.
 *
 * @import { Vector } from "../space/vector.js"
 * @import { Cell } from "./document.js"
 * @import { Side } from "./edits.js"
 *
 * @typedef {object} Neighbours
 * @property {{cell: number, position: Vector}[]} points each once, the corner not among them
 * @property {{cell: number, from: Vector, to: Vector}[]} lines of the small grid that they make with the corner, each once
 */
import { placeOf } from "./cell.js";

/**
 * @param {readonly Side[]} sides of the corner
 * @param {(id: number) => Cell | undefined} cellOf
 * @param {boolean} isApart whether cells are drawn apart, and each has points and lines of its own
 * @returns {Neighbours}
 */
export function neighboursOf(sides, cellOf, isApart) {
  /** @type {Map<string, {cell: number, position: Vector}>} */
  const points = new Map();
  /** @type {Map<string, {cell: number, from: Vector, to: Vector}>} */
  const lines = new Map();
  for (const { cell, corner } of sides) {
    const found = cellOf(cell);
    if (!found) continue;
    // Places of the block, inwards from the corner along each axis.
    const at = (/** @type {number[]} */ inwards) => {
      const [i, j, k] = inwards.map((step, axis) => (corner[axis] ? 3 - step : step));
      return found.coefficients[placeOf(i, j, k)].position;
    };
    const nameOf = (/** @type {Vector} */ place) => (isApart ? `${cell} ` : "") + place.map((value) => value.toPrecision(9)).join(" ");
    for (let n = 0; n < 8; n += 1) {
      const inwards = [n & 1, (n >> 1) & 1, (n >> 2) & 1];
      const position = at(inwards);
      if (n > 0) points.set(nameOf(position), { cell, position });
      for (const axis of [0, 1, 2].filter((each) => inwards[each] === 0)) {
        const to = at(inwards.map((step, k) => (k === axis ? 1 : step)));
        lines.set([nameOf(position), nameOf(to)].sort().join(" "), { cell, from: position, to });
      }
    }
  }
  return { points: [...points.values()], lines: [...lines.values()] };
}
