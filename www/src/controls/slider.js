/**
 * A slider: one press and drag is one run of edits, and so are key presses that follow each other.
 *
 * @import { Editing } from "./run.js"
 */
import { h } from "../dom.js";
import { newRun } from "./run.js";

/**
 * @param {{label: string, name: string, min: number, max: number, step: number}} options
 * @param {Editing<number>} editing
 */
export function slider({ label, name, min, max, step }, editing) {
  let run = newRun(name);
  const input = h("input", { type: "range", "aria-label": label, "data-slider": name });
  input.min = String(min);
  input.max = String(max);
  input.step = String(step);
  const element = h("span", { class: "slider" }, input);
  const end = () => {
    run = newRun(name);
    editing.end?.();
  };
  input.addEventListener("input", () => editing.change(Number(input.value), run));
  input.addEventListener("pointerup", end);
  input.addEventListener("blur", end);
  input.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !editing.cancel) return;
    editing.cancel(run);
    run = newRun(name);
  });

  return {
    element,
    input,
    /** @param {number} value a value past the end leaves the thumb at the end */
    set(value) {
      const inside = Math.min(max, Math.max(min, value));
      if (Number(input.value) !== inside) input.value = String(inside);
      element.style.setProperty("--fill", String((inside - min) / (max - min)));
    },
    /** @param {number} last */
    setMax(last) {
      max = last;
      input.max = String(last);
    },
  };
}
