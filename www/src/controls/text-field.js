/**
 * A field for a short text: Enter and leaving commit, Escape restores, an empty text is refused.
 */
import { h } from "../dom.js";

/** Most characters of a name in a document. */
const LONGEST = 100;

/**
 * @param {{label: string, name: string, bare?: boolean}} options `bare` looks like plain text until touched
 * @param {(text: string) => void} change
 */
export function textField({ label, name, bare = false }, change) {
  let value = "";
  const input = h("input", {
    type: "text",
    class: bare ? "bare" : "",
    maxLength: LONGEST,
    autocomplete: "off",
    spellcheck: false,
    "aria-label": label,
    "data-field": name,
  });
  const element = bare ? input : h("span", { class: "field" }, input);

  const settle = () => {
    const next = input.value.trim();
    if (next !== "" && next !== value) {
      value = next;
      change(next);
    }
    input.value = value;
  };
  input.addEventListener("blur", settle);
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") input.blur();
    if (event.key === "Escape") {
      event.stopPropagation();
      input.value = value;
      input.blur();
    }
  });
  return {
    element,
    input,
    /** @param {string} text */
    set(text) {
      if (text === value) return;
      value = text;
      input.defaultValue = text;
      input.value = text;
    },
  };
}
