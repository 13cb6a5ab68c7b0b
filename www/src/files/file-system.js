/**
 * Files the page may write to, where the browser lets it: pickers and handles of the File System Access API. Types of the
 * platform leave this part out, because not every browser has it.
 *
 * @typedef {object} PickerOptions
 * @property {string} [suggestedName]
 * @property {{description: string, accept: {[type: string]: string[]}}[]} types
 *
 * @typedef {FileSystemFileHandle & {
 *   queryPermission?: (how: {mode: "readwrite"}) => Promise<PermissionState>,
 *   requestPermission?: (how: {mode: "readwrite"}) => Promise<PermissionState>,
 * }} FileHandle
 *
 * @typedef {object} Pickers
 * @property {(options: PickerOptions) => Promise<FileHandle[]>} [showOpenFilePicker]
 * @property {(options: PickerOptions) => Promise<FileHandle>} [showSaveFilePicker]
 */
import { strings } from "../strings.js";

/** Endings of what can be opened, by kind: documents first. */
const OPENED = {
  "application/json": [".json"],
  "image/svg+xml": [".svg"],
  "text/csv": [".csv"],
  "text/plain": [".txt"],
  "model/stl": [".stl"],
};
const SAVED = { "application/json": [".json"] };

/** The same endings as an input of the page lists them. */
export const ACCEPTED = Object.values(OPENED).flat().join(",");

const pickers = /** @type {Pickers} */ (/** @type {unknown} */ (globalThis));

/**
 * Asks which file to open. Must be called while the browser still counts the person's press.
 * @returns {Promise<FileHandle | null | undefined>} null when the person turned away, undefined where there is no picker
 */
export async function pickToOpen() {
  const types = [{ description: strings.file.openKind, accept: OPENED }];
  return asked(async () => (await pickers.showOpenFilePicker?.({ types }))?.[0]);
}

/**
 * Asks where to save a document. Must be called while the browser still counts the person's press.
 * @param {string} suggestedName
 * @returns {Promise<FileHandle | null | undefined>} null when the person turned away, undefined where there is no picker
 */
export async function pickToSave(suggestedName) {
  const types = [{ description: strings.file.saveKind, accept: SAVED }];
  return asked(async () => pickers.showSaveFilePicker?.({ suggestedName, types }));
}

/**
 * Replaces the content of a file. Rejects when the person or the system does not allow it.
 * @param {FileHandle} handle
 * @param {Blob} blob
 */
export async function writeTo(handle, blob) {
  const how = /** @type {const} */ ({ mode: "readwrite" });
  const state = await handle.queryPermission?.(how);
  if (state === "prompt" || state === "denied") {
    if ((await handle.requestPermission?.(how)) !== "granted") throw new Error(strings.file.notAllowed);
  }
  const writable = await handle.createWritable();
  await writable.write(blob);
  await writable.close();
}

/**
 * What a drop brings: the file, and a handle to it where the browser gives one. Asked for at once, since the browser takes the
 * items back after the event.
 * @param {DataTransfer} transfer
 * @returns {{file: File, handle: Promise<FileHandle | null>} | null}
 */
export function dropped(transfer) {
  const [item] = [...transfer.items].filter(({ kind }) => kind === "file");
  const file = item?.getAsFile() ?? transfer.files[0];
  if (!file) return null;
  const source = /** @type {{getAsFileSystemHandle?: () => Promise<FileSystemHandle | null>}} */ (/** @type {unknown} */ (item));
  const handle = source?.getAsFileSystemHandle?.().then(
    (found) => (found?.kind === "file" ? /** @type {FileHandle} */ (found) : null),
    () => null,
  );
  return { file, handle: handle ?? Promise.resolve(null) };
}

/**
 * @template T
 * @param {() => Promise<T>} ask
 * @returns {Promise<T | null | undefined>}
 */
async function asked(ask) {
  try {
    return await ask();
  } catch (error) {
    const name = error instanceof Error ? error.name : "";
    if (name === "AbortError") return null;
    // A page inside another one may not ask; it then works as where there is no picker.
    if (name === "SecurityError") return undefined;
    throw error;
  }
}
