/** Every word of drawing. */
import { inSentence, plural } from "../strings.js";

export const words = {
  region: "Drawing",
  mode: "How to draw",
  points: "Points",
  freehand: "Freehand",
  replaces: (/** @type {string} */ curve) => `This replaces the ${inSentence(curve)} curve and keeps its composition.`,
  start: "Click to set the first point.",
  more: (/** @type {number} */ missing) => `Click on; ${plural(missing, "more point", "more points")} to close.`,
  close: "Click on, or close with Enter, a double click or a click on the first point.",
  touchStart: "Tap to set the first point.",
  touchMore: (/** @type {number} */ missing) => `Tap on; ${plural(missing, "more point", "more points")} to close.`,
  touchClose: "Tap on, or close with a tap on the first point.",
  stroke: "Press, draw one closed line, and let go.",
  tooShort: "That line is too short. Press and draw once round.",
  fitting: "Fitting a curve to the line",
  flat: "These points lie on one line. Set one beside it.",
  back: "Back",
  finish: "Close",
  cancel: "Cancel",
  keyboard: "Canvas for drawing",
  help:
    "Arrow keys move the crosshair, with Shift far, with Alt finely. Space sets a point, Backspace takes the last one " +
    "back, Enter closes the curve, Escape gives up.",
  cross: (/** @type {string} */ x, /** @type {string} */ y) => `x ${x}, y ${y}`,
  set: (/** @type {number} */ count, /** @type {string} */ x, /** @type {string} */ y) => `Point ${count}, x ${x}, y ${y}`,
  taken: (/** @type {number} */ left) => `Point taken back, ${left} left`,
  done: (/** @type {string} */ curve, /** @type {number} */ points) =>
    `Drew ${inSentence(curve)} with ${plural(points, "control point", "control points")}`,
  gaveUp: "Drawing given up",
};

/** Words of drawing an open curve. */
export const openWords = {
  finish: "Finish",
  leave: "Leave open",
  more: "Click on; 1 more point to finish.",
  close: "Click on, or finish with Enter or a double click.",
  touchMore: "Tap on; 1 more point to finish.",
  touchClose: "Tap on, or finish with the button.",
  either: "Click on, close with Enter or a click on the first point, or leave it open with Shift and Enter.",
  touchEither: "Tap on, close with a tap on the first point, or leave it open.",
  stroke: "Press, draw one line from end to end, and let go.",
  tooShort: "That line is too short. Press and draw from end to end.",
};
