/**
 * The presets of a workbench as a list: picture, title, and one line that says why it matters.
 *
 * @import { App } from "../state/app.js"
 * @import { Kind, KindPreset } from "../kinds/kinds.js"
 *
 * @typedef {object} List
 * @property {string} name of the panel
 * @property {{heading: string, open: (title: string) => string}} words
 * @property {readonly KindPreset[]} presets
 * @property {Kind["thumbnail"]} thumbnail
 */
import "../../styles/list.css";
import { h } from "../dom.js";
import { openDocument } from "../files/open.js";
import { openPanel } from "../frame/panel.js";

/** CSS pixels of a picture. */
const SIZE = { width: 84, height: 60 };
const RATIO = 2;

/** A picture of one clear pixel, which keeps the place. */
const NOTHING = "data:image/gif;base64,R0lGODlhAQABAIAAAAAAAP///yH5BAEAAAAALAAAAAABAAEAAAIBRAA7";

/** Pictures of the presets, for as long as the page is open. @type {Map<string, string>} */
const pictures = new Map();

/** @param {App} app @param {List} list */
export function showPresets(app, { name, words, presets, thumbnail }) {
  const images = presets.map(({ id }) => h("img", { alt: "", class: "listed-picture", src: pictures.get(id) ?? NOTHING, ...SIZE }));
  const entries = presets.map(({ id, line, document }, index) =>
    h(
      "button",
      { type: "button", class: "listed", "data-preset": id, onclick: () => void open(document) },
      images[index],
      h("span", { class: "listed-title" }, document.title),
      h("span", { class: "listed-line" }, line),
    ),
  );
  const panel = openPanel({ name, heading: words.heading, body: [h("ul", { class: "listing" }, ...entries.map((entry) => h("li", {}, entry)))] });
  if (!panel) return;
  const { element, close } = panel;

  /** @param {{title: string}} document */
  async function open(document) {
    if (!(await openDocument(app, document, document.title))) return;
    app.say(words.open(document.title));
    close();
  }

  // Without pictures the titles say what there is.
  paint().catch(() => {});

  /** One after the other: what is open goes first. */
  async function paint() {
    for (const [index, { id, document }] of presets.entries()) {
      if (pictures.has(id)) continue;
      pictures.set(id, await thumbnail(app.kernel, document, SIZE, RATIO));
      images[index].src = pictures.get(id) ?? NOTHING;
    }
  }

  element.addEventListener("keydown", (event) => {
    const here = entries.findIndex((entry) => entry === document.activeElement);
    const by = { ArrowDown: 1, ArrowUp: -1, Home: -here, End: entries.length - 1 - here }[event.key];
    if (here < 0 || by === undefined) return;
    event.preventDefault();
    entries[Math.min(entries.length - 1, Math.max(0, here + by))].focus();
  });
  entries[0].focus();
}
