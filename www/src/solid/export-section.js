/**
 * The export of the solid, a part of the export panel: as triangles for other programs, and as a picture.
 *
 * @import { App } from "../state/app.js"
 * @import { SolidColor } from "./state.js"
 *
 * @typedef {"stl" | "ply" | "obj" | "png"} SolidFormat
 */
import "../../styles/solid.css";
import { checkBox, segment } from "../controls/choices.js";
import { row } from "../controls/row.js";
import { select } from "../controls/select.js";
import { h, write } from "../dom.js";
import { copyPng } from "../files/clipboard.js";
import { download } from "../files/download.js";
import { fileName } from "../files/names.js";
import { pictureRows } from "../files/picture-rows.js";
import { LARGEST, scaledSize } from "../files/pictures.js";
import { problem } from "../painter.js";
import { lackOf, reasonOf } from "./raise.js";
import { colorOf, rowsOf, solidUi } from "./state.js";
import { words } from "./words.js";

/** How much larger than the screen a picture is at first. */
const SCALE = 2;
const TYPES = { stl: "model/stl", ply: "application/octet-stream", obj: "model/obj" };

/** What was chosen last, for as long as the page is open. @type {{kind: SolidFormat, transparent: boolean}} */
const last = { kind: "stl", transparent: false };

/** @param {App} app */
export function createSolidExport(app) {
  const { color, layers } = solidUi(app);
  const wanted = {
    ...last,
    color,
    caps: layers.includes("caps"),
    theme: app.ui.value.theme,
    ...scaledSize(app.ui.value.size, SCALE),
  };
  let isBusy = false;
  const text = words.exports;

  const kind = segment(
    {
      label: text.kind,
      name: "solid-format",
      choices: /** @type {const} */ (["stl", "ply", "obj", "png"]).map((value) => ({ value, text: text.kinds[value] })),
    },
    (value) => change({ kind: value }),
  );
  const colors = select(
    {
      label: text.color,
      name: "solid-export-color",
      choices: /** @type {const} */ (["material", "fraction", "twist", "flank"]).map((value) => ({ value, text: words.show.colors[value] })),
    },
    (value) => change({ color: /** @type {SolidColor} */ (value) }),
  );
  const caps = checkBox({ name: "solid-export-caps", text: [text.closed] }, (on) => change({ caps: on }));
  const picture = pictureRows({ name: "solid", largest: LARGEST }, change);
  const rows = {
    color: row(text.color, colors),
    caps: row(text.caps, caps),
    size: picture.size,
    theme: picture.theme,
    background: picture.background,
  };
  /** @type {{[kind in SolidFormat]: (keyof typeof rows)[]}} */
  const shown = { stl: ["caps"], ply: ["color", "caps"], obj: ["color", "caps"], png: ["size", "theme", "background"] };
  const note = h("p", { class: "export-note" });
  const message = h("p", { class: "export-message", "data-message": "solid", hidden: true });
  const save = h("button", { type: "button", class: "push", "data-solid-export": "", onclick: () => void run(saved) }, text.download);
  const copy = h("button", { type: "button", class: "push", "data-solid-copy": "", onclick: () => void run(copied) }, text.copy);
  const element = h("div", {}, row(text.kind, kind), h("div", { class: "export" }, ...Object.values(rows), note), h("div", { class: "export-acts" }, save, copy), message);

  /** @param {Partial<typeof wanted>} patch */
  function change(patch) {
    Object.assign(wanted, patch);
    Object.assign(last, { kind: wanted.kind, transparent: wanted.transparent });
    tell(null);
    render();
  }

  function render() {
    kind.set(wanted.kind);
    colors.set(wanted.color);
    caps.set(wanted.caps);
    picture.set(wanted);
    for (const [name, element] of Object.entries(rows)) element.hidden = !shown[wanted.kind].some((each) => each === name);
    const lack = lackOf(app.store.document);
    write(note, lack ?? text.notes[wanted.kind]);
    copy.hidden = wanted.kind !== "png";
    for (const each of [save, copy]) {
      if (isBusy || lack !== null) each.setAttribute("aria-disabled", "true");
      else each.removeAttribute("aria-disabled");
    }
  }

  /** @param {string | null} line @param {boolean} [failed] */
  function tell(line, failed = false) {
    message.hidden = line === null;
    message.classList.toggle("failed", failed);
    write(message, line ?? "");
    if (line !== null) app.say(line);
  }

  async function saved() {
    const name = `${fileName(app.store.document.title)}.${wanted.kind}`;
    download(await made({ ...wanted }), name);
    return text.downloaded(name);
  }

  async function copied() {
    await copyPng(made({ ...wanted }));
    return text.copied;
  }

  /** @param {() => Promise<string>} act what is said when it is done */
  async function run(act) {
    if (save.ariaDisabled) return;
    isBusy = true;
    tell(null);
    render();
    try {
      tell(await act());
    } catch (error) {
      tell(text.failed(problem(error).message.replace(/\.$/, "")), true);
    }
    isBusy = false;
    render();
  }

  /** @param {typeof wanted} now @returns {Promise<Blob>} */
  async function made(now) {
    const { document } = app.store;
    const options = { color: colorOf({ ...solidUi(app), color: now.kind === "png" ? solidUi(app).color : now.color }, document.materials.length), stages: rowsOf(document) };
    const solid = await app.kernel.solid(document, options);
    const { bounds } = solid;
    if (!solid.ok || !bounds) throw new Error(reasonOf(await app.kernel.match(document)));
    if (now.kind === "png") return (await import("./picture.js")).solidPicture(app, { ...solid, bounds }, now);
    const bytes = await app.kernel.solidFile(document, { ...options, caps: now.caps, format: now.kind });
    return new Blob([/** @type {Uint8Array<ArrayBuffer>} */ (bytes)], { type: TYPES[now.kind] });
  }

  const stop = app.store.subscribe(render);
  render();
  return { element, render, close: stop };
}
