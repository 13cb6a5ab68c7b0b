/**
 * The open document and its command log.
 *
 * A document is never changed in place: an edit builds the next one and the log keeps both. Pointer, keyboard, number
 * fields and menus all end in `commit`, so undo sees one kind of edit.
 *
 * @import { CurvesDocument } from "../types.js"
 *
 * @typedef {object} Edit
 * @property {(document: CurvesDocument) => CurvesDocument} change
 *   Pure. Returns the same object when there is nothing to do.
 * @property {string} [run]
 *   Edits that follow each other with the same name are one entry of the log: one drag, one sweep of a slider.
 *
 * @typedef {{run: string | null, before: CurvesDocument, after: CurvesDocument}} Entry
 *
 * @typedef {object} Origin Where the open document lives; one object for as long as it is open.
 * @property {string} name of this opening, which a reload keeps
 * @property {string | null} id the name under which the browser's storage keeps it; null until it is kept
 * @property {string | null} stamp of what the storage has, as the page last wrote or read it
 * @property {string | null} file the name of the file it stands in
 * @property {import("../files/file-system.js").FileHandle | null} handle that file, where the page may write to it
 * @property {number | null} modified when the file was last changed, as far as the page knows, in milliseconds of the epoch
 */
import { token } from "../storage/token.js";

/**
 * The origin of a document that stands nowhere yet.
 * @param {Partial<Origin>} [known]
 * @returns {Origin}
 */
export function originOf(known = {}) {
  return { id: null, stamp: null, file: null, handle: null, modified: null, ...known, name: known.name ?? token() };
}

export class Store {
  /** @type {CurvesDocument} */ #document;
  /** @type {CurvesDocument} */ #kept;
  /** @type {Entry[]} */ #past = [];
  /** @type {Entry[]} */ #future = [];
  /** @type {string | null} */ #run = null;
  /** @type {Origin} */ #origin = originOf();
  /** @type {Set<() => void>} */ #listeners = new Set();

  /** @param {CurvesDocument} document */
  constructor(document) {
    this.#document = document;
    this.#kept = document;
  }

  get document() {
    return this.#document;
  }

  get origin() {
    return this.#origin;
  }

  /** Whether a drag or another run of edits is under way. */
  get running() {
    return this.#run !== null;
  }

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  /** Whether the document differs from the one that was opened or last written to a file. */
  get edited() {
    return this.#document !== this.#kept;
  }

  /** @param {Edit} edit */
  commit({ change, run }) {
    const before = this.#document;
    const after = change(before);
    if (after === before) return;
    const last = this.#past.at(-1);
    if (run !== undefined && run === this.#run && last) {
      this.#past[this.#past.length - 1] = { ...last, after };
    } else {
      this.#past.push({ run: run ?? null, before, after });
    }
    this.#run = run ?? null;
    this.#future = [];
    this.#become(after);
  }

  /** Closes a run, so that the next edit is an entry of its own. */
  endRun() {
    this.#run = null;
  }

  /**
   * Takes back a run that is still open and leaves no trace of it in the log.
   * @param {string} run
   * @returns {boolean} whether there was one
   */
  cancel(run) {
    if (this.#run !== run) return false;
    const last = this.#past.pop();
    this.#run = null;
    if (!last) return false;
    this.#become(last.before);
    return true;
  }

  undo() {
    const entry = this.#past.pop();
    if (!entry) return;
    this.#future.push(entry);
    this.#run = null;
    this.#become(entry.before);
  }

  redo() {
    const entry = this.#future.pop();
    if (!entry) return;
    this.#past.push(entry);
    this.#run = null;
    this.#become(entry.after);
  }

  /**
   * Replaces everything: a preset or a file was opened.
   * @param {CurvesDocument} document
   * @param {boolean} [edited] whether it counts as edited from the start (a reload of edited work)
   * @param {Origin} [origin] nowhere when it is not given
   */
  open(document, edited = false, origin = originOf()) {
    this.#past = [];
    this.#future = [];
    this.#run = null;
    this.#kept = edited ? { ...document } : document;
    this.#origin = origin;
    this.#become(document);
  }

  /**
   * A document was written to a file.
   * @param {CurvesDocument} [document] the one that was, when the open one may have gone on since
   */
  kept(document = this.#document) {
    this.#kept = document;
    this.#tell();
  }

  /**
   * @param {() => void} listener
   * @returns {() => void} ends the listening
   */
  subscribe(listener) {
    this.#listeners.add(listener);
    return () => void this.#listeners.delete(listener);
  }

  /** @param {CurvesDocument} document */
  #become(document) {
    this.#document = document;
    this.#tell();
  }

  #tell() {
    for (const listener of this.#listeners) listener();
  }
}
