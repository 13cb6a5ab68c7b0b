/**
 * The place that a figure in the plane reads, with its handle: dragged, and moved by arrow keys, within a box.
 *
 * @import { View } from "../../../js/directrix.js"
 * @import { Point } from "../types.js"
 */
import { stride } from "../controls/arrows.js";
import { toPlane, toScreen } from "../../../js/element/plane.js";
import { attribute, h } from "../dom.js";
import { fixed } from "../format.js";
import { words } from "./words.js";

/** CSS pixels of an arrow key; Shift makes them ten times as many, Alt a tenth. */
const NUDGE = 4;

/** @type {{[key: string]: Point}} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/**
 * @param {ReturnType<typeof import("./surface.js").createSurface>} surface
 * @param {object} options
 * @param {Point | null} options.place at first; a figure without one has no handle
 * @param {number} options.digits of its coordinates in words
 * @param {() => {view: View, box: readonly (readonly number[])[]} | null} options.ground the place lies in the box; null while there is nothing to read
 * @param {(isDrag: boolean) => void} options.changed
 * @param {() => void} options.released
 * @param {(text: string) => void} options.say
 */
export function createPlaceHandle(surface, { place: first, digits, ground, changed, released, say }) {
  let place = first;
  const handle = h("button", { type: "button", class: "handle round chosen", "data-lesson": "place" });
  surface.element.append(h("div", { class: "lesson-handles", hidden: first === null }, handle));

  /** @param {Point} at */
  const texts = ([x, y]) => /** @type {const} */ ([fixed(x, digits), fixed(y, digits)]);

  /** @param {Point} to on the screen @param {boolean} isDrag */
  function put(to, isDrag) {
    const here = ground();
    if (!here) return;
    const [[left, low], [right, high]] = here.box;
    const [x, y] = toPlane(here.view, surface.size(), to);
    place = [Math.min(right, Math.max(left, x)), Math.min(high, Math.max(low, y))];
    changed(isDrag);
  }

  handle.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    handle.focus({ preventScroll: true });
    handle.setPointerCapture(event.pointerId);
  });
  handle.addEventListener("pointermove", (event) => {
    if (handle.hasPointerCapture(event.pointerId)) put(surface.placeOf(event), true);
  });
  for (const type of /** @type {const} */ (["pointerup", "pointercancel"])) handle.addEventListener(type, released);
  handle.addEventListener("keydown", (event) => {
    const arrow = ARROWS[event.key];
    const here = ground();
    if (!arrow || !here || !place || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    const [x, y] = toScreen(here.view, surface.size(), place);
    const by = NUDGE * stride(event);
    put([x + by * arrow[0], y + by * arrow[1]], false);
    say(words.placeMoved(...texts(place)));
  });

  return {
    get place() {
      return place;
    },
    reset() {
      place = first;
    },
    /** Shows the handle where the place is. */
    render() {
      const here = ground();
      if (!place || !here) return;
      const [x, y] = toScreen(here.view, surface.size(), place).map((each) => Math.round(each * surface.zoom));
      handle.style.transform = `translate(${x}px, ${y}px)`;
      attribute(handle, "aria-label", words.place(...texts(place)));
    },
  };
}
