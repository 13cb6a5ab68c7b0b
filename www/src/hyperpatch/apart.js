/**
 * Cells drawn apart: each is moved away from the middle of the body, by as much as its own middle lies off it.
 *
 * @import { CellSummary } from "../../../js/directrix.js"
 * @import { Bounds, Vector } from "../space/vector.js"
 *
 * @typedef {ReadonlyMap<number, Vector>} Shifts By the number of the cell.
 */
import { add, middleOf, scaled, subtract } from "../space/vector.js";

/** @type {Vector} */
const NOWHERE = [0, 0, 0];

/** @param {readonly Pick<CellSummary, "id" | "corners">[]} cells @param {Bounds} bounds of the body @returns {Shifts} */
export function shiftsOf(cells, bounds) {
  const middle = middleOf(bounds);
  return new Map(
    cells.map(({ id, corners }) => {
      const sum = corners.reduce((whole, corner) => add(whole, corner), NOWHERE);
      return [id, subtract(scaled(sum, 1 / corners.length), middle)];
    }),
  );
}

/** @param {Shifts} shifts @param {number} cell */
export const shiftOf = (shifts, cell) => shifts.get(cell) ?? NOWHERE;

/** The shifts of vertices, three numbers each. @param {ArrayLike<number>} cells of the vertices @param {Shifts} shifts */
export function shiftsAlong(cells, shifts) {
  const all = new Float32Array(3 * cells.length);
  for (let n = 0; n < cells.length; n += 1) all.set(shiftOf(shifts, cells[n]), 3 * n);
  return all;
}

/**
 * Points where they are drawn.
 * @param {{positions: Float32Array, cells: ArrayLike<number>}} mesh
 * @param {Shifts} shifts
 * @param {number} apart share of the shifts
 */
export function drawnPositions({ positions, cells }, shifts, apart) {
  if (apart === 0) return positions;
  const drawn = new Float32Array(positions.length);
  for (let n = 0; n < cells.length; n += 1) {
    const by = shiftOf(shifts, cells[n]);
    for (let k = 0; k < 3; k += 1) drawn[3 * n + k] = positions[3 * n + k] + apart * by[k];
  }
  return drawn;
}

/** A box that holds all cells as they are drawn. @param {Bounds} bounds @param {Shifts} shifts @param {number} apart @returns {Bounds} */
export function drawnBounds({ min, max }, shifts, apart) {
  const least = /** @type {Vector} */ ([0, 1, 2].map((k) => Math.min(0, ...[...shifts.values()].map((by) => by[k]))));
  const most = /** @type {Vector} */ ([0, 1, 2].map((k) => Math.max(0, ...[...shifts.values()].map((by) => by[k]))));
  return { min: add(min, scaled(least, apart)), max: add(max, scaled(most, apart)) };
}
