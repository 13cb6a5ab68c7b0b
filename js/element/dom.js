/** Small tools for elements, which know no markup: texts stay texts. */

/**
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag
 * @param {{ [name: string]: string }} [attributes]
 * @param {...(Node | string)} children
 * @returns {HTMLElementTagNameMap[K]}
 */
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

const SHAPES = {
  play: "M5 3.4v9.2a.6.6 0 0 0 .92.5l7.1-4.6a.6.6 0 0 0 0-1L5.92 2.9a.6.6 0 0 0-.92.5Z",
  pause: "M4.25 3h2.5v10h-2.5zM9.25 3h2.5v10h-2.5z",
  step: "M3 3.4v9.2a.6.6 0 0 0 .92.5l6.1-4.6a.6.6 0 0 0 0-1L3.92 2.9a.6.6 0 0 0-.92.5ZM11.5 3h2v10h-2z",
  check: "m3 8.5 3.25 3.25L13 4.75",
};

/** @param {keyof typeof SHAPES} name */
export function icon(name) {
  const box = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  for (const [key, value] of Object.entries({ viewBox: "0 0 16 16", width: "16", height: "16", "aria-hidden": "true", class: `icon icon-${name}` })) {
    box.setAttribute(key, value);
  }
  path.setAttribute("d", SHAPES[name]);
  box.append(path);
  return box;
}

/**
 * Sets an attribute where it differs; `null` removes it.
 *
 * @param {Element} element
 * @param {string} name
 * @param {string | null} value
 */
export function attribute(element, name, value) {
  if (element.getAttribute(name) === value) return;
  if (value === null) element.removeAttribute(name);
  else element.setAttribute(name, value);
}

/** @param {Element} element @param {string} text */
export function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}
