/** What the controls and readings of figures are made of: labels, sliders with their values, and numbers that the text can name. */
import { slider } from "../controls/slider.js";
import { attribute, h, write } from "../dom.js";

/** @param {string} text */
export const label = (text) => h("span", { class: "cell-label" }, text);

/** A number in the line above a figure. @param {string} text @param {string} value @param {string} name for the text of the lesson */
export const measure = (text, value, name) => h("span", {}, `${text} `, h("span", { class: "strong number", "data-lesson": name }, value));

/** A row of a list of numbers. @param {string} text @param {string} name for the text of the lesson @param {...(string | Node)} value */
export const fact = (text, name, ...value) => [h("dt", {}, text), h("dd", { class: "number", "data-lesson": name }, ...value)];

/**
 * A slider between its label and its value.
 * @param {object} options
 * @param {string} options.label
 * @param {Node} [options.shown] in place of the label
 * @param {string} options.name
 * @param {number} [options.min]
 * @param {number} options.max
 * @param {number} options.step
 * @param {(value: number) => void} change
 */
export function parameter({ label: text, shown = label(text), name, min = 0, max, step }, change) {
  const control = slider({ label: text, name: `lesson-${name}`, min, max, step }, { change });
  const value = h("span", { class: "number strong", "data-lesson": name });
  return {
    row: h("div", { class: "cell-parameter" }, shown, control.element, value),
    value,
    setMax: control.setMax,
    /** @param {number} next @param {string} said */
    set(next, said) {
      control.set(next);
      write(value, said);
      attribute(control.input, "aria-valuetext", said);
    },
  };
}
