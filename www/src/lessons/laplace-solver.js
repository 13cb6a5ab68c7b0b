/**
 * What the kernel says of the boundary value problem of a figure. What belongs to a document is solved once for it, whatever place is read.
 *
 * @import { LaplaceBoundary, LaplaceDocument, LaplaceSection, LaplaceSolver, Point, RemoteLaplaceSolution } from "../../../js/directrix.js"
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 * @import { Kernel } from "../types.js"
 * @import { Matrix } from "./laplace-known.js"
 *
 * @typedef {{document: LaplaceDocument, place: Point | null, radius: number, omega: number, isMoving: boolean}} Job
 * @typedef {{name: "none" | "jacobi" | "ssor", residuals: Float64Array, iterations: number, converged: boolean, time: number}} Run
 *
 * @typedef {object} Solved What belongs to a document.
 * @property {LaplaceDocument} document
 * @property {LaplaceBoundary} boundary
 * @property {RemoteLaplaceSolution} solution
 * @property {[Point, Point]} box
 * @property {LaplaceSection} section
 * @property {HTMLCanvasElement} picture
 * @property {number[][]} levels isolines in pixels of the section: x and y of both ends of each piece
 * @property {Matrix | null} matrix
 * @property {{panels: number, error: number}[]} errors
 * @property {number | null} condition
 *
 * @typedef {object} Known
 * @property {Job} job
 * @property {Solved} solved
 * @property {Float64Array | null} found fractions at the place
 * @property {Float64Array | null} around fractions on the circle; null where it leaves the body
 * @property {Run[]} runs
 *
 * @typedef {{signal: AbortSignal}} Control
 */
import { h } from "../dom.js";
import { colorsOf, grown, LEVELS, levelLines } from "../laboratory/pixels.js";
import { circleOf, farthest, FOLLOWED, frameOf, inputOf, matrixOf, probes, stepsOf, withSteps } from "./laplace-known.js";

/** Pixels along the longer side of the picture, at rest and while something is dragged. */
const FINE = 360;
const MOVING = 160;
/** Steps along a side for which errors are measured. */
const SIZES = [2, 4, 8, 16, 32, 64];
/** Most elements whose condition number is estimated here: the time of elimination grows as the cube. */
const MOST_CONDITION = 1000;
/** A tolerance that leaves the error to the elements. */
const EXACT = 1e-9;

/**
 * @param {Kernel} kernel
 * @param {Figure} figure
 */
export function createLaplaceSolver(kernel, figure) {
  const isCompared = figure.reading === "residuals";
  const hasMatrix = figure.reading === "influence" || figure.reading === "matrix";
  /** @type {Solved | null} */
  let kept = null;
  /** Runs without a parameter. @type {{document: LaplaceDocument, runs: Run[]} | null} */
  let steady = null;

  /** @param {Job} job @param {AbortSignal} signal @returns {Promise<Known>} */
  return async function ask(job, signal) {
    const control = { signal };
    const { document, place } = job;
    const longest = job.isMoving ? MOVING : FINE;
    const isKnown = kept?.document === document && Math.max(...kept.section.size) >= longest;
    const solved = isKnown && kept ? kept : await solve(document, longest, control);
    const at = async (/** @type {number[]} */ points) => (await solved.solution.at(points, { outside: "skip" }, control)).values;
    const found = place ? await at(place) : null;
    const around = place && figure.circle !== null ? await at(circleOf(place, job.radius)) : null;
    const runs = isCompared ? await compare(solved.boundary, job, control) : [];
    kept = solved;
    return { job, solved, found, around: around?.some(Number.isNaN) ? null : around, runs };
  };

  /** @param {LaplaceDocument} document @param {number} longest @param {Control} control @returns {Promise<Solved>} */
  async function solve(document, longest, control) {
    const boundary = await kernel.boundary(document, control);
    const solution = kept?.document === document ? kept.solution : await kernel.solveLaplace(inputOf(boundary), control);
    const { frame, box } = frameOf(document, boundary, longest);
    const section = await solution.section(frame, control);
    const lines = LEVELS.flatMap((level) => levelLines(section.values[0], section.size, level));
    const levels = Array.from({ length: lines.length / 4 }, (_, n) => lines.slice(4 * n, 4 * n + 4).map((each) => each + 0.5));
    const matrix = hasMatrix ? matrixOf(boundary) : null;
    const errors = figure.reading === "error" ? await measure(document, control) : [];
    const isSmall = boundary.groups.length <= MOST_CONDITION;
    const condition = isCompared && isSmall ? (await kernel.solveLaplace(inputOf(boundary, { condition: true }), control)).condition : null;
    return { document, boundary, solution, box, section, picture: pictureOf(document, boundary, section), levels, matrix, errors, condition };
  }

  /** How far the solution is from the exact one, by steps along a side. @param {LaplaceDocument} document @param {Control} control */
  async function measure(document, control) {
    const points = probes((await kernel.boundary(document, control)).dimension);
    const exact = await kernel.exact(document, points, control);
    const rows = [];
    for (const steps of [...new Set([...SIZES, stepsOf(document)])].sort((a, b) => a - b)) {
      const boundary = await kernel.boundary(withSteps(document, steps), control);
      const solution = await kernel.solveLaplace(inputOf(boundary, { ...boundary.solver, tolerance: EXACT }), control);
      const { values } = await solution.at(points, {}, control);
      rows.push({ panels: boundary.groups.length, error: farthest(values, exact) });
    }
    return rows;
  }

  /** Residuals of each preconditioner; those without a parameter are found once. @param {LaplaceBoundary} boundary @param {Job} job @param {Control} control */
  async function compare(boundary, { document, omega }, control) {
    const run = async (/** @type {Run["name"]} */ name) => {
      /** @type {LaplaceSolver} */
      const solver = { ...FOLLOWED, preconditioner: name, ...(name === "ssor" ? { omega } : {}) };
      const { residuals, iterations, converged, times } = await kernel.solveLaplace(inputOf(boundary, solver), control);
      return { name, residuals: residuals[0], iterations: iterations[0], converged, time: times.solve };
    };
    if (steady?.document !== document) steady = { document, runs: [await run("none"), await run("jacobi")] };
    return [...steady.runs, await run("ssor")];
  }
}

/** The section in the colours of its fractions. @param {LaplaceDocument} document @param {LaplaceBoundary} boundary @param {LaplaceSection} section */
function pictureOf({ materials = [] }, { dimension }, section) {
  const [width, height] = section.size;
  const picture = h("canvas", { width, height });
  const pixels = grown(colorsOf(section, materials, true), section.size, dimension === 2 ? 2 : 0);
  picture.getContext("2d")?.putImageData(new ImageData(pixels, width, height), 0, 0);
  return picture;
}
