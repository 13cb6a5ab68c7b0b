/**
 * Pixels of a solution: fractions mixed to colours, grown a little beyond the boundary so that its edge can be cut sharply, and lines of equal fraction.
 *
 * @typedef {object} Found What the kernel gives of a section.
 * @property {[number, number]} size
 * @property {ArrayLike<number>[]} values of each material, row by row
 */
import { mean } from "../oklab.js";
import { srgbOf } from "../space/colors.js";

/** Colours of materials in Oklab, three numbers each. @param {readonly {color: string}[]} materials */
export const labsOfMaterials = (materials) => materials.map(({ color }) => mean([color], [1]));

/**
 * The mean in Oklab, weighted by fractions.
 * @param {number[][]} labs of the materials
 * @param {(material: number) => number} fraction
 * @returns {[number, number, number]}
 */
export function labOf(labs, fraction) {
  /** @type {[number, number, number]} */
  const sum = [0, 0, 0];
  labs.forEach((lab, material) => {
    const share = Math.min(1, Math.max(0, fraction(material)));
    for (const k of /** @type {const} */ ([0, 1, 2])) sum[k] += share * lab[k];
  });
  return sum;
}

/**
 * Colours row by row; what is outside is clear.
 * @param {Found} found
 * @param {readonly {color: string}[]} materials
 * @param {boolean} [isFlipped] whether the last row comes first, as in pictures
 * @returns {Uint8ClampedArray<ArrayBuffer>}
 */
export function colorsOf({ size: [wide, tall], values }, materials, isFlipped = false) {
  const labs = labsOfMaterials(materials);
  const pixels = new Uint8ClampedArray(4 * wide * tall);
  for (let row = 0; row < tall; row += 1) {
    for (let column = 0; column < wide; column += 1) {
      const n = row * wide + column;
      if (Number.isNaN(values[0][n])) continue;
      const at = 4 * ((isFlipped ? tall - 1 - row : row) * wide + column);
      const [r, g, b] = srgbOf(labOf(labs, (material) => values[material][n]), 0);
      pixels.set([255 * r, 255 * g, 255 * b, 255], at);
    }
  }
  return pixels;
}

/**
 * Pixels with clear ones beside coloured ones coloured as well, some times over.
 * @param {Uint8ClampedArray<ArrayBuffer>} pixels four bytes each
 * @param {[number, number]} size
 * @param {number} times
 */
export function grown(pixels, [wide, tall], times) {
  let now = pixels;
  for (let turn = 0; turn < times; turn += 1) {
    const next = now.slice();
    for (let n = 0; n < wide * tall; n += 1) {
      if (now[4 * n + 3] > 0) continue;
      const [x, y] = [n % wide, Math.floor(n / wide)];
      let [count, r, g, b] = [0, 0, 0, 0];
      for (const [i, j] of [[x - 1, y], [x + 1, y], [x, y - 1], [x, y + 1], [x - 1, y - 1], [x + 1, y - 1], [x - 1, y + 1], [x + 1, y + 1]]) {
        if (i < 0 || j < 0 || i >= wide || j >= tall) continue;
        const k = 4 * (j * wide + i);
        if (now[k + 3] === 0) continue;
        count += 1;
        r += now[k];
        g += now[k + 1];
        b += now[k + 2];
      }
      if (count > 0) next.set([r / count, g / count, b / count, 255], 4 * n);
    }
    now = next;
  }
  return now;
}

/**
 * Where a value passes a level between the middles of pixels, as segments: each square of four middles is looked at by itself (marching squares;
 * W. E. Lorensen and H. E. Cline, Marching cubes, 1987, in the plane). Squares that reach outside have none.
 * @param {ArrayLike<number>} values row by row
 * @param {[number, number]} size
 * @param {number} level
 * @returns {number[]} four numbers a segment: columns and rows, whole in the middle of pixels
 */
export function levelLines(values, [wide, tall], level) {
  const segments = [];
  for (let j = 0; j + 1 < tall; j += 1) {
    for (let i = 0; i + 1 < wide; i += 1) {
      const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
      const heights = corners.map(([x, y]) => values[y * wide + x] - level);
      if (heights.some(Number.isNaN)) continue;
      /** @type {number[][]} */
      const met = [];
      for (let k = 0; k < 4; k += 1) {
        const [a, b] = [heights[k], heights[(k + 1) % 4]];
        if (a >= 0 === b >= 0) continue;
        const t = a / (a - b);
        met.push([0, 1].map((axis) => corners[k][axis] + t * (corners[(k + 1) % 4][axis] - corners[k][axis])));
      }
      // Of a saddle the mean of the corners tells which two of them are joined.
      if (met.length === 4 && heights[0] >= 0 !== heights.reduce((sum, height) => sum + height, 0) >= 0) met.push(/** @type {number[]} */ (met.shift()));
      for (let k = 0; k + 1 < met.length; k += 2) segments.push(...met[k], ...met[k + 1]);
    }
  }
  return segments;
}

/** Levels of lines of equal fraction. */
export const LEVELS = [0.2, 0.4, 0.6, 0.8];

/** The mix that a condition gives; null of a flux. @param {{value: number[]} | {flux: number[]} | undefined} condition */
export const mixOf = (condition) => (condition && "value" in condition ? condition.value : null);
