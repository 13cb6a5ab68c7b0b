/**
 * A figure of a boundary value problem: its solution in the plane or in a section, with its panels, a place that is read with a circle round it, and below
 * it means, extremes, influences, the matrix, errors or residuals. All of it is solved when it is shown.
 *
 * @import { LaplaceBoundary, LaplaceDocument, LaplaceSection, LaplaceSolver, Point, RemoteLaplaceSolution, View } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument } from "../types.js"
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 * @import { FigureView, Host } from "./figure.js"
 * @import { Matrix } from "./laplace-known.js"
 * @import { Part, Parts } from "./parts.js"
 *
 * @typedef {{document: LaplaceDocument, place: Point | null, omega: number, isMoving: boolean}} Job
 * @typedef {{name: "none" | "jacobi" | "ssor", residuals: Float64Array, iterations: number, converged: boolean, time: number}} Run
 *
 * @typedef {object} Solved What belongs to a document.
 * @property {LaplaceDocument} document
 * @property {LaplaceBoundary} boundary
 * @property {RemoteLaplaceSolution} solution
 * @property {[Point, Point]} box
 * @property {LaplaceSection} section
 * @property {HTMLCanvasElement} picture
 * @property {string} levels isolines in pixels of the section, as path data
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
 */
import "../../styles/lesson-cell.css";
import "../../styles/lesson-laplace.css";
import { fitting, toPlane, toScreen } from "../../../js/element/plane.js";
import { slider } from "../controls/slider.js";
import { attribute, h, svg, write } from "../dom.js";
import { fixed } from "../format.js";
import { colorsOf, grown, LEVELS, levelLines } from "../laboratory/pixels.js";
import { Lane } from "../state/lane.js";
import { circleOf, farthest, FOLLOWED, frameOf, inputOf, matrixOf, panelsOf, probes, stepsOf, withSteps } from "./laplace-known.js";
import { readingOf } from "./laplace-reading.js";
import { createPlaceHandle } from "./place-handle.js";
import { words } from "./words-laplace.js";

/** Room round the body, CSS pixels. */
const MARGIN = 24;
/** Pixels along the longer side of the picture, at rest and while something is dragged. */
const FINE = 360;
const MOVING = 160;
const IDLE = 200;
/** Most panels whose middles are drawn. */
const DRAWN = 128;
/** Steps along a side for which errors are measured. */
const SIZES = [2, 4, 8, 16, 32, 64];
/** Most elements whose condition number is estimated here: the time of elimination grows as the cube. */
const MOST_CONDITION = 1000;

/**
 * @param {App} app
 * @param {Host} host
 * @param {Figure} figure of the view `laplace`
 * @returns {FigureView}
 */
export function createLaplaceFigure(app, host, figure) {
  const { kernel } = app;
  const { surface } = host;
  const canvas = h("canvas", { role: "img", width: 1, height: 1 });
  const status = h("p", { class: "lesson-status" });
  const levels = svg("path", { class: "laplace-levels" });
  const boundary = svg("path", { class: "laplace-boundary" });
  const ends = svg("path", { class: "laplace-ends" });
  const under = svg("path", { class: "laplace-middles-under" });
  const middles = svg("path", { class: "laplace-middles" });
  const chosen = svg("path", { class: "laplace-panel" });
  const circleUnder = svg("path", { class: "laplace-circle-under" });
  const circle = svg("path", { class: "laplace-circle" });
  const over = svg("svg", { class: "lesson-laplace", "aria-hidden": "true" }, levels, boundary, chosen, ends, under, middles, circleUnder, circle);
  const handle = createPlaceHandle({
    placeOf: surface.placeOf,
    at: () => place && known && toScreen(viewOf(known.solved), surface.size(), place),
    put,
    released: () => isMoving && rest(),
    moved: () => place && app.say(words.moved(fixed(place[0], 2), fixed(place[1], 2))),
  });
  surface.element.prepend(canvas, /** @type {any} */ (over));
  surface.element.append(h("div", { class: "lesson-handles", hidden: figure.place === null }, handle.element));

  /** @type {LaplaceDocument | null} */
  let first = null;
  /** @type {LaplaceDocument | null} */
  let document = null;
  /** @type {Known | null} */
  let known = null;
  /** @type {Solved | null} */
  let kept = null;
  /** Runs without a parameter, with the document that they are of. @type {{document: LaplaceDocument, runs: Run[]} | null} */
  let steady = null;
  /** @type {Point | null} */
  let place = figure.place;
  let radius = figure.circle ?? 0;
  let omega = 0.5;
  let panel = 0;
  let isMoving = false;
  let isOver = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let idle;

  const isCompared = figure.reading === "residuals";
  const hasRow = figure.reading === "influence" || figure.reading === "matrix";
  const [fewest, most] = figure.panels ?? [1, 2];
  const text = (/** @type {string} */ own) => h("span", { class: "number strong", "data-lesson": own });
  const label = (/** @type {string} */ words) => h("span", { class: "cell-label" }, words);
  const [stepsText, omegaText, panelText, radiusText] = ["steps", "omega", "panel", "radius"].map(text);
  const steps = slider({ label: words.steps, name: "lesson-steps", min: fewest, max: most, step: 1 }, { change: (next) => document && change(withSteps(document, next)) });
  const omegas = slider({ label: words.omega, name: "lesson-omega", min: 0.1, max: 1.9, step: 0.1 }, { change: setOmega });
  const panels = slider({ label: words.panel, name: "lesson-panel", min: 1, max: 2, step: 1 }, { change: setPanel });
  const radii = slider({ label: words.radius, name: "lesson-radius", min: 0.01, max: 0.5, step: 0.01 }, { change: setRadius });
  const row = (/** @type {string} */ name, /** @type {HTMLElement} */ input, /** @type {HTMLElement} */ value) => h("div", { class: "cell-parameter" }, label(name), input, value);
  const reading = h("div", { class: "cell-reading", "data-reading": figure.reading ?? "" });
  const controls = h(
    "div",
    { class: "cell-controls" },
    ...(figure.panels ? [row(words.steps, steps.element, stepsText)] : []),
    ...(hasRow ? [row(words.panel, panels.element, panelText)] : []),
    ...(figure.circle === null ? [] : [row(words.radius, radii.element, radiusText)]),
    ...(isCompared ? [row(words.omega, omegas.element, omegaText)] : []),
    reading,
  );

  /** @type {Lane<Job, Known>} */
  const lane = new Lane({
    work: (job, signal) => ask(job, signal),
    done(found) {
      if (isOver) return;
      known = found;
      kept = found.solved;
      host.failed(null);
      render();
      const { job } = found;
      if (job.document === document && job.place === place && job.omega === omega && !job.isMoving) host.element.dataset.drawn = "true";
    },
    failed(error) {
      if (isOver || /** @type {Error} */ (error).name === "AbortError") return;
      host.failed(error);
    },
  });

  /** @param {Job} job @param {AbortSignal} signal @returns {Promise<Known>} */
  async function ask(job, signal) {
    const control = { signal };
    const longest = job.isMoving ? MOVING : FINE;
    const isKnown = kept?.document === job.document && Math.max(...kept.section.size) >= longest;
    const solved = isKnown && kept ? kept : await solve(job, longest, control);
    const at = async (/** @type {number[]} */ points) => (await solved.solution.at(points, { outside: "skip" }, control)).values;
    const found = job.place ? await at(job.place) : null;
    const around = job.place && figure.circle !== null ? await at(circleOf(job.place, radius)) : null;
    const runs = isCompared ? await compare(solved.boundary, job, control) : [];
    return { job, solved, found, around: around?.some(Number.isNaN) ? null : around, runs };
  }

  /** @param {Job} job @param {number} longest @param {{signal: AbortSignal}} control @returns {Promise<Solved>} */
  async function solve({ document: given }, longest, control) {
    const boundary = await kernel.boundary(given, control);
    const solution = kept?.document === given ? kept.solution : await kernel.solveLaplace(inputOf(boundary), control);
    const { frame, box } = frameOf(given, boundary, longest);
    const section = await solution.section(frame, control);
    const [width, height] = section.size;
    const picture = h("canvas", { width, height });
    const pixels = grown(colorsOf(section, given.materials ?? [], true), section.size, boundary.dimension === 2 ? 2 : 0);
    picture.getContext("2d")?.putImageData(new ImageData(pixels, width, height), 0, 0);
    const lines = LEVELS.flatMap((level) => levelLines(section.values[0], section.size, level));
    const levels = Array.from({ length: lines.length / 4 }, (_, n) => lines.slice(4 * n, 4 * n + 4).map((each) => each + 0.5));
    const matrix = hasRow ? matrixOf(boundary) : null;
    const errors = figure.reading === "error" ? await measure(given, control) : [];
    const isSmall = boundary.groups.length <= MOST_CONDITION;
    const condition = isCompared && isSmall ? (await kernel.solveLaplace(inputOf(boundary, { condition: true }), control)).condition : null;
    return { document: given, boundary, solution, box, section, picture, levels: levels.map((each) => each.join(" ")).join(";"), matrix, errors, condition };
  }

  /** How far the solution is from the exact one, by steps along a side. @param {LaplaceDocument} given @param {{signal: AbortSignal}} control */
  async function measure(given, control) {
    const points = probes((await kernel.boundary(given, control)).dimension);
    const exact = await kernel.exact(given, points, control);
    const own = stepsOf(given);
    const rows = [];
    for (const size of [...new Set([...SIZES, own])].sort((a, b) => a - b)) {
      const boundary = await kernel.boundary(withSteps(given, size), control);
      const solution = await kernel.solveLaplace(inputOf(boundary, { ...boundary.solver, tolerance: 1e-9 }), control);
      const { values } = await solution.at(points, {}, control);
      rows.push({ panels: boundary.groups.length, error: farthest(values, exact) });
    }
    return rows;
  }

  /** Residuals of each preconditioner; those without a parameter are found once. @param {LaplaceBoundary} boundary @param {Job} job @param {{signal: AbortSignal}} control */
  async function compare(boundary, job, control) {
    const run = async (/** @type {Run["name"]} */ name) => {
      const own = name === "ssor" ? { omega: job.omega } : {};
      /** @type {LaplaceSolver} */
      const solver = { ...FOLLOWED, preconditioner: name, ...own };
      const { residuals, iterations, converged, times } = await kernel.solveLaplace(inputOf(boundary, solver), control);
      return { name, residuals: residuals[0], iterations: iterations[0], converged, time: times.solve };
    };
    if (steady?.document !== job.document) steady = { document: job.document, runs: [await run("none"), await run("jacobi")] };
    return [...steady.runs, await run("ssor")];
  }

  function paint() {
    const { width, height } = surface.size();
    if (!document || width < 1 || height < 1) return;
    lane.push({ document, place, omega, isMoving });
    render();
  }

  /** @param {LaplaceDocument} next */
  function change(next) {
    document = next;
    touch(true);
  }

  /** @param {number} next */
  function setOmega(next) {
    omega = next;
    touch(true);
  }

  /** @param {number} next */
  function setPanel(next) {
    panel = next - 1;
    host.touched();
    render();
  }

  /** @param {number} next */
  function setRadius(next) {
    radius = next;
    touch(true);
  }

  /** Something is different. @param {boolean} isDrag whether more of it is about to come */
  function touch(isDrag) {
    host.touched();
    delete host.element.dataset.drawn;
    isMoving = isDrag;
    clearTimeout(idle);
    if (isDrag) idle = setTimeout(rest, IDLE);
    paint();
  }

  function rest() {
    isMoving = false;
    paint();
  }

  /** @param {Solved} solved @returns {View} */
  const viewOf = ({ box }) => fitting(box, surface.size(), MARGIN);

  function face() {
    if (!document) return;
    const size = stepsOf(document);
    steps.set(size);
    write(stepsText, String(size));
    omegas.set(omega);
    write(omegaText, fixed(omega, 1));
    radii.set(radius);
    write(radiusText, fixed(radius, 2));
    const count = known?.solved.matrix?.count;
    if (count === undefined) return;
    panel = Math.min(panel, count - 1);
    panels.setMax(count);
    panels.set(panel + 1);
    write(panelText, words.numbered(panel + 1, count));
    attribute(panels.input, "aria-valuetext", words.numbered(panel + 1, count));
  }

  function render() {
    face();
    const now = known;
    const { width, height } = surface.size();
    if (!now || isOver || width < 1 || height < 1) return;
    const { solved } = now;
    const view = viewOf(solved);
    const seen = (/** @type {readonly number[]} */ at) => toScreen(view, { width, height }, /** @type {Point} */ (at));
    attribute(over, "viewBox", `0 0 ${width} ${height}`);
    attribute(canvas, "aria-label", host.alt());
    const own = solved.boundary.dimension === 2 ? panelsOf(solved.boundary) : [];
    drawPicture(solved, own, seen);
    const isFew = own.length <= DRAWN;
    const line = (/** @type {typeof own[number]} */ { from, to }) => `M${written(seen(from))}L${written(seen(to))}`;
    attribute(boundary, "d", own.map(line).join(""));
    attribute(ends, "d", isFew && figure.panels ? own.map(({ from }) => `M${written(seen(from))}h.01`).join("") : "");
    const dots = isFew && figure.panels ? own.map(({ middle }) => `M${written(seen(middle))}h.01`).join("") : "";
    attribute(middles, "d", dots);
    attribute(under, "d", dots);
    attribute(chosen, "d", hasRow && own[panel] ? line(own[panel]) : "");
    if (place) handle.show(surface.zoom, words.place(fixed(place[0], 2), fixed(place[1], 2)));
    const ring = place && figure.circle !== null ? round(seen(place), radius * view.scale) : "";
    attribute(circle, "d", ring);
    attribute(circleUnder, "d", ring);
    drawStatus(now);
    reading.replaceChildren(...readingOf(figure, now, panel, getComputedStyle(host.element).getPropertyValue("--accent")));
    name(own, seen, view);
  }

  /** The fractions by their colours, cut off at the boundary of a body in the plane. @param {Solved} solved @param {ReturnType<typeof panelsOf>} own @param {(at: readonly number[]) => Point} seen */
  function drawPicture({ picture, box, section, levels: given }, own, seen) {
    const { width, height } = surface.size();
    const ratio = surface.zoom * (window.devicePixelRatio || 1);
    [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    const [[left, bottom], [right, top]] = box.map(seen);
    const pixel = (right - left) / section.size[0];
    const path = given === "" ? [] : given.split(";").map((each) => each.split(" ").map(Number));
    attribute(levels, "d", path.map(([a, b, c, d]) => `M${written([left + a * pixel, bottom - b * pixel])}L${written([left + c * pixel, bottom - d * pixel])}`).join(""));
    const context = canvas.getContext("2d");
    if (!context) return;
    context.scale(ratio, ratio);
    if (own.length > 0) {
      context.beginPath();
      for (const [n, { from, to }] of own.entries()) {
        const before = own[n - 1];
        if (!before || before.to[0] !== from[0] || before.to[1] !== from[1]) context.moveTo(...seen(from));
        context.lineTo(...seen(to));
      }
      context.clip("evenodd");
    }
    context.drawImage(picture, left, top, right - left, bottom - top);
  }

  /** @param {Known} now */
  function drawStatus({ solved, found }) {
    const item = (/** @type {string} */ text, /** @type {string} */ value, /** @type {string} */ own) => h("span", {}, `${text} `, h("span", { class: "strong number", "data-lesson": own }, value));
    const count = solved.boundary.groups.length;
    status.hidden = figure.controls === "none";
    if (!found) status.replaceChildren(h("span", { "data-lesson": "panels" }, solved.boundary.dimension === 2 ? words.panels(count) : words.triangles(count)));
    else if (found.some(Number.isNaN)) status.replaceChildren(h("span", {}, words.outside));
    else status.replaceChildren(...(solved.document.materials ?? []).map(({ name }, k) => item(name, fixed(found[k], 3), `mix-${k}`)));
  }

  /** What the terms of the text mean. @param {ReturnType<typeof panelsOf>} own @param {(at: readonly number[]) => Point} seen @param {View} view */
  function name(own, seen, view) {
    const middle = place ? seen(place) : null;
    /** @type {{[name: string]: () => Part}} */
    const all = {
      boundary: () => ({ lines: own.map(({ from, to }) => [seen(from), seen(to)]) }),
      middles: () => ({ dots: own.map(({ middle }) => seen(middle)) }),
      panel: () => ({ lines: own[panel] ? [[seen(own[panel].from), seen(own[panel].to)]] : [] }),
      place: () => ({ dots: middle ? [middle] : [] }),
      circle: () => ({ lines: middle ? [Array.from({ length: 65 }, (_, n) => /** @type {Point} */ ([middle[0] + radius * view.scale * Math.cos((n * Math.PI) / 32), middle[1] + radius * view.scale * Math.sin((n * Math.PI) / 32)]))] : [] }),
    };
    /** @type {Parts} */
    const parts = new Map();
    for (const term of host.terms) if (all[term]) parts.set(term, all[term]());
    surface.name(parts);
  }

  /** @param {Point} at on the screen @param {boolean} isDrag */
  function put(at, isDrag) {
    if (!known) return;
    const [[left, low], [right, high]] = known.solved.box;
    const [x, y] = toPlane(viewOf(known.solved), surface.size(), at);
    place = [Math.min(right, Math.max(left, x)), Math.min(high, Math.max(low, y))];
    touch(isDrag);
  }

  return {
    status,
    controls: figure.controls === "none" ? null : controls,
    show(next) {
      clearTimeout(idle);
      first = /** @type {LaplaceDocument} */ (/** @type {unknown} */ (next));
      [document, place, radius, omega, panel, isMoving, steady] = [first, figure.place, figure.circle ?? 0, 0.5, 0, false, null];
      paint();
    },
    draw: paint,
    state: () => (document ? { document: /** @type {CurvesDocument} */ (/** @type {unknown} */ (document)), s: null, step: null } : null),
    close() {
      isOver = true;
      clearTimeout(idle);
      lane.cancel();
    },
  };
}

/** @param {readonly number[]} at */
const written = ([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`;

/** @param {Point} center @param {number} radius */
const round = ([x, y], radius) => `M${x - radius} ${y}a${radius} ${radius} 0 1 0 ${2 * radius} 0a${radius} ${radius} 0 1 0 ${-2 * radius} 0Z`;
