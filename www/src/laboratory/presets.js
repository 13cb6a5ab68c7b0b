/** The presets of the solver laboratory: documents by the names that links have for them. */
import { PRESETS } from "./preset-words.js";

/** @type {{[path: string]: {title: string}}} */
const documents = import.meta.glob("../../presets/laplace/*.json", { eager: true, import: "default" });

export const problems = PRESETS.map(({ id, file, line }) => ({ id, line, document: documents[`../../presets/laplace/${file}.json`] }));
