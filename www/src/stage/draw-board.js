/**
 * What drawing has in common, whatever is drawn: marks over the picture, a crosshair for the keyboard, keys, and strokes.
 *
 * @import { App, Stroke } from "../state/app.js"
 * @import { Point, Size, View } from "../types.js"
 *
 * @typedef {object} Drawing What is drawn.
 * @property {string} name of the keyboard's place and its help, as ids
 * @property {{keyboard: string, help: string, cross: (x: string, y: string) => string}} words
 * @property {() => readonly Point[]} points that are set, in document units
 * @property {(at: Point) => Point} rested where a place that is aimed at comes to rest
 * @property {() => void} refresh everything is drawn again
 * @property {() => void} giveUp
 * @property {() => void} takeBack the last point
 * @property {(event: KeyboardEvent) => void} finish
 * @property {(at: Point) => void} set sets a point, where points can be set
 */
import { ARROWS } from "../controls/arrows.js";
import { attribute, h, svg } from "../dom.js";
import { coordinate } from "../format.js";
import { gridStep, panned, toPlane, toScreen } from "../view.js";
import { put } from "./mark.js";
import { SPACING } from "./strokes.js";

/** Pixels of an arrow key, and those at the edges of the picture that the crosshair keeps clear of. */
const STEP = 10;
const EDGE = { side: 24, foot: 100 };
/** Radius of the marks of points that are set, and of the first one where it closes what is drawn. */
const DOT = 3.5;
const FIRST = 6;

/**
 * @param {App} app
 * @param {Drawing} drawing
 */
export function createBoard(app, drawing) {
  const { name, words } = drawing;
  const preview = svg("path", { class: "draw-line" });
  const closing = svg("path", { class: "draw-closing" });
  const dots = svg("g", {});
  const cursor = svg("path", { class: "draw-cross", d: "M-9 0H9M0-9V9" });
  const marks = svg("svg", { class: "marks", "aria-hidden": "true" }, preview, closing, dots, cursor);
  const help = h("p", { id: `${name}-help`, class: "spoken" }, words.help);
  const keyboard = h("div", { id: `${name}-keys`, class: "draw-keys", tabIndex: 0, role: "application", "aria-label": words.keyboard, "aria-describedby": help.id });
  const over = new AbortController();
  addEventListener("keydown", key, { capture: true, signal: over.signal });

  /** @type {Point | null} */
  let pointer = null;
  /** @type {Point | null} */
  let cross = null;
  /** A stroke under way, document units. @type {Point[]} */
  let line = [];

  /** @param {KeyboardEvent} event */
  function key(event) {
    const { points, giveUp, takeBack, finish, set } = drawing;
    const target = event.target instanceof Element ? event.target : null;
    const undoes = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "z" && points().length > 0;
    if ((!undoes && (event.ctrlKey || event.metaKey)) || target?.closest("input[type=text], select, [data-panel], [role=menu]")) return;
    const own = !target || target === document.body || target === keyboard;
    if (event.key === "Escape") giveUp();
    else if (undoes || event.key === "Backspace" || event.key === "Delete") takeBack();
    else if (event.key === "Enter" && (own || isChoice(target))) finish(event);
    else if (!own) return;
    else if (event.key === " ") set(crosshair());
    else if (ARROWS[event.key]) moveCross(ARROWS[event.key], event);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** @returns {Point} */
  const crosshair = () => cross ?? drawing.points().at(-1) ?? app.ui.value.view?.center ?? [0, 0];

  /** @param {Point} arrow @param {KeyboardEvent} event */
  function moveCross(arrow, event) {
    const { view, size, snap } = app.ui.value;
    if (!view) return;
    const step = snap ? gridStep(view.scale) : STEP / view.scale;
    const by = step * (event.shiftKey ? (snap ? 5 : 10) : event.altKey && !snap ? 0.1 : 1);
    const [x, y] = crosshair();
    cross = drawing.rested([x + arrow[0] * by, y + arrow[1] * by]);
    pointer = null;
    const [sx, sy] = toScreen(view, size, cross);
    const out = /** @type {Point} */ ([
      sx < EDGE.side ? EDGE.side - sx : Math.min(0, size.width - EDGE.side - sx),
      sy < EDGE.side ? EDGE.side - sy : Math.min(0, size.height - EDGE.foot - sy),
    ]);
    if (out[0] !== 0 || out[1] !== 0) app.ui.set({ view: panned(view, out), fitted: false });
    app.say(words.cross(coordinate(cross[0]), coordinate(cross[1])));
    drawing.refresh();
  }

  return {
    marks,
    keyboard,
    help,
    /** Where the pointer or the crosshair is. */
    here: () => pointer ?? cross,
    hasPointer: () => pointer !== null,
    /** The pointer is at a place, or has left. @param {Point | null} at document units */
    point(at) {
      pointer = at;
      if (at) cross = null;
    },
    /** A press begins: neither counts until they move again. */
    press: () => void (pointer = cross = null),
    line: () => line,
    /** Ends the stroke. @returns {Point[]} what it was */
    takeLine() {
      const taken = line;
      line = [];
      return taken;
    },
    /** A stroke from a press on. @param {Point} at CSS pixels @param {() => void} ended @returns {Stroke} */
    stroke(at, ended) {
      const { view, size } = app.ui.value;
      let last = at;
      line = view ? [toPlane(view, size, at)] : [];
      return {
        to(to) {
          const now = app.ui.value;
          if (!now.view || Math.hypot(to[0] - last[0], to[1] - last[1]) < SPACING) return;
          last = to;
          line.push(toPlane(now.view, now.size, to));
          drawing.refresh();
        },
        end: ended,
        undo() {
          line = [];
          drawing.refresh();
        },
      };
    },
    /** Whether a press is meant for a point. @param {Point} at CSS pixels @param {Point | undefined} point @param {number} reach CSS pixels */
    isOn(at, point, reach) {
      const { view, size } = app.ui.value;
      if (!view || !point) return false;
      const [x, y] = toScreen(view, size, point);
      return Math.hypot(x - at[0], y - at[1]) <= reach;
    },
    /**
     * @param {View} view
     * @param {Size} size
     * @param {object} shown
     * @param {string} shown.line as `d` of a path
     * @param {[Point, Point] | null} shown.closing what a stroke or a polygon lacks to its beginning
     * @param {boolean} shown.isClosable whether the first point closes what is drawn
     * @param {boolean} shown.hasCross whether the crosshair can be seen
     */
    draw(view, size, shown) {
      attribute(preview, "d", shown.line);
      attribute(closing, "d", shown.closing ? chainPath(view, size, shown.closing) : "");
      dots.replaceChildren(
        ...drawing.points().map((at, i) => {
          const [x, y] = toScreen(view, size, at);
          const isFirst = shown.isClosable && i === 0;
          return svg("circle", { cx: x.toFixed(1), cy: y.toFixed(1), r: isFirst ? FIRST : DOT, class: isFirst ? "draw-first" : "draw-dot" });
        }),
      );
      put(cursor, shown.hasCross && cross && !pointer ? toScreen(view, size, cross) : null);
    },
    close() {
      over.abort();
      for (const each of [marks, keyboard, help]) each.remove();
    },
  };
}

/** Places joined by lines, as `d` of a path. @param {View} view @param {Size} size @param {readonly Point[]} chain document units */
export const chainPath = (view, size, chain) =>
  chain.length < 2 ? "" : `M${chain.map((at) => toScreen(view, size, at).map((v) => v.toFixed(1)).join(" ")).join("L")}`;

/** Whether the focus is on a choice, which has no use of its own for Enter. @param {Element | null} target */
const isChoice = (target) => target instanceof HTMLInputElement && target.type === "radio";
