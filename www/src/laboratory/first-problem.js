/**
 * A first problem on a body of the person's own: the two ends of its longest extent are held at two materials, and nothing flows through the rest. The
 * section runs along that extent, where the body fills it best.
 *
 * @import { Bounds, Vector } from "../space/vector.js"
 * @import { Boundary, Group, LaboratoryDocument, Model, Solver } from "./document.js"
 * @import { Section } from "./section-state.js"
 */
import { cutOf } from "../space/plane.js";
import { AXES } from "../space/section.js";
import { middleOf, subtract } from "../space/vector.js";
import { written } from "./box-edit.js";
import { MOST } from "./document.js";
import { insulated, pure, solverOf } from "./edits.js";
import { boundsOf, centreOf, countOf, soupOf } from "./mesh.js";
import { through } from "./section-state.js";
import { words } from "./words.js";

/** How deep each end is, as a share of the longest extent, and how far its box reaches beyond the body. */
const DEPTH = 0.1;
const BEYOND = 0.02;
/** Places that a section is tried at, from a third of the body to two thirds, and stations along the longest extent that it should reach. */
const TRIES = 33;
const STATIONS = 64;
/** Stations that a section may miss and still be as good as the best. */
const AS_GOOD = 1;

/** @typedef {0 | 1 | 2} Axis */

/** The axes from the longest extent to the shortest; of equal ones the height comes first. @param {Bounds} bounds @returns {Axis[]} */
function axesOf({ min, max }) {
  const size = subtract(max, min);
  return /** @type {Axis[]} */ ([2, 0, 1]).sort((a, b) => size[b] - size[a]);
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
 * @returns {number[][]}
 */
function boxAt(bounds, axis, end, depth) {
  const room = BEYOND * Math.max(...subtract(bounds.max, bounds.min));
  const [min, max] = [bounds.min.map((value) => written(value - room, bounds)), bounds.max.map((value) => written(value + room, bounds))];
  (end === "min" ? max : min)[axis] = depth;
  return [min, max];
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
 * A plane along the longest extent, at the place nearest to the middle where it reaches as much of that extent as it can: the shaft of a bent body may
 * pass by its middle.
 * @param {Boundary} boundary
 * @param {Bounds} bounds
 * @param {Axis} along the axis of the longest extent
 * @returns {Section}
 */
export function sectionAlong(boundary, bounds, along) {
  const across = along === 1 ? 0 : 1;
  const normal = across === 1 ? AXES.y : /** @type {Vector} */ ([-1, 0, 0]);
  const middle = middleOf(bounds);
  const soup = soupOf(boundary);
  const nothing = new Float32Array(soup.positions.length);
  const [low, size] = [bounds.min[along], bounds.max[along] - bounds.min[along]];
  const station = (/** @type {number} */ place) => Math.min(STATIONS - 1, Math.max(0, Math.floor((STATIONS * (place - low)) / size)));
  const tries = Array.from({ length: TRIES }, (_, k) => {
    const share = 1 / 3 + k / (3 * (TRIES - 1));
    const place = bounds.min[across] + share * (bounds.max[across] - bounds.min[across]);
    const { positions } = cutOf(soup, { normal, offset: normal[across] * place }, nothing);
    const met = new Uint8Array(STATIONS);
    for (let n = 0; n < positions.length; n += 6) {
      const ends = [station(positions[n + along]), station(positions[n + 3 + along])];
      met.fill(1, Math.min(...ends), Math.max(...ends) + 1);
    }
    return { place, off: Math.abs(share - 0.5), met: met.reduce((sum, each) => sum + each, 0) };
  });
  const best = Math.max(...tries.map(({ met }) => met));
  const chosen = tries.filter(({ met }) => met >= best - AS_GOOD).sort((a, b) => a.off - b.off)[0];
  const place = chosen.off < 1e-9 ? middle[across] : written(chosen.place, bounds);
  return through(normal, /** @type {Vector} */ (middle.map((value, axis) => (axis === across ? place : value))));
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
  const axes = axesOf(bounds);
  const { section: _section, rest: _rest, ...kept } = document;
  const solver = solverFor(document, countOf(boundary));
  const whole = { ...kept, title, model, solver, section: sectionAlong(boundary, bounds, axes[0]) };
  const along = axes.find((axis) => endsAlong(boundary, axis, bounds));
  const ends = along === undefined ? null : endsAlong(boundary, along, bounds);
  if (along === undefined || !ends) return { document: { ...whole, groups: [], rest: pure(document, 0) }, told: words.first.one(document.materials[0].name) };
  /** @type {Group[]} */
  const groups = /** @type {const} */ (["min", "max"]).map((end, k) => ({ name: words.first.ends[along][k], where: { box: boxAt(bounds, along, end, ends[k]) }, condition: pure(document, k) }));
  return {
    document: { ...whole, groups, rest: insulated(document) },
    told: words.first.two(groups.map(({ name }, k) => [document.materials[k].name, name])),
  };
}
