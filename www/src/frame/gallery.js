/**
 * The way to the gallery, which is loaded when it is first asked for.
 *
 * @import { App } from "../state/app.js"
 */

import { isBody } from "../hyperpatch/kind.js";

/** @param {App} app */
export async function openGallery(app) {
  if (isBody(app.store.document)) return (await import("../hyperpatch/gallery.js")).showBodies(app);
  const { showGallery } = await import("../gallery/gallery.js");
  showGallery(app);
}
