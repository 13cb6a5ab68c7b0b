/**
 * How the picture of a part was left: view and display, for each opening of a document as long as the page is open, the last one also across a reload.
 *
 * @import { App } from "../state/app.js"
 * @import { View } from "../types.js"
 * @import { Shown } from "./state.js"
 *
 * @typedef {{of: string, view: View | null, fitted: boolean, fitScale: number, shown: Shown}} Seen `of`: the opening of the document.
 */

/** @type {Map<string, Seen>} */
const left = new Map();

/** @param {App} app @param {string} of @param {Shown} shown */
export function leave({ ui }, of, shown) {
  const { view, fitted, fitScale } = ui.value;
  const seen = { of, view, fitted, fitScale, shown };
  left.set(of, seen);
  ui.set({ part: seen });
}

/** How the picture of an opening of a document was left; null for a new one. @param {App} app @param {string} of @returns {Seen | null} */
export function leftOf({ ui }, of) {
  const { part } = ui.value;
  return left.get(of) ?? (part?.of === of ? part : null);
}
