/**
 * A figure of a boundary value problem: its solution in the plane or in a section, with its panels, a place that is read with a circle round it, and below
 * it means, extremes, influences, the matrix, errors or residuals. All of it is solved when it is shown.
 *
 * @import { LaplaceDocument, Point, View } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 * @import { FigureView, Host } from "./figure.js"
 * @import { Job, Known, Solved } from "./laplace-solver.js"
 */
import "../../styles/lesson-cell.css";
import "../../styles/lesson-laplace.css";
import { fitting, toScreen } from "../../../js/element/plane.js";
import { attribute, h, svg } from "../dom.js";
import { fixed } from "../format.js";
import { Lane } from "../state/lane.js";
import { createChanging } from "./changing.js";
import { shownState } from "./document.js";
import { panelsOf, stepsOf, withSteps } from "./laplace-known.js";
import { readingOf } from "./laplace-reading.js";
import { createLaplaceSolver } from "./laplace-solver.js";
import { measure, parameter } from "./parameter.js";
import { partsOf } from "./parts.js";
import * as path from "./path.js";
import { createPlaceHandle } from "./place-handle.js";
import { words } from "./words-laplace.js";

/** Room round the body, CSS pixels. */
const MARGIN = 24;
/** Most panels whose middles are drawn. */
const DRAWN = 128;
/** The parameter of SSOR at first. */
const OMEGA = 0.5;

/**
 * @param {App} app
 * @param {Host} host
 * @param {Figure} figure of the view `laplace`
 * @returns {FigureView}
 */
export function createLaplaceFigure(app, host, figure) {
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
  surface.element.prepend(canvas, /** @type {any} */ (over));

  /** @type {LaplaceDocument | null} */
  let document = null;
  /** @type {Known | null} */
  let known = null;
  let radius = figure.circle ?? 0;
  let omega = OMEGA;
  let panel = 0;
  let isOver = false;

  const changing = createChanging(host, paint);
  const handle = createPlaceHandle(surface, {
    place: figure.place,
    digits: 2,
    ground: () => known && { view: viewOf(known.solved), box: known.solved.box },
    changed: changing.touch,
    released: changing.rest,
    say: app.say,
  });
  const isCompared = figure.reading === "residuals";
  const hasRow = figure.reading === "influence" || figure.reading === "matrix";
  const [fewest, most] = figure.panels ?? [1, 2];
  const steps = parameter({ label: words.steps, name: "steps", min: fewest, max: most, step: 1 }, (next) => {
    if (document) document = withSteps(document, next);
    changing.touch(true);
  });
  const panels = parameter({ label: words.panel, name: "panel", min: 1, max: 2, step: 1 }, (next) => {
    panel = next - 1;
    host.touched();
    render();
  });
  const radii = parameter({ label: words.radius, name: "radius", min: 0.01, max: 0.5, step: 0.01 }, (next) => {
    radius = next;
    changing.touch(true);
  });
  const omegas = parameter({ label: words.omega, name: "omega", min: 0.1, max: 1.9, step: 0.1 }, (next) => {
    omega = next;
    changing.touch(true);
  });
  const reading = h("div", { class: "cell-reading", "data-reading": figure.reading ?? "" });
  const controls = h(
    "div",
    { class: "cell-controls" },
    figure.panels ? steps.row : null,
    hasRow ? panels.row : null,
    figure.circle === null ? null : radii.row,
    isCompared ? omegas.row : null,
    reading,
  );

  /** @type {Lane<Job, Known>} */
  const lane = new Lane({
    work: createLaplaceSolver(app.kernel, figure),
    done(found) {
      if (isOver) return;
      known = found;
      host.failed(null);
      render();
      const { job } = found;
      if (job.document === document && job.place === handle.place && job.omega === omega && !job.isMoving) host.element.dataset.drawn = "true";
    },
    failed: host.failed,
  });

  function paint() {
    const { width, height } = surface.size();
    if (!document || width < 1 || height < 1) return;
    lane.push({ document, place: handle.place, radius, omega, isMoving: changing.isMoving });
    render();
  }

  /** @param {Solved} solved @returns {View} */
  const viewOf = ({ box }) => fitting(box, surface.size(), MARGIN);

  function face() {
    if (!document) return;
    steps.set(stepsOf(document), String(stepsOf(document)));
    omegas.set(omega, fixed(omega, 1));
    radii.set(radius, fixed(radius, 2));
    const count = known?.solved.matrix?.count;
    if (count === undefined) return;
    panel = Math.min(panel, count - 1);
    panels.setMax(count);
    panels.set(panel + 1, words.numbered(panel + 1, count));
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
    const line = (/** @type {typeof own[number]} */ { from, to }) => path.polyline([seen(from), seen(to)]);
    attribute(boundary, "d", own.map(line).join(""));
    attribute(ends, "d", isFew && figure.panels ? own.map(({ from }) => path.dot(seen(from))).join("") : "");
    const dots = isFew && figure.panels ? own.map(({ middle }) => path.dot(seen(middle))).join("") : "";
    attribute(middles, "d", dots);
    attribute(under, "d", dots);
    attribute(chosen, "d", hasRow && own[panel] ? line(own[panel]) : "");
    handle.render();
    const ring = handle.place && figure.circle !== null ? path.circle(seen(handle.place), radius * view.scale) : "";
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
    const onScreen = (/** @type {number} */ x, /** @type {number} */ y) => /** @type {Point} */ ([left + x * pixel, bottom - y * pixel]);
    attribute(levels, "d", given.map(([a, b, c, d]) => path.polyline([onScreen(a, b), onScreen(c, d)])).join(""));
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
    const count = solved.boundary.groups.length;
    status.hidden = figure.controls === "none";
    if (!found) status.replaceChildren(h("span", { "data-lesson": "panels" }, solved.boundary.dimension === 2 ? words.panels(count) : words.triangles(count)));
    else if (found.some(Number.isNaN)) status.replaceChildren(h("span", {}, words.outside));
    else status.replaceChildren(...(solved.document.materials ?? []).map(({ name }, k) => measure(name, fixed(found[k], 3), `mix-${k}`)));
  }

  /** What the terms of the text mean. @param {ReturnType<typeof panelsOf>} own @param {(at: readonly number[]) => Point} seen @param {View} view */
  function name(own, seen, view) {
    const middle = handle.place ? seen(handle.place) : null;
    surface.name(
      partsOf(host.terms, {
        boundary: () => ({ lines: own.map(({ from, to }) => [seen(from), seen(to)]) }),
        middles: () => ({ dots: own.map(({ middle }) => seen(middle)) }),
        panel: () => ({ lines: own[panel] ? [[seen(own[panel].from), seen(own[panel].to)]] : [] }),
        place: () => ({ dots: middle ? [middle] : [] }),
        circle: () => ({ lines: middle ? [path.roundOf(middle, radius * view.scale)] : [] }),
      }),
    );
  }

  return {
    status,
    controls: figure.controls === "none" ? null : controls,
    show(next) {
      changing.stop();
      handle.reset();
      document = /** @type {LaplaceDocument} */ (/** @type {unknown} */ (next));
      [radius, omega, panel] = [figure.circle ?? 0, OMEGA, 0];
      paint();
    },
    draw: paint,
    state: () => shownState(document),
    close() {
      isOver = true;
      changing.stop();
      lane.cancel();
    },
  };
}
