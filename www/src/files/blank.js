/**
 * The new document: no curve yet, and everything else as the format has it by default.
 *
 * @import { App } from "../state/app.js"
 */
import { strings } from "../strings.js";
import { openDocument } from "./open.js";

/** @param {App} app */
export function openBlank(app) {
  const raw = {
    directrix: 1,
    kind: "curves",
    title: strings.untitled,
    curves: [],
    matching: { method: "exact", oneToOne: true },
  };
  return openDocument(app, raw, strings.commands.new);
}
