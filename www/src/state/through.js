/**
 * The closed curve through given points: a periodic cubic B-spline with continuous curvature whose knots follow the
 * square roots of the distances (centripetal), which keeps it from looping between points that lie unevenly.
 *
 * @import { Point, Shape } from "../types.js"
 */

/** Fewest points a closed cubic curve is laid through; three get the points of their circle between them. */
const FEWEST = 4;
/** Three points whose triangle is flatter than this (area over longest side squared) have no useful circle. */
const FLAT = 1e-3;

/**
 * The curve passes the points in their order, the first at the start of its domain [0, 1].
 * @param {readonly Point[]} given neighbours that coincide count once
 * @returns {Shape | null} null for fewer than three points, and for three on one line
 */
export function curveThrough(given) {
  const distinct = given.filter((point, i) => distance(point, given.at(i - 1) ?? point) > 0);
  const through = distinct.length < FEWEST ? withCircle(distinct) : distinct;
  if (!through) return null;
  const n = through.length;
  const steps = through.map((point, i) => Math.sqrt(distance(point, through[(i + 1) % n])));
  const total = steps.reduce((sum, step) => sum + step, 0);
  let sum = 0;
  const knots = [0, ...steps.map((step, i) => (i === n - 1 ? 1 : (sum += step) / total))];
  return { degree: 3, form: "periodic", points: controlPoints(through, knots), knots };
}

/**
 * Control points of the periodic cubic curve that passes `through[j]` at `knots[j]`: a cyclic tridiagonal system, each
 * row the three cubic basis functions that do not vanish at a knot.
 * @param {readonly Point[]} through
 * @param {readonly number[]} knots one more than points, one period
 * @returns {Point[]}
 */
function controlPoints(through, knots) {
  const n = through.length;
  const step = (/** @type {number} */ i) => knots[((i + n) % n) + 1] - knots[(i + n) % n];
  const rows = through.map((_, j) => {
    const [before2, before, after, after2] = [step(j - 2), step(j - 1), step(j), step(j + 1)];
    const low = (after * after) / ((after + before) * (after + before + before2));
    const high = (before * before) / ((before + after + after2) * (before + after));
    return /** @type {[number, number, number]} */ ([low, 1 - low - high, high]);
  });
  const xs = solveCyclic(rows, through.map(([x]) => x));
  const ys = solveCyclic(rows, through.map(([, y]) => y));
  // Unknown j is the middle one of row j, which is control point j + 1.
  return xs.map((_, i) => [xs[(i + n - 1) % n], ys[(i + n - 1) % n]]);
}

/**
 * Solves a cyclic tridiagonal system with the correction of Sherman and Morrison for its two corners.
 * @param {readonly [number, number, number][]} rows coefficients of unknowns j - 1, j, j + 1
 * @param {readonly number[]} right
 * @returns {number[]}
 */
export function solveCyclic(rows, right) {
  const n = rows.length;
  const corner = -rows[0][1];
  const [topRight, bottomLeft] = [rows[0][0], rows[n - 1][2]];
  const inner = rows.map((row) => /** @type {[number, number, number]} */ ([...row]));
  inner[0][1] -= corner;
  inner[n - 1][1] -= (topRight * bottomLeft) / corner;
  const u = rows.map((_, i) => (i === 0 ? corner : i === n - 1 ? bottomLeft : 0));
  const y = solveTridiagonal(inner, right);
  const z = solveTridiagonal(inner, u);
  const along = (/** @type {number[]} */ v) => v[0] + (topRight / corner) * v[n - 1];
  const factor = along(y) / (1 + along(z));
  return y.map((value, i) => value - factor * z[i]);
}

/**
 * @param {readonly [number, number, number][]} rows
 * @param {readonly number[]} right
 */
export function solveTridiagonal(rows, right) {
  const n = rows.length;
  /** @type {number[]} */
  const high = [];
  /** @type {number[]} */
  const value = [];
  for (let i = 0; i < n; i += 1) {
    const [low, middle, next] = rows[i];
    const pivot = i === 0 ? middle : middle - low * high[i - 1];
    high.push(next / pivot);
    value.push((i === 0 ? right[i] : right[i] - low * value[i - 1]) / pivot);
  }
  for (let i = n - 2; i >= 0; i -= 1) value[i] -= high[i] * value[i + 1];
  return value;
}

/**
 * Three points of a circle, and the middles of the arcs between them.
 * @param {readonly Point[]} points
 * @returns {Point[] | null}
 */
function withCircle(points) {
  if (points.length < 3) return null;
  const [a, b, c] = points;
  const cross = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  const longest = Math.max(distance(a, b), distance(b, c), distance(c, a));
  if (Math.abs(cross) < 2 * FLAT * longest * longest) return null;
  const [bb, cc] = [square(b, a), square(c, a)];
  const cx = a[0] + ((c[1] - a[1]) * bb - (b[1] - a[1]) * cc) / (2 * cross);
  const cy = a[1] + ((b[0] - a[0]) * cc - (c[0] - a[0]) * bb) / (2 * cross);
  const radius = Math.hypot(a[0] - cx, a[1] - cy);
  const turn = cross > 0 ? 1 : -1;
  return points.flatMap((point, i) => {
    const from = Math.atan2(point[1] - cy, point[0] - cx);
    const next = points[(i + 1) % 3];
    const to = Math.atan2(next[1] - cy, next[0] - cx);
    const by = ((turn * (to - from)) % (2 * Math.PI) + 2 * Math.PI) % (2 * Math.PI);
    const angle = from + (turn * by) / 2;
    return [point, /** @type {Point} */ ([cx + radius * Math.cos(angle), cy + radius * Math.sin(angle)])];
  });
}

/** @param {Point} a @param {Point} b */
const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** @param {Point} a @param {Point} b */
const square = (a, b) => (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2;
