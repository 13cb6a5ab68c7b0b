/**
 * Numbers that the text of a lesson may state, each with what the kernel says about the figure of the step. The tests hold every stated
 * number against it.
 *
 * @import { Directrix } from "../../js/directrix.js"
 *
 * @typedef {object} Question What a fact is asked about.
 * @property {Directrix} dx
 * @property {any} document of the figure, with its changes
 * @property {"figure" | "steps"} view
 *
 * @typedef {object} FactKind
 * @property {number} arguments numbers behind its name
 * @property {string} meaning
 * @property {(question: Question, ...numbers: number[]) => number} of
 */

/** What the figure shows: of the greedy growth where it shows that. @param {Question} question */
const result = ({ dx, document, view }) => (view === "steps" ? dx.steps(document) : dx.match(document));

/** @param {Question} question */
const totals = (question) => {
  const { pairs, lines } = result(question).totals;
  return /** @type {any} */ (pairs ?? lines);
};

/** η by another method, with everything else the same. @param {string} method @returns {FactKind} */
const eta = (method) => ({
  arguments: 0,
  meaning: `η of the same curves by the method ${method}`,
  of: ({ dx, document }) => totals({ dx, document: { ...document, matching: { ...document.matching, method } }, view: "figure" }).eta,
});

/** A line of the growth, counted from 1. @param {Question} question @param {number} number */
function grown({ dx, document }, number) {
  const line = dx.steps(document).growth[number - 1];
  if (!line) throw new RangeError(`the growth has no line ${number}`);
  return line;
}

/** What the start of line number `number` sees and may have just before it is accepted. @param {Question} question @param {number} number */
const setsOf = (question, number) =>
  question.dx.sets(question.document, { step: number - 1, vertex: grown(question, number).from });

/**
 * The fraction of a material at the share s of every line, if it is the same on all of them.
 * @param {Question} question
 * @param {number} material from 1
 * @param {number} s
 */
function fraction({ dx, document }, material, s) {
  const all = dx.match(document).pairs.map(({ from, to }) => {
    const place = dx.probe(document, [from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])]);
    return place?.fractions[material - 1] ?? NaN;
  });
  const [first = NaN] = all;
  if (!all.every((each) => Math.abs(each - first) < 1e-6)) throw new RangeError(`the fraction of material ${material} differs along s = ${s}`);
  return first;
}

/** @type {{[name: string]: FactKind}} */
export const FACTS = {
  samples: { arguments: 1, meaning: "samples of curve 1 or 2", of: (question, curve) => result(question).samples[curve - 1]?.points.length ?? NaN },
  materials: { arguments: 0, meaning: "materials of the document", of: ({ document }) => document.materials.length },
  stages: { arguments: 0, meaning: "steps from one curve to the other", of: ({ document }) => document.blend.stages },
  "in-betweens": { arguments: 0, meaning: "in-between curves", of: ({ document }) => document.blend.stages - 1 },
  fraction: { arguments: 2, meaning: "fraction of a material (from 1) at a share s of every line", of: fraction },
  lines: { arguments: 0, meaning: "ruling lines", of: (question) => totals(question).count },
  crossings: { arguments: 0, meaning: "crossings of lines", of: (question) => totals(question).crossings },
  blocked: { arguments: 0, meaning: "lines that run through a curve", of: (question) => totals(question).blocked },
  eta: { arguments: 0, meaning: "η", of: (question) => totals(question).eta },
  gap: { arguments: 0, meaning: "how far J stays below the optimum", of: (question) => result(question).gap ?? NaN },
  "eta-parameter": eta("parameter"),
  "eta-shift": eta("shift"),
  "eta-greedy": eta("greedy"),
  "eta-exact": eta("exact"),
  growth: { arguments: 0, meaning: "lines that the growth accepts", of: ({ dx, document }) => dx.steps(document).growth.length },
  before: { arguments: 1, meaning: "lines accepted before this one", of: (question, number) => (grown(question, number), number - 1) },
  removed: { arguments: 0, meaning: "redundant lines that are removed", of: ({ dx, document }) => dx.steps(document).removed.length },
  "lines-left": { arguments: 0, meaning: "lines after the removal", of: ({ dx, document }) => dx.steps(document).lines.length },
  inserted: { arguments: 0, meaning: "ends that move to new vertices", of: ({ dx, document }) => dx.steps(document).inserted.length },
  f: { arguments: 1, meaning: "f of a line of the growth", of: (question, number) => grown(question, number).value },
  from: { arguments: 1, meaning: "vertex where a line of the growth starts", of: (question, number) => grown(question, number).from },
  to: { arguments: 1, meaning: "vertex where a line of the growth ends", of: (question, number) => grown(question, number).to },
  visible: { arguments: 1, meaning: "size of V where a line of the growth starts", of: (question, number) => setsOf(question, number).visible.length },
  valid: { arguments: 1, meaning: "size of R there", of: (question, number) => setsOf(question, number).valid.length },
  candidates: {
    arguments: 1,
    meaning: "size of V ∩ R there",
    of: (question, number) => setsOf(question, number).visible.filter(({ candidate }) => candidate).length,
  },
};

/**
 * Whether a number as it stands in a text is what the kernel says, to the digits that are shown.
 * @param {string} shown such as `0.969`, `2.9 %` or `44`
 * @param {number} value
 */
export function isTrue(shown, value) {
  const found = /^(-?\d+)(?:\.(\d+))?( %)?$/.exec(shown.replace("\u2212", "-").replace("\u00a0", " "));
  if (!found) return false;
  const [, whole = "", decimals = "", percent] = found;
  const stated = Number(`${whole}.${decimals || "0"}`) / (percent ? 100 : 1);
  const isCount = decimals === "" && !percent;
  return Math.abs(stated - value) <= (isCount ? 0 : 0.5001 * 10 ** -(decimals.length + (percent ? 2 : 0)));
}
