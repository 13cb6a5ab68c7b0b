/**
 * A figure of one cell: its body with the net of its 64 coefficients, a place u, v, w in it with what is summed there, and coefficients
 * that are moved by hand. It is painted as figures on other pages are, so no graphics card is needed.
 *
 * @import { BodySurface, CellVerdict } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { Camera } from "../space/camera.js"
 * @import { Vector } from "../space/vector.js"
 * @import { CurvesDocument, Point } from "../types.js"
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 * @import { Cell, BodyDocument } from "../hyperpatch/document.js"
 * @import { Index } from "./cell-sum.js"
 * @import { FigureView, Host } from "./figure.js"
 * @import { Part, Parts } from "./parts.js"
 */
import "../../styles/lesson-cell.css";
import { createOrbit } from "../../../js/element/body/orbit.js";
import { paint as paintBody, shapeOf } from "../../../js/element/body/picture.js";
import { numberField } from "../controls/number-field.js";
import { select } from "../controls/select.js";
import { slider } from "../controls/slider.js";
import { attribute, h, svg, write } from "../dom.js";
import { coordinate, fixed } from "../format.js";
import { icon, symbol } from "../icons.js";
import { edgeSegments, placeOf, sampleAt } from "../hyperpatch/cell.js";
import { cellsOf } from "../hyperpatch/document.js";
import { axesOf, fitted, seenAt, STANDARD, unitsPerPixel } from "../space/camera.js";
import { add, cornersOf, scaled } from "../space/vector.js";
import { Lane } from "../state/lane.js";
import { INDICES, jacobianAt } from "./cell-sum.js";
import { createReading } from "./cell-reading.js";
import { words } from "./words.js";

/** Steps of the sliders of u, v and w. */
const STEP = 0.01;
/** Pieces of a line of parameters as it is drawn. */
const PIECES = 24;
/** Step of an arrow key, as a share of the box of the cell; digits of a coordinate that was dragged. */
const NUDGE = 0.02;
const DIGITS = 3;
/** Milliseconds after a change until the picture is fine again. */
const IDLE = 200;

/** @type {{[key: string]: Vector}} */
const ARROWS = { ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, 0, 1], ArrowDown: [0, 0, -1] };

/** @typedef {{document: BodyDocument, surface: BodySurface, verdict: CellVerdict}} Known */

/**
 * @param {App} app
 * @param {Host} host
 * @param {Figure} figure of the view `body`
 * @returns {FigureView}
 */
export function createBodyFigure(app, host, figure) {
  const { kernel, ui } = app;
  const { surface } = host;
  const canMove = figure.controls === "full";
  const canvas = h("canvas", { role: "img", width: 1, height: 1 });
  const status = h("p", { class: "lesson-status" });
  const net = svg("path", { class: "cell-net" });
  const through = svg("path", { class: "cell-through" });
  const dots = svg("path", { class: "cell-dots" });
  const pointUnder = svg("path", { class: "cell-point-under" });
  const point = svg("path", { class: "cell-point" });
  const over = svg("svg", { class: "lesson-cell", "aria-hidden": "true" }, net, through, dots, pointUnder, point);
  const handle = h("button", { type: "button", class: "handle round chosen", "data-lesson": "coefficient" });
  const handles = h("div", { class: "lesson-handles", hidden: !canMove }, handle);
  const orbit = createOrbit({
    camera: () => camera,
    frame,
    fitted: () => whole,
    turn(next) {
      camera = next;
      follows = false;
      moved();
    },
    fit(view) {
      fit(view ? STANDARD[view] : camera);
      moved();
    },
    rest: () => rest(),
    say: app.say,
  });
  surface.element.prepend(canvas, /** @type {any} */ (over), ...orbit.elements);
  surface.element.append(handles);

  /** @type {BodyDocument | null} */
  let document = null;
  /** @type {Known | null} */
  let known = null;
  /** @type {ReturnType<typeof shapeOf> | null} */
  let shape = null;
  /** @type {Vector} */
  let uvw = figure.point ?? [0.5, 0.5, 0.5];
  /** @type {Index} */
  let chosen = figure.coefficient ?? [3, 3, 3];
  /** @type {Camera} */
  let camera = { ...STANDARD.iso, target: [0, 0, 0], distance: 1 };
  let whole = 1;
  let follows = true;
  let isFine = true;
  let isOver = false;
  let asked = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let idle;

  const reading = figure.reading ? createReading(figure.reading) : null;
  const axes = /** @type {const} */ (["u", "v", "w"]);
  const sliders = axes.map((name, axis) => {
    const control = slider({ label: words.cell.parameter(name), name: `lesson-${name}`, min: 0, max: 1, step: STEP }, { change: (next) => place(axis, next) });
    const value = h("span", { class: "number strong" });
    return { ...control, value, row: h("div", { class: "cell-parameter" }, h("i", {}, name), control.element, value) };
  });
  const choices = INDICES.map((index) => ({ value: index.join(" "), text: words.cell.coefficient(index) }));
  const which = select({ label: words.cell.which, name: "lesson-coefficient", choices }, (value) => {
    choose(/** @type {Index} */ (value.split(" ").map(Number)));
  });
  const fields = /** @type {const} */ (["x", "y", "z"]).map((name, axis) =>
    numberField(
      { label: words.cell.coordinate(name), name: `lesson-${name}`, prefix: name, min: -1000, max: 1000, step: () => nudge() / 2, decimals: 2, rounded: true },
      { change: (next) => moveTo(axis, next), end: () => rest() },
    ),
  );
  const inputs = [...fields.map(({ element }) => element), ...fields.map(({ error }) => error)];
  const controls = h(
    "div",
    { class: "cell-controls" },
    canMove ? h("div", { class: "cell-coefficient" }, h("span", { class: "cell-label" }, words.cell.which), which.element, ...inputs) : null,
    figure.point ? h("div", { class: "cell-parameters" }, ...sliders.map(({ row }) => row)) : null,
    reading?.element ?? null,
  );

  /** @type {Lane<BodyDocument, Known>} */
  const lane = new Lane({
    async work(job, signal) {
      const body = await kernel.hyperpatch(job, { signal });
      const found = await body.surface({}, { signal });
      const [verdict] = await body.verdicts({}, { signal });
      return { document: job, surface: found, verdict };
    },
    done(found) {
      if (isOver) return;
      known = found;
      shape = shapeOf(found.surface);
      host.failed(null);
      if (follows) fit(camera);
      draw();
      drawn();
    },
    failed(error) {
      if (isOver || /** @type {Error} */ (error).name === "AbortError") return;
      host.failed(error);
    },
  });

  function frame() {
    const { width, height } = surface.size();
    return { size: { width: Math.max(1, width), height: Math.max(1, height) }, top: 0, bottom: 0 };
  }

  /** The cell as it is moved, which the picture follows. @returns {Cell | null} */
  const cell = () => (document && cellsOf(document)[0]) ?? null;

  /** Of the coefficients, which the body lies within. */
  function boxOf(/** @type {Cell} */ { coefficients }) {
    const [min, max] = [Math.min, Math.max].map((most) => [0, 1, 2].map((axis) => most(...coefficients.map(({ position }) => position[axis]))));
    return { min: /** @type {Vector} */ (min), max: /** @type {Vector} */ (max) };
  }

  function nudge() {
    const now = cell();
    if (!now) return NUDGE;
    const { min, max } = boxOf(now);
    return Number((NUDGE * Math.max(...max.map((high, axis) => high - min[axis]))).toPrecision(1));
  }

  /** @param {Pick<Camera, "azimuth" | "elevation">} direction */
  function fit(direction) {
    const now = cell();
    if (!now) return;
    camera = fitted(direction, frame(), cornersOf(boxOf(now)));
    whole = camera.distance;
    follows = true;
  }

  /** The picture has changed and may go on to. */
  function moved() {
    isFine = false;
    if (asked === 0) asked = requestAnimationFrame(draw);
    clearTimeout(idle);
    idle = setTimeout(rest, IDLE);
  }

  function rest() {
    clearTimeout(idle);
    if (isFine || isOver) return;
    isFine = true;
    draw();
  }

  function draw() {
    cancelAnimationFrame(asked);
    asked = 0;
    const now = cell();
    const { width, height } = surface.size();
    if (isOver || !now || width < 1 || height < 1) return;
    const ratio = surface.zoom * (window.devicePixelRatio || 1);
    const { witness } = known?.verdict ?? {};
    const look = { camera, frame: frame(), ratio, theme: ui.value.theme, isFine, isSmall: true, witnesses: witness ? [witness.point] : [] };
    if (shape) paintBody(canvas, shape, null, look);
    drawOver(now);
  }

  /** @param {readonly number[]} position */
  const seen = (position) => seenAt(camera, frame(), position).at;

  /** What lies over the body: net, coefficients, and the place with its lines of parameters. @param {Cell} now */
  function drawOver(now) {
    const { width, height } = surface.size();
    attribute(over, "viewBox", `0 0 ${width} ${height}`);
    const at = now.coefficients.map(({ position }) => seen(position));
    const lines = netOf(at);
    const crossing = figure.point ? [0, 1, 2].map((axis) => lineThrough(now, axis)) : [];
    attribute(net, "d", pathOf(lines));
    attribute(dots, "d", at.map(dot).join(""));
    attribute(through, "d", pathOf(crossing));
    const here = figure.point ? seen(sampleAt(now, uvw, 1).position) : null;
    for (const each of [point, pointUnder]) attribute(each, "d", here ? dot(here) : "");
    const own = now.coefficients[placeOf(...chosen)].position;
    const [x, y] = seen(own).map((each) => each * surface.zoom);
    handle.style.transform = `translate(${x}px, ${y}px)`;
    attribute(handle, "aria-label", words.cell.handle(chosen, ...placeText(own)));
    which.set(chosen.join(" "));
    fields.forEach(({ set }, axis) => set(own[axis]));
    sliders.forEach(({ set, value, input }, axis) => {
      set(uvw[axis]);
      write(value, fixed(uvw[axis], 2));
      attribute(input, "aria-valuetext", fixed(uvw[axis], 2));
    });
    reading?.render({ cell: now, uvw, materials: document?.materials ?? [], verdict: known?.document === document ? known.verdict : null });
    name(at, lines, crossing, here);
  }

  /** Numbers beside the picture, and names for what the terms of the text mean. */
  function drawn() {
    attribute(canvas, "aria-label", host.alt());
    const verdict = known?.verdict;
    if (verdict) {
      const isSound = verdict.verdict === "regular" || verdict.verdict === "valid";
      status.replaceChildren(
        ...(isSound ? [icon("check", 14)] : []),
        h("span", { class: verdict.verdict === "invalid" ? "failed" : "", "data-lesson": "verdict" }, words.cell.verdicts[verdict.verdict]),
        ...(figure.reading === "jacobian" ? [h("span", {}, symbol("J"), " ", h("span", { class: "strong number" }, fixed(jacobianAt(/** @type {Cell} */ (cell()), uvw), 2)))] : []),
      );
      status.hidden = figure.controls === "none";
    }
    host.element.dataset.drawn = "true";
  }

  /** A line of parameters through the place. @param {Cell} now @param {number} axis @returns {Point[]} */
  function lineThrough(now, axis) {
    return Array.from({ length: PIECES + 1 }, (_, n) => seen(sampleAt(now, uvw.map((own, k) => (k === axis ? n / PIECES : own)), 1).position));
  }

  /**
   * @param {Point[]} at of the coefficients
   * @param {Point[][]} lines of the net
   * @param {Point[][]} crossing
   * @param {Point | null} here
   */
  function name(at, lines, crossing, here) {
    const now = cell();
    if (!now) return;
    const { witness } = known?.verdict ?? {};
    /** @type {{[name: string]: () => Part}} */
    const parts = {
      coefficients: () => ({ dots: at }),
      coefficient: () => ({ dots: [at[placeOf(...chosen)]] }),
      corners: () => ({ dots: INDICES.flatMap((index, n) => (index.every((each) => each % 3 === 0) ? [at[n]] : [])) }),
      inner: () => ({ dots: INDICES.flatMap((index, n) => (index.every((each) => each % 3 !== 0) ? [at[n]] : [])) }),
      net: () => ({ lines }),
      edges: () => {
        const ends = edgeSegments(now);
        const end = (/** @type {number} */ start) => seen(ends.slice(start, start + 3));
        return { lines: Array.from({ length: ends.length / 6 }, (_, n) => [end(6 * n), end(6 * n + 3)]) };
      },
      point: () => ({ dots: here ? [here] : [] }),
      through: () => ({ lines: crossing }),
      witness: () => ({ dots: witness ? [seen(witness.point)] : [] }),
    };
    /** @type {Parts} */
    const found = new Map();
    for (const term of host.terms) if (parts[term]) found.set(term, parts[term]());
    surface.name(found);
  }

  /** @param {number} axis @param {number} value */
  function place(axis, value) {
    uvw = /** @type {Vector} */ (uvw.map((own, k) => (k === axis ? value : own)));
    host.touched();
    const now = cell();
    if (now) drawOver(now);
    drawn();
  }

  /** @param {Index} index */
  function choose(index) {
    chosen = index;
    host.touched();
    const now = cell();
    if (now) drawOver(now);
  }

  /** Moves the chosen coefficient, and nothing else. @param {readonly number[]} to */
  function put(to) {
    if (!document) return;
    const n = placeOf(...chosen);
    const replaced = (/** @type {Cell} */ { coefficients }) => ({
      coefficients: coefficients.map((own, k) => (k === n ? { ...own, position: /** @type {Vector} */ ([...to]) } : own)),
    });
    const operations = document.operations.map((operation) =>
      operation.op === "cells" ? { ...operation, cells: /** @type {Cell[]} */ (operation.cells).map(replaced) } : operation,
    );
    document = /** @type {BodyDocument} */ ({ ...document, operations });
    follows = false;
    host.touched();
    lane.push(document);
    moved();
  }

  /** @param {number} axis @param {number} value */
  function moveTo(axis, value) {
    const own = cell()?.coefficients[placeOf(...chosen)].position;
    if (own) put(own.map((each, k) => (k === axis ? value : each)));
  }

  /** @param {readonly number[]} position @returns {[string, string, string]} */
  const placeText = (position) => [coordinate(position[0]), coordinate(position[1]), coordinate(position[2])];

  /** Where a drag of the handle began: on the screen, and in space. @type {{at: Point, position: readonly number[]} | null} */
  let grabbed = null;
  handle.addEventListener("pointerdown", (event) => {
    const own = cell()?.coefficients[placeOf(...chosen)].position;
    if (event.button !== 0 || !own) return;
    event.preventDefault();
    handle.focus({ preventScroll: true });
    handle.setPointerCapture(event.pointerId);
    grabbed = { at: surface.placeOf(event), position: own };
  });
  handle.addEventListener("pointermove", (event) => {
    if (!grabbed) return;
    // Across the view, at the depth where it lies.
    const { right, up } = axesOf(camera);
    const [x, y] = surface.placeOf(event);
    const { depth } = seenAt(camera, frame(), grabbed.position);
    const units = (unitsPerPixel(camera, frame()) * depth) / camera.distance;
    const to = add(grabbed.position, add(scaled(right, (x - grabbed.at[0]) * units), scaled(up, (grabbed.at[1] - y) * units)));
    put(to.map((each) => Number(each.toFixed(DIGITS)) + 0));
  });
  for (const type of /** @type {const} */ (["pointerup", "pointercancel"])) {
    handle.addEventListener(type, () => {
      grabbed = null;
      rest();
    });
  }
  handle.addEventListener("keydown", (event) => {
    const arrow = ARROWS[event.key];
    const own = cell()?.coefficients[placeOf(...chosen)].position;
    if (!arrow || !own || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    const by = nudge() * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
    const to = add(own, scaled(arrow, by)).map((each) => Number(each.toFixed(9)) + 0);
    put(to);
    app.say(words.cell.handle(chosen, ...placeText(to)));
  });
  // A tap near a coefficient takes it.
  surface.element.addEventListener("click", (event) => {
    const now = cell();
    if (!canMove || !now || event.target === handle) return;
    const here = surface.placeOf(event);
    const reach = matchMedia("(pointer: coarse)").matches ? 22 : 12;
    const far = now.coefficients.map(({ position }) => Math.hypot(...seen(position).map((each, k) => each - here[k])));
    const nearest = Math.min(...far);
    if (nearest <= reach) choose(INDICES[far.indexOf(nearest)]);
  });

  return {
    status,
    controls: controls.childElementCount > 0 && figure.controls !== "none" ? controls : null,
    show(next) {
      document = /** @type {BodyDocument} */ (/** @type {unknown} */ (next));
      known = shape = null;
      uvw = figure.point ?? [0.5, 0.5, 0.5];
      chosen = figure.coefficient ?? [3, 3, 3];
      isFine = true;
      fit(STANDARD.iso);
      lane.push(document);
    },
    draw() {
      if (follows) fit(camera);
      draw();
    },
    state: () => (document ? { document: /** @type {CurvesDocument} */ (/** @type {unknown} */ (document)), s: null, step: null } : null),
    close() {
      isOver = true;
      cancelAnimationFrame(asked);
      clearTimeout(idle);
      lane.cancel();
    },
  };
}

/** The lines of the net: along each parameter from coefficient to coefficient. @param {Point[]} at @returns {Point[][]} */
function netOf(at) {
  const lines = [];
  for (const a of [0, 1, 2, 3]) {
    for (const b of [0, 1, 2, 3]) {
      const along = [0, 1, 2, 3];
      lines.push(along.map((n) => at[placeOf(n, a, b)]), along.map((n) => at[placeOf(a, n, b)]), along.map((n) => at[placeOf(a, b, n)]));
    }
  }
  return lines;
}

/** @param {Point} place */
const written = ([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`;

/** @param {Point[][]} lines */
const pathOf = (lines) => lines.map((line) => `M${line.map(written).join("L")}`).join("");

/** @param {Point} place */
const dot = (place) => `M${written(place)}h.01`;
