/**
 * The panel Export of a part: its document, its picture, and its fractions on a grid.
 *
 * @import { App } from "../state/app.js"
 * @import { Format, Wanted } from "./files.js"
 */
import "../../styles/export.css";
import "../../styles/push.css";
import { segment } from "../controls/choices.js";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { select } from "../controls/select.js";
import { attribute, h, write } from "../dom.js";
import { fixed, percent } from "../format.js";
import { copyPng } from "../files/clipboard.js";
import { download } from "../files/download.js";
import { fileName } from "../files/names.js";
import { written } from "../files/written.js";
import { openPanel } from "../frame/panel.js";
import { problem } from "../painter.js";
import { partOf } from "./document.js";
import { endingOf, estimated, fileOptions, MOST_MEMORY } from "./files.js";
import { words } from "./words.js";

const FORMATS = /** @type {const} */ (["png", "csv", "vti", "nrrd", "slices", "json"]);
/** Pixels along the longer side at first, and the most that a field takes. */
const FIRST = 1024;
const LONGEST = 65_535;
/** Bytes of a mebibyte. */
const MIB = 1 << 20;
/** Smallest and largest pitch of the field, in document units. */
const PITCH = { min: 1e-6, max: 1e6 };

/** What was chosen last, for as long as the page is open. @type {Wanted} */
let wanted = { format: "png", by: "longer", longer: FIRST, pitch: 0.1, material: null, dither: "none" };

/** @param {App} app */
export async function showPartExport(app) {
  const document = partOf(app);
  const { materials = [], unit = "mm" } = document;
  if (wanted.material !== null && !materials[wanted.material]) wanted = { ...wanted, material: null };
  const over = new AbortController();
  const part = await app.kernel.part(document);
  const text = words.exports;

  const format = segment({ label: text.format, name: "part-format", choices: FORMATS.map((value) => ({ value, text: text.formats[value] })) }, (value) => change({ format: value }));
  const formats = row(text.format, format);
  formats.classList.add("export-formats");
  const longer = numberField({ label: text.longer, name: "part-longer", min: 1, max: LONGEST, step: 64, decimals: 0, whole: true }, { change: (value) => change({ by: "longer", longer: value }) });
  const pitch = numberField(
    { label: text.pitch(unit), name: "part-pitch", min: PITCH.min, max: PITCH.max, step: () => wanted.pitch / 10, decimals: 3 },
    { change: (value) => change({ by: "pitch", pitch: value }) },
  );
  const picture = select(
    { label: text.picture, name: "part-picture", choices: [{ value: "", text: text.colors }, ...materials.map(({ name }, i) => ({ value: String(i), text: text.grey(name) }))] },
    (value) => change({ material: value === "" ? null : Number(value) }),
  );
  const dither = segment(
    { label: text.dither, name: "part-dither", choices: /** @type {const} */ (["none", "diffusion", "blue-noise"]).map((value) => ({ value, text: text.dithers[value] })) },
    (value) => change({ dither: value }),
  );
  const rows = { picture: row(text.picture, picture), dither: row(text.dither, dither), longer: row(text.longer, longer), pitch: row(text.pitch(unit), pitch) };
  /** The rows of each format. @type {{[format in Format]: (keyof typeof rows)[]}} */
  const shown = { png: ["picture", "dither", "longer", "pitch"], slices: ["dither", "longer", "pitch"], csv: ["longer", "pitch"], vti: ["longer", "pitch"], nrrd: ["longer", "pitch"], json: [] };
  const estimate = h("p", { class: "export-note", "data-estimate": "" });
  const note = h("p", { class: "export-note" });
  const message = h("p", { class: "export-message", "data-message": "", hidden: true });
  const button = (/** @type {string} */ name, /** @type {string} */ label, /** @type {() => Promise<string>} */ act) =>
    h("button", { type: "button", class: "push", "data-export": name, onclick: () => void run(act) }, label);
  const save = button("download", text.download, async () => {
    const { format: chosen } = wanted;
    const name = `${fileName(document.title ?? "")}.${endingOf(chosen)}`;
    download(new Blob([chosen === "json" ? written(document) : /** @type {BlobPart} */ (await bytes())]), name);
    return text.done(name);
  });
  const copy = button("copy", text.copy, async () => {
    await copyPng(bytes().then((png) => new Blob([/** @type {BlobPart} */ (png)], { type: "image/png" })));
    return text.copied;
  });

  /** The file that is wanted. */
  function bytes() {
    if (!part.box) throw new Error(text.nothing);
    return part.file(fileOptions(part.box, wanted), { signal: over.signal, onprogress: (share) => tell(text.working(percent(share))) });
  }

  /** @param {Partial<Wanted>} patch */
  function change(patch) {
    wanted = { ...wanted, ...patch };
    const { box } = part;
    if (box && patch.by === undefined) wanted = { ...wanted, by: "longer" };
    if (box) {
      const side = Math.max(box[1][0] - box[0][0], box[1][1] - box[0][1]);
      if (wanted.by === "longer") wanted = { ...wanted, pitch: Number((side / wanted.longer).toPrecision(6)) };
      else wanted = { ...wanted, longer: Math.max(...estimated(document, box, wanted).size) };
    }
    tell(null);
    render();
  }

  function render() {
    format.set(wanted.format);
    longer.set(wanted.longer);
    pitch.set(wanted.pitch);
    picture.set(wanted.material === null ? "" : String(wanted.material));
    dither.set(wanted.dither);
    for (const [name, element] of Object.entries(rows)) element.hidden = !shown[wanted.format].some((each) => each === name);
    copy.hidden = wanted.format !== "png";
    write(note, text.notes[wanted.format]);
    const isRaster = wanted.format !== "json";
    estimate.hidden = !isRaster;
    const found = part.box && isRaster ? estimated(document, part.box, wanted) : null;
    estimate.classList.toggle("failed", isRaster && (!found || found.excess !== null));
    write(estimate, found ? estimateText(found) : text.nothing);
    for (const each of [save, copy]) attribute(each, "aria-disabled", isRaster && (!found || found.excess !== null) ? "true" : null);
  }

  /** @param {ReturnType<typeof estimated>} found */
  function estimateText({ size: [wide, tall], pixels, memory, most, excess }) {
    const whole = text.estimate(fixed(wide, 0), fixed(tall, 0), fixed(pixels, 0), fixed(Math.max(1, memory / MIB), 0));
    if (excess === "pixels") return `${whole} ${text.mostPixels(fixed(most, 0))}`;
    return excess === "memory" ? `${whole} ${text.mostMemory(fixed(MOST_MEMORY / MIB, 0))}` : whole;
  }

  /** @param {string | null} said @param {boolean} [failed] */
  function tell(said, failed = false) {
    message.hidden = said === null;
    message.classList.toggle("failed", failed);
    write(message, said ?? "");
  }

  /** @param {() => Promise<string>} act what is said when it is done */
  async function run(act) {
    if (save.ariaDisabled) return;
    for (const each of [save, copy]) attribute(each, "aria-disabled", "true");
    try {
      const said = await act();
      tell(said);
      app.say(said);
    } catch (error) {
      const { name, message: why } = problem(error);
      if (name !== "AbortError") tell(text.failed(why.replace(/\.$/, "")), true);
    }
    for (const each of [save, copy]) attribute(each, "aria-disabled", null);
    render();
  }

  change({ by: wanted.by });
  const panel = openPanel({
    name: "export",
    heading: text.heading,
    body: [formats, h("div", { class: "export" }, ...Object.values(rows), estimate, note), h("div", { class: "export-acts" }, save, copy), message],
    onclose: () => over.abort(),
  });
  if (panel && !matchMedia("(width < 600px)").matches) save.focus();
}
