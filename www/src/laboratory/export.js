/**
 * The panel Export of a problem: its document, its solution on the boundary and on the section, and its picture.
 *
 * @import { App } from "../state/app.js"
 * @import { Offer } from "./picture.js"
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
import { csvOf } from "./compare/csv.js";
import { laboratoryOf } from "./document.js";
import { elementRows, offered, problemPicture, sectionRowsOf } from "./picture.js";
import { words } from "./words.js";

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
  const { theme } = app.ui.value;
  const file = () => `${fileName(laboratoryOf(app).title)}.png`;
  const picture = size && pictureSection({ name: "lab", size, theme, file, make: problemPicture, run });
  const panel = openPanel({ name: "export", heading: text.heading, body: [list, ...(picture ? [picture] : []), message] });
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
}
