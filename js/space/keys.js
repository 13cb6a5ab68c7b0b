/**
 * The camera by keys.
 *
 * @import { StandardView } from "./camera.js"
 *
 * @typedef {{turn: [number, number]} | {pan: [number, number]} | {zoom: number} | {fit: true} | {view: StandardView}} Move
 */

/** Degrees, CSS pixels and the factor of one press. */
const TURN = 5;
const PAN = 24;
const ZOOM = 1.25;

/** @type {Readonly<{[key: string]: [number, number]}>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** @type {Readonly<{[key: string]: StandardView}>} */
const VIEWS = { 5: "iso", 6: "front", 7: "side", 8: "top" };

/** The key of a standard view. @param {StandardView} view */
export const keyOf = (view) => Object.keys(VIEWS).find((key) => VIEWS[key] === view) ?? "";

/**
 * What a key does to the camera. Arrows only count on the picture itself.
 * @param {Pick<KeyboardEvent, "key" | "shiftKey" | "altKey">} event
 * @param {boolean} isOnPicture
 * @returns {Move | null}
 */
export function moveOf({ key, shiftKey, altKey }, isOnPicture) {
  const arrow = isOnPicture ? ARROWS[key] : undefined;
  if (arrow && shiftKey) return { pan: [arrow[0] * PAN, -arrow[1] * PAN] };
  if (arrow) {
    const by = altKey ? TURN / 10 : TURN;
    return { turn: [arrow[0] * by, arrow[1] * by] };
  }
  if (altKey) return null;
  if (key === "+" || key === "=") return { zoom: ZOOM };
  if (key === "-") return { zoom: 1 / ZOOM };
  if (key === "f" || key === "F") return { fit: true };
  return VIEWS[key] ? { view: VIEWS[key] } : null;
}
