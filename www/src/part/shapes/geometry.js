/**
 * The shapes of a part as the page takes hold of them: each has handles in an order of its own, some of them its points, and an outline.
 *
 * @import { PartShape } from "../../../../js/directrix.js"
 * @import { Point } from "../../types.js"
 *
 * @typedef {{name: string} & PartShape} NamedShape
 * @typedef {PartShape["kind"]} Kind
 */
import { outline, signedArea } from "../../spline.js";
import { tidy } from "../../state/edits.js";

/** Greatest coordinate and length of the format. */
export const FAR = 1e9;
/** Digits of a unit vector. */
const DIGITS = 9;

/** A coordinate as far as the format goes, without the noise of binary addition. @param {number} value */
export const kept = (value) => tidy(Math.min(FAR, Math.max(-FAR, value))) + 0;

/** @param {Point} at @returns {Point} */
export const keptPoint = ([x, y]) => [kept(x), kept(y)];

/**
 * The points of a shape that can be moved by themselves. A clamped curve repeats its first one at the end, and both count once.
 * @param {PartShape} shape
 * @returns {readonly Point[]}
 */
export function pointsOf(shape) {
  switch (shape.kind) {
    case "point":
      return [shape.at];
    case "line":
      return [shape.through];
    case "segment":
      return [shape.from, shape.to];
    case "circle":
      return [shape.center];
    default:
      return isClamped(shape) ? shape.points.slice(0, -1) : shape.points;
  }
}

/**
 * The handles of a shape: its points, and after them the rim of a circle or the direction of a line.
 * @param {PartShape} shape
 */
export function handleCount(shape) {
  if (shape.kind === "polygon" || shape.kind === "polyline") return shape.points.length;
  if (shape.kind === "curve") return shape.points.length - (isClamped(shape) ? 1 : 0);
  return shape.kind === "point" ? 1 : 2;
}

/** Whether a handle sets a radius or a direction and is no point of the shape. @param {PartShape} shape @param {number} handle */
export const isReach = ({ kind }, handle) => handle === 1 && (kind === "circle" || kind === "line");

/** Whether a shape has a list of points, which may grow and shrink. @param {PartShape} shape @returns {shape is Extract<PartShape, {points: Point[]}>} */
export const hasList = (shape) => "points" in shape;

/** @param {PartShape} shape */
export const isClamped = (shape) => shape.kind === "curve" && shape.form === "clamped";

/** Whether a shape can be an outline or a hole. @param {PartShape} shape */
export const isClosed = (shape) =>
  shape.kind === "circle" || shape.kind === "polygon" || (shape.kind === "curve" && shape.form !== "open");

/** Points that a shape counts with towards the limit of a document. @param {PartShape} shape */
export const countOf = (shape) => (hasList(shape) ? shape.points.length : 2);

/** Fewest handles that a shape with a list can have: those of a polygon, a chain, a curve of its degree. @param {PartShape} shape */
export function fewestOf(shape) {
  if (shape.kind === "curve") return isClamped(shape) || shape.form === "periodic" ? Math.max(3, shape.degree + (isClamped(shape) ? 0 : 1)) : shape.degree + 1;
  return shape.kind === "polygon" ? 3 : 2;
}

/** The direction of a line as a unit vector; along x where it has none. @param {Extract<PartShape, {kind: "line"}>} line @returns {Point} */
export function unitOf({ direction: [x, y] }) {
  const length = Math.hypot(x, y);
  return length > 0 ? [x / length, y / length] : [1, 0];
}

/** A unit vector by its angle, exact along the axes. @param {number} degrees counter-clockwise from x @returns {Point} */
export function directionAt(degrees) {
  const angle = (degrees * Math.PI) / 180;
  const rounded = (/** @type {number} */ value) => Number(value.toFixed(DIGITS)) + 0;
  return [rounded(Math.cos(angle)), rounded(Math.sin(angle))];
}

/** The angle of a line, above -180 and at most 180 degrees. @param {Extract<PartShape, {kind: "line"}>} line */
export function angleOf(line) {
  const [x, y] = unitOf(line);
  return tidy(Number(((Math.atan2(y, x) * 180) / Math.PI).toFixed(6))) + 0;
}

/**
 * Whether a curve can be drawn: its points are enough for its degree, and its knots, where it has some, fit them and ascend.
 * @param {PartShape} shape
 */
function isSound(shape) {
  if (shape.kind !== "curve") return true;
  const { degree: p, form, points, knots } = shape;
  const n = points.length;
  if (n <= p || p < 1) return false;
  if (!knots) return true;
  const counts = form === "periodic" ? [n + 1, n + 2 * p + 1] : [n + p + 1];
  return counts.includes(knots.length) && knots.every((knot, i) => i === 0 || knot >= knots[i - 1]) && knots[knots.length - 1] > knots[0];
}

/** Least chords of a whole curve and of one knot span: a curve of few points fills the window with each span. */
const CHORDS = { curve: 600, span: 12 };
/** Chains that were asked for: a shape is never changed in place. @type {WeakMap<PartShape, readonly Point[]>} */
const chains = new WeakMap();

/**
 * The chain of points that is drawn for a shape with ends or a closed one; of a curve that cannot be made its control polygon. A circle and a line are drawn
 * otherwise.
 * @param {PartShape} shape
 * @returns {readonly Point[]}
 */
export function chainOf(shape) {
  if (shape.kind !== "curve" || !isSound(shape)) return hasList(shape) ? shape.points : pointsOf(shape);
  const known = chains.get(shape) ?? outline(shape, Math.max(CHORDS.span, Math.ceil(CHORDS.curve / shape.points.length))).map(({ at }) => at);
  chains.set(shape, known);
  return known;
}

/**
 * The place on a chain nearest to a point: the piece it lies on, and its distance.
 * @param {readonly Point[]} chain
 * @param {boolean} closed
 * @param {Point} target
 */
export function nearestPiece(chain, closed, [x, y]) {
  let best = { piece: 0, distance: Infinity, at: /** @type {Point} */ (chain[0]) };
  const pieces = closed ? chain.length : chain.length - 1;
  for (let i = 0; i < pieces; i += 1) {
    const [ax, ay] = chain[i];
    const [bx, by] = chain[(i + 1) % chain.length];
    const [dx, dy] = [bx - ax, by - ay];
    const length = dx * dx + dy * dy;
    const t = length > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / length)) : 0;
    const at = /** @type {Point} */ ([ax + dx * t, ay + dy * t]);
    const distance = Math.hypot(at[0] - x, at[1] - y);
    if (distance < best.distance) best = { piece: i, distance, at };
  }
  return best;
}

/** Boxes that were asked for. @type {WeakMap<PartShape, [Point, Point]>} */
const boxes = new WeakMap();

/** The box round a shape; that of a line is its point. @param {PartShape} shape @returns {[Point, Point]} */
export function boxOf(shape) {
  const known = boxes.get(shape) ?? measured(shape);
  boxes.set(shape, known);
  return known;
}

/** @param {PartShape} shape @returns {[Point, Point]} */
function measured(shape) {
  if (shape.kind === "circle") {
    const [[x, y], r] = [shape.center, shape.radius];
    return [[x - r, y - r], [x + r, y + r]];
  }
  const low = /** @type {Point} */ ([Infinity, Infinity]);
  const high = /** @type {Point} */ ([-Infinity, -Infinity]);
  for (const at of chainOf(shape)) {
    for (const k of [0, 1]) {
      low[k] = Math.min(low[k], at[k]);
      high[k] = Math.max(high[k], at[k]);
    }
  }
  return [low, high];
}

/** The middle of a shape, by which it is said to move. @param {PartShape} shape @returns {Point} */
export function middleOf(shape) {
  const [[left, low], [right, high]] = boxOf(shape);
  return [(left + right) / 2, (low + high) / 2];
}

/** Half the diagonal of the box of a shape. @param {PartShape} shape */
export function reachOf(shape) {
  const [[left, low], [right, high]] = boxOf(shape);
  return Math.hypot(right - left, high - low) / 2;
}

/** Area of a closed shape, never negative. @param {PartShape} shape */
export const areaOf = (shape) =>
  shape.kind === "circle" ? Math.PI * shape.radius ** 2 : isClosed(shape) ? Math.abs(signedArea([...chainOf(shape)])) / 2 : 0;
