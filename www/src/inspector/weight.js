/**
 * A slider with a field beside it for the same number.
 *
 * @import { Control } from "../controls/row.js"
 * @import { Editing } from "../controls/run.js"
 */
import { numberField } from "../controls/number-field.js";
import { slider } from "../controls/slider.js";

/**
 * @param {object} options
 * @param {string} options.label
 * @param {string} options.name
 * @param {number} options.min
 * @param {number} options.reach end of the slider; the field goes on to `max`
 * @param {number} options.max
 * @param {number} options.step
 * @param {boolean} [options.whole]
 * @param {Editing<number>} editing
 * @returns {{controls: [Control, Control], set: (value: number) => void}}
 */
export function weight({ label, name, min, reach, max, step, whole = false }, editing) {
  const track = slider({ label, name, min, max: reach, step }, editing);
  const field = numberField({ label, name, min, max, step, decimals: whole ? 0 : 1, whole }, editing);
  field.element.classList.add("short");
  return {
    controls: [track, field],
    set(value) {
      track.set(value);
      field.set(value);
    },
  };
}
