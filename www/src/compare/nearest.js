/**
 * The ruling line nearest to a point of the plane.
 *
 * @import { Point } from "../types.js"
 */

/**
 * @param {readonly {from: Point, to: Point}[]} lines
 * @param {Point} at
 * @returns {number} index of the line, -1 without lines
 */
export function nearestLine(lines, at) {
  let [best, least] = [-1, Infinity];
  lines.forEach(({ from, to }, i) => {
    const distance = squaredDistance(from, to, at);
    if (distance < least) [best, least] = [i, distance];
  });
  return best;
}

/**
 * @param {Point} from
 * @param {Point} to
 * @param {Point} at
 */
function squaredDistance([x, y], [x2, y2], at) {
  const [dx, dy] = [x2 - x, y2 - y];
  const [px, py] = [at[0] - x, at[1] - y];
  const squared = dx * dx + dy * dy;
  const share = squared > 0 ? Math.min(1, Math.max(0, (px * dx + py * dy) / squared)) : 0;
  return (px - share * dx) ** 2 + (py - share * dy) ** 2;
}
