/**
 * The new document: nothing in it yet, and everything else as the format has it by default. It is of the kind that is open, where that kind has an
 * empty document, and else of curves.
 *
 * @import { App } from "../state/app.js"
 */
import { kindOf } from "../kinds/kinds.js";
import { strings } from "../strings.js";
import { openDocument } from "./open.js";

/** @param {App} app */
export async function openBlank(app) {
  const kind = await kindOf(app.store.document);
  const empty = kind?.empty ?? { kind: "curves", curves: [], matching: { method: "exact", oneToOne: true } };
  return openDocument(app, { directrix: 1, title: strings.untitled, ...empty }, strings.commands.new);
}
