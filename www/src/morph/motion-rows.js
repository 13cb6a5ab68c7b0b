/**
 * Seconds, easing and repeat of the morph, in the group Blend and where it is exported.
 *
 * @import { App } from "../state/app.js"
 * @import { Motion } from "./motion.js"
 */
import { segment } from "../controls/choices.js";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { h } from "../dom.js";
import { LONGEST, SHORTEST } from "./motion.js";
import { words } from "./words.js";

/**
 * @param {App} app
 * @param {string} place part of the names of the controls
 */
export function motionRows(app, place) {
  const change = (/** @type {Partial<Motion>} */ patch) => app.ui.set({ motion: { ...app.ui.value.motion, ...patch } });
  const seconds = numberField(
    { label: words.secondsLabel, name: `${place}-seconds`, min: SHORTEST, max: LONGEST, step: 0.5, decimals: 1 },
    { change: (value) => change({ seconds: value }) },
  );
  const easing = segment(
    {
      label: words.easing,
      name: `${place}-easing`,
      choices: /** @type {const} */ (["linear", "ease"]).map((value) => ({ value, text: words.easings[value] })),
    },
    (value) => change({ easing: value }),
  );
  const repeat = segment(
    {
      label: words.repeatLabel,
      name: `${place}-repeat`,
      choices: /** @type {const} */ (["once", "loop", "swing"]).map((value) => ({ value, text: words.repeats[value] })),
    },
    (value) => change({ repeat: value }),
  );
  const duration = row(words.seconds, seconds);
  return {
    /** The row of the seconds, which pictures without times do without. */
    duration,
    element: h(
      "div",
      { "data-motion": place },
      duration,
      row(words.easing, easing),
      row(words.repeat, repeat),
    ),
    render() {
      const { motion } = app.ui.value;
      seconds.set(motion.seconds);
      easing.set(motion.easing);
      repeat.set(motion.repeat);
    },
  };
}
