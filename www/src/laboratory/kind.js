/**
 * Boundary value problems as a kind of document.
 *
 * @import { Kind } from "../kinds/kinds.js"
 */
import { completedLaboratory } from "./document.js";

/** @type {Kind} */
export const laboratoryKind = {
  completed: completedLaboratory,
  presets: async () => (await import("./presets.js")).problems,
  showGallery: async (app) => (await import("./gallery.js")).showProblems(app),
  showExport: async (app) => (await import("./export.js")).showProblemExport(app),
  thumbnail: async (...args) => (await import("./thumbnail.js")).problemThumbnail(...args),
};
