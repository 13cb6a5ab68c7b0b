/** The status line of a mode or of another workbench. */
import { h } from "../dom.js";

/**
 * Writes the line when it differs from what stands there, so that a button keeps its focus.
 * @param {HTMLElement} element
 * @param {string} verdict
 * @param {Node[]} left the measures
 * @param {(Node | null)[]} right remarks and commands
 */
export function fillStatus(element, verdict, left, right) {
  const next = [h("div", { class: "certificates" }, ...left), h("div", { class: "remark" }, ...right.filter((node) => node !== null))];
  element.dataset.verdict = verdict;
  const same = next.every((node, i) => element.children[i]?.isEqualNode(node));
  if (!same || element.children.length !== next.length) element.replaceChildren(...next);
}
