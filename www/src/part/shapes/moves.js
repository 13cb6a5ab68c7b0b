/**
 * Moving what is held: where it comes to rest, by how much a key moves it, and where it is, in words.
 *
 * @import { Point } from "../../types.js"
 * @import { WholePart } from "../document.js"
 * @import { Bench } from "../state.js"
 * @import { NamedShape } from "./geometry.js"
 * @import { Held } from "./places.js"
 */
import { coordinate, fixed } from "../../format.js";
import { snappedTo } from "../../stage/snap.js";
import { bodyShapes, moveShapes, placeHandle, setAngle, setRadius, shapeOf, shapesOf, withShapesOf } from "../edits/shapes.js";
import { aimed, gridStep } from "../../view.js";
import { angleOf, boxOf, isReach, middleOf, pointsOf } from "./geometry.js";
import { words } from "./words.js";

/** Pixels within which a point of another shape holds what is moved, with snapping. */
const NEAR = 8;
/** Degrees that a direction rests on with snapping, those of an arrow key, and the decimals it has without. */
const TURNS = 15;
const TURN = 1;
const DECIMALS = 1;

/** The step of the grid that counts now, or null. @param {Bench} bench @param {boolean} invert whether Control is held */
function stepNow(bench, invert) {
  const step = bench.step();
  if (!invert) return step;
  const { view } = bench.now();
  return step === null && view ? gridStep(view.scale) : null;
}

/**
 * Where a place that is aimed at comes to rest: with snapping on a point of another shape that is near, or on the grid; else on a decimal that can be aimed at.
 * @param {Bench} bench
 * @param {Point} at document units
 * @param {boolean} invert whether Control is held
 * @param {string | null} [own] name of the shape that the place belongs to
 * @returns {Point}
 */
export function rested(bench, at, invert, own = null) {
  const { document, view } = bench.now();
  const step = stepNow(bench, invert);
  if (step !== null) return (view && pointNear(document, at, NEAR / view.scale, own)) ?? snappedTo(at, step);
  return view ? [aimed(at[0], view), aimed(at[1], view)] : at;
}

/**
 * The point of a shape nearest to a place; null where none is near.
 * @param {WholePart} document
 * @param {Point} at
 * @param {number} reach document units
 * @param {string | null} own the shape whose points do not count
 * @returns {Point | null}
 */
function pointNear(document, [x, y], reach, own) {
  /** @type {Point | null} */
  let best = null;
  let least = reach;
  for (const shape of shapesOf(document)) {
    if (shape.name === own) continue;
    for (const point of pointsOf(shape)) {
      const distance = Math.hypot(point[0] - x, point[1] - y);
      if (distance <= least) [best, least] = [point, distance];
    }
  }
  return best;
}

/** A radius that is aimed at. @param {Bench} bench @param {number} radius @param {boolean} invert */
export function restedRadius(bench, radius, invert) {
  const step = stepNow(bench, invert);
  const { view } = bench.now();
  if (step !== null) return Math.max(step, snappedTo([radius, 0], step)[0]);
  const least = view ? 1 / view.scale : 0;
  return view ? Math.max(aimed(radius, view), aimed(least, view)) : radius;
}

/** An angle that is aimed at. @param {Bench} bench @param {number} degrees @param {boolean} invert */
export function restedAngle(bench, degrees, invert) {
  const turns = stepNow(bench, invert) === null ? 10 ** -DECIMALS : TURNS;
  return Number((Math.round(degrees / turns) * turns).toFixed(DECIMALS));
}

/** The angle from one place to another, degrees. @param {Point} from @param {Point} to */
const angleTo = (from, to) => (Math.atan2(to[1] - from[1], to[0] - from[0]) * 180) / Math.PI;

/** Whether the outline of a body takes its holes and references along, for as long as the page is open. */
export const along = { isOn: false };

/** Names of the shapes that move with a whole one. @param {WholePart} document @param {string} name */
export const movedWith = (document, name) => (along.isOn ? bodyShapes(document, name) : [name]);

/** Whether a handle moves the whole of its shape: the centre of a circle does. @param {NamedShape} shape @param {number} point */
const isMiddle = ({ kind }, point) => kind === "circle" && point === 0;

/**
 * What is held, dragged by some way from where it was.
 * @param {Bench} bench
 * @param {WholePart} before the document when the drag began
 * @param {Held} held
 * @param {Point} aim for a handle the place it is dragged to, for a whole shape the way, which goes by whole steps of the grid
 * @param {boolean} invert whether Control is held
 * @returns {(document: WholePart) => WholePart}
 */
export function dragged(bench, before, { shape: name, point }, aim, invert) {
  const start = shapeOf(before, name);
  if (!start) return (document) => document;
  if (point === null || isMiddle(start, point)) {
    const step = stepNow(bench, invert);
    const { view } = bench.now();
    const way = (/** @type {Point} */ by) => (step !== null ? snappedTo(by, step) : view ? /** @type {Point} */ ([aimed(by[0], view), aimed(by[1], view)]) : by);
    const [from] = pointsOf(start);
    const to = point === null ? null : rested(bench, aim, invert, name);
    const by = to ? /** @type {Point} */ ([to[0] - from[0], to[1] - from[1]]) : way(aim);
    const names = movedWith(before, name);
    const after = moveShapes(before, names, by);
    return (document) => withShapesOf(document, after, names);
  }
  if (start.kind === "circle" && isReach(start, point)) {
    const radius = restedRadius(bench, Math.hypot(aim[0] - start.center[0], aim[1] - start.center[1]), invert);
    return (document) => setRadius(document, name, radius);
  }
  if (start.kind === "line" && isReach(start, point)) {
    const angle = restedAngle(bench, angleTo(start.through, aim), invert);
    return (document) => setAngle(document, name, angle);
  }
  const to = rested(bench, aim, invert, name);
  return (document) => placeHandle(document, name, point, to);
}

/**
 * What is held, moved by an arrow key: a radius grows to the right and up, a direction turns counter-clockwise up and to the left.
 * @param {WholePart} document
 * @param {Held} held
 * @param {Point} arrow
 * @param {number} far factor of the step
 * @returns {WholePart}
 */
export function nudged(document, { shape: name, point }, arrow, far) {
  const shape = shapeOf(document, name);
  if (!shape) return document;
  const by = arrowStep(document) * far;
  if (point === null || isMiddle(shape, point)) return moveShapes(document, movedWith(document, name), [arrow[0] * by, arrow[1] * by]);
  if (shape.kind === "circle" && isReach(shape, point)) return setRadius(document, name, shape.radius + (arrow[0] + arrow[1]) * by);
  if (shape.kind === "line" && isReach(shape, point)) {
    return setAngle(document, name, Number((angleOf(shape) + (arrow[1] - arrow[0]) * TURN * far).toFixed(6)));
  }
  const [x, y] = pointsOf(shape)[point] ?? [0, 0];
  return placeHandle(document, name, point, [x + arrow[0] * by, y + arrow[1] * by]);
}

/** Steps of documents that were asked for: one is never changed in place. @type {WeakMap<object, number>} */
const steps = new WeakMap();

/** The step of an arrow key: the power of ten nearest to a hundredth of all shapes together. @param {WholePart} document */
export function arrowStep(document) {
  const shapes = shapesOf(document);
  const known = steps.get(shapes);
  if (known !== undefined) return known;
  const boxes = shapes.map(boxOf);
  const span = (/** @type {0 | 1} */ k) => Math.max(...boxes.map(([, high]) => high[k])) - Math.min(...boxes.map(([low]) => low[k]));
  const extent = Math.max(span(0), span(1));
  const step = extent > 0 && Number.isFinite(extent) ? 10 ** Math.round(Math.log10(extent / 100)) : 1;
  steps.set(shapes, step);
  return step;
}

/** The name of a handle: that of the shape and its number, where it has several. @param {NamedShape} shape @param {number} point */
export const handleName = (shape, point) => (pointsOf(shape).length > 1 ? words.handles.nth(shape.name, point) : shape.name);

/**
 * Where something is, in words.
 * @param {NamedShape} shape
 * @param {number | null} point
 */
export function spokenPlace(shape, point) {
  if (point === null) {
    const [x, y] = middleOf(shape).map(coordinate);
    return words.handles.whole(shape.name, words.kind(shape), x, y);
  }
  if (shape.kind === "circle" && isReach(shape, point)) return words.handles.radius(shape.name, coordinate(shape.radius));
  if (shape.kind === "line" && isReach(shape, point)) return words.handles.angle(shape.name, fixed(angleOf(shape), 1));
  const [x, y] = pointsOf(shape)[point].map(coordinate);
  return words.handles.point(handleName(shape, point), x, y);
}
