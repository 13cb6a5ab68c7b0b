/**
 * The surface of a body brought up to date in place.
 *
 * @import { BodySurface, SurfaceRanges } from "./directrix.js"
 */

/**
 * Puts what `surface({ since: surface.id })` brought into the arrays of the surface it was asked of, and says which places have new values. The
 * surface has the number of the new one afterwards. A whole surface, which comes where that one is not known any more or the body has other
 * faces, has no places there: it takes the place of the other one, and the result is null.
 *
 * @param {BodySurface} surface
 * @param {BodySurface} change
 * @returns {SurfaceRanges | null}
 */
export function renewSurface(surface, change) {
  if (change.since !== surface.id) return null;
  const materials = surface.fractions.length / Math.max(1, surface.cells.length);
  /** @type {SurfaceRanges} */
  const ranges = { vertices: [], indices: [], edges: [] };
  let [vertex, index, point] = [0, 0, 0];
  for (const { vertexStart, vertexCount, start, count } of change.patches) {
    const put = (/** @type {"positions" | "normals" | "parameters" | "fractions" | "colors" | "cells"} */ name, /** @type {number} */ width) =>
      surface[name].set(/** @type {any} */ (change[name].subarray(width * vertex, width * (vertex + vertexCount))), width * vertexStart);
    put("positions", 3);
    put("normals", 3);
    put("parameters", 3);
    put("fractions", materials);
    put("colors", 4);
    put("cells", 1);
    surface.indices.set(change.indices.subarray(index, index + count), start);
    ranges.vertices.push([vertexStart, vertexCount]);
    ranges.indices.push([start, count]);
    vertex += vertexCount;
    index += count;
  }
  for (const { start, count } of change.edges) {
    surface.edgePositions.set(change.edgePositions.subarray(3 * point, 3 * (point + count)), 3 * start);
    ranges.edges.push([start, count]);
    point += count;
  }
  for (const corner of change.corners) surface.corners[corner.index] = corner;
  surface.deviation = change.deviation;
  surface.id = change.id;
  return ranges;
}
