/**
 * The legend of a part: its materials with how much there is of each, or the scale of what two rules differ by.
 *
 * @import { Bench } from "./state.js"
 */
import { h } from "../dom.js";
import { percent } from "../format.js";
import { measure } from "../space/measure.js";
import { scale } from "../stage/legend.js";
import { words } from "./words.js";

/** Materials named at most. */
const NAMED = 8;

/** @param {Bench} bench */
export function createLegend(bench) {
  const element = h("div", { class: "legend part-legend", "data-part-legend": "" });
  let drawn = "";
  return {
    element,
    render() {
      const { document, known, isCurrent, shown } = bench.now();
      const { materials = [], unit = "mm" } = document;
      const measured = known?.measured ?? null;
      const isDifference = shown.difference && known?.reference != null && !shown.leaves;
      element.hidden = shown.leaves || shown.compare;
      element.classList.toggle("stale", !isCurrent || !measured);
      if (!measured && drawn && !isDifference) return;
      const key = JSON.stringify([materials, measured?.amounts, measured?.area, unit, isDifference]);
      if (key === drawn) return;
      drawn = key;
      element.replaceChildren(
        ...(isDifference
          ? [h("div", { class: "part-scale" }, h("div", { class: "legend-row" }, h("span", {}, words.legend.difference), h("span", { class: "legend-bar viridis" }), h("span", {})), scale([0, 0.5, 1].map(percent)))]
          : materials.slice(0, NAMED).map(({ name, color }, i) => {
              const swatch = h("span", { class: "part-swatch" });
              swatch.style.backgroundColor = color;
              const amount = measured?.amounts[i];
              return h(
                "div",
                { class: "part-material", "data-part-amount": String(i) },
                swatch,
                h("span", { class: "part-name" }, name),
                h("span", { class: "number strong" }, amount === undefined ? "" : measure(amount, unit, 2)),
                h("span", { class: "number" }, amount === undefined || !measured?.area ? "" : percent(amount / measured.area)),
              );
            })),
        ...(!isDifference && materials.length > NAMED ? [h("div", {}, words.legend.more(materials.length - NAMED))] : []),
      );
    },
  };
}
