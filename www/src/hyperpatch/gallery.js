/**
 * The presets of the workbench as a list: picture, title, and one line that says why it matters.
 *
 * @import { App } from "../state/app.js"
 */
import { h } from "../dom.js";
import { openDocument } from "../files/open.js";
import { openPanel } from "../frame/panel.js";
import { bodies } from "./presets.js";
import { words } from "./words.js";

/** CSS pixels of a picture. */
const SIZE = { width: 84, height: 60 };
const RATIO = 2;

/** A picture of one clear pixel, which keeps the place. */
const NOTHING = "data:image/gif;base64,R0lGODlhAQABAIAAAAAAAP///yH5BAEAAAAALAAAAAABAAEAAAIBRAA7";

/** Pictures of the presets, for as long as the page is open. @type {Map<string, string>} */
const pictures = new Map();

/** @param {App} app */
export function showBodies(app) {
  const images = bodies.map(({ id }) => h("img", { alt: "", class: "body-preset-picture", src: pictures.get(id) ?? NOTHING, ...SIZE }));
  const entries = bodies.map(({ id, line, document }, index) =>
    h(
      "button",
      { type: "button", class: "body-preset", "data-preset": id, onclick: () => void open(document) },
      images[index],
      h("span", { class: "body-preset-title" }, document.title),
      h("span", { class: "body-preset-line" }, line),
    ),
  );
  const panel = openPanel({ name: "bodies", heading: words.gallery.heading, body: [h("ul", { class: "body-presets" }, ...entries.map((entry) => h("li", {}, entry)))] });
  if (!panel) return;
  const { element, close } = panel;

  /** @param {{title: string}} document */
  async function open(document) {
    if (!(await openDocument(app, document, document.title))) return;
    app.say(words.gallery.open(document.title));
    close();
  }

  // Without pictures the titles say what there is.
  paint().catch(() => {});

  /** One after the other: what is open goes first. */
  async function paint() {
    const { bodyThumbnail } = await import("./thumbnail.js");
    for (const [index, { id, document }] of bodies.entries()) {
      if (pictures.has(id)) continue;
      pictures.set(id, await bodyThumbnail(app.kernel, /** @type {any} */ (document), SIZE, RATIO));
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
