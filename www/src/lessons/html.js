/**
 * Text of a lesson, which the build has set, in an element. The measures in formulas are put on one by one: a policy that forbids styles in
 * a text allows that.
 *
 * @template {HTMLElement} T
 * @param {T} element
 * @param {string} html
 * @returns {T}
 */
export function fill(element, html) {
  element.innerHTML = html;
  for (const part of /** @type {NodeListOf<HTMLElement>} */ (element.querySelectorAll("[data-style]"))) {
    part.style.cssText = part.dataset.style ?? "";
    delete part.dataset.style;
  }
  return element;
}
