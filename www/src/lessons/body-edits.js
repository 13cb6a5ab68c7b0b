/**
 * What figures of bodies change about their documents: a twist, displacements of coefficients, the material of a row of cells. The build
 * makes the first state of a figure by the same functions. Pure functions.
 *
 * @import { HyperpatchDocument, HyperpatchOperation } from "../../../js/directrix.js"
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 * @import { Cell, Coefficient } from "../hyperpatch/document.js"
 * @import { Vector } from "../space/vector.js"
 * @import { Index } from "./cell-sum.js"
 *
 * @typedef {"block" | "single" | "pair"} Reach `block` and `single` as in docs/format.md; `pair` moves the coefficient beyond the corner the other
 *   way, and nothing else: Eq. 8 of the paper on one pair
 * @typedef {"reflect" | "flat" | "natural"} Rule for the material on either side of a joint
 * @typedef {{before: number, at: number}} Shares fractions of the second material at the middle joint of a row, and at the coefficients before it
 * @typedef {{cell: number, at: Index}} Chosen
 */
import { placeOf } from "../hyperpatch/cell.js";
import { subtract } from "../space/vector.js";
import { INDICES } from "./cell-sum.js";

/** What counts as one point, in the coordinates of the presets. */
const SAME = 1e-6;

/** @param {HyperpatchDocument} document @returns {Cell[]} those that are written out */
const written = ({ operations }) => operations.flatMap((operation) => (operation.op === "cells" ? /** @type {Cell[]} */ (operation.cells) : []));

/**
 * A document whose cells that are written out have become others.
 * @template {HyperpatchDocument} D
 * @param {D} document
 * @param {(coefficient: Coefficient, index: Index, cell: number) => Coefficient} change
 * @returns {D}
 */
function changed(document, change) {
  let cell = -1;
  const operations = document.operations.map((operation) => {
    if (operation.op !== "cells") return operation;
    const cells = /** @type {Cell[]} */ (operation.cells).map(({ coefficients }) => {
      cell += 1;
      return { coefficients: coefficients.map((own, n) => change(own, INDICES[n], cell)) };
    });
    return { ...operation, cells };
  });
  return { ...document, operations: /** @type {HyperpatchOperation[]} */ (operations) };
}

/**
 * The layers of coefficients from w = 0 to w = 1 turned about the z axis, evenly up to the whole angle.
 * @template {HyperpatchDocument} D
 * @param {D} document
 * @param {number} degrees
 * @returns {D}
 */
export function twisted(document, degrees) {
  return changed(document, (own, [, , k]) => {
    const angle = (((degrees * k) / 3) * Math.PI) / 180;
    const [x, y, z] = own.position;
    return { ...own, position: [x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle), z] };
  });
}

/**
 * One coefficient at another place, and nothing else.
 * @template {HyperpatchDocument} D
 * @param {D} document
 * @param {Chosen} chosen
 * @param {Vector} position
 * @returns {D}
 */
export function placed(document, { cell: which, at }, position) {
  return changed(document, (own, index, cell) => (cell === which && String(index) === String(at) ? { ...own, position } : own));
}

/** The end of the axis that a coefficient belongs to, along each of them: its corner. @param {readonly number[]} at @returns {Vector} */
export const cornerOf = (at) => /** @type {Vector} */ (at.map((each) => (each < 2 ? 0 : 1)));

/**
 * The coefficient beyond the corner of another one, in line with both, in the body before any of them was moved; null where there is none.
 * @param {HyperpatchDocument} document
 * @param {Chosen} chosen
 * @returns {Chosen | null}
 */
export function oppositeOf(document, { cell, at }) {
  const cells = written(document);
  const own = cells[cell]?.coefficients;
  if (!own) return null;
  const [i, j, k] = cornerOf(at).map((end) => 3 * end);
  const from = own[placeOf(...at)].position;
  const beyond = own[placeOf(i, j, k)].position.map((each, axis) => 2 * each - from[axis]);
  for (const [other, { coefficients }] of cells.entries()) {
    const n = coefficients.findIndex(({ position }) => Math.hypot(...subtract(position, /** @type {Vector} */ (beyond))) < SAME);
    if (n >= 0 && (other !== cell || n !== placeOf(...at))) return { cell: other, at: INDICES[n] };
  }
  return null;
}

/**
 * A document with a displacement after its operations, or with a larger one if it ends with the same.
 * @template {HyperpatchDocument} D
 * @param {D} document
 * @param {Chosen} chosen
 * @param {readonly number[]} by
 * @param {Reach} reach
 * @returns {D}
 */
export function moved(document, chosen, by, reach) {
  const move = (/** @type {Chosen} */ { cell, at }, /** @type {readonly number[]} */ by) => ({
    op: /** @type {const} */ ("move"),
    cell,
    at,
    by: /** @type {Vector} */ ([...by]),
    reach: reach === "pair" ? /** @type {const} */ ("single") : reach,
  });
  const opposite = reach === "pair" ? oppositeOf(document, chosen) : null;
  const moves = [move(chosen, by), ...(opposite ? [move(opposite, by.map((each) => -each))] : [])];
  const last = document.operations.slice(-moves.length);
  const isMore = moves.every((one, n) => {
    const before = /** @type {Partial<typeof one>} */ (last[n] ?? {});
    return before.op === "move" && before.cell === one.cell && before.reach === one.reach && String(before.at) === String(one.at);
  });
  if (!isMore) return { ...document, operations: [...document.operations, ...moves] };
  const more = moves.map((one, n) => ({ ...one, by: one.by.map((each, axis) => each + /** @type {any} */ (last[n]).by[axis]) }));
  return { ...document, operations: /** @type {HyperpatchOperation[]} */ ([...document.operations.slice(0, -moves.length), ...more]) };
}

/**
 * A document whose last displacement, if it is that of the coefficient, is made again with something else going along.
 * @template {HyperpatchDocument} D
 * @param {D} document
 * @param {Chosen} chosen
 * @param {Reach} from what went along
 * @param {Reach} to
 * @returns {D}
 */
export function redone(document, chosen, from, to) {
  const count = from === "pair" && oppositeOf(document, chosen) ? 2 : 1;
  const last = document.operations.at(-count);
  if (last?.op !== "move" || last.cell !== chosen.cell || String(last.at) !== String(chosen.at)) return document;
  return moved({ ...document, operations: document.operations.slice(0, -count) }, chosen, last.by, to);
}

/** What Eq. 8 of the paper asks for beyond a joint: as far on the other side. @param {Shares} shares */
export const reflected = ({ before, at }) => 2 * at - before;

/**
 * A row of four cells with these fractions about its middle joint, and the material of all joints by a rule. What a reflection asks for is
 * taken as far as it is a composition.
 * @template {HyperpatchDocument} D
 * @param {D} document
 * @param {Shares} shares
 * @param {Rule} rule
 * @returns {D}
 */
export function graded(document, shares, rule) {
  const beyond = Math.min(1, Math.max(0, reflected(shares)));
  const sides = rule === "reflect" ? { before: shares.before, beyond } : { before: shares.at, beyond: shares.at };
  // Layers of the second cell and of the third, where they are given.
  const middle = [[undefined, undefined, sides.before, shares.at], [shares.at, sides.beyond]];
  const row = changed(document, (own, [i], cell) => {
    const share = middle[cell - 1]?.[i];
    return share === undefined ? own : { ...own, mix: [1 - share, share] };
  });
  const operations = row.operations.filter(({ op }) => op !== "slope");
  if (rule !== "natural") return { ...row, operations };
  const corners = [0, 1, 2, 3].map((n) => [n >> 1, n & 1]);
  const slope = (/** @type {number} */ cell, /** @type {number} */ end) =>
    corners.map(([v, w]) => ({ op: /** @type {const} */ ("slope"), cell, corner: /** @type {Vector} */ ([end, v, w]), rule: /** @type {const} */ ("natural") }));
  const slopes = [...slope(0, 0), ...written(row).flatMap((_, cell) => slope(cell, 1))];
  return { ...row, operations: /** @type {HyperpatchOperation[]} */ ([...operations, ...slopes]) };
}

/** The fractions of a figure of a row at first; half of each material without any. @param {Figure} figure @returns {Shares} */
export const firstShares = ({ shares }) => ({ before: shares?.[0] ?? 0.5, at: shares?.[1] ?? 0.5 });

/**
 * The first state of a figure of a body.
 * @template {HyperpatchDocument} D
 * @param {D} document
 * @param {Figure} figure
 * @returns {D}
 */
export function firstState(document, figure) {
  const { twist, rule, by, reach, cell, coefficient } = figure;
  const turned = twist === null ? document : twisted(document, twist);
  const row = rule ? graded(turned, firstShares(figure), rule) : turned;
  return by ? moved(row, { cell, at: coefficient ?? [3, 3, 3] }, by, reach ?? "single") : row;
}
