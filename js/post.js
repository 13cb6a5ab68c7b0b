/**
 * Hyperpatch documents in messages: operations that the other side has are named by their keys alone.
 *
 * @import { Packed, Written } from "./operations.js"
 *
 * @typedef {object} Posted a document in a message
 * @property {"hyperpatch"} posted
 * @property {string} head
 * @property {Uint32Array} keys
 * @property {boolean} apart
 * @property {[key: number, operation: Written][]} written operations that the other side was not sent before
 */
import { DirectrixError } from "./errors.js";

/** Characters of operations that were received and not read yet, as those of calls that were cancelled; the oldest go first. */
const MOST_WAITING = 64e6;

/** @type {Map<number, Written>} */
const waiting = new Map();
let size = 0;

/**
 * A document as a message.
 *
 * @param {Packed} document
 * @param {Set<number>} sent keys of the operations that the other side has been sent; those that go with this message are added
 * @returns {Posted}
 */
export function posted({ head, keys, apart, write }, sent) {
  /** @type {Posted["written"]} */
  const written = [];
  keys.forEach((key, place) => {
    if (!sent.has(key)) written.push([key, write(place)]);
  });
  for (const [key] of written) sent.add(key);
  return { posted: "hyperpatch", head, keys, apart, written };
}

/** Takes in what a message brings, also of a call that will be cancelled before its turn. @param {any} argument the first of a call */
export function receive(argument) {
  if (argument?.posted !== "hyperpatch") return;
  for (const [key, written] of /** @type {Posted} */ (argument).written) {
    drop(key);
    waiting.set(key, written);
    size += lengthOf(written);
  }
  for (const old of waiting.keys()) {
    if (size <= MOST_WAITING) break;
    drop(old);
  }
}

/** @param {number} key */
function drop(key) {
  const written = waiting.get(key);
  if (written) size -= lengthOf(written);
  waiting.delete(key);
}

/** @param {Written} written */
const lengthOf = ({ text, cells = [] }) => cells.reduce((sum, cell) => sum + cell.length, text.length);

/**
 * The document of a message, or `undefined` when it is none.
 *
 * @param {any} argument
 * @returns {Packed | undefined}
 */
export function received(argument) {
  if (argument?.posted !== "hyperpatch") return undefined;
  // On one thread nobody has received it before.
  receive(argument);
  const { head, keys, apart } = /** @type {Posted} */ (argument);
  return { head, keys, apart, write: (place) => take(keys[place]), known: () => keys.forEach(drop) };
}

/** @param {number} key */
function take(key) {
  const written = waiting.get(key);
  if (!written) throw new DirectrixError("unsent", "", "an operation is not known here any more; expected it to be sent again");
  return written;
}
