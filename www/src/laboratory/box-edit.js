/**
 * The box by which a group picks elements, as its handles move it.
 *
 * @import { Side } from "../space/box-mark.js"
 * @import { Bounds, Vector } from "../space/vector.js"
 */
import { subtract } from "../space/vector.js";

/** How far a box is drawn and moved beyond the body, as a share of its longest side. */
const ROOM = 0.05;
/** A step of a side by keys, as a share of the body along its axis. */
const STEP = 0.01;
/** Places that are written for each power of ten of the longest side of the body. */
const PLACES = 1000;

/** @param {Bounds} bounds */
const longest = ({ min, max }) => Math.max(...subtract(max, min));

/** Where sides of boxes can be moved to. @param {Bounds} bounds of the body @returns {Bounds} */
export function reachOf(bounds) {
  const room = ROOM * longest(bounds);
  return { min: /** @type {Vector} */ (bounds.min.map((value) => value - room)), max: /** @type {Vector} */ (bounds.max.map((value) => value + room)) };
}

/** A number with no more digits than a person sees a difference by. @param {number} value @param {Bounds} bounds of the body */
export function written(value, bounds) {
  const power = powerOf(bounds);
  return neat(Math.round(value * power) / power);
}

/** Places for a unit of length. @param {Bounds} bounds */
const powerOf = (bounds) => PLACES / 10 ** Math.floor(Math.log10(longest(bounds)));

/** Without what rounding leaves, and never a negative zero. @param {number} value */
const neat = (value) => Number(value.toPrecision(12)) + 0;

/** A box round a body whose coordinates are written shortly. @param {Bounds} bounds @returns {[Vector, Vector]} */
export function boxRound(bounds) {
  const power = powerOf(bounds);
  const rounded = (/** @type {Vector} */ corner, /** @type {(value: number) => number} */ round) => /** @type {Vector} */ (corner.map((value) => neat(round(Number((value * power).toPrecision(12))) / power)));
  return [rounded(bounds.min, Math.floor), rounded(bounds.max, Math.ceil)];
}

/** Decimals by which places of a body are told apart. @param {Bounds} bounds of the body @param {number} [digits] of a body as long as a unit @param {number} [least] */
export const decimalsOf = (bounds, digits = 2, least = 2) => Math.max(least, digits - Math.floor(Math.log10(longest(bounds))));

/** Two opposite corners as the least and the greatest coordinates. @param {readonly number[][]} box @returns {Bounds} */
const sorted = ([a, b]) => ({
  min: /** @type {Vector} */ (a.map((value, axis) => Math.min(value, b[axis]))),
  max: /** @type {Vector} */ (a.map((value, axis) => Math.max(value, b[axis]))),
});

/**
 * A box as it is drawn: sides far beyond the body stand just outside of it.
 * @param {readonly number[][]} box two opposite corners
 * @param {Bounds} bounds of the body
 * @returns {Bounds}
 */
export function drawnBox(box, bounds) {
  const { min, max } = sorted(box);
  const reach = reachOf(bounds);
  const kept = (/** @type {Vector} */ corner) => /** @type {Vector} */ (corner.map((value, axis) => Math.min(reach.max[axis], Math.max(reach.min[axis], value))));
  return { min: kept(min), max: kept(max) };
}

/** The ends of the way of a side: the other side, and just outside of the body. @param {readonly number[][]} box @param {Side} side @param {Bounds} bounds @returns {[number, number]} */
export function wayOf(box, { axis, end }, bounds) {
  const [drawn, reach] = [drawnBox(box, bounds), reachOf(bounds)];
  return end === "min" ? [reach.min[axis], drawn.max[axis]] : [drawn.min[axis], reach.max[axis]];
}

/**
 * A box with one side elsewhere on its way; its other sides stay as they were written.
 * @param {readonly number[][]} box two opposite corners
 * @param {Side} side
 * @param {number} place
 * @param {Bounds} bounds of the body
 * @returns {number[][]} the least and the greatest coordinates
 */
export function withSide(box, side, place, bounds) {
  const [low, high] = wayOf(box, side, bounds);
  const next = sorted(box);
  const { axis, end } = side;
  // At its ends it stands exactly there, however they are written.
  next[end][axis] = place <= low ? low : place >= high ? high : Math.min(high, Math.max(low, written(place, bounds)));
  return [next.min, next.max];
}

/** A box with one side moved by steps. @param {readonly number[][]} box @param {Side} side @param {number} steps @param {Bounds} bounds */
export function stepped(box, side, steps, bounds) {
  const { axis, end } = side;
  const step = STEP * (bounds.max[axis] - bounds.min[axis] || longest(bounds));
  const before = drawnBox(box, bounds)[end][axis];
  const [low, high] = wayOf(box, side, bounds);
  // Beyond the end of its way it stays where it is.
  if ((steps < 0 && before <= low) || (steps > 0 && before >= high)) return [sorted(box).min, sorted(box).max];
  return withSide(box, side, before + steps * step, bounds);
}

/** The place of a side as it is drawn. @param {readonly number[][]} box @param {Side} side @param {Bounds} bounds */
export const placeOfSide = (box, { axis, end }, bounds) => drawnBox(box, bounds)[end][axis];
