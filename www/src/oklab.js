/**
 * The colour of a mixture for legends and strips, as CSS: the mean in Oklab, weighted by the fractions. The figure
 * itself is coloured by the kernel with the same rule.
 */

/**
 * @param {string[]} colors `#rrggbb`
 * @param {number[]} fractions
 */
export function mixed(colors, fractions) {
  const [l = 0, a = 0, b = 0] = mean(colors, fractions);
  return `oklab(${l.toFixed(4)} ${a.toFixed(4)} ${b.toFixed(4)})`;
}

/**
 * The mean in Oklab.
 * @param {string[]} colors `#rrggbb`
 * @param {number[]} fractions
 */
export function mean(colors, fractions) {
  const sum = [0, 0, 0];
  fractions.forEach((fraction, i) => {
    const lab = oklab(colors[i] ?? "#000000");
    for (let k = 0; k < 3; k += 1) sum[k] = /** @type {number} */ (sum[k]) + fraction * /** @type {number} */ (lab[k]);
  });
  return sum;
}

/**
 * sRGB to Oklab (Björn Ottosson, A perceptual color space for image processing, 2020).
 * @param {string} hex
 */
function oklab(hex) {
  const value = Number.parseInt(hex.slice(1), 16);
  const [r, g, b] = [value >> 16, (value >> 8) & 255, value & 255].map((channel) => {
    const c = channel / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  });
  const [red, green, blue] = [r ?? 0, g ?? 0, b ?? 0];
  const l = Math.cbrt(0.4122214708 * red + 0.5363325363 * green + 0.0514459929 * blue);
  const m = Math.cbrt(0.2119034982 * red + 0.6806995451 * green + 0.1073969566 * blue);
  const s = Math.cbrt(0.0883024619 * red + 0.2817188376 * green + 0.6299787005 * blue);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}
