/**
 * From one workbench to another and back: each goes on with the document that was open there last, or with its first preset.
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
import { isCurves } from "../state/kind.js";
import { kindOf } from "./kinds.js";

/** What was open last, by kind. @type {Map<string, Left>} */
const left = new Map();

/** @param {App} app @param {string} kind */
export async function enter(app, kind) {
  const { document, edited, origin } = app.store;
  if (document.kind === kind) return;
  left.set(document.kind, { document, edited, origin });
  if (isCurves(document)) {
    app.ui.set({ mode: "figure", playing: false });
    // A mode of the curves is left before its document is.
    await new Promise(requestAnimationFrame);
  }
  const found = left.get(kind);
  if (found) {
    app.store.open(found.document, found.edited, found.origin);
    app.ui.set({ selection: null, ...(isCurves(found.document) ? viewAt(null, app.ui.value.size) : {}) });
    return;
  }
  const [first] = (await (await kindOf({ kind }))?.presets()) ?? [];
  await openDocument(app, first?.document ?? firstPreset, first?.document.title ?? "");
}
