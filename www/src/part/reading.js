/**
 * What is read at a place of a part.
 *
 * @import { PartPlace, PartRaster } from "../../../js/directrix.js"
 * @import { Point } from "../types.js"
 *
 * @typedef {PartPlace & {at: Point, isVoxel: boolean}} PartReading `isVoxel`: the fractions are those of the pixel of the picture, as the rule `printed` gives them
 */

/**
 * What a raster has at a place.
 * @param {PartRaster} raster
 * @param {Point} at document units
 * @returns {{body: number, fractions: number[], leaf: number} | null} null outside of it and of all bodies
 */
export function pixelAt({ size: [wide, tall], box: [[left, low], [right, high]], body, fractions, leaves }, [x, y]) {
  const column = Math.floor(((x - left) / (right - left)) * wide);
  const row = Math.floor(((high - y) / (high - low)) * tall);
  if (!(column >= 0 && column < wide && row >= 0 && row < tall)) return null;
  const n = row * wide + column;
  return body[n] === 0 ? null : { body: body[n] - 1, fractions: fractions.map((list) => list[n]), leaf: leaves[n] };
}

/**
 * The reading at a place: exact, but for fractions that need voxels, which are those of the picture.
 * @param {PartPlace | null} place
 * @param {PartRaster} raster
 * @param {Point} at
 * @returns {PartReading | null}
 */
export function readingOf(place, raster, at) {
  if (!place) return null;
  if (place.fractions) return { ...place, at, isVoxel: false };
  return { ...place, at, fractions: pixelAt(raster, at)?.fractions ?? null, isVoxel: true };
}
