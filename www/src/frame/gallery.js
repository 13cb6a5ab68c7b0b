/**
 * The way to the gallery, which is loaded when it is first asked for.
 *
 * @import { App } from "../state/app.js"
 */

/** @param {App} app */
export async function openGallery(app) {
  const { showGallery } = await import("../gallery/gallery.js");
  await showGallery(app);
}
