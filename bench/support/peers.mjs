/** Other ways to pair two closed curves, as they are found outside: what they make of the same samples. */
import flubber from "flubber";
import { polygonArea } from "./curve.mjs";

/**
 * @import { Point } from "../../js/directrix.js"
 * @import { End } from "./curve.mjs"
 * @import { Place } from "./checker.mjs"
 */

/** Samples of one counter-clockwise curve. @typedef {{shares: number[], ends: End[]}} Sampled */

/**
 * Pairs of the package `flubber`: it equalises the numbers of points and turns one ring until the squares of the distances
 * are least. Read off at both ends of its interpolation.
 *
 * @param {[Sampled, Sampled]} samples
 * @returns {Place[]}
 */
export function flubberPairs(samples) {
  const rings = samples.map(({ ends }) => ends.map(({ point }) => point));
  const at = flubber.interpolate(rings[0], rings[1], { string: false, maxSegmentLength: Infinity });
  /** @type {Point[][]} */
  const ends = [at(0), at(1)];
  // It chooses the direction, the same for both.
  if (polygonArea(ends[0]) < 0) ends.forEach((ring) => ring.reverse());
  return ascending(ends[0].map((point, k) => [shareOn(samples[0], point), shareOn(samples[1], ends[1][k])]));
}

/** Share of a point of the polygon through samples, linear between these. @param {Sampled} sampled @param {Point} point */
function shareOn({ shares, ends }, [x, y]) {
  let [least, share] = [Infinity, 0];
  ends.forEach(({ point: [ax, ay] }, k) => {
    const [bx, by] = ends[(k + 1) % ends.length].point;
    const [dx, dy] = [bx - ax, by - ay];
    const t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)));
    const distance = Math.hypot(ax + t * dx - x, ay + t * dy - y);
    if (distance < least) {
      least = distance;
      share = shares[k] + t * ((shares[k + 1] ?? shares[0] + 1) - shares[k]);
    }
  });
  return share;
}

/**
 * Dynamic time warping of the places (x, y) and the normals of samples, both curves scaled by one number so that places weigh
 * about as much as normals: for every seam on the second curve the way of least cost, and of all these the least.
 *
 * @param {[Sampled, Sampled]} samples
 * @returns {Place[]} many to many, in cyclic order
 */
export function warpedPairs(samples) {
  const [a, b] = samples.map(({ ends }) => ends.length);
  const scale = spread(samples.flatMap(({ ends }) => ends.map(({ point }) => point)));
  const features = samples.map(({ ends }) => ends.map(({ point: [x, y], normal }) => [x / scale, y / scale, ...normal]));
  const costs = new Float64Array(a * b);
  features[0].forEach((p, i) => features[1].forEach((q, j) => (costs[i * b + j] = p.reduce((sum, x, k) => sum + (x - q[k]) ** 2, 0))));

  const total = new Float64Array(a * b);
  const fill = (/** @type {number} */ seam) => {
    for (let i = 0; i < a; i++) {
      for (let j = 0; j < b; j++) {
        const at = i * b + j;
        const straight = i > 0 ? total[at - b] : Infinity;
        const beside = j > 0 ? total[at - 1] : Infinity;
        const across = i > 0 && j > 0 ? total[at - b - 1] : Infinity;
        total[at] = (at === 0 ? 0 : Math.min(straight, beside, across)) + costs[i * b + ((j + seam) % b)];
      }
    }
    return total[a * b - 1];
  };
  let [least, best] = [Infinity, 0];
  for (let seam = 0; seam < b; seam++) {
    const cost = fill(seam);
    if (cost < least) [least, best] = [cost, seam];
  }
  fill(best);

  /** @type {Place[]} */
  const places = [];
  for (let i = a - 1, j = b - 1; ; ) {
    const at = (j + best) % b;
    places.push([samples[0].shares[i], samples[1].shares[at] + Math.floor((j + best) / b)]);
    if (i === 0 && j === 0) return places.reverse();
    const ways = [
      [i - 1, j - 1],
      [i - 1, j],
      [i, j - 1],
    ].filter(([x, y]) => x >= 0 && y >= 0);
    [i, j] = ways.reduce((one, other) => (total[other[0] * b + other[1]] < total[one[0] * b + one[1]] ? other : one));
  }
}

/** Root of the mean square of the distances from their mean. @param {Point[]} points */
function spread(points) {
  const mean = [0, 1].map((axis) => points.reduce((sum, point) => sum + point[axis], 0) / points.length);
  return Math.sqrt(points.reduce((sum, [x, y]) => sum + (x - mean[0]) ** 2 + (y - mean[1]) ** 2, 0) / points.length);
}

/** Shares in cyclic order made ascending over the seams. @param {Place[]} places @returns {Place[]} */
function ascending(places) {
  const laps = [0, 0];
  return places.map((place, k) => {
    const axes = /** @type {const} */ ([0, 1]);
    if (k > 0) for (const axis of axes) if (place[axis] < places[k - 1][axis] - 1e-9) laps[axis]++;
    return [place[0] + laps[0], place[1] + laps[1]];
  });
}
