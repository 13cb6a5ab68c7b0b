/**
 * Pointer, wheel and touch on the figure: drag points or a curve, select in a box, pan, zoom about the pointer, pinch, and
 * ask for a menu. A tool that has the canvas is served from here too.
 *
 * @import { App } from "../state/app.js"
 * @import { Point, Selection } from "../types.js"
 * @import { Held } from "./handles.js"
 *
 * @typedef {object} Drag
 * @property {"point" | "curve" | "pan" | "box" | "stroke"} kind
 * @property {Point} from CSS pixels
 * @property {boolean} moved
 * @property {(to: Point, event: PointerEvent) => void} to
 * @property {() => void} [end] after a drag that moved
 * @property {() => void} undo
 */
import { newRun } from "../controls/run.js";
import { find } from "../dom.js";
import { movePoints } from "../state/edits.js";
import { seen } from "../state/in-space.js";
import { includes, movedPoints, toggle } from "../state/selection.js";
import { panned, toPlane, zoomed } from "../view.js";
import { createBox } from "./box.js";
import { chosenBy, heldBy, spokenPlace } from "./handle-keys.js";
import { insertAt } from "./points.js";
import { rested } from "./snap.js";
import { zoomLimits } from "./zoom.js";

/** Half the hit area of a handle, by pointer and by touch. */
const REACH = { mouse: 12, touch: 22 };
/** Pixels before a press counts as a drag. */
const DEAD = 3;
/** Milliseconds of a touch that rests before it asks for the menu. */
const LONG = 550;
/** Wheel: factor for one pixel of scroll; a line counts as 16 pixels. */
const WHEEL = 0.0016;
const LINE = 16;

/**
 * @param {App} app
 * @param {ReturnType<typeof import("./handles.js").createHandles>} handles
 * @param {{hover: (at: Point | null) => void, tap: (at: Point) => void, pick: (at: Point) => void}} probe
 * @param {{show: (at: Point | null) => void}} reading coordinates of the pointer
 */
export function listenToPointer(app, handles, probe, reading) {
  const stage = find("#stage");
  const box = createBox(app, handles);
  /** @type {Map<number, Point>} */
  const down = new Map();
  /** @type {Drag | null} */
  let drag = null;
  /** @type {number | null} */
  let pinch = null;
  /** @type {Held | null} */
  let pressed = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let rest;
  /** What was chosen before the press. */
  let { selection: before } = app.ui.value;

  /** @param {MouseEvent} event @returns {Point} */
  const place = (event) => {
    const frame = stage.getBoundingClientRect();
    return [event.clientX - frame.left, event.clientY - frame.top];
  };
  /** @param {Event} event */
  const onFurniture = (event) => event.target instanceof Element && event.target.closest("[data-furniture]") !== null;
  /** @param {Point} at @param {PointerEvent} event */
  const under = (at, event) =>
    handles.nearest(at, event.pointerType === "touch" ? REACH.touch : REACH.mouse) ?? heldBy(event.target);

  stage.addEventListener("pointerdown", (event) => {
    if (event.button > 1 || onFurniture(event)) return;
    const at = place(event);
    down.set(event.pointerId, at);
    stage.setPointerCapture(event.pointerId);
    clearTimeout(rest);
    if (down.size === 2) {
      drag?.undo();
      finish();
      pinch = spread(down);
      return;
    }
    if (down.size > 2) return;
    event.preventDefault();
    probe.hover(null);
    if (app.tool) {
      pressed = null;
      drag = (event.button === 0 ? strokeOf(app.tool, at) : null) ?? dragView(at);
      stage.dataset.drag = drag.kind;
      return;
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
      drag = dragSelection(held, selection, at);
    } else {
      if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
      drag = event.shiftKey && event.button === 0 ? box.drag(at) : dragView(at);
    }
    stage.dataset.drag = drag.kind;
  });

  stage.addEventListener("pointermove", (event) => {
    const at = place(event);
    if (event.pointerType !== "touch") reading.show(onFurniture(event) ? null : at);
    if (!down.has(event.pointerId)) {
      if (event.pointerType === "touch") return;
      if (app.tool) app.tool.hover(onFurniture(event) ? null : at);
      else probe.hover(!onFurniture(event) && handles.nearest(at, REACH.mouse) === null ? at : null);
      return;
    }
    const last = /** @type {Point} */ (down.get(event.pointerId));
    down.set(event.pointerId, at);
    if (down.size === 2 && pinch !== null) {
      const { view, size } = app.ui.value;
      const now = spread(down);
      if (!view || now === 0) return;
      const slid = panned(view, [(at[0] - last[0]) / 2, (at[1] - last[1]) / 2]);
      show(zoomed(slid, size, middle(down), now / pinch, zoomLimits(app)));
      pinch = now;
    } else if (drag) {
      if (!drag.moved && Math.hypot(at[0] - drag.from[0], at[1] - drag.from[1]) < DEAD) return;
      drag.moved = true;
      clearTimeout(rest);
      drag.to(at, event);
    }
  });

  /** @param {PointerEvent} event */
  const up = (event) => {
    clearTimeout(rest);
    if (!down.delete(event.pointerId)) return;
    pinch = null;
    if (!drag) return;
    const { moved, kind } = drag;
    if (event.type === "pointercancel") drag.undo();
    else if (moved && drag.end) drag.end();
    else if (moved && kind !== "pan") speakSelection();
    else if (moved) drag = null;
    else if (app.tool && event.button === 0) app.tool.tap(place(event), event);
    else if (kind === "pan" && event.pointerType === "touch") probe.tap(place(event));
    else if (kind === "pan" && event.button === 0) probe.pick(place(event));
    else if (pressed && !event.shiftKey) app.ui.set({ selection: chosenBy(pressed) });
    finish();
  };
  stage.addEventListener("pointerup", up);
  stage.addEventListener("pointercancel", up);
  stage.addEventListener("pointerleave", (event) => {
    // A finger leaves with every tap, and what it asked for stays.
    if (event.pointerType === "touch") return;
    reading.show(null);
    if (app.tool) app.tool.hover(null);
    else probe.hover(null);
  });

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
    if (!drag || drag.moved) return;
    drag.undo();
    finish();
    down.clear();
    app.ui.set({ selection: before });
    void menu(held, place(event), { left: event.clientX, top: event.clientY, bottom: event.clientY });
  }

  /** @param {Held | null} held @param {Point} at @param {{left: number, top: number, bottom: number}} where */
  async function menu(held, at, where) {
    probe.hover(null);
    const { openContextMenu } = await import("./context-menu.js");
    openContextMenu(app, held, at, where);
  }

  stage.addEventListener(
    "wheel",
    (event) => {
      const { view, size } = app.ui.value;
      if (!view || onFurniture(event)) return;
      event.preventDefault();
      const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? LINE : 1);
      const factor = Math.exp(-pixels * WHEEL * (event.ctrlKey ? 5 : 1));
      show(zoomed(view, size, place(event), factor, zoomLimits(app)));
    },
    { passive: false },
  );

  addEventListener(
    "keydown",
    (event) => {
      if (event.key !== "Escape" || !drag) return;
      event.stopPropagation();
      drag.undo();
      finish();
    },
    { capture: true },
  );

  function finish() {
    drag = null;
    delete stage.dataset.drag;
    handles.hold(null, false);
    app.store.endRun();
  }

  function speakSelection() {
    const { selection } = app.ui.value;
    if (selection) app.say(spokenPlace(app.store.document, selection));
  }

  /** @param {import("../types.js").View} view */
  function show(view) {
    app.ui.set({ view, fitted: false });
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

  /** @param {Point} from @returns {Drag} */
  function dragView(from) {
    const { view: start, fitted } = app.ui.value;
    return {
      kind: "pan",
      from,
      moved: false,
      to(at) {
        if (start) show(panned(start, [at[0] - from[0], at[1] - from[1]]));
      },
      undo: () => app.ui.set({ view: start, fitted }),
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

/** @param {Map<number, Point>} down */
function spread(down) {
  const [a, b] = [...down.values()];
  return a && b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
}

/** @param {Map<number, Point>} down @returns {Point} */
function middle(down) {
  const [a = [0, 0], b = a] = [...down.values()];
  return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
}
