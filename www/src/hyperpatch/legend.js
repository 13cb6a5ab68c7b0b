/**
 * The legend of a body: how its materials blend, or the scale of the fraction or of the Jacobian that is shown.
 *
 * @import { App } from "../state/app.js"
 * @import { Aspect, Joints } from "./joints.js"
 * @import { Shown } from "./state.js"
 */
import { triangle } from "../controls/triangle.js";
import { h, svg } from "../dom.js";
import { fixed, percent, significantText } from "../format.js";
import { corners, list, scale, strip } from "../stage/legend.js";
import { bodyOf } from "./document.js";
import { words } from "./words.js";

const SIDE = 76;

/** The signs of the picture, each on its line. */
const SIGNS = {
  C1: () => [svg("path", { class: "thin", d: "M0 7H28" }), svg("circle", { class: "filled", cx: 14, cy: 7, r: 3.6 })],
  C0: () => [svg("path", { class: "firm", d: "M0 7H28" }), svg("rect", { class: "filled", x: 10.5, y: 3.5, width: 7, height: 7 })],
  none: () => [svg("path", { class: "firm", d: "M0 7H6M9 7H11M17 7H19M22 7H28" }), svg("path", { class: "hollow", d: "M14 2.5 18.5 7 14 11.5 9.5 7Z" })],
};

/** A length with its unit. @param {number} length @param {string} unit */
const measureOf = (length, unit) => `${significantText(length)}\u00a0${unit}`.trim();

/** @param {App} app */
export function createBodyLegend(app) {
  const colors = triangle(SIDE);
  const element = h("div", { class: "legend", "data-body-legend": "" });
  let drawn = "";
  return {
    element,
    /**
     * @param {Readonly<Shown>} shown
     * @param {[number, number] | null} range of the Jacobian
     * @param {Joints | null} joints what is shown of how cells continue each other
     * @param {readonly number[]} amounts of each material
     */
    render({ color, material, continuity }, range, joints, amounts) {
      const { materials } = bodyOf(app);
      const indices = amounts.flatMap((amount, i) => (amount !== 0 && i < bodyOf(app).materials.length ? [i] : []));
      const key = JSON.stringify([color, material, materials, indices, range, joints?.counts, continuity]);
      if (key === drawn) return;
      drawn = key;
      const meeting = joints && continuity !== "off" ? meetings(joints.counts, continuity) : [];
      element.replaceChildren(...meeting, ...(color === "material" ? blend(indices) : bar(color, material, range)));
    },
  };

  /** Signs of corners between cells, with how many there are. @param {Joints["counts"]} counts @param {Aspect} aspect @returns {Node[]} */
  function meetings(counts, aspect) {
    const { unit } = bodyOf(app);
    const row = (/** @type {keyof typeof SIGNS} */ name) =>
      h(
        "div",
        { class: "body-meeting", "data-meeting": name },
        /** @type {any} */ (svg("svg", { class: `body-sign ${name}`, width: 28, height: 14, viewBox: "0 0 28 14", "aria-hidden": "true" }, ...SIGNS[name]())),
        h("span", {}, words.legend.meetings[aspect][name]),
        h("span", { class: "strong number" }, String(counts[name])),
      );
    const names = /** @type {const} */ (["C1", "C0", "none"]).filter((name) => name !== "none" || aspect === "material");
    const gap = counts.gap > 0 ? [h("div", { class: "body-meeting", "data-meeting": "gap" }, h("span", {}), h("span", {}, words.legend.gap(measureOf(counts.gap, unit))), h("span", { class: "strong number" }, String(counts.contacts)))] : [];
    return [h("div", { class: "body-meetings" }, ...names.map(row), ...gap)];
  }

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
