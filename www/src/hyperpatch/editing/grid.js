/**
 * The coefficients at a corner in a grid, as pure functions.
 *
 * @import { Around, Point } from "./around.js"
 *
 * @typedef {object} Node
 * @property {Point} point
 * @property {readonly number[]} at its place in the grid, along u, v and w
 * @property {boolean} isCorner whether it is the corner itself
 */

/**
 * Points of a corner in a grid: by their offsets, or at a crease those of the cell that was asked about, by their places in it.
 * @param {Pick<Around, "neighbourhood" | "side">} around
 * @returns {Node[]}
 */
export function nodesOf({ neighbourhood, side }) {
  return neighbourhood.points.flatMap((point) => {
    const { offset } = point;
    if (neighbourhood.regular) return offset ? [{ point, at: offset, isCorner: offset.every((step) => step === 0) }] : [];
    const user = point.users.find(({ cell }) => cell === side.cell);
    return user ? [{ point, at: user.at, isCorner: user.at.every((along, k) => along === 3 * side.corner[k]) }] : [];
  });
}
