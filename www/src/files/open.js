/**
 * Opens documents: from a file, from text, or as an object. Whatever is wrong with them, the open one stays.
 *
 * @import { App } from "../state/app.js"
 * @import { Origin } from "../state/store.js"
 *
 * @typedef {object} OpenOptions
 * @property {Partial<Origin>} [origin] where the document lives; nowhere yet when it is not given
 * @property {boolean} [edited] whether it differs from its file
 * @property {boolean} [foreign] whether it comes from outside: its curves are then tried as well, while what this browser kept is
 *   shown as it was left
 */
import { completed } from "../kernel.js";
import { problem } from "../painter.js";
import { isCurves } from "../state/kind.js";
import { only, within } from "../state/selection.js";
import { originOf } from "../state/store.js";
import { strings } from "../strings.js";
import { splitView, viewAt } from "./document-view.js";
import { words } from "./words.js";

/**
 * Opens a document that has not been checked.
 * @param {App} app
 * @param {unknown} raw
 * @param {string} name for the message
 * @param {OpenOptions} [options]
 * @returns {Promise<boolean>} whether it was opened
 */
export async function openDocument(app, raw, name, { origin, edited = false, foreign = false } = {}) {
  try {
    const { document, ui, place } = splitView(await completed(app.kernel, raw));
    if (!isCurves(document)) {
      // A mode of the curves is left before its document is.
      app.ui.set({ mode: "figure" });
      await new Promise(requestAnimationFrame);
    } else if (foreign) await app.kernel.fit(document, { width: 1, height: 1 });
    app.store.open(document, edited, originOf(origin));
    const { size } = app.ui.value;
    app.ui.set({
      ...ui,
      step: 1,
      selection: isCurves(document) ? within(only(1, 0), document) : null,
      probe: null,
      witness: null,
      note: null,
      playing: false,
      ...viewAt(place, size),
    });
    return true;
  } catch (error) {
    const { path = "", message } = problem(error);
    refuse(app, name, strings.errors.document(path, message));
    return false;
  }
}

/**
 * Opens the text of a document, or offers the shapes of a text that is none.
 * @param {App} app
 * @param {string} name of the file it came from, or what stands for one
 * @param {string} text
 * @param {OpenOptions} [options]
 * @returns {Promise<boolean>} whether it was opened
 */
export async function openText(app, name, text, options) {
  let raw;
  if (/^[\s\ufeff]*[{[]/.test(text)) {
    try {
      raw = JSON.parse(text.replace(/^\ufeff/, ""));
    } catch (error) {
      refuse(app, name, `${words.notJson} (${problem(error).message})`);
      return false;
    }
    if (isDocument(raw)) return openDocument(app, raw, name, { ...options, foreign: true });
  }
  const { importText } = await import("../import/import.js");
  return importText(app, name, text);
}

/**
 * Whether JSON is meant to be a document of ours rather than points: an object that says so, or nothing else either.
 * @param {unknown} raw
 */
function isDocument(raw) {
  if (typeof raw !== "object" || raw === null || Array.isArray(raw)) return false;
  return "directrix" in raw || !("points" in raw || "type" in raw || "shapes" in raw);
}

/**
 * Opens a file of the person's machine.
 * @param {App} app
 * @param {File} file
 * @param {import("./file-system.js").FileHandle | null} [handle] to save to
 * @returns {Promise<boolean>} whether it was opened
 */
export async function openFile(app, file, handle = null) {
  if (isStl(file)) return (await import("../laboratory/stl-document.js")).openStlDocument(app, file);
  let text;
  try {
    text = await file.text();
  } catch (error) {
    refuse(app, file.name, problem(error).message);
    return false;
  }
  const { name, lastModified: modified } = file;
  const { keptInFile } = await import("../storage/reopen.js");
  const origin = { ...(await keptInFile(app, name, handle)), file: name, handle, modified };
  const opened = await openText(app, name, text, { origin });
  if (opened && app.store.origin.file === name) void app.keeper.keep();
  return opened;
}

/** Whether a file is meant to be an STL. @param {{name: string}} file */
export const isStl = ({ name }) => /\.stl$/i.test(name);

/**
 * Says why something was not opened.
 * @param {App} app
 * @param {string} name
 * @param {string} reason
 */
export function refuse(app, name, reason) {
  const text = words.notOpened(name, reason.replace(/\.$/, ""));
  app.ui.set({ note: { tone: "error", text } });
  app.say(text);
}
