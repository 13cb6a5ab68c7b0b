/**
 * The open curve through given points: the natural cubic spline on knots that follow the square roots of the distances, as the closed one.
 *
 * @import { Point, Shape } from "../types.js"
 */
import { solveTridiagonal } from "./through.js";

/**
 * The curve passes the points in their order, from the first at 0 to the last at 1, and is straight at its ends.
 * @param {readonly Point[]} given neighbours that coincide count once
 * @returns {Shape | null} null for fewer than two points
 */
export function openCurveThrough(given) {
  const through = given.filter((point, i) => i === 0 || distance(point, given[i - 1]) > 0);
  const n = through.length;
  if (n < 2) return null;
  const [first, last] = [through[0], through[n - 1]];
  if (n === 2) {
    const between = (/** @type {number} */ t) => /** @type {Point} */ ([0, 1].map((k) => first[k] + t * (last[k] - first[k])));
    return { degree: 3, form: "open", points: [first, between(1 / 3), between(2 / 3), last] };
  }
  const steps = through.slice(1).map((point, i) => Math.sqrt(distance(point, through[i])));
  const total = steps.reduce((sum, step) => sum + step, 0);
  let sum = 0;
  const inner = steps.slice(0, -1).map((step) => (sum += step) / total);
  const knots = [0, 0, 0, 0, ...inner, 1, 1, 1, 1];
  // Beyond either end the knots stand still.
  const step = (/** @type {number} */ i) => (steps[i] ?? 0) / total;
  const natural = (/** @type {number} */ near, /** @type {number} */ far) => [near + far + near, -near];
  const [head, headNext] = natural(step(0), step(1));
  const [tail, tailNext] = natural(step(n - 2), step(n - 3));
  /** @type {[number, number, number][]} */
  const rows = [[0, head, headNext]];
  for (let j = 1; j < n - 1; j += 1) {
    const [before2, before, after, after2] = [step(j - 2), step(j - 1), step(j), step(j + 1)];
    const low = (after * after) / ((after + before) * (after + before + before2));
    const high = (before * before) / ((before + after + after2) * (before + after));
    rows.push([low, 1 - low - high, high]);
  }
  rows.push([tailNext, tail, 0]);
  const solve = (/** @type {0 | 1} */ axis) => {
    const right = through.map((point) => point[axis]);
    right[0] = (step(0) + step(1)) * first[axis];
    right[n - 1] = (step(n - 2) + step(n - 3)) * last[axis];
    return solveTridiagonal(rows, right);
  };
  const [xs, ys] = [solve(0), solve(1)];
  return { degree: 3, form: "open", points: [first, ...xs.map((x, i) => /** @type {Point} */ ([x, ys[i]])), last], knots };
}

/** @param {Point} a @param {Point} b */
const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
