/**
 * The handle of a coefficient: dragged across the view, and moved by arrow keys.
 *
 * @import { BodyDocument } from "../hyperpatch/document.js"
 * @import { Vector } from "../space/vector.js"
 * @import { Point } from "../types.js"
 *
 * @typedef {{document: BodyDocument, position: Vector}} Start where a displacement starts
 */
import { stride } from "../controls/arrows.js";
import { add, scaled } from "../space/vector.js";

/** Digits of a coordinate that was dragged, and of one that was moved by keys. */
const DIGITS = 3;
const ALL_DIGITS = 9;

/** @type {{[key: string]: Vector}} */
const ARROWS = { ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, 0, 1], ArrowDown: [0, 0, -1] };

/** @param {readonly number[]} position @param {number} digits */
const rounded = (position, digits) => position.map((each) => Number(each.toFixed(digits)) + 0);

/**
 * @param {HTMLElement} handle
 * @param {object} acts
 * @param {(isAdded?: boolean) => Start | null} acts.start
 * @param {(position: Vector, by: Point) => Vector} acts.dragged by so many CSS pixels
 * @param {() => number} acts.nudge step of a key
 * @param {(event: PointerEvent) => Point} acts.placeOf
 * @param {(to: readonly number[], from: Start) => void} acts.put
 * @param {() => void} acts.rest
 * @param {(position: readonly number[]) => void} acts.say
 */
export function moveByHand(handle, { start, dragged, nudge, placeOf, put, rest, say }) {
  /** @type {(Start & {at: Point}) | null} */
  let grabbed = null;
  handle.addEventListener("pointerdown", (event) => {
    const from = start();
    if (event.button !== 0 || !from) return;
    event.preventDefault();
    handle.focus({ preventScroll: true });
    handle.setPointerCapture(event.pointerId);
    grabbed = { at: placeOf(event), ...from };
  });
  handle.addEventListener("pointermove", (event) => {
    if (!grabbed) return;
    const [x, y] = placeOf(event);
    put(rounded(dragged(grabbed.position, [x - grabbed.at[0], y - grabbed.at[1]]), DIGITS), grabbed);
  });
  for (const type of /** @type {const} */ (["pointerup", "pointercancel"])) {
    handle.addEventListener(type, () => {
      grabbed = null;
      rest();
    });
  }
  handle.addEventListener("keydown", (event) => {
    const arrow = ARROWS[event.key];
    const from = start(true);
    if (!arrow || !from || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    const by = nudge() * stride(event);
    const to = rounded(add(from.position, scaled(arrow, by)), ALL_DIGITS);
    put(to, from);
    say(to);
  });
}
