/**
 * A figure of a body: with the net of one of its cells, or with the coefficients round a corner; a place u, v, w in it with what is read there,
 * and coefficients that are moved by hand. It is painted as figures on other pages are, so no graphics card is needed.
 *
 * @import { App } from "../state/app.js"
 * @import { Camera } from "../space/camera.js"
 * @import { Vector } from "../space/vector.js"
 * @import { Point } from "../types.js"
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 * @import { Cell, BodyDocument } from "../hyperpatch/document.js"
 * @import { Chosen, Reach, Rule, Shares } from "./body-edits.js"
 * @import { Start } from "./body-handle.js"
 * @import { Job, Known } from "./body-known.js"
 * @import { FigureView, Host } from "./figure.js"
 */
import "../../styles/lesson-cell.css";
import { createOrbit } from "../../../js/element/body/orbit.js";
import { paint as paintBody, shapeOf } from "../../../js/element/body/picture.js";
import { attribute, h, svg } from "../dom.js";
import { coordinate, fixed } from "../format.js";
import { icon, symbol } from "../icons.js";
import { placeOf, sampleAt } from "../hyperpatch/cell.js";
import { cellsOf } from "../hyperpatch/document.js";
import { axesOf, fitted, seenAt, STANDARD, unitsPerPixel } from "../space/camera.js";
import { add, cornersOf, scaled } from "../space/vector.js";
import { Lane } from "../state/lane.js";
import { createBodyControls } from "./body-controls.js";
import { firstShares, graded, moved as displaced, placed, redone, twisted } from "./body-edits.js";
import { moveByHand } from "./body-handle.js";
import { known as ask } from "./body-known.js";
import { blockOf, edgesOf, lineThrough, netOf } from "./body-lines.js";
import { createReading } from "./cell-reading.js";
import { INDICES, jacobianAt } from "./cell-sum.js";
import { shownState } from "./document.js";
import { partsOf } from "./parts.js";
import { dot, polyline } from "./path.js";
import { words } from "./words-body.js";

/** Step of an arrow key, as a share of the box of the body. */
const NUDGE = 0.02;
/** Milliseconds after a change until the picture is fine again. */
const IDLE = 200;

/** The worst first. */
const WORST = /** @type {const} */ (["invalid", "degenerate", "locally-valid", "valid", "regular"]);

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
  const movingUnder = svg("path", { class: "cell-moving-under" });
  const moving = svg("path", { class: "cell-moving" });
  const pointUnder = svg("path", { class: "cell-point-under" });
  const point = svg("path", { class: "cell-point" });
  const over = svg("svg", { class: "lesson-cell", "aria-hidden": "true" }, net, through, dots, movingUnder, moving, pointUnder, point);
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
  /** @type {Chosen} */
  const first = { cell: figure.cell, at: figure.coefficient ?? [3, 3, 3] };
  let chosen = first;
  /** @type {Reach | null} */
  let reach = figure.reach;
  let twist = figure.twist ?? 0;
  /** @type {Shares} */
  let shares = firstShares(figure);
  /** @type {Rule | null} */
  let rule = figure.rule;
  let halvings = 0;
  /** @type {Camera} */
  let camera = { ...STANDARD.iso, target: [0, 0, 0], distance: 1 };
  let whole = 1;
  let follows = true;
  let isFine = true;
  let isOver = false;
  let asked = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let idle;

  const reading = figure.reading ? createReading(/** @type {Parameters<typeof createReading>[0]} */ (figure.reading)) : null;
  const controls = createBodyControls(figure, reading?.element ?? null, {
    place,
    choose,
    moveTo,
    rest: () => rest(),
    nudge,
    reach(next) {
      const again = document && reach ? redone(document, chosen, reach, next) : null;
      reach = next;
      if (again) change(again);
    },
    twist(next) {
      if (document) change(twisted(document, next - twist));
      twist = next;
    },
    shares: (next) => grade({ ...shares, ...next }, rule),
    rule: (next) => grade(shares, next),
    halve(next) {
      halvings = next;
      host.touched();
      redraw();
    },
  });

  /** @type {Lane<Job, Known>} */
  const lane = new Lane({
    work: (job, signal) => ask(kernel, figure, job, signal),
    done(found) {
      if (isOver) return;
      known = found;
      shape = shapeOf(found.surface);
      host.failed(null);
      if (follows) fit(camera);
      draw();
      drawn();
    },
    failed: host.failed,
  });

  function frame() {
    const { width, height } = surface.size();
    return { size: { width: Math.max(1, width), height: Math.max(1, height) }, top: 0, bottom: 0 };
  }

  /** The cells as they are moved, which the picture follows; where operations move them, as the kernel has found them. @returns {Cell[]} */
  function cells() {
    if (!document) return [];
    const isWritten = document.operations.every(({ op }) => op === "cells");
    return isWritten ? cellsOf(document) : (known?.cells ?? cellsOf(document));
  }

  /** The one of the figure. @returns {Cell | null} */
  const cell = () => cells()[figure.cell] ?? null;

  /** @param {Chosen} which */
  const positionOf = ({ cell, at }) => cells()[cell]?.coefficients[placeOf(...at)].position;

  /** Coefficients that are shown, and can be chosen: those round the corner once each. @returns {Chosen[]} */
  function shown() {
    if (figure.net === "none") return [];
    const around = known?.around;
    if (figure.net === "corner") return around ? around.points.map(({ users }) => users.find((user) => isOf(user, chosen)) ?? users[0]) : [first];
    return INDICES.map((at) => ({ cell: figure.cell, at }));
  }

  /** Of the coefficients, which the body lies within; of the body itself where they are not shown. */
  function boxOf() {
    if (figure.net === "none" && shape) return shape.bounds;
    const all = cells().flatMap(({ coefficients }) => coefficients);
    const [min, max] = [Math.min, Math.max].map((most) => [0, 1, 2].map((axis) => all.reduce((found, { position }) => most(found, position[axis]), all[0].position[axis])));
    return { min: /** @type {Vector} */ (min), max: /** @type {Vector} */ (max) };
  }

  function nudge() {
    if (!cell()) return NUDGE;
    const { min, max } = boxOf();
    return Number((NUDGE * Math.max(...max.map((high, axis) => high - min[axis]))).toPrecision(1));
  }

  /** @param {Pick<Camera, "azimuth" | "elevation">} direction */
  function fit(direction) {
    if (!cell()) return;
    camera = fitted(direction, frame(), cornersOf(boxOf()));
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
    const look = { camera, frame: frame(), ratio, theme: ui.value.theme, isFine, isSmall: true, witnesses: witnesses() };
    if (shape) paintBody(canvas, shape, null, look);
    drawOver(now);
  }

  const witnesses = () => (known?.verdicts ?? []).flatMap(({ witness }) => (witness ? [witness.point] : []));

  /** @param {readonly number[]} position */
  const seen = (position) => seenAt(camera, frame(), position).at;

  /** What lies over the body: net, coefficients, and the place with its lines of parameters. @param {Cell} now */
  function drawOver(now) {
    const { width, height } = surface.size();
    attribute(over, "viewBox", `0 0 ${width} ${height}`);
    const choices = shown();
    const at = choices.map((each) => seen(positionOf(each) ?? [0, 0, 0]));
    const project = (/** @type {Vector[][]} */ all) => all.map((each) => each.map(seen));
    const lines = project(figure.net === "cell" ? netOf(now, INDICES) : figure.net === "corner" ? cornerLines() : []);
    const crossing = project(figure.point ? [0, 1, 2].map((axis) => lineThrough(now, uvw, axis)) : []);
    const goes = (known?.moving ?? []).map((each) => seen(positionOf(each) ?? [0, 0, 0]));
    attribute(net, "d", lines.map(polyline).join(""));
    attribute(dots, "d", at.map(dot).join(""));
    for (const each of [moving, movingUnder]) attribute(each, "d", goes.map(dot).join(""));
    attribute(through, "d", crossing.map(polyline).join(""));
    const here = figure.point ? seen(sampleAt(now, uvw, 1).position) : null;
    for (const each of [point, pointUnder]) attribute(each, "d", here ? dot(here) : "");
    const own = positionOf(chosen) ?? [0, 0, 0];
    const [x, y] = seen(own).map((each) => each * surface.zoom);
    handle.style.transform = `translate(${x}px, ${y}px)`;
    attribute(handle, "aria-label", words.handle(chosen.at, ...placeText(own)));
    controls.render({ uvw, own, chosen, choices, reach, twist, shares, rule, halvings });
    const isCurrent = known?.job.document === document;
    reading?.render({
      cell: now,
      cells: cells(),
      uvw,
      materials: document?.materials ?? [],
      verdict: (isCurrent && known?.verdicts[figure.cell]) || null,
      known: isCurrent ? known : null,
      shares,
      rule,
      halvings,
    });
    name(at, lines, crossing, here, goes);
  }

  /** The lines of the blocks that meet in the corner. */
  function cornerLines() {
    const blocks = known?.around?.cells ?? [];
    return blocks.flatMap(({ cell, corner }) => {
      const own = cells()[cell];
      return own ? netOf(own, blockOf(corner)) : [];
    });
  }

  /** Numbers beside the picture, and names for what the terms of the text mean. */
  function drawn() {
    attribute(canvas, "aria-label", host.alt());
    const verdicts = (known?.verdicts ?? []).map(({ verdict }) => verdict);
    const worst = WORST.find((each) => verdicts.includes(each));
    if (worst) {
      const isSound = worst === "regular" || worst === "valid";
      status.replaceChildren(
        ...(isSound ? [icon("check", 14)] : []),
        h("span", { class: worst === "invalid" ? "failed" : "", "data-lesson": "verdict" }, words.verdicts[worst]),
        ...(figure.reading === "jacobian" ? [h("span", {}, symbol("J"), " ", h("span", { class: "strong number" }, fixed(jacobianAt(/** @type {Cell} */ (cell()), uvw), 2)))] : []),
      );
      status.hidden = figure.controls === "none";
    }
    host.element.dataset.drawn = "true";
  }

  /**
   * @param {Point[]} at of the coefficients
   * @param {Point[][]} lines of the net
   * @param {Point[][]} crossing
   * @param {Point | null} here
   * @param {Point[]} goes of what moves with the chosen one
   */
  function name(at, lines, crossing, here, goes) {
    const now = cell();
    if (!now) return;
    const choices = shown();
    /** Those with such indices. @param {(each: number) => boolean} fits */
    const those = (fits) => choices.flatMap((choice, n) => (choice.at.every(fits) ? [at[n]] : []));
    surface.name(
      partsOf(host.terms, {
        coefficients: () => ({ dots: at }),
        coefficient: () => ({ dots: [seen(positionOf(chosen) ?? [0, 0, 0])] }),
        moving: () => ({ dots: goes }),
        corners: () => ({ dots: those((each) => each % 3 === 0) }),
        inner: () => ({ dots: those((each) => each % 3 !== 0) }),
        net: () => ({ lines }),
        edges: () => ({ lines: edgesOf(now).map((edge) => edge.map(seen)) }),
        point: () => ({ dots: here ? [here] : [] }),
        through: () => ({ lines: crossing }),
        witness: () => ({ dots: witnesses().map(seen) }),
      }),
    );
  }

  /** Draws what lies over the body again. */
  function redraw() {
    const now = cell();
    if (now) drawOver(now);
  }

  /** @param {number} axis @param {number} value */
  function place(axis, value) {
    uvw = /** @type {Vector} */ (uvw.map((own, k) => (k === axis ? value : own)));
    host.touched();
    redraw();
    drawn();
  }

  /** @param {Chosen} which */
  function choose(which) {
    chosen = which;
    host.touched();
    redraw();
    if (reach) again();
  }

  /** Asks the kernel about the document as it is. */
  function again() {
    if (document) lane.push({ document, chosen, reach });
  }

  /** @param {BodyDocument} next */
  function change(next) {
    document = next;
    follows = false;
    host.touched();
    again();
    moved();
  }

  /** @param {Shares} next @param {Rule | null} by */
  function grade(next, by) {
    [shares, rule] = [next, by];
    if (document && rule) change(graded(document, shares, rule));
  }

  /** Moves the chosen coefficient: by an operation, with what goes with it, or it alone. @param {readonly number[]} to @param {Start} from */
  function put(to, from) {
    if (!document) return;
    if (reach) {
      change(displaced(from.document, chosen, to.map((each, axis) => each - from.position[axis]), reach));
      return;
    }
    change(placed(document, chosen, /** @type {Vector} */ ([...to])));
  }

  /** @param {number} axis @param {number} value */
  function moveTo(axis, value) {
    const from = start();
    if (from) put(from.position.map((each, k) => (k === axis ? value : each)), from);
  }

  /**
   * Where a displacement of the chosen coefficient starts: in the body that the kernel has answered for, whose positions are known, or in the
   * newest one, to which it is added.
   * @param {boolean} [isAdded]
   */
  function start(isAdded = false) {
    const from = reach && !isAdded ? known?.job.document : document;
    const position = positionOf(chosen);
    return from && position ? { document: from, position } : null;
  }

  /** @param {readonly number[]} position @returns {[string, string, string]} */
  const placeText = (position) => [coordinate(position[0]), coordinate(position[1]), coordinate(position[2])];

  moveByHand(handle, {
    start,
    /** Across the view, at the depth where it lies. */
    dragged(position, [x, y]) {
      const { right, up } = axesOf(camera);
      const { depth } = seenAt(camera, frame(), position);
      const units = (unitsPerPixel(camera, frame()) * depth) / camera.distance;
      return add(position, add(scaled(right, x * units), scaled(up, -y * units)));
    },
    nudge,
    placeOf: surface.placeOf,
    put,
    rest: () => rest(),
    say: (position) => app.say(words.handle(chosen.at, ...placeText(position))),
  });
  // A tap near a coefficient takes it.
  surface.element.addEventListener("click", (event) => {
    const now = cell();
    if (!canMove || !now || event.target === handle) return;
    const here = surface.placeOf(event);
    const near = matchMedia("(pointer: coarse)").matches ? 22 : 12;
    const choices = shown();
    const far = choices.map((each) => Math.hypot(...seen(positionOf(each) ?? [0, 0, 0]).map((own, k) => own - here[k])));
    const nearest = Math.min(...far);
    if (nearest <= near) choose(choices[far.indexOf(nearest)]);
  });

  return {
    status,
    controls: controls.element,
    show(next) {
      document = /** @type {BodyDocument} */ (/** @type {unknown} */ (next));
      known = shape = null;
      uvw = figure.point ?? [0.5, 0.5, 0.5];
      [chosen, reach, twist, shares, rule, halvings] = [first, figure.reach, figure.twist ?? 0, firstShares(figure), figure.rule, 0];
      isFine = true;
      fit(STANDARD.iso);
      again();
    },
    draw() {
      if (follows) fit(camera);
      draw();
    },
    state: () => shownState(document && { ...document, operations: [{ op: "cells", cells: cells() }] }),
    close() {
      isOver = true;
      cancelAnimationFrame(asked);
      clearTimeout(idle);
      lane.cancel();
    },
  };
}

/** @param {Chosen} one @param {Chosen} other */
const isOf = (one, other) => one.cell === other.cell && String(one.at) === String(other.at);
