/**
 * Keeps what is known of a body up with the document: shape and certificates at once, the checks of the whole body once the document
 * rests. Whatever is known names the document that it belongs to, so that no verdict outlives an edit.
 *
 * @import { BodyContinuity, BodySharing, BodySummary, BodySurface, CellSummary, CellVerdict, RemoteHyperpatch } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { Problem } from "../types.js"
 * @import { BodyDocument, Cell } from "./document.js"
 *
 * @typedef {object} Known
 * @property {BodyDocument} document
 * @property {RemoteHyperpatch} body
 * @property {CellSummary[]} cells
 * @property {import("../../../js/directrix.js").OperationResult[]} operations what came of each operation
 * @property {(id: number) => Cell | undefined} cellOf the coefficients of a cell
 * @property {CellVerdict[]} verdicts of all cells, in their order; certificates alone until `summary` is there
 * @property {BodySurface} surface with the faces between cells where they are wanted
 * @property {boolean} hasInner whether it has those
 * @property {boolean} isRenewed whether it has the triangles of a surface before, whatever the shape now needs
 * @property {BodyContinuity | null} continuity null unless it is wanted
 * @property {BodySharing} sharing
 * @property {number} volume
 * @property {number[]} amounts
 * @property {BodySummary | null} summary null until every check has run to its end
 * @property {number} ms from the edit to its certificates
 */
import { renewSurface } from "../../../js/renew.js";
import { problem } from "../painter.js";
import { Lane } from "../state/lane.js";
import { cellsIn } from "./document.js";

/** Milliseconds of rest before the checks of the whole body begin. */
const REST = 250;

/**
 * @param {App} app
 * @param {() => {inner: boolean, continuity: boolean}} wants what the picture needs besides
 * @param {object} listeners
 * @param {(known: Known) => void} listeners.changed
 * @param {(error: Problem) => void} listeners.refused the body cannot be made
 * @param {(error: Problem) => void} listeners.interrupted the person cancelled, or the module stopped
 */
export function createRunner(app, wants, { changed, refused, interrupted }) {
  const { kernel, results, store } = app;
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
      const cellOf = cellsIn(body.cells, await body.coefficients(control));
      const ms = performance.now() - started;
      const wanted = wants();
      const { surface, isRenewed } = await surfaceOf(body, wanted.inner, control);
      const continuity = wanted.continuity ? await body.continuity(control) : null;
      const sharing = await body.sharing(control);
      const amounts = await body.amounts(control);
      const volume = body.cells.reduce((sum, cell) => sum + Math.abs(cell.volume), 0);
      /** @type {Known} */
      const known = { document, body, cells: body.cells, operations: body.operations, cellOf, verdicts, surface, hasInner: wanted.inner, isRenewed, continuity, sharing, volume, amounts, summary: null, ms };
      return known;
    },
    done(known, document) {
      if (document !== newest) return;
      tell(known);
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

  /** What the picture has come to need since. @type {Lane<Known, Partial<Known>>} */
  const more = new Lane({
    async work(known, signal) {
      const wanted = wants();
      /** @type {Partial<Known>} */
      const surface = wanted.inner && !known.hasInner ? { surface: await known.body.surface({ faces: "all" }, { signal }), hasInner: true, isRenewed: false } : {};
      /** @type {Partial<Known>} */
      const continuity = wanted.continuity && !known.continuity ? { continuity: await known.body.continuity({ signal }) } : {};
      return { ...surface, ...continuity };
    },
    done(found, known) {
      if (known.document === newest && latest?.document === newest) tell({ ...latest, ...found });
    },
    failed(error) {
      const reason = problem(error);
      if (reason.name !== "AbortError") interrupted(reason);
    },
  });
  /** @type {Known | null} */
  let latest = null;

  /**
   * The surface of a body. While something is dragged only what differs from the one before comes, and is put into its arrays: it is shown no more.
   * @param {Known["body"]} body
   * @param {boolean} hasInner
   * @param {import("../../../js/directrix.js").Control} control
   */
  async function surfaceOf(body, hasInner, control) {
    const faces = hasInner ? "all" : "outer";
    const before = store.running && latest?.hasInner === hasInner ? latest.surface : null;
    if (!before) return { surface: await body.surface({ faces }, control), isRenewed: false };
    const change = await body.surface({ faces, since: before.id }, control);
    return renewSurface(before, change) ? { surface: { ...before }, isRenewed: true } : { surface: change, isRenewed: false };
  }

  /** @param {Known} known */
  function tell(known) {
    latest = known;
    changed(known);
  }

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
      /** @type {Partial<Known>} */
      const whole = known.isRenewed ? { surface: await known.body.surface({ faces: known.hasInner ? "all" : "outer" }, control), isRenewed: false } : {};
      const verdicts = await known.body.verdicts({}, control);
      const summary = await known.body.summary(control);
      const isSame = latest?.surface === known.surface;
      if (known.document === newest) tell({ ...known, ...(latest?.document === newest ? latest : {}), ...(isSame ? whole : {}), verdicts, summary });
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
    /** Sees whether the picture needs more than is known. @param {Known} known */
    look(known) {
      const wanted = wants();
      if ((wanted.inner && !known.hasInner) || (wanted.continuity && !known.continuity)) more.push(known);
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
      more.cancel();
      results.set({ slow: false, progress: 0 });
    },
  };
}
