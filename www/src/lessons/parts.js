/**
 * What a term of the text names in a figure, as it lies on the screen: to be lit up when the term is pointed at, and to be found under
 * the pointer. Pure functions.
 *
 * @import { Point } from "../types.js"
 *
 * @typedef {object} Part
 * @property {Point[][]} [lines] polylines, CSS pixels
 * @property {Point[]} [dots]
 * @property {Point[][]} [area] closed outlines; a point in an odd number of them is inside
 *
 * @typedef {Map<string, Part>} Parts by term
 */
import { dot, polyline } from "./path.js";

/** Distance at which a line or a dot is under the pointer, CSS pixels. */
const REACH = 7;
/** A dot on a line wins against the line within this distance. */
const DOT_FIRST = 3;

/**
 * What the terms of a text name, of all that a figure has names for.
 * @param {ReadonlySet<string>} terms
 * @param {{[term: string]: () => Part}} named
 * @returns {Parts}
 */
export const partsOf = (terms, named) => new Map([...terms].flatMap((term) => (named[term] ? [[term, named[term]()]] : [])));

/** The strokes and the area of a part as path data. @param {Part | undefined} part */
export function pathsOf({ lines = [], dots = [], area = [] } = {}) {
  return {
    strokes: lines.map(polyline).join(""),
    dots: dots.map(dot).join(""),
    area: area.map((ring) => `${polyline(ring)}Z`).join(""),
  };
}

/**
 * The term of the part under a place.
 * @param {Parts} parts
 * @param {Point} at CSS pixels
 * @returns {string | null}
 */
export function partAt(parts, at) {
  /** @type {string | null} */
  let found = null;
  let least = REACH;
  for (const [term, { lines = [], dots = [] }] of parts) {
    const toDots = Math.min(Infinity, ...dots.map(([x, y]) => Math.hypot(x - at[0], y - at[1]))) - DOT_FIRST;
    const toLines = Math.min(Infinity, ...lines.map((line) => distance(line, at)));
    const nearest = Math.min(toDots, toLines);
    if (nearest < least) [found, least] = [term, nearest];
  }
  if (found !== null) return found;
  for (const [term, { area = [] }] of parts) {
    if (area.filter((ring) => isInside(ring, at)).length % 2 === 1) return term;
  }
  return null;
}

/** @param {Point[]} line @param {Point} at */
function distance(line, at) {
  let least = Infinity;
  for (let k = 1; k < line.length; k += 1) {
    const [a, b] = [/** @type {Point} */ (line[k - 1]), /** @type {Point} */ (line[k])];
    const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    const square = dx * dx + dy * dy;
    const t = square > 0 ? Math.min(1, Math.max(0, ((at[0] - a[0]) * dx + (at[1] - a[1]) * dy) / square)) : 0;
    least = Math.min(least, Math.hypot(a[0] + t * dx - at[0], a[1] + t * dy - at[1]));
  }
  return least;
}

/** @param {Point[]} ring @param {Point} at */
function isInside(ring, [x, y]) {
  let inside = false;
  ring.forEach(([ax, ay], k) => {
    const [bx, by] = /** @type {Point} */ (ring[(k + 1) % ring.length]);
    if (ay > y !== by > y && x < ax + ((y - ay) * (bx - ax)) / (by - ay)) inside = !inside;
  });
  return inside;
}
