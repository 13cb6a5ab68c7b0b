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
import { h, write } from "../../dom.js";
import { coordinate } from "../../format.js";
import { problem } from "../../painter.js";
import { chainPath, createBoard } from "../../stage/draw-board.js";
import { isLoop, spread, TOLERANCE } from "../../stage/strokes.js";
import { aimed, toPlane } from "../../view.js";
import { KINDS, words } from "./draw-words.js";
import { bodyFor, isChain, isCurved, nameFor, NEEDS, put, shapeFrom, whyNotPut } from "./drawing.js";
import { rested, restedRadius } from "./moves.js";
import { outlinePath } from "./places.js";

/** Pixels within which a click is meant for a point that is there, by pointer and by touch, and for the second half of a double click. */
const REACH = { mouse: 10, touch: 22 };
const TWICE = 3;
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
  /** A sentence that stands until the next step. */
  let said = "";
  let fitting = false;

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
  const board = createBoard(app, {
    name: "shape-draw",
    words,
    points: () => points,
    rested: (at) => rested(bench, at, false),
    refresh,
    giveUp,
    takeBack,
    finish: done,
    set: setPoint,
  });
  stage.append(board.marks, board.keyboard, board.help, bar);
  board.keyboard.focus({ preventScroll: true });

  const invisible = () => bench.now().view === null;
  const closes = () => NEEDS[drawn].closes;

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
    said = "";
    board.takeLine();
    refresh();
    board.keyboard.focus({ preventScroll: true });
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
    const stroke = board.takeLine();
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
    board.close();
    bar.remove();
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
    const here = board.here();
    const line = board.line();
    const through = here && points.length > 0 ? [...points, here] : points;
    const shape = drawn === "polygon" || drawn === "point" ? null : shapeFrom(drawn, through);
    const ring = line.length > 1 ? line : through;
    const isOpenRing = (line.length > 1 && drawn === "closed") || (drawn === "polygon" && ring.length > 2);
    board.draw(view, size, {
      line: line.length > 1 || !shape ? chainPath(view, size, ring) : outlinePath(view, size, shape),
      closing: isOpenRing ? [ring[ring.length - 1], ring[0]] : null,
      isClosable: closes() && isChain(drawn) && points.length >= NEEDS[drawn].fewest,
      hasCross: true,
    });
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

  /** A drag from the first point to the second. @param {Point} at CSS pixels @returns {Stroke} */
  function pulled(at) {
    let to = at;
    return {
      to(next) {
        // A press that does not move is a tap, which sets its point itself.
        points = [planeOf(at)];
        said = "";
        to = next;
        board.point(planeOf(next));
        refresh();
      },
      end() {
        board.point(null);
        setPoint(planeOf(to));
      },
      undo() {
        points = [];
        board.point(null);
        refresh();
      },
    };
  }

  /** @type {Tool} */
  const tool = {
    hover(at) {
      if (!at && !board.hasPointer()) return;
      const isFirst = at && closes() && isChain(drawn) && points.length >= NEEDS[drawn].fewest && board.isOn(at, points[0], REACH.mouse);
      board.point(at ? (isFirst ? points[0] : planeOf(at)) : null);
      refresh();
    },
    tap(at, event) {
      const reach = event.pointerType === "touch" ? REACH.touch : REACH.mouse;
      board.press();
      // Enter and Backspace are meant for what is drawn, also after a choice in the bar.
      board.keyboard.focus({ preventScroll: true });
      const enough = points.length >= NEEDS[drawn].fewest;
      const isFirst = isChain(drawn) && closes() && enough && board.isOn(at, points[0], reach);
      // The second half of a double click lands on the point that the first half has set.
      const doubled = isChain(drawn) && event.pointerType !== "touch" && board.isOn(at, points.at(-1), TWICE);
      if (isFirst || (doubled && enough)) done();
      else if (!doubled) setPoint(planeOf(at, event.ctrlKey || event.metaKey));
    },
    stroke(at) {
      if (fitting || points.length > 0 || drawn === "point") return null;
      if (isCurved(drawn)) {
        said = "";
        return board.stroke(at, () => void fitLine());
      }
      return isChain(drawn) ? null : pulled(at);
    },
    render: refresh,
    close: () => close(null),
  };
  app.tool = tool;
  refresh();
  return tool;
}
