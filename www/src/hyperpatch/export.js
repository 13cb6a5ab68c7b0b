/**
 * The panel Export of a body: its document, its surface, its cells, and its picture.
 *
 * @import { App } from "../state/app.js"
 */
import "../../styles/export.css";
import "../../styles/list.css";
import { h } from "../dom.js";
import { download } from "../files/download.js";
import { fileName } from "../files/names.js";
import { pictureSection } from "../files/picture-section.js";
import { written } from "../files/written.js";
import { openPanel } from "../frame/panel.js";
import { problem } from "../painter.js";
import { bodyOf } from "./document.js";
import { bodyPicture, pictureSize } from "./picture.js";
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
      { type: "button", class: "listed", "data-export": format, onclick: () => void write(format) },
      h("span", { class: "listed-title" }, name),
      h("span", { class: "listed-line" }, line),
    );
  });
  const size = pictureSize();
  const list = h("ul", { class: "listing" }, ...buttons.map((button) => h("li", {}, button)));
  const { theme } = app.ui.value;
  const file = () => `${fileName(bodyOf(app).title)}.png`;
  const picture = size && pictureSection({ name: "body", size, theme, file, make: bodyPicture, run });
  const panel = openPanel({ name: "export", heading: words.exports.heading, body: [list, ...(picture ? [picture] : []), message] });
  if (!panel) return;
  buttons[0].focus();

  /** @param {() => Promise<string>} act what is said when it is done */
  async function run(act) {
    try {
      app.say(await act());
      message.hidden = true;
    } catch (error) {
      message.hidden = false;
      message.textContent = problem(error).message;
    }
  }

  /** @param {Format} format */
  async function write(format) {
    const document = bodyOf(app);
    const name = `${fileName(document.title)}.${format}`;
    await run(async () => {
      const part = format === "json" ? written(/** @type {any} */ (document)) : await (await app.kernel.hyperpatch(document)).file({ format });
      download(new Blob([/** @type {BlobPart} */ (part)]), name);
      return words.exports.done(name);
    });
  }
}
