/**
 * Shapes from elsewhere: text that is no document of ours is read for closed outlines, and a panel offers them.
 *
 * @import { App } from "../state/app.js"
 */
import { refuse } from "../files/open.js";
import { problem } from "../painter.js";
import { hasSpace } from "../state/in-space.js";
import { isCurves, isOf } from "../state/kind.js";
import { strings } from "../strings.js";
import { showShapes } from "./panel.js";
import { words } from "./words.js";

/**
 * Reads the shapes of a text and opens the panel that takes them over. Whatever is wrong with the text, the document stays.
 * @param {App} app
 * @param {string} name of the file it came from, or what stands for one
 * @param {string} text
 * @returns {Promise<boolean>} whether there was anything to offer
 */
export async function importText(app, name, text) {
  const { document } = app.store;
  const isPart = isOf(document, "part");
  if (!isPart && (!isCurves(document) || hasSpace(document))) {
    refuse(app, name, isCurves(document) ? words.inSpace : words.elsewhere);
    return false;
  }
  try {
    const found = await app.kernel.readShapes(text, { format: "auto" });
    if (found.shapes.length === 0) {
      const [first] = found.skipped;
      refuse(app, name, first ? words.onlySkipped(first.name, first.reason, found.skipped.length) : words.nothing);
      return false;
    }
    const isList = !/^[\s\ufeff]*</.test(text);
    const show = isPart ? (await import("../part/shapes/import.js")).showPartImport : showShapes;
    show(app, name, found, isList);
    return true;
  } catch (error) {
    const { path = "", message } = problem(error);
    refuse(app, name, strings.errors.document(path, message));
    return false;
  }
}
