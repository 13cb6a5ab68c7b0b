/**
 * The legend of the solid: how materials blend, or the scale of the fraction or the angle that is shown.
 *
 * @import { App } from "../state/app.js"
 * @import { Solid } from "../../../js/directrix.js"
 * @import { SolidUi } from "./state.js"
 */
import { triangle } from "../controls/triangle.js";
import { h } from "../dom.js";
import { fixed, percent } from "../format.js";
import { blends, corners, list, scale, strip } from "../stage/legend.js";
import { usedMaterials } from "../state/materials.js";
import { words } from "./words.js";

const SIDE = 76;

/** @param {App} app */
export function createSolidLegend(app) {
  const colors = triangle(SIDE);
  const element = h("div", { class: "legend", "data-solid-legend": "" });
  let drawn = "";

  return {
    element,
    /** @param {Readonly<SolidUi>} shown @param {Solid | null} solid */
    render({ color, material }, solid) {
      const { document } = app.store;
      const key = JSON.stringify([color, material, document.materials, color === "material" ? blends(document) : solid?.range]);
      if (key === drawn) return;
      drawn = key;
      element.replaceChildren(...(color === "material" ? materialLegend() : scaleLegend(color, material, solid)));
    },
  };

  /** @returns {Node[]} */
  function materialLegend() {
    const { document } = app.store;
    const used = usedMaterials(document);
    const names = used.map((i) => document.materials[i]);
    if (used.length === 2) {
      const pairs = blends(document);
      if (pairs.length > 0) return [...pairs.map(([a, b]) => strip(document, a, b)), scale([0, 0.5, 1].map(percent))];
    }
    if (used.length === 3) {
      colors.draw(names.map((each) => each.color));
      return [corners(names, colors.element)];
    }
    return used.length > 1 ? [list(names, used, false)] : [];
  }

  /**
   * @param {"fraction" | "twist" | "flank"} color
   * @param {number} material
   * @param {Solid | null} solid
   * @returns {Node[]}
   */
  function scaleLegend(color, material, solid) {
    const { materials } = app.store.document;
    const [low, high] = solid?.range ?? [0, 1];
    const isFraction = color === "fraction";
    const name = isFraction ? words.legend.fraction(materials[Math.min(material, materials.length - 1)]?.name ?? "") : words.legend[color];
    const ticks = [low, (low + high) / 2, high].map((value) => (isFraction ? percent(value) : `${fixed(value, 1)}°`));
    return [
      h("div", { class: "legend-row" }, h("span", {}, name), h("span", { class: "legend-bar viridis" }), h("span", {})),
      ...(isFraction || solid?.range ? [scale(ticks)] : []),
    ];
  }
}
