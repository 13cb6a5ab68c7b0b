/**
 * A first problem on a body of the person's own: the two ends of its longest extent are held at two materials, and nothing flows through the rest. The
 * section runs along that extent.
 *
 * @import { Bounds, Vector } from "../space/vector.js"
 * @import { Boundary, Group, LaboratoryDocument, Model, Solver } from "./document.js"
 * @import { Soup } from "./mesh.js"
 * @import { Section } from "./section-state.js"
 */
import { cutOf } from "../space/plane.js";
import { AXES } from "../space/section.js";
import { middleOf, scaled, subtract } from "../space/vector.js";
import { written } from "./box-edit.js";
import { MOST } from "./document.js";
import { insulated, pure, solverOf } from "./edits.js";
import { boundsOf, centreOf, countOf, soupOf } from "./mesh.js";
import { through } from "./section-state.js";
import { words } from "./words.js";

/** How deep each end is, as a share of the longest extent, and how far its box reaches beyond the body. */
const DEPTH = 0.1;
const BEYOND = 0.02;
/** Places that a section is tried at, from a third of the body to two thirds, and stations along the longest extent at which its width is taken. */
const TRIES = 17;
const STATIONS = 60;
/** The share of the greatest width that is as good, and how much wider the plane seen less well from the corner has to be. */
const AS_WIDE = 0.9;
const WIDER = 1.5;

/** @typedef {0 | 1 | 2} Axis */

const UNITS = [AXES.x, AXES.y, AXES.z];
/** Axes that a plane can stand across, first the one that is seen best from the corner. @type {readonly Axis[]} */
const ACROSS = [1, 0, 2];

/** The axes from the longest extent to the shortest; of equal ones the height comes first. @param {Bounds} bounds @param {2 | 3} dimension @returns {Axis[]} */
function axesOf({ min, max }, dimension) {
  const size = subtract(max, min);
  const axes = /** @type {Axis[]} */ (dimension === 3 ? [2, 0, 1] : [1, 0]);
  return axes.sort((a, b) => size[b] - size[a]);
}

/**
 * How far the two ends along an axis reach into the body, so that each holds the middle of an element.
 * @param {Boundary} boundary
 * @param {Axis} axis
 * @param {Bounds} bounds
 * @returns {[number, number] | null} null where the middles of all elements lie side by side
 */
function endsAlong(boundary, axis, bounds) {
  let [low, high] = [Infinity, -Infinity];
  for (let element = 0; element < countOf(boundary); element += 1) {
    const place = centreOf(boundary, element)[axis];
    low = Math.min(low, place);
    high = Math.max(high, place);
  }
  const span = high - low;
  if (!(span > 0)) return null;
  const deep = DEPTH * (bounds.max[axis] - bounds.min[axis]);
  // Of few elements the outermost lie deeper, and never are both ends one.
  const [middle, within] = [(low + high) / 2, DEPTH * span];
  const ends = [Math.min(middle - within, Math.max(low + within, bounds.min[axis] + deep)), Math.max(middle + within, Math.min(high - within, bounds.max[axis] - deep))];
  return /** @type {[number, number]} */ (span > deep ? ends.map((place) => written(place, bounds)) : ends);
}

/**
 * A box at one end of a body.
 * @param {Bounds} bounds
 * @param {Axis} axis
 * @param {"min" | "max"} end
 * @param {number} depth the coordinate that it reaches into the body
 * @param {2 | 3} dimension
 * @returns {number[][]}
 */
function boxAt(bounds, axis, end, depth, dimension) {
  const room = BEYOND * Math.max(...subtract(bounds.max, bounds.min));
  const [min, max] = [bounds.min.map((value) => written(value - room, bounds)), bounds.max.map((value) => written(value + room, bounds))];
  (end === "min" ? max : min)[axis] = depth;
  return [min.slice(0, dimension), max.slice(0, dimension)];
}

/** The solver as it is, unless it does not take so many elements. @param {LaboratoryDocument} document @param {number} count @returns {Solver} */
function solverFor(document, count) {
  const { method, preconditioner } = solverOf(document);
  if (method === "lu") return count > MOST.lu ? {} : document.solver;
  return preconditioner === "ssor" && count > MOST.ssor ? { ...withoutOmega(document.solver), preconditioner: "jacobi" } : document.solver;
}

/** @param {Solver} solver @returns {Solver} */
function withoutOmega({ omega: _omega, ...rest }) {
  return rest;
}

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

/**
 * @param {LaboratoryDocument} document whose materials, unit and solver stay
 * @param {Model} model the body
 * @param {Boundary} boundary of it, with whatever conditions
 * @param {string} title
 * @returns {{document: LaboratoryDocument, told: string}} with what was given, in words
 */
export function firstProblem(document, model, boundary, title) {
  const bounds = boundsOf(boundary);
  const { dimension } = boundary;
  const axes = axesOf(bounds, dimension);
  const { section: _section, rest: _rest, ...kept } = document;
  const solver = solverFor(document, countOf(boundary));
  const whole = { ...kept, title, model, solver, ...(dimension === 3 ? { section: sectionAlong(boundary, bounds, axes[0]) } : {}) };
  const along = axes.find((axis) => endsAlong(boundary, axis, bounds));
  const ends = along === undefined ? null : endsAlong(boundary, along, bounds);
  if (along === undefined || !ends) return { document: { ...whole, groups: [], rest: pure(document, 0) }, told: words.first.one(document.materials[0].name) };
  /** @type {Group[]} */
  const groups = /** @type {const} */ (["min", "max"]).map((end, k) => ({ name: words.first.ends[dimension === 2 && along === 1 ? 2 : along][k], where: { box: boxAt(bounds, along, end, ends[k], dimension) }, condition: pure(document, k) }));
  return {
    document: { ...whole, groups, rest: insulated(document) },
    told: words.first.two(groups.map(({ name }, k) => [document.materials[k].name, name])),
  };
}
