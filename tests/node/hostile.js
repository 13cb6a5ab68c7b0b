/**
 * The bad input of `tests/hostile/cases.json`, and a small generator of random changes.
 *
 * @typedef {object} Case
 * @property {string} name
 * @property {string} text of the file
 * @property {string | undefined} code
 * @property {string | undefined} path
 * @property {string[]} says words of the message
 */
import { readFileSync } from "node:fs";

const table = JSON.parse(readFileSync(new URL("../hostile/cases.json", import.meta.url), "utf8"));

/** A good document, which the cases are changes of. */
export const base = table.base;

/** @type {Case[]} */
export const cases = table.cases.map((/** @type {any} */ one) => ({ ...one, text: textOf(one) }));

/** @param {any} one */
function textOf({ text, times = 1, set = {}, ring, fill, replace }) {
  if (text !== undefined) return text.repeat(times);
  const document = structuredClone(base);
  for (const [pointer, value] of Object.entries(set)) put(document, pointer, value);
  if (ring) {
    const [curve, count] = ring;
    put(document, `/curves/${curve}/points`, Array.from({ length: count }, (_, k) => [k % 1000, Math.floor(k / 1000)]));
  }
  if (fill) {
    const [pointer, item, count] = fill;
    put(document, pointer, typeof item === "string" ? item.repeat(count) : new Array(count).fill(item));
  }
  const written = JSON.stringify(document);
  return replace ? written.replace(replace[0], replace[1]) : written;
}

/**
 * @param {any} document
 * @param {string} pointer
 * @param {unknown} value
 */
function put(document, pointer, value) {
  const names = pointer.split("/").slice(1);
  const last = names.pop() ?? "";
  names.reduce((inner, name) => inner[name], document)[last] = value;
}

/**
 * Whole numbers below a bound, the same for the same seed (splitmix32).
 *
 * @param {number} seed
 */
export function numbers(seed) {
  let state = seed | 0;
  return (/** @type {number} */ below) => {
    state = (state + 0x9e3779b9) | 0;
    let z = Math.imul(state ^ (state >>> 16), 0x21f0aaad);
    z = Math.imul(z ^ (z >>> 15), 0x735a2d97);
    return ((z ^ (z >>> 15)) >>> 0) % below;
  };
}

/** Values that a careless hand or program may put anywhere. */
const JUNK = [null, true, "", "NaN", [], {}, -1, 0, 0.5, 2, 7, 1e300, -1e300, 1e-300, 1e12, [[0, 0], [0, 0]], "\u0000\u202e"];

/**
 * A document with up to three places changed or removed.
 *
 * @param {unknown} document
 * @param {(below: number) => number} number
 */
export function mutated(document, number) {
  const changed = structuredClone(document);
  for (let i = number(3); i >= 0; i--) {
    /** @type {[any, string][]} */
    const places = [];
    const visit = (/** @type {any} */ value) => {
      if (value === null || typeof value !== "object") return;
      for (const key of Object.keys(value)) {
        places.push([value, key]);
        visit(value[key]);
      }
    };
    visit(changed);
    if (places.length === 0) continue;
    const [owner, key] = places[number(places.length)];
    const what = number(JUNK.length + 3);
    if (what < JUNK.length) owner[key] = JUNK[what];
    else if (Array.isArray(owner)) owner.splice(Number(key), 1);
    else delete owner[key];
  }
  return changed;
}

/**
 * A text with a few characters changed, dropped, doubled or cut off.
 *
 * @param {string} text
 * @param {(below: number) => number} number
 */
export function garbled(text, number) {
  let result = text;
  for (let i = number(4); i >= 0 && result; i--) {
    const at = number(result.length);
    const kind = number(8);
    if (kind < 2) result = result.slice(0, at) + String.fromCharCode(number(0x3000)) + result.slice(at + 1);
    else if (kind < 4) result = result.slice(0, at) + "0123456789-.eE[]{},:"[number(20)] + result.slice(at + 1);
    else if (kind < 6) result = result.slice(0, at) + result.slice(at + 1);
    else if (kind < 7) result = result.slice(0, at) + result[at] + result.slice(at);
    else if (number(4) === 0) result = result.slice(0, at);
  }
  return result;
}
