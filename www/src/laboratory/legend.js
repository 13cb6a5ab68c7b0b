/**
 * The legend: how fractions mix to colours, and what grey and hatched elements mean.
 *
 * @import { Bench } from "./state.js"
 */
import { h } from "../dom.js";
import { percent } from "../format.js";
import { corners, list, scale, strip } from "../stage/legend.js";
import { triangle } from "../controls/triangle.js";
import { kindOf } from "./edits.js";
import { words } from "./words.js";

/** Side of the triangle of three materials, CSS pixels. */
const SIDE = 72;

/** @param {Bench} bench */
export function createLegend(bench) {
  const colors = triangle(SIDE);
  const element = h("div", { class: "legend lab-legend", "data-lab-legend": "" });
  let drawn = "";
  return {
    element,
    render() {
      const { document, shown } = bench.now();
      const { materials, groups, rest } = document;
      const kinds = new Set([...groups.map(({ condition }) => condition), ...(rest ? [rest] : [])].map(kindOf));
      const key = JSON.stringify([materials, [...kinds], shown.color]);
      if (key === drawn) return;
      drawn = key;
      element.replaceChildren(
        ...blend(),
        ...(shown.color === "given" ? /** @type {const} */ (["flux", "insulated"]).filter((kind) => kinds.has(kind)).map((kind) => h("div", { class: "lab-key" }, h("span", { class: `part-swatch lab-swatch ${kind}` }), h("span", {}, words.legend[kind]))) : []),
      );

      /** @returns {Node[]} */
      function blend() {
        if (materials.length === 2) return [strip(/** @type {any} */ (document), 0, 1), scale([0, 0.5, 1].map(percent))];
        const names = list(materials, materials.map((_, k) => k), false);
        if (materials.length === 3) {
          colors.draw(materials.map((each) => each.color));
          // A phone has no room for the triangle.
          return [corners(materials, colors.element), h("div", { class: "lab-instead" }, names)];
        }
        return [names];
      }
    },
  };
}
