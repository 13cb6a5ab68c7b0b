/**
 * The export: format, how it looks, and where it goes.
 *
 * @import { App } from "../state/app.js"
 * @import { Content, Format, Table, Wanted } from "../files/contents.js"
 */
import "../../styles/export.css";
import "../../styles/push.css";
import { words as ofCells } from "../cells/words.js";
import { segment } from "../controls/choices.js";
import { row } from "../controls/row.js";
import { attribute, h, write } from "../dom.js";
import { copyPng, copyText } from "../files/clipboard.js";
import { fileOf, nameOf, textOf } from "../files/contents.js";
import { download } from "../files/download.js";
import { pictureRows } from "../files/picture-rows.js";
import { LARGEST, scaledSize } from "../files/pictures.js";
import { words as flow } from "../harmonic/words.js";
import { kindOf } from "../kinds/kinds.js";
import { problem } from "../painter.js";
import { isHarmonic, lookedAt } from "../state/look.js";
import { words } from "./export-words.js";
import { openPanel } from "./panel.js";


const SCALES = /** @type {const} */ (["1", "2", "4"]);
/** Exports with choices of their own. */
const SECTIONS = {
  morph: async () => (await import("../morph/export-section.js")).createMorphExport,
  solid: async () => (await import("../solid/export-section.js")).createSolidExport,
};
/** The scale a picture has until another is chosen: sharp in a text and on a slide. */
const FIRST_SCALE = "2";

/**
 * What was chosen last, for as long as the page is open; `section`: the export with a section of its own, where that was one.
 * @type {{format: Format, table: Table, content: Content, transparent: boolean, section: keyof typeof SECTIONS | null}}
 */
const last = { format: "png", table: "lines", content: "document", transparent: false, section: null };

/** @param {App} app */
export async function showExport(app) {
  const kind = await kindOf(app.store.document);
  if (kind) return kind.showExport(app);
  const { size } = app.ui.value;
  /** @type {Wanted} */
  const wanted = {
    ...{ format: last.format, table: last.table, content: last.content, transparent: last.transparent, theme: app.ui.value.theme },
    ...scaledSize(size, Number(FIRST_SCALE)),
  };

  const format = segment(
    {
      label: words.format,
      name: "export-format",
      choices: /** @type {const} */ (["png", "svg", "csv", "json", "morph", "solid"]).map((value) => ({
        value,
        text: value === "morph" || value === "solid" ? words[value] : value.toUpperCase(),
      })),
    },
    (value) => (value === "morph" || value === "solid" ? void showSection(value) : change({ format: value })),
  );
  const scale = segment(
    { label: words.scale, name: "export-scale", choices: SCALES.map((value) => ({ value, text: `${value}×` })) },
    (value) => change(scaledSize(app.ui.value.size, Number(value))),
  );
  const picture = pictureRows({ name: "export", largest: LARGEST }, change);
  const table = segment(
    {
      label: words.table,
      name: "export-table",
      choices: /** @type {const} */ (["lines", "stages", "cells"]).map((value) => ({
        value,
        text: value === "cells" ? ofCells.table : words.tables[value],
      })),
    },
    (value) => change({ table: value }),
  );
  const content = segment(
    {
      label: ofCells.content,
      name: "export-content",
      choices: /** @type {const} */ (["document", "cells"]).map((value) => ({ value, text: ofCells.contents[value] })),
    },
    (value) => change({ content: value }),
  );

  /** What needs ruling lines, with the reason that it is not to be had without. @type {[HTMLElement, string, string][]} */
  const needsLines = [
    [format.element, "solid", flow.noSolid],
    [table.element, "cells", flow.noCells],
    [content.element, "cells", flow.noCells],
  ];
  const rows = {
    scale: row(words.scale, scale),
    size: picture.size,
    theme: picture.theme,
    background: picture.background,
    table: row(words.table, table),
    content: row(ofCells.content, content),
  };
  /** The rows of each format. @type {{[format in Format]: (keyof typeof rows)[]}} */
  const shown = { png: ["scale", "size", "theme", "background"], svg: ["theme", "background"], csv: ["table"], json: ["content"] };

  const note = h("p", { class: "export-note" });
  const message = h("p", { class: "export-message", "data-message": "", hidden: true });
  const button = (/** @type {string} */ name, /** @type {string} */ text, /** @type {() => Promise<string>} */ act) =>
    h("button", { type: "button", class: "push", "data-export": name, onclick: () => void run(act) }, text);
  const save = button("download", words.download, async () => {
    const name = nameOf(app, wanted);
    download(await fileOf(app, { ...wanted }), name);
    return words.downloaded(name);
  });
  const copy = button("copy", words.copy, async () => {
    if (wanted.format === "png") await copyPng(fileOf(app, { ...wanted }));
    else await copyText(textOf(app, { ...wanted }));
    return words.copied;
  });

  /** The export that stands in for the rest. @type {import("../morph/export-section.js").Section | null} */
  let section = null;

  /** @param {keyof typeof SECTIONS} name */
  async function showSection(name) {
    last.section = name;
    const create = await SECTIONS[name]();
    if (!place.isConnected || last.section !== name) return;
    section?.close();
    section = create(app);
    place.replaceChildren(section.element);
    still.hidden = true;
  }

  /** @param {Partial<Wanted>} patch */
  function change(patch) {
    place.replaceChildren();
    still.hidden = false;
    last.section = null;
    Object.assign(wanted, patch);
    Object.assign(last, { format: wanted.format, table: wanted.table, content: wanted.content, transparent: wanted.transparent });
    tell(null);
    render();
  }

  function render() {
    const isFlow = isHarmonic(lookedAt(app));
    for (const [group, value, why] of needsLines) bar(group, value, isFlow ? why : null);
    for (const value of /** @type {const} */ (["lines", "stages"])) {
      const word = /** @type {HTMLElement} */ (table.element.querySelector(`[value=${value}] + span`));
      write(word, isFlow ? flow.tables[value] : words.tables[value]);
    }
    if (isFlow && wanted.table === "cells") wanted.table = "lines";
    if (isFlow && wanted.content === "cells") wanted.content = "document";
    format.set(wanted.format);
    const same = SCALES.find((each) => {
      const { width: w, height: h } = scaledSize(app.ui.value.size, Number(each));
      return w === wanted.width && h === wanted.height;
    });
    scale.set(same ?? /** @type {any} */ (""));
    picture.set(wanted);
    table.set(wanted.table);
    content.set(wanted.content);
    for (const [name, element] of Object.entries(rows)) {
      element.hidden = !shown[wanted.format].some((each) => each === name);
    }
    const own = isFlow && wanted.format === "csv" && wanted.table !== "cells" ? flow.tableNotes[wanted.table] : noteOf(wanted);
    write(note, own);
  }

  /** @param {string | null} text @param {boolean} [failed] */
  function tell(text, failed = false) {
    message.hidden = text === null;
    message.classList.toggle("failed", failed);
    write(message, text ?? "");
    if (text !== null) app.say(text);
  }

  /** @param {() => Promise<string>} act */
  async function run(act) {
    const buttons = [save, copy];
    if (save.ariaDisabled) return;
    for (const each of buttons) each.setAttribute("aria-disabled", "true");
    tell(null);
    try {
      tell(await act());
    } catch (error) {
      tell(words.failed(problem(error).message.replace(/\.$/, "")), true);
    }
    for (const each of buttons) each.removeAttribute("aria-disabled");
  }

  const still = h(
    "div",
    {},
    h("div", { class: "export" }, ...Object.values(rows), note),
    h("div", { class: "export-acts" }, save, copy),
    message,
  );
  const place = h("div", {});
  const formats = row(words.format, format);
  formats.classList.add("export-formats");
  render();
  const panel = openPanel({
    name: "export",
    heading: words.heading,
    body: [formats, still, place],
    onclose: () => section?.close(),
  });
  if (last.section === "solid" && isHarmonic(lookedAt(app))) last.section = null;
  if (panel && last.section) {
    format.set(last.section);
    void showSection(last.section);
    return;
  }
  // Enter once more downloads; on a phone the choices above would leave the screen.
  if (panel && !matchMedia("(width < 600px)").matches) save.focus();
}

/**
 * Bars one choice, and says why, or gives it free.
 * @param {HTMLElement} group
 * @param {string} value
 * @param {string | null} why
 */
function bar(group, value, why) {
  const input = /** @type {HTMLInputElement} */ (group.querySelector(`[value=${value}]`));
  input.disabled = why !== null;
  const label = /** @type {HTMLElement} */ (input.parentElement);
  label.classList.toggle("barred", why !== null);
  attribute(label, "title", why);
}

/** @param {Wanted} wanted */
function noteOf({ format, table, content }) {
  if (format === "csv") return table === "cells" ? ofCells.notes.csv : words.notes[table];
  return format === "json" && content === "cells" ? ofCells.notes.json : words.notes[format];
}
