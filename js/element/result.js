/**
 * What a matching is worth, in numbers and in words.
 *
 * @import { CurvesDocument, Match } from "../directrix.js"
 * @import { FigureResult } from "../element.js"
 */
import { fixed, words } from "./words.js";

/**
 * @param {Match} match
 * @param {CurvesDocument} document
 * @returns {FigureResult}
 */
export function summary({ ok, diagnostics, totals, gap, gapKind, spans = [], harmonic }, { matching }) {
  const shown = totals.pairs ?? totals.lines;
  // A stack is as good as its worst span.
  const etas = spans.flatMap(({ totals }) => (totals.pairs ?? totals.lines)?.eta ?? []);
  const bare = spans.flatMap(({ totals }) => totals.lines?.uncovered.flat() ?? []).length;
  const counts = {
    lines: harmonic?.lines ?? shown?.count ?? 0,
    crossings: harmonic?.crossings ?? shown?.crossings ?? 0,
    blocked: shown?.blocked ?? 0,
    uncovered: shown ? shown.uncovered[0].length + shown.uncovered[1].length + (totals.pairs ? 0 : bare) : 0,
  };
  const { crossings, blocked, uncovered } = counts;
  const kept = diagnostics.some(({ code }) => code === "unverified-gap" || code === "occluded" || code === "unverified");
  const result = {
    ...counts,
    ok,
    verified: ok && crossings + blocked + uncovered === 0 && !kept,
    eta: shown?.eta ?? (etas.length > 0 ? Math.min(...etas) : null),
    integral: shown?.integral ?? null,
    gap,
    gapKind,
    method: matching.method,
    diagnostics: diagnostics.map(({ code }) => code),
  };
  return { ...result, text: stated(result) };
}

/**
 * @param {Omit<FigureResult, "text">} result
 * @returns {string} such as "44 lines, none crossing, η 0.98"
 */
function stated({ lines, crossings, blocked, uncovered, eta, gap, method, diagnostics }) {
  const says = words.result;
  if (diagnostics.includes("incomplete")) return says.incomplete;
  if (lines === 0) return says.noLines;
  return [
    says.counted(lines),
    crossings === 0 ? says.noCrossing : says.crossing(crossings),
    ...(blocked > 0 ? [says.blocked(blocked)] : []),
    ...(uncovered > 0 ? [says.uncovered(uncovered)] : []),
    ...(eta === null ? [] : [says.eta(fixed(eta, 2))]),
    ...(method === "greedy" && gap !== null ? [says.gap(fixed(100 * gap, 1))] : []),
  ].join(", ");
}
