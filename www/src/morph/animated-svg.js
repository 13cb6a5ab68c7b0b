/**
 * The morph as an SVG that plays by itself.
 *
 * @import { MorphPaths } from "../../../js/directrix.js"
 * @import { Material, Size, View } from "../types.js"
 * @import { Motion } from "./motion.js"
 *
 * @typedef {object} Animated
 * @property {MorphPaths} paths
 * @property {Motion} motion
 * @property {Material[]} materials
 * @property {Size} size CSS pixels
 * @property {"light" | "dark"} theme
 */
import { between, hex } from "./color.js";
import { commands, fitted, moved } from "./path-data.js";
import { animate, animateColor } from "./smil.js";

/** Decimals of places in CSS pixels. */
const DECIMALS = 2;
/** Room round the shape by itself, in CSS pixels. */
const MARGIN = 24;
/** Strokes of the current in-between, as the kernel draws it over the band and, in its materials, on the bare canvas. */
const HALO = 'stroke="#ffffff" stroke-width="4.5" stroke-opacity="0.9"';
const LINE = 'stroke="#101216" stroke-width="1.75"';
const WORN = 5;
const CASING = WORN + 2;

/** @type {{[theme in "light" | "dark"]: {canvas: string, ink: string}}} */
const COLORS = { light: { canvas: "#ffffff", ink: "#17191d" }, dark: { canvas: "#0e0f12", ink: "#f3f4f7" } };

/**
 * The figure with its in-between in motion.
 * @param {string} figure the kernel's SVG without the current in-between
 * @param {View} view
 * @param {boolean} onBand whether the figure has the material under the in-between
 * @param {Animated} options
 */
export function animatedFigure(figure, view, onBand, options) {
  const { width, height } = options.size;
  const { center: [x, y], scale } = view;
  const place = { scale, x: width / 2 - scale * x, y: height / 2 + scale * y };
  const from = moved(options.paths.from, place, DECIMALS);
  const to = moved(options.paths.to, place, DECIMALS);
  const line = onBand ? cased(from, animate("d", from, to, options.motion)) : worn(from, to, options);
  return figure.replace(/<\/svg>\s*$/, `${line}</svg>\n`);
}

/**
 * The in-between alone, in its materials.
 * @param {string} title
 * @param {boolean} transparent
 * @param {Animated} options
 */
export function animatedShape(title, transparent, options) {
  const { width, height } = options.size;
  const place = fitted(options.paths.viewBox, options.size, MARGIN);
  const [from, to] = [options.paths.from, options.paths.to].map((path) => moved(path, place, DECIMALS));
  const ground = transparent ? "" : `<rect width="100%" height="100%" fill="${COLORS[options.theme].canvas}"/>\n`;
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" role="img">\n` +
    `<title>${escaped(title)}</title>\n${ground}${worn(from ?? "", to ?? "", options)}</svg>\n`
  );
}

/** The line over a halo. @param {string} from @param {string} change the animation of its path */
export function cased(from, change) {
  const path = (/** @type {string} */ stroke) => `<path ${stroke} d="${from}">${change}</path>\n`;
  return `<g id="morph" fill="none" stroke-linejoin="round">\n${path(HALO)}${path(LINE)}</g>\n`;
}

/** The line in the colours of its materials. @param {string} from @param {string} to @param {Animated} options */
function worn(from, to, { paths, motion, materials, theme }) {
  const colors = materials.map(({ color }) => color);
  const [first, second] = paths.fractions;
  const starts = commands(from);
  const ends = commands(to);
  const casing = `<path stroke="${COLORS[theme].ink}" stroke-width="${CASING}" d="${from}">${animate("d", from, to, motion)}</path>\n`;
  let pieces = "";
  for (let k = 0; k < starts.length; ) {
    const color = (/** @type {number} */ s) => hex(colors, between(first[k] ?? [], second[k] ?? [], s));
    let last = k + 1;
    // Neighbours of the same colours all the way are one piece.
    while (last < starts.length && same(first[last], first[k]) && same(second[last], second[k])) last += 1;
    const whole = paths.closed && last - k === starts.length;
    const data = (/** @type {typeof starts} */ all) =>
      `M${all[k]?.start}${all.slice(k, last).map(({ cubic }) => cubic).join("")}${whole ? "Z" : ""}`;
    const [a, b] = [data(starts), data(ends)];
    pieces += `<path stroke="${color(0)}" d="${a}">${animate("d", a, b, motion)}${animateColor("stroke", color, motion)}</path>\n`;
    k = last;
  }
  return (
    `<g id="morph" fill="none" stroke-linejoin="round" stroke-linecap="round">\n${casing}` +
    `<g stroke-width="${WORN}">\n${pieces}</g>\n</g>\n`
  );
}

/** @param {number[] | undefined} a @param {number[] | undefined} b */
const same = (a = [], b = []) => a.every((fraction, k) => fraction === b[k]);

/** @param {string} text */
export const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
