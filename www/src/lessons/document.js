/**
 * The documents of a lesson's figures. Pure functions.
 *
 * @import { CurvesDocument } from "../types.js"
 * @import { Figure, Moment } from "../../../scripts/lib/lesson.mjs"
 * @import { Steps } from "../../../js/directrix.js"
 */
import { lengths, totalOf } from "../steps/film.js";
import { firstState } from "./body-edits.js";
import { firstPart } from "./part-known.js";

/**
 * The document of a figure with its changes, and with the layers and the in-between curve that it shows.
 * @param {unknown} source the preset, or the open document of the person
 * @param {Figure} figure
 * @returns {CurvesDocument} with its defaults still to be filled in
 */
export function figureDocument(source, figure) {
  const { changes, layers, s, view: kind } = figure;
  if (kind === "body") return /** @type {any} */ (firstState(/** @type {any} */ (source), figure));
  if (kind === "part" || kind === "grid") return /** @type {any} */ (firstPart(/** @type {any} */ (source), figure));
  if (kind === "laplace") return structuredClone(/** @type {any} */ (source));
  const document = structuredClone(/** @type {any} */ (source));
  for (const [path, value] of changes) {
    const keys = path.split(".");
    const last = keys.pop() ?? "";
    let place = document;
    for (const key of keys) place = place[key] ??= {};
    place[last] = value;
  }
  const { layers: own, s: at, ...view } = document.view ?? {};
  const shown = { ...view, ...(layers ? { layers } : own ? { layers: own } : {}), ...(s === null ? (at === undefined ? {} : { s: at }) : { s }) };
  return { ...document, ...(Object.keys(shown).length > 0 ? { view: shown } : {}) };
}

/**
 * The step of a trace that a moment stands for; the nearest one of its phase where the curves are others.
 * @param {Steps} steps
 * @param {Moment | null} moment
 * @returns {number}
 */
export function momentOf(steps, moment) {
  const { growth, removal, first, second } = lengths(steps);
  const { phase, index } = moment ?? { phase: "start", index: 1 };
  const within = (/** @type {number} */ before, /** @type {number} */ count) => before + Math.min(index === "last" ? count : index, count);
  if (phase === "start") return 0;
  if (phase === "growth") return within(0, growth);
  if (phase === "removal") return within(growth, removal);
  if (phase === "insertion") return within(growth + removal, first + second);
  return totalOf(steps);
}

/** What a figure without in-between curve and without steps shows, to be opened in the editor. @param {object | null} document */
export const shownState = (document) => document && { document: /** @type {CurvesDocument} */ (document), s: null, step: null };
