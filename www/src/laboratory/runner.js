/**
 * Keeps what is known of a problem up with the document: first its boundary, which is shown at once, then its solution. Whatever is known names the
 * document that it belongs to.
 *
 * @import { Control } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { Problem } from "../types.js"
 * @import { Boundary, LaboratoryDocument } from "./document.js"
 * @import { Known, Mesh } from "./state.js"
 */
import { problem } from "../painter.js";
import { Lane } from "../state/lane.js";
import { accuracyOf } from "./accuracy.js";
import { inputOf, isSameProblem, isSameSolution } from "./document.js";
import { boundsOf, countOf, jointsOf, soupOf } from "./mesh.js";

/** Milliseconds of rest before a problem is solved while a run of edits goes on. */
const REST = 120;

/**
 * @param {App} app
 * @param {object} listeners
 * @param {(known: Known) => void} listeners.changed
 * @param {(error: Problem) => void} listeners.refused the document cannot be read
 * @param {(error: Problem) => void} listeners.interrupted the person cancelled, or the module stopped
 */
export function createRunner(app, { changed, refused, interrupted }) {
  const { kernel, results } = app;
  /** @type {LaboratoryDocument | null} */
  let newest = null;
  /** @type {Known | null} */
  let latest = null;
  /** Given up for something newer, of which nobody is told. */
  let isSuperseded = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  /** @type {Lane<LaboratoryDocument, Known>} */
  const lane = new Lane({
    async work(document, signal) {
      isSuperseded = false;
      /** @type {Control} */
      const control = { signal, onprogress: (progress) => results.set({ progress }) };
      const started = performance.now();
      const same = latest && isSameProblem(latest.document, document) ? latest : null;
      const boundary = same?.boundary ?? (await kernel.boundary(/** @type {any} */ (document)));
      const mesh = same?.mesh ?? (latest && isSameMesh(latest.boundary, boundary) ? latest.mesh : meshOf(boundary));
      if (same?.solution && isSameSolution(same.document, document)) return { ...same, document };
      /** @type {Known} */
      const known = { document, boundary, mesh, solution: null, unsolved: null, accuracy: null, ms: 0 };
      if (!boundary.ready) return known;
      // Boundary and conditions are seen while the rest is worked on.
      if (!same) tell(known);
      try {
        const solution = await kernel.solveLaplace(inputOf(boundary, document.solver), control);
        const ms = performance.now() - started;
        const accuracy = await accuracyOf(kernel, document, boundary, mesh.bounds, solution, { signal });
        return { ...known, solution, accuracy, ms };
      } catch (error) {
        const { name, code, message } = problem(error);
        if (name === "AbortError" || code === "trap") throw error;
        return { ...known, unsolved: message };
      }
    },
    done(known) {
      if (newest !== null) tell(known);
    },
    failed(error, document) {
      const reason = problem(error);
      if (document !== newest || (reason.name === "AbortError" && isSuperseded)) return;
      if (reason.name === "AbortError" || reason.code === "trap") interrupted(reason);
      else refused(reason);
    },
    slow: (slow) => results.set(slow ? { slow } : { slow, progress: 0 }),
  });

  /** @param {Known} known */
  function tell(known) {
    latest = known;
    changed(known);
  }

  /** @param {LaboratoryDocument} document */
  function start(document) {
    if (lane.busy) {
      isSuperseded = true;
      lane.cancel();
    }
    lane.push(document);
  }

  return {
    /** @param {LaboratoryDocument} document */
    push(document) {
      newest = document;
      clearTimeout(timer);
      if (app.store.running) timer = setTimeout(() => start(document), REST);
      else start(document);
    },
    /** Gives up for the person, who is told. */
    cancel() {
      clearTimeout(timer);
      lane.cancel();
    },
    /** Nothing is wanted any more. */
    close() {
      newest = null;
      clearTimeout(timer);
      lane.cancel();
      results.set({ slow: false, progress: 0 });
    },
  };
}

/** @param {Boundary} boundary @returns {Mesh} */
function meshOf(boundary) {
  return {
    count: countOf(boundary),
    bounds: boundsOf(boundary),
    soup: boundary.dimension === 3 ? soupOf(boundary) : null,
    joints: jointsOf(boundary),
  };
}

/** Whether two boundaries are the same mesh, whatever their conditions. @param {Boundary} a @param {Boundary} b */
function isSameMesh(a, b) {
  const isSame = (/** @type {ArrayLike<number>} */ one, /** @type {ArrayLike<number>} */ other) => {
    if (one.length !== other.length) return false;
    for (let k = 0; k < one.length; k += 1) if (one[k] !== other[k]) return false;
    return true;
  };
  return a.dimension === b.dimension && isSame(a.elements, b.elements) && isSame(a.vertices, b.vertices);
}
