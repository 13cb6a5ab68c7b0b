/**
 * Keeps what is known of a body up with the document: shape and certificates at once, the checks of the whole body once the document
 * rests. Whatever is known names the document that it belongs to, so that no verdict outlives an edit.
 *
 * @import { BodySharing, BodySummary, BodySurface, CellSummary, CellVerdict, RemoteHyperpatch } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { Problem } from "../types.js"
 * @import { BodyDocument } from "./document.js"
 *
 * @typedef {object} Known
 * @property {BodyDocument} document
 * @property {RemoteHyperpatch} body
 * @property {CellSummary[]} cells
 * @property {CellVerdict[]} verdicts of all cells, in their order; certificates alone until `summary` is there
 * @property {BodySurface} surface
 * @property {BodySharing} sharing
 * @property {number} volume
 * @property {number[]} amounts
 * @property {BodySummary | null} summary null until every check has run to its end
 * @property {number} ms from the edit to its certificates
 */
import { problem } from "../painter.js";
import { Lane } from "../state/lane.js";

/** Milliseconds of rest before the checks of the whole body begin. */
const REST = 250;

/**
 * @param {App} app
 * @param {object} listeners
 * @param {(known: Known) => void} listeners.changed
 * @param {(error: Problem) => void} listeners.refused the body cannot be made
 * @param {(error: Problem) => void} listeners.interrupted the person cancelled, or the module stopped
 */
export function createRunner(app, { changed, refused, interrupted }) {
  const { kernel, results } = app;
  /** @type {BodyDocument | null} */
  let newest = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  let checks = new AbortController();

  /** @type {Lane<BodyDocument, Known>} */
  const lane = new Lane({
    async work(document, signal) {
      const started = performance.now();
      const onprogress = (/** @type {number} */ progress) => results.set({ progress });
      const control = { signal, onprogress };
      const body = await kernel.hyperpatch(document, control);
      const verdicts = await body.verdicts({ global: false }, control);
      const ms = performance.now() - started;
      const surface = await body.surface({}, control);
      const sharing = await body.sharing(control);
      const amounts = await body.amounts(control);
      const volume = body.cells.reduce((sum, cell) => sum + Math.abs(cell.volume), 0);
      /** @type {Known} */
      const known = { document, body, cells: body.cells, verdicts, surface, sharing, volume, amounts, summary: null, ms };
      return known;
    },
    done(known, document) {
      if (document !== newest) return;
      changed(known);
      rest(known);
    },
    failed(error, document) {
      const reason = problem(error);
      if (document !== newest) return;
      if (reason.name === "AbortError" || reason.code === "trap") interrupted(reason);
      else refused(reason);
    },
    slow: (slow) => results.set(slow ? { slow } : { slow, progress: 0 }),
  });

  /** @param {Known} known */
  function rest(known) {
    clearTimeout(timer);
    timer = setTimeout(() => void check(known), REST);
  }

  /** @param {Known} known */
  async function check(known) {
    checks = new AbortController();
    const control = { signal: checks.signal };
    try {
      const verdicts = await known.body.verdicts({}, control);
      const summary = await known.body.summary(control);
      if (known.document === newest) changed({ ...known, verdicts, summary });
    } catch (error) {
      const reason = problem(error);
      if (known.document === newest) interrupted(reason);
    }
  }

  return {
    /** @param {BodyDocument} document */
    push(document) {
      newest = document;
      clearTimeout(timer);
      checks.abort();
      lane.push(document);
    },
    /** Runs the checks of the whole body again after they were given up. @param {Known} known */
    check: (known) => rest(known),
    /** Gives up for the person, who is told. */
    cancel() {
      lane.cancel();
      checks.abort();
    },
    /** Nothing is wanted any more. */
    close() {
      newest = null;
      clearTimeout(timer);
      checks.abort();
      lane.cancel();
      results.set({ slow: false, progress: 0 });
    },
  };
}
