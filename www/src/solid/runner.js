/**
 * Keeps the solid up with the document: the newest document and colour win, one request at a time; once the page rests, the greatest angles
 * are asked for as well.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Match, Problem } from "../types.js"
 * @import { Solid, SolidOptions } from "../../../js/directrix.js"
 *
 * @typedef {object} Outcome
 * @property {CurvesDocument} document
 * @property {Solid | null} solid
 * @property {Match | null} match where there is no surface
 * @property {Problem | null} problem
 * @property {number | null} ms from the edit to its solid
 *
 * @typedef {{document: CurvesDocument, color: SolidOptions["color"]}} Wanted
 */
import { problem } from "../painter.js";
import { Lane } from "../state/lane.js";
import { rowsOf } from "./state.js";

/** Milliseconds of rest before the angles are asked for. */
const REST = 300;

/**
 * @param {App} app
 * @param {object} listeners
 * @param {(outcome: Outcome) => void} listeners.changed
 * @param {(worst: {twist: number | null, flank: number | null}) => void} listeners.measured the greatest angles, in degrees
 * @param {(error: Problem) => void} listeners.interrupted the person cancelled, or the module stopped
 */
export function createRunner(app, { changed, measured, interrupted }) {
  const { kernel, results } = app;
  /** @type {Wanted | null} */
  let newest = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  /** @type {Lane<Wanted, Outcome>} */
  const lane = new Lane({
    async work({ document, color }, signal) {
      const started = performance.now();
      const onprogress = (/** @type {number} */ progress) => results.set({ progress });
      try {
        const solid = await kernel.solid(document, { color, stages: rowsOf(document) }, { signal, onprogress });
        const ms = performance.now() - started;
        // What is wrong with a matching stands in its totals.
        const match = solid.ok ? null : await kernel.match(document, {}, { signal });
        return /** @type {Outcome} */ ({ document, solid, match, problem: null, ms });
      } catch (error) {
        const reason = problem(error);
        if (reason.name === "AbortError" || reason.code === "trap") throw error;
        return /** @type {Outcome} */ ({ document, solid: null, match: null, problem: reason, ms: null });
      }
    },
    done(outcome, wanted) {
      if (!newest) return;
      changed(outcome);
      clearTimeout(timer);
      if (wanted === newest && outcome.solid?.ok) timer = setTimeout(() => void measure(wanted), REST);
    },
    failed: (error) => void (newest && interrupted(problem(error))),
    slow: (slow) => results.set(slow ? { slow } : { slow, progress: 0 }),
  });

  /** @param {Wanted} wanted */
  async function measure(wanted) {
    try {
      const ranges = [];
      for (const color of /** @type {const} */ (["twist", "flank"])) {
        if (newest !== wanted) return;
        ranges.push((await kernel.solid(wanted.document, { color, stages: 1, caps: false })).range);
      }
      if (newest !== wanted) return;
      const [twist, flank] = ranges.map((range) => range?.[1] ?? null);
      measured({ twist, flank });
    } catch (error) {
      if (newest === wanted) interrupted(problem(error));
    }
  }

  return {
    /** @param {Wanted} wanted */
    push(wanted) {
      if (newest?.document !== wanted.document) measured({ twist: null, flank: null });
      newest = wanted;
      clearTimeout(timer);
      lane.push(wanted);
    },
    /** Gives up for the person, who is told. */
    cancel: () => lane.cancel(),
    /** Nothing is wanted any more. */
    close() {
      newest = null;
      clearTimeout(timer);
      lane.cancel();
      results.set({ slow: false, progress: 0 });
    },
  };
}
