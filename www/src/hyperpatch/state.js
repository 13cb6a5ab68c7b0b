/**
 * What the picture of a body shows besides the document, and what is chosen in it.
 *
 * @import { BodySharing } from "../../../js/directrix.js"
 * @import { Bounds } from "../space/vector.js"
 * @import { Section } from "../space/section.js"
 * @import { FaceName } from "../../../js/directrix.js"
 * @import { Place, Reach, Side } from "./edits.js"
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
 * @property {number | null} cell the one chosen last
 * @property {readonly number[]} cells all that are chosen, that one the last of them
 * @property {boolean} picksCells whether a click chooses cells besides those that are chosen
 * @property {readonly {cell: number, face: FaceName}[]} faces chosen ones
 * @property {boolean} picksFaces whether a click chooses faces instead of cells
 * @property {Side | null} corner the chosen one, as one of its cells has it
 * @property {readonly Side[]} others corners that move with it
 * @property {boolean} picksCorners whether a click chooses corners besides
 * @property {Place | null} at the chosen neighbour of the corner; null for the corner itself
 * @property {Reach} reach what moves with it
 * @property {"off" | "x" | "y" | "z"} mirror axis of the plane in which moves are mirrored
 * @property {boolean} isMiddle whether that plane goes through the middle of the body, and not through the origin
 * @property {import("./editing/refusal.js").Policy} invalid what happens to edits that make a cell invalid
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
  cells: [],
  picksCells: false,
  faces: [],
  picksFaces: false,
  corner: null,
  others: [],
  picksCorners: false,
  at: null,
  reach: "block",
  mirror: "off",
  isMiddle: false,
  invalid: "ask",
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

/** Of a list with one more of it, or one less where it was there. @template T @param {readonly T[]} list @param {T} item @param {(a: T, b: T) => boolean} [is] */
export function toggled(list, item, is = (a, b) => a === b) {
  const others = list.filter((each) => !is(each, item));
  return others.length < list.length ? others : [...list, item];
}

/** @param {Side} a @param {Side} b */
export const isSide = (a, b) => a.cell === b.cell && a.corner.every((end, k) => end === b.corner[k]);

/**
 * What is chosen, without what the body does not have any more.
 * @param {Shown} shown
 * @param {{cells: readonly {id: number}[], sharing: Pick<BodySharing, "corners" | "faces">}} known
 * @returns {Shown}
 */
export function withoutGone(shown, { cells, sharing }) {
  const ids = new Set(cells.map(({ id }) => id));
  const isThere = (/** @type {{cell: number}} */ { cell }) => ids.has(cell);
  const isOuter = new Set(sharing.faces.filter(({ sides }) => sides.length === 1).map(({ sides: [side] }) => `${side.cell} ${side.face}`));
  const kept = shown.cells.filter((cell) => ids.has(cell));
  const faces = shown.faces.filter(({ cell, face }) => isOuter.has(`${cell} ${face}`));
  const isSame = kept.length === shown.cells.length && faces.length === shown.faces.length && (!shown.corner || isThere(shown.corner)) && shown.others.every(isThere) && (!shown.at || isThere(shown.at));
  if (isSame) return shown;
  const corner = shown.corner && isThere(shown.corner) ? shown.corner : null;
  return { ...shown, cells: kept, cell: kept.at(-1) ?? null, faces, corner, others: shown.others.filter(isThere), at: corner && shown.at && isThere(shown.at) ? shown.at : null };
}

/**
 * A corner with every cell that has it; null where no cell has it any more.
 * @param {Pick<BodySharing, "corners">} sharing
 * @param {Side | null} side
 */
export function sharedCorner({ corners }, side) {
  if (!side) return null;
  return corners.find(({ sides }) => sides.some((other) => isSide(other, side))) ?? null;
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
