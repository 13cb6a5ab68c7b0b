/**
 * The panel Export of a problem: its document, its solution on the boundary and on the section, and its picture.
 *
 * @import { App } from "../state/app.js"
 * @import { Offer } from "./picture.js"
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
import { csvOf } from "./compare/csv.js";
import { laboratoryOf } from "./document.js";
import { elementRows, offered, sectionRowsOf } from "./picture.js";
import { words } from "./words.js";

const SCALES = /** @type {const} */ (["1", "2", "4"]);
/** What was chosen last, for as long as the page is open. */
const last = { transparent: false };

/** @param {App} app */
export function showProblemExport(app) {
  const text = words.exports;
  const message = h("p", { class: "lab-note", role: "alert", hidden: true, "data-export-error": "" });
  /** @param {"json" | "elements" | "section"} name @param {string} ending @param {(offer: Offer | null) => string} make */
  const entry = (name, ending, make) =>
    h(
      "button",
      {
        type: "button",
        class: "listed",
        "data-export": name,
        onclick: () =>
          void run(async () => {
            const file = `${fileName(laboratoryOf(app).title)}${ending}`;
            download(new Blob([make(offered())]), file);
            return text.done(file);
          }),
      },
      h("span", { class: "listed-title" }, text[name][0]),
      h("span", { class: "listed-line" }, text[name][1]),
    );
  const buttons = [
    entry("json", ".json", () => written(/** @type {any} */ (laboratoryOf(app)))),
    entry("elements", "-boundary.csv", (offer) => csvOf(elementRows(offer))),
    entry("section", "-section.csv", (offer) => csvOf(sectionRowsOf(offer))),
  ];
  const size = offered()?.size ?? null;
  const list = h("ul", { class: "listing" }, ...buttons.map((button) => h("li", {}, button)));
  const panel = openPanel({ name: "export", heading: text.heading, body: [list, ...(size ? [pictureSection(size)] : []), message] });
  if (!panel) return;
  buttons[0].focus();

  /** The picture as it is seen. @param {import("../types.js").Size} size on the screen */
  function pictureSection(size) {
    /** @type {import("../files/picture-rows.js").PictureWanted} */
    const wanted = { ...last, theme: app.ui.value.theme, ...scaledSize(size, Number(SCALES[1])) };
    const rows = pictureRows({ name: "lab", largest: LARGEST }, change);
    const scale = segment({ label: text.picture.scale, name: "lab-scale", choices: SCALES.map((value) => ({ value, text: `${value}×` })) }, (value) => change(scaledSize(size, Number(value))));

    /** @param {Partial<typeof wanted>} patch */
    function change(patch) {
      Object.assign(wanted, patch);
      last.transparent = wanted.transparent;
      rows.set(wanted);
      const same = SCALES.find((each) => scaledSize(size, Number(each)).width === wanted.width && scaledSize(size, Number(each)).height === wanted.height);
      scale.set(same ?? /** @type {any} */ (""));
    }
    change({});
    const png = async () => {
      const canvas = offered()?.picture(wanted);
      if (!canvas) throw new Error(offered() ? text.tooLarge : text.noPicture);
      return canvas.convertToBlob({ type: "image/png" });
    };
    const button = (/** @type {string} */ name, /** @type {string} */ label, /** @type {() => Promise<string>} */ act) =>
      h("button", { type: "button", class: "push", "data-export": name, onclick: () => void run(act) }, label);
    const save = button("png", text.picture.download, async () => {
      const name = `${fileName(laboratoryOf(app).title)}.png`;
      download(await png(), name);
      return text.done(name);
    });
    const copy = button("copy", text.picture.copy, async () => {
      await copyPng(png());
      return text.picture.copied;
    });
    return h("div", { class: "lab-picture" }, h("h3", {}, text.picture.heading), row(text.picture.scale, scale), rows.size, rows.theme, rows.background, h("div", { class: "export-acts" }, save, copy));
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
}
