/**
 * What this is, which version, and the licences of everything that it carries, as collected at the build.
 *
 * @typedef {{name: string, version: string, licence: string, text: string}} Part
 */
import { h } from "../dom.js";
import { words } from "./about-words.js";
import { openPanel } from "./panel.js";

export async function openAbout() {
  const parts = h("div", { class: "licences", "aria-busy": "true" }, h("p", { class: "note" }, words.loading));
  const shown = openPanel({
    name: "about",
    heading: words.heading,
    wide: true,
    body: [
      h("p", {}, h("strong", {}, words.version(__DIRECTRIX_VERSION__)), " ", words.line),
      h("p", { class: "note" }, words.own),
      h("h3", {}, words.parts),
      parts,
    ],
  });
  if (!shown) return;
  const list = await licences();
  parts.setAttribute("aria-busy", "false");
  if (!list) {
    parts.replaceChildren(h("p", { class: "note" }, words.missing));
    return;
  }
  parts.replaceChildren(
    ...list.map(({ name, version, licence, text }) =>
      h(
        "details",
        { "data-part": name },
        h("summary", {}, h("span", {}, `${name} ${version}`), h("span", { class: "licence" }, licence)),
        h("pre", { tabIndex: 0 }, text),
      ),
    ),
  );
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
