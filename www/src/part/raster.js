/**
 * Which pixels of a part are evaluated: of the visible box as many as time allows, or of the whole part where a body needs voxels.
 *
 * @import { Point, Size, View } from "../types.js"
 * @import { WholePart } from "./document.js"
 *
 * @typedef {{box: [Point, Point], size: [number, number]}} Frame
 */
import { toPlane } from "../view.js";

/** Pixels evaluated while something moves, and the milliseconds that they should take at most, so that each frame can have its picture. */
const COARSE = { least: 16_000, first: 60_000, most: 160_000, ms: 12 };
/** Pixels evaluated at most when it rests. */
export const FINE = 2_400_000;
/** Pixels for the lines of equal fraction: the kernel takes about a million. */
export const LINES = 300_000;
/** Voxels along the longer side of a part with a body by the rule `printed`, while something moves and when it rests. */
export const VOXELS = { coarse: 160, fine: 500 };
/** Largest coordinate of a place that the kernel evaluates, in document units. */
const FAR = 1e9;
/** Pixels along the longer side of a part for its measures, where it needs no voxels. */
export const MEASURED = 1000;

/**
 * How many pixels can be evaluated while something moves.
 * @param {number | null} rate pixels for a millisecond, as far as is known
 */
export const coarsePixels = (rate) => (rate === null ? COARSE.first : Math.round(Math.min(COARSE.most, Math.max(COARSE.least, rate * COARSE.ms))));

/** Whether a body takes voxels, so that its composition depends on their number. @param {WholePart} document */
export const needsVoxels = ({ bodies }) => bodies.some(({ rule }) => rule === "printed");

/**
 * The pixels of what is seen, as far as the coordinates of a document go.
 * @param {View} view
 * @param {Size} size CSS pixels
 * @param {number} ratio device pixels for one of them
 * @param {number} most pixels
 * @returns {Frame | null} null where nothing of that is seen
 */
export function visibleFrame(view, size, ratio, most) {
  const share = Math.min(1, Math.sqrt(most / (size.width * size.height * ratio * ratio)));
  const within = (/** @type {number} */ value) => Math.min(FAR, Math.max(-FAR, value));
  const [lowest, highest] = [toPlane(view, size, [0, size.height]), toPlane(view, size, [size.width, 0])];
  const [left, low, right, top] = [...lowest, ...highest].map(within);
  if (!(left < right && low < top)) return null;
  const pixels = (/** @type {number} */ length, /** @type {number} */ part) => Math.max(1, Math.floor(length * ratio * share * part));
  return {
    box: [[left, low], [right, top]],
    size: [pixels(size.width, (right - left) / (highest[0] - lowest[0])), pixels(size.height, (top - low) / (highest[1] - lowest[1]))],
  };
}

/**
 * The whole of a part with nearly square pixels.
 * @param {[Point, Point]} box
 * @param {number} longer pixels along the longer side
 * @returns {Frame}
 */
export function wholeFrame(box, longer) {
  const [[left, low], [right, high]] = box;
  const [wide, tall] = [right - left, high - low];
  const scale = longer / Math.max(wide, tall);
  const pixels = (/** @type {number} */ length) => Math.max(1, Math.round(length * scale));
  return { box, size: [pixels(wide), pixels(tall)] };
}

/** Fewer pixels of the same box, at most so many. @param {Frame} frame @param {number} most @returns {Frame} */
export function thinned({ box, size: [wide, tall] }, most) {
  const share = Math.min(1, Math.sqrt(most / (wide * tall)));
  return { box, size: [Math.max(1, Math.floor(wide * share)), Math.max(1, Math.floor(tall * share))] };
}
