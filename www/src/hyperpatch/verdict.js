/**
 * Verdicts as signs that differ in shape: tick, half disc, ring, dash, cross.
 *
 * @import { VerdictName } from "../../../js/directrix.js"
 */
import { h, svg } from "../dom.js";
import { words } from "./words.js";

/** @type {Record<VerdictName, () => SVGElement[]>} */
const SIGNS = {
  regular: () => [svg("path", { d: "M3 8.5 6.5 12 13 4.5" })],
  valid: () => [svg("circle", { cx: 8, cy: 8, r: 5 }), svg("path", { d: "M8 3a5 5 0 0 1 0 10Z", class: "filled" })],
  "locally-valid": () => [svg("circle", { cx: 8, cy: 8, r: 5 })],
  degenerate: () => [svg("path", { d: "M3.5 8h9" })],
  invalid: () => [svg("path", { d: "M4 4l8 8M12 4l-8 8" })],
};

/** @param {VerdictName} verdict */
export const sign = (verdict) =>
  svg("svg", { class: `verdict-sign ${verdict}`, width: 16, height: 16, viewBox: "0 0 16 16", "aria-hidden": "true" }, ...SIGNS[verdict]());

/** A sign with its word. @param {VerdictName} verdict */
export const badge = (verdict) =>
  h("span", { class: "verdict-badge", "data-verdict": verdict }, /** @type {any} */ (sign(verdict)), h("span", {}, words.verdicts[verdict]));

/** Verdicts from the worst to the best. @type {readonly VerdictName[]} */
export const WORST_FIRST = ["invalid", "degenerate", "locally-valid", "valid", "regular"];
