/** The spans of a stack: neighbours as documents of two curves. Imports errors alone, so that the page takes them apart as the package does. */
import { DirectrixError } from "./errors.js";

/**
 * The document of curve `span` and the next one, with their counts and pins; blends of two curves are `ruled`.
 *
 * @template {import("./directrix.js").CurvesDocument} T
 * @param {T} document with its counts where it has a sampling
 * @param {number} span
 * @returns {T}
 * @throws {DirectrixError} when there is no such span
 */
export function spanOf(document, span) {
  const { curves, sampling, matching, blend } = document;
  if (!Number.isInteger(span) || span < 0 || span > curves.length - 2) {
    const expected = curves.length < 2 ? "a document of two curves or more" : `a whole number from 0 to ${curves.length - 2}`;
    throw new DirectrixError("range", "span", `${String(span)} was found; expected ${expected}`);
  }
  const own = matching.pins?.filter(({ pair = 0 }) => pair === span).map(({ u, v }) => ({ u, v }));
  return {
    ...document,
    curves: curves.slice(span, span + 2),
    ...(sampling ? { sampling: { ...sampling, ...(sampling.counts ? { counts: sampling.counts.slice(span, span + 2) } : {}) } } : {}),
    matching: { ...matching, ...(own ? { pins: own } : {}) },
    ...(blend ? { blend: { ...blend, kind: "ruled" } } : {}),
  };
}
