/**
 * The morph of a stack as an SVG that plays by itself: the current in-between passes every stage of every span.
 *
 * @import { Stage } from "../../../js/directrix.js"
 * @import { Size, View } from "../types.js"
 * @import { Motion } from "./motion.js"
 */
import { cased } from "./animated-svg.js";
import { shareAt } from "./motion.js";
import { timing } from "./smil.js";

/**
 * The figure with its in-between in motion. All stages have the same number of points, so that a blend of two of them is an in-between again.
 * @param {string} figure the kernel's SVG without the current in-between
 * @param {View} view
 * @param {{stages: Stage[], closed: boolean, motion: Motion, size: Size}} options
 */
export function animatedStack(figure, { center: [x, y], scale }, { stages, closed, motion, size: { width, height } }) {
  const place = (/** @type {number[]} */ [px, py]) =>
    `${(width / 2 + scale * (px - x)).toFixed(1)} ${(height / 2 - scale * (py - y)).toFixed(1)}`;
  const paths = stages.map(({ points }) => `M${points.map(place).join("L")}${closed ? "Z" : ""}`);
  const change = animateThrough("d", paths, stages.map(({ s }) => s), motion);
  return figure.replace(/<\/svg>\s*$/, `${cased(paths[0], change)}</svg>\n`);
}

/**
 * A change of one attribute through values at places from 0 to 1, each reached when the easing of the motion is there.
 * @param {string} name
 * @param {string[]} values
 * @param {number[]} places ascending
 * @param {Motion} motion
 */
function animateThrough(name, values, places, motion) {
  const swings = motion.repeat === "swing";
  const there = places.map((s) => shareAt(motion.easing, s));
  const times = swings ? [...there.map((t) => t / 2), ...there.slice(0, -1).reverse().map((t) => 1 - t / 2)] : there;
  const all = swings ? [...values, ...values.slice(0, -1).reverse()] : values;
  const written = times.map((t) => Number(t.toFixed(6)));
  return `<animate attributeName="${name}" values="${all.join(";")}" keyTimes="${written.join(";")}" ${timing(motion)}/>`;
}
