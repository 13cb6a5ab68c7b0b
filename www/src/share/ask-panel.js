/**
 * Asks before a document is fetched from the address in a link, and says what became of it; and tells what was wrong with a link.
 *
 * @import { App } from "../state/app.js"
 * @import { Panel } from "../frame/panel.js"
 */
import { h, write } from "../dom.js";
import { openPanel } from "../frame/panel.js";
import { problem } from "../painter.js";
import { fetchDocument } from "./remote.js";
import { words } from "./words.js";

/** @type {Panel | null} */
let shown = null;

/** Closes what an earlier link has shown. */
export function closeLinkPanel() {
  shown?.close();
}

/**
 * @param {App} app
 * @param {string} text
 */
export function showLinkProblem(app, text) {
  closeLinkPanel();
  const w = words.problem;
  shown = openPanel({
    name: "link",
    heading: w.heading,
    body: [h("p", { class: "link-problem", "data-link-problem": "" }, text), h("p", { class: "share-note" }, w.about)],
    onclose: () => (shown = null),
  });
  app.say(`${w.heading}. ${text}`);
}

/**
 * @param {App} app
 * @param {string} address
 * @param {(raw: unknown) => Promise<string | null>} open opens what was fetched; gives what is wrong with it
 * @param {() => void} ondeclined called when the panel is closed and nothing was opened
 */
export function askForAddress(app, address, open, ondeclined) {
  closeLinkPanel();
  const w = words.ask;
  const { host } = new URL(address);
  let opened = false;
  let aborter = new AbortController();
  const message = h("p", { class: "link-problem", "data-link-problem": "", hidden: true });
  const agree = h("button", { type: "button", class: "solid", "data-ask": "agree", onclick: () => void run() }, w.agree);
  const decline = h("button", { type: "button", class: "outlined", "data-ask": "decline", onclick: () => panel?.close() }, w.decline);

  async function run() {
    if (agree.ariaDisabled) return;
    agree.setAttribute("aria-disabled", "true");
    write(agree, w.fetching);
    message.hidden = true;
    aborter = new AbortController();
    const { signal } = aborter;
    /** @type {string | null} */
    let wrong;
    try {
      wrong = await open(await fetchDocument(address, signal));
    } catch (error) {
      wrong = problem(error).message;
    }
    if (signal.aborted) return;
    agree.removeAttribute("aria-disabled");
    write(agree, w.again);
    if (wrong === null) {
      opened = true;
      panel?.close();
      return;
    }
    write(message, wrong);
    message.hidden = false;
    app.say(wrong);
  }

  const panel = openPanel({
    name: "link",
    heading: w.heading,
    body: [
      h("p", {}, w.about(host)),
      h("p", { class: "link-address", role: "group", "aria-label": w.address, "data-link-address": "" }, address),
      message,
      h("div", { class: "share-acts" }, agree, decline),
    ],
    onclose: () => {
      shown = null;
      aborter.abort();
      if (!opened) ondeclined();
    },
  });
  shown = panel;
  app.say(w.about(host));
}
