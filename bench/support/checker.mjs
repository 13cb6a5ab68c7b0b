/**
 * A slow check of lines between two closed curves: plain geometry on whole lists, without lifts, grids or exact predicates,
 * and nothing of the kernels.
 */

/**
 * @import { CurvesDocument, Point } from "../../js/directrix.js"
 * @import { ClosedCurve, End } from "./curve.mjs"
 *
 * @typedef {object} Weights
 * @property {number} normal exponent of the product of the normals
 * @property {number} distance exponent of the length
 * @property {number} [gap] distance between the planes of the curves, which counts in the length
 *
 * @typedef {[number, number]} Place shares of arc length on both curves; along a list they may go beyond 1
 */

/** Places, at least, at which J is taken. */
const midpoints = 8000;
/** Places on each curve at which the bound of J is taken. */
const boundPlaces = 400;
/** Partners that are looked at for each of them, before the best is refined. */
const boundPartners = 400;

/**
 * The weights of a document in which negative products count as they are.
 *
 * @param {CurvesDocument} document
 * @returns {Weights}
 */
export function weightsOf({ matching, curves }) {
  const isPlain = (matching.negative ?? "signed") === "signed" && !matching.alignmentWeight && !matching.printed?.length;
  if (!isPlain) throw new Error("the checker knows plain values alone");
  const [first, second] = curves.map(({ height = 0 }) => height);
  return { normal: matching.normalWeight ?? 1, distance: matching.distanceWeight ?? 2, gap: second - first };
}

/**
 * Value f of a line.
 *
 * @param {End} p
 * @param {End} q
 * @param {Weights} weights
 */
export function value(p, q, { normal, distance, gap = 0 }) {
  const c = p.normal[0] * q.normal[0] + p.normal[1] * q.normal[1];
  const d = Math.hypot(q.point[0] - p.point[0], q.point[1] - p.point[1], gap);
  return (normal === 0 ? 1 : Math.sign(c) * Math.abs(c) ** normal) / d ** distance;
}

/**
 * Whether two segments pass through each other: the ends of either lie on both sides of the other, by more than a hair.
 *
 * @param {[Point, Point]} one
 * @param {[Point, Point]} other
 * @param {number} hair
 */
function pass([a, b], [c, d], hair) {
  return isParted(a, b, c, d, hair) && isParted(c, d, a, b, hair);
}

/** @param {Point} a @param {Point} b @param {Point} c @param {Point} d @param {number} hair */
function isParted(a, b, c, d, hair) {
  const [s, t] = [distanceFrom(a, b, c), distanceFrom(a, b, d)];
  return Math.min(s, t) < -hair && Math.max(s, t) > hair;
}

/** Signed distance of a point from the line through two others. @param {Point} a @param {Point} b @param {Point} p */
function distanceFrom(a, b, p) {
  const [x, y] = [b[0] - a[0], b[1] - a[1]];
  return (x * (p[1] - a[1]) - y * (p[0] - a[0])) / Math.hypot(x, y);
}

/**
 * Whether a closed polygon passes from one side of a segment to the other, by more than a hair on both. What happens within a
 * hair of the ends of the segment does not count: they lie on the polygons themselves.
 *
 * @param {[Point, Point]} segment
 * @param {Point[]} polygon
 * @param {number} hair
 */
export function isCut([a, b], polygon, hair) {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const [dx, dy] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
  const [first, last] = [hair, length - hair];
  // On which side the polygon was last seen, if it has been beside the segment ever since.
  let side = 0;
  let [along, off] = [0, 0];
  // A second lap, for what passes through the first vertex.
  for (let k = 0; k <= 2 * polygon.length; k++) {
    const point = polygon[k % polygon.length];
    const alongBefore = along;
    const offBefore = off;
    along = dx * (point[0] - a[0]) + dy * (point[1] - a[1]);
    off = dx * (point[1] - a[1]) - dy * (point[0] - a[0]);
    if (k === 0) continue;
    if (k > polygon.length && side === 0) return false;
    if ((along <= first && alongBefore <= first) || (along >= last && alongBefore >= last)) {
      side = 0;
      continue;
    }
    // The part of the edge that is beside the segment.
    const [s, t] = [(first - alongBefore) / (along - alongBefore), (last - alongBefore) / (along - alongBefore)];
    const isWhole = along > first && along < last && alongBefore > first && alongBefore < last;
    const from = isWhole ? 0 : Math.max(0, Math.min(s, t));
    const to = isWhole ? 1 : Math.min(1, Math.max(s, t));
    if (from > 0) side = 0;
    const start = offBefore + from * (off - offBefore);
    const end = offBefore + to * (off - offBefore);
    if (Math.abs(start) > hair) {
      if (side * start < 0) return true;
      side = Math.sign(start);
    }
    if (Math.abs(end) > hair) {
      if (side * end < 0) return true;
      side = Math.sign(end);
    }
    if (to < 1) side = 0;
  }
  return false;
}

/**
 * Pairs of lines that cross, and lines that pass through a polygon.
 *
 * @param {[Point, Point][]} segments
 * @param {Point[][]} polygons
 * @param {number} hair what is no deeper does not count
 * @returns {{crossed: [number, number][], blocked: number[]}}
 */
export function faults(segments, polygons, hair) {
  /** @type {[number, number][]} */
  const crossed = [];
  for (let i = 0; i < segments.length; i++) {
    for (let k = i + 1; k < segments.length; k++) if (pass(segments[i], segments[k], hair)) crossed.push([i, k]);
  }
  const indices = segments.map((_, k) => k);
  return { crossed, blocked: indices.filter((k) => polygons.some((polygon) => isCut(segments[k], polygon, hair))) };
}

/**
 * J of a closed correspondence that is linear in arc length from each place to the next: the mean of f over both curves, by
 * midpoints.
 *
 * @param {[ClosedCurve, ClosedCurve]} curves
 * @param {Place[]} places in cyclic order
 * @param {Weights} weights
 */
export function integral(curves, places, weights) {
  const parts = Math.max(8, Math.ceil(midpoints / places.length));
  const turn = (/** @type {number} */ x) => x - Math.floor(x);
  return places.reduce((sum, [x, y], k) => {
    const [toX, toY] = places[(k + 1) % places.length];
    const isLast = k + 1 === places.length;
    // From the last place to the first a lap is completed.
    const [dx, dy] = isLast ? [turn(toX - x), turn(toY - y)] : [toX - x, toY - y];
    let own = 0;
    for (let i = 0; i < parts; i++) {
      const t = (i + 0.5) / parts;
      own += value(curves[0].at(x + t * dx), curves[1].at(y + t * dy), weights);
    }
    return sum + ((dx + dy) / 2) * (own / parts);
  }, 0);
}

/**
 * An upper bound of J: every place of either curve with the best partner that it sees.
 *
 * @param {[ClosedCurve, ClosedCurve]} curves
 * @param {Weights} weights
 * @param {number} hair
 */
export function bound(curves, weights, hair) {
  const polygons = curves.map((curve) => curve.polygon);
  return [0, 1].reduce((sum, axis) => {
    const partners = Array.from({ length: boundPartners }, (_, k) => curves[1 - axis].at(k / boundPartners));
    for (let i = 0; i < boundPlaces; i++) {
      const here = curves[axis].at((i + 0.5) / boundPlaces);
      const rated = partners.map((partner, k) => ({ k, f: value(here, partner, weights) })).sort((a, b) => b.f - a.f);
      const sees = (/** @type {{k: number}} */ { k }) =>
        !polygons.some((polygon) => isCut([here.point, partners[k].point], polygon, hair));
      const best = rated.find(sees);
      if (best) {
        const refined = top((share) => value(here, curves[1 - axis].at(share), weights), best.k / boundPartners, 1 / boundPartners);
        sum += Math.max(best.f, refined) / boundPlaces / 2;
      }
    }
    return sum;
  }, 0);
}

/**
 * The greatest value of a function near a place, by golden sections.
 *
 * @param {(x: number) => number} f
 * @param {number} at
 * @param {number} width
 */
function top(f, at, width) {
  const golden = (Math.sqrt(5) - 1) / 2;
  let [low, high] = [at - width, at + width];
  for (let k = 0; k < 30; k++) {
    const [a, b] = [high - golden * (high - low), low + golden * (high - low)];
    if (f(a) > f(b)) high = b;
    else low = a;
  }
  return f((low + high) / 2);
}
