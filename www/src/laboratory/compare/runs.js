/**
 * Runs of the laboratory, one after the other in the worker: every method on the problem as it stands, and one body in many sizes. What was found names the
 * document that it was found of.
 *
 * @import { RemoteLaplaceSolution } from "../../../../js/directrix.js"
 * @import { LaboratoryDocument, Solver } from "../document.js"
 * @import { Bench } from "../state.js"
 *
 * @typedef {"lu" | "none" | "jacobi" | "ssor"} Method
 *
 * @typedef {object} Outcome
 * @property {number} assembly milliseconds
 * @property {number} solve milliseconds
 * @property {number} iterations of all materials together
 * @property {boolean} converged
 * @property {number[]} residuals after each iteration, the greatest of the materials
 * @property {number[]} preconditioned
 * @property {number | null} error the largest difference from the exact solution; null where none is known
 *
 * @typedef {object} Run
 * @property {Method} method
 * @property {number} omega
 * @property {"waits" | "runs" | "done" | "failed" | "unable"} state
 * @property {Outcome | null} outcome
 * @property {string} reason why it failed or cannot be
 *
 * @typedef {object} Size One size of the body.
 * @property {number} size
 * @property {number} elements
 * @property {number | null} error
 * @property {{[method in Method]?: Outcome}} outcomes
 *
 * @typedef {object} Found
 * @property {LaboratoryDocument} document
 * @property {Run[]} runs
 * @property {number | null} condition
 *
 * @typedef {{document: LaboratoryDocument, sizes: Size[]}} Series
 *
 * @typedef {{omega: number, iterations: number, converged: boolean}} Trial One parameter of SSOR.
 *
 * @typedef {{document: LaboratoryDocument, trials: Trial[]}} Sweep
 */
import { problem } from "../../painter.js";
import { accuracyOf } from "../accuracy.js";
import { inputOf, MOST } from "../document.js";
import { solverOf } from "../edits.js";
import { boundsOf } from "../mesh.js";
import { inSize, isNamed, MODELS } from "../models.js";
import { words } from "./words.js";

/** Methods in the order of the table. */
export const METHODS = /** @type {const} */ (["lu", "none", "jacobi", "ssor"]);
/** Parameters of SSOR that are tried. */
const OMEGAS = [0.1, 0.3, 0.5, 0.7, 0.9, 1.1, 1.3, 1.5, 1.7, 1.9];

/**
 * @param {Bench} bench
 * @param {() => void} changed
 */
export function createRuns(bench, changed) {
  const { kernel } = bench.app;
  /** @type {AbortController | null} */
  let flight = null;
  /** @type {Found | null} */
  let found = null;
  /** @type {Series | null} */
  let series = null;
  /** @type {Sweep | null} */
  let swept = null;
  let progress = 0;
  let running = "";

  /**
   * @param {LaboratoryDocument} document
   * @param {Solver & {condition?: boolean}} solver
   * @param {AbortSignal} signal
   */
  async function solved(document, solver, signal) {
    const boundary = await kernel.boundary(/** @type {any} */ (document));
    const fault = boundary.diagnostics.find(({ remark, code }) => !remark && code !== "method");
    if (fault) throw new Error(fault.message);
    const solution = await kernel.solveLaplace(inputOf(boundary, solver), {
      signal,
      onprogress(share) {
        progress = share;
        changed();
      },
    });
    const accuracy = await accuracyOf(kernel, document, boundary, boundsOf(boundary), solution, { signal });
    return { boundary, solution, outcome: outcomeOf(solution, accuracy?.error ?? null) };
  }

  /** @param {string} what @param {(signal: AbortSignal) => Promise<void>} work */
  async function fly(what, work) {
    flight?.abort();
    const own = new AbortController();
    flight = own;
    running = what;
    progress = 0;
    changed();
    try {
      await work(own.signal);
    } catch (error) {
      const { name, message } = problem(error);
      if (name !== "AbortError") bench.app.ui.set({ note: { tone: "error", text: message } });
    }
    if (flight === own) {
      flight = null;
      running = "";
    }
    changed();
  }

  /** @param {Run} run @param {Partial<Run>} patch */
  function tell(run, patch) {
    Object.assign(run, patch);
    changed();
  }

  return {
    get found() {
      return found;
    },
    get series() {
      return series;
    },
    get swept() {
      return swept;
    },
    /** What runs: `methods`, `sizes`, `omegas`, or nothing. */
    get running() {
      return running;
    },
    get progress() {
      return progress;
    },
    /** Solves the problem by every method. @param {LaboratoryDocument} document @param {number} elements */
    compare(document, elements) {
      const own = solverOf(document);
      /** @type {Run[]} */
      const runs = METHODS.map((method) => {
        const reason = method === "lu" && elements > MOST.lu ? words.runs.mostLu : method === "ssor" && elements > MOST.ssor ? words.runs.mostSsor : "";
        return { method, omega: own.omega, state: reason ? "unable" : "waits", outcome: null, reason };
      });
      /** @type {Found} */
      const next = { document, runs, condition: null };
      found = next;
      void fly("methods", async (signal) => {
        for (const run of runs) {
          if (run.state !== "waits") continue;
          tell(run, { state: "runs" });
          try {
            const { outcome } = await solved(document, solverFor(run.method, own), signal);
            tell(run, { state: "done", outcome });
          } catch (error) {
            const { name, message } = problem(error);
            tell(run, name === "AbortError" ? { state: "waits" } : { state: "failed", reason: message });
            if (name === "AbortError") throw error;
          }
        }
        if (elements > MOST.lu) return;
        const { solution } = await solved(document, { method: "lu", condition: true }, signal);
        next.condition = solution.condition;
      });
    },
    /** Solves the body in one size after the other. @param {LaboratoryDocument} document */
    grow(document) {
      if (!isNamed(document.model)) return;
      const own = solverOf(document);
      /** @type {Size[]} */
      const sizes = [];
      series = { document, sizes };
      void fly("sizes", async (signal) => {
        for (const size of MODELS[document.model.kind].sizes.values) {
          const sized = { ...document, model: inSize(document.model, size) };
          /** @type {Size | null} */
          let row = null;
          for (const method of /** @type {const} */ (["jacobi", "none", "ssor", "lu"])) {
            if (row && row.elements > MOST.lu && method === "lu") continue;
            const { boundary, outcome } = await solved(sized, solverFor(method, own), signal);
            if (!row) sizes.push((row = { size, elements: boundary.elements.length / boundary.dimension, error: outcome.error, outcomes: {} }));
            row.outcomes[method] = outcome;
            changed();
          }
        }
      });
    },
    /** Solves the problem by SSOR with one parameter after the other. @param {LaboratoryDocument} document */
    sweep(document) {
      const own = solverOf(document);
      /** @type {Trial[]} */
      const trials = [];
      swept = { document, trials };
      void fly("omegas", async (signal) => {
        for (const omega of OMEGAS) {
          const { outcome } = await solved(document, solverFor("ssor", { ...own, omega }), signal);
          trials.push({ omega, iterations: outcome.iterations, converged: outcome.converged });
          changed();
        }
      });
    },
    cancel() {
      flight?.abort();
    },
    close() {
      flight?.abort();
      flight = null;
    },
  };
}

/** @param {Method} method @param {ReturnType<typeof solverOf>} own @returns {Solver} */
function solverFor(method, { omega, restart, tolerance, maxIterations, dense }) {
  const kept = dense === undefined ? {} : { dense };
  if (method === "lu") return { method, ...kept };
  return { method: "gmres", preconditioner: method, ...(method === "ssor" ? { omega } : {}), restart, tolerance, ...(maxIterations === undefined ? {} : { maxIterations }), ...kept };
}

/** @param {RemoteLaplaceSolution} solution @param {number | null} error @returns {Outcome} */
function outcomeOf({ times, iterations, converged, residuals, preconditionedResiduals }, error) {
  return {
    assembly: times.assembly,
    solve: times.solve,
    iterations: iterations.reduce((sum, each) => sum + each, 0),
    converged,
    residuals: greatest(residuals),
    preconditioned: greatest(preconditionedResiduals),
    error,
  };
}

/**
 * The greatest of several lists at each of their places; where one has ended its last value counts.
 * @param {readonly ArrayLike<number>[]} lists
 * @returns {number[]}
 */
export function greatest(lists) {
  const length = Math.max(0, ...lists.map((list) => list.length));
  return Array.from({ length }, (_, k) => Math.max(...lists.flatMap((list) => (list.length > 0 ? [list[Math.min(k, list.length - 1)]] : []))));
}

/**
 * The slope of a straight line through points on logarithmic axes, by least squares; null of fewer than two points.
 * @param {{x: number, y: number}[]} points with positive coordinates
 */
export function slopeOf(points) {
  const logs = points.filter(({ x, y }) => x > 0 && y > 0).map(({ x, y }) => [Math.log(x), Math.log(y)]);
  if (logs.length < 2) return null;
  const [mx, my] = [0, 1].map((k) => logs.reduce((sum, point) => sum + point[k], 0) / logs.length);
  const square = logs.reduce((sum, [x]) => sum + (x - mx) ** 2, 0);
  return square > 0 ? logs.reduce((sum, [x, y]) => sum + (x - mx) * (y - my), 0) / square : null;
}
