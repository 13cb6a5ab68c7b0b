/**
 * What is drawn: the shape that points make, and the document with it.
 *
 * @import { PartShape } from "../../../../js/directrix.js"
 * @import { Point } from "../../types.js"
 * @import { WholePart } from "../document.js"
 *
 * @typedef {"polygon" | "circle" | "closed" | "point" | "segment" | "line" | "polyline" | "open"} Drawn
 * @typedef {"reference" | "body" | "hole"} Purpose
 */
import { isInside } from "../../import/choose.js";
import { openCurveThrough } from "../../state/through-open.js";
import { curveThrough } from "../../state/through.js";
import { addBody, addShape, freshName, makeHole, MOST_BODIES, MOST_HOLES, shapeNames, shapeOf, whyNotAdd } from "../edits/shapes.js";
import { chainOf, directionAt, keptPoint, kept, middleOf } from "./geometry.js";

/** Of each kind the fewest points, the most after which it is finished, and whether it closes. @type {{[drawn in Drawn]: {fewest: number, most: number, closes: boolean}}} */
export const NEEDS = {
  polygon: { fewest: 3, most: Infinity, closes: true },
  circle: { fewest: 2, most: 2, closes: true },
  closed: { fewest: 3, most: Infinity, closes: true },
  point: { fewest: 1, most: 1, closes: false },
  segment: { fewest: 2, most: 2, closes: false },
  line: { fewest: 2, most: 2, closes: false },
  polyline: { fewest: 2, most: Infinity, closes: false },
  open: { fewest: 2, most: Infinity, closes: false },
};

/** Decimals of the angle of a line that is drawn. */
const DECIMALS = 1;

/** Whether a chain of points is set, rather than one or two. @param {Drawn} drawn */
export const isChain = (drawn) => NEEDS[drawn].most === Infinity;

/** Whether a stroke can stand for the points. @param {Drawn} drawn */
export const isCurved = (drawn) => drawn === "closed" || drawn === "open";

/**
 * The shape that points make; null where they make none.
 * @param {Drawn} drawn
 * @param {readonly Point[]} points
 * @returns {PartShape | null}
 */
export function shapeFrom(drawn, points) {
  if (points.length < NEEDS[drawn].fewest) return null;
  const [a, b = a] = points;
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  switch (drawn) {
    case "point":
      return { kind: "point", at: a };
    case "line": {
      if (dx === 0 && dy === 0) return null;
      const angle = (Math.atan2(dy, dx) * 180) / Math.PI;
      return { kind: "line", through: a, direction: directionAt(Number(angle.toFixed(DECIMALS))) };
    }
    case "segment":
      return dx === 0 && dy === 0 ? null : { kind: "segment", from: a, to: b };
    case "circle":
      return dx === 0 && dy === 0 ? null : { kind: "circle", center: a, radius: kept(Math.hypot(dx, dy)) };
    case "polygon":
    case "polyline":
      return { kind: drawn, points: [...points] };
    default: {
      const curve = (drawn === "closed" ? curveThrough : openCurveThrough)(points);
      return curve && { kind: "curve", ...curve, points: curve.points.map(keptPoint) };
    }
  }
}

/** What a name begins with. @type {{[drawn in Drawn]: string}} */
const NAMES = { polygon: "polygon", circle: "circle", closed: "curve", point: "point", segment: "segment", line: "line", polyline: "polyline", open: "curve" };

/**
 * The body that a hole is cut out of: the chosen one, else the uppermost that has the middle of the hole, else the uppermost.
 * @param {WholePart} document
 * @param {number | null} chosen
 * @param {PartShape} shape
 * @returns {number | null}
 */
export function bodyFor(document, chosen, shape) {
  if (chosen !== null && document.bodies[chosen]) return chosen;
  if (document.bodies.length === 0) return null;
  const at = middleOf(shape);
  const inside = document.bodies.findLastIndex(({ outline }) => {
    const around = shapeOf(document, outline);
    if (!around) return false;
    return around.kind === "circle" ? Math.hypot(at[0] - around.center[0], at[1] - around.center[1]) <= around.radius : isInside(chainOf(around), at);
  });
  return inside >= 0 ? inside : document.bodies.length - 1;
}

/**
 * Why something cannot be drawn, as the name of a word, or null.
 * @param {WholePart} document
 * @param {PartShape} shape
 * @param {Purpose} purpose
 * @param {number | null} body that a hole is cut out of
 * @returns {"mostShapes" | "mostPoints" | "mostBodies" | "mostHoles" | "noBody" | null}
 */
export function whyNotPut(document, shape, purpose, body) {
  const why = whyNotAdd(document, [shape]);
  if (why) return why === "shapes" ? "mostShapes" : "mostPoints";
  if (purpose === "body") return document.bodies.length >= MOST_BODIES ? "mostBodies" : null;
  if (purpose === "reference") return null;
  if (body === null) return "noBody";
  return (document.bodies[body].holes?.length ?? 0) >= MOST_HOLES ? "mostHoles" : null;
}

/**
 * A name for what is drawn.
 * @param {WholePart} document
 * @param {Drawn} drawn
 * @param {Purpose} purpose
 */
export const nameFor = (document, drawn, purpose) => freshName(shapeNames(document), purpose === "hole" ? "hole" : NAMES[drawn], 1);

/**
 * The document with a new shape, as what it is for.
 * @param {WholePart} document
 * @param {string} name
 * @param {PartShape} shape
 * @param {Purpose} purpose
 * @param {number | null} body
 */
export function put(document, name, shape, purpose, body) {
  const named = { ...shape, name };
  if (purpose === "body") return addBody(document, named, freshName(document.bodies.map((each) => each.name), "body", 1));
  const added = addShape(document, named);
  return purpose === "hole" && body !== null ? makeHole(added, body, name) : added;
}
