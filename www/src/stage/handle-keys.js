/**
 * Keys on the handles: arrows move, page keys go from point to point, Insert and Delete change their number.
 *
 * @import { App } from "../state/app.js"
 * @import { Curve, Point } from "../types.js"
 */
import { newRun } from "../controls/run.js";
import { coordinate } from "../format.js";
import { curveName, pointName } from "../state/app.js";
import { handleCount, moveCurve, movePoint, tidy } from "../state/edits.js";
import { strings } from "../strings.js";
import { arrowStep } from "../view.js";
import { centerOf } from "./handles.js";
import { insertAfter, remove } from "./points.js";

/** Milliseconds between two arrow keys that still belong to one run. */
const PAUSE = 1000;

/** @type {{[key: string]: Point}} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/**
 * @param {App} app
 * @param {ReturnType<typeof import("./handles.js").createHandles>} handles
 */
export function listenToKeys(app, handles) {
  let run = newRun("keys");
  let last = 0;

  handles.element.addEventListener("focusin", (event) => {
    const chosen = selectionOf(event.target);
    if (!chosen) return;
    run = newRun("keys");
    app.ui.set({ selection: chosen });
  });

  handles.element.addEventListener("keydown", (event) => {
    const chosen = selectionOf(event.target);
    if (!chosen || event.ctrlKey || event.metaKey) return;
    if (handle(event, chosen)) {
      event.preventDefault();
      event.stopPropagation();
    }
  });

  /**
   * @param {KeyboardEvent} event
   * @param {{curve: 0 | 1, point: number | null}} chosen
   * @returns {boolean} whether the key meant something
   */
  function handle(event, { curve, point }) {
    const arrow = ARROWS[event.key];
    if (arrow) {
      move(curve, point, arrow, event);
      return true;
    }
    const count = handleCount(app.store.document.curves[curve]);
    switch (event.key) {
      case "PageDown":
        go(curve, point === null ? 0 : (point + 1) % count);
        return true;
      case "PageUp":
        go(curve, point === null ? count - 1 : (point + count - 1) % count);
        return true;
      case "Home":
        go(curve, null);
        return true;
      case "End":
        go(curve, count - 1);
        return true;
      case "Insert":
        void insertAfter(app, curve, point ?? 0).then(() => refocus(curve));
        return true;
      case "Delete":
      case "Backspace":
        if (point === null) return false;
        remove(app, curve, point);
        refocus(curve);
        return true;
      case "Escape":
        if (!app.store.cancel(run)) return false;
        run = newRun("keys");
        speak(curve, point);
        return true;
      default:
        return false;
    }
  }

  /**
   * @param {0 | 1} curve
   * @param {number | null} point
   * @param {Point} arrow
   * @param {KeyboardEvent} event
   */
  function move(curve, point, arrow, event) {
    const now = performance.now();
    if (now - last > PAUSE) run = newRun("keys");
    last = now;
    const by = arrowStep(app.store.document) * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
    const [dx, dy] = [arrow[0] * by, arrow[1] * by];
    app.store.commit({
      run,
      change: (document) => {
        if (point === null) return moveCurve(document, curve, [dx, dy]);
        const [x, y] = /** @type {Point} */ (document.curves[curve].points[point]);
        return movePoint(document, curve, point, [tidy(x + dx), tidy(y + dy)]);
      },
    });
    speak(curve, point);
  }

  /** @param {0 | 1} curve @param {number | null} point */
  function go(curve, point) {
    app.ui.set({ selection: { curve, point } });
    handles.render();
    handles.focus({ curve, point });
  }

  /** @param {0 | 1} curve */
  function refocus(curve) {
    handles.render();
    handles.focus({ curve, point: app.ui.value.selection?.point ?? 0 });
  }

  /** @param {0 | 1} curve @param {number | null} point */
  function speak(curve, point) {
    app.say(spokenPlace(app, curve, point));
  }
}

/**
 * Where a handle is, in words.
 * @param {App} app
 * @param {0 | 1} curve
 * @param {number | null} point
 */
export function spokenPlace(app, curve, point) {
  const shape = /** @type {Curve} */ (app.store.document.curves[curve]);
  const [x, y] = point === null ? centerOf(shape) : /** @type {Point} */ (shape.points[point]);
  return point === null
    ? strings.handles.curve(curveName(app.store.document, curve), coordinate(x), coordinate(y))
    : strings.handles.point(pointName(curve, point), coordinate(x), coordinate(y));
}

/**
 * @param {EventTarget | null} target
 * @returns {{curve: 0 | 1, point: number | null} | null}
 */
export function selectionOf(target) {
  if (!(target instanceof Element)) return null;
  const handle = target.closest("[data-handle]");
  if (handle instanceof HTMLElement) {
    const name = handle.dataset.handle ?? "";
    return { curve: name.startsWith("A") ? 0 : 1, point: Number(name.slice(1)) - 1 };
  }
  const path = target.closest("[data-outline]");
  return path ? { curve: path.getAttribute("data-outline") === "0" ? 0 : 1, point: null } : null;
}
