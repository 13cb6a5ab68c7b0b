/** A select whose choices change with the document. */
import { h } from "../../dom.js";

/**
 * @param {{label: string, name: string}} options
 * @param {(value: string) => void} change
 */
export function picker({ label, name }, change) {
  const input = h("select", { "aria-label": label, "data-select": name });
  input.addEventListener("change", () => change(input.value));
  let drawn = "";
  return {
    element: h("span", { class: "field select" }, input),
    input,
    /** @param {string} value @param {readonly {value: string, text: string, disabled?: boolean}[]} choices */
    set(value, choices) {
      const next = JSON.stringify(choices);
      if (next !== drawn) {
        drawn = next;
        input.replaceChildren(...choices.map((each) => h("option", { value: each.value, disabled: each.disabled === true }, each.text)));
      }
      if (input.value !== value) input.value = value;
    },
  };
}
