/** Words of what commands on curves have done, and of the menu of what lies under the pointer. */
import { inSentence, plural } from "../strings.js";

export const words = {
  smoothed: (/** @type {string} */ curve, /** @type {number} */ points) =>
    `${curve} is smooth now, with ${plural(points, "control point", "control points")}`,
  doubled: (/** @type {string} */ name) => `Doubled ${name}`,
  copied: (/** @type {string} */ curve) => `Copied to ${inSentence(curve)}`,
  swapped: "Swapped the curves",
  reversed: (/** @type {string} */ curve) => `Reversed ${inSentence(curve)}`,
  deleted: (/** @type {string} */ curve) => `Deleted ${inSentence(curve)}`,
  menu: "Commands",
  addPoint: "Add to the selection",
  dropPoint: "Take out of the selection",
};
