import { svg } from "../dom.js";

/** A text in a chart. @param {string} text @param {number} x @param {number} y @param {string} anchor as `text-anchor` has it */
export function label(text, x, y, anchor) {
  const element = svg("text", { x: x.toFixed(1), y: y.toFixed(1), "text-anchor": anchor });
  element.textContent = text;
  return element;
}
