/** Laplace's equation by boundary elements: the cube of the paper, sections of it, and the ring between two circles. */
import { load } from "../js/node.js";

/** @import { LaplaceInput, LaplaceSolution } from "../js/directrix.js" */

/**
 * The unit cube with m steps along each edge: 1 above, 0.5 below, 0 at the sides.
 *
 * @param {number} m
 * @returns {LaplaceInput}
 */
export function cube(m) {
  /** @type {number[]} */
  const vertices = [];
  /** @type {number[]} */
  const groups = [];
  for (let axis = 0; axis < 3; axis++) {
    for (const end of [0, 1]) {
      const place = (/** @type {number[]} */ [i, j]) => {
        const point = [0, 0, 0];
        point[axis] = end;
        point[(axis + 1) % 3] = i / m;
        point[(axis + 2) % 3] = j / m;
        return point;
      };
      for (let n = 0; n < m * m; n++) {
        const [i, j] = [n % m, Math.floor(n / m)];
        for (const half of [[[i, j], [i + 1, j], [i + 1, j + 1]], [[i, j], [i + 1, j + 1], [i, j + 1]]]) {
          vertices.push(...(end ? half : half.toReversed()).flatMap(place));
          groups.push(axis === 2 ? 1 + end : 0);
        }
      }
    }
  }
  const elements = Uint32Array.from({ length: vertices.length / 3 }, (_, n) => n);
  return { dimension: 3, vertices, elements, conditions: [{ value: 0 }, { value: 0.5 }, { value: 1 }], groups };
}

/**
 * A ring: two circles of `count` segments each.
 *
 * @param {number} count
 * @returns {LaplaceInput}
 */
function ring(count) {
  const points = [1, 0.4].flatMap((radius, k) =>
    Array.from({ length: count }, (_, n) => [radius * Math.cos((2 * Math.PI * n) / count), (k ? -radius : radius) * Math.sin((2 * Math.PI * n) / count)]),
  );
  const elements = points.flatMap((_, n) => [n, n - (n % count) + ((n + 1) % count)]);
  return { dimension: 2, vertices: points.flat(), elements, conditions: [{ value: 0 }, { value: 1 }], groups: points.map((_, n) => Number(n >= count)) };
}

/** @param {number} m @param {LaplaceInput["solver"]} [solver] */
const solve = (m, solver) => async () => {
  const dx = await load({ module: "full" });
  const input = { ...cube(m), solver };
  return () => dx.solveLaplace(input);
};

/** @param {LaplaceInput} input @param {(solution: LaplaceSolution) => unknown} show */
const shown = (input, show) => async () => {
  const solution = (await load({ module: "full" })).solveLaplace(input);
  return () => show(solution);
};

/** The longest turn of a solution over a connection. @param {number} m @param {LaplaceInput["solver"]} [solver] */
const turns = (m, solver) => async () => {
  const dx = await load({ module: "full" });
  const input = { ...cube(m), solver };
  return function* () {
    const job = dx.job(null, { solveLaplace: input });
    while (!job.step(12).done) yield;
  };
};

/** @type {[number[], number[]]} */
const sides = [[1, 0, 0], [0, 0, 1]];

/** @type {import("../scripts/lib/bench.mjs").Case[]} */
export default [
  { name: "Laplace, cube of 972 triangles", budget: 60, prepare: solve(9) },
  { name: "Laplace, cube of 972 triangles, by LU", prepare: solve(9, { method: "lu" }) },
  { name: "Laplace, cube of 3 888 triangles", budget: 800, prepare: solve(18) },
  { name: "Laplace, cube of 3 888 triangles, without a matrix", prepare: solve(18, { dense: 0 }) },
  { name: "Laplace, section 256 x 256 of 972 triangles", budget: 300, prepare: shown(cube(9), (s) => s.section({ origin: [0, 0.5, 0], sides, size: [256, 256] })) },
  { name: "Laplace, two circles of 200 segments", prepare: async () => {
    const dx = await load({ module: "full" });
    return () => dx.solveLaplace(ring(200));
  } },
  { name: "Laplace, 512 x 512 between two circles", prepare: shown(ring(200), (s) => s.section({ longest: 512 })) },
  { name: "Laplace, cube of 3 888 triangles, longest call", budget: 50, prepare: turns(18) },
  { name: "Laplace, cube of 15 552 triangles, without a matrix", budget: 15_000, prepare: solve(36) },
];
