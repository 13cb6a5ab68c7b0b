/**
 * Hyperpatch documents on their way to the module: their operations travel one by one, and each is written, sent and read once.
 *
 * Operations are taken as immutable: one that is the same object as before is the same operation, and whoever changes one makes a new object.
 * So an edit of a large body costs the operation that it adds. The cells of an operation that writes them out travel one by one as well, so
 * that reading them is work in small steps.
 *
 * @typedef {{ text: string, cells?: string[], count?: number }} Written an operation as JSON, its cells apart
 *
 * @typedef {object} Packed a document as it goes to the module
 * @property {string} head JSON of all but the operations
 * @property {Uint32Array} keys of the operations
 * @property {boolean} apart whether it has a list of operations that come apart; else `head` is all of it
 * @property {(place: number) => Written} write the operation at a place of the list
 * @property {() => void} [known] is called once the module has the whole document
 */
import { DirectrixError } from "./errors.js";
import { toText } from "./text.js";

/** Most cells of a document. More of them are counted and not written. */
const MOST_CELLS = 10_000;
/** Most operations of a document. */
const MOST_OPERATIONS = 10_000;
/** Longest text of a document, in bytes. */
const LONGEST_TEXT = 4 << 20;
/** Materials of a document that names none. */
const MATERIALS = 2;
/** Documents that came as text and are kept, so that their operations stay the same objects. */
const KEPT = 4;

/** @type {WeakMap<object, { materials: number, key: number }>} */
const keys = new WeakMap();
let next = 0;

/** @type {Map<string, unknown>} */
const parsed = new Map();

/** Keys of operations of this side, from a number on: a worker's own are to be others than those that it is sent. @param {number} start */
export function countFrom(start) {
  next = start;
}

/**
 * A document in parts.
 *
 * @param {unknown} document an object, or its JSON
 * @returns {Packed}
 * @throws {DirectrixError} when it is no object, or holds numbers that are not finite
 */
export function packed(document) {
  const value = valueOf(document);
  if (typeof value !== "object" || value === null || !("operations" in value) || !Array.isArray(value.operations)) {
    return { head: typeof document === "string" ? document : toText(value), keys: new Uint32Array(), apart: false, write };
  }
  const { operations, ...rest } = /** @type {{ operations: unknown[], materials?: unknown }} */ (value);
  const materials = Array.isArray(rest.materials) ? rest.materials.length : MATERIALS;
  const found = operations.length > MOST_OPERATIONS ? new Uint32Array(operations.length) : Uint32Array.from(operations, (one) => keyOf(one, materials));
  return { head: toText(rest), keys: found, apart: true, write: (place) => written(operations[place], `operations[${place}]`) };
}

/**
 * A document as an object.
 *
 * @param {unknown} document an object, or its JSON
 * @returns {unknown}
 * @throws {DirectrixError} with code `syntax` or `limit`
 */
export function valueOf(document) {
  return typeof document === "string" ? read(document) : document;
}

/**
 * The key of an operation in documents of so many materials. What is no object is never the same again; it is refused anyway.
 *
 * @param {unknown} operation
 * @param {number} materials
 */
function keyOf(operation, materials) {
  if (typeof operation !== "object" || operation === null) return next++;
  const known = keys.get(operation);
  if (known?.materials === materials) return known.key;
  const key = next++;
  keys.set(operation, { materials, key });
  return key;
}

/** A document that came as text. @param {string} text */
function read(text) {
  if (parsed.has(text)) return parsed.get(text);
  if (text.length * 3 > LONGEST_TEXT) {
    const { length } = new TextEncoder().encode(text);
    if (length > LONGEST_TEXT) {
      throw new DirectrixError("limit", "", `the text has ${length} bytes; at most ${LONGEST_TEXT} are read`);
    }
  }
  let value;
  try {
    value = JSON.parse(text);
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    throw new DirectrixError("syntax", "", `the text is not JSON that can be read: ${reason}`);
  }
  parsed.set(text, value);
  for (const old of parsed.keys()) {
    if (parsed.size <= KEPT) break;
    parsed.delete(old);
  }
  return value;
}

/**
 * @param {unknown} operation
 * @param {string} path
 * @returns {Written}
 */
function written(operation, path) {
  if (typeof operation === "object" && operation !== null && "op" in operation && operation.op === "cells") {
    const { cells, ...rest } = /** @type {{ cells?: unknown }} */ (operation);
    if (Array.isArray(cells)) {
      const texts = cells.length > MOST_CELLS ? [] : cells.map((cell, n) => objectText(cell, `${path}.cells[${n}]`));
      return { text: toText(rest, path), cells: texts, count: cells.length };
    }
  }
  return { text: objectText(operation, path) };
}

/**
 * The JSON of what should be an object; text is none.
 *
 * @param {unknown} value
 * @param {string} path
 */
function objectText(value, path) {
  if (typeof value === "string") {
    throw new DirectrixError("type", path, `the text ${JSON.stringify(value.slice(0, 40))} was found; expected an object`);
  }
  return toText(value, path);
}

/** @returns {Written} */
function write() {
  throw new DirectrixError("failed", "", "a document without a list of operations has none to supply");
}
