/**
 * Shapes on the canvas of the workbench Part: outlines, handles, what a press on them means, and the tools that draw new ones.
 *
 * @import { Stroke } from "../../state/app.js"
 * @import { Point } from "../../types.js"
 * @import { Bench } from "../state.js"
 * @import { Held } from "./places.js"
 */
import "../../../styles/edit.css";
import "../../../styles/part-shapes.css";
import { newRun } from "../../controls/run.js";
import { shapeOf } from "../edits/shapes.js";
import { toPlane } from "../../view.js";
import { isReach, hasList } from "./geometry.js";
import { createHandles } from "./handles.js";
import { insertAt } from "./insert.js";
import { listenToKeys } from "./keys.js";
import { dragged, spokenPlace } from "./moves.js";
import { handleAt, nearestHandle, under } from "./places.js";
import { createTools } from "./tools.js";

/** Half the hit area of a handle and of an outline, by pointer and by touch. */
const REACH = { mouse: 12, touch: 22 };
const NEAR = { mouse: 7, touch: 14 };
/** Milliseconds within which a second tap belongs to a double one. */
const DOUBLE = 450;

/**
 * @param {Bench} bench
 * @param {HTMLElement} stage the element that the picture lies in
 */
export function createShapes(bench, stage) {
  const { app } = bench;
  const over = new AbortController();
  /** @type {string | null} */
  let hovered = null;
  /** @type {Map<string, number>} */
  const rims = new Map();
  /** What the pointer does now, which the functions of the stage are not told. */
  let touch = false;
  let invert = false;
  let button = 0;
  /** @type {Held | null} */
  let pressed = null;
  /** What was chosen before the press. @type {Held | null} */
  let before = null;
  let tapped = -Infinity;

  const tools = createTools(bench, stage);
  const handles = createHandles(bench, () => ({ hovered, rims, hidden: tools.isDrawing() }));
  stage.append(handles.element);
  listenToKeys(bench, handles);

  const { signal } = over;
  const note = (/** @type {PointerEvent} */ event) => {
    touch = event.pointerType === "touch";
    invert = event.ctrlKey || event.metaKey;
    if (event.type === "pointerdown") button = event.button;
  };
  for (const type of /** @type {const} */ (["pointerdown", "pointermove"])) stage.addEventListener(type, note, { signal, capture: true });
  stage.addEventListener("dblclick", (event) => {
    const { view, size, document } = bench.now();
    const shape = shapeOf(document, pressed?.shape ?? null);
    if (!view || !shape || pressed?.point !== null || !hasList(shape) || tools.isDrawing()) return;
    const frame = stage.getBoundingClientRect();
    void insertAt(bench, shape.name, toPlane(view, size, [event.clientX - frame.left, event.clientY - frame.top]));
  }, { signal });

  const reach = () => (touch ? "touch" : "mouse");

  /** What a place means: a handle of the chosen shape or of the one under the pointer, else an outline, that of the chosen shape first. @param {Point} at @returns {Held | null} */
  function heldAt(at) {
    const { document, view, size, shown } = bench.now();
    if (!view || !shown.shapes || shown.compare) return null;
    for (const name of new Set([shown.shape, hovered])) {
      const shape = shapeOf(document, name);
      const point = shape ? nearestHandle(view, size, shape, at, REACH[reach()], rims.get(shape.name)) : null;
      if (shape && point !== null) return { shape: shape.name, point };
    }
    const names = under(document, view, size, at, NEAR[reach()]);
    const name = shown.shape !== null && names.includes(shown.shape) ? shown.shape : names[0];
    const shape = shapeOf(document, name ?? null);
    return shape ? { shape: shape.name, point: shape.kind === "point" ? 0 : null } : null;
  }

  /** @param {Held | null} held */
  function mark(held) {
    const over = held ? (held.point === null ? "shape" : "point") : "";
    if (stage.dataset.over !== over) stage.dataset.over = over;
    if (hovered === (held?.shape ?? null)) return;
    hovered = held?.shape ?? null;
    bench.request();
  }

  /**
   * The drag of a handle or of a whole shape, which starts from the shape as it was.
   * @param {Held} held
   * @param {Point} from CSS pixels
   * @returns {Stroke | null}
   */
  function strokeOf(held, from) {
    const { document, view, size } = bench.now();
    const start = shapeOf(document, held.shape);
    if (!start || !view) return null;
    const run = newRun("shape");
    const place = held.point === null ? null : toPlane(view, size, handleAt(view, size, start, held.point, rims.get(held.shape)));
    return {
      to(at) {
        const { view: now } = bench.now();
        if (!now) return;
        const by = /** @type {Point} */ ([(at[0] - from[0]) / now.scale, (from[1] - at[1]) / now.scale]);
        const aim = place ? /** @type {Point} */ ([place[0] + by[0], place[1] + by[1]]) : by;
        if (start.kind === "circle" && held.point !== null && isReach(start, held.point)) {
          rims.set(held.shape, Math.atan2(aim[1] - start.center[1], aim[0] - start.center[0]));
        }
        bench.commit(dragged(bench, document, held, aim, invert), run);
      },
      end() {
        handles.hold(null, false);
        const shape = shapeOf(bench.now().document, held.shape);
        if (shape) app.say(spokenPlace(shape, held.point));
      },
      undo() {
        handles.hold(null, false);
        app.store.cancel(run);
      },
    };
  }

  return {
    render() {
      const { document } = bench.now();
      if (hovered !== null && !shapeOf(document, hovered)) hovered = null;
      handles.render();
      tools.render();
    },

    /** @param {Point | null} at CSS pixels; null when the pointer leaves @returns {boolean} whether it is over a shape, or a tool has the canvas */
    hover(at) {
      if (tools.tool) {
        tools.tool.hover(at);
        mark(null);
        return true;
      }
      const held = at && heldAt(at);
      mark(held);
      return held !== null;
    },

    /**
     * A press and release in one place. A second tap on a shape chooses the next one under it, one on nothing chooses none.
     * @param {Point} at
     * @param {PointerEvent} event
     * @returns {boolean} whether it was about a shape or a tool
     */
    tap(at, event) {
      handles.hold(null, false);
      if (tools.tool) {
        tools.tool.tap(at, event);
        return true;
      }
      const { document, view, size, shown } = bench.now();
      const now = performance.now();
      const isSecond = now - tapped < DOUBLE;
      tapped = now;
      const held = pressed;
      if (!held) {
        if (shown.shape !== null) bench.change({ shape: null, point: null });
        return false;
      }
      if (!view || isSecond || before?.shape !== held.shape || before.point !== held.point || held.point !== null) return true;
      const names = under(document, view, size, at, NEAR[reach()]);
      const next = names[(names.indexOf(held.shape) + 1) % names.length];
      if (next !== undefined && next !== held.shape) choose({ shape: next, point: null });
      return true;
    },

    /** @param {Point} at @returns {Stroke | null} null to pan */
    stroke(at) {
      if (tools.tool) return button === 0 ? tools.tool.stroke(at) : null;
      const { shown } = bench.now();
      before = shown.shape === null ? null : { shape: shown.shape, point: shown.point };
      const held = button === 0 ? heldAt(at) : null;
      pressed = held;
      if (!held) {
        if (globalThis.document.activeElement instanceof HTMLElement || globalThis.document.activeElement instanceof SVGElement) globalThis.document.activeElement.blur();
        return null;
      }
      choose(held);
      handles.hold(held, touch);
      return strokeOf(held, at);
    },

    close() {
      over.abort();
      tools.close();
      handles.element.remove();
      delete stage.dataset.over;
    },
  };

  /** @param {Held} held */
  function choose(held) {
    bench.change(held);
    handles.render();
    handles.focus(held);
  }
}
