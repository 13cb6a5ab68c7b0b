/** Every word of the harmonic blend on the page. */
import { inSentence } from "../strings.js";

/** Names in a sentence. @param {string[]} names */
const listed = (names) => (names.length < 2 ? names.join("") : `${names.slice(0, -1).join(", ")} and ${names[names.length - 1]}`);

export const words = {
  kind: "Harmonic",
  lines: "Lines",
  linesField: "Lines along the gradient",
  segments: "Segments",
  segmentsField: "Segments of each curve",
  look: "Look at",
  looks: { ruled: "Linear", harmonic: "Harmonic", difference: "Difference" },
  lookHelp: "How the same curves look with either blend; the document keeps its own.",
  looking: {
    ruled: "Shown with the linear blend along ruling lines",
    harmonic: "Shown with the harmonic blend",
    difference: "Shown: how far the harmonic blend is from the linear one",
  },
  /** What the groups of the matching say where the blend does not need them. */
  unusedMatching: "The harmonic blend does not use the matching.",
  unusedSampling: "The harmonic blend does not use samples; it has segments of its own.",
  usedBeside: "Only the linear blend beside it does.",

  add: "Add a curve inside",
  addHelp: "Adds a circle where there is most room between the curves",
  added: (/** @type {string} */ name) => `Added ${inSentence(name)} inside`,
  copied: (/** @type {string} */ name) => `Copied to ${inSentence(name)}, where there is room`,
  noRoom: "There is no room for another curve inside",

  status: {
    segments: (/** @type {number} */ count) => (count === 1 ? "segment" : "segments"),
    lines: (/** @type {number} */ count) => (count === 1 ? "gradient line" : "gradient lines"),
    crossings: "crossings",
    lost: "lines lost",
    balance: "flow balanced to",
    iterations: (/** @type {number} */ count) => (count === 1 ? "iteration, residual" : "iterations, residual"),
    shown: (/** @type {string} */ place) => `Shown: ${place}`,
    place: "Show the place",
  },
  faults: {
    "open-curves": (/** @type {string[]} */ names) =>
      `${listed(names)} ${names.length === 1 ? "is" : "are"} open: the harmonic blend lies between closed curves.`,
    "curves-meet": (/** @type {string[]} */ names, /** @type {string} */ where) =>
      `${listed(names)} touch${where}. Move one away, or undo.`,
    "no-outer": (/** @type {string[]} */ names, /** @type {string} */ where) =>
      `No curve contains all others: ${listed(names)} lie in none. Move one inside${where === "" ? "" : `, see${where}`}.`,
    nested: (/** @type {string[]} */ [inner, outer]) =>
      `${inner} lies inside ${inSentence(outer)}, an inner curve: inner curves lie side by side. Move it out, or delete one.`,
    "coarse-sampling": (/** @type {string[]} */ _, /** @type {string} */ where) => `The segments meet${where} although the curves do not. Raise their number.`,
    "no-field": (/** @type {string[]} */ _, /** @type {string} */ where) => `The heat flow could not be computed${where}. Raise the segments, or move the curves apart.`,
  },
  remarks: {
    "heights-ignored": "Heights do not count: the blend lies in one plane.",
    "lost-lines": "Some gradient lines did not arrive. Raise the segments.",
  },
  several: (/** @type {string[]} */ names) => `${listed(names)} lie side by side in one curve: ruling lines join a curve with one other.`,
  use: "Use the harmonic blend",
  used: "The blend is harmonic now",

  noWhy: "Lines of the harmonic blend follow the gradient; there is no choice to be explained",
  modes: {
    steps: "Steps show how ruling lines are found. The harmonic blend has none: it is the flow of heat between the curves, solved at once.",
    compare: "Compare sets methods of matching side by side. The harmonic blend needs no matching; the difference from the linear blend is in the group Blend.",
    solid: "The solid is spanned by ruling lines between curves at different heights. The harmonic blend lies in one plane.",
  },
  refused: "Not with a harmonic blend",
  toFigure: "Back to the figure",

  difference: "Difference",
  differenceNumbers: (/** @type {string} */ largest, /** @type {string} */ mean) => `largest ${largest}, mean ${mean}`,
  mean: (/** @type {string} */ mean) => `mean ${mean}`,
  noRuled: "The linear blend is not complete here, so there is nothing to compare with.",

  tables: { lines: "Gradient lines", stages: "Level curves" },
  tableNotes: {
    lines: "One row for each point of the lines along the gradient, with the inner curve each starts from.",
    stages: "One row for each point of the level curves of the potential; a level may be several loops.",
  },
  noBlend: "there is no harmonic blend of these curves",
  noCells: "Unit cells lie between ruling lines, which the harmonic blend does not have.",
  noSolid: "The solid is spanned by ruling lines, which the harmonic blend does not have.",
  noPaths: "Paths follow ruling lines, which the harmonic blend does not have. It plays as pictures and as a film.",
  noShape: "The shape alone follows ruling lines; a level of the harmonic blend may be several loops",
  noPlaying: "an animated SVG follows ruling lines, which the harmonic blend does not have; it plays as pictures and as a film",
};
