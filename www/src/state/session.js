/**
 * Keeps the work across a reload and the back button, in the entry of the browser's own history.
 *
 * @import { App, Ui } from "./app.js"
 * @import { CurvesDocument } from "../types.js"
 *
 * @typedef {object} Session
 * @property {CurvesDocument} document
 * @property {boolean} edited
 * @property {Partial<Ui>} ui
 * @property {import("../storage/keeper.js").Kept | null} kept where the browser's storage has the document
 */

/** Milliseconds of rest before the work is kept. */
const PAUSE = 800;
const VERSION = 2;

/** The hash that the page has taken in. While it has another one, the entry belongs to a document that is not open yet. */
let taken = "";

/** The page has done what the hash says, or told that it cannot. */
export function takeHash() {
  taken = location.hash;
}

/** @returns {Session | null} */
export function restore() {
  const state = history.state;
  if (typeof state !== "object" || state === null || state.directrix !== VERSION) return null;
  const { document, edited, ui, kept } = state;
  return document && ui ? { document, edited: edited === true, ui, kept: kept ?? null } : null;
}

/** Keeps the work in this entry of the history, before another one is gone to with another document. */
export let keepNow = () => {};

/** @param {App} app */
export function keep(app) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  const write = () => {
    clearTimeout(timer);
    if (location.hash !== taken) return;
    const { mode, solid, body, part, lab, step, selection, view, fitted, fitScale, layers, s, motion, isoMaterial, patterns, stageLabels, open, tab, snap } = app.ui.value;
    try {
      history.replaceState(
        {
          directrix: VERSION,
          document: app.store.document,
          edited: app.store.edited,
          kept: app.keeper.kept(),
          ui: { mode, solid, body, part, lab, step, selection, view, fitted, fitScale, layers, s, motion, isoMaterial, patterns, stageLabels, open, tab, snap },
        },
        "",
      );
    } catch {
      // A document past the browser's own limit is not kept across a reload; the page goes on.
    }
  };
  keepNow = () => {
    takeHash();
    write();
  };
  const later = () => {
    clearTimeout(timer);
    timer = setTimeout(write, PAUSE);
  };
  app.store.subscribe(later);
  app.keeper.subscribe(write);
  app.ui.subscribe((ui, before) => {
    if (ui.playing && ui.s !== before.s) return;
    if (ui.probe !== before.probe && ui.view === before.view) return;
    later();
  });
  // When the page is hidden it may be too late for a reload, which has read the entry by then.
  addEventListener("beforeunload", write);
  addEventListener("pagehide", write);
}
