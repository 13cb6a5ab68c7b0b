/**
 * The documents in the browser's storage: list, read, write, delete and restore.
 *
 * @import { CurvesDocument } from "../types.js"
 * @import { FileHandle } from "../files/file-system.js"
 * @import { Head } from "./records.js"
 */
import { answer, transact } from "./database.js";
import { beginning, bodyKey, fileKey, headKey, HEADS, isHead, VERSION, versionKey, versionsOf } from "./records.js";
import { expired, replaced, saved } from "./versions.js";

/** The stored document is not the one that the page knows: another tab, or another version of the page, wrote it since. */
export class Conflict extends Error {}

/**
 * All documents, the newest first, deleted ones too. What is past its time in the bin goes.
 * @returns {Promise<Head[]>}
 */
export async function list() {
  const found = await transact("readonly", (store) => answer(store.getAll(beginning(HEADS))));
  const heads = found.filter(isHead);
  const gone = expired(heads, Date.now());
  for (const { id } of gone) await erase(id);
  return heads.filter((head) => !gone.includes(head)).sort((a, b) => b.time - a.time);
}

/**
 * @param {string} id
 * @returns {Promise<{head: Head, body: unknown, handle: FileHandle | null} | null>} null when there is none; the body has not
 *   been checked
 */
export async function read(id) {
  const [head, body, handle] = await transact("readonly", (store) =>
    Promise.all([headKey(id), bodyKey(id), fileKey(id)].map((key) => answer(store.get(key)))),
  );
  if (!isHead(head)) return null;
  const usable = typeof handle?.createWritable === "function";
  return { head, body, handle: usable ? handle : null };
}

/**
 * @typedef {object} Entry
 * @property {string} id
 * @property {CurvesDocument} document with its view
 * @property {string | null} file
 * @property {number | null} modified
 * @property {boolean} edited
 * @property {Head["thumbnail"]} thumbnail null keeps the one that is there
 * @property {string} stamp of this write
 * @property {boolean} saved whether the document was just written to its file
 * @property {(stamp: string) => boolean} mine whether the stored document is the one that the page wrote or read
 *
 * Writes a document, all of it or nothing, and takes it out of the bin.
 * @param {Entry} entry
 * @returns {Promise<void>} rejects with `Conflict` when the stored document is not the page's own
 */
export function put({ id, document, file, modified, edited, thumbnail, stamp, saved: filed, mine }) {
  return transact("readwrite", async (store) => {
    const found = await answer(store.get(headKey(id)));
    if (found !== undefined && !(isHead(found) && mine(found.stamp))) throw new Conflict();
    const now = Date.now();
    const past = isHead(found) ? found : null;
    let versions = past?.versions ?? [];
    if (past) {
      const change = replaced(past, now);
      if (change.keep) store.put(await answer(store.get(bodyKey(id))), versionKey(id, past.time));
      for (const { time } of change.drop) store.delete(versionKey(id, time));
      versions = change.versions;
    }
    if (filed) {
      const change = saved(versions, now);
      for (const { time } of change.drop) store.delete(versionKey(id, time));
      store.put(document, versionKey(id, now));
      versions = change.versions;
    }
    /** @type {Head} */
    const head = {
      version: VERSION,
      id,
      title: document.title,
      file,
      modified,
      edited,
      born: past?.born ?? now,
      time: now,
      deleted: null,
      stamp,
      thumbnail: thumbnail ?? past?.thumbnail ?? null,
      versions,
    };
    store.put(document, bodyKey(id));
    store.put(head, headKey(id));
  });
}

/**
 * Remembers the file of a document, or forgets it. A browser may refuse to keep a handle; Save then asks again.
 * @param {string} id
 * @param {FileHandle | null} handle
 */
export function putFile(id, handle) {
  return transact("readwrite", async (store) => {
    if (handle) await answer(store.put(handle, fileKey(id)));
    else await answer(store.delete(fileKey(id)));
  });
}

/**
 * @param {string} id
 * @param {number} time
 * @returns {Promise<unknown>} a state that the document had; undefined when there is none
 */
export function readVersion(id, time) {
  return transact("readonly", (store) => answer(store.get(versionKey(id, time))));
}

/** Puts a document into the bin. @param {string} id */
export const remove = (id) => setDeleted(id, Date.now());

/** Takes a document out of the bin. @param {string} id */
export const restore = (id) => setDeleted(id, null);

/** Deletes a document for good, with all it had. @param {string} id */
export function erase(id) {
  return transact("readwrite", async (store) => {
    for (const key of [headKey(id), bodyKey(id), fileKey(id)]) store.delete(key);
    await answer(store.delete(beginning(versionsOf(id))));
  });
}

/** @param {string} id @param {number | null} deleted */
function setDeleted(id, deleted) {
  return transact("readwrite", async (store) => {
    const head = await answer(store.get(headKey(id)));
    if (isHead(head)) await answer(store.put({ ...head, deleted }, headKey(id)));
  });
}
