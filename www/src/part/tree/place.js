/**
 * Where the feature list stands: at the left of a wide window, else as the first group of the inspector, which is the first tab of a phone.
 *
 * @import { Group } from "../../inspector/group.js"
 */
import { h } from "../../dom.js";
import { words } from "./words.js";

/**
 * @param {{element: HTMLElement, render: () => void}} tree
 * @param {HTMLElement} list the place at the left
 * @param {AbortSignal} signal ends it
 * @returns {Group} empty, and not shown, where the list stands at the left
 */
export function treeGroup(tree, list, signal) {
  const body = h("div", {});
  const wide = matchMedia("(width >= 1200px)");
  const put = () => (wide.matches ? list : body).append(tree.element);
  put();
  wide.addEventListener("change", put, { signal });
  return { name: "tree", heading: words.heading, body, phrase: () => "", render: () => {} };
}
