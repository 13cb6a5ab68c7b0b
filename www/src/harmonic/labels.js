/**
 * Places for the names of the level curves: on each where one line along the gradient crosses it, the line that goes most steeply over the screen.
 *
 * @import { Point } from "../types.js"
 * @import { Harmonic } from "../../../js/directrix.js"
 */
import { pointsOf } from "./blend.js";

/**
 * @param {Harmonic} blend
 * @param {(at: Point) => Point} toScreen
 * @param {(at: Point) => boolean} isFree whether a name may stand at a place of the screen
 * @returns {{s: number, at: Point}[]} from the inner curves to the outer one, in pixels
 */
export function levelPlaces({ levels, lines }, toScreen, isFree) {
  const chains = lines.map((line) => pointsOf(line).map(toScreen));
  const rise = (/** @type {Point[]} */ chain) => {
    const [a, b] = [chain[0], chain[chain.length - 1]];
    return isFree(a) && isFree(b) ? Math.abs(a[1] - b[1]) - Math.abs(a[0] - b[0]) / 2 : -Infinity;
  };
  const chain = chains.reduce((best, other) => (rise(other) > rise(best) ? other : best), chains[0]);
  if (!chain || rise(chain) === -Infinity) return [];
  return levels.map(({ value, loops }) => ({ s: value, at: nearest(loops.flatMap((loop) => pointsOf(loop).map(toScreen)), chain) }));
}

/** The point that is nearest to a chain. @param {Point[]} points @param {Point[]} chain */
function nearest(points, chain) {
  const away = ([x, y] = /** @type {Point} */ ([0, 0])) => Math.min(...chain.map(([a, b]) => Math.hypot(a - x, b - y)));
  return points.reduce((best, other) => (away(other) < away(best) ? other : best), points[0]);
}
