/**
 * Pointer, wheel and touch on a picture of the plane: a press becomes a drag, two fingers pinch, the wheel zooms about the pointer. What a press means
 * is asked of who shows the picture; what lies in `[data-furniture]` within it is left alone.
 *
 * @import { App } from "../state/app.js"
 * @import { Point, View } from "../types.js"
 *
 * @typedef {object} Drag
 * @property {"point" | "curve" | "pan" | "box" | "stroke"} kind
 * @property {Point} from CSS pixels
 * @property {boolean} moved
 * @property {(to: Point, event: PointerEvent) => void} to
 * @property {() => void} [end] after a drag that moved
 * @property {() => void} undo
 *
 * @typedef {object} Handlers
 * @property {(at: Point, event: PointerEvent) => Drag} press of the main or the middle button, or of a first finger
 * @property {(at: Point | null, isPressed: boolean) => void} hover null over furniture and outside; not told of fingers
 * @property {(drag: Drag, at: Point, event: PointerEvent) => void} released a press that did not move, or that moved and has no end of its own
 * @property {() => void} [moving] a press turned out to be a drag, or is over
 * @property {() => void} [finished] a drag is over, however it went
 * @property {AbortSignal} [signal] ends the listening
 *
 * @typedef {object} Gestures
 * @property {(event: MouseEvent) => Point} place of an event in the picture, CSS pixels
 * @property {(event: Event) => boolean} onFurniture
 * @property {() => Drag | null} current
 * @property {() => void} giveUp takes back what is under way
 * @property {(from: Point) => Drag} pan a drag that moves the view
 */
import { panned, zoomed } from "../view.js";
import { zoomLimits } from "./zoom.js";

/** Pixels before a press counts as a drag. */
const DEAD = 3;
/** Wheel: factor for one pixel of scroll; a line counts as 16 pixels. */
const WHEEL = 0.0016;
const LINE = 16;

/**
 * @param {App} app
 * @param {HTMLElement} stage
 * @param {Handlers} handlers
 * @returns {Gestures}
 */
export function listenToGestures(app, stage, { press, hover, released, moving, finished, signal }) {
  /** @type {Map<number, Point>} */
  const down = new Map();
  /** @type {Drag | null} */
  let drag = null;
  /** @type {number | null} */
  let pinch = null;

  /** @param {MouseEvent} event @returns {Point} */
  const place = (event) => {
    const frame = stage.getBoundingClientRect();
    return [event.clientX - frame.left, event.clientY - frame.top];
  };
  /** @param {Event} event */
  const onFurniture = (event) => {
    const furniture = event.target instanceof Element ? event.target.closest("[data-furniture]") : null;
    return furniture !== null && furniture !== stage;
  };

  stage.addEventListener("pointerdown", (event) => {
    if (event.button > 1 || onFurniture(event)) return;
    const at = place(event);
    down.set(event.pointerId, at);
    stage.setPointerCapture(event.pointerId);
    moving?.();
    if (down.size === 2) {
      drag?.undo();
      finish();
      pinch = spread(down);
      return;
    }
    if (down.size > 2) return;
    event.preventDefault();
    drag = press(at, event);
    stage.dataset.drag = drag.kind;
  });

  stage.addEventListener("pointermove", (event) => {
    const at = place(event);
    const last = down.get(event.pointerId);
    if (event.pointerType !== "touch") hover(onFurniture(event) ? null : at, last !== undefined);
    if (!last) return;
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
      moving?.();
      drag.to(at, event);
    }
  });

  /** @param {PointerEvent} event */
  const up = (event) => {
    moving?.();
    if (!down.delete(event.pointerId)) return;
    pinch = null;
    if (!drag) return;
    if (event.type === "pointercancel") drag.undo();
    else if (drag.moved && drag.end) drag.end();
    else released(drag, place(event), event);
    finish();
  };
  stage.addEventListener("pointerup", up);
  stage.addEventListener("pointercancel", up);
  stage.addEventListener("pointerleave", (event) => {
    // A finger leaves with every tap, and what it asked for stays.
    if (event.pointerType !== "touch") hover(null, false);
  });

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
    { capture: true, ...(signal ? { signal } : {}) },
  );

  function finish() {
    drag = null;
    delete stage.dataset.drag;
    finished?.();
    app.store.endRun();
  }

  /** @param {View} view */
  function show(view) {
    app.ui.set({ view, fitted: false });
  }

  return {
    place,
    onFurniture,
    current: () => drag,
    giveUp() {
      drag?.undo();
      finish();
      down.clear();
    },
    pan(from) {
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
    },
  };
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
