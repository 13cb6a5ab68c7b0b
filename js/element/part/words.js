/** What a figure of a part says to a person. */
import { counted } from "../../sentence.js";

export const words = {
  picture: "Places of the part",
  help: "Arrow keys move a mark through the part and read what is there, with Shift ten times as far. Plus and minus come nearer and go farther, F shows the whole part, Escape leaves the picture.",
  view: "View",
  nearer: "Nearer",
  farther: "Farther",
  fit: "The whole part",
  zoomed: (/** @type {string} */ share) => `Zoom ${share} %`,
  none: "Nothing to be moved",
  outside: "outside",
  percent: (/** @type {string} */ value) => `${value} %`,
  distance: (/** @type {string} */ value, /** @type {string} */ unit) => `${value} ${unit}`,
  place: (/** @type {string} */ x, /** @type {string} */ y, /** @type {string} */ what) => `x ${x}, y ${y}: ${what}`,
  spoken: (/** @type {string} */ body, /** @type {string[]} */ materials, /** @type {string[]} */ distances) => [body, ...materials, ...distances].join(", "),
  printed: "mixed by the printed rule",
  bodies: (/** @type {number} */ count) => counted(count, "body", "bodies"),
  features: (/** @type {number} */ count) => counted(count, "feature", "features"),
  skipped: (/** @type {number} */ count) => `${count} left out`,
  broken: (/** @type {number} */ count) => `${counted(count, "rule", "rules")} broken`,
  empty: "No body yet",
};
