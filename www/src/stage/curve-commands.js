/**
 * Commands on the selected curve and its points. Each is one entry of the log, and says what it did.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Selection } from "../types.js"
 * @import { Alignment } from "../state/curve-edits.js"
 */
import { find } from "../dom.js";
import { problem } from "../painter.js";
import { isOpen, outline } from "../spline.js";
import { curveName, pointName } from "../state/app.js";
import {
  alignPoints,
  deleteCurve,
  duplicateCurve,
  duplicatePoint,
  putShape,
  reverseCurve,
  reversedPoint,
  swapCurves,
} from "../state/curve-edits.js";
import { isHarmonic } from "../state/look.js";
import { allPoints, several, whole, within } from "../state/selection.js";
import { strings } from "../strings.js";
import { words } from "./curve-words.js";
import { insertAfter, remove } from "./points.js";

/** Distance of a smoothed curve from the one with corners, in parts of its diagonal. */
const NEAR = 0.004;

/** @param {App} app @returns {Selection} */
function chosen({ store, ui }) {
  return ui.value.selection ?? whole(Math.max(0, store.document.curves.length - 1));
}

/**
 * @param {App} app
 * @param {(document: CurvesDocument) => CurvesDocument} change
 * @param {Selection | null} selection after it
 * @param {string} said
 */
function commit(app, change, selection, said) {
  app.store.commit({ change });
  app.ui.set({ selection: within(selection, app.store.document) });
  app.say(said);
}

/** @param {App} app */
export function selectAll(app) {
  const selection = allPoints(app.store.document, chosen(app).curve);
  app.ui.set({ selection });
  app.say(strings.curves.selected(selection.points.length));
}

/** @param {App} app */
export function selectWhole(app) {
  const { curve } = chosen(app);
  app.ui.set({ selection: whole(curve) });
  app.say(curveName(app.store.document, curve));
}

/** @param {App} app */
export async function insertPoint(app) {
  const { curve, points } = chosen(app);
  await insertAfter(app, curve, points[points.length - 1] ?? 0);
}

/** @param {App} app */
export function deletePoints(app) {
  const { curve, points } = chosen(app);
  if (points.length > 0) remove(app, curve, points);
}

/** @param {App} app */
export function duplicatePoints(app) {
  const { curve, points } = chosen(app);
  // From the last on, so that the indices of those before stay true; the new point follows the old one.
  const copies = points.map((point, k) => point + k + 1);
  commit(
    app,
    (document) => [...points].reverse().reduce((now, point) => duplicatePoint(now, curve, point), document),
    several(curve, copies),
    words.doubled(points.map((point) => pointName(curve, point)).join(", ")),
  );
}

/** @param {App} app */
export async function duplicate(app) {
  const { curve } = chosen(app);
  if (isHarmonic(app.store.document) && app.store.document.curves.length > 1) return (await import("../harmonic/commands.js")).addInside(app, curve);
  if (app.store.document.curves.length > 2) return (await import("../stack/stack-commands.js")).duplicate(app, curve);
  const target = app.store.document.curves.length === 2 ? 1 - curve : 1;
  app.store.commit({ change: (document) => duplicateCurve(document, curve) });
  app.ui.set({ selection: whole(target) });
  app.say(words.copied(curveName(app.store.document, target)));
}

/** @param {App} app */
export function rename(app) {
  const { open } = app.ui.value;
  app.ui.set({ tab: "curves", open: open.includes("curves") ? open : [...open, "curves"] });
  const root = document.documentElement;
  if (matchMedia("(width >= 600px) and (width < 900px)").matches && !root.classList.contains("panel-open")) {
    find("[data-action=panel]").click();
  }
  requestAnimationFrame(() => {
    const input = find("input[data-field=curve-name]");
    input.focus();
    /** @type {HTMLInputElement} */ (input).select();
  });
}

/** @param {App} app */
export function swap(app) {
  const { curve, points } = chosen(app);
  commit(app, swapCurves, { curve: app.store.document.curves.length - 1 - curve, points }, words.swapped);
}

/** @param {App} app */
export function reverse(app) {
  const { curve, points } = chosen(app);
  const shape = app.store.document.curves[curve];
  commit(
    app,
    (document) => reverseCurve(document, curve),
    several(curve, points.map((point) => reversedPoint(shape, point))),
    words.reversed(curveName(app.store.document, curve)),
  );
}

/** @param {App} app */
export function removeCurve(app) {
  const { curve } = chosen(app);
  const left = app.store.document.curves.length - 1;
  const said = words.deleted(curveName(app.store.document, curve));
  commit(app, (document) => deleteCurve(document, curve), left > 0 ? whole(Math.max(0, curve - 1)) : null, said);
}

/**
 * @param {App} app
 * @param {Alignment} how
 */
export function align(app, how) {
  const { curve, points } = chosen(app);
  const said = strings.curves.alignments[how];
  commit(app, (document) => alignPoints(document, curve, points, how), chosen(app), said);
}

/**
 * Replaces a curve that has corners by one without, near to it.
 * @param {App} app
 */
export async function smooth(app) {
  const { curve } = chosen(app);
  const before = app.store.document;
  const chain = outline(before.curves[curve]).map(({ at }) => at);
  const xs = chain.map(([x]) => x);
  const ys = chain.map(([, y]) => y);
  const diagonal = Math.hypot(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys));
  try {
    const shape = isOpen(before.curves[curve]) ? await smoothOpen(chain) : await fitted(app, chain, diagonal * NEAR);
    if (app.store.document !== before || !shape) return;
    const said = words.smoothed(curveName(before, curve), shape.points.length);
    commit(app, (document) => putShape(document, curve, shape), whole(curve), said);
  } catch (error) {
    app.ui.set({ note: { tone: "error", text: problem(error).message } });
  }
}

/**
 * @param {App} app
 * @param {import("../types.js").Point[]} chain
 * @param {number} tolerance
 */
async function fitted(app, chain, tolerance) {
  const { curve } = await app.kernel.fitCurve(chain.slice(0, -1), { tolerance, corners: "smooth", through: false });
  return /** @type {import("../types.js").Shape} */ (curve);
}

/** Points of an open curve that its smooth one passes. */
const PASSED = 24;

/** @param {import("../types.js").Point[]} chain */
async function smoothOpen(chain) {
  const { openCurveThrough } = await import("../state/through-open.js");
  const every = (chain.length - 1) / Math.min(PASSED - 1, chain.length - 1);
  const count = Math.round((chain.length - 1) / every) + 1;
  return openCurveThrough(Array.from({ length: count }, (_, k) => chain[Math.min(chain.length - 1, Math.round(k * every))]));
}
