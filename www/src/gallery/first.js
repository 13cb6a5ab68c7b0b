/**
 * The document that opens with the page.
 */

/** @type {{[path: string]: unknown}} */
const files = import.meta.glob("../../presets/amoeba.json", { eager: true, import: "default" });

/** The first preset of the gallery. */
export const firstPreset = files["../../presets/amoeba.json"];
