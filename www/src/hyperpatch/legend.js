/**
 * The legend of a body: how its materials blend, or the scale of the fraction or of the Jacobian that is shown.
 *
 * @import { App } from "../state/app.js"
 * @import { Shown } from "./state.js"
 */
import { triangle } from "../controls/triangle.js";
import { h } from "../dom.js";
import { fixed, percent } from "../format.js";
import { corners, list, scale, strip } from "../stage/legend.js";
import { bodyOf, cellsOf } from "./document.js";
import { words } from "./words.js";

const SIDE = 76;

/** @param {App} app */
export function createBodyLegend(app) {
  const colors = triangle(SIDE);
  const element = h("div", { class: "legend", "data-body-legend": "" });
  let drawn = "";
  /** Materials of the cells that were looked through last. */
  let used = /** @type {{operations: unknown, indices: number[]}} */ ({ operations: null, indices: [] });

  /** Materials that a coefficient holds. */
  function usedMaterials() {
    const document = bodyOf(app);
    if (used.operations === document.operations) return used.indices;
    const found = new Set(cellsOf(document).flatMap(({ coefficients }) => coefficients.flatMap(({ mix }) => (mix ?? [1]).flatMap((fraction, i) => (fraction > 0 ? [i] : [])))));
    used = { operations: document.operations, indices: document.materials.map((_, i) => i).filter((i) => found.has(i)) };
    return used.indices;
  }

  return {
    element,
    /** @param {Readonly<Shown>} shown @param {[number, number] | null} range of the Jacobian */
    render({ color, material }, range) {
      const { materials } = bodyOf(app);
      const indices = usedMaterials();
      const key = JSON.stringify([color, material, materials, indices, range]);
      if (key === drawn) return;
      drawn = key;
      element.replaceChildren(...(color === "material" ? blend(indices) : bar(color, material, range)));
    },
  };

  /** @param {number[]} indices @returns {Node[]} */
  function blend(indices) {
    const document = bodyOf(app);
    const names = indices.map((i) => document.materials[i]);
    if (names.length === 2) return [strip(/** @type {any} */ (document), indices[0], indices[1]), scale([0, 0.5, 1].map(percent))];
    if (names.length === 3) {
      colors.draw(names.map((each) => each.color));
      return [corners(names, colors.element)];
    }
    return names.length > 1 ? [list(names, indices, false)] : [];
  }

  /** @param {"fraction" | "jacobian"} color @param {number} material @param {[number, number] | null} range @returns {Node[]} */
  function bar(color, material, range) {
    const { materials } = bodyOf(app);
    const isFraction = color === "fraction";
    const name = isFraction ? (materials[Math.min(material, materials.length - 1)]?.name ?? "") : words.legend.jacobian;
    const ticks = isFraction ? [0, 0.5, 1].map(percent) : range ? range.map((value, i) => (i === 1 ? words.legend.ofMean(fixed(value, 2)) : fixed(value, 2))) : [];
    return [h("div", { class: "legend-row" }, h("span", {}, name), h("span", { class: "legend-bar viridis" }), h("span", {})), scale(ticks)];
  }
}
