/**
 * The level curves and the lines along the gradient of the blend that is looked at, fetched once for a document.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Point } from "../types.js"
 * @import { Harmonic } from "../../../js/directrix.js"
 */
import { lookedAt } from "../state/look.js";

/** @type {WeakMap<CurvesDocument, Promise<Harmonic>>} */
const known = new WeakMap();

/** Halvings in which the place of a level on a line is found, and how near to its ends the band is asked. */
const HALVINGS = 12;
const NEAR = 1e-3;

/**
 * @param {App} app
 * @param {CurvesDocument} [document]
 * @returns {Promise<Harmonic>}
 */
export function blendOf(app, document = lookedAt(app)) {
  const found = known.get(document) ?? app.kernel.harmonic(document);
  known.set(document, found);
  found.catch(() => known.delete(document));
  return found;
}

/** The points of a list of coordinates. @param {Float64Array} flat @returns {Point[]} */
export const pointsOf = (flat) => Array.from({ length: flat.length / 2 }, (_, k) => [flat[2 * k], flat[2 * k + 1]]);

/**
 * The place at a share of the length of a chain.
 * @param {readonly Point[]} chain
 * @param {number} share 0 to 1
 * @returns {Point}
 */
export function along(chain, share) {
  const lengths = chain.slice(1).map(([x, y], k) => Math.hypot(x - chain[k][0], y - chain[k][1]));
  let rest = share * lengths.reduce((sum, length) => sum + length, 0);
  for (const [k, length] of lengths.entries()) {
    if (rest <= length && length > 0) {
      const [[ax, ay], [bx, by]] = [chain[k], chain[k + 1]];
      return [ax + ((bx - ax) * rest) / length, ay + ((by - ay) * rest) / length];
    }
    rest -= length;
  }
  return chain[chain.length - 1];
}

/**
 * What the blend holds on a line along the gradient, at a potential: it rises along the line, so that halving finds the place.
 * @param {App} app
 * @param {number} line
 * @param {number} s
 */
export async function readLine(app, line, s) {
  const document = lookedAt(app);
  const { lines } = await blendOf(app, document);
  if (!lines[line]) return null;
  const chain = pointsOf(lines[line]);
  let [low, high] = [NEAR, 1 - NEAR];
  let found = null;
  for (let turn = 0; turn < HALVINGS; turn += 1) {
    const middle = (low + high) / 2;
    const here = await app.kernel.probe(document, along(chain, middle));
    if (!here) break;
    found = here;
    if (here.s < s) low = middle;
    else high = middle;
  }
  return found && lookedAt(app) === document ? { ...found, line } : null;
}
