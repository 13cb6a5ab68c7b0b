/**
 * Shapes from elsewhere in a part: as reference geometry, as holes of a body, or as bodies, of which those that lie in others are their holes.
 *
 * @import { PartShape } from "../../../../js/directrix.js"
 * @import { WholePart } from "../document.js"
 * @import { Purpose } from "../shapes/drawing.js"
 * @import { NamedShape } from "../shapes/geometry.js"
 */
import { isInside } from "../../import/choose.js";
import { areaOf, chainOf } from "../shapes/geometry.js";
import { addShape, freshName, LONGEST_NAME, makeBody, makeHole, shapeNames } from "./shapes.js";

/**
 * Names for shapes that come into a document, none of which another one has.
 * @param {WholePart} document
 * @param {readonly {name: string, shape: PartShape}[]} shapes
 * @returns {NamedShape[]}
 */
export function namedFor(document, shapes) {
  const taken = shapeNames(document);
  return shapes.map(({ name, shape }) => {
    const own = freshName(taken, name.trim().slice(0, LONGEST_NAME) || "shape");
    taken.push(own);
    return { ...shape, name: own };
  });
}

/**
 * For each of closed shapes the one that it lies in, by its index, and in how many.
 * @param {readonly PartShape[]} shapes
 * @returns {{depth: number, within: number | null}[]}
 */
export function nestingOf(shapes) {
  const chains = shapes.map((shape) => chainOf(shape));
  const areas = shapes.map(areaOf);
  return shapes.map((_, index) => {
    const around = shapes
      .map((_, other) => other)
      .filter((other) => areas[other] > areas[index] && isInside(chains[other], chains[index][0]))
      .sort((a, b) => areas[a] - areas[b]);
    return { depth: around.length, within: around[0] ?? null };
  });
}

/**
 * The document with closed shapes that have names of their own.
 * @param {WholePart} document
 * @param {readonly NamedShape[]} shapes
 * @param {Purpose} purpose
 * @param {number | null} body that holes are cut out of
 * @returns {WholePart}
 */
export function withImported(document, shapes, purpose, body) {
  const added = shapes.reduce(addShape, document);
  if (purpose === "reference") return added;
  if (purpose === "hole") return body === null ? added : shapes.reduce((now, { name }) => makeHole(now, body, name), added);
  const nesting = nestingOf(shapes);
  /** The body that each shape became. @type {Map<number, string>} */
  const made = new Map();
  let now = added;
  shapes.forEach(({ name }, index) => {
    if (nesting[index].depth % 2 !== 0) return;
    const own = freshName(now.bodies.map((each) => each.name), name);
    const next = makeBody(now, name, own);
    if (next !== now) made.set(index, own);
    now = next;
  });
  shapes.forEach(({ name }, index) => {
    const { depth, within } = nesting[index];
    const owner = depth % 2 !== 0 && within !== null ? made.get(within) : undefined;
    const at = now.bodies.findIndex((each) => each.name === owner);
    if (owner !== undefined && at >= 0) now = makeHole(now, at, name);
  });
  return now;
}
