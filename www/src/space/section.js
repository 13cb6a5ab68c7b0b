/**
 * The section of a body: a plane across an axis or across the view, at a place of its way, and how it is moved.
 *
 * @import { Plane } from "./plane.js"
 * @import { PlaneMoves } from "./plane-mark.js"
 * @import { Vector } from "./vector.js"
 *
 * @typedef {"off" | "x" | "y" | "z" | "view"} SectionAxis
 *
 * @typedef {object} Section
 * @property {SectionAxis} axis that the plane stands across
 * @property {number} at its place on the way through the body, 0 to 1
 * @property {boolean} flipped whether the other side is taken away
 */
import { extentAlong } from "./plane.js";
import { scaled } from "./vector.js";

/** A step of the plane by keys, as a share of its way. */
const STEP = 0.01;

/** @type {Readonly<{[axis in "x" | "y" | "z"]: Vector}>} */
export const AXES = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

/**
 * The plane of a section; what its normal points to is kept.
 * @param {Section} section
 * @param {ArrayLike<number>} positions of the body
 * @param {Vector} back from the body to the eye
 * @returns {{plane: Plane, extent: [number, number]} | null} with the offsets at the two ends of its way
 */
export function sectionPlane({ axis, at, flipped }, positions, back) {
  if (axis === "off" || positions.length === 0) return null;
  // On the axes the side towards the viewer of the first view is taken away, across the view that towards the eye.
  const away = axis === "view" ? scaled(back, -1) : axis === "y" ? AXES.y : scaled(AXES[axis], -1);
  const normal = flipped ? scaled(away, -1) : away;
  const along = axis === "view" ? back : AXES[axis];
  const extent = extentAlong(along, positions);
  const offset = extent[0] + at * (extent[1] - extent[0]);
  const same = normal[0] * along[0] + normal[1] * along[1] + normal[2] * along[2] > 0;
  return { plane: { normal, offset: same ? offset : -offset }, extent };
}

/** Whether the normal of the plane points against its axis. @param {Section} section */
const isReversed = ({ axis, flipped }) => (axis !== "y") !== flipped;

/**
 * Where the plane stands: on its axis, or across the view from the middle of the body.
 * @param {number} at
 * @param {[number, number]} extent
 * @param {SectionAxis} axis
 */
export function placeOf(at, extent, axis) {
  return axis === "view" ? (at - 0.5) * (extent[1] - extent[0]) : extent[0] + at * (extent[1] - extent[0]);
}

/**
 * The inverse of `placeOf`, within the body.
 * @param {number} place
 * @param {[number, number]} extent
 * @param {SectionAxis} axis
 */
export function shareOf(place, [low, high], axis) {
  if (low === high) return 0.5;
  const from = axis === "view" ? (low - high) / 2 : low;
  return Math.min(1, Math.max(0, (place - from) / (high - low)));
}

/**
 * What moving the plane by its handle does to the section.
 * @param {object} of
 * @param {() => Section} of.read
 * @param {() => [number, number] | null} of.extent of the plane's way
 * @param {(section: Section) => void} of.write
 * @param {(axis: SectionAxis, place: number) => void} of.told says where it stands after a step
 * @returns {PlaneMoves}
 */
export function planeMoves({ read, extent, write, told }) {
  /** @type {{of: string, at: number} | null} */
  let drag = null;
  return {
    move(offset, run) {
      const section = read();
      const way = extent();
      if (!way) return;
      if (drag?.of !== run) drag = { of: run, at: section.at };
      write({ ...section, at: shareOf(isReversed(section) ? -offset : offset, way, section.axis) });
    },
    end() {
      drag = null;
    },
    undo(run) {
      if (drag?.of === run) write({ ...read(), at: drag.at });
      drag = null;
    },
    step(steps) {
      const section = read();
      const at = Math.min(1, Math.max(0, section.at + steps * STEP));
      write({ ...section, at });
      const way = extent();
      if (way) told(section.axis, placeOf(at, way, section.axis));
    },
  };
}
