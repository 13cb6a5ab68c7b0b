/**
 * Rasters of a part as pixels: its colours, the leaves of the subdivision, what two rules differ by, and where design rules are broken.
 *
 * @import { PartRaster } from "../../../js/directrix.js"
 * @import { Leaf, Violations } from "./state.js"
 *
 * @typedef {Uint8ClampedArray<ArrayBuffer>} Pixels straight RGBA in rows from the top
 */
import { viridis } from "../hyperpatch/colors.js";

/** Hues of leaves: multiples of the golden section of the circle lie apart for any count of them. */
const GOLDEN = (Math.sqrt(5) - 1) / 2;
/** Turn of the hue from body to body. */
const BODY = 0.29;
/** Lightness and chroma of leaves in Oklch, by how many features hold them: from 1 on; and of places that none holds. */
const LIGHTNESS = [0.84, 0.74, 0.65, 0.57];
const CHROMA = 0.085;
const NONE = [205, 208, 214];
/** Opacity of leaves beside the one that is lit. */
const FAINT = 70;

/** The colours of the kernel. @param {PartRaster} raster @returns {Pixels} */
export const colorPixels = ({ colors, body }) =>
  /** @type {Pixels} */ (colors ? new Uint8ClampedArray(/** @type {ArrayBuffer} */ (colors.buffer), colors.byteOffset, colors.byteLength) : new Uint8ClampedArray(4 * body.length));

/** How many features hold a leaf. @param {number} leaf */
export function countOf(leaf) {
  let count = 0;
  for (let rest = leaf >>> 0; rest > 0; rest = Math.floor(rest / 2)) count += rest % 2;
  return count;
}

/**
 * The colour of a leaf, which depends on nothing but the leaf, so that an edit changes no other.
 * @param {Leaf} leaf
 * @returns {number[]} red, green, blue from 0 to 255
 */
export function leafColor({ body, leaf }) {
  if (leaf === 0) return NONE;
  const hue = 2 * Math.PI * ((leaf * GOLDEN + body * BODY) % 1);
  return srgb(LIGHTNESS[Math.min(countOf(leaf), LIGHTNESS.length) - 1], CHROMA * Math.cos(hue), CHROMA * Math.sin(hue));
}

/**
 * Oklab as sRGB, clipped (Björn Ottosson, A perceptual color space for image processing, 2020).
 * @param {number} lightness
 * @param {number} a
 * @param {number} b
 */
function srgb(lightness, a, b) {
  const [l, m, s] = [lightness + 0.3963377774 * a + 0.2158037573 * b, lightness - 0.1055613458 * a - 0.0638541728 * b, lightness - 0.0894841775 * a - 1.291485548 * b].map((t) => t ** 3);
  return [4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s, -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s, -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s].map(
    (t) => Math.round(255 * Math.min(1, Math.max(0, t <= 0.0031308 ? 12.92 * t : 1.055 * t ** (1 / 2.4) - 0.055))),
  );
}

/**
 * @param {PartRaster} raster
 * @param {Leaf | null} lit the one that stands out
 * @returns {Pixels}
 */
export function leafPixels({ body, leaves }, lit) {
  const pixels = new Uint8ClampedArray(4 * body.length);
  /** @type {Map<number, number[]>} */
  const known = new Map();
  for (let n = 0; n < body.length; n += 1) {
    if (body[n] === 0) continue;
    const key = body[n] * 2 ** 32 + leaves[n];
    let color = known.get(key);
    if (!color) {
      const leaf = { body: body[n] - 1, leaf: leaves[n] };
      const isFaint = lit !== null && (lit.body !== leaf.body || lit.leaf !== leaf.leaf);
      known.set(key, (color = [...leafColor(leaf), isFaint ? FAINT : 255]));
    }
    pixels.set(color, 4 * n);
  }
  return pixels;
}

/**
 * The largest difference of a fraction in each pixel.
 * @param {Pick<PartRaster, "body" | "fractions">} raster
 * @param {Pick<PartRaster, "fractions">} other of the same pixels
 * @returns {{differences: Float32Array, most: number}}
 */
export function differencesOf({ body, fractions }, other) {
  const differences = new Float32Array(body.length);
  let most = 0;
  for (const [k, list] of fractions.entries()) {
    const others = other.fractions[k];
    for (let n = 0; n < body.length; n += 1) {
      if (body[n] === 0) continue;
      const difference = Math.abs(list[n] - others[n]);
      if (difference > differences[n]) differences[n] = difference;
      if (difference > most) most = difference;
    }
  }
  return { differences, most };
}

/**
 * What two rules differ by, from 0 to 1 on the scale of scalars.
 * @param {PartRaster} raster
 * @param {PartRaster} other of the same pixels
 * @returns {Pixels}
 */
export function differencePixels(raster, other) {
  const { differences } = differencesOf(raster, other);
  const pixels = new Uint8ClampedArray(4 * differences.length);
  for (let n = 0; n < differences.length; n += 1) {
    if (raster.body[n] === 0) continue;
    const [red, green, blue] = viridis(differences[n]);
    pixels[4 * n] = red;
    pixels[4 * n + 1] = green;
    pixels[4 * n + 2] = blue;
    pixels[4 * n + 3] = 255;
  }
  return pixels;
}

/**
 * Where design rules are broken: opaque there, transparent elsewhere.
 * @param {Pick<Violations, "pixels">} violations
 * @param {number | null} rule the only one; null for all
 * @returns {Pixels}
 */
export function brokenPixels({ pixels }, rule) {
  const mask = rule === null ? 0xffffffff : (1 << rule) >>> 0;
  const found = new Uint8ClampedArray(4 * pixels.length);
  for (let n = 0; n < pixels.length; n += 1) if ((pixels[n] & mask) !== 0) found[4 * n + 3] = 255;
  return found;
}
