/**
 * The shapes of a part as they lie in a figure. Pure functions.
 *
 * @import { PartDocument, Point } from "../../../js/directrix.js"
 * @import { NamedShape } from "../part/shapes/geometry.js"
 *
 * @typedef {{seen: (at: Point) => Point, scale: number}} Ground where places lie on the screen, and CSS pixels a unit
 */
import { circle, dot, polyline, roundOf } from "./path.js";

/** The shapes that features refer to by name. @param {PartDocument} document @returns {NamedShape[]} */
export function referredTo({ bodies, shapes = [] }) {
  const names = new Set(bodies.flatMap(({ features = [] }) => features.flatMap(({ reference, references = {} }) => [reference, ...Object.values(references)])));
  return shapes.filter(({ name }) => names.has(name));
}

/** Path data of a shape; nothing of one that has no end. @param {NamedShape} shape @param {Ground} ground */
export function pathOf(shape, { seen, scale }) {
  switch (shape.kind) {
    case "point":
      return dot(seen(shape.at));
    case "circle":
      return circle(seen(shape.center), shape.radius * scale);
    case "polygon":
      return `${polyline(shape.points.map(seen))}Z`;
    default: {
      const line = lineOf(shape, { seen, scale });
      return line.length > 0 ? polyline(line) : "";
    }
  }
}

/** A shape as a line of points on the screen; none of a point, and of what has no end. @param {NamedShape} shape @param {Ground} ground @returns {Point[]} */
export function lineOf(shape, { seen, scale }) {
  switch (shape.kind) {
    case "segment":
      return [seen(shape.from), seen(shape.to)];
    case "polyline":
      return shape.points.map(seen);
    case "polygon":
      return [...shape.points, ...shape.points.slice(0, 1)].map(seen);
    case "circle":
      return roundOf(seen(shape.center), shape.radius * scale);
    default:
      return [];
  }
}
