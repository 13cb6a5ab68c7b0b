/**
 * Select: four choices or more.
 */
import { h } from "../dom.js";

/**
 * @template {string} Value
 * @param {{label: string, name: string, choices: {value: Value, text: string}[]}} options
 * @param {(value: Value) => void} change
 */
export function select({ label, name, choices }, change) {
  const input = h(
    "select",
    { "aria-label": label, "data-select": name },
    ...choices.map(({ value, text }) => h("option", { value }, text)),
  );
  input.addEventListener("change", () => change(/** @type {Value} */ (input.value)));
  return {
    element: h("span", { class: "field select" }, input),
    /** @param {Value} value */
    set(value) {
      if (input.value !== value) input.value = value;
    },
  };
}
