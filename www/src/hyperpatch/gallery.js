/**
 * The presets of the workbench as a list: title, and one line that says why it matters.
 *
 * @import { App } from "../state/app.js"
 */
import { h } from "../dom.js";
import { openDocument } from "../files/open.js";
import { openPanel } from "../frame/panel.js";
import { bodies } from "./presets.js";
import { words } from "./words.js";

/** @param {App} app */
export function showBodies(app) {
  const entries = bodies.map(({ id, line, document }) =>
    h(
      "button",
      { type: "button", class: "body-preset", "data-preset": id, onclick: () => void open(document) },
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

  element.addEventListener("keydown", (event) => {
    const here = entries.findIndex((entry) => entry === document.activeElement);
    const by = { ArrowDown: 1, ArrowUp: -1, Home: -here, End: entries.length - 1 - here }[event.key];
    if (here < 0 || by === undefined) return;
    event.preventDefault();
    entries[Math.min(entries.length - 1, Math.max(0, here + by))].focus();
  });
  entries[0].focus();
}
