/**
 * Drawing a curve: by points that it passes, or freehand with a fit when the line is let go. It is open beside an open curve and closed
 * beside a closed one; the first one is either. The figure keeps its zoom and pan meanwhile.
 *
 * @import { App, Stroke, Tool } from "../state/app.js"
 * @import { Point, Shape } from "../types.js"
 */
import { segment } from "../controls/choices.js";
import { attribute, find, h, svg, write } from "../dom.js";
import { coordinate } from "../format.js";
import { problem } from "../painter.js";
import { isOpen, outline } from "../spline.js";
import { curveName } from "../state/app.js";
import { placeForCurve, POINT_LIMIT, putShape } from "../state/curve-edits.js";
import { handleCount } from "../state/edits.js";
import { whole } from "../state/selection.js";
import { openCurveThrough } from "../state/through-open.js";
import { curveThrough } from "../state/through.js";
import { aimed, gridStep, panned, toPlane, toScreen } from "../view.js";
import { openWords, words } from "./draw-words.js";
import { rested } from "./snap.js";
import { isLoop, SPACING, spread, TOLERANCE } from "./strokes.js";

/** Fewest points of a closed curve, and of an open one. */
const FEWEST = 3;
const FEWEST_OPEN = 2;
/** Pixels within which a click is meant for a point that is there, by pointer and by touch. */
const REACH = { mouse: 10, touch: 22 };
/** Pixels of an arrow key. */
const STEP = 10;
/** Chords of one knot span of the preview, whose spans may be long. */
const CHORDS = 32;

/**
 * Takes the canvas until the curve is closed or given up.
 * @param {App} app
 */
export function startDrawing(app) {
  app.tool?.close();
  const { view } = app.ui.value;
  if (!view) return;
  app.tool = createDraw(app);
  app.ui.set({ drawing: true, playing: false, probe: null, witness: null, note: null });
}

/**
 * @param {App} app
 * @returns {Tool}
 */
function createDraw(app) {
  const touch = matchMedia("(pointer: coarse)").matches;
  const { index, replaces } = placeForCurve(app.store.document, app.ui.value.selection?.curve ?? 1);
  const { curves } = app.store.document;
  const other = replaces ? curves[1 - index] : curves[0];
  /** Whether the curve has to be open; both kinds may come first. */
  const open = isOpen(other);
  const either = !other;
  const fewest = open ? FEWEST_OPEN : FEWEST;
  const before = document.activeElement;
  /** @type {"points" | "freehand"} */
  let mode = "points";
  /** @type {Point[]} */
  let points = [];
  /** @type {Point[]} */
  let line = [];
  /** @type {Point | null} */
  let pointer = null;
  /** @type {Point | null} */
  let cross = null;
  /** A sentence that stands until the next step. */
  let said = "";
  let fitting = false;

  const preview = svg("path", { class: "draw-line" });
  const closing = svg("path", { class: "draw-closing" });
  const dots = svg("g", {});
  const cursor = svg("path", { class: "draw-cross", d: "M-9 0H9M0-9V9" });
  const marks = svg("svg", { class: "marks", "aria-hidden": "true" }, preview, closing, dots, cursor);

  const choice = segment(
    {
      label: words.mode,
      name: "draw-mode",
      choices: [
        { value: "points", text: words.points },
        { value: "freehand", text: words.freehand },
      ],
    },
    (value) => {
      mode = value;
      points = [];
      said = "";
      refresh();
    },
  );
  choice.set(mode);
  const hint = h("span", { class: "draw-hint", "data-hint": "" });
  const button = (/** @type {string} */ name, /** @type {string} */ text, /** @type {() => void} */ act) => {
    const element = h("button", { type: "button", class: "command-word", "data-draw": name, onclick: act }, text);
    return element;
  };
  const back = button("back", words.back, takeBack);
  const finish = button("close", open ? openWords.finish : words.finish, () => done());
  const leave = button("leave", openWords.leave, () => done(true));
  const cancel = button("cancel", words.cancel, () => giveUp());
  const bar = h(
    "div",
    { class: "draw-bar", role: "group", "aria-label": words.region, "data-furniture": "" },
    choice.element,
    hint,
    h("span", { class: "draw-commands" }, back, finish, ...(either ? [leave] : []), cancel),
  );
  const keyboard = h("div", {
    id: "draw-keys",
    class: "draw-keys",
    tabIndex: 0,
    role: "application",
    "aria-label": words.keyboard,
    "aria-describedby": "draw-help",
  });
  const help = h("p", { id: "draw-help", class: "spoken" }, words.help);
  find("#overlay").before(marks, keyboard, help);
  find("#stage").append(bar);
  const over = new AbortController();
  addEventListener("keydown", key, { capture: true, signal: over.signal });
  keyboard.focus({ preventScroll: true });

  /** @param {KeyboardEvent} event */
  function key(event) {
    const target = event.target instanceof Element ? event.target : null;
    const undoes = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "z" && points.length > 0;
    if ((!undoes && (event.ctrlKey || event.metaKey)) || target?.closest("input[type=text], select, [data-panel], [role=menu]")) return;
    const own = !target || target === document.body || target === keyboard;
    if (event.key === "Escape") giveUp();
    else if (undoes || event.key === "Backspace" || event.key === "Delete") takeBack();
    else if (!own) return;
    else if (event.key === "Enter") done(open || (either && event.shiftKey));
    else if (event.key === " " && mode === "points") setPoint(crosshair());
    else if (event.key.startsWith("Arrow")) moveCross(event);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  function crosshair() {
    const { view } = app.ui.value;
    return cross ?? points.at(-1) ?? view?.center ?? [0, 0];
  }

  /** @param {KeyboardEvent} event */
  function moveCross(event) {
    const { view, size, snap } = app.ui.value;
    if (!view) return;
    const step = snap ? gridStep(view.scale) : STEP / view.scale;
    const by = step * (event.shiftKey ? (snap ? 5 : 10) : event.altKey && !snap ? 0.1 : 1);
    const [x, y] = crosshair();
    const to = /** @type {Point} */ ([
      x + (event.key === "ArrowRight" ? by : event.key === "ArrowLeft" ? -by : 0),
      y + (event.key === "ArrowUp" ? by : event.key === "ArrowDown" ? -by : 0),
    ]);
    cross = rested(app, to, false);
    pointer = null;
    const [sx, sy] = toScreen(view, size, cross);
    const out = /** @type {Point} */ ([
      sx < 24 ? 24 - sx : Math.min(0, size.width - 24 - sx),
      sy < 24 ? 24 - sy : Math.min(0, size.height - 100 - sy),
    ]);
    if (out[0] !== 0 || out[1] !== 0) app.ui.set({ view: panned(view, out), fitted: false });
    app.say(words.cross(coordinate(cross[0]), coordinate(cross[1])));
    refresh();
  }

  /** @param {Point} at document units */
  function setPoint(at) {
    const last = points.at(-1);
    if (last && last[0] === at[0] && last[1] === at[1]) return;
    if (points.length >= POINT_LIMIT) return;
    points.push(at);
    said = "";
    app.say(words.set(points.length, coordinate(at[0]), coordinate(at[1])));
    refresh();
  }

  function takeBack() {
    points.pop();
    said = "";
    app.say(words.taken(points.length));
    refresh();
  }

  /** @param {string} text */
  function tell(text) {
    said = text;
    app.say(text);
    refresh();
  }

  /** @param {boolean} [leavesOpen] */
  function done(leavesOpen = open) {
    if (mode === "freehand") return;
    if (points.length < (leavesOpen ? FEWEST_OPEN : FEWEST)) {
      tell(hintText());
      return;
    }
    const shape = (leavesOpen ? openCurveThrough : curveThrough)(points);
    if (shape) put(shape);
    else tell(words.flat);
  }

  /** @param {Shape} shape */
  function put(shape) {
    const { view } = app.ui.value;
    // Digits that nobody could aim at would only be in the way of editing.
    const points = view ? shape.points.map(([x, y]) => /** @type {Point} */ ([aimed(x, view), aimed(y, view)])) : shape.points;
    app.store.commit({ change: (document) => putShape(document, index, { ...shape, points }) });
    close();
    // On a phone the canvas shrinks again when the drawing is over, and the figure with it.
    app.ui.set({ selection: whole(index), fitted: matchMedia("(width < 600px)").matches });
    // What comes next is meant for the curve: keys act on what has the focus.
    requestAnimationFrame(() => focusOutline(index));
    const { document } = app.store;
    app.say(words.done(curveName(document, index), handleCount(document.curves[index])));
  }

  /** Fits a curve to the line that was drawn. */
  async function fitLine() {
    const { view } = app.ui.value;
    const drawn = line;
    line = [];
    const shape = open && view ? openCurveThrough(spread(drawn, view.scale)) : null;
    if (!view || (open ? !shape : !isLoop(drawn, view.scale))) {
      tell(open ? openWords.tooShort : words.tooShort);
      return;
    }
    if (shape) {
      put(shape);
      return;
    }
    fitting = true;
    refresh();
    try {
      const options = { tolerance: TOLERANCE / view.scale, corners: /** @type {const} */ ("smooth"), through: false };
      const { curve } = await app.kernel.fitCurve(drawn, options);
      fitting = false;
      if (app.tool === tool) put(/** @type {Shape} */ (curve));
    } catch (error) {
      fitting = false;
      if (app.tool === tool) tell(problem(error).message);
    }
  }

  function giveUp() {
    close();
    app.say(words.gaveUp);
  }

  function close() {
    if (app.tool !== tool) return;
    over.abort();
    marks.remove();
    keyboard.remove();
    help.remove();
    const held = bar.contains(document.activeElement) || document.activeElement === document.body;
    bar.remove();
    app.tool = null;
    app.ui.set({ drawing: false });
    if (held && before instanceof HTMLElement && before.isConnected) before.focus({ preventScroll: true });
  }

  function hintText() {
    if (said) return said;
    if (fitting) return words.fitting;
    if (mode === "freehand") return open ? openWords.stroke : words.stroke;
    if (points.length === 0) return touch ? words.touchStart : words.start;
    const missing = fewest - points.length;
    if (open && missing > 0) return touch ? openWords.touchMore : openWords.more;
    if (open) return touch ? openWords.touchClose : openWords.close;
    if (missing > 0) return (touch ? words.touchMore : words.more)(missing);
    if (either) return touch ? openWords.touchEither : openWords.either;
    return touch ? words.touchClose : words.close;
  }

  /** Pans, zooms and steps alike end in a new drawing of the marks. */
  function refresh() {
    const { view, size } = app.ui.value;
    if (!view) return;
    const freehand = mode === "freehand";
    const here = freehand ? null : (pointer ?? cross);
    const through = here && points.length > 0 ? [...points, here] : points;
    const path = (/** @type {readonly Point[]} */ chain) =>
      chain.length < 2 ? "" : `M${chain.map((at) => toScreen(view, size, at).map((v) => v.toFixed(1)).join(" ")).join("L")}`;
    const shape = freehand ? null : (open ? openCurveThrough : curveThrough)(through);
    const chain = shape ? outline(shape, CHORDS).map(({ at }) => at) : freehand ? line : through;
    attribute(preview, "d", path(chain));
    attribute(closing, "d", freehand && !open && line.length > 1 ? path([line[line.length - 1], line[0]]) : "");
    dots.replaceChildren(
      ...points.map((at, i) => {
        const [x, y] = toScreen(view, size, at);
        const first = !open && i === 0 && points.length >= FEWEST;
        return svg("circle", { cx: x.toFixed(1), cy: y.toFixed(1), r: first ? 6 : 3.5, class: first ? "draw-first" : "draw-dot" });
      }),
    );
    const shown = cross && !pointer && !freehand;
    cursor.style.display = shown ? "" : "none";
    if (shown) attribute(cursor, "transform", `translate(${toScreen(view, size, cross ?? [0, 0]).join(" ")})`);
    const extra = replaces && points.length === 0 && !said ? ` ${words.replaces(curveName(app.store.document, index))}` : "";
    write(hint, hintText() + extra);
    back.disabled = points.length === 0;
    finish.disabled = points.length < fewest;
    leave.disabled = points.length < FEWEST_OPEN;
    back.hidden = finish.hidden = leave.hidden = freehand;
  }

  /** @param {Point} at CSS pixels @param {boolean} invert */
  function planeOf(at, invert = false) {
    const { view, size } = app.ui.value;
    return view ? rested(app, toPlane(view, size, at), invert) : at;
  }

  /** Whether a press is meant for a point. @param {Point} at @param {Point | undefined} point @param {number} reach */
  function isOn(at, point, reach) {
    const { view, size } = app.ui.value;
    if (!view || !point) return false;
    const [x, y] = toScreen(view, size, point);
    return Math.hypot(x - at[0], y - at[1]) <= reach;
  }

  /** @type {Tool} */
  const tool = {
    hover(at) {
      if (mode === "freehand" || (!at && !pointer)) return;
      const first = at && !open && points.length >= FEWEST && isOn(at, points[0], REACH.mouse);
      pointer = at ? (first ? points[0] : planeOf(at)) : null;
      if (at) cross = null;
      refresh();
    },
    tap(at, event) {
      if (mode === "freehand") {
        tell(open ? openWords.tooShort : words.tooShort);
        return;
      }
      const reach = event.pointerType === "touch" ? REACH.touch : REACH.mouse;
      pointer = null;
      cross = null;
      const closes = !open && points.length >= FEWEST && isOn(at, points[0], reach);
      // The second half of a double click lands on the point that the first half has set.
      const doubled = event.pointerType !== "touch" && isOn(at, points.at(-1), 3);
      if (closes || (doubled && points.length >= fewest)) done();
      else if (!doubled) setPoint(planeOf(at, event.ctrlKey || event.metaKey));
    },
    stroke(at) {
      if (mode === "points" || fitting) return null;
      const { view, size } = app.ui.value;
      if (!view) return null;
      let last = at;
      line = [toPlane(view, size, at)];
      said = "";
      /** @type {Stroke} */
      const stroke = {
        to(to) {
          if (Math.hypot(to[0] - last[0], to[1] - last[1]) < SPACING) return;
          last = to;
          line.push(toPlane(view, size, to));
          refresh();
        },
        end: () => void fitLine(),
        undo() {
          line = [];
          refresh();
        },
      };
      return stroke;
    },
    render: refresh,
    close,
  };
  return tool;
}

/** @param {number} index */
function focusOutline(index) {
  const outline = document.querySelector(`[data-outline="${index}"]`);
  if (outline instanceof SVGElement) outline.focus({ preventScroll: true });
}
