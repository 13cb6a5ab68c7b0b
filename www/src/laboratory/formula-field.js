/**
 * A line in which the numbers or formulas of a condition are written, one for each material, with a comma between them. It takes effect with Enter or when it is left.
 */
import { attribute, h, write } from "../dom.js";
import { parse } from "../format.js";

/** Most characters of a line. */
const LONGEST = 1000;

/**
 * @param {{name: string, label: string, note: string}} options
 * @param {(list: (number | string)[]) => void} change
 */
export function formulaField({ name, label, note }, change) {
  let shown = "";
  const input = h("input", { type: "text", maxLength: LONGEST, autocomplete: "off", spellcheck: false, "aria-label": label, "data-field": name });
  const about = h("p", { class: "lab-note", id: `${name}-note` }, note);
  attribute(input, "aria-describedby", about.id);
  const settle = () => {
    if (input.value.trim() === shown) return;
    shown = input.value.trim();
    change(listOf(shown));
  };
  input.addEventListener("blur", settle);
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") settle();
    if (event.key !== "Escape") return;
    event.stopPropagation();
    input.value = shown;
    input.blur();
  });
  const field = h("span", { class: "field" }, input);
  const element = h("details", { class: "lab-formula" }, h("summary", {}, label), h("div", {}, field, about));
  return {
    element,
    /** @param {(number | string)[]} list @param {boolean} isOpen whether it has to be seen */
    render(list, isOpen) {
      if (isOpen) element.open = true;
      const text = textOf(list);
      if (text === shown) return;
      shown = text;
      input.value = text;
      write(about, note);
    },
  };
}

/** Numbers and formulas as a line. @param {readonly (number | string)[]} list */
export const textOf = (list) => list.join(", ");

/**
 * A line as numbers and formulas; commas within brackets part nothing.
 * @param {string} text
 * @returns {(number | string)[]}
 */
export function listOf(text) {
  /** @type {string[]} */
  const parts = [""];
  let depth = 0;
  for (const sign of text) {
    if (sign === "(") depth += 1;
    if (sign === ")") depth -= 1;
    if (sign === "," && depth === 0) parts.push("");
    else parts[parts.length - 1] += sign;
  }
  return parts.map((part) => parse(part) ?? part.trim());
}
