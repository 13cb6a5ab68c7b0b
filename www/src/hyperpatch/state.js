/**
 * What the picture of a body shows besides the document, and what is chosen in it.
 *
 * @import { BodySharing } from "../../../js/directrix.js"
 * @import { Bounds } from "../space/vector.js"
 * @import { Section } from "../space/section.js"
 * @import { Reach, Side } from "./edits.js"
 *
 * @typedef {object} Shown
 * @property {"material" | "fraction" | "jacobian"} color
 * @property {number} material index of the material whose fraction is shown
 * @property {boolean} edges
 * @property {boolean} corners
 * @property {boolean} light
 * @property {number} apart how far cells are drawn apart, 0 to 1
 * @property {number} transparency of the faces, 0 to 1
 * @property {"off" | import("./joints.js").Aspect} continuity what is shown of how cells continue each other
 * @property {Section} section
 * @property {number | null} cell the chosen one
 * @property {Side | null} corner the chosen one, as one of its cells has it
 * @property {Reach} reach what moves with a corner
 */

/** @type {Readonly<Shown>} */
export const FIRST_SHOWN = {
  color: "material",
  material: 0,
  edges: true,
  corners: true,
  light: true,
  apart: 0,
  transparency: 0,
  continuity: "off",
  section: { axis: "off", at: 0.5, flipped: false },
  cell: null,
  corner: null,
  reach: "block",
};

/** @param {ArrayLike<number>} positions three numbers a point @returns {Bounds} */
export function boundsOf(positions) {
  /** @type {Bounds} */
  const box = { min: [Infinity, Infinity, Infinity], max: [-Infinity, -Infinity, -Infinity] };
  for (let n = 0; n < positions.length; n += 1) {
    const axis = n % 3;
    if (positions[n] < box.min[axis]) box.min[axis] = positions[n];
    if (positions[n] > box.max[axis]) box.max[axis] = positions[n];
  }
  return positions.length > 0 ? box : { min: [0, 0, 0], max: [1, 1, 1] };
}

/**
 * A corner with every cell that has it; null where no cell has it any more.
 * @param {Pick<BodySharing, "corners">} sharing
 * @param {Side | null} side
 */
export function sharedCorner({ corners }, side) {
  if (!side) return null;
  const is = (/** @type {Side} */ other) => other.cell === side.cell && other.corner.every((end, k) => end === side.corner[k]);
  return corners.find(({ sides }) => sides.some(is)) ?? null;
}

/** Whether the picture needs the faces between cells. @param {Shown} shown */
export const hasInner = ({ apart, transparency, continuity }) => apart > 0 || transparency > 0 || continuity !== "off";

/**
 * The corner so many places after a chosen one, round and round, those within the body as well; the first where none is chosen.
 * @param {Pick<BodySharing, "corners">} sharing
 * @param {Side | null} chosen
 * @param {1 | -1} by
 * @returns {Side | null}
 */
export function neighbour(sharing, chosen, by) {
  const { corners } = sharing;
  if (corners.length === 0) return null;
  const shared = sharedCorner(sharing, chosen);
  const here = corners.findIndex((corner) => corner === shared);
  const next = here < 0 ? (by > 0 ? 0 : corners.length - 1) : (here + by + corners.length) % corners.length;
  const [{ cell, corner }] = corners[next].sides;
  return { cell, corner };
}
