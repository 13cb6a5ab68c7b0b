/**
 * One row of a group: a label column and controls, with room for a message below.
 */
import { h } from "../dom.js";

/** @typedef {{element: HTMLElement, error?: HTMLElement}} Control */

/**
 * @param {Node | string} label
 * @param {...Control} controls
 */
export function row(label, ...controls) {
  return h(
    "div",
    { class: "row" },
    h("span", { class: "row-label" }, label),
    h("span", { class: "row-controls" }, ...controls.map((c) => c.element)),
    ...controls.map((c) => c.error),
  );
}
