/**
 * A section that shows much of a body: along its longest extent, near its middle, and with its bend where it is bent.
 *
 * @import { Bounds, Vector } from "../space/vector.js"
 * @import { Boundary } from "./document.js"
 * @import { Soup } from "./mesh.js"
 * @import { Section } from "./section-state.js"
 *
 * @typedef {0 | 1 | 2} Axis
 */
import { cutOf } from "../space/plane.js";
import { AXES } from "../space/section.js";
import { middleOf, scaled } from "../space/vector.js";
import { written } from "./box-edit.js";
import { soupOf } from "./mesh.js";
import { through } from "./section-state.js";

/** Places that a section is tried at, from a third of the body to two thirds, and stations along the longest extent at which its width is taken. */
const TRIES = 17;
const STATIONS = 60;
/** The share of the greatest width that is as good, and how much wider the plane seen less well from the corner has to be. */
const AS_WIDE = 0.9;
const WIDER = 1.5;

const UNITS = [AXES.x, AXES.y, AXES.z];
/** Axes that a plane can stand across, first the one that is seen best from the corner. @type {readonly Axis[]} */
const ACROSS = [1, 0, 2];

/**
 * How much a plane shows of a body: its outline has a width at stations along the longest extent, and a tenth of them may be narrower than what is told.
 * @param {Soup} soup
 * @param {Bounds} bounds
 * @param {Axis} along the longest extent
 * @param {Axis} across the plane
 * @param {number} place of the plane
 */
function widthAt(soup, bounds, along, across, place) {
  const { positions } = cutOf(soup, { normal: UNITS[across], offset: place }, new Float32Array(soup.positions.length));
  const other = 3 - along - across;
  const [low, size] = [bounds.min[along], bounds.max[along] - bounds.min[along]];
  const stationOf = (/** @type {number} */ at) => (STATIONS * (at - low)) / size - 0.5;
  const [least, most] = [new Array(STATIONS).fill(Infinity), new Array(STATIONS).fill(-Infinity)];
  for (let n = 0; n < positions.length; n += 6) {
    const [a, b] = [stationOf(positions[n + along]), stationOf(positions[n + 3 + along])];
    const [from, to] = [positions[n + other], positions[n + 3 + other]];
    for (let k = Math.max(0, Math.ceil(Math.min(a, b))); k <= Math.min(STATIONS - 1, Math.max(a, b)); k += 1) {
      const at = a === b ? from : from + ((k - a) / (b - a)) * (to - from);
      least[k] = Math.min(least[k], at);
      most[k] = Math.max(most[k], at);
    }
  }
  const widths = most.map((value, k) => Math.max(0, value - least[k])).sort((a, b) => a - b);
  return widths[Math.floor(STATIONS / 10)];
}

/**
 * A plane along the longest extent, near the middle of the body; where the body bends away from its middle, where it is seen at its widest.
 * @param {Boundary} boundary
 * @param {Bounds} bounds
 * @param {Axis} along the axis of the longest extent
 * @returns {Section}
 */
export function sectionAlong(boundary, bounds, along) {
  const soup = soupOf(boundary);
  const middle = middleOf(bounds);
  const planes = ACROSS.filter((axis) => axis !== along).map((across) => {
    const tries = Array.from({ length: TRIES }, (_, k) => {
      const off = (k / (TRIES - 1) - 0.5) / 3;
      const place = middle[across] + off * (bounds.max[across] - bounds.min[across]);
      return { off: Math.abs(off), place, width: widthAt(soup, bounds, along, across, place) };
    });
    const widest = Math.max(...tries.map(({ width }) => width));
    const [{ off, place, width }] = tries.filter((each) => each.width >= AS_WIDE * widest).sort((a, b) => a.off - b.off);
    return { across, width, place: off < 1e-9 ? place : written(place, bounds) };
  });
  const [first, second] = planes;
  const { across, place } = second.width > WIDER * first.width ? second : first;
  return through(across === 1 ? AXES.y : scaled(UNITS[across], -1), /** @type {Vector} */ (middle.map((value, axis) => (axis === across ? place : value))));
}
