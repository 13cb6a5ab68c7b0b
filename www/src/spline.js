/**
 * Places on a curve for the pointer: where its outline runs on the screen and which parameter lies under a double
 * click. What the page shows as a result always comes from the kernel.
 *
 * @import { Curve, Point, Shape } from "./types.js"
 */
import { seen } from "./state/in-space.js";

/** Chords of one knot span, unless asked otherwise. At 14 spans the outline is within a pixel of the curve. */
const CHORDS = 12;
/** Part of the domain to either side over which a tangent is taken. */
const NEAR = 1e-4;

/** @param {Shape | undefined} curve */
export const isOpen = (curve) => curve?.form === "open";

/** How the path of an outline ends. @param {Shape} curve */
export const ending = (curve) => (isOpen(curve) ? "" : "Z");

/**
 * The full knot vector with the control points it belongs to, as they are seen, repeated for a periodic curve.
 * @param {Shape} curve
 * @returns {{knots: number[], points: Point[]}}
 */
export function unrolled(curve) {
  const { degree: p, form } = curve;
  const { points } = seen(curve);
  const n = points.length;
  if (form !== "periodic") {
    const knots = curve.knots ?? Array.from({ length: n + p + 1 }, (_, i) => clampedKnot(i, n, p));
    return { knots, points };
  }
  const wrapped = Array.from({ length: n + p }, (_, i) => /** @type {Point} */ (points[i % n]));
  if (curve.knots && curve.knots.length === n + 2 * p + 1) return { knots: curve.knots, points: wrapped };
  const domain = curve.knots ?? Array.from({ length: n + 1 }, (_, i) => i / n);
  const first = /** @type {number} */ (domain[0]);
  const period = /** @type {number} */ (domain[n]) - first;
  const knots = Array.from({ length: n + 2 * p + 1 }, (_, i) => {
    const turn = Math.floor((i - p) / n);
    return /** @type {number} */ (domain[i - p - turn * n]) + turn * period;
  });
  return { knots, points: wrapped };
}

/**
 * @param {number} i
 * @param {number} n
 * @param {number} p
 */
function clampedKnot(i, n, p) {
  return Math.min(Math.max(i - p, 0), n - p) / (n - p);
}

/** Outlines that were asked for: a curve is never changed in place. @type {WeakMap<Shape, {u: number, at: Point}[]>} */
const outlines = new WeakMap();

/**
 * The outline as a chain of chords with the parameter of every vertex, the seam of a closed curve at both ends.
 * @param {Shape} shape
 * @param {number} [chords] of one knot span
 * @returns {{u: number, at: Point}[]}
 */
export function outline(shape, chords = CHORDS) {
  const curve = seen(shape);
  if (chords !== CHORDS) return trace(curve, chords);
  const known = outlines.get(curve) ?? trace(curve, chords);
  outlines.set(curve, known);
  return known;
}

/**
 * @param {Shape} curve
 * @param {number} chords
 * @returns {{u: number, at: Point}[]}
 */
function trace(curve, chords) {
  const { knots, points } = unrolled(curve);
  const p = curve.degree;
  /** @type {{u: number, at: Point}[]} */
  const chain = [];
  for (let span = p; span < points.length; span += 1) {
    const a = /** @type {number} */ (knots[span]);
    const b = /** @type {number} */ (knots[span + 1]);
    if (!(b > a)) continue;
    for (let i = chain.length === 0 ? 0 : 1; i <= chords; i += 1) {
      const u = a + ((b - a) * i) / chords;
      chain.push({ u, at: deBoor(knots, points, p, span, u) });
    }
  }
  return chain;
}

/**
 * A place on a curve by its fraction of the knot domain, and the unit normal there, outward or to the right of an open curve; at a corner
 * the normal bisects.
 * @param {Curve} curve
 * @param {number} fraction
 * @returns {{at: Point, normal: Point}}
 */
export function placeOn(curve, fraction) {
  const [before, at, after] = [-NEAR, 0, NEAR].map((by) => pointAt(curve, fraction + by));
  const [dx, dy] = [after[0] - before[0], after[1] - before[1]];
  const length = Math.hypot(dx, dy) || 1;
  const side = !isOpen(curve) && signedArea(outline(curve).map((vertex) => vertex.at)) < 0 ? -1 : 1;
  return { at, normal: [(side * dy) / length, (-side * dx) / length] };
}

/**
 * The fraction of the knot domain of the place on the outline nearest to a point.
 * @param {Curve} curve
 * @param {Point} target
 */
export function nearestFraction(curve, target) {
  const { knots, points } = unrolled(curve);
  const [low, high] = [knots[curve.degree], knots[points.length]];
  return (nearestParameter(curve, target) - low) / (high - low);
}

/**
 * Twice the area of a polygon, positive when it turns counter-clockwise.
 * @param {Point[]} polygon
 */
export function signedArea(polygon) {
  let area = 0;
  polygon.forEach(([x, y], i) => {
    const [nextX, nextY] = polygon[(i + 1) % polygon.length];
    area += x * nextY - y * nextX;
  });
  return area;
}

/**
 * @param {Curve} curve
 * @param {number} fraction of the knot domain, past either end round the seam, or on an open curve at the end
 * @returns {Point}
 */
function pointAt(curve, fraction) {
  const { knots, points } = unrolled(curve);
  const p = curve.degree;
  const [low, high] = [knots[p], knots[points.length]];
  const inside = isOpen(curve) ? Math.min(1, Math.max(0, fraction)) : fraction - Math.floor(fraction);
  const u = low + inside * (high - low);
  let span = p;
  while (span < points.length - 1 && knots[span + 1] <= u) span += 1;
  return deBoor(knots, points, p, span, u);
}

/**
 * De Boor's recursion on one span.
 * @param {number[]} knots
 * @param {Point[]} points
 * @param {number} p
 * @param {number} span
 * @param {number} u
 * @returns {Point}
 */
function deBoor(knots, points, p, span, u) {
  const d = points.slice(span - p, span + 1).map(([x, y]) => /** @type {Point} */ ([x, y]));
  for (let level = 1; level <= p; level += 1) {
    for (let j = p; j >= level; j -= 1) {
      const low = /** @type {number} */ (knots[span - p + j]);
      const high = /** @type {number} */ (knots[span + 1 + j - level]);
      const t = high > low ? (u - low) / (high - low) : 0;
      const from = /** @type {Point} */ (d[j - 1]);
      const to = /** @type {Point} */ (d[j]);
      d[j] = [from[0] + (to[0] - from[0]) * t, from[1] + (to[1] - from[1]) * t];
    }
  }
  return /** @type {Point} */ (d[p]);
}

/**
 * The parameter of the place on the outline nearest to a point.
 * @param {Curve} curve
 * @param {Point} target
 */
export function nearestParameter(curve, target) {
  const chain = outline(curve);
  let best = { distance: Infinity, u: 0 };
  for (let i = 1; i < chain.length; i += 1) {
    const a = /** @type {{u: number, at: Point}} */ (chain[i - 1]);
    const b = /** @type {{u: number, at: Point}} */ (chain[i]);
    const [dx, dy] = [b.at[0] - a.at[0], b.at[1] - a.at[1]];
    const length = dx * dx + dy * dy;
    const along = length > 0 ? ((target[0] - a.at[0]) * dx + (target[1] - a.at[1]) * dy) / length : 0;
    const t = Math.min(1, Math.max(0, along));
    const distance = Math.hypot(a.at[0] + dx * t - target[0], a.at[1] + dy * t - target[1]);
    if (distance < best.distance) best = { distance, u: a.u + (b.u - a.u) * t };
  }
  return best.u;
}

/**
 * The explicit knots left when a control point goes: the knot nearest to the middle of the point's support is taken
 * out. Undefined when the curve has uniform knots of its own accord.
 * @param {Curve} curve
 * @param {number} point
 * @returns {number[] | undefined}
 */
export function dropKnot(curve, point) {
  if (!curve.knots) return undefined;
  const { knots } = unrolled(curve);
  const { degree: p, form } = curve;
  const n = curve.points.length;
  let middle = 0;
  for (let i = 1; i <= p; i += 1) middle += /** @type {number} */ (knots[point + i]) / p;
  if (form !== "periodic") {
    const inner = nearestIndex(knots.slice(p + 1, n), middle);
    return knots.filter((_, i) => i !== p + 1 + inner);
  }
  const domain = knots.slice(p, n + p + 1);
  const first = /** @type {number} */ (domain[0]);
  const period = /** @type {number} */ (domain[n]) - first;
  const wrapped = first + ((((middle - first) % period) + period) % period);
  const inner = nearestIndex(domain.slice(1, n), wrapped);
  return domain.filter((_, i) => i !== 1 + inner);
}

/**
 * @param {number[]} values
 * @param {number} target
 */
function nearestIndex(values, target) {
  let best = 0;
  values.forEach((value, i) => {
    if (Math.abs(value - target) < Math.abs(/** @type {number} */ (values[best]) - target)) best = i;
  });
  return best;
}
