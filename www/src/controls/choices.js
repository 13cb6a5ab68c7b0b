/**
 * Segment (two or three choices) and check box.
 */
import { h } from "../dom.js";

/**
 * @template {string} Value
 * @param {{label: string, name: string, choices: {value: Value, text: string}[]}} options
 * @param {(value: Value) => void} change
 */
export function segment({ label, name, choices }, change) {
  const inputs = choices.map(({ value }) =>
    h("input", {
      type: "radio",
      name,
      value,
      onchange: () => change(value),
    }),
  );
  const element = h(
    "span",
    { class: "segment", role: "radiogroup", "aria-label": label, "data-segment": name },
    ...choices.map(({ text }, i) => h("label", {}, inputs[i], h("span", {}, text))),
  );
  return {
    element,
    /** @param {Value} value */
    set(value) {
      for (const input of inputs) input.checked = input.value === value;
    },
  };
}

/**
 * @param {{name: string, text: (Node | string)[]}} options
 * @param {(on: boolean) => void} change
 */
export function checkBox({ name, text }, change) {
  const input = h("input", { type: "checkbox", "data-box": name });
  input.addEventListener("change", () => change(input.checked));
  const element = h("label", { class: "box" }, input, h("span", {}, ...text));
  return {
    element,
    /** @param {boolean} on */
    set(on) {
      input.checked = on;
    },
  };
}
