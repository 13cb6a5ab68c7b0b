/**
 * The link in the address bar: put there without touching what the page keeps in the entry of the browser's history, and taken
 * away by the first edit, so that the address never leads to something else than what is shown.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument } from "../types.js"
 */
import { readLink, writeLink } from "../../../js/link.js";
import { takeHash } from "../state/session.js";

/** The document that the address leads to. @type {CurvesDocument | null} */
let linked = null;
/** The hash that leads to it. */
let linkedHash = "";
let watching = false;

/**
 * Puts a hash into the address bar.
 * @param {string} hash empty for none
 */
function put(hash) {
  history.replaceState(history.state, "", hash || location.pathname + location.search);
  takeHash();
}

/**
 * The address leads to the open document from now on.
 * @param {App} app
 * @param {string} [hash] default: the one it has
 */
export function linkAddress(app, hash = location.hash) {
  if (hash !== location.hash) put(hash);
  else takeHash();
  linked = app.store.document;
  linkedHash = location.hash;
  if (watching) return;
  watching = true;
  app.store.subscribe(() => {
    if (linked === null || app.store.document === linked) return;
    linked = null;
    if (location.hash === linkedHash) put(withoutDocument());
  });
}

/** What the hash says of how the page looks, which an edit leaves as it is. */
function withoutDocument() {
  try {
    const { controls, theme } = readLink(location.hash);
    return controls || theme ? writeLink({ controls, theme }) : "";
  } catch {
    return "";
  }
}
