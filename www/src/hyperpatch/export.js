/**
 * The panel Export of a body: its document, its surface, its cells.
 *
 * @import { App } from "../state/app.js"
 */
import { h } from "../dom.js";
import { download } from "../files/download.js";
import { fileName } from "../files/names.js";
import { written } from "../files/written.js";
import { openPanel } from "../frame/panel.js";
import { problem } from "../painter.js";
import { bodyOf } from "./document.js";
import { words } from "./words.js";

/** @typedef {keyof typeof words.exports.formats} Format */

const FORMATS = /** @type {const} */ (["json", "stl", "ply", "obj", "vtu"]);

/** @param {App} app */
export function showBodyExport(app) {
  const message = h("p", { class: "body-note", role: "alert", hidden: true, "data-export-error": "" });
  const buttons = FORMATS.map((format) => {
    const [name, line] = words.exports.formats[format];
    return h(
      "button",
      { type: "button", class: "body-preset", "data-export": format, onclick: () => void write(format) },
      h("span", { class: "body-preset-title" }, name),
      h("span", { class: "body-preset-line" }, line),
    );
  });
  const panel = openPanel({ name: "export", heading: words.exports.heading, body: [h("ul", { class: "body-exports" }, ...buttons.map((button) => h("li", {}, button))), message] });
  if (!panel) return;
  buttons[0].focus();

  /** @param {Format} format */
  async function write(format) {
    const document = bodyOf(app);
    const name = `${fileName(document.title)}.${format}`;
    try {
      const part = format === "json" ? written(/** @type {any} */ (document)) : await (await app.kernel.hyperpatch(document)).file({ format });
      download(new Blob([/** @type {BlobPart} */ (part)]), name);
      message.hidden = true;
      app.say(words.exports.done(name));
    } catch (error) {
      message.hidden = false;
      message.textContent = problem(error).message;
    }
  }
}
