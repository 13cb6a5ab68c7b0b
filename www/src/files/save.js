/**
 * Saves the open document: to its own file where the browser can write there, else as a download.
 *
 * @import { App } from "../state/app.js"
 * @import { Origin } from "../state/store.js"
 * @import { FileHandle } from "./file-system.js"
 */
import { problem } from "../painter.js";
import { documentWithView } from "./document-view.js";
import { download } from "./download.js";
import { pickToSave, writeTo } from "./file-system.js";
import { fileName } from "./names.js";
import { words } from "./words.js";
import { written } from "./written.js";

/**
 * Save: the next one goes to the same file without a question.
 * @param {App} app
 * @returns {Promise<boolean>} whether the document stands in a file now
 */
export async function save(app) {
  const { document, origin } = app.store;
  if (origin.handle && (await changedOutside(origin))) {
    tell(app, "error", words.changedOutside(origin.handle.name));
    return false;
  }
  const place = await write(app, origin.handle);
  if (!place) return false;
  if (app.store.origin === origin) {
    Object.assign(origin, place);
    app.store.kept(document);
    void app.keeper.flush({ saved: true });
  }
  tell(app, "plain", words.saved(place.file));
  return true;
}

/**
 * Whether the file of a document is not as the page left it. Told once: the next Save replaces it.
 * @param {Origin} origin
 */
async function changedOutside(origin) {
  const modified = await lastModified(origin.handle);
  if (modified === null || origin.modified === null || modified === origin.modified) return false;
  origin.modified = modified;
  return true;
}

/**
 * When a file was last changed; null when that cannot be told.
 * @param {FileHandle | null} handle
 */
async function lastModified(handle) {
  try {
    return (await handle?.getFile())?.lastModified ?? null;
  } catch {
    return null;
  }
}

/**
 * Save a copy: the document stays with the file it has, and counts as edited as before.
 * @param {App} app
 * @returns {Promise<boolean>} whether a copy was written
 */
export async function saveCopy(app) {
  const place = await write(app, null);
  if (place) tell(app, "plain", words.copied(place.file));
  return place !== null;
}

/**
 * @param {App} app
 * @param {FileHandle | null} known where to write; null asks
 * @returns {Promise<Pick<Origin, "file" | "handle" | "modified"> & {file: string} | null>} null when nothing was written
 */
async function write(app, known) {
  const name = `${fileName(app.store.document.title)}.json`;
  const blob = new Blob([written(documentWithView(app))], { type: "application/json" });
  try {
    const handle = known ?? (await pickToSave(name));
    if (handle === null) return null;
    if (handle === undefined) {
      download(blob, name);
      return { file: name, handle: null, modified: null };
    }
    await writeTo(handle, blob);
    return { file: handle.name, handle, modified: await lastModified(handle) };
  } catch (error) {
    tell(app, "error", words.notSaved(known?.name ?? name, problem(error).message.replace(/\.$/, "")));
    return null;
  }
}

/** @param {App} app @param {"plain" | "error"} tone @param {string} text */
function tell(app, tone, text) {
  app.ui.set({ note: { tone, text } });
  app.say(text);
}
