/** Points between the module, which takes and gives flat arrays, and the world, where a point is a pair. */
import { DirectrixError } from "./errors.js";

/**
 * @param {unknown} points pairs of numbers
 * @returns {Float64Array}
 * @throws {DirectrixError} with code `type` or `non-finite` and the path of the value
 */
export function flatPoints(points) {
  if (!Array.isArray(points)) {
    throw new DirectrixError("type", "points", `${String(points)} was found; expected a list of pairs`);
  }
  const flat = new Float64Array(points.length * 2);
  points.forEach((point, i) => {
    const isPair = Array.isArray(point) && point.length === 2;
    if (!isPair) throw new DirectrixError("type", `points[${i}]`, `${String(point)} was found; expected two numbers`);
    for (const k of [0, 1]) {
      const value = point[k];
      const path = `points[${i}][${k}]`;
      if (typeof value !== "number") throw new DirectrixError("type", path, `${String(value)} was found; expected a number`);
      if (!Number.isFinite(value)) throw new DirectrixError("non-finite", path, `${value} was found; expected a finite number`);
      flat[2 * i + k] = value;
    }
  });
  return flat;
}

/**
 * The shapes that the module read, with pairs for points.
 *
 * @param {any} found
 * @returns {import("./directrix.js").ShapeList}
 */
export function shapesOf({ shapes, skipped }) {
  const pairs = (/** @type {Float64Array} */ flat) => {
    /** @type {import("./directrix.js").Point[]} */
    const points = new Array(flat.length / 2);
    for (let i = 0; i < points.length; i++) points[i] = [flat[2 * i], flat[2 * i + 1]];
    return points;
  };
  const shape = (/** @type {any} */ { points, corners, ...rest }) => ({ ...rest, points: pairs(points), corners: [...corners] });
  return { shapes: shapes.map(shape), skipped };
}
