/**
 * The section of a problem in space: a plane that the document has, and how it is moved. The normal points to what is kept.
 *
 * @import { Plane } from "../space/plane.js"
 * @import { Vector } from "../space/vector.js"
 * @import { Soup } from "./mesh.js"
 *
 * @typedef {{origin: Vector, normal: Vector}} Section As in docs/format.md.
 * @typedef {"off" | "x" | "y" | "z" | "own"} Across The axis that the plane stands across.
 *
 * @typedef {object} FaceFrame The rectangle of the plane that holds the face.
 * @property {Vector} origin
 * @property {[Vector, Vector]} sides
 */
import { planeAxes } from "../space/cut.js";
import { extentAlong } from "../space/plane.js";
import { AXES } from "../space/section.js";
import { add, dot, scaled, unit } from "../space/vector.js";

/** How near the unit vectors a normal counts as one, as a share. */
const STRAIGHT = 1e-9;
/** Digits of coordinates that are written. */
const DIGITS = 9;

/** @param {Vector} vector @returns {Vector} */
const tidy = (vector) => /** @type {Vector} */ (vector.map((value) => Number(value.toPrecision(DIGITS)) + 0));

/** What the plane stands across. @param {Section | undefined} section @returns {Across} */
export function acrossOf(section) {
  if (!section) return "off";
  const normal = unit(section.normal);
  return /** @type {const} */ (["x", "y", "z"]).find((axis) => Math.abs(Math.abs(dot(normal, AXES[axis])) - 1) < STRAIGHT) ?? "own";
}

/** The plane with a normal of length 1. @param {Section} section @returns {Plane} */
export function planeOf({ origin, normal }) {
  const along = unit(normal);
  return { normal: along, offset: dot(along, origin) };
}

/** The direction along which the place of the plane counts: the axis it stands across, or its own normal. @param {Section} section @returns {Vector} */
function wayOf(section) {
  const across = acrossOf(section);
  return across === "off" || across === "own" ? unit(section.normal) : AXES[across];
}

/** Where the plane stands on its way, in units of the body. @param {Section} section */
export const placeOf = (section) => dot(wayOf(section), section.origin);

/** The ends of the way of a plane through a body. @param {Section} section @param {ArrayLike<number>} positions @returns {[number, number]} */
export const extentOf = (section, positions) => extentAlong(wayOf(section), positions);

/**
 * The plane at another place of its way, within the body.
 * @param {Section} section
 * @param {number} place
 * @param {[number, number]} extent
 * @returns {Section}
 */
export function placed(section, place, [low, high]) {
  const way = wayOf(section);
  const by = Math.min(high, Math.max(low, place)) - placeOf(section);
  return { ...section, origin: tidy(add(section.origin, scaled(way, by))) };
}

/**
 * A plane through the middle of a body.
 * @param {Vector} normal towards what is kept
 * @param {Vector} middle
 * @returns {Section}
 */
export const through = (normal, middle) => ({ origin: tidy(middle), normal: tidy(unit(normal)) });

/** The same plane, with the other side kept. @param {Section} section @returns {Section} */
export const flipped = ({ origin, normal }) => ({ origin, normal: tidy(scaled(normal, -1)) });

/**
 * The rectangle of a plane that a body can reach, so that its face lies within.
 * @param {Plane} plane
 * @param {Soup["positions"]} positions
 * @returns {FaceFrame}
 */
export function faceFrame({ normal, offset }, positions) {
  const axes = planeAxes(normal);
  const [across, up] = axes.map((axis) => extentAlong(axis, positions));
  const foot = scaled(normal, offset);
  return {
    origin: add(foot, add(scaled(axes[0], across[0]), scaled(axes[1], up[0]))),
    sides: [scaled(axes[0], across[1] - across[0]), scaled(axes[1], up[1] - up[0])],
  };
}

/**
 * Pixels along the sides of a rectangle, square or nearly so.
 * @param {readonly [ArrayLike<number>, ArrayLike<number>]} sides
 * @param {number} longest
 * @returns {[number, number]}
 */
export function pixelsOf(sides, longest) {
  const lengths = sides.map((side) => Math.hypot(...Array.from(side)));
  const pixel = Math.max(...lengths) / longest;
  return /** @type {[number, number]} */ (lengths.map((length) => Math.min(longest, Math.max(1, Math.round(length / pixel)))));
}
