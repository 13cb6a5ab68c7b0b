/**
 * How the picture of a body was left: camera and display, for each opening of a document as long as the page is open, the last one also across
 * a reload.
 *
 * @import { App } from "../state/app.js"
 * @import { Camera } from "../space/camera.js"
 * @import { Shown } from "./state.js"
 *
 * @typedef {Pick<Shown, "color" | "material" | "edges" | "corners" | "light" | "apart" | "transparency" | "continuity" | "section">} Display
 * @typedef {{of: string, camera: Camera | null, display: Display}} Seen `of`: the opening of the document.
 */

/** @type {Map<string, Seen>} */
const left = new Map();

/** @param {App} app @param {string} of @param {Camera | null} camera null where nothing is drawn @param {Shown} shown */
export function leave({ ui }, of, camera, { color, material, edges, corners, light, apart, transparency, continuity, section }) {
  const seen = { of, camera, display: { color, material, edges, corners, light, apart, transparency, continuity, section } };
  left.set(of, seen);
  ui.set({ body: seen });
}

/** How the picture of an opening of a document was left; null for a new one. @param {App} app @param {string} of @returns {Seen | null} */
export function leftOf({ ui }, of) {
  const { body } = ui.value;
  return left.get(of) ?? (body?.of === of ? body : null);
}
