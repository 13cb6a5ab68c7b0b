/**
 * Three significant figures as nodes: the exponent is raised.
 */
import { h } from "./dom.js";
import { significant } from "./format.js";

/** @param {number} value */
export function numberNode(value) {
  const { mantissa, exponent } = significant(value);
  const parts = exponent === null ? [mantissa] : [`${mantissa} × 10`, h("sup", {}, exponent)];
  return h("span", { class: "number" }, ...parts);
}
