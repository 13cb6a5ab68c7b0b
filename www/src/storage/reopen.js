/**
 * Opens what the browser's storage has: a recent document, or a state that it had. Each goes through the same checks as a file.
 *
 * @import { App } from "../state/app.js"
 * @import { FileHandle } from "../files/file-system.js"
 * @import { CurvesDocument } from "../types.js"
 * @import { Head, Version } from "./records.js"
 */
import { openDocument, refuse } from "../files/open.js";
import { copyTitle } from "./desk.js";
import { list, read, readVersion } from "./shelf.js";
import { words } from "./words.js";

/** Milliseconds that a file waits for the storage before it is opened. */
const PATIENCE = 1000;

/**
 * Opens a recent document; as a copy when another tab works on it.
 * @param {App} app
 * @param {Head} head
 * @returns {Promise<boolean>} whether it was opened
 */
export function openKept(app, { id, title }) {
  return app.keeper.between(async (desk) => {
    const free = await desk.take(id);
    const found = await read(id);
    if (!found) {
      refuse(app, title, words.gone);
      return false;
    }
    const { head, body, handle } = found;
    if (!free) {
      const opened = await openDocument(app, renamed(body, copyTitle(title)), title, { edited: true });
      if (opened) tell(app, words.openElsewhere(title));
      return opened;
    }
    const origin = { id, stamp: head.stamp, file: head.file, modified: head.modified, handle };
    return openDocument(app, body, title, { origin, edited: head.edited });
  });
}

/**
 * Opens a state that a document had, as a document of its own: the one it belongs to stays as it is.
 * @param {App} app
 * @param {Head} head
 * @param {Version} version
 * @returns {Promise<boolean>} whether it was opened
 */
export async function openVersion(app, { id, title }, { time }) {
  const body = await readVersion(id, time);
  if (body !== undefined) return openDocument(app, renamed(body, copyTitle(title)), title, { edited: true });
  refuse(app, title, words.gone);
  return false;
}

/**
 * The recent document that a file is about to be opened into: the one which stands in it and has not been edited since,
 * so that opening a file again does not list it twice.
 * @param {App} app
 * @param {string} file its name
 * @param {FileHandle | null} handle
 * @returns {Promise<{id?: string, stamp?: string}>} nothing when there is none, or none is found in time
 */
export async function keptInFile(app, file, handle) {
  const none = /** @type {{id?: string, stamp?: string}} */ ({});
  const search = app.keeper.between(async (desk) => {
    for (const head of await list()) {
      if (head.file !== file || head.edited || head.deleted !== null) continue;
      const found = await read(head.id);
      const same = handle === null ? found?.handle === null : await found?.handle?.isSameEntry(handle);
      if (found && same && (await desk.take(head.id))) return { id: head.id, stamp: found.head.stamp };
    }
    return none;
  });
  const late = new Promise((resolve) => setTimeout(resolve, PATIENCE)).then(() => none);
  return Promise.race([search.catch(() => none), late]);
}

/**
 * A stored document under another title. Whether it is a document at all is checked when it is opened.
 * @param {unknown} body
 * @param {string} title
 */
function renamed(body, title) {
  return typeof body === "object" && body !== null ? { .../** @type {CurvesDocument} */ (body), title } : body;
}

/** @param {App} app @param {string} text */
function tell(app, text) {
  app.ui.set({ note: { tone: "plain", text } });
  app.say(text);
}
