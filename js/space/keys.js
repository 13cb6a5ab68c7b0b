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

/**
 * The unit vector that a key moves a point by: arrows along those of the axes x and y that lie nearest to them on the screen, away from the
 * camera for the one upwards; Home raises, End lowers.
 * @param {string} key
 * @param {number} azimuth of the camera, degrees
 * @returns {import("./vector.js").Vector | null}
 */
export function groundStep(key, azimuth) {
  if (key === "Home" || key === "End") return [0, 0, key === "Home" ? 1 : -1];
  const arrow = ARROWS[key];
  if (!arrow) return null;
  const angle = (azimuth * Math.PI) / 180;
  const [right, away] = [
    [-Math.sin(angle), Math.cos(angle)],
    [-Math.cos(angle), -Math.sin(angle)],
  ];
  const across = Math.abs(right[0]) >= Math.abs(right[1]) ? 0 : 1;
  /** @type {import("./vector.js").Vector} */
  const step = [0, 0, 0];
  if (arrow[0] !== 0) step[across] = Math.sign(right[across]) * arrow[0];
  else step[1 - across] = Math.sign(away[1 - across]) * arrow[1];
  return step;
}

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
