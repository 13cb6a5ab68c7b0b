/**
 * Edits of pins from the figure and from the inspector: each ends in `commit`, and is spoken.
 *
 * @import { App } from "../state/app.js"
 * @import { Pin } from "../types.js"
 */
import { currentMatch } from "../state/app.js";
import { addPin, MOST, movePin, pinAt, pinOf, removePin, wrapped } from "./pins.js";
import { words } from "./words.js";

/** Pins of the open document. @param {App} app @returns {Pin[]} */
export const pinsOf = (app) => app.store.document.matching.pins ?? [];

/**
 * Pins a ruling line at its ends, or finds the pin that is there.
 * @param {App} app
 * @param {number} line
 * @param {string} [run]
 * @returns {number} the number of the pin, -1 when there is none
 */
export function pinLine(app, line, run) {
  const { document } = app.store;
  const match = currentMatch(app);
  const ends = match && pinOf(document, match, line);
  if (!ends) return -1;
  const there = pinAt(document, ends);
  if (there >= 0) return there;
  const index = pinsOf(app).length;
  if (index >= MOST) {
    tell(app, words.pins.full(MOST));
    return -1;
  }
  app.store.commit({ change: (now) => addPin(now, ends), ...(run === undefined ? {} : { run }) });
  app.ui.set({ line: null, pin: index });
  if (document.matching.method === "exact") app.say(words.pins.added(index));
  else tell(app, words.pins.madeExact);
  return index;
}

/**
 * Puts one end of a pin elsewhere on its curve.
 * @param {App} app
 * @param {number} index
 * @param {"u" | "v"} end
 * @param {number} value beyond the domain it goes on round the seam
 * @param {string} [run]
 */
export function putPin(app, index, end, value, run) {
  const curve = app.store.document.curves[end === "u" ? 0 : 1];
  if (!curve) return;
  const at = wrapped(curve, value);
  app.store.commit({ change: (now) => movePin(now, index, end, at), ...(run === undefined ? {} : { run }) });
}

/** @param {App} app @param {number} index */
export function dropPin(app, index) {
  app.store.commit({ change: (now) => removePin(now, index) });
  app.ui.set({ pin: null });
  app.say(words.pins.removed(index));
}

/** @param {App} app @param {string} text */
function tell(app, text) {
  app.ui.set({ note: { tone: "plain", text } });
  app.say(text);
}
