/**
 * The presets of the workbench Hyperpatch: documents by the names that links have for them.
 */
import { PRESETS } from "./words.js";

/** @type {{[path: string]: {title: string}}} */
const documents = import.meta.glob("../../presets/hyperpatch/*.json", { eager: true, import: "default" });

export const bodies = PRESETS.map(({ id, file, line }) => ({ id, line, document: documents[`../../presets/hyperpatch/${file}.json`] }));
