/**
 * How far a solution is from the exact one, where that is known: at the places of a lattice that are not next to the boundary.
 *
 * @import { RemoteLaplaceSolution } from "../../../js/directrix.js"
 * @import { Kernel } from "../types.js"
 * @import { Bounds } from "../space/vector.js"
 * @import { Boundary, LaboratoryDocument } from "./document.js"
 * @import { Accuracy } from "./state.js"
 *
 * @typedef {{signal?: AbortSignal}} Control
 */

/** Places along the longest side of the box, in the plane and in space. */
const ALONG = { 2: 44, 3: 15 };

/**
 * The middles of the cells of a lattice over a box.
 * @param {2 | 3} dimension
 * @param {Bounds} bounds
 * @param {number} [along] cells along the longest side
 * @returns {{points: Float64Array, size: number[]}} points one after the other, the first coordinate the fastest
 */
export function lattice(dimension, { min, max }, along = ALONG[dimension]) {
  const axes = Array.from({ length: dimension }, (_, axis) => axis);
  const spans = axes.map((axis) => max[axis] - min[axis]);
  const step = Math.max(...spans) / along;
  const size = spans.map((span) => Math.max(3, Math.round(span / step)));
  const count = size.reduce((all, each) => all * each, 1);
  const points = new Float64Array(dimension * count);
  for (let n = 0; n < count; n += 1) {
    let rest = n;
    for (const axis of axes) {
      points[dimension * n + axis] = min[axis] + ((rest % size[axis]) + 0.5) * (spans[axis] / size[axis]);
      rest = Math.floor(rest / size[axis]);
    }
  }
  return { points, size };
}

/**
 * The places whose neighbours along every axis and every diagonal are inside as well: about a cell away from the boundary.
 * @param {number[]} size
 * @param {(n: number) => boolean} isInside
 * @returns {number[]} their numbers
 */
export function innerOf(size, isInside) {
  const count = size.reduce((all, each) => all * each, 1);
  /** @type {number[]} */
  const strides = size.map((_, axis) => size.slice(0, axis).reduce((all, each) => all * each, 1));
  const steps = size.reduce((all, _, axis) => all.flatMap((by) => [-1, 0, 1].map((k) => [...by, k * strides[axis]])), /** @type {number[][]} */ ([[]]));
  const found = [];
  for (let n = 0; n < count; n += 1) {
    const isAtEdge = size.some((each, axis) => {
      const k = Math.floor(n / strides[axis]) % each;
      return k === 0 || k === each - 1;
    });
    if (!isAtEdge && steps.every((by) => isInside(n + by.reduce((sum, each) => sum + each, 0)))) found.push(n);
  }
  return found;
}

/**
 * @param {Kernel} kernel
 * @param {LaboratoryDocument} document
 * @param {Boundary} boundary
 * @param {Bounds} bounds
 * @param {RemoteLaplaceSolution} solution
 * @param {Control} control
 * @returns {Promise<Accuracy | null>} null where no exact solution is known
 */
export async function accuracyOf(kernel, document, boundary, bounds, solution, control) {
  if (boundary.exact === null) return null;
  const { dimension } = boundary;
  const { points, size } = lattice(dimension, bounds);
  const { values } = await solution.at(points, { outside: "skip" }, control);
  const { materials } = solution;
  const inner = innerOf(size, (n) => !Number.isNaN(values[materials * n]));
  if (inner.length === 0) return null;
  const places = Float64Array.from(inner.flatMap((n) => [...points.subarray(dimension * n, dimension * (n + 1))]));
  const exact = await kernel.exact(/** @type {any} */ (document), places);
  /** @type {Accuracy} */
  const found = { error: 0, at: [...places.subarray(0, dimension)], points: inner.length };
  inner.forEach((n, k) => {
    for (let material = 0; material < materials; material += 1) {
      const error = Math.abs(values[materials * n + material] - exact[materials * k + material]);
      if (error > found.error) Object.assign(found, { error, at: [...places.subarray(dimension * k, dimension * (k + 1))] });
    }
  });
  return found;
}
