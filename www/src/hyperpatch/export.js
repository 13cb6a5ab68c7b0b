/**
 * The panel Export of a body: its document, its surface, its cells, and its picture.
 *
 * @import { App } from "../state/app.js"
 */
import "../../styles/export.css";
import "../../styles/list.css";
import "../../styles/push.css";
import { segment } from "../controls/choices.js";
import { row } from "../controls/row.js";
import { h } from "../dom.js";
import { copyPng } from "../files/clipboard.js";
import { download } from "../files/download.js";
import { fileName } from "../files/names.js";
import { pictureRows } from "../files/picture-rows.js";
import { LARGEST, scaledSize } from "../files/pictures.js";
import { written } from "../files/written.js";
import { openPanel } from "../frame/panel.js";
import { problem } from "../painter.js";
import { bodyOf } from "./document.js";
import { bodyPicture, pictureSize } from "./picture.js";
import { words } from "./words.js";

/** @typedef {keyof typeof words.exports.formats} Format */

const SCALES = /** @type {const} */ (["1", "2", "4"]);
/** What was chosen last, for as long as the page is open. */
const last = { transparent: false };

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
  const panel = openPanel({ name: "export", heading: words.exports.heading, body: [list, ...(size ? [pictureSection(size)] : []), message] });
  if (!panel) return;
  buttons[0].focus();

  /** The picture as it is seen. @param {import("../types.js").Size} size on the screen */
  function pictureSection(size) {
    const text = words.exports.picture;
    /** @type {import("../files/picture-rows.js").PictureWanted} */
    const wanted = { ...last, theme: app.ui.value.theme, ...scaledSize(size, Number(SCALES[1])) };
    const rows = pictureRows({ name: "body", largest: LARGEST }, change);
    const scale = segment({ label: text.scale, name: "body-scale", choices: SCALES.map((value) => ({ value, text: `${value}×` })) }, (value) => change(scaledSize(size, Number(value))));

    /** @param {Partial<typeof wanted>} patch */
    function change(patch) {
      Object.assign(wanted, patch);
      last.transparent = wanted.transparent;
      rows.set(wanted);
      const same = SCALES.find((each) => scaledSize(size, Number(each)).width === wanted.width && scaledSize(size, Number(each)).height === wanted.height);
      scale.set(same ?? /** @type {any} */ (""));
    }
    change({});
    const button = (/** @type {string} */ name, /** @type {string} */ label, /** @type {() => Promise<string>} */ act) =>
      h("button", { type: "button", class: "push", "data-export": name, onclick: () => void run(act) }, label);
    const save = button("png", text.download, async () => {
      const name = `${fileName(bodyOf(app).title)}.png`;
      download(await bodyPicture(wanted), name);
      return words.exports.done(name);
    });
    const copy = button("copy", text.copy, async () => {
      await copyPng(bodyPicture(wanted));
      return text.copied;
    });
    return h("div", { class: "body-picture" }, h("h3", {}, text.heading), row(text.scale, scale), rows.size, rows.theme, rows.background, h("div", { class: "export-acts" }, save, copy));
  }

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
