/**
 * Commands on the list of curves. Each is one entry of the log, and says what it did.
 *
 * @import { App } from "../state/app.js"
 * @import { CompositionKey, Curve, CurvesDocument, Point, Shape } from "../types.js"
 */
import { spanOf } from "../../../js/span.js";
import { problem } from "../painter.js";
import { isOpen, placeOn } from "../spline.js";
import { curveName } from "../state/app.js";
import { deleteCurve, POINT_LIMIT } from "../state/curve-edits.js";
import { isHarmonic } from "../state/look.js";
import { written } from "../state/mix.js";
import { whole } from "../state/selection.js";
import { openCurveThrough } from "../state/through-open.js";
import { beyond, moveCurve, putCurve } from "./stack-edits.js";
import { words } from "./words.js";

/** Distance of an inserted curve from the in-between, in parts of its diagonal, and points that an open one passes. */
const NEAR = 0.0012;
const PASSED = 16;
/** Points of an in-between from each thread to the next. */
const REFINE = 4;
/** Places of an inserted curve at which its composition is read, and fractions that count as the same. */
const READ = 12;
const SAME = 2e-3;

/** @param {App} app */
const selected = ({ store, ui }) => ui.value.selection?.curve ?? store.document.curves.length - 1;

/** A curve at the end of the list; before the first one where that is selected. @param {App} app */
export async function addCurve(app) {
  const { curves } = app.store.document;
  if (isHarmonic(app.store.document) && curves.length > 1) return (await import("../harmonic/commands.js")).addInside(app);
  addAt(app, curves.length > 1 && selected(app) === 0 ? "first" : "last");
}

/** @param {App} app @param {"first" | "last"} end */
function addAt(app, end) {
  const { curves, sampling } = app.store.document;
  const index = end === "first" ? 0 : curves.length;
  const samples = sampling.counts[end === "first" ? 0 : curves.length - 1];
  app.store.commit({ change: (document) => putCurve(document, index, beyond(document, end), samples) });
  app.ui.set({ selection: whole(index) });
  app.say(words.added(curveName(app.store.document, index)));
}

/** A copy of an end goes beyond it; one of an inner curve would meet it, so that a curve comes half way to the next. @param {App} app @param {number} curve */
export async function duplicate(app, curve) {
  const last = app.store.document.curves.length - 1;
  if (curve === 0 || curve === last) addAt(app, curve === 0 ? "first" : "last");
  else await insertCurve(app);
}

/** The in-between half way to the next curve becomes a curve. @param {App} app */
export async function insertCurve(app) {
  const { document } = app.store;
  const index = selected(app);
  try {
    const curve = await halfWay(app, document, index);
    if (app.store.document !== document) return;
    if (!curve) {
      app.ui.set({ note: { tone: "plain", text: words.noInBetween } });
      app.say(words.noInBetween);
      return;
    }
    const [a, b] = document.sampling.counts.slice(index, index + 2);
    app.store.commit({ change: (now) => putCurve(now, index + 1, curve, Math.round((a + b) / 2)) });
    app.ui.set({ selection: whole(index + 1) });
    app.say(words.inserted(curveName(app.store.document, index + 1), curve.points.length));
  } catch (error) {
    app.ui.set({ note: { tone: "error", text: problem(error).message } });
  }
}

/**
 * @param {App} app
 * @param {CurvesDocument} document
 * @param {number} span
 * @returns {Promise<Curve | null>} null where the two curves are not matched
 */
async function halfWay(app, document, span) {
  const pair = spanOf(document, span);
  const [first, second] = pair.curves;
  const halved = { ...pair, blend: { ...pair.blend, stages: 2 }, matching: { ...pair.matching, printed: [] } };
  const stages = await app.kernel.stages(halved, { refine: REFINE });
  const points = stages[1]?.points;
  if (!points) return null;
  const shape = isOpen(first) ? through(points) : await fitted(app, points);
  if (!shape) return null;
  const composition = await mixes(app, pair, shape);
  return { ...shape, height: (first.height + second.height) / 2, composition };
}

/** @param {App} app @param {Point[]} points @returns {Promise<Shape>} */
async function fitted(app, points) {
  const size = (/** @type {0 | 1} */ axis) => {
    const values = points.map((point) => point[axis]);
    return Math.max(...values) - Math.min(...values);
  };
  const tolerance = NEAR * Math.hypot(size(0), size(1));
  // Where lines fan, points lie on each other.
  const apart = points.filter((point, k) => {
    const before = points[(k + points.length - 1) % points.length];
    return Math.hypot(point[0] - before[0], point[1] - before[1]) > tolerance / 8;
  });
  const every = Math.max(1, Math.ceil(apart.length / POINT_LIMIT));
  const ring = apart.filter((_, k) => k % every === 0);
  const { curve } = await app.kernel.fitCurve(ring, { tolerance, corners: "smooth", through: false });
  return /** @type {Shape} */ (curve);
}

/** @param {Point[]} points */
function through(points) {
  const last = points.length - 1;
  const count = Math.min(PASSED, points.length);
  return openCurveThrough(Array.from({ length: count }, (_, k) => points[Math.round((k * last) / (count - 1))]));
}

/**
 * What the blend is made of along a curve in its middle: one key where that is the same all along, as it is between two curves that are.
 * @param {App} app
 * @param {CurvesDocument} pair
 * @param {Shape} shape
 * @returns {Promise<CompositionKey[]>}
 */
async function mixes(app, pair, shape) {
  const [first, second] = pair.curves.map(({ composition }) => composition);
  const half = [{ at: 0, mix: written(first[0].mix.map((part, i) => (part + second[0].mix[i]) / 2)) }];
  if (first.length === 1 && second.length === 1) return half;
  /** @type {CompositionKey[]} */
  const keys = [];
  for (let k = 0; k < READ; k += 1) {
    const at = k / READ;
    const found = await app.kernel.probe(pair, placeOn(/** @type {Curve} */ (shape), at).at);
    if (found) keys.push({ at: Number(at.toFixed(4)), mix: written(found.fractions) });
  }
  if (keys.length === 0) return half;
  const isSame = keys.every(({ mix }) => mix.every((part, i) => Math.abs(part - keys[0].mix[i]) < SAME));
  return isSame ? [{ at: 0, mix: keys[0].mix }] : keys;
}

/** @param {App} app @param {number} index @param {-1 | 1} by @returns {boolean} whether it moved */
export function move(app, index, by) {
  const { document } = app.store;
  const name = curveName(document, index);
  const count = document.curves.length;
  if (!document.curves[index + by]) {
    app.say(words.atEnd(name, by < 0 ? "first" : "last"));
    return false;
  }
  const { selection } = app.ui.value;
  app.store.commit({ change: (now) => moveCurve(now, index, by) });
  app.ui.set({ selection: selection?.curve === index ? { ...selection, curve: index + by } : whole(index + by) });
  const pins = (/** @type {CurvesDocument} */ { matching }) => matching.pins?.length ?? 0;
  const gone = pins(document) - pins(app.store.document);
  app.say(`${words.moved(name, index + by + 1, count)}${gone > 0 ? words.movedLess(gone) : ""}`);
  return true;
}

/** @param {App} app @param {number} index */
export function remove(app, index) {
  const said = words.remove(curveName(app.store.document, index)).replace("Delete", "Deleted");
  app.store.commit({ change: (document) => deleteCurve(document, index) });
  app.ui.set({ selection: whole(Math.max(0, index - 1)) });
  app.say(said);
}
