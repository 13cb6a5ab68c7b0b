/**
 * What this is, which version, and the licences of everything that it carries, as collected at the build.
 *
 * @import { App } from "../state/app.js"
 *
 * @typedef {{name: string, version: string, licence: string, text?: string, textOf?: number}} Part `textOf`: index of the part that has the same text
 */
import "../../styles/about.css";
import { h } from "../dom.js";
import { offline, reload } from "../offline/offline.js";
import { words as offlineWords } from "../offline/words.js";
import { words } from "./about-words.js";
import { openPanel } from "./panel.js";

/** @param {App} app */
export async function openAbout(app) {
  const offlineState = h("div", { class: "offline-state", "aria-live": "polite" });
  const tell = () => offlineState.replaceChildren(...offlineNodes(app));
  const leave = offline.subscribe(tell);
  tell();
  const parts = h("div", { class: "licences", "aria-busy": "true" }, h("p", { class: "note" }, words.loading));
  const shown = openPanel({
    name: "about",
    heading: words.heading,
    wide: true,
    onclose: leave,
    body: [
      h("p", {}, h("strong", {}, words.version(__DIRECTRIX_VERSION__)), " ", words.line),
      h("p", { class: "note" }, words.own),
      offlineState,
      h("h3", {}, words.parts),
      parts,
    ],
  });
  if (!shown) {
    leave();
    return;
  }
  const list = await licences();
  parts.setAttribute("aria-busy", "false");
  if (!list) {
    parts.replaceChildren(h("p", { class: "note" }, words.missing));
    return;
  }
  parts.replaceChildren(
    ...list.map(({ name, version, licence, text, textOf }) =>
      h(
        "details",
        { "data-part": name },
        h("summary", {}, h("span", {}, `${name} ${version}`), h("span", { class: "licence" }, licence)),
        h("pre", { tabIndex: 0 }, text ?? list[textOf ?? -1]?.text),
      ),
    ),
  );
}

/** Whether the page works without a network, and the new version where one waits. @param {App} app @returns {Node[]} */
function offlineNodes(app) {
  const { state, reason, ready, changes } = offline.value;
  const heading = h("h3", {}, offlineWords.heading);
  const standing = h("p", { class: "note", "data-offline": state }, offlineWords.states[state], reason ? ` ${offlineWords.reason(reason)}` : "");
  if (!ready) return [heading, standing];
  return [
    h("h3", {}, offlineWords.ready),
    h(
      "p",
      { class: "note" },
      h("button", { type: "button", class: "outlined", "data-reload": "", onclick: () => void reload(app) }, offlineWords.reload),
      ` ${offlineWords.reloadNote}`,
    ),
    changes.length > 0 ? h("h4", {}, offlineWords.changed) : h("p", { class: "note" }, offlineWords.unlisted),
    ...(changes.length > 0 ? [h("ul", { class: "changes", tabIndex: 0, "aria-label": offlineWords.changed }, ...changes.map((change) => h("li", {}, change)))] : []),
    heading,
    standing,
  ];
}

/** @returns {Promise<Part[] | null>} null where the build has not collected them */
async function licences() {
  try {
    const response = await fetch("./licences.json");
    return response.ok ? await response.json() : null;
  } catch {
    return null;
  }
}
