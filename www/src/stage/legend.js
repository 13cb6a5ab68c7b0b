/**
 * Legend of the material fractions: one strip for each pair of materials that blends from curve to curve.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument } from "../types.js"
 */
import { find, h } from "../dom.js";
import { percent } from "../format.js";
import { symbol } from "../icons.js";
import { numberNode } from "../number-node.js";
import { currentMatch } from "../state/app.js";
import { holds } from "../state/materials.js";

/** Strips shown at most. */
const STRIPS = 3;

/** @param {App} app */
export function createLegend(app) {
  const element = find("#legend");
  let drawn = "";

  return {
    render() {
      const { layers } = app.ui.value;
      const { document } = app.store;
      const range = layers.includes("value") ? valueRange(app) : null;
      const pairs = layers.includes("material") ? blends(document) : [];
      const key = JSON.stringify([pairs, document.materials, range]);
      if (key === drawn) return;
      drawn = key;
      element.hidden = pairs.length === 0 && !range;
      element.replaceChildren(
        ...pairs.map(([a, b]) => strip(document, a, b)),
        ...(pairs.length > 0 ? [scale([percent(0), percent(0.5), percent(1)])] : []),
        ...(range ? valueStrip(range) : []),
      );
    },
  };
}

/**
 * Pairs of different materials, one on the first curve and one on the second.
 * @param {CurvesDocument} document
 * @returns {[number, number][]}
 */
function blends({ curves, materials }) {
  const on = curves.map((curve) => materials.map((_, i) => i).filter((i) => holds(curve, i)));
  const [first = [], second = []] = on;
  /** @type {[number, number][]} */
  const pairs = first.flatMap((a) =>
    second.flatMap((b) => (a === b ? [] : [/** @type {[number, number]} */ ([a, b])])),
  );
  return pairs.slice(0, STRIPS);
}

/** @param {CurvesDocument} document @param {number} a @param {number} b */
function strip({ materials }, a, b) {
  const bar = h("span", { class: "legend-bar" });
  bar.style.backgroundImage = `linear-gradient(to right in oklab, ${materials[a]?.color}, ${materials[b]?.color})`;
  return h("div", { class: "legend-row" }, h("span", {}, materials[a]?.name), bar, h("span", {}, materials[b]?.name));
}

/** @param {(string | Node)[]} ticks */
function scale(ticks) {
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
  const values = currentMatch(app)?.lines.map((line) => line.value) ?? [];
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
