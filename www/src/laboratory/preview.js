/**
 * Which elements a group has while its box is dragged, before the kernel has said so: those whose middle lies in the box and that face its direction.
 *
 * @import { Bench } from "./state.js"
 * @import { Boundary, Group, Where } from "./document.js"
 */
import { dot, unit } from "../space/vector.js";
import { ANGLE, isFormula } from "./edits.js";
import { centreOf, countOf, normalOf } from "./mesh.js";

/** How far an angle may be passed for rounding's sake, in its cosine, as in the kernel. */
const ROUNDING = 1e-12;

/**
 * Whether elements lie in a box and face a direction, where nothing else chooses them.
 * @param {Boundary} boundary
 * @param {Where} where
 * @returns {((element: number) => boolean) | null} null where the kernel alone can tell
 */
export function insideOf(boundary, { box, direction, angle = ANGLE, positive, elements }) {
  if (!box || positive !== undefined || elements) return null;
  const [low, high] = box;
  const way = direction && unit([direction[0], direction[1], direction[2] ?? 0]);
  const least = Math.cos((angle * Math.PI) / 180) - ROUNDING;
  return (element) => {
    const centre = centreOf(boundary, element);
    return low.every((value, axis) => centre[axis] >= value && centre[axis] <= high[axis]) && (!way || dot(normalOf(boundary, element), way) >= least);
  };
}

/**
 * A boundary with one group elsewhere.
 * @param {Boundary} boundary
 * @param {number} index of the group
 * @param {Group} group as it is to be
 * @param {number} rest index of the set of everything else
 * @returns {Boundary | null} null where the kernel alone can tell
 */
export function withElements(boundary, index, group, rest) {
  const isIn = insideOf(boundary, group.where);
  if (!isIn) return null;
  const { conditions } = boundary;
  const members = boundary.members.slice();
  // The condition of the group comes after the others; what has none has a number beyond all.
  const none = conditions.length + 1;
  const groups = boundary.groups.map((condition) => (condition < conditions.length ? condition : none));
  const former = (/** @type {number} */ set) => groups[boundary.members.indexOf(set)] ?? none;
  const [own, others] = [isFormula(group.condition) ? former(index) : conditions.length, former(rest)];
  for (let element = 0; element < countOf(boundary); element += 1) {
    const was = boundary.members[element] === index;
    const is = isIn(element);
    if (is) members[element] = index;
    else if (was) members[element] = rest;
    if (was !== is) groups[element] = is ? own : others;
  }
  return { ...boundary, groups, members, conditions: [...conditions, /** @type {any} */ (group.condition)] };
}

/** @param {Bench} bench */
export function createPreview(bench) {
  /** @type {{boundary: Boundary, group: Group, found: Boundary | null} | null} */
  let last = null;
  return {
    /** The boundary with the chosen group as it is dragged; null where the kernel has answered, or nothing is dragged. @returns {Boundary | null} */
    get boundary() {
      const { document, known, isCurrent, shown } = bench.now();
      const group = shown.group === null ? undefined : document.groups[shown.group];
      if (!known || isCurrent || shown.group === null || !group) return null;
      const { boundary } = known;
      const before = known.document.groups[shown.group];
      if (known.document.model !== document.model || known.document.groups.length !== document.groups.length || !before?.where.box || before.where === group.where) return null;
      if (last?.boundary !== boundary || last.group !== group) last = { boundary, group, found: withElements(boundary, shown.group, group, document.groups.length) };
      return last.found;
    },
    /** How many elements a group has then. @param {number} set */
    count(set) {
      const members = this.boundary?.members;
      return members ? members.reduce((sum, each) => sum + (each === set ? 1 : 0), 0) : null;
    },
  };
}
