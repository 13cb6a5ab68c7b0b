/**
 * A strip that shows how the composition runs along a curve, where it is not the same everywhere.
 *
 * @import { CurvesDocument } from "../types.js"
 */
import { h } from "../dom.js";
import { curveName } from "../state/app.js";
import { strings } from "../strings.js";
import { mixed } from "../oklab.js";

/**
 * @param {CurvesDocument} document
 * @param {number} index
 * @returns {HTMLElement | null} null for a curve of one composition
 */
export function compositionStrip(document, index) {
  const keys = [...(document.curves[index]?.composition ?? [])].sort((a, b) => a.at - b.at);
  const first = keys[0];
  const last = keys.at(-1);
  if (!first || !last || keys.length < 2) return null;
  const colors = document.materials.map(({ color }) => color);
  const seam = first.at + 1 - last.at;
  const t = (1 - last.at) / seam;
  const atSeam = mixed(
    colors,
    first.mix.map((f, i) => f * t + (last.mix[i] ?? 0) * (1 - t)),
  );
  const stops = [
    `${atSeam} 0%`,
    ...keys.map(({ at, mix }) => `${mixed(colors, mix)} ${(at * 100).toFixed(2)}%`),
    `${atSeam} 100%`,
  ];
  const bar = h("div", { class: "composition" });
  bar.style.backgroundImage = `linear-gradient(to right in oklab, ${stops.join(", ")})`;
  for (const { at } of keys) {
    const stop = h("span", {});
    stop.style.left = `${at * 100}%`;
    bar.append(stop);
  }
  return h(
    "div",
    { class: "composition-row" },
    bar,
    h(
      "div",
      { class: "composition-note number" },
      h("span", {}, strings.materials.along(curveName(document, index))),
      h("span", {}, strings.materials.stops(keys.length)),
    ),
  );
}
