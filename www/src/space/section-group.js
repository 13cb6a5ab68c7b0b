/**
 * The rows of the group Section beside a body.
 *
 * @import { Section, SectionAxis } from "./section.js"
 *
 * @typedef {object} SectionWords
 * @property {string} axis
 * @property {Readonly<{[axis in SectionAxis]: string}>} axes
 * @property {string} at
 * @property {string} field
 * @property {string} other
 * @property {string} off
 * @property {(axis: string, place: string) => string} value
 *
 * @typedef {object} SectionNow
 * @property {Section} section
 * @property {[number, number] | null} extent of the plane's way
 * @property {string} unit
 */
import { checkBox, segment } from "../controls/choices.js";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { slider } from "../controls/slider.js";
import { h } from "../dom.js";
import { fixed } from "../format.js";
import { placeOf, shareOf } from "./section.js";

/** Largest coordinate that is taken, and steps of the slider. */
const FAR = 1e12;
const STEP = 0.001;

/**
 * Where the plane stands, in words.
 * @param {SectionWords} words
 * @param {SectionAxis} axis
 * @param {number} place
 * @param {string} unit
 */
export const sectionText = (words, axis, place, unit) => words.value(axis, `${fixed(place, 1)}\u00a0${unit}`.trim());

/**
 * @param {object} options
 * @param {string} options.name before the names of the controls
 * @param {SectionWords} options.words
 * @param {() => number} options.step of the field by keys
 * @param {number} options.decimals
 * @param {() => SectionNow} now
 * @param {(section: Section) => void} write
 */
export function sectionRows({ name, words, step, decimals }, now, write) {
  const change = (/** @type {Partial<Section>} */ patch) => write({ ...now().section, ...patch });
  const axis = segment(
    { label: words.axis, name: `${name}-axis`, choices: /** @type {const} */ (["off", "x", "y", "z", "view"]).map((value) => ({ value, text: words.axes[value] })) },
    (value) => change({ axis: /** @type {SectionAxis} */ (value) }),
  );
  const place = slider({ label: words.field, name: `${name}-at`, min: 0, max: 1, step: STEP }, { change: (at) => change({ at }) });
  const field = numberField(
    { label: words.field, name: `${name}-place`, min: -FAR, max: FAR, step, decimals, rounded: true },
    {
      change(value) {
        const { extent, section } = now();
        if (extent) change({ at: shareOf(value, extent, section.axis) });
      },
    },
  );
  field.element.classList.add("short");
  const other = checkBox({ name: `${name}-other`, text: [words.other] }, (flipped) => change({ flipped }));
  /** What is there while the plane is on. */
  const on = h("div", {}, row(words.at, place, field), row("", other));
  return {
    element: h("div", {}, row(words.axis, axis), on),
    on,
    phrase() {
      const { section, extent, unit } = now();
      return section.axis === "off" || !extent ? words.off : sectionText(words, section.axis, placeOf(section.at, extent, section.axis), unit);
    },
    render() {
      const { section, extent, unit } = now();
      axis.set(section.axis);
      on.hidden = section.axis === "off";
      place.set(section.at);
      other.set(section.flipped);
      if (!extent || section.axis === "off") return;
      const value = placeOf(section.at, extent, section.axis);
      field.set(Number(value.toPrecision(9)));
      place.input.setAttribute("aria-valuetext", sectionText(words, section.axis, value, unit));
    },
  };
}
