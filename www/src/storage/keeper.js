/**
 * When the open document is kept in the browser's storage: a pause after the last edit, never during a drag, and at once when
 * another document takes its place. Where the storage fails the page says so once and goes on.
 *
 * @import { App } from "../state/app.js"
 * @import { Origin } from "../state/store.js"
 * @import { CurvesDocument } from "../types.js"
 * @import { Desk, Writing } from "./desk.js"
 *
 * @typedef {object} Keeper
 * @property {() => Kept} kept what a reload must know of the storage
 * @property {(how?: Writing) => Promise<void>} flush writes at once what is not written yet
 * @property {() => Promise<void>} keep writes the open document although nobody edited it
 * @property {(listener: () => void) => void} subscribe is told when the open document has been kept
 * @property {<T>(work: (desk: Desk) => Promise<T>) => Promise<T>} between runs work on the storage between two writes
 *
 * @typedef {object} Kept
 * @property {string} [name] of the opening
 * @property {string | null} id
 * @property {string | null} file
 * @property {number | null} modified
 * @property {string | null} stamp
 * @property {string} writer
 * @property {boolean} safe whether the document needs no more keeping as it stands
 */
import { documentWithView } from "../files/document-view.js";
import { strings } from "../strings.js";
import { token } from "./token.js";

/** Milliseconds of rest before the work is kept. */
const PAUSE = 800;
/** A run of edits that rests so long, with no button pressed, is over: keys and focused fields leave theirs open. */
const RESTING = 1500;

/**
 * @param {App} app
 * @param {Kept | null} former what the page kept before a reload
 * @returns {Keeper}
 */
export function createKeeper(app, former) {
  const { store } = app;
  const writer = token();
  /** @type {{origin: Origin, document: CurvesDocument, edited: boolean}} */
  let open = { origin: store.origin, document: store.document, edited: store.edited };
  /** @type {CurvesDocument | null} the document that needs no keeping as it stands */
  let safe = former?.safe === false ? null : open.document;
  let lastEdit = 0;
  let pressed = false;
  let told = false;
  /** @type {Set<() => void>} */
  const listeners = new Set();
  let waiting = 0;
  /** @type {Promise<unknown>} */
  let queue = Promise.resolve();
  /** @type {Promise<Desk> | null} */
  let desk = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  /** What does the writing, loaded when there is something to write. */
  function atDesk() {
    desk ??= import("./desk.js").then(({ createDesk }) => createDesk(app, writer, former));
    desk.catch(() => (desk = null));
    return desk;
  }

  /** @type {Keeper["between"]} */
  function between(work) {
    waiting += 1;
    const result = queue
      .then(async () => work(await atDesk()))
      .finally(async () => {
        waiting -= 1;
        if (waiting === 0) (await desk)?.letGo();
      });
    queue = result.catch(() => {});
    return result;
  }

  /** @param {Writing} [how] */
  async function write(how) {
    const { origin, document, edited } = open;
    // At once, so that a page that is loaded again in this moment knows the name.
    origin.id ??= token();
    const snapshot = { origin, document, edited, body: documentWithView(app, document) };
    try {
      await between((at) => at.write(snapshot, how));
      if (open.document === document) safe = document;
      told = false;
      app.ui.set({ unkept: false });
      for (const listener of listeners) listener();
    } catch (error) {
      app.ui.set({ unkept: true });
      if (told) return;
      told = true;
      const text = strings.storage.problem(error instanceof Error ? error.name : "");
      app.ui.set({ note: { tone: "error", text } });
      app.say(text);
    }
  }

  /** @type {Keeper["flush"]} */
  async function flush(how = {}) {
    clearTimeout(timer);
    if (open.document !== safe || how.saved) await write(how);
  }

  function later() {
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (pressed || (store.running && performance.now() - lastEdit < RESTING)) later();
      else void flush();
    }, PAUSE);
  }

  store.subscribe(() => {
    const { origin, document, edited } = store;
    if (origin !== open.origin) {
      void flush();
      // A preset that is only looked at is not kept.
      safe = edited && origin.stamp === null ? null : document;
    }
    const changed = document !== open.document;
    open = { origin, document, edited };
    if (!changed || document === safe) return;
    lastEdit = performance.now();
    later();
  });

  for (const [type, down] of /** @type {const} */ ([["pointerdown", true], ["pointerup", false], ["pointercancel", false]])) {
    addEventListener(type, () => (pressed = down), { capture: true });
  }
  document.addEventListener("visibilitychange", () => {
    if (document.hidden) void flush();
  });
  addEventListener("pagehide", () => void flush({ hurried: true }));
  addEventListener("beforeunload", (event) => {
    if (!open.edited || open.document === safe) return;
    void flush({ hurried: true });
    event.preventDefault();
  });

  if (open.origin.id !== null) void between((at) => at.resume(open.origin)).catch(() => {});
  if (open.document !== safe) later();

  return {
    kept: () => ({
      name: open.origin.name,
      id: open.origin.id,
      file: open.origin.file,
      modified: open.origin.modified,
      stamp: open.origin.stamp,
      writer,
      safe: open.document === safe,
    }),
    flush,
    keep: () => write(),
    subscribe: (listener) => void listeners.add(listener),
    between,
  };
}
