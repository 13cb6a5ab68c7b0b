/**
 * The matched pair of curves as texts for other tools.
 *
 * @import { MorphPaths } from "../../../js/directrix.js"
 * @import { Material } from "../types.js"
 * @import { Motion } from "./motion.js"
 *
 * @typedef {"svg" | "json" | "css" | "smil"} PathText
 */
import { average, between, hex } from "./color.js";
import { escaped } from "./animated-svg.js";
import { HANDLES } from "./motion.js";
import { fitted, moved } from "./path-data.js";
import { animate, animateColor } from "./smil.js";

/** Longer side of the box of a clip path, in CSS pixels. */
const CLIP = 400;
/** Digits of the box, beyond what its numbers say. */
const DIGITS = 8;

/**
 * @param {PathText} text
 * @param {MorphPaths} paths
 * @param {{title: string, materials: Material[], motion: Motion}} options
 */
export function pathText(text, paths, { title, materials, motion }) {
  const { from, to, viewBox } = paths;
  const box = viewBox.map((number) => Number(number.toPrecision(DIGITS))).join(" ");
  const colors = materials.map(({ color }) => color);
  const ends = paths.fractions.map(average);
  const color = (/** @type {number} */ s) => hex(colors, between(ends[0] ?? [], ends[1] ?? [], s));
  const open = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${box}" role="img">\n<title>${escaped(title)}</title>\n`;
  switch (text) {
    case "json":
      return `${JSON.stringify({ from, to, commands: paths.commands, error: paths.error, viewBox }, null, 2)}\n`;
    case "svg":
      return (
        `${open}<g fill="none" stroke="#17191d">\n` +
        [["from", from], ["to", to]].map(([id, d]) => `<path id="${id}" vector-effect="non-scaling-stroke" d="${d}"/>\n`).join("") +
        `</g>\n</svg>\n`
      );
    case "smil": {
      const [name, rest] = paths.closed ? ["fill", ""] : ["stroke", ' fill="none" stroke-width="2" vector-effect="non-scaling-stroke"'];
      return (
        `${open}<path ${name}="${color(0)}"${rest} d="${from}">\n${animate("d", from, to, motion)}\n` +
        `${animateColor(name, color, motion)}\n</path>\n</svg>\n`
      );
    }
    case "css":
      return css(paths, box, motion, [color(0), color(1)]);
  }
}

/** @param {MorphPaths} paths @param {string} box @param {Motion} motion @param {[string, string]} fills */
function css({ from, to, closed, viewBox }, box, motion, [first, last]) {
  const timing = HANDLES[motion.easing].map((handle) => Number(handle.toFixed(6))).join(", ");
  const count = { once: "forwards", loop: "infinite", swing: "infinite alternate" }[motion.repeat];
  const run = `${motion.seconds}s cubic-bezier(${timing}) ${count}`;
  const ink = (/** @type {string} */ color) => (closed ? `fill: ${color}` : `fill: none; stroke: ${color}`);
  const path = `/* For <svg viewBox="${box}"><path class="morph" /></svg> */
.morph {
  animation: morph ${run};
}

@keyframes morph {
  from { d: path("${from}"); ${ink(first)}; }
  to { d: path("${to}"); ${ink(last)}; }
}
`;
  // An open curve cuts nothing out.
  if (!closed) return path;
  const scale = CLIP / Math.max(viewBox[2], viewBox[3]);
  const [width, height] = [viewBox[2] * scale, viewBox[3] * scale].map((side) => Math.ceil(side));
  const place = fitted(viewBox, { width, height }, 0);
  const [a, b] = [from, to].map((path) => moved(path, place, 2));
  return `${path}
/* For any element */
.morph-clip {
  width: ${width}px;
  height: ${height}px;
  animation: morph-clip ${run};
}

@keyframes morph-clip {
  from { clip-path: path("${a}"); background-color: ${first}; }
  to { clip-path: path("${b}"); background-color: ${last}; }
}
`;
}
