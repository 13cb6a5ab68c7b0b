/**
 * What a body is worth, in numbers and in words.
 *
 * @import { BodySummary, CellVerdict } from "../../directrix.js"
 * @import { FigureResult } from "../../element.js"
 */
import { describeBody } from "../../sentence.js";
import { NO_MATCHING } from "../no-matching.js";
import { words } from "./words.js";

/**
 * A body of which the certificates are known, and all checks once they have run. That nothing is wrong is said only then.
 *
 * @param {CellVerdict[]} verdicts
 * @param {number} volume
 * @param {BodySummary | null} summary
 * @returns {FigureResult}
 */
export function bodyResult(verdicts, volume, summary) {
  const of = (/** @type {string} */ name) => verdicts.filter(({ verdict }) => verdict === name).length;
  const pairs = (/** @type {string} */ relation) => summary?.pairs.filter((pair) => pair.relation === relation).length ?? 0;
  const [invalid, degenerate, overlaps] = [of("invalid"), of("degenerate"), pairs("overlaps")];
  const count = verdicts.length;
  const counted = (/** @type {number} */ cells, /** @type {string} */ what) => (cells === 0 ? [] : [count === 1 ? what : words.problems(cells, what)]);
  const faults = [
    ...counted(invalid, words.invalid),
    ...counted(degenerate, words.degenerate),
    ...(overlaps > 0 ? [words.problems(overlaps, words.overlaps(overlaps))] : []),
  ];
  const ok = faults.length === 0;
  const verified = ok && summary !== null && of("locally-valid") + pairs("not-proven") === 0;
  const state = !ok ? faults.join(", ") : summary === null ? words.checking : verified ? words.verified : words.certified;
  const brief = count === 0 ? words.empty : `${words.cells(count)}, ${state}`;
  return {
    ...NO_MATCHING,
    diagnostics: [],
    ok,
    verified,
    text: summary ? describeBody(summary) : brief,
    brief,
    body: { cells: count, invalid, degenerate, overlaps, volume, checked: summary !== null },
  };
}
