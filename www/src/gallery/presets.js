/**
 * The presets with their thumbnails. They come with the gallery, not with the page.
 *
 * @typedef {"shapes" | "pockets" | "measures" | "materials" | "stacks"} Topic
 *
 * @typedef {object} Preset
 * @property {string} id
 * @property {string} title
 * @property {Topic} topic
 * @property {false} [matched] false where the curves cannot be matched as they lie
 * @property {string} line why it matters
 */

/** @type {{[path: string]: unknown}} */
const documents = import.meta.glob("../../presets/*.json", { eager: true, import: "default" });
/** @type {{[path: string]: string}} */
const pictures = import.meta.glob("../../thumbnails/*.png", { eager: true, query: "?url", import: "default" });

/** The list of presets, in the order of the gallery. */
export const presets = /** @type {Preset[]} */ (documents["../../presets/index.json"]);

/** @param {string} id */
export function presetDocument(id) {
  return documents[`../../presets/${id}.json`];
}

/**
 * The address of a preset's small picture.
 * @param {string} id
 * @param {"light" | "dark"} theme
 */
export function thumbnail(id, theme) {
  return pictures[`../../thumbnails/${id}-${theme}.png`] ?? "";
}
