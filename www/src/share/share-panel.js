/**
 * The panel Share: the link to the editor, the link to the figure alone, and what puts the figure into a page. Opening it puts the
 * first of them into the address bar.
 *
 * @import { Link } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 */
import "../../styles/share.css";
import { segment } from "../controls/choices.js";
import { row } from "../controls/row.js";
import { h, write } from "../dom.js";
import { copyText } from "../files/clipboard.js";
import { documentWithView } from "../files/document-view.js";
import { download } from "../files/download.js";
import { fileName } from "../files/names.js";
import { written } from "../files/written.js";
import { openPanel } from "../frame/panel.js";
import { problem } from "../painter.js";
import { writeLink } from "../../../js/link.js";
import { linkAddress } from "./address.js";
import { addressOf, linkTo, LONGEST } from "./made.js";
import { elementCode, frameCode } from "./snippets.js";
import { words } from "./words.js";

/** Milliseconds of rest after an edit until the links are made anew. */
const PAUSE = 200;
/** Milliseconds for which a button says that it has copied. */
const COPIED = 2000;

/** @typedef {"editor" | "view" | "embed"} Tab */

/** What was chosen last, for as long as the page is open. */
const chosen = {
  tab: /** @type {Tab} */ ("editor"),
  controls: /** @type {"full" | "minimal" | "none"} */ ("minimal"),
  theme: /** @type {"auto" | "light" | "dark"} */ ("auto"),
  reveal: /** @type {"auto" | "interaction"} */ ("auto"),
  code: /** @type {"element" | "iframe"} */ ("element"),
  size: /** @type {import("./snippets.js").Size} */ ("column"),
};

/** @param {App} app */
export function showShare(app) {
  /** @type {Awaited<ReturnType<typeof linkTo>> | null} null until it is made */
  let made = null;
  let failure = "";
  let turn = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let copiedTimer;

  const choice = (/** @type {keyof typeof chosen} */ name, /** @type {string} */ label, /** @type {{[value: string]: string}} */ texts) =>
    segment({ label, name: `share-${name}`, choices: Object.entries(texts).map(([value, text]) => ({ value, text })) }, (value) => {
      Object.assign(chosen, { [name]: value });
      tell(null);
      write(copy, words.copy);
      render();
    });
  const choices = {
    tab: choice("tab", words.tabs, { editor: words.editor, view: words.view, embed: words.embed }),
    code: choice("code", words.code, words.codes),
    size: choice("size", words.size, words.sizes),
    controls: choice("controls", words.controls, words.allControls),
    theme: choice("theme", words.theme, words.allThemes),
    reveal: choice("reveal", words.start, words.allStarts),
  };
  const rows = {
    code: row(words.code, choices.code),
    size: row(words.size, choices.size),
    controls: row(words.controls, choices.controls),
    theme: row(words.theme, choices.theme),
    reveal: row(words.start, choices.reveal),
  };
  /** The rows of each tab. @type {{[tab in Tab]: (keyof typeof rows)[]}} */
  const shown = { editor: [], view: ["controls", "theme"], embed: ["code", "size", "controls", "theme", "reveal"] };

  const about = h("p", { class: "share-note" });
  const field = h("textarea", { class: "share-field", readOnly: true, spellcheck: false, "data-share-text": "", onfocus: () => field.select() });
  const note = h("p", { class: "share-note", "data-share-note": "" });
  const long = h("p", { class: "share-note share-long", "data-share-long": "" });
  const steps = h("ol", { class: "share-steps" }, ...words.host.map((text) => h("li", {}, text)));
  const copy = h("button", { type: "button", class: "solid", "data-share": "copy", onclick: () => void run() }, words.copy);
  const save = h("button", { type: "button", class: "outlined", "data-share": "download", onclick: saveFile }, words.download);
  const message = h("p", { class: "share-message", "data-message": "", hidden: true });

  /** The name of the file that the document goes into. */
  const file = () => `${fileName(app.store.document.title)}.json`;

  /** What a tab shares. @returns {{text: string, link: string, file: boolean}} `file`: the document has to be shared as a file besides */
  function content() {
    const { tab, controls, theme, reveal, code, size } = chosen;
    const { title, ...target } = /** @type {NonNullable<typeof made>} */ (made);
    /** @type {Link} */
    const look = {
      ...(tab === "editor" || controls === "full" ? {} : { controls }),
      ...(tab === "editor" || theme === "auto" ? {} : { theme }),
      ...(tab !== "embed" || reveal === "auto" ? {} : { reveal }),
    };
    const page = addressOf(tab === "editor" ? "editor" : "view");
    let link = `${page}${writeLink({ ...target, ...look })}`;
    const isLong = link.length > LONGEST;
    const { document: _document, ...rest } = target;
    if (isLong) link = `${page}${writeLink({ ...rest, ...look, url: `https://example.org/${file()}` })}`;
    const element = tab === "embed" && code === "element";
    const text = element
      ? elementCode({ ...rest, ...look, ...(target.preset ? {} : { src: file() }) }, size, title || words.figure)
      : tab === "embed"
        ? frameCode(link, size, title || words.figure)
        : link;
    return { text, link, file: element ? target.preset === undefined : isLong };
  }

  function render() {
    const { tab } = chosen;
    for (const [name, control] of Object.entries(choices)) control.set(/** @type {any} */ (chosen[/** @type {keyof typeof chosen} */ (name)]));
    for (const [name, element] of Object.entries(rows)) element.hidden = !shown[tab].some((each) => each === name);
    field.setAttribute("aria-label", words.label[tab]);
    field.classList.toggle("code", tab === "embed");
    const isReady = made !== null && failure === "";
    for (const button of [copy, save]) {
      if (isReady) button.removeAttribute("aria-disabled");
      else button.setAttribute("aria-disabled", "true");
    }
    if (failure) tell(words.failed(failure), true);
    if (!made || failure) return;
    const { text, link, file: needsFile } = content();
    const isElement = tab === "embed" && chosen.code === "element";
    const isLong = needsFile && !isElement;
    if (field.value !== text) field.value = text;
    const whole = `${addressOf(tab === "editor" ? "editor" : "view")}${writeLink(targetOf(made))}`.length;
    write(about, tab === "editor" && !isLong ? `${words.about.editor} ${words.inBar}` : words.about[tab]);
    const { view } = made;
    const opensAt = view === "steps" ? words.mode.steps(made.step ?? 0) : view === undefined || view === "figure" ? "" : words.mode[view];
    const length = isElement
      ? needsFile
        ? words.place(file())
        : ""
      : made.preset
        ? words.short(link.length, made.title)
        : words.whole(link.length);
    write(note, [isLong ? "" : length, opensAt].filter(Boolean).join(" "));
    note.hidden = note.textContent === "";
    long.hidden = !isLong;
    steps.hidden = !isLong;
    write(long, words.tooLong(whole, LONGEST));
    save.hidden = !needsFile;
  }

  /** Makes the links anew, and brings the address bar up to date. */
  async function make() {
    turn += 1;
    const now = turn;
    const document = app.store.document;
    try {
      const found = await linkTo(app);
      if (now !== turn || document !== app.store.document) return;
      made = found;
      failure = "";
      const hash = writeLink(targetOf(found));
      if (addressOf("editor").length + hash.length <= LONGEST) linkAddress(app, hash);
    } catch (error) {
      if (now !== turn) return;
      failure = problem(error).message.replace(/\.$/, "");
    }
    render();
  }

  function later() {
    clearTimeout(timer);
    timer = setTimeout(() => void make(), PAUSE);
  }

  /** @param {string | null} text @param {boolean} [failed] */
  function tell(text, failed = false) {
    message.hidden = text === null;
    message.classList.toggle("failed", failed);
    write(message, text ?? "");
    if (text !== null) app.say(text);
  }

  async function run() {
    if (copy.ariaDisabled) return;
    const { tab } = chosen;
    try {
      await copyText(Promise.resolve(field.value));
      tell(words.copiedAll[tab]);
      write(copy, words.copied);
      clearTimeout(copiedTimer);
      copiedTimer = setTimeout(() => write(copy, words.copy), COPIED);
    } catch {
      field.focus();
      field.select();
      tell(words.notCopied, true);
    }
  }

  function saveFile() {
    if (save.ariaDisabled) return;
    const blob = new Blob([written(documentWithView(app))], { type: "application/json" });
    download(blob, file());
    tell(words.downloaded(file()));
  }

  const panel = openPanel({
    name: "share",
    heading: words.heading,
    tall: true,
    body: [
      h("div", { class: "share-tabs" }, choices.tab.element),
      about,
      h("div", { class: "share-rows" }, ...Object.values(rows)),
      long,
      steps,
      field,
      note,
      h("div", { class: "share-acts" }, copy, save),
      message,
    ],
    onclose: () => {
      turn += 1;
      clearTimeout(timer);
      clearTimeout(copiedTimer);
      leaveStore();
      leaveUi();
    },
  });
  if (!panel) return;
  const leaveStore = app.store.subscribe(later);
  const leaveUi = app.ui.subscribe((now, before) => {
    const parts = /** @type {const} */ (["mode", "step", "layers", "s", "isoMaterial", "view", "fitted"]);
    if (!now.playing && parts.some((part) => now[part] !== before[part])) later();
  });
  render();
  void make();
}

/** What a link leads to, without its title. @param {Awaited<ReturnType<typeof linkTo>>} made @returns {Link} */
function targetOf({ title: _title, ...target }) {
  return target;
}
