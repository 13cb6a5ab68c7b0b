/** The presets of the solver laboratory. */
import { showPresets } from "../gallery/list.js";
import { problems } from "./presets.js";
import { problemThumbnail } from "./thumbnail.js";
import { words } from "./words.js";

/** @param {import("../state/app.js").App} app */
export const showProblems = (app) => showPresets(app, { name: "problems", words: words.gallery, presets: problems, thumbnail: problemThumbnail });
