/**
 * Keys on the handles: arrows move, page keys go from point to point, Insert and Delete change their number.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Point, Selection } from "../types.js"
 * @import { Held } from "./handles.js"
 */
import { ARROWS, KeyRun, stride } from "../controls/arrows.js";
import { coordinate } from "../format.js";
import { curveName, pointName } from "../state/app.js";
import { handleCount, movePoints } from "../state/edits.js";
import { includes, isWhole, middleOf, movedPoints, only, several, whole } from "../state/selection.js";
import { strings } from "../strings.js";
import { arrowStep } from "../view.js";
import { pointBy } from "./point-keys.js";
import { insertAfter, remove } from "./points.js";

/**
 * @param {App} app
 * @param {ReturnType<typeof import("./handles.js").createHandles>} handles
 */
export function listenToKeys(app, handles) {
  const runs = new KeyRun("keys");

  handles.element.addEventListener("focusin", (event) => {
    const held = heldBy(event.target);
    if (!held) return;
    runs.renew();
    const { selection } = app.ui.value;
    const { curve, point } = held;
    const kept = point === null ? isWhole(selection) && selection?.curve === curve : includes(selection, curve, point);
    if (!kept) app.ui.set({ selection: chosenBy(held) });
  });

  handles.element.addEventListener("keydown", (event) => {
    const held = heldBy(event.target);
    if (!held || event.ctrlKey || event.metaKey) return;
    if (handle(event, held)) {
      event.preventDefault();
      event.stopPropagation();
    }
  });

  /**
   * @param {KeyboardEvent} event
   * @param {Held} held
   * @returns {boolean} whether the key meant something
   */
  function handle(event, { curve, point }) {
    const arrow = ARROWS[event.key];
    if (arrow) {
      move(arrow, event);
      return true;
    }
    const next = pointBy(event.key, point, handleCount(app.store.document.curves[curve]));
    if (next !== undefined) {
      go(curve, next, event.shiftKey && event.key.startsWith("Page"));
      return true;
    }
    switch (event.key) {
      case "Insert":
        void insertAfter(app, curve, point ?? 0).then(refocus);
        return true;
      case "Delete":
      case "Backspace":
        if (point === null || event.shiftKey) return false;
        remove(app, curve, app.ui.value.selection?.points ?? [point]);
        refocus();
        return true;
      case "Escape":
        if (!app.store.cancel(runs.name)) return false;
        runs.renew();
        speak();
        return true;
      default:
        return false;
    }
  }

  /**
   * @param {Point} arrow
   * @param {KeyboardEvent} event
   */
  function move(arrow, event) {
    const { selection } = app.ui.value;
    if (!selection) return;
    const run = runs.press();
    const by = arrowStep(app.store.document) * stride(event);
    app.store.commit({
      run,
      change: (document) =>
        movePoints(document, selection.curve, movedPoints(document, selection), [arrow[0] * by, arrow[1] * by]),
    });
    speak();
  }

  /**
   * @param {number} curve
   * @param {number | null} point
   * @param {boolean} [extend] keeps the points chosen so far
   */
  function go(curve, point, extend = false) {
    const { selection } = app.ui.value;
    const kept = extend && selection?.curve === curve ? selection.points : [];
    app.ui.set({ selection: point === null ? whole(curve) : several(curve, [...kept, point]) });
    handles.render();
    handles.focus({ curve, point });
    if (kept.length > 0) speak();
  }

  function refocus() {
    handles.render();
    const { selection } = app.ui.value;
    if (selection) handles.focus({ curve: selection.curve, point: selection.points[0] ?? null });
  }

  function speak() {
    const { selection } = app.ui.value;
    if (selection) app.say(spokenPlace(app.store.document, selection));
  }
}

/**
 * Where the selection is, in words.
 * @param {CurvesDocument} document
 * @param {Selection} selection
 */
export function spokenPlace(document, selection) {
  const { curve, points } = selection;
  const [x, y] = middleOf(document, selection).map(coordinate);
  if (points.length === 0) return strings.handles.curve(curveName(document, curve), x, y);
  const name = points.length === 1 ? pointName(curve, points[0]) : strings.curves.several(points.length);
  return strings.handles.point(name, x, y);
}

/**
 * The handle that an event is about; its point is null for the outline.
 * @param {EventTarget | null} target
 * @returns {Held | null}
 */
export function heldBy(target) {
  if (!(target instanceof Element)) return null;
  const handle = target.closest("[data-handle]");
  if (handle instanceof HTMLElement) {
    const name = handle.dataset.handle ?? "";
    return { curve: name.startsWith("A") ? 0 : 1, point: Number(name.slice(1)) - 1 };
  }
  const path = target.closest("[data-outline]");
  return path ? { curve: path.getAttribute("data-outline") === "0" ? 0 : 1, point: null } : null;
}

/**
 * The selection of just what is held.
 * @param {Held} held
 */
export const chosenBy = ({ curve, point }) => (point === null ? whole(curve) : only(curve, point));
