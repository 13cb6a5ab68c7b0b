/**
 * Drawing a shape by the places that it passes or is given by, or a curve in one stroke. The picture keeps its zoom and pan meanwhile.
 *
 * @import { PartShape } from "../../../../js/directrix.js"
 * @import { Stroke, Tool } from "../../state/app.js"
 * @import { Point } from "../../types.js"
 * @import { Bench } from "../state.js"
 * @import { Drawn, Purpose } from "./drawing.js"
 */
import { segment } from "../../controls/choices.js";
import { select } from "../../controls/select.js";
import { attribute, h, svg, write } from "../../dom.js";
import { coordinate } from "../../format.js";
import { problem } from "../../painter.js";
import { isLoop, SPACING, spread, TOLERANCE } from "../../stage/strokes.js";
import { aimed, gridStep, panned, toPlane, toScreen } from "../../view.js";
import { KINDS, words } from "./draw-words.js";
import { bodyFor, isChain, isCurved, nameFor, NEEDS, put, shapeFrom, whyNotPut } from "./drawing.js";
import { ARROWS, rested, restedRadius } from "./moves.js";
import { outlinePath } from "./places.js";

/** Pixels within which a click is meant for a point that is there, by pointer and by touch, and for the second half of a double click. */
const REACH = { mouse: 10, touch: 22 };
const TWICE = 3;
/** Pixels of an arrow key, and those at the edges of the picture that the crosshair keeps clear of. */
const STEP = 10;
const EDGE = { side: 24, foot: 100 };
/** Radius of the marks of points that are set, and of the first one where it closes the shape. */
const DOT = 3.5;
const FIRST = 6;

/**
 * Takes the canvas until the shape is finished or given up.
 * @param {Bench} bench
 * @param {HTMLElement} stage
 * @param {{drawn: Drawn, purpose: Purpose}} first
 * @param {(last: {drawn: Drawn, purpose: Purpose}, made: string | null) => void} over told when the tool is closed, with the name of the shape that was made
 * @returns {Tool}
 */
export function createDraw(bench, stage, first, over) {
  const { app } = bench;
  const touch = matchMedia("(pointer: coarse)").matches;
  let { drawn, purpose } = first;
  /** @type {Point[]} */
  let points = [];
  /** A stroke under way, document units. @type {Point[]} */
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

  const kinds = /** @type {Drawn[]} */ (Object.keys(KINDS));
  const kind = select({ label: words.kind, name: "draw-kind", choices: kinds.map((value) => ({ value, text: KINDS[value] })) }, (value) => {
    drawn = value;
    restart();
  });
  const purposes = segment(
    {
      label: words.as,
      name: "draw-as",
      choices: /** @type {Purpose[]} */ (["reference", "body", "hole"]).map((value) => ({ value, text: words[value] })),
    },
    (value) => {
      purpose = value;
      refresh();
    },
  );
  const hint = h("span", { class: "draw-hint", "data-hint": "" });
  const button = (/** @type {string} */ name, /** @type {string} */ text, /** @type {() => void} */ act) =>
    h("button", { type: "button", class: "command-word", "data-draw": name, onclick: act }, text);
  const back = button("back", words.back, takeBack);
  const finish = button("close", words.close, done);
  const cancel = button("cancel", words.cancel, giveUp);
  const bar = h(
    "div",
    { class: "draw-bar shape-draw-bar", role: "group", "aria-label": words.region, "data-furniture": "" },
    kind.element,
    purposes.element,
    hint,
    h("span", { class: "draw-commands" }, back, finish, cancel),
  );
  const keyboard = h("div", {
    class: "draw-keys",
    tabIndex: 0,
    role: "application",
    "aria-label": words.keyboard,
    "aria-describedby": "shape-draw-help",
  });
  const help = h("p", { id: "shape-draw-help", class: "spoken" }, words.help);
  stage.append(marks, keyboard, help, bar);
  const listening = new AbortController();
  addEventListener("keydown", key, { capture: true, signal: listening.signal });
  keyboard.focus({ preventScroll: true });

  const invisible = () => bench.now().view === null;
  const closes = () => NEEDS[drawn].closes;

  /** @param {KeyboardEvent} event */
  function key(event) {
    const target = event.target instanceof Element ? event.target : null;
    const undoes = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "z" && points.length > 0;
    if ((!undoes && (event.ctrlKey || event.metaKey)) || target?.closest("input[type=text], select, [data-panel], [role=menu]")) return;
    const own = !target || target === document.body || target === keyboard;
    if (event.key === "Escape") giveUp();
    else if (undoes || event.key === "Backspace" || event.key === "Delete") takeBack();
    else if (!own) return;
    else if (event.key === "Enter") done();
    else if (event.key === " ") setPoint(crosshair());
    else if (ARROWS[event.key]) moveCross(ARROWS[event.key], event);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** @returns {Point} */
  const crosshair = () => cross ?? points.at(-1) ?? bench.now().view?.center ?? [0, 0];

  /** @param {Point} arrow @param {KeyboardEvent} event */
  function moveCross(arrow, event) {
    const { view, size } = bench.now();
    if (!view) return;
    const snaps = bench.step() !== null;
    const step = snaps ? gridStep(view.scale) : STEP / view.scale;
    const by = step * (event.shiftKey ? (snaps ? 5 : 10) : event.altKey && !snaps ? 0.1 : 1);
    const [x, y] = crosshair();
    cross = rested(bench, [x + arrow[0] * by, y + arrow[1] * by], false);
    pointer = null;
    const [sx, sy] = toScreen(view, size, cross);
    const out = /** @type {Point} */ ([
      sx < EDGE.side ? EDGE.side - sx : Math.min(0, size.width - EDGE.side - sx),
      sy < EDGE.side ? EDGE.side - sy : Math.min(0, size.height - EDGE.foot - sy),
    ]);
    if (out[0] !== 0 || out[1] !== 0) app.ui.set({ view: panned(view, out), fitted: false });
    app.say(words.cross(coordinate(cross[0]), coordinate(cross[1])));
    refresh();
  }

  /** @param {Point} at document units */
  function setPoint(at) {
    const last = points.at(-1);
    if (fitting || invisible()) return;
    if (last && last[0] === at[0] && last[1] === at[1]) {
      if (!isChain(drawn)) tell(words.same);
      return;
    }
    points.push(at);
    said = "";
    if (points.length >= NEEDS[drawn].most) return done();
    app.say(words.set(points.length, coordinate(at[0]), coordinate(at[1])));
    refresh();
  }

  function takeBack() {
    points.pop();
    said = "";
    app.say(words.taken(points.length));
    refresh();
  }

  function restart() {
    points = [];
    line = [];
    said = "";
    refresh();
    keyboard.focus({ preventScroll: true });
  }

  /** @param {string} text */
  function tell(text) {
    said = text;
    app.say(text);
    refresh();
  }

  function done() {
    if (fitting) return;
    if (points.length < NEEDS[drawn].fewest) return tell(hintText());
    const shape = shapeFrom(drawn, points);
    if (shape) return make(shape);
    if (NEEDS[drawn].most === points.length) points.pop();
    tell(drawn === "closed" ? words.flat : words.same);
  }

  /** @param {PartShape} shape */
  function make(shape) {
    const { document, shown, view } = bench.now();
    const what = closes() ? purpose : "reference";
    const body = what === "hole" ? bodyFor(document, shown.body, shape) : null;
    const rounded = withAim(shape, view);
    const why = whyNotPut(document, rounded, what, body);
    if (why) {
      if (!isChain(drawn)) points.pop();
      return tell(words[why]);
    }
    const name = nameFor(document, drawn, what);
    close(name);
    bench.commit((now) => put(now, name, rounded, what, body));
    bench.change({ shape: name, point: null });
    app.say(body === null ? words.done(name) : words.cut(name, document.bodies[body].name));
  }

  /** A shape without digits that nobody could aim at: they would only be in the way of editing. @param {PartShape} shape @param {import("../../types.js").View | null} view @returns {PartShape} */
  function withAim(shape, view) {
    if (!view) return shape;
    if (shape.kind === "curve") return { ...shape, points: shape.points.map(([x, y]) => /** @type {Point} */ ([aimed(x, view), aimed(y, view)])) };
    return shape.kind === "circle" ? { ...shape, radius: restedRadius(bench, shape.radius, false) } : shape;
  }

  /** Fits a curve to the stroke. */
  async function fitLine() {
    const { view } = bench.now();
    const stroke = line;
    line = [];
    if (!view) return;
    if (drawn === "open") {
      const shape = shapeFrom("open", spread(stroke, view.scale));
      return shape ? make(shape) : tell(words.tooShort);
    }
    if (!isLoop(stroke, view.scale)) return tell(words.tooShort);
    fitting = true;
    refresh();
    try {
      const { curve } = await app.kernel.fitCurve(stroke, { tolerance: TOLERANCE / view.scale, corners: "smooth", through: false });
      fitting = false;
      if (app.tool === tool) make({ kind: "curve", degree: curve.degree, form: curve.form, points: curve.points, ...(curve.knots ? { knots: curve.knots } : {}) });
    } catch (error) {
      fitting = false;
      if (app.tool === tool) tell(problem(error).message);
    }
  }

  function giveUp() {
    close(null);
    app.say(words.gaveUp);
  }

  /** @param {string | null} made */
  function close(made) {
    if (app.tool !== tool) return;
    listening.abort();
    for (const each of [marks, keyboard, help, bar]) each.remove();
    app.tool = null;
    over({ drawn, purpose }, made);
  }

  function hintText() {
    if (said) return said;
    return fitting ? words.fitting : words.hint(drawn, points.length, NEEDS[drawn].fewest, touch);
  }

  /** Pans, zooms and steps alike end in a new drawing of the marks. */
  function refresh() {
    const { view, size } = bench.now();
    if (!view) return;
    kind.set(drawn);
    purposes.set(purpose);
    purposes.element.hidden = !closes();
    const here = pointer ?? cross;
    const through = here && points.length > 0 ? [...points, here] : points;
    const path = (/** @type {readonly Point[]} */ chain) =>
      chain.length < 2 ? "" : `M${chain.map((at) => toScreen(view, size, at).map((v) => v.toFixed(1)).join(" ")).join("L")}`;
    const shape = drawn === "polygon" || drawn === "point" ? null : shapeFrom(drawn, through);
    attribute(preview, "d", line.length > 1 ? path(line) : shape ? outlinePath(view, size, shape) : path(through));
    const ring = line.length > 1 ? line : through;
    const isOpenRing = (line.length > 1 && drawn === "closed") || (drawn === "polygon" && ring.length > 2);
    attribute(closing, "d", isOpenRing ? path([ring[ring.length - 1], ring[0]]) : "");
    dots.replaceChildren(
      ...points.map((at, i) => {
        const [x, y] = toScreen(view, size, at);
        const isFirst = closes() && isChain(drawn) && i === 0 && points.length >= NEEDS[drawn].fewest;
        return svg("circle", { cx: x.toFixed(1), cy: y.toFixed(1), r: isFirst ? FIRST : DOT, class: isFirst ? "draw-first" : "draw-dot" });
      }),
    );
    const shown = cross && !pointer;
    cursor.style.display = shown ? "" : "none";
    if (shown) attribute(cursor, "transform", `translate(${toScreen(view, size, cross ?? [0, 0]).join(" ")})`);
    write(hint, hintText());
    write(finish, closes() ? words.close : words.finish);
    back.disabled = points.length === 0;
    finish.disabled = points.length < NEEDS[drawn].fewest;
    finish.hidden = !isChain(drawn);
    back.hidden = NEEDS[drawn].most === 1;
  }

  /** @param {Point} at CSS pixels @param {boolean} invert */
  function planeOf(at, invert = false) {
    const { view, size } = bench.now();
    return view ? rested(bench, toPlane(view, size, at), invert) : at;
  }

  /** Whether a press is meant for a point. @param {Point} at @param {Point | undefined} point @param {number} reach */
  function isOn(at, point, reach) {
    const { view, size } = bench.now();
    if (!view || !point) return false;
    const [x, y] = toScreen(view, size, point);
    return Math.hypot(x - at[0], y - at[1]) <= reach;
  }

  /** A drag that draws a curve. @param {Point} at CSS pixels @returns {Stroke} */
  function freehand(at) {
    const { view, size } = bench.now();
    let last = at;
    line = view ? [toPlane(view, size, at)] : [];
    said = "";
    return {
      to(to) {
        const { view: now, size: room } = bench.now();
        if (!now || Math.hypot(to[0] - last[0], to[1] - last[1]) < SPACING) return;
        last = to;
        line.push(toPlane(now, room, to));
        refresh();
      },
      end: () => void fitLine(),
      undo() {
        line = [];
        refresh();
      },
    };
  }

  /** A drag from the first point to the second. @param {Point} at CSS pixels @returns {Stroke} */
  function pulled(at) {
    let to = at;
    return {
      to(next) {
        // A press that does not move is a tap, which sets its point itself.
        points = [planeOf(at)];
        said = "";
        to = next;
        pointer = planeOf(next);
        refresh();
      },
      end() {
        pointer = null;
        setPoint(planeOf(to));
      },
      undo() {
        points = [];
        pointer = null;
        refresh();
      },
    };
  }

  /** @type {Tool} */
  const tool = {
    hover(at) {
      if (!at && !pointer) return;
      const isFirst = at && closes() && isChain(drawn) && points.length >= NEEDS[drawn].fewest && isOn(at, points[0], REACH.mouse);
      pointer = at ? (isFirst ? points[0] : planeOf(at)) : null;
      if (at) cross = null;
      refresh();
    },
    tap(at, event) {
      const reach = event.pointerType === "touch" ? REACH.touch : REACH.mouse;
      pointer = null;
      cross = null;
      // Enter and Backspace are meant for what is drawn, also after a choice in the bar.
      keyboard.focus({ preventScroll: true });
      const enough = points.length >= NEEDS[drawn].fewest;
      const isFirst = isChain(drawn) && closes() && enough && isOn(at, points[0], reach);
      // The second half of a double click lands on the point that the first half has set.
      const doubled = isChain(drawn) && event.pointerType !== "touch" && isOn(at, points.at(-1), TWICE);
      if (isFirst || (doubled && enough)) done();
      else if (!doubled) setPoint(planeOf(at, event.ctrlKey || event.metaKey));
    },
    stroke(at) {
      if (fitting || points.length > 0 || drawn === "point") return null;
      if (isCurved(drawn)) return freehand(at);
      return isChain(drawn) ? null : pulled(at);
    },
    render: refresh,
    close: () => close(null),
  };
  app.tool = tool;
  refresh();
  return tool;
}
