/**
 * The blend that is looked at: two closed curves can be seen with the blend that the document does not have, which changes nothing in it.
 *
 * @import { App } from "./app.js"
 * @import { CurvesDocument } from "../types.js"
 */

/** Lines along the gradient and segments of each curve, where a document that has another blend names none (`docs/format.md`). */
const LINES = 44;
const SEGMENTS = 200;

/** @param {CurvesDocument} document */
export const isHarmonic = ({ blend }) => blend.kind === "harmonic";

/** Whether a document can be seen with either blend. @param {CurvesDocument} document */
export const hasLooks = ({ curves }) => curves.length === 2 && curves.every(({ form }) => form !== "open");

/** @type {WeakMap<CurvesDocument, CurvesDocument>} */
const known = new WeakMap();

/**
 * The document with the blend that the figure shows; the same object for the same document.
 * @param {Pick<App, "store" | "ui">} app
 * @returns {CurvesDocument}
 */
export function lookedAt({ store: { document }, ui }) {
  const { look, mode } = ui.value;
  if (!look || mode !== "figure" || isHarmonic(document) === (look === "harmonic") || !hasLooks(document)) return document;
  const other = known.get(document) ?? withBlend(document, look);
  known.set(document, other);
  return other;
}

/**
 * A document with another blend, whose own numbers are written out.
 * @param {CurvesDocument} document
 * @param {CurvesDocument["blend"]["kind"]} kind
 * @returns {CurvesDocument}
 */
export function withBlend(document, kind) {
  const own = kind === "harmonic" ? { lines: LINES, segments: SEGMENTS } : {};
  return { ...document, blend: { ...own, ...document.blend, kind } };
}
