/** Every word of drawing shapes. */
import { plural } from "../../strings.js";

/** @typedef {import("./drawing.js").Drawn} Drawn */

/** @type {{[drawn in Drawn]: string}} */
export const KINDS = {
  polygon: "Polygon",
  circle: "Circle",
  closed: "Closed curve",
  point: "Point",
  segment: "Segment",
  line: "Line",
  polyline: "Polyline",
  open: "Open curve",
};

export const words = {
  draw: "Draw",
  region: "Drawing",
  kind: "Kind of shape",
  as: "What it is for",
  reference: "Reference",
  body: "Body",
  hole: "Hole",
  back: "Back",
  close: "Close",
  finish: "Finish",
  cancel: "Cancel",
  keyboard: "Canvas for drawing",
  help:
    "Arrow keys move the crosshair, with Shift far, with Alt finely. Space sets a point, Backspace takes the last one back, Enter finishes the shape, " +
    "Escape gives up.",
  /** @param {Drawn} drawn @param {number} count of points that are set @param {number} fewest @param {boolean} touch */
  hint(drawn, count, fewest, touch) {
    const act = touch ? "Tap" : "Click";
    if (drawn === "point") return `${act} where it is to be.`;
    if (drawn === "circle") return count === 0 ? `${act} the centre, or drag from it to the rim.` : `${act} the rim.`;
    if (drawn === "line") return count === 0 ? `${act} a point of it, or drag along it.` : `${act} another point of it.`;
    if (drawn === "segment") return count === 0 ? `${act} where it starts, or drag to its end.` : `${act} where it ends.`;
    const curved = drawn === "closed" || drawn === "open";
    if (count === 0) return curved ? `${act} to set the first point, or draw it in one stroke.` : `${act} to set the first point.`;
    const closes = drawn === "polygon" || drawn === "closed";
    if (count < fewest) return `${act} on; ${plural(fewest - count, "more point", "more points")} to ${closes ? "close" : "finish"}.`;
    if (touch) return closes ? "Tap on, or close with a tap on the first point." : "Tap on, or finish with the button.";
    return closes ? "Click on, or close with Enter, a double click or a click on the first point." : "Click on, or finish with Enter or a double click.";
  },
  tooShort: "That stroke is too short.",
  fitting: "Fitting a curve to the stroke",
  flat: "These points lie on one line. Set one beside it.",
  same: "It needs another place for this point.",
  mostShapes: "A part has 500 shapes at most.",
  mostPoints: "The shapes of a part have 10 000 points at most.",
  mostBodies: "A part has 64 bodies at most.",
  mostHoles: "A body has 100 holes at most.",
  noBody: "There is no body to cut it out of.",
  cross: (/** @type {string} */ x, /** @type {string} */ y) => `x ${x}, y ${y}`,
  set: (/** @type {number} */ count, /** @type {string} */ x, /** @type {string} */ y) => `Point ${count}, x ${x}, y ${y}`,
  taken: (/** @type {number} */ left) => `Point taken back, ${left} left`,
  done: (/** @type {string} */ name) => `Drew ${name}`,
  cut: (/** @type {string} */ name, /** @type {string} */ body) => `Drew ${name}, cut out of ${body}`,
  gaveUp: "Drawing given up",
};
