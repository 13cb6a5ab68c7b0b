/** The presets of the workbench Part. */
import { showPresets } from "../gallery/list.js";
import { parts } from "./presets.js";
import { partThumbnail } from "./thumbnail.js";
import { words } from "./words.js";

/** @param {import("../state/app.js").App} app */
export const showParts = (app) => showPresets(app, { name: "parts", words: words.gallery, presets: parts, thumbnail: partThumbnail });
