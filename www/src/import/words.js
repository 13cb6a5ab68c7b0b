/** Every word of the import of shapes. */
import { inSentence, plural } from "../strings.js";

export const words = {
  heading: (/** @type {string} */ file) => `Import: ${file}`,
  shapes: "Shapes",
  skipped: (/** @type {number} */ count) => `${count} skipped`,
  tolerance: "Tolerance",
  percent: (/** @type {string} */ value) => `${value}\u00a0%`,
  corners: "Corners",
  keep: "Keep",
  smooth: "Smooth",
  through: "Through the points",
  center: "Centre at the origin",
  points: (/** @type {number} */ count) => plural(count, "point", "points"),
  wasOpen: ", open ends joined",
  fitting: "Fitting",
  controls: (/** @type {number} */ points) => plural(points, "control point", "control points"),
  error: (/** @type {string} */ error, /** @type {string} */ unit) => `error ${error}\u00a0${unit}`,
  exact: "exact",
  crosses: "It crosses itself",
  place: (/** @type {string[]} */ size, /** @type {string} */ unit, /** @type {string[] | null} */ middle) =>
    `${size[0]} × ${size[1]}\u00a0${unit} about ${middle ? `(${middle.join(", ")})` : "the origin"}; one unit of the drawing is one ${unit}.`,
  open: "Open as new document",
  replace: (/** @type {string} */ curve) => `Replace ${inSentence(curve)}`,
  add: "Add as a curve",
  addInside: "Add inside",
  chooseOne: "To replace a curve, choose one shape.",
  chooseSome: "Choose one shape or more.",
  stack: "These shapes lie in each other: a stack of curves, from the inside out.",
  harmonic: "More than two shapes, not each in the next: a harmonic blend, with the largest one outside.",
  noRoom: "There is no room inside for this shape; take “Centre at the origin” off to put it where it was drawn.",
  found: (/** @type {number} */ shapes, /** @type {number} */ skipped) =>
    `${plural(shapes, "shape", "shapes")} found${skipped > 0 ? `, ${skipped} skipped` : ""}`,
  nothing: "it holds no closed shape",
  onlySkipped: (/** @type {string} */ name, /** @type {string} */ reason, /** @type {number} */ count) =>
    `it holds no closed shape: ${name}: ${reason}${count > 1 ? ` (and ${count - 1} more)` : ""}`,
  opened: (/** @type {string} */ title) => `Opened ${title}`,
  placed: (/** @type {string} */ curve, /** @type {number} */ points) =>
    `${curve} now has ${plural(points, "control point", "control points")}`,
  elsewhere: "shapes are for curves and for parts; open one of them first",
  inSpace: "shapes lie in the plane, and the curves of this document in space; open a new one first",
};
