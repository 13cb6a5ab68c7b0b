/**
 * The first triangle of a mesh that a ray meets (Moeller and Trumbore, Fast, minimum storage ray/triangle intersection, 1997).
 *
 * @import { Vector } from "./vector.js"
 * @import { Plane } from "./plane.js"
 *
 * @typedef {object} Hit
 * @property {number} triangle index of the triangle
 * @property {Vector} weights of its three corners, with the sum 1
 * @property {Vector} point
 * @property {number} distance in lengths of the ray's direction
 * @property {boolean} isFront whether the ray comes from outside
 */
import { add, cross, dot, scaled, subtract } from "./vector.js";
import { isKept } from "./plane.js";

/**
 * @param {{positions: Float32Array, indices: Uint32Array}} mesh
 * @param {{from: Vector, along: Vector}} ray
 * @param {Plane[]} [planes] what they take away is not met
 * @param {(triangle: number, point: Vector) => boolean} [isShown]
 * @returns {Hit | null}
 */
export function firstHit({ positions, indices }, { from, along }, planes = [], isShown = () => true) {
  /** @type {Hit | null} */
  let first = null;
  for (let k = 0; k < indices.length; k += 3) {
    const [a, b, c] = [indices[k] * 3, indices[k + 1] * 3, indices[k + 2] * 3];
    const [ax, ay, az] = [positions[a], positions[a + 1], positions[a + 2]];
    const e = [positions[b] - ax, positions[b + 1] - ay, positions[b + 2] - az];
    const f = [positions[c] - ax, positions[c + 1] - ay, positions[c + 2] - az];
    const p = cross(along, f);
    const determinant = dot(e, p);
    if (determinant === 0) continue;
    const t = subtract(from, [ax, ay, az]);
    const v = dot(t, p) / determinant;
    if (v < 0 || v > 1) continue;
    const q = cross(t, e);
    const w = dot(along, q) / determinant;
    if (w < 0 || v + w > 1) continue;
    const distance = dot(f, q) / determinant;
    if (distance <= 0 || (first && distance >= first.distance)) continue;
    const point = add(from, scaled(along, distance));
    if (!isShown(k / 3, point) || !isKept(planes, point)) continue;
    first = { triangle: k / 3, weights: [1 - v - w, v, w], point, distance, isFront: determinant > 0 };
  }
  return first;
}
