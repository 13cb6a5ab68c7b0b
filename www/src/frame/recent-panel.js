/**
 * The recent documents: open, delete, restore, and earlier states of each.
 *
 * @import { App } from "../state/app.js"
 * @import { Head } from "../storage/records.js"
 */
import "../../styles/recent.css";
import { h } from "../dom.js";
import { icon } from "../icons.js";
import { claimed } from "../storage/claims.js";
import { openKept, openVersion } from "../storage/reopen.js";
import { erase, list, remove, restore } from "../storage/shelf.js";
import { strings } from "../strings.js";
import { openPanel } from "./panel.js";
import { words } from "./recent-words.js";
import { moment, when } from "./when.js";

/** @param {App} app */
export async function showRecent(app) {
  const message = h("div", { class: "recent-message", hidden: true, "data-message": "" });
  const documents = h("ul", { class: "recent-list" });
  const empty = h("p", { class: "recent-note", hidden: true }, words.empty);
  const bin = h("ul", { class: "recent-list" });
  const binned = h("section", { "aria-labelledby": "recent-bin", hidden: true, "data-bin": "" },
    h("h3", { id: "recent-bin", class: "recent-heading" }, words.deleted), bin);
  const panel = openPanel({
    name: "recent",
    heading: words.heading,
    body: [message, documents, empty, binned, h("p", { class: "recent-note" }, words.where)],
  });
  if (!panel) return;
  /** The documents whose versions are shown. @type {Set<string>} */
  const unfolded = new Set();
  documents.addEventListener("keydown", walk);
  // What is not kept yet belongs into the list, unless the storage does not take it anyway.
  if (!app.ui.value.unkept) await app.keeper.flush();
  await refresh();

  /**
   * Reads the storage again and draws what it has.
   * @param {string} [focus] selector of what takes the focus
   */
  async function refresh(focus) {
    try {
      const [heads, elsewhere] = await Promise.all([list(), claimed()]);
      const kept = heads.filter(({ deleted }) => deleted === null);
      const gone = heads.filter(({ deleted }) => deleted !== null).sort((a, b) => Number(b.deleted) - Number(a.deleted));
      documents.replaceChildren(...kept.map((head) => row(head, elsewhere.has(head.id))));
      bin.replaceChildren(...gone.map(binRow));
      empty.hidden = kept.length > 0;
      binned.hidden = gone.length === 0;
    } catch (error) {
      say(strings.storage.problem(error instanceof Error ? error.name : ""));
      return;
    }
    if (focus) /** @type {HTMLElement | null} */ (panel?.element.querySelector(focus))?.focus();
  }

  /**
   * Says what was done, with a way back where there is one.
   * @param {string} text
   * @param {{text: string, act: () => void}} [back]
   */
  function say(text, back) {
    const button = back
      ? h("button", { type: "button", class: "command-word", "data-undo": "", onclick: back.act }, back.text)
      : null;
    message.replaceChildren(h("span", {}, text), ...(button ? [button] : []));
    message.hidden = false;
    app.say(text);
  }

  /**
   * Does something to the storage and draws it anew.
   * @param {() => Promise<unknown>} work
   * @param {() => void} [done]
   * @param {string} [focus]
   */
  async function change(work, done, focus) {
    try {
      await work();
    } catch (error) {
      say(strings.storage.problem(error instanceof Error ? error.name : ""));
      return;
    }
    done?.();
    await refresh(focus);
  }

  /** @param {() => Promise<boolean>} work */
  async function open(work) {
    try {
      if (await work()) panel?.close();
    } catch (error) {
      say(strings.storage.problem(error instanceof Error ? error.name : ""));
    }
  }

  /** @param {Head} head @param {boolean} held whether some tab has it open */
  function row(head, held) {
    const { id, title, versions } = head;
    const here = app.store.origin.id === id;
    const state = here ? words.here : held ? words.elsewhere : null;
    const line = [when(head.time, Date.now()), head.file ?? words.noFile, state].filter((each) => each !== null);
    const opener = h(
      "button",
      {
        type: "button",
        class: "recent-open",
        "data-open": "",
        onclick: () => (here ? panel?.close() : void open(() => openKept(app, head))),
      },
      ...picture(head),
      text(title, line.join(" · ")),
    );
    const past = h(
      "button",
      {
        type: "button",
        class: "bare icon-only",
        "aria-label": words.versionsOf(title),
        title: words.versionsOf(title),
        "aria-expanded": String(unfolded.has(id)),
        "data-versions": "",
        onclick: () => {
          if (!unfolded.delete(id)) unfolded.add(id);
          void refresh(`[data-document="${id}"] [data-versions]`);
        },
      },
      icon(unfolded.has(id) ? "down" : "right", 14),
    );
    const away = h(
      "button",
      {
        type: "button",
        class: "bare icon-only",
        "aria-label": words.delete(title),
        title: words.delete(title),
        disabled: here,
        "data-delete": "",
        onclick: () => void put(head),
      },
      icon("cross", 14),
    );
    return h(
      "li",
      { "data-document": id },
      h("div", { class: "recent-row" }, opener, versions.length > 0 ? past : null, away),
      unfolded.has(id) ? states(head) : null,
    );
  }

  /** Into the bin, and back if it was a slip. @param {Head} head */
  async function put({ id, title }) {
    const back = () => void change(() => restore(id), () => say(words.restored(title)), `[data-document="${id}"] button`);
    await change(() => remove(id), () => say(words.gone(title), { text: words.undo, act: back }));
    /** @type {HTMLElement | null} */ (message.querySelector("button"))?.focus();
  }

  /** @param {Head} head */
  function states(head) {
    const items = [...head.versions].reverse().map((version) =>
      h(
        "li",
        {},
        h(
          "button",
          {
            type: "button",
            class: "recent-version",
            "data-version": version.time,
            onclick: () => void open(() => openVersion(app, head, version)),
          },
          h("span", { class: "number" }, moment(version.time)),
          h("span", { class: "menu-line" }, words.kinds[version.kind]),
        ),
      ),
    );
    return h("ul", { class: "recent-versions", "aria-label": words.versionsOf(head.title) }, ...items);
  }

  /** @param {Head} head */
  function binRow(head) {
    const { id, title } = head;
    const button = (/** @type {string} */ name, /** @type {string} */ word, /** @type {() => void} */ act) =>
      h(
        "button",
        { type: "button", class: "command-word", "data-bin-act": name, "aria-label": `${word}: ${title}`, onclick: act },
        word,
      );
    return h(
      "li",
      { "data-document": id },
      h(
        "div",
        { class: "recent-open" },
        ...picture(head),
        h(
          "div",
          {},
          text(title, words.since(when(head.deleted ?? 0, Date.now()))),
          button("restore", words.restore, () =>
            void change(() => restore(id), () => say(words.restored(title)), `[data-document="${id}"] button`)),
          button("erase", words.erase, () =>
            void change(() => erase(id), () => say(words.erased(title)), "[data-bin] button, [data-open], h2")),
        ),
      ),
    );
  }

  /** Arrows go through the list, Delete deletes. @param {KeyboardEvent} event */
  function walk(event) {
    const openers = /** @type {HTMLElement[]} */ ([...documents.querySelectorAll("[data-open]")]);
    const focused = document.activeElement?.closest("[data-document]");
    const here = openers.findIndex((each) => focused?.contains(each));
    if (here < 0) return;
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step !== undefined) openers[Math.min(openers.length - 1, Math.max(0, here + step))]?.focus();
    else if (event.key === "Delete") /** @type {HTMLElement | null} */ (focused?.querySelector("[data-delete]"))?.click();
    else return;
    event.preventDefault();
  }
}

/** Both pictures of a document; the style sheet shows the one of the theme. @param {Head} head */
function picture({ thumbnail }) {
  const themes = /** @type {const} */ (["light", "dark"]);
  if (!thumbnail) return [h("span", { class: "recent-picture" })];
  return themes.map((theme) => h("img", { class: `recent-picture on-${theme}`, src: thumbnail[theme], alt: "" }));
}

/** @param {string} title @param {string} line */
function text(title, line) {
  return h("span", { class: "menu-text" }, h("span", { class: "recent-title" }, title), h("span", { class: "menu-line" }, line));
}
