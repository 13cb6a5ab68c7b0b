/**
 * The handle of the place that a figure in the plane reads: dragged, and moved by arrow keys.
 *
 * @import { Point } from "../types.js"
 */
import { attribute, h } from "../dom.js";

/** CSS pixels of an arrow key; Shift makes them ten times as many, Alt a tenth. */
const NUDGE = 4;

/** @type {{[key: string]: Point}} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/**
 * @param {object} acts
 * @param {(event: PointerEvent) => Point} acts.placeOf
 * @param {() => Point | null} acts.at where the handle is, in pixels of the figure; none while there is nothing to read
 * @param {(to: Point, isDrag: boolean) => void} acts.put
 * @param {() => void} acts.released
 * @param {() => void} acts.moved by a key
 */
export function createPlaceHandle({ placeOf, at, put, released, moved }) {
  const handle = h("button", { type: "button", class: "handle round chosen", "data-lesson": "place" });
  handle.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    handle.focus({ preventScroll: true });
    handle.setPointerCapture(event.pointerId);
  });
  handle.addEventListener("pointermove", (event) => {
    if (handle.hasPointerCapture(event.pointerId)) put(placeOf(event), true);
  });
  for (const type of /** @type {const} */ (["pointerup", "pointercancel"])) handle.addEventListener(type, released);
  handle.addEventListener("keydown", (event) => {
    const arrow = ARROWS[event.key];
    const here = at();
    if (!arrow || !here || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    const by = NUDGE * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
    put([here[0] + by * arrow[0], here[1] + by * arrow[1]], false);
    moved();
  });
  return {
    element: handle,
    /** Shows the handle where it is. @param {number} zoom of the figure @param {string} name */
    show(zoom, name) {
      const here = at();
      if (!here) return;
      const [x, y] = here.map((each) => Math.round(each * zoom));
      handle.style.transform = `translate(${x}px, ${y}px)`;
      attribute(handle, "aria-label", name);
    },
  };
}
