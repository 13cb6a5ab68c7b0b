/**
 * Edits of bodies as pure functions: every edit is an operation at the end of the document's list, which can be read and changed like any
 * other. Operations that an edit leaves alone stay the same objects, so that each is sent to the module once.
 *
 * @import { HyperpatchOperation } from "../../../js/directrix.js"
 * @import { BodyDocument } from "./document.js"
 * @import { Vector } from "../space/vector.js"
 *
 * @typedef {HyperpatchOperation} Operation
 * @typedef {{cell: number, corner: readonly number[]}} Side A corner as one cell has it: 0 or 1 along u, v and w.
 * @typedef {{cell: number, at: readonly number[]}} Place A coefficient of a cell, 0 to 3 along u, v and w.
 * @typedef {"block" | "single"} Reach
 *   With what belongs to it: a corner with its blocks in all its cells, a neighbour of a smooth corner with those that keep it smooth; or alone.
 * @typedef {0 | 1 | 2} Axis
 */
import { add } from "../space/vector.js";

/** Largest identifier of an operation, as in docs/format.md. */
const LAST_ID = 9999;
/** Digits of displacements that are kept, so that sums of many small ones stay readable. */
const DIGITS = 12;

/** The run of edits that an operation was made in. Operations of the same run and target are one. @type {WeakMap<Operation, string>} */
const runs = new WeakMap();

/** The coefficient of a corner. @param {Side} side @returns {Place} */
export const placeOfCorner = ({ cell, corner }) => ({ cell, at: corner.map((end) => 3 * end) });

/** Whether a place is a corner of its cell. @param {readonly number[]} at */
export const isCorner = (at) => at.every((along) => along === 0 || along === 3);

/** The identifiers of operations: where none is written, one more than the largest before it. @param {readonly Operation[]} operations */
export function idsOf(operations) {
  let largest = -1;
  return operations.map(({ id = largest + 1 }) => {
    largest = Math.max(largest, id);
    return id;
  });
}

/** An identifier that no operation has: the next one, or where there is none the least that is free. @param {readonly Operation[]} operations */
function freeId(operations) {
  const ids = idsOf(operations);
  const next = Math.max(-1, ...ids) + 1;
  if (next <= LAST_ID) return next;
  const taken = new Set(ids);
  let free = 0;
  while (taken.has(free)) free += 1;
  return free;
}

/** What an operation is about, as a text: operations of one run that are about the same are joined. @param {Operation} operation */
function targetOf(operation) {
  const { by, mix, shape, material, rule, id, ...target } = /** @type {any} */ (operation);
  return JSON.stringify(target);
}

/**
 * An operation that goes on where another of the same target was: displacements add up, what else it says takes its place.
 * @param {Operation} before
 * @param {Operation} next
 * @returns {Operation | null} null where nothing is left of it
 */
function joined(before, next) {
  if (before.op !== "move" || next.op !== "move") return /** @type {Operation} */ ({ ...before, ...next });
  const by = rounded(add(/** @type {Vector} */ (before.by), /** @type {Vector} */ (next.by)));
  return by.every((length) => length === 0) ? null : { ...before, by };
}

/** @param {readonly number[]} by @returns {Vector} */
const rounded = (by) => /** @type {Vector} */ (by.map((length) => Number(length.toPrecision(DIGITS)) + 0));

/**
 * Adds an operation at the end, or lets the one of the same run and target take it up.
 * @param {BodyDocument} document
 * @param {Operation} operation without an identifier
 * @param {string} [run]
 * @returns {BodyDocument}
 */
export function appended(document, operation, run) {
  const { operations } = document;
  const target = targetOf(operation);
  let at = operations.length - 1;
  while (run !== undefined && at >= 0 && runs.get(operations[at]) === run && targetOf(operations[at]) !== target) at -= 1;
  const before = run !== undefined && at >= 0 && runs.get(operations[at]) === run ? operations[at] : null;
  const { op, ...rest } = operation;
  const next = before ? joined(before, operation) : /** @type {Operation} */ ({ op, id: freeId(operations), ...rest });
  if (next && run !== undefined) runs.set(next, run);
  const list = before ? operations.flatMap((each) => (each === before ? (next ?? []) : each)) : [...operations, ...(next ? [next] : [])];
  return { ...document, operations: list };
}

/**
 * Moves coefficients by the same way.
 * @param {BodyDocument} document
 * @param {readonly {place: Place, by: Vector}[]} moves document units
 * @param {Reach} reach
 * @param {string} [run]
 * @returns {BodyDocument} the same one when nothing moves
 */
export function moved(document, moves, reach, run) {
  return moves.reduce((next, { place: { cell, at }, by }) => {
    if (by.every((length) => length === 0)) return next;
    const operation = { op: /** @type {const} */ ("move"), cell, at: /** @type {Vector} */ ([...at]), by: rounded(by), ...(reach === "single" ? { reach } : {}) };
    return appended(next, operation, run);
  }, document);
}

/**
 * The way that moves of a coefficient have taken in one document and not yet in another: what an edit does before the module answers.
 * @param {BodyDocument} document
 * @param {BodyDocument} since
 * @param {Place} place
 * @returns {Vector}
 */
export function movedSince(document, since, { cell, at }) {
  const is = (/** @type {Operation} */ operation) => operation.op === "move" && operation.cell === cell && operation.at.every((along, k) => along === at[k]);
  const old = new Set(since.operations);
  const now = new Set(document.operations);
  /** @type {Vector} */
  const way = [0, 0, 0];
  const count = (/** @type {readonly Operation[]} */ list, /** @type {Set<Operation>} */ others, /** @type {1 | -1} */ sign) => {
    for (const operation of list) {
      if (operation.op !== "move" || others.has(operation) || !is(operation)) continue;
      operation.by.forEach((length, k) => (way[k] += sign * length));
    }
  };
  count(document.operations, old, 1);
  count(since.operations, now, -1);
  return way;
}

/**
 * Operations in another order or fewer of them, each with the identifier that it had.
 * @param {readonly {operation: Operation, id: number}[]} list
 * @returns {Operation[]}
 */
function pinned(list) {
  let largest = -1;
  return list.map(({ operation, id }) => {
    const isDefault = id === largest + 1;
    largest = Math.max(largest, id);
    if (operation.id === undefined ? isDefault : operation.id === id) return operation;
    const { op, ...rest } = operation;
    return /** @type {Operation} */ ({ op, ...rest, id });
  });
}

/** Operations with their identifiers. @param {BodyDocument} document */
function identified({ operations }) {
  const ids = idsOf(operations);
  return operations.map((operation, n) => ({ operation, id: ids[n] }));
}

/** Without one of its operations. @param {BodyDocument} document @param {number} place @returns {BodyDocument} */
export function without(document, place) {
  const list = identified(document).filter((_, n) => n !== place);
  return list.length === document.operations.length ? document : { ...document, operations: pinned(list) };
}

/**
 * With one of its operations earlier or later by one.
 * @param {BodyDocument} document
 * @param {number} place
 * @param {1 | -1} by
 * @returns {BodyDocument} the same one at either end
 */
export function shifted(document, place, by) {
  const list = identified(document);
  const other = place + by;
  if (!list[place] || !list[other]) return document;
  [list[place], list[other]] = [list[other], list[place]];
  return { ...document, operations: pinned(list) };
}

/**
 * With other numbers in one of its operations.
 * @param {BodyDocument} document
 * @param {number} place
 * @param {object} patch
 * @returns {BodyDocument}
 */
export function changed(document, place, patch) {
  const operations = document.operations.map((operation, n) => (n === place ? /** @type {Operation} */ ({ ...operation, ...patch }) : operation));
  return { ...document, operations };
}
