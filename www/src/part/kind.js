/**
 * Parts as a kind of document.
 *
 * @import { Kind } from "../kinds/kinds.js"
 */
import { completedPart } from "./document.js";

/** @type {Kind} */
export const partKind = {
  completed: completedPart,
  empty: { kind: "part", bodies: [] },
  presets: async () => (await import("./presets.js")).parts,
  showGallery: async (app) => (await import("./gallery.js")).showParts(app),
  showExport: async (app) => (await import("./export.js")).showPartExport(app),
  thumbnail: async (...args) => (await import("./thumbnail.js")).partThumbnail(...args),
};
