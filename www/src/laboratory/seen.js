/**
 * How the picture of a problem was left: camera, view and display, for each opening of a document as long as the page is open, the last one also across
 * a reload.
 *
 * @import { App } from "../state/app.js"
 * @import { Camera } from "../space/camera.js"
 * @import { View } from "../types.js"
 * @import { Shown } from "./state.js"
 *
 * @typedef {{of: string, camera: Camera | null, view: View | null, fitted: boolean, fitScale: number, shown: Shown}} Seen `of`: the opening of the document.
 */

/** @type {Map<string, Seen>} */
const left = new Map();

/** @param {App} app @param {string} of @param {Camera | null} camera @param {Shown} shown */
export function leave({ ui }, of, camera, shown) {
  const { view, fitted, fitScale } = ui.value;
  const seen = { of, camera, view, fitted, fitScale, shown: { ...shown, picking: null } };
  left.set(of, seen);
  ui.set({ lab: seen });
}

/** How the picture of an opening of a document was left; null for a new one. @param {App} app @param {string} of @returns {Seen | null} */
export function leftOf({ ui }, of) {
  const { lab } = ui.value;
  return left.get(of) ?? (lab?.of === of ? lab : null);
}
