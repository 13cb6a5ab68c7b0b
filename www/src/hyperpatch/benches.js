/**
 * From curves to a body and back: each workbench goes on with the document that was open there last, or with its first preset.
 *
 * @import { App } from "../state/app.js"
 * @import { Origin } from "../state/store.js"
 * @import { CurvesDocument } from "../types.js"
 *
 * @typedef {{document: CurvesDocument, edited: boolean, origin: Origin}} Left
 */
import { viewAt } from "../files/document-view.js";
import { openDocument } from "../files/open.js";
import { firstPreset } from "../gallery/first.js";
import { isBody } from "./kind.js";
import { bodies } from "./presets.js";

/** What was open last, of bodies and of curves. @type {{body: Left | null, curves: Left | null}} */
const left = { body: null, curves: null };

/** @param {App} app @param {boolean} wantsBody */
export async function enter(app, wantsBody) {
  if (isBody(app.store.document) !== wantsBody) await (wantsBody ? toBodies(app) : toCurves(app));
}

/** @param {App} app */
async function toBodies(app) {
  leave(app, "curves");
  if (left.body) {
    app.ui.set({ mode: "figure", playing: false });
    // A mode of the curves is left before its document is.
    await new Promise(requestAnimationFrame);
    goOn(app, left.body);
  } else await openDocument(app, bodies[0].document, bodies[0].document.title);
}

/** @param {App} app */
async function toCurves(app) {
  leave(app, "body");
  if (left.curves) {
    goOn(app, left.curves);
    app.ui.set(viewAt(null, app.ui.value.size));
  } else await openDocument(app, firstPreset, "");
}

/** @param {App} app @param {keyof typeof left} kind */
function leave({ store }, kind) {
  const { document, edited, origin } = store;
  left[kind] = { document, edited, origin };
}

/** @param {App} app @param {Left} found */
function goOn(app, { document, edited, origin }) {
  app.store.open(document, edited, origin);
  app.ui.set({ selection: null });
}
