/**
 * The section of a panel that writes what is seen in space as a PNG, or copies it.
 *
 * @import { Size } from "../types.js"
 * @import { PictureWanted } from "./picture-rows.js"
 */
import "../../styles/picture-section.css";
import "../../styles/push.css";
import { segment } from "../controls/choices.js";
import { row } from "../controls/row.js";
import { h } from "../dom.js";
import { copyPng } from "./clipboard.js";
import { download } from "./download.js";
import { pictureRows } from "./picture-rows.js";
import { words } from "./picture-words.js";
import { LARGEST, scaledSize } from "./pictures.js";

const SCALES = /** @type {const} */ (["1", "2", "4"]);
/** What was chosen last, for as long as the page is open. */
const last = { transparent: false };

/**
 * @param {object} options
 * @param {string} options.name before the names of the controls
 * @param {Size} options.size on the screen
 * @param {"light" | "dark"} options.theme
 * @param {() => string} options.file name of the file
 * @param {(wanted: PictureWanted) => Promise<Blob>} options.make
 * @param {(act: () => Promise<string>) => Promise<void>} options.run carries out what a button is for, which returns what is said when it is done
 */
export function pictureSection({ name, size, theme, file, make, run }) {
  /** @type {PictureWanted} */
  const wanted = { ...last, theme, ...scaledSize(size, Number(SCALES[1])) };
  const rows = pictureRows({ name, largest: LARGEST }, change);
  const scale = segment({ label: words.scale, name: `${name}-scale`, choices: SCALES.map((value) => ({ value, text: `${value}×` })) }, (value) => change(scaledSize(size, Number(value))));

  /** @param {Partial<PictureWanted>} patch */
  function change(patch) {
    Object.assign(wanted, patch);
    last.transparent = wanted.transparent;
    rows.set(wanted);
    const same = SCALES.find((each) => scaledSize(size, Number(each)).width === wanted.width && scaledSize(size, Number(each)).height === wanted.height);
    scale.set(same ?? /** @type {any} */ (""));
  }
  change({});

  const button = (/** @type {string} */ act, /** @type {string} */ label, /** @type {() => Promise<string>} */ done) =>
    h("button", { type: "button", class: "push", "data-export": act, onclick: () => void run(done) }, label);
  const save = button("png", words.download, async () => {
    download(await make(wanted), file());
    return words.done(file());
  });
  const copy = button("copy", words.copy, async () => {
    await copyPng(make(wanted));
    return words.copied;
  });
  return h("div", { class: "picture-section" }, h("h3", {}, words.heading), row(words.scale, scale), rows.size, rows.theme, rows.background, h("div", { class: "export-acts" }, save, copy));
}
