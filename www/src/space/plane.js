/**
 * Planes that cut a body: what is kept lies on the side that the normal points to.
 *
 * @import { Vector } from "./vector.js"
 *
 * @typedef {object} Plane
 * @property {Vector} normal of length 1
 * @property {number} offset the scalar product of the normal with every point of the plane
 */
import { dot } from "./vector.js";

/** @param {Plane[]} planes @param {readonly number[]} point */
export const isKept = (planes, point) => planes.every(({ normal, offset }) => dot(normal, point) >= offset);

/**
 * Least and greatest offset of planes with a normal that touch some points.
 * @param {Vector} normal
 * @param {ArrayLike<number>} positions three numbers a point
 * @returns {[number, number]}
 */
export function extentAlong(normal, positions) {
  let [low, high] = [Infinity, -Infinity];
  for (let k = 0; k < positions.length; k += 3) {
    const offset = normal[0] * positions[k] + normal[1] * positions[k + 1] + normal[2] * positions[k + 2];
    if (offset < low) low = offset;
    if (offset > high) high = offset;
  }
  return [low, high];
}

/**
 * The line in which a plane cuts a mesh, as separate segments.
 * @param {{positions: Float32Array, indices: Uint32Array}} mesh
 * @param {Plane} plane
 * @param {ArrayLike<number>} values three numbers a vertex, taken along, such as colours
 * @param {number} [end] indices from here on are left out
 * @returns {{positions: number[], values: number[]}} six numbers a segment
 */
export function cutOf({ positions, indices }, { normal, offset }, values, end = indices.length) {
  /** @type {{positions: number[], values: number[]}} */
  const found = { positions: [], values: [] };
  const height = new Float64Array(positions.length / 3);
  for (let i = 0; i < height.length; i += 1) {
    height[i] = normal[0] * positions[3 * i] + normal[1] * positions[3 * i + 1] + normal[2] * positions[3 * i + 2] - offset;
  }
  for (let k = 0; k < end; k += 3) {
    const corners = [indices[k], indices[k + 1], indices[k + 2]];
    // A corner in the plane itself counts as above, so that an edge is never cut twice or not at all.
    const above = corners.map((corner) => height[corner] >= 0);
    if (above[0] === above[1] && above[1] === above[2]) continue;
    for (let edge = 0; edge < 3; edge += 1) {
      if (above[edge] === above[(edge + 1) % 3]) continue;
      // Both triangles of an edge have to find the same point, so it is always cut from its lower index.
      const [a, b] = [corners[edge], corners[(edge + 1) % 3]].sort((i, j) => i - j);
      const t = height[a] / (height[a] - height[b]);
      for (let axis = 0; axis < 3; axis += 1) {
        found.positions.push(positions[3 * a + axis] + t * (positions[3 * b + axis] - positions[3 * a + axis]));
        found.values.push(values[3 * a + axis] + t * (values[3 * b + axis] - values[3 * a + axis]));
      }
    }
  }
  return found;
}
