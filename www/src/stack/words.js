/** Every word of stacks: more than two curves, matched pair by pair. */
import { inSentence } from "../strings.js";

export const words = {
  add: "Add a curve",
  addHelp: "Adds a curve at the end, or before the first one where that is selected",
  insert: "Insert between",
  up: (/** @type {string} */ curve) => `Move ${inSentence(curve)} up`,
  down: (/** @type {string} */ curve) => `Move ${inSentence(curve)} down`,
  remove: (/** @type {string} */ curve) => `Delete ${inSentence(curve)}`,
  moved: (/** @type {string} */ curve, /** @type {number} */ place, /** @type {number} */ of) =>
    `${curve} is curve ${place} of ${of} now`,
  movedLess: (/** @type {number} */ pins) => `, ${pins === 1 ? "1 pin" : `${pins} pins`} removed`,
  atEnd: (/** @type {string} */ curve, /** @type {"first" | "last"} */ end) => `${curve} is the ${end} one`,
  added: (/** @type {string} */ curve) => `Added ${inSentence(curve)}`,
  inserted: (/** @type {string} */ curve, /** @type {number} */ points) =>
    `Inserted ${inSentence(curve)} half way to the next, with ${points} control points`,
  noInBetween: "These two curves are not matched, so that nothing lies half way between them",
  span: "Span",
  spanChosen: (/** @type {string} */ span) => `Span ${span}`,
  noPins: "Lines of a stack are pinned in its file: fields `u`, `v` and `pair` of `matching.pins`.",
  onePath: "Paths join two curves. A stack plays as SVG with its figure, as pictures and as a film.",
};
