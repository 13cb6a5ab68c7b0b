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
  if (match.spans) return match.spans.flatMap(shownLines);
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
 * What the shown lines are worth. Of a stack: counts of all spans, and eta and J of the span with the least eta.
 * @param {Match} match
 * @returns {Totals & {span?: number} | null}
 */
export function shownTotals({ totals, spans }) {
  const shown = totals.pairs ?? totals.lines;
  if (!spans || !shown) return shown;
  const each = spans.map((span) => /** @type {Totals} */ (shownTotals(span)));
  const etas = each.map(({ eta }) => eta ?? 0);
  const span = etas.indexOf(Math.min(...etas));
  const bare = (/** @type {0 | 1} */ side) => each.flatMap(({ uncovered }) => uncovered[side]);
  const { eta = null, integral = null } = each[span] ?? {};
  return { ...shown, eta, integral, uncovered: [bare(0), bare(1)], span };
}

/**
 * A reading with the number of its line counted on through all spans, as pictures count them.
 * @template {import("../types.js").Probe} P
 * @param {Match | null} match
 * @param {P} probe
 * @returns {P}
 */
export function numbered(match, probe) {
  const before = match?.spans?.slice(0, probe.span ?? 0) ?? [];
  return { ...probe, line: before.reduce((sum, span) => sum + shownLines(span).length, probe.line) };
}

/**
 * The span of a line that is counted on through all spans, and its number there.
 * @param {Match | null} match
 * @param {number} line
 */
export function inSpan(match, line) {
  let span = 0;
  for (const { length } of match?.spans?.map(shownLines) ?? []) {
    if (line < length) break;
    line -= length;
    span += 1;
  }
  return { span, line };
}

/**
 * Gaps that keep the lines between samples, because no one-to-one lines fit there.
 * @param {Match} match
 */
export function keptGaps({ diagnostics }) {
  return diagnostics.filter(({ code }) => code === "unverified-gap");
}
