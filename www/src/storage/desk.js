/**
 * Writes documents to the browser's storage, and sees to it that no two tabs write the same one: a tab holds a lock on the
 * document it works on, and whoever finds that the stored one is not its own goes on with a copy.
 *
 * @import { App } from "../state/app.js"
 * @import { Origin } from "../state/store.js"
 * @import { CurvesDocument } from "../types.js"
 * @import { Claim } from "./claims.js"
 * @import { Kept } from "./keeper.js"
 *
 * @typedef {object} Snapshot What is to be written, taken at one moment.
 * @property {Origin} origin
 * @property {CurvesDocument} document
 * @property {CurvesDocument} body the document with its view
 * @property {boolean} edited whether it differs from its file
 *
 * @typedef {object} Writing
 * @property {boolean} [saved] the document was just written to its file: this state is kept as a version
 * @property {boolean} [hurried] the page may be gone in a moment: no new thumbnail
 *
 * @typedef {ReturnType<typeof createDesk>} Desk
 */
import { claim } from "./claims.js";
import { Conflict, put, putFile, read } from "./shelf.js";
import { thumbnails } from "./thumbnail.js";
import { token } from "./token.js";
import { words } from "./words.js";

/** Milliseconds that a page waits for its former self, or for a closing tab, to let go of a document. */
const LETTING_GO = 1500;
/** Most characters of a title in the format. */
const LONGEST_TITLE = 200;

/** The page that wrote a stamp. @param {string} stamp */
const writerOf = (stamp) => stamp.split(".", 1)[0] ?? "";

/** The title of a copy, within the length that the format allows. @param {string} title */
export function copyTitle(title) {
  const marked = words.copyOf(title);
  return marked.length > LONGEST_TITLE ? title : marked;
}

/**
 * @param {App} app
 * @param {string} writer the name of this page, for as long as it is not loaded again
 * @param {Kept | null} former what the page kept before a reload
 */
export function createDesk(app, writer, former) {
  const { store } = app;
  /** @type {Map<string, Claim>} */
  const claims = new Map();
  let writes = 0;

  /**
   * Takes a document for this tab.
   * @param {string} id
   * @param {number} [patience] milliseconds
   * @returns {Promise<boolean>} false when another tab has it open
   */
  async function take(id, patience = 0) {
    if (claims.has(id)) return true;
    const taken = await claim(id, patience);
    if (taken.free) claims.set(id, taken);
    return taken.free;
  }

  /**
   * Whether what is stored is what this page wrote or read.
   * @param {Origin} origin
   * @param {string} stamp of what is stored
   * @param {boolean} [first] whether the page looks for the first time
   */
  function isMine({ id, stamp: known }, stamp, first = false) {
    if (stamp === known || writerOf(stamp) === writer) return true;
    // The page before the reload may have written once more while it closed.
    return writerOf(stamp) === former?.writer && (first || claims.get(id ?? "")?.locked === true);
  }

  /**
   * Goes on with a document of its own.
   * @param {Origin} origin
   * @param {(title: string) => string} reason
   */
  function becomeCopy(origin, reason) {
    claims.get(origin.id ?? "")?.release();
    claims.delete(origin.id ?? "");
    Object.assign(origin, { id: null, stamp: null, file: null, handle: null, modified: null });
    if (store.origin !== origin) return;
    const { title } = store.document;
    store.commit({ change: (document) => ({ ...document, title: copyTitle(title) }) });
    const text = reason(title);
    app.ui.set({ note: { tone: "plain", text } });
    app.say(text);
  }

  return {
    take,

    /**
     * After a reload: takes the document again, and learns what the storage has of it.
     * @param {Origin} origin
     */
    async resume(origin) {
      const id = origin.id ?? "";
      if (!(await take(id, LETTING_GO))) {
        becomeCopy(origin, words.openElsewhere);
        return;
      }
      const found = await read(id);
      if (!found || !isMine(origin, found.head.stamp, true)) return;
      origin.stamp = found.head.stamp;
      origin.handle = found.handle;
    },

    /**
     * @param {Snapshot} snapshot
     * @param {Writing} [how]
     */
    async write({ origin, document, body, edited }, { saved = false, hurried = false } = {}) {
      const thumbnail = hurried ? null : await thumbnails(app, document);
      for (;;) {
        const id = (origin.id ??= token());
        try {
          if (!(await take(id, LETTING_GO))) throw new Conflict();
          writes += 1;
          const stamp = `${writer}.${writes}`;
          const mine = (/** @type {string} */ stored) => isMine(origin, stored);
          const { file, modified } = origin;
          await put({ id, document: body, file, modified, edited, thumbnail, stamp, saved, mine });
          origin.stamp = stamp;
          await putFile(id, origin.handle).catch(() => {});
          return;
        } catch (error) {
          if (!(error instanceof Conflict)) throw error;
          becomeCopy(origin, words.changedElsewhere);
          body = { ...body, title: copyTitle(body.title) };
          edited = true;
        }
      }
    },

    /** Lets go of every document but the open one. */
    letGo() {
      for (const [id, { release }] of claims) {
        if (id === store.origin.id) continue;
        release();
        claims.delete(id);
      }
    },
  };
}
