/**
 * Pointer and touch on the figure of curves: drag points or a curve, select in a box, and ask for a menu. A tool that has the canvas is served from
 * here too. Pan, zoom and pinch are those of `gestures.js`.
 *
 * @import { App } from "../state/app.js"
 * @import { Point, Selection } from "../types.js"
 * @import { Drag } from "./gestures.js"
 * @import { Held } from "./handles.js"
 */
import { newRun } from "../controls/run.js";
import { find } from "../dom.js";
import { movePoints } from "../state/edits.js";
import { seen } from "../state/in-space.js";
import { includes, movedPoints, toggle } from "../state/selection.js";
import { toPlane } from "../view.js";
import { createBox } from "./box.js";
import { listenToGestures } from "./gestures.js";
import { chosenBy, heldBy, spokenPlace } from "./handle-keys.js";
import { insertAt } from "./points.js";
import { rested } from "./snap.js";

/** Half the hit area of a handle, by pointer and by touch. */
const REACH = { mouse: 12, touch: 22 };
/** Milliseconds of a touch that rests before it asks for the menu. */
const LONG = 550;

/**
 * @param {App} app
 * @param {ReturnType<typeof import("./handles.js").createHandles>} handles
 * @param {{hover: (at: Point | null) => void, tap: (at: Point) => void, pick: (at: Point) => void}} probe
 * @param {{show: (at: Point | null) => void}} reading coordinates of the pointer
 */
export function listenToPointer(app, handles, probe, reading) {
  const stage = find("#stage");
  const box = createBox(app, handles);
  /** @type {Held | null} */
  let pressed = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let rest;
  /** What was chosen before the press. */
  let { selection: before } = app.ui.value;

  const gestures = listenToGestures(app, stage, {
    press,
    hover(at, isPressed) {
      reading.show(at);
      if (isPressed) return;
      if (app.tool) app.tool.hover(at);
      else probe.hover(at && handles.nearest(at, REACH.mouse) === null ? at : null);
    },
    released({ kind, moved }, at, event) {
      if (moved && kind !== "pan") speakSelection();
      else if (moved) return;
      else if (app.tool && event.button === 0) app.tool.tap(at, event);
      else if (kind === "pan" && event.pointerType === "touch") probe.tap(at);
      else if (kind === "pan" && event.button === 0) probe.pick(at);
      else if (pressed && !event.shiftKey) app.ui.set({ selection: chosenBy(pressed) });
    },
    moving: () => clearTimeout(rest),
    finished: () => handles.hold(null, false),
  });
  const { place, onFurniture } = gestures;
  /** @param {Point} at @param {PointerEvent} event */
  const under = (at, event) =>
    handles.nearest(at, event.pointerType === "touch" ? REACH.touch : REACH.mouse) ?? heldBy(event.target);

  /** @param {Point} at @param {PointerEvent} event @returns {Drag} */
  function press(at, event) {
    probe.hover(null);
    if (app.tool) {
      pressed = null;
      return (event.button === 0 ? strokeOf(app.tool, at) : null) ?? gestures.pan(at);
    }
    const held = event.button === 0 ? under(at, event) : null;
    pressed = held;
    before = app.ui.value.selection;
    if (event.pointerType === "touch") rest = setTimeout(() => longPress(held, event), LONG);
    if (held) {
      const selection = chosen(held, event.shiftKey);
      app.ui.set({ selection });
      handles.render();
      handles.focus(held.point === null || includes(selection, held.curve, held.point) ? held : firstOf(selection));
      handles.hold(held, event.pointerType === "touch");
      return dragSelection(held, selection, at);
    }
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
    return event.shiftKey && event.button === 0 ? box.drag(at) : gestures.pan(at);
  }

  stage.addEventListener("dblclick", (event) => {
    const { view, size } = app.ui.value;
    if (pressed?.point === null && view) void insertAt(app, pressed.curve, toPlane(view, size, place(event)));
  });

  stage.addEventListener("contextmenu", (event) => {
    if (onFurniture(event)) return;
    event.preventDefault();
    if (app.tool || /** @type {PointerEvent} */ (event).pointerType === "touch") return;
    // From the keyboard the event comes from what has the focus, and so does the menu.
    const keyboard = event.button !== 2;
    const target = event.target instanceof Element ? event.target : stage;
    const held = keyboard ? heldBy(target) : under(place(event), /** @type {PointerEvent} */ (event));
    const frame = keyboard && held?.point !== null ? target.getBoundingClientRect() : null;
    void menu(held, place(event), frame ?? { left: event.clientX, top: event.clientY, bottom: event.clientY });
  });

  /** @param {Held | null} held @param {PointerEvent} event */
  function longPress(held, event) {
    if (!gestures.current() || gestures.current()?.moved) return;
    gestures.giveUp();
    app.ui.set({ selection: before });
    void menu(held, place(event), { left: event.clientX, top: event.clientY, bottom: event.clientY });
  }

  /** @param {Held | null} held @param {Point} at @param {{left: number, top: number, bottom: number}} where */
  async function menu(held, at, where) {
    probe.hover(null);
    const { openContextMenu } = await import("./context-menu.js");
    openContextMenu(app, held, at, where);
  }

  function speakSelection() {
    const { selection } = app.ui.value;
    if (selection) app.say(spokenPlace(app.store.document, selection));
  }

  /**
   * What a press on a handle chooses: a point of the selection takes the others along, Shift adds or drops one.
   * @param {Held} held
   * @param {boolean} add
   */
  function chosen(held, add) {
    const { selection } = app.ui.value;
    if (held.point !== null && add) return toggle(selection, held.curve, held.point);
    if (held.point !== null && includes(selection, held.curve, held.point)) return /** @type {Selection} */ (selection);
    return chosenBy(held);
  }

  /**
   * The held point comes to rest on the grid; a whole curve moves by whole steps of it.
   * @param {Held} held
   * @param {Selection} selection
   * @param {Point} from
   * @returns {Drag}
   */
  function dragSelection({ curve, point }, selection, from) {
    const { document } = app.store;
    // Curves in space may be seen from another side with every step, and the held point stays under the pointer.
    const held = () => /** @type {Point} */ (point === null ? [0, 0] : seen(document.curves[curve]).points[point]);
    const start = held();
    const moved = movedPoints(document, selection);
    const run = newRun("drag");
    return {
      kind: point === null ? "curve" : "point",
      from,
      moved: false,
      to(at, event) {
        const { view } = app.ui.value;
        if (!view) return;
        const aim = /** @type {Point} */ ([
          start[0] + (at[0] - from[0]) / view.scale,
          start[1] + (from[1] - at[1]) / view.scale,
        ]);
        const to = rested(app, aim, event.ctrlKey || event.metaKey);
        const was = held();
        const by = /** @type {Point} */ ([to[0] - was[0], to[1] - was[1]]);
        app.store.commit({ run, change: (now) => movePoints({ ...now, curves: document.curves }, curve, moved, by) });
      },
      undo: () => app.store.cancel(run),
    };
  }

  /** @param {import("../state/app.js").Tool} tool @param {Point} from @returns {Drag | null} */
  function strokeOf(tool, from) {
    const stroke = tool.stroke(from);
    return stroke && { ...stroke, kind: "stroke", from, moved: false };
  }
}

/** @param {Selection} selection @returns {Held} */
function firstOf({ curve, points }) {
  return { curve, point: points[0] ?? null };
}
