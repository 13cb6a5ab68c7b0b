/** The presets of the workbench Hyperpatch. */
import { showPresets } from "../gallery/list.js";
import { bodies } from "./presets.js";
import { bodyThumbnail } from "./thumbnail.js";
import { words } from "./words.js";

/** @param {import("../state/app.js").App} app */
export const showBodies = (app) => showPresets(app, { name: "bodies", words: words.gallery, presets: bodies, thumbnail: bodyThumbnail });
