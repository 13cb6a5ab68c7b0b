/**
 * A first problem on a body of the person's own: the two ends of its longest extent are held at two materials, and nothing flows through the rest. The
 * section runs along that extent.
 *
 * @import { Bounds } from "../space/vector.js"
 * @import { Boundary, Group, LaboratoryDocument, Model, Solver } from "./document.js"
 * @import { Axis } from "./section-along.js"
 */
import { subtract } from "../space/vector.js";
import { written } from "./box-edit.js";
import { MOST } from "./document.js";
import { insulated, pure, solverOf } from "./edits.js";
import { boundsOf, centreOf, countOf } from "./mesh.js";
import { sectionAlong } from "./section-along.js";
import { words } from "./words.js";

/** How deep each end is, as a share of the longest extent, and how far its box reaches beyond the body. */
const DEPTH = 0.1;
const BEYOND = 0.02;
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
  const [found] = axes.flatMap((axis) => {
    const ends = endsAlong(boundary, axis, bounds);
    return ends ? [{ along: axis, ends }] : [];
  });
  if (!found) return { document: { ...whole, groups: [], rest: pure(document, 0) }, told: words.first.one(document.materials[0].name) };
  const { along, ends } = found;
  /** @type {Group[]} */
  const groups = /** @type {const} */ (["min", "max"]).map((end, k) => ({ name: words.first.ends[dimension === 2 && along === 1 ? 2 : along][k], where: { box: boxAt(bounds, along, end, ends[k], dimension) }, condition: pure(document, k) }));
  return {
    document: { ...whole, groups, rest: insulated(document) },
    told: words.first.two(groups.map(({ name }, k) => [document.materials[k].name, name])),
  };
}
