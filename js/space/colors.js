/**
 * Colours of vertices in Oklab, in which the surface is coloured between them: fractions mix there, so that what a fragment gets is the
 * colour of its own mix.
 */

/** Numbers from 0 to 1 in linear light for each byte of sRGB (IEC 61966-2-1). */
const LINEAR = Float64Array.from({ length: 256 }, (_, byte) => {
  const c = byte / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
});

/**
 * @param {Uint8Array} colors four bytes a vertex, sRGB and opacity
 * @returns {Float32Array} three numbers a vertex, Oklab (Björn Ottosson, A perceptual color space for image processing, 2020)
 */
export function labsOf(colors) {
  const labs = new Float32Array((colors.length / 4) * 3);
  for (let i = 0, k = 0; i < colors.length; i += 4, k += 3) {
    const [red, green, blue] = [LINEAR[colors[i]], LINEAR[colors[i + 1]], LINEAR[colors[i + 2]]];
    const l = Math.cbrt(0.4122214708 * red + 0.5363325363 * green + 0.0514459929 * blue);
    const m = Math.cbrt(0.2119034982 * red + 0.6806995451 * green + 0.1073969566 * blue);
    const s = Math.cbrt(0.0883024619 * red + 0.2817188376 * green + 0.6299787005 * blue);
    labs[k] = 0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s;
    labs[k + 1] = 1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s;
    labs[k + 2] = 0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s;
  }
  return labs;
}

/**
 * sRGB of a colour in Oklab from 0 to 1, clipped.
 * @param {ArrayLike<number>} labs
 * @param {number} start
 * @returns {[number, number, number]}
 */
export function srgbOf(labs, start) {
  const [L, a, b] = [labs[start], labs[start + 1], labs[start + 2]];
  const l = (L + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (L - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (L - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    encoded(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

/** @param {number} light */
function encoded(light) {
  const clipped = Math.min(1, Math.max(0, light));
  return clipped <= 0.0031308 ? 12.92 * clipped : 1.055 * clipped ** (1 / 2.4) - 0.055;
}

/** The channels of `#rrggbb`, from 0 to 1. @param {string} hex @returns {[number, number, number]} */
export function plainColor(hex) {
  const value = Number.parseInt(hex.slice(1), 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}
