/**
 * Adding and removing control points, from pointer, key and panel alike.
 *
 * @import { App } from "../state/app.js"
 * @import { Curve, CurvesDocument, Point } from "../types.js"
 */
import { problem } from "../painter.js";
import { isOpen, nearestParameter } from "../spline.js";
import { pointName } from "../state/app.js";
import { canRemovePoints, handleCount, removePoints } from "../state/edits.js";
import { seen } from "../state/in-space.js";
import { only } from "../state/selection.js";
import { strings } from "../strings.js";

/**
 * Adds a control point where the curve is nearest to `at`. The shape stays as it is.
 * @param {App} app
 * @param {number} index
 * @param {Point} at
 */
export async function insertAt(app, index, at) {
  const before = app.store.document;
  const u = nearestParameter(before.curves[index], at);
  try {
    const after = /** @type {CurvesDocument} */ (await app.kernel.insertPoint(before, index, u));
    if (app.store.document !== before) return;
    app.store.commit({ change: () => after });
    const curve = seen(after.curves[index]);
    const point = nearestPoint(curve, at);
    app.ui.set({ selection: only(index, point) });
    app.say(strings.handles.inserted(pointName(index, point)));
  } catch (error) {
    app.ui.set({ note: { tone: "error", text: problem(error).message } });
  }
}

/**
 * Adds a control point between one and the next, before the last one of an open curve.
 * @param {App} app
 * @param {number} index
 * @param {number} point
 */
export function insertAfter(app, index, point) {
  const curve = seen(app.store.document.curves[index]);
  const a = /** @type {Point} */ (curve.points[point]);
  const last = point + 1 === curve.points.length;
  const b = /** @type {Point} */ (curve.points[last ? (isOpen(curve) ? point - 1 : 0) : point + 1]);
  return insertAt(app, index, [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]);
}

/**
 * Removes control points; says why when the curve cannot spare them.
 * @param {App} app
 * @param {number} index
 * @param {readonly number[]} points
 */
export function remove(app, index, points) {
  const curve = app.store.document.curves[index];
  if (!canRemovePoints(curve, points.length)) {
    const text = strings.handles.tooFew(curve.degree);
    app.ui.set({ note: { tone: "plain", text } });
    app.say(text);
    return;
  }
  app.store.commit({ change: (document) => removePoints(document, index, points) });
  const left = handleCount(app.store.document.curves[index]);
  app.ui.set({ selection: only(index, Math.min(points[0], left - 1)) });
  app.say(strings.handles.removed(points.map((point) => pointName(index, point)).join(", ")));
}

/** @param {Curve} curve @param {Point} at */
function nearestPoint(curve, at) {
  let best = 0;
  let least = Infinity;
  for (let i = 0; i < handleCount(curve); i += 1) {
    const [x, y] = /** @type {Point} */ (curve.points[i]);
    const distance = Math.hypot(x - at[0], y - at[1]);
    if (distance < least) [least, best] = [distance, i];
  }
  return best;
}
