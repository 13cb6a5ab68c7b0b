/**
 * Legend of the material fractions: the triangle of all mixes for three materials, one strip for each pair that blends from curve to curve
 * for two, and a list for more.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Material } from "../types.js"
 */
import { find, h } from "../dom.js";
import { percent } from "../format.js";
import { symbol } from "../icons.js";
import { numberNode } from "../number-node.js";
import { currentMatch } from "../state/app.js";
import { shownLines } from "../state/lines.js";
import { hasLooks, isHarmonic, lookedAt } from "../state/look.js";
import { strings } from "../strings.js";
import { triangle } from "../controls/triangle.js";
import { setHatch } from "../state/hatch.js";
import { inTriangle } from "../state/mix.js";
import { holds, usedMaterials } from "../state/materials.js";

/** Strips and names shown at most, and the side of the triangle in CSS pixels. */
const STRIPS = 3;
const NAMES = 6;
const SIDE = 76;

/** @param {App} app */
export function createLegend(app) {
  const element = find("#legend");
  const colors = triangle(SIDE);
  const dot = h("span", { class: "triangle-dot", hidden: true });
  let drawn = "";

  return {
    render() {
      const { layers, patterns } = app.ui.value;
      const { document } = app.store;
      const range = layers.includes("value") ? valueRange(app) : null;
      // The difference of two blends has a legend of its own.
      const differs = layers.includes("difference") && hasLooks(document) && isHarmonic(lookedAt(app));
      const used = layers.includes("material") && !differs ? usedMaterials(document) : [];
      const pairs = used.length === 2 && !patterns ? blends(document) : [];
      mark(used);
      const key = JSON.stringify([used, pairs, document.materials, range, patterns]);
      if (key === drawn) return;
      drawn = key;
      const names = used.map((i) => document.materials[i]);
      const asTriangle = used.length === 3 && !patterns;
      const asList = used.length > 3 || (used.length > 1 && patterns);
      if (asTriangle) colors.draw(names.map(({ color }) => color));
      element.hidden = used.length < 2 && !range;
      element.replaceChildren(
        ...pairs.map(([a, b]) => strip(document, a, b)),
        ...(pairs.length > 0 ? [scale([percent(0), percent(0.5), percent(1)])] : []),
        ...(asTriangle ? [corners(names, colors.element, dot)] : []),
        ...(asList ? [list(names, used, patterns)] : []),
        ...(range ? valueStrip(range) : []),
      );
    },
  };

  /** Shows the probed mix in the triangle. @param {number[]} used */
  function mark(used) {
    const { probe } = app.ui.value;
    dot.hidden = !probe || used.length !== 3 || app.ui.value.patterns;
    if (!probe || dot.hidden) return;
    const [x, y] = inTriangle(used.map((i) => probe.fractions[i] ?? 0));
    dot.style.left = `${x * SIDE}px`;
    dot.style.bottom = `${y * SIDE}px`;
  }
}

/**
 * The triangle of three materials with their names.
 * @param {Material[]} names
 * @param {...Node} area
 */
export function corners([a, b, c], ...area) {
  return h(
    "div",
    { class: "legend-triangle" },
    h("span", {}, c.name),
    h("div", { class: "triangle-area" }, ...area),
    h("div", { class: "triangle-base" }, h("span", {}, a.name), h("span", {}, b.name)),
  );
}

/** @param {Material[]} names @param {number[]} indices @param {boolean} patterns */
export function list(names, indices, patterns) {
  const rows = names.slice(0, NAMES).map((material, i) => {
    const swatch = h("span", { class: "mix-swatch" });
    swatch.style.setProperty("--color", material.color);
    setHatch(swatch, patterns, indices[i] ?? 0, material);
    return h("div", { class: "legend-name" }, swatch, h("span", {}, material.name));
  });
  const more = names.length > NAMES ? [h("div", { class: "legend-name" }, strings.legend.more(names.length - NAMES))] : [];
  return h("div", { class: "legend-list" }, ...rows, ...more);
}

/**
 * Pairs of different materials, one on a curve and one on the next; the same two only once.
 * @param {CurvesDocument} document
 * @returns {[number, number][]}
 */
export function blends({ curves, materials }) {
  const on = curves.map((curve) => materials.map((_, i) => i).filter((i) => holds(curve, i)));
  /** @type {[number, number][]} */
  const pairs = on.slice(1).flatMap((second, k) =>
    on[k].flatMap((a) => second.flatMap((b) => (a === b ? [] : [/** @type {[number, number]} */ ([a, b])]))),
  );
  const isNew = (/** @type {number[]} */ [a, b], /** @type {number} */ i) => !pairs.slice(0, i).some(([c, d]) => (a === d && b === c) || (a === c && b === d));
  return pairs.filter(isNew).slice(0, STRIPS);
}

/** @param {CurvesDocument} document @param {number} a @param {number} b */
export function strip({ materials }, a, b) {
  const bar = h("span", { class: "legend-bar" });
  bar.style.backgroundImage = `linear-gradient(to right in oklab, ${materials[a]?.color}, ${materials[b]?.color})`;
  return h("div", { class: "legend-row" }, h("span", {}, materials[a]?.name), bar, h("span", {}, materials[b]?.name));
}

/** @param {(string | Node)[]} ticks */
export function scale(ticks) {
  return h(
    "div",
    { class: "legend-row legend-ticks number" },
    h("span", {}),
    h("span", { class: "legend-scale" }, ...ticks.map((tick) => h("span", {}, tick))),
    h("span", {}),
  );
}

/** @param {App} app @returns {[number, number] | null} */
function valueRange(app) {
  const values = shownLines(currentMatch(app)).map((line) => line.value);
  return values.length > 0 ? [Math.min(...values), Math.max(...values)] : null;
}

/** @param {[number, number]} range */
function valueStrip([low, high]) {
  return [
    h(
      "div",
      { class: "legend-row" },
      h("span", {}, symbol("f")),
      h("span", { class: "legend-bar viridis" }),
      h("span", {}),
    ),
    scale([numberNode(low), numberNode(high)]),
  ];
}
