/**
 * Bodies of hyperpatches as a kind of document.
 *
 * @import { Kind } from "../kinds/kinds.js"
 */
import { completedBody } from "./document.js";

/** @type {Kind} */
export const bodyKind = {
  completed: completedBody,
  presets: async () => (await import("./presets.js")).bodies,
  showGallery: async (app) => (await import("./gallery.js")).showBodies(app),
  showExport: async (app) => (await import("./export.js")).showBodyExport(app),
  thumbnail: async (...args) => (await import("./thumbnail.js")).bodyThumbnail(...args),
};
