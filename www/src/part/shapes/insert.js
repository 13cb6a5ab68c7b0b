/**
 * More and fewer points of a shape, from pointer, key and panel alike, and shapes that are deleted.
 *
 * @import { Point } from "../../types.js"
 * @import { Bench } from "../state.js"
 */
import { problem } from "../../painter.js";
import { nearestParameter } from "../../spline.js";
import { canRemove, insertPoint, placeAfter, removePoints, whyNotInsert } from "../edits/points.js";
import { deleteShape, setGeometry, shapeOf, usesOf } from "../edits/shapes.js";
import { fewestOf, handleCount, hasList, isClosed, nearestPiece, pointsOf } from "./geometry.js";
import { words } from "./words.js";

/** Says why something was not done. @param {Bench} bench @param {string} text @param {"plain" | "error"} [tone] */
function tell({ app }, text, tone = "plain") {
  app.ui.set({ note: { tone, text } });
  app.say(text);
}

/** @param {Bench} bench @param {string} name whether it can have one more point, which is said if not */
function canInsert(bench, name) {
  const { document } = bench.now();
  const shape = shapeOf(document, name);
  const why = whyNotInsert(document, name);
  if (why && shape) tell(bench, why === "kind" ? words.handles.noList(words.kind(shape)) : words.handles.mostPoints);
  return why === null;
}

/** @param {Bench} bench @param {string} name @param {number} point */
function chosen({ app, change }, name, point) {
  change({ shape: name, point });
  app.say(words.handles.inserted(words.handles.nth(name, point)));
}

/**
 * Adds a point where the outline of a shape is nearest to a place. The shape stays as it is.
 * @param {Bench} bench
 * @param {string} name
 * @param {Point} at document units
 */
export async function insertAt(bench, name, at) {
  if (!canInsert(bench, name)) return;
  const shape = shapeOf(bench.now().document, name);
  if (shape?.kind === "curve") return insertInCurve(bench, name, at);
  if (!shape || !hasList(shape)) return;
  const { piece, at: place } = nearestPiece(shape.points, isClosed(shape), at);
  bench.commit((document) => insertPoint(document, name, piece + 1, place));
  chosen(bench, name, piece + 1);
}

/**
 * A point of a curve comes with a knot where the curve is nearest to a place.
 * @param {Bench} bench
 * @param {string} name
 * @param {Point} at
 */
async function insertInCurve(bench, name, at) {
  const { document } = bench.now();
  const shape = shapeOf(document, name);
  if (shape?.kind !== "curve") return;
  const { degree, form, points, knots } = shape;
  const curve = { degree, form, points, ...(knots ? { knots } : {}) };
  try {
    const raw = /** @type {any} */ ({ directrix: 1, kind: "curves", curves: [curve], matching: { method: "exact" } });
    const after = await bench.app.kernel.insertPoint(raw, 0, nearestParameter(/** @type {any} */ (curve), at));
    if (bench.now().document !== document) return;
    const { degree: p, form: how, points: list, knots: all } = /** @type {any} */ (after.curves[0]);
    const next = { kind: /** @type {const} */ ("curve"), degree: p, form: how, points: list, ...(all ? { knots: all } : {}) };
    bench.commit((now) => setGeometry(now, name, next));
    const near = pointsOf(next).map(([x, y]) => Math.hypot(x - at[0], y - at[1]));
    chosen(bench, name, near.indexOf(Math.min(...near)));
  } catch (error) {
    tell(bench, problem(error).message, "error");
  }
}

/**
 * Adds a point after another one; past the end of an open chain it goes on, and of an open curve it comes before the end.
 * @param {Bench} bench
 * @param {string} name
 * @param {number} point
 */
export async function insertAfter(bench, name, point) {
  if (!canInsert(bench, name)) return;
  const shape = shapeOf(bench.now().document, name);
  if (!shape) return;
  const points = pointsOf(shape);
  const last = shape.kind === "curve" && !isClosed(shape) && point === points.length - 1;
  const place = placeAfter(points, isClosed(shape), last ? point - 1 : point);
  if (shape.kind === "curve") return insertInCurve(bench, name, place);
  bench.commit((document) => insertPoint(document, name, point + 1, place));
  chosen(bench, name, point + 1);
}

/**
 * Removes a point; says so where the shape cannot spare it.
 * @param {Bench} bench
 * @param {string} name
 * @param {number} point
 */
export function removePoint(bench, name, point) {
  const shape = shapeOf(bench.now().document, name);
  if (!shape) return;
  if (!canRemove(bench.now().document, name)) {
    tell(bench, hasList(shape) ? words.handles.tooFew(name, fewestOf(shape)) : words.handles.noList(words.kind(shape)));
    return;
  }
  bench.commit((document) => removePoints(document, name, [point]));
  bench.change({ point: Math.min(point, handleCount(shape) - 2) });
  bench.app.say(words.handles.removed(words.handles.nth(name, point)));
}

/**
 * Deletes a shape, and says how many places still name it.
 * @param {Bench} bench
 * @param {string} name
 * @param {boolean} [withUses] whether what uses it goes as well
 */
export function removeShape(bench, name, withUses = false) {
  const naming = withUses ? 0 : usesOf(bench.now().document, name).filter(({ as }) => as === "outline" || as === "reference").length;
  bench.commit((document) => deleteShape(document, name, { withUses }));
  bench.change({ shape: null, point: null });
  if (naming > 0) tell(bench, words.group.orphans(name, naming));
  else bench.app.say(words.handles.deleted(name));
}
