/** The panel Export of a part. */
import { openPanel } from "../frame/panel.js";
import { words } from "./words.js";

/** @param {import("../state/app.js").App} _app */
export function showPartExport(_app) {
  openPanel({ name: "export", heading: words.exports.heading, body: [] });
}
