/**
 * Solves and paints every method of a document, then solves each again for its time. The newest document wins: what is still
 * under way for an older one stops at the next method.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Match, PaintOptions, Picture, Problem, Size } from "../types.js"
 *
 * @typedef {object} Result
 * @property {CurvesDocument} document that was asked for, with its own method
 * @property {Match | null} match
 * @property {ReturnType<typeof qualityOf>} quality
 * @property {Problem | null} problem why there is no match
 * @property {Picture | null} picture
 * @property {Size} size of the picture on the screen
 * @property {number[]} times milliseconds that solving took in the worker, once for each run
 *
 * @typedef {object} Job
 * @property {CurvesDocument} document
 * @property {PaintOptions} options
 * @property {Size} size
 */
import { problem } from "../painter.js";
import { Lane } from "../state/lane.js";
import { measured, METHODS, qualityOf, withMethod } from "./methods.js";

/** Runs for a median, by the milliseconds that one takes at most. */
const RUNS = [
  { most: 60, runs: 5 },
  { most: 400, runs: 3 },
  { most: Infinity, runs: 1 },
];
const NO_QUALITY = { eta: null, integral: null, bound: null };

/**
 * @param {App} app
 * @param {object} listeners
 * @param {(results: (Result | null)[]) => void} listeners.changed
 * @param {(error: Problem) => void} listeners.interrupted the person cancelled, or the module stopped; what stood for an
 *   older document is gone then
 */
export function createRunner(app, { changed, interrupted }) {
  const { kernel } = app;
  /** @type {(Result | null)[]} */
  let results = METHODS.map(() => null);
  /** @type {Job | null} */
  let newest = null;
  let isSolving = false;

  /** @type {Lane<Job, void>} */
  const lane = new Lane({
    async work(job, signal) {
      isSolving = true;
      for (const i of METHODS.keys()) {
        if (newest !== job) return;
        const result = await run(job, i, signal);
        if (!newest || !hasSameLines(newest.document, job.document)) return;
        put(i, result);
        changed(results);
        if (newest !== job) return;
        app.results.set({ progress: (i + 1) / METHODS.length });
      }
      isSolving = false;
      app.results.set({ slow: false, progress: 0 });
      await time(job, signal);
    },
    done() {},
    failed(error) {
      if (!newest) return;
      const { document } = newest;
      results = results.map((result) => (result && hasSameLines(result.document, document) ? result : null));
      changed(results);
      interrupted(problem(error));
    },
    slow: (slow) => app.results.set(slow && isSolving ? { slow } : { slow: false, progress: 0 }),
  });

  /** @param {Job} job @param {number} i @param {AbortSignal} signal @returns {Promise<Result>} */
  async function run({ document, options, size }, i, signal) {
    const own = withMethod(document, METHODS[i]);
    const before = results[i];
    const known = before && hasSameLines(before.document, document) ? before : await solved(own, i, signal);
    const picture = await kernel.paint(own, options, { signal });
    return { ...known, document, picture, size };
  }

  /** @param {number} i @param {Result} result */
  function put(i, result) {
    results = results.map((each, k) => (k === i ? result : each));
  }

  /** @param {CurvesDocument} document @param {number} i @param {AbortSignal} signal @returns {Promise<Pick<Result, "match" | "quality" | "problem" | "times">>} */
  async function solved(document, i, signal) {
    const onprogress = (/** @type {number} */ share) => app.results.set({ progress: (i + share) / METHODS.length });
    /** @type {number[]} */
    const times = [];
    try {
      const onsolved = (/** @type {number} */ spent) => times.push(spent);
      const match = await kernel.match(document, {}, { signal, onprogress, onsolved });
      const like = measured(document);
      const quality = qualityOf(like === document ? match : await kernel.match(like, {}, { signal }));
      return { match, quality, problem: null, times };
    } catch (error) {
      const reason = problem(error);
      if (reason.name === "AbortError" || reason.code === "trap") throw error;
      return { match: null, quality: NO_QUALITY, problem: reason, times };
    }
  }

  /**
   * Solves what has been solved once more: the module remembers documents by their text, so every run has a text of its own.
   * @param {Job} job
   * @param {AbortSignal} signal
   */
  async function time(job, signal) {
    const texts = METHODS.map((method) => JSON.stringify(withMethod(job.document, method)));
    for (let turn = 1; turn < RUNS[0].runs; turn += 1) {
      for (const [i, text] of texts.entries()) {
        const result = results[i];
        if (newest !== job) return;
        if (!result?.match || result.times.length >= runsFor(Math.min(...result.times))) continue;
        await kernel.match(text + " ".repeat(turn), {}, {
          signal,
          onsolved: (spent) => {
            put(i, { ...result, times: [...result.times, spent] });
          },
        });
      }
      if (newest === job) changed(results);
    }
  }

  return {
    /** @param {Job} job */
    push(job) {
      newest = job;
      lane.push(job);
    },
    /** Gives up for the person, who is told. */
    cancel: () => lane.cancel(),
    /** Gives up for good. */
    close() {
      newest = null;
      lane.cancel();
      app.results.set({ slow: false, progress: 0 });
    },
  };
}

/**
 * Whether two documents differ in nothing that lines depend on.
 * @param {CurvesDocument} a
 * @param {CurvesDocument} b
 */
const hasSameLines = (a, b) => a.curves === b.curves && a.sampling === b.sampling && a.matching === b.matching;

/** @param {number} least milliseconds of the shortest run so far: the very first one is slowed by the start of the module */
const runsFor = (least) => RUNS.find(({ most }) => least <= most)?.runs ?? 1;
