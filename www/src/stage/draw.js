/**
 * Drawing a curve: by points that it passes, or freehand with a fit when the line is let go. It is open beside an open curve and closed
 * beside a closed one; the first one is either. The figure keeps its zoom and pan meanwhile.
 *
 * @import { App, Tool } from "../state/app.js"
 * @import { Point, Shape } from "../types.js"
 */
import { segment } from "../controls/choices.js";
import { find, h, write } from "../dom.js";
import { coordinate } from "../format.js";
import { problem } from "../painter.js";
import { isOpen, outline } from "../spline.js";
import { curveName } from "../state/app.js";
import { placeForCurve, POINT_LIMIT, putShape } from "../state/curve-edits.js";
import { handleCount } from "../state/edits.js";
import { whole } from "../state/selection.js";
import { openCurveThrough } from "../state/through-open.js";
import { curveThrough } from "../state/through.js";
import { aimed, toPlane } from "../view.js";
import { chainPath, createBoard } from "./draw-board.js";
import { openWords, words } from "./draw-words.js";
import { rested } from "./snap.js";
import { isLoop, spread, TOLERANCE } from "./strokes.js";

/** Fewest points of a closed curve, and of an open one. */
const FEWEST = 3;
const FEWEST_OPEN = 2;
/** Pixels within which a click is meant for a point that is there, by pointer and by touch. */
const REACH = { mouse: 10, touch: 22 };
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
  /** A sentence that stands until the next step. */
  let said = "";
  let fitting = false;

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
  const board = createBoard(app, {
    name: "draw",
    words,
    points: () => points,
    rested: (at) => rested(app, at, false),
    refresh,
    giveUp,
    takeBack,
    finish: (event) => done(open || (either && event.shiftKey)),
    set: setPoint,
  });
  find("#overlay").before(board.marks, board.keyboard, board.help);
  find("#stage").append(bar);
  board.keyboard.focus({ preventScroll: true });

  /** @param {Point} at document units */
  function setPoint(at) {
    const last = points.at(-1);
    if (mode === "freehand" || points.length >= POINT_LIMIT) return;
    if (last && last[0] === at[0] && last[1] === at[1]) return;
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
    const drawn = board.takeLine();
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
    board.close();
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
    const here = freehand ? null : board.here();
    const line = board.line();
    const through = here && points.length > 0 ? [...points, here] : points;
    const shape = freehand ? null : (open ? openCurveThrough : curveThrough)(through);
    const chain = shape ? outline(shape, CHORDS).map(({ at }) => at) : freehand ? line : through;
    board.draw(view, size, {
      line: chainPath(view, size, chain),
      closing: freehand && !open && line.length > 1 ? [line[line.length - 1], line[0]] : null,
      isClosable: !open && points.length >= FEWEST,
      hasCross: !freehand,
    });
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

  /** @type {Tool} */
  const tool = {
    hover(at) {
      if (mode === "freehand" || (!at && !board.hasPointer())) return;
      const first = at && !open && points.length >= FEWEST && board.isOn(at, points[0], REACH.mouse);
      board.point(at ? (first ? points[0] : planeOf(at)) : null);
      refresh();
    },
    tap(at, event) {
      if (mode === "freehand") {
        tell(open ? openWords.tooShort : words.tooShort);
        return;
      }
      const reach = event.pointerType === "touch" ? REACH.touch : REACH.mouse;
      board.press();
      const closes = !open && points.length >= FEWEST && board.isOn(at, points[0], reach);
      // The second half of a double click lands on the point that the first half has set.
      const doubled = event.pointerType !== "touch" && board.isOn(at, points.at(-1), 3);
      if (closes || (doubled && points.length >= fewest)) done();
      else if (!doubled) setPoint(planeOf(at, event.ctrlKey || event.metaKey));
    },
    stroke(at) {
      if (mode === "points" || fitting) return null;
      said = "";
      return board.stroke(at, () => void fitLine());
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
