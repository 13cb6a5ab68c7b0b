/**
 * The camera by pointer, touch and wheel: a drag turns, with Shift, the right or the middle button it moves; the wheel and two fingers
 * zoom; two fingers move.
 *
 * @import { Point } from "../types.js"
 *
 * @typedef {object} Gestures
 * @property {(x: number, y: number) => void} turn CSS pixels
 * @property {(x: number, y: number) => void} pan CSS pixels
 * @property {(at: Point, factor: number) => void} zoom
 * @property {(at: Point | null) => void} hover a pointer that hovers; null when it leaves or begins to drag
 * @property {(at: Point, isMore: boolean) => void} tap `isMore`: with Shift or Ctrl, which means besides what is chosen
 * @property {() => void} rest a drag has ended
 */

/** CSS pixels that a press may move and still be a tap. */
const DEAD = 4;
/** Factor of one CSS pixel of the wheel, and pixels of its lines. */
const WHEEL = 1.0015;
const LINE = 24;

/**
 * @param {HTMLElement} element
 * @param {Gestures} gestures
 * @returns {() => void} ends the listening
 */
export function listenToGestures(element, gestures) {
  const over = new AbortController();
  const { signal } = over;
  /** @type {Map<number, Point>} */
  const held = new Map();
  let moved = false;
  let pans = false;

  /** @param {MouseEvent} event @returns {Point} */
  const placeOf = ({ clientX, clientY }) => {
    const box = element.getBoundingClientRect();
    return [clientX - box.left, clientY - box.top];
  };

  element.addEventListener(
    "pointerdown",
    (down) => {
      if (down.button > 2) return;
      element.setPointerCapture(down.pointerId);
      if (held.size === 0) {
        moved = false;
        pans = down.shiftKey || down.button > 0;
      } else moved = true;
      held.set(down.pointerId, placeOf(down));
    },
    { signal },
  );
  element.addEventListener(
    "pointermove",
    (event) => {
      const before = held.get(event.pointerId);
      const at = placeOf(event);
      if (!before) {
        // With a button down something else is dragged across, such as a handle.
        if (event.pointerType !== "touch") gestures.hover(event.buttons === 0 ? at : null);
        return;
      }
      const by = /** @type {Point} */ ([at[0] - before[0], at[1] - before[1]]);
      if (!moved && Math.hypot(...by) < DEAD) return;
      if (!moved) gestures.hover(null);
      moved = true;
      if (held.size === 1) {
        held.set(event.pointerId, at);
        if (pans) gestures.pan(...by);
        else gestures.turn(...by);
        return;
      }
      const other = [...held].find(([id]) => id !== event.pointerId)?.[1] ?? before;
      held.set(event.pointerId, at);
      const spread = (/** @type {Point} */ place) => Math.max(1, Math.hypot(place[0] - other[0], place[1] - other[1]));
      gestures.pan(by[0] / 2, by[1] / 2);
      gestures.zoom([(at[0] + other[0]) / 2, (at[1] + other[1]) / 2], spread(at) / spread(before));
    },
    { signal },
  );
  /** @param {PointerEvent} event */
  const up = (event) => {
    const at = held.get(event.pointerId);
    if (!held.delete(event.pointerId) || !at || held.size > 0) return;
    if (!moved && event.type === "pointerup") gestures.tap(at, event.shiftKey || event.ctrlKey || event.metaKey);
    else gestures.rest();
  };
  for (const type of /** @type {const} */ (["pointerup", "pointercancel"])) element.addEventListener(type, up, { signal });
  element.addEventListener("pointerleave", () => held.size === 0 && gestures.hover(null), { signal });
  element.addEventListener("contextmenu", (event) => event.preventDefault(), { signal });
  element.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const pixels = event.deltaY * (event.deltaMode === 0 ? 1 : LINE);
      gestures.zoom(placeOf(event), WHEEL ** -pixels);
      gestures.rest();
    },
    { signal, passive: false },
  );
  return () => over.abort();
}
