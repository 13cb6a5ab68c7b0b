/** The presets of the workbench Part: documents by the names that links have for them. */
import { PRESETS } from "./words.js";

/** @type {{[path: string]: {title: string}}} */
const documents = import.meta.glob("../../presets/part/*.json", { eager: true, import: "default" });

export const parts = PRESETS.map(({ id, file, line }) => ({ id, line, document: documents[`../../presets/part/${file}.json`] }));
