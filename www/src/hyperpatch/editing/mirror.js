/**
 * Symmetric editing: what lies opposite of a coefficient in a mirror plane across an axis, and how it moves.
 *
 * @import { BodySharing } from "../../../../js/directrix.js"
 * @import { Cell } from "../document.js"
 * @import { Axis, Place, Side } from "../edits.js"
 * @import { Vector } from "../../space/vector.js"
 *
 * @typedef {{axis: Axis, at: number}} Mirror The plane where that coordinate is `at`.
 */
import { placeOf } from "../cell.js";

/** How far a coefficient may lie from the mirrored place, as a share of the body. */
const NEAR = 1e-6;

/** @param {readonly number[]} point @param {Mirror} mirror @returns {Vector} */
const mirroredPoint = (point, { axis, at }) => /** @type {Vector} */ (point.map((value, k) => (k === axis ? 2 * at - value : value)));

/** @param {readonly number[]} way @param {Axis} axis @returns {Vector} */
export const mirroredWay = (way, axis) => /** @type {Vector} */ (way.map((value, k) => (k === axis ? 0 - value : value)));

/**
 * The coefficient opposite of one.
 * @param {Side} corner that it belongs to
 * @param {Place} place
 * @param {Mirror} mirror
 * @param {object} body
 * @param {Pick<BodySharing, "corners">} body.sharing
 * @param {(id: number) => Cell | undefined} body.cellOf
 * @param {number} body.size its diagonal, document units
 * @returns {Place | "itself" | null} null where there is none
 */
export function opposite(corner, place, mirror, { sharing, cellOf, size }) {
  const at = (/** @type {Place} */ { cell, at: [i, j, k] }) => cellOf(cell)?.coefficients[placeOf(i, j, k)].position;
  const [mine, own] = [at(place), at({ cell: corner.cell, at: corner.corner.map((end) => 3 * end) })];
  if (!mine || !own) return null;
  const isAt = (/** @type {readonly number[]} */ a, /** @type {readonly number[]} */ b) => Math.hypot(...a.map((value, k) => value - b[k])) <= NEAR * size;
  const wanted = mirroredPoint(mine, mirror);
  if (isAt(mine, wanted)) return "itself";
  const across = mirroredPoint(own, mirror);
  const found = sharing.corners.find(({ position }) => isAt(position, across));
  const places = (found?.sides ?? []).flatMap(({ cell, corner: ends }) =>
    Array.from({ length: 8 }, (_, n) => ({ cell, at: ends.map((end, k) => (end ? 3 - ((n >> k) & 1) : (n >> k) & 1)) })),
  );
  // The corner itself comes first: where two coefficients are one point it is meant.
  return places.find((each) => isAt(at(each) ?? [Infinity, 0, 0], wanted)) ?? null;
}
