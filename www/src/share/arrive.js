/**
 * Opens what the address says: when the page starts, when another link is put into the address bar, and on the way back and forward.
 * A document opens as an unsaved copy beside everything the person has; a link that is wrong changes nothing.
 *
 * @import { Link } from "../../../js/directrix.js"
 * @import { App, Ui } from "../state/app.js"
 * @import { Session } from "../state/session.js"
 * @import { Kernel } from "../types.js"
 *
 * @typedef {object} Arrival
 * @property {Session | null} session what the page starts with; null where the link leads to no document
 * @property {(app: App) => void} begin called once the page stands
 */
import { readLink } from "../../../js/link.js";
import { find } from "../dom.js";
import { splitView, viewAt } from "../files/document-view.js";
import { openDocument } from "../files/open.js";
import { presetOfAnyKind } from "../kinds/kinds.js";
import { isCurves } from "../state/kind.js";
import { completed } from "../kernel.js";
import { currentTheme } from "../frame/theme.js";
import { problem } from "../painter.js";
import { originOf } from "../state/store.js";
import { takeHash } from "../state/session.js";
import { strings } from "../strings.js";
import { linkAddress } from "./address.js";
import { askForAddress, closeLinkPanel, showLinkProblem } from "./ask-panel.js";
import { look } from "./look.js";
import { words } from "./words.js";

/** Milliseconds in which both events of one way through the history have come. */
const MOMENT = 20;

/** Counts what was asked for, so that only the last counts. */
let turns = 0;

/**
 * What the page starts with.
 * @param {Kernel} kernel
 * @param {Session | null} former what this entry of the history showed before: edits after a link was opened are in it
 * @returns {Promise<Arrival>}
 */
export async function arrive(kernel, former) {
  try {
    const link = read();
    if (link) look(link);
    if (former || !link) {
      takeHash();
      return { session: null, begin: (app) => link && linkAddress(app) };
    }
    if (link.url !== undefined) return { session: null, begin: (app) => ask(app, link) };
    const raw = await rawOf(link);
    if (raw === undefined) {
      takeHash();
      return { session: null, begin: (app) => app.ui.set(modeOf(link)) };
    }
    const { document, ui, place } = await tried(kernel, raw);
    const view = viewAt(place, find("#stage").getBoundingClientRect());
    return {
      session: { document, edited: false, ui: { ...ui, ...view, ...modeOf(link) }, kept: null },
      begin(app) {
        linkAddress(app);
        tell(app, words.opened(document.title || strings.untitled));
      },
    };
  } catch (error) {
    takeHash();
    return { session: null, begin: (app) => showLinkProblem(app, reasonOf(error)) };
  }
}

/**
 * Goes where the address leads now, on a page that stands.
 * @param {App} app
 * @param {Session | null} entry what this entry of the history showed, when the person goes back or forward
 */
export async function follow(app, entry) {
  turns += 1;
  const turn = turns;
  await new Promise((done) => setTimeout(done, MOMENT));
  if (turn !== turns) return;
  closeLinkPanel();
  try {
    const link = entry ? readable() : read();
    lookOf(app, link ?? {});
    if (entry) await goTo(app, entry);
    else if (link?.url !== undefined) return ask(app, link);
    else if (link) {
      const raw = await rawOf(link);
      const opened = raw === undefined ? null : await tried(app.kernel, raw);
      if (turn !== turns) return;
      if (opened) {
        const { title } = opened.document;
        await openDocument(app, raw, title);
        linkAddress(app);
        tell(app, words.opened(title || strings.untitled));
      }
      app.ui.set(modeOf(link));
    }
    takeHash();
  } catch (error) {
    if (turn !== turns) return;
    takeHash();
    showLinkProblem(app, reasonOf(error));
  }
}

/** The link in the address; null where the hash names a lesson or a place of the page, or nothing. @returns {Link | null} */
function read() {
  const { hash } = location;
  const isElsewhere = hash.length < 2 || /^#lesson\b/.test(hash) || document.getElementById(hash.slice(1)) !== null;
  return isElsewhere ? null : readLink(hash);
}

/** The link in the address of an entry that shows its document anyway. */
function readable() {
  try {
    return read() ?? {};
  } catch {
    return {};
  }
}

/**
 * The document that a link carries or names, not checked yet; undefined when it says nothing of one.
 * @param {Link} link
 * @returns {Promise<unknown>}
 */
async function rawOf({ document, preset }) {
  if (preset === undefined) return document;
  const { presetDocument, presets } = await import("../gallery/presets.js");
  if (presets.some(({ id }) => id === preset)) return presetDocument(preset);
  const other = await presetOfAnyKind(preset);
  if (other) return other;
  throw Object.assign(new Error(words.problem.noPreset(preset)), { code: "link", path: "preset" });
}

/**
 * A document from outside, with its curves tried.
 * @param {Kernel} kernel
 * @param {unknown} raw
 */
async function tried(kernel, raw) {
  const found = splitView(await completed(kernel, raw));
  if (isCurves(found.document)) await kernel.fit(found.document, { width: 1, height: 1 });
  return found;
}

/** A step leads to the steps. @param {Link} link @returns {Pick<Ui, "mode" | "step">} */
const modeOf = ({ view, step }) => ({ mode: view ?? (step === undefined ? "figure" : "steps"), step: step ?? 1 });

/** @param {App} app @param {Link} link */
function lookOf(app, link) {
  look(link);
  app.ui.set({ theme: currentTheme() });
}

/** @param {App} app @param {Link} link with an address */
function ask(app, link) {
  const address = link.url ?? "";
  const turn = turns;
  askForAddress(
    app,
    address,
    async (raw) => {
      try {
        const { document } = await tried(app.kernel, raw);
        if (turn !== turns) return null;
        await openDocument(app, raw, document.title);
        app.ui.set(modeOf(link));
        linkAddress(app);
        tell(app, words.ask.opened(document.title || strings.untitled, new URL(address).host));
        return null;
      } catch (error) {
        return reasonOf(error);
      }
    },
    takeHash,
  );
}

/**
 * Back to a document that was left for another, or forward again: as the storage has it, else as the entry has it. An older state of
 * the document that is open is none to go back to; undo is.
 * @param {App} app
 * @param {Session} entry
 */
async function goTo(app, { document, edited, ui, kept }) {
  const { origin } = app.store;
  const { name = "", id = null, stamp = null, file = null, modified = null } = kept ?? {};
  if (name === origin.name || (id !== null && id === origin.id)) return;
  if (id === null || !(await reopened(app, id))) {
    app.store.open(document, edited, originOf({ ...(name ? { name } : {}), id, stamp, file, modified }));
    app.ui.set({ ...ui, playing: false });
  }
  const { mode = "figure", step = 1 } = ui;
  app.ui.set({ mode, step });
  if (location.hash) linkAddress(app);
}

/** @param {App} app @param {string} id */
async function reopened(app, id) {
  try {
    const [{ openKept }, { list }] = await Promise.all([import("../storage/reopen.js"), import("../storage/shelf.js")]);
    const head = (await list()).find((each) => each.id === id && each.deleted === null);
    return head !== undefined && (await openKept(app, head));
  } catch {
    // Storage is closed or broken; the entry has the document as well.
    return false;
  }
}

/** What is wrong with a link, for the person. @param {unknown} error */
function reasonOf(error) {
  const { code, path = "", message } = problem(error);
  const plain = message.replace(/\.$/, "");
  return code === "link" ? words.problem.reason(path, plain) : words.problem.inDocument(path, plain);
}

/** @param {App} app @param {string} text */
function tell(app, text) {
  app.ui.set({ note: { tone: "plain", text } });
  app.say(text);
}
