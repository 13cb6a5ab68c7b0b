/**
 * The ruling lines as the picture shows them: one-to-one pairs where there are pairs, else the lines between samples.
 *
 * @import { Match, Point, Totals } from "../types.js"
 *
 * @typedef {{from: Point, to: Point, value: number}} Line
 */

/** @type {WeakMap<Match, Line[]>} */
const known = new WeakMap();

/**
 * @param {Match | null} match
 * @returns {Line[]}
 */
export function shownLines(match) {
  if (!match) return [];
  if (match.pairs.length > 0) return match.pairs;
  const lines =
    known.get(match) ??
    match.lines.map(({ from, to, value }) => ({
      from: match.samples[0].points[from],
      to: match.samples[1].points[to],
      value,
    }));
  known.set(match, lines);
  return lines;
}

/**
 * What the shown lines are worth.
 * @param {Match} match
 * @returns {Totals | null}
 */
export function shownTotals({ totals }) {
  return totals.pairs ?? totals.lines;
}

/**
 * Gaps that keep the lines between samples, because no one-to-one lines fit there.
 * @param {Match} match
 */
export function keptGaps({ diagnostics }) {
  return diagnostics.filter(({ code }) => code === "unverified-gap");
}
