/** Colours of mixtures as files take them. */
import { mean } from "../oklab.js";

/**
 * The colour of a mixture, by the mean in Oklab, as `#rrggbb`; what a screen cannot show is cut to what it can.
 *
 * Oklab to sRGB: Björn Ottosson, A perceptual color space for image processing, 2020.
 * @param {string[]} colors `#rrggbb`
 * @param {number[]} fractions
 */
export function hex(colors, fractions) {
  const [lightness = 0, a = 0, b = 0] = mean(colors, fractions);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const channels = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ].map((linear) => {
    const c = Math.min(1, Math.max(0, linear));
    const value = c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055;
    return Math.round(value * 255).toString(16).padStart(2, "0");
  });
  return `#${channels.join("")}`;
}

/**
 * The mean of mixtures.
 * @param {number[][]} mixtures at least one, of equally many materials
 */
export function average(mixtures) {
  return (mixtures[0] ?? []).map((_, k) => mixtures.reduce((sum, mixture) => sum + (mixture[k] ?? 0), 0) / mixtures.length);
}

/** A mixture on the way from one to another. @param {number[]} from @param {number[]} to @param {number} s */
export const between = (from, to, s) => from.map((fraction, k) => fraction * (1 - s) + (to[k] ?? 0) * s);
