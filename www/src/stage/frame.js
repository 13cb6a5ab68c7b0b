/**
 * The frame round a selection: eight handles scale it, one turns it. Pointer, touch and keys end in the same edits.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Point, Selection } from "../types.js"
 *
 * @typedef {"nw" | "n" | "ne" | "e" | "se" | "s" | "sw" | "w"} Side
 * @typedef {{left: number, right: number, low: number, high: number}} Box
 */
import { ARROWS, KeyRun, stride } from "../controls/arrows.js";
import { newRun } from "../controls/run.js";
import { attribute, find, h, svg } from "../dom.js";
import { fixed, percent } from "../format.js";
import { curveName } from "../state/app.js";
import { scalePoints, turnPoints } from "../state/curve-edits.js";
import { seen } from "../state/in-space.js";
import { movedPoints } from "../state/selection.js";
import { arrowStep, toPlane, toScreen } from "../view.js";
import { words } from "./frame-words.js";

/** Pixels between the selection and its frame, from the frame to the handle that turns, and from the edge of the canvas. */
const PAD = 22;
const STEM = 26;
const EDGE = 12;
/** Smallest factor of one drag: a selection never folds over or vanishes. */
const LEAST = 0.02;
/** Degrees that Shift turns by, and those of an arrow key. */
const SNAP = 15;
const TURN = 1;

/** Which edges a handle moves: -1 left or low, 1 right or high. @type {{[side in Side]: [number, number]}} */
const SIDES = { nw: [-1, 1], n: [0, 1], ne: [1, 1], e: [1, 0], se: [1, -1], s: [0, -1], sw: [-1, -1], w: [-1, 0] };

/** @param {App} app */
export function createFrame(app) {
  const rectangle = svg("path", { class: "frame-line" });
  const drawing = svg("svg", { class: "marks" }, rectangle);
  const sides = /** @type {Side[]} */ (Object.keys(SIDES));
  const buttons = /** @type {(Side | "turn")[]} */ (["turn", ...sides]).map((name) => {
    const label = name === "turn" ? words.turn : words.scale[name];
    const button = h("button", { type: "button", class: "frame-handle", "aria-label": label, title: label });
    button.dataset.frame = name;
    button.addEventListener("pointerdown", (event) => press(event, name));
    button.addEventListener("keydown", (event) => key(event, name));
    return { name, button };
  });
  const help = h("p", { id: "frame-help", class: "spoken" }, words.help);
  const element = h(
    "div",
    { class: "frame", role: "application", "aria-describedby": "frame-help", "data-furniture": "" },
    /** @type {any} */ (drawing),
    help,
    ...buttons.map(({ button }) => button),
  );
  find("#overlay").after(element);
  let stop = 0;
  const runs = new KeyRun("frame");
  /** The turn of a drag under way, which the frame follows. */
  let turned = 0;
  /** @type {{box: Box, selection: Selection} | null} the box before a drag, while it turns */
  let held = null;

  /** @param {PointerEvent} down @param {Side | "turn"} name */
  function press(down, name) {
    const { selection, view, size } = app.ui.value;
    if (down.button !== 0 || !selection || !view) return;
    down.preventDefault();
    down.stopPropagation();
    const index = buttons.findIndex((each) => each.name === name);
    const { button } = buttons[index];
    stop = index;
    button.focus({ preventScroll: true });
    button.setPointerCapture(down.pointerId);
    const { document } = app.store;
    const box = boxOf(document, selection);
    const frame = find("#stage").getBoundingClientRect();
    const at = (/** @type {PointerEvent} */ event) =>
      toPlane(view, size, [event.clientX - frame.left, event.clientY - frame.top]);
    const from = at(down);
    const drag = newRun("frame");
    const over = new AbortController();
    element.classList.add("dragging");
    let said = "";

    /** @param {PointerEvent} event */
    const move = (event) => {
      const to = at(event);
      const by = /** @type {Point} */ ([to[0] - from[0], to[1] - from[1]]);
      if (name === "turn") {
        const center = centerOf(box);
        const angle = (/** @type {Point} */ p) => (Math.atan2(p[1] - center[1], p[0] - center[0]) * 180) / Math.PI;
        const raw = ((angle(to) - angle(from) + 540) % 360) - 180;
        const degrees = event.shiftKey ? Math.round(raw / SNAP) * SNAP : Math.round(raw * 10) / 10;
        held = { box, selection };
        turned = degrees;
        commit(drag, document, (now) => turn(now, selection, box, degrees));
        said = words.turned(fixed(degrees, 1));
      } else {
        const factors = factorsOf(name, box, by, event.shiftKey, event.altKey);
        commit(drag, document, (now) => scale(now, selection, box, name, factors, event.altKey));
        said = words.scaled(percent(factors[0]), percent(factors[1]));
      }
    };
    /** @param {string | null} text */
    const finish = (text) => {
      over.abort();
      element.classList.remove("dragging");
      [turned, held] = [0, null];
      if (text === null) app.store.cancel(drag);
      else if (text) app.say(text);
      app.store.endRun();
      render();
    };
    const { signal } = over;
    button.addEventListener("pointermove", move, { signal });
    button.addEventListener("pointerup", () => finish(said), { signal });
    button.addEventListener("pointercancel", () => finish(null), { signal });
    addEventListener(
      "keydown",
      (event) => {
        if (event.key !== "Escape") return;
        event.stopPropagation();
        finish(null);
      },
      { signal, capture: true },
    );
  }

  /**
   * Every step of a run starts from the curves before it, so that rounding does not add up.
   * @param {string} name of the run
   * @param {CurvesDocument} start
   * @param {(document: CurvesDocument) => CurvesDocument} change
   */
  function commit(name, start, change) {
    app.store.commit({ run: name, change: (now) => change({ ...now, curves: start.curves }) });
  }

  /** @param {KeyboardEvent} event @param {Side | "turn"} name */
  function key(event, name) {
    const { selection } = app.ui.value;
    if (!selection || event.ctrlKey || event.metaKey) return;
    const arrow = ARROWS[event.key];
    if (arrow) {
      const run = runs.press();
      const far = stride(event);
      const box = boxOf(app.store.document, selection);
      if (name === "turn") {
        const degrees = TURN * far * (arrow[0] + arrow[1] < 0 ? 1 : -1);
        app.store.commit({ run, change: (document) => turn(document, selection, box, degrees) });
        app.say(words.turned(fixed(degrees, 1)));
      } else {
        const step = arrowStep(app.store.document) * far;
        const corner = SIDES[name][0] !== 0 && SIDES[name][1] !== 0;
        const factors = factorsOf(name, box, [arrow[0] * step, arrow[1] * step], corner, false);
        app.store.commit({ run, change: (document) => scale(document, selection, box, name, factors, false) });
        app.say(words.scaled(percent(factors[0]), percent(factors[1])));
      }
    } else if (event.key === "PageDown" || event.key === "PageUp") {
      stop = (stop + (event.key === "PageDown" ? 1 : buttons.length - 1)) % buttons.length;
      render();
      buttons[stop].button.focus({ preventScroll: true });
    } else if (event.key === "Escape" && app.store.cancel(runs.name)) {
      runs.renew();
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  function render() {
    const { view, size, selection, drawing, layers } = app.ui.value;
    const { document } = app.store;
    const chosen = selection && document.curves[selection.curve] && selection.points.length !== 1 ? selection : null;
    element.hidden = !chosen || !view || drawing || !layers.includes("controlPoints");
    if (element.hidden || !chosen || !view) return;
    attribute(element, "aria-label", words.group(curveName(document, chosen.curve)));
    const box = held ? held.box : boxOf(document, chosen);
    const [x0, y0] = toScreen(view, size, [box.left, box.high]);
    const [x1, y1] = toScreen(view, size, [box.right, box.low]);
    const floor = size.height - find("#morph").offsetHeight - EDGE;
    // A frame larger than the canvas keeps its handles within reach.
    const left = Math.min(Math.max(x0 - PAD, EDGE), size.width - 3 * EDGE);
    const right = Math.max(Math.min(x1 + PAD, size.width - EDGE), left + 2 * EDGE);
    const top = Math.min(Math.max(y0 - PAD, EDGE + STEM), floor - 2 * EDGE);
    const bottom = Math.max(Math.min(y1 + PAD, floor), top + 2 * EDGE);
    const middle = /** @type {Point} */ ([(x0 + x1) / 2, (y0 + y1) / 2]);
    const angle = (-turned * Math.PI) / 180;
    const spun = (/** @type {number} */ x, /** @type {number} */ y) => {
      if (turned === 0) return [x, y];
      const [dx, dy] = [x - middle[0], y - middle[1]];
      return [middle[0] + dx * Math.cos(angle) - dy * Math.sin(angle), middle[1] + dx * Math.sin(angle) + dy * Math.cos(angle)];
    };
    const [cx, cy] = [(left + right) / 2, (top + bottom) / 2];
    const corners = [spun(left, top), spun(right, top), spun(right, bottom), spun(left, bottom)];
    const text = (/** @type {number[]} */ p) => p.map((value) => value.toFixed(1)).join(" ");
    attribute(
      rectangle,
      "d",
      `M${corners.map(text).join("L")}ZM${text(spun(cx, top))}L${text(spun(cx, top - STEM))}`,
    );
    buttons.forEach(({ name, button }, i) => {
      const [sx, sy] = name === "turn" ? [0, 1] : SIDES[name];
      const x = sx < 0 ? left : sx > 0 ? right : cx;
      const y = name === "turn" ? top - STEM : sy > 0 ? top : sy < 0 ? bottom : cy;
      const [px, py] = spun(x, y);
      button.style.transform = `translate(${px.toFixed(1)}px, ${py.toFixed(1)}px)`;
      attribute(button, "tabindex", i === stop ? "0" : "-1");
    });
  }

  return { render };
}

/**
 * The box of the control points that a selection moves, in document units.
 * @param {CurvesDocument} document
 * @param {Selection} selection
 * @returns {Box}
 */
function boxOf(document, selection) {
  const { points } = seen(document.curves[selection.curve]);
  const box = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity };
  for (const index of movedPoints(document, selection)) {
    const [x, y] = points[index];
    box.left = Math.min(box.left, x);
    box.right = Math.max(box.right, x);
    box.low = Math.min(box.low, y);
    box.high = Math.max(box.high, y);
  }
  return box;
}

/** @param {Box} box @returns {Point} */
const centerOf = ({ left, right, low, high }) => [(left + right) / 2, (low + high) / 2];

/**
 * Factors along x and y of a drag that moves a handle by some way.
 * @param {Side} side
 * @param {Box} box
 * @param {Point} by document units
 * @param {boolean} proportion
 * @param {boolean} centred the other side moves as far
 * @returns {[number, number]}
 */
function factorsOf(side, box, by, proportion, centred) {
  const [sx, sy] = SIDES[side];
  const [width, height] = [box.right - box.left, box.high - box.low];
  const twice = centred ? 2 : 1;
  const fx = sx !== 0 && width > 0 ? Math.max(LEAST, 1 + (sx * by[0] * twice) / width) : 1;
  const fy = sy !== 0 && height > 0 ? Math.max(LEAST, 1 + (sy * by[1] * twice) / height) : 1;
  if (!proportion) return [fx, fy];
  const both = Math.abs(fx - 1) * width > Math.abs(fy - 1) * height ? fx : fy;
  return [both, both];
}

/**
 * @param {CurvesDocument} document
 * @param {Selection} selection
 * @param {Box} box before
 * @param {Side} side
 * @param {[number, number]} factors
 * @param {boolean} centred
 */
function scale(document, selection, box, side, factors, centred) {
  const [sx, sy] = SIDES[side];
  const [cx, cy] = centerOf(box);
  const about = /** @type {Point} */ ([
    centred || sx === 0 ? cx : sx > 0 ? box.left : box.right,
    centred || sy === 0 ? cy : sy > 0 ? box.low : box.high,
  ]);
  return scalePoints(document, selection.curve, movedPoints(document, selection), about, factors);
}

/**
 * @param {CurvesDocument} document
 * @param {Selection} selection
 * @param {Box} box before
 * @param {number} degrees
 */
function turn(document, selection, box, degrees) {
  return turnPoints(document, selection.curve, movedPoints(document, selection), centerOf(box), degrees);
}
