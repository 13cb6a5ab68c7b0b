/**
 * What stands at a place of the solid: the fractions, the share of the way between the curves, the angle that is shown.
 *
 * @import { Solid } from "../../../js/directrix.js"
 * @import { Plane } from "../space/plane.js"
 * @import { Vector } from "../space/vector.js"
 *
 * @typedef {object} SolidReading
 * @property {Vector} point
 * @property {number[]} fractions
 * @property {number | null} s null off the ruled surface, and where curves are not flat
 * @property {number | null} scalar degrees
 * @property {number | null} cap the curve that the cap closes
 */
import { firstHit } from "../space/pick.js";
import { levelsOf, shareAt } from "./state.js";

/**
 * @param {Solid} solid
 * @param {{from: Vector, along: Vector}} ray
 * @param {object} shown
 * @param {Plane[]} shown.planes that cut the body
 * @param {boolean} shown.hasCaps
 * @param {boolean} shown.hasFace whether cuts have faces, of which nothing is known
 * @returns {SolidReading | "inside" | null}
 */
export function readingAt(solid, ray, { planes, hasCaps, hasFace }) {
  const groupOf = (/** @type {number} */ triangle) =>
    solid.groups.find(({ start, count }) => 3 * triangle >= start && 3 * triangle < start + count);
  const hit = firstHit(solid, ray, planes, (triangle) => hasCaps || groupOf(triangle)?.name !== "cap");
  if (!hit) return null;
  // From within, the ray has come through the face of a cut.
  if (!hit.isFront && hasFace) return "inside";
  const corners = [0, 1, 2].map((k) => solid.indices[3 * hit.triangle + k]);
  const mixed = (/** @type {(corner: number) => number} */ valueAt) => corners.reduce((sum, corner, k) => sum + hit.weights[k] * valueAt(corner), 0);
  const materials = Math.round(solid.fractions.length / (solid.positions.length / 3));
  const group = groupOf(hit.triangle);
  const levels = levelsOf(solid);
  const { scalar } = solid;
  return {
    point: hit.point,
    fractions: Array.from({ length: materials }, (_, i) => mixed((corner) => solid.fractions[corner * materials + i])),
    s: levels && group?.name !== "cap" ? shareAt(levels, hit.point[2]) : null,
    scalar: scalar && group?.name !== "cap" ? mixed((corner) => scalar[corner]) : null,
    cap: group?.name === "cap" ? (group.curve ?? 0) : null,
  };
}
