/**
 * Grids of lessons: which pixels a feature has, how far they are by the transform, and how far exactly. Pure functions.
 *
 * @import { PartDocument, Point } from "../../../js/directrix.js"
 *
 * @typedef {object} Marks
 * @property {[number, number]} size pixels, in rows from the top as rasters of parts have them
 * @property {number} edge of a pixel
 * @property {readonly (readonly number[])[]} box
 * @property {Uint8Array} features
 *
 * @typedef {{worst: number, mean: number, errors: Float32Array, size: [number, number]}} Errors in edges of a pixel
 */

/** Places of a pixel along a side at which the error is measured. */
const PLACES = 5;

/**
 * The pixels of a document's box that its features meet: those that hold its points, and those that a circle runs through.
 *
 * @param {PartDocument} document
 * @param {readonly (readonly number[])[]} box
 * @param {number} pixels along the longer side
 * @returns {Marks}
 */
export function marksOf({ shapes = [] }, box, pixels) {
  const [[left, low], [right, high]] = box;
  const edge = Math.max(right - left, high - low) / pixels;
  const size = /** @type {[number, number]} */ ([Math.max(1, Math.round((right - left) / edge)), Math.max(1, Math.round((high - low) / edge))]);
  const features = new Uint8Array(size[0] * size[1]);
  for (const shape of shapes) {
    if (shape.kind === "point") {
      const [x, y] = shape.at;
      features[Math.floor((high - y) / edge) * size[0] + Math.floor((x - left) / edge)] = 1;
    } else if (shape.kind === "circle") {
      const { center, radius } = shape;
      features.forEach((_, n) => {
        const corner = [left + (n % size[0]) * edge, high - (Math.floor(n / size[0]) + 1) * edge];
        if (meets(corner, edge, center, radius)) features[n] = 1;
      });
    }
  }
  return { size, edge, box, features };
}

/** Whether a circle runs through a square. @param {number[]} corner @param {number} edge @param {readonly number[]} center @param {number} radius */
function meets(corner, edge, center, radius) {
  const along = corner.map((low, axis) => {
    const [a, b] = [low - center[axis], low + edge - center[axis]];
    return { near: a <= 0 && b >= 0 ? 0 : Math.min(Math.abs(a), Math.abs(b)), far: Math.max(Math.abs(a), Math.abs(b)) };
  });
  return Math.hypot(...along.map(({ near }) => near)) <= radius && radius <= Math.hypot(...along.map(({ far }) => far));
}

/** The pixels at which the error is measured: the centres, or places all over each. @param {Marks} marks @param {boolean} isAnywhere @returns {[number, number]} */
export const measured = ({ size }, isAnywhere) => (isAnywhere ? [PLACES * size[0], PLACES * size[1]] : size);

/**
 * How far digital distances are off, in edges of a pixel. Exact distances are read from a profile that is linear up to `reach`, which is a ruler.
 *
 * @param {Marks} marks
 * @param {Float32Array} digital in pixels
 * @param {Float32Array} share of the way to `reach`, at the measured places
 * @param {number} reach
 * @param {boolean} isAnywhere
 * @returns {Errors}
 */
export function errorsOf(marks, digital, share, reach, isAnywhere) {
  const size = measured(marks, isAnywhere);
  const times = isAnywhere ? PLACES : 1;
  const errors = share.map((part, n) => {
    const [x, y] = [Math.floor((n % size[0]) / times), Math.floor(Math.floor(n / size[0]) / times)];
    return Math.abs((part * reach) / marks.edge - digital[y * marks.size[0] + x]);
  });
  let [worst, sum] = [0, 0];
  for (const error of errors) [worst, sum] = [Math.max(worst, error), sum + error];
  return { worst, mean: sum / errors.length, errors, size };
}

/** The centre of a pixel. @param {Marks} marks @param {number} x @param {number} y @returns {Point} */
export const centerOf = ({ box, edge }, x, y) => [box[0][0] + (x + 0.5) * edge, box[1][1] - (y + 0.5) * edge];
