/**
 * The bar above: mark, workbench, title, undo, redo, gallery, file, export, theme, share; on a phone one menu for most of it.
 *
 * @import { App } from "../state/app.js"
 */
import { commandText, commandTitle, runCommand } from "../commands.js";
import { textField } from "../controls/text-field.js";
import { attribute, find, h, write } from "../dom.js";
import { createChooser } from "../files/choose.js";
import { halfDisc, icon } from "../icons.js";
import { strings } from "../strings.js";
import { fileItems } from "./file-menu.js";
import { openGallery } from "./gallery.js";
import { mark } from "./mark.js";
import { attachMenu } from "./menu-button.js";
import { toggleTheme } from "./theme.js";

/** @param {App} app */
export function createBar(app) {
  const words = strings.bar;
  const iconButton = (/** @type {string} */ name, /** @type {Node} */ face, /** @type {string} */ label) =>
    h(
      "button",
      { type: "button", class: "bare icon-only", "aria-label": label, title: label, "data-action": name },
      face,
    );
  const wordButton = (/** @type {string} */ name, /** @type {string} */ label) =>
    h("button", { type: "button", class: "bare word", "data-action": name }, label);

  const chooser = createChooser(app);
  const choose = () => void chooser.choose();
  const title = textField({ label: words.title, name: "title", bare: true }, (text) =>
    app.store.commit({ change: (document) => ({ ...document, title: text }) }),
  );
  const state = h("span", { class: "bar-state", "data-state": "" });
  const benches = /** @type {const} */ (["curves", "part", "hyperpatch", "laplace"]).map((kind) => h("a", { href: "#stage", "data-bench": kind }, words[kind]));
  const lessons = h("a", { href: "#lesson" }, words.lessons);
  const undo = iconButton("undo", icon("undo"), commandText(app, "undo"));
  const redo = iconButton("redo", icon("redo"), commandText(app, "redo"));
  const theme = iconButton("theme", halfDisc(), words.toDark);
  const gallery = wordButton("gallery", words.gallery);
  const file = wordButton("file", words.file);
  const exporting = wordButton("export", words.export);
  const share = h(
    "button",
    { type: "button", class: "outlined share", "data-action": "share", "aria-label": commandText(app, "share") },
    icon("link"),
    h("span", {}, commandText(app, "share")),
  );
  const menu = iconButton("menu", icon("menu"), words.menu);
  const panel = iconButton("panel", icon("panel"), words.panel);

  undo.title = commandTitle(app, "undo");
  redo.title = commandTitle(app, "redo");
  share.title = commandTitle(app, "share");
  undo.addEventListener("click", () => app.store.undo());
  redo.addEventListener("click", () => app.store.redo());
  theme.addEventListener("click", () => toggleTheme(app));
  share.addEventListener("click", () => runCommand(app, "share"));
  gallery.addEventListener("click", () => void openGallery(app));
  panel.setAttribute("aria-expanded", "false");
  panel.setAttribute("aria-controls", "inspector");

  for (const bench of benches) {
    bench.addEventListener("click", (event) => {
      // Out of the lessons the address leads; from one document to another it stays as it is.
      if (app.ui.value.workbench !== "lessons") event.preventDefault();
      void import("../kinds/benches.js").then(({ enter }) => enter(app, bench.dataset.bench ?? ""));
    });
  }
  const openExport = () => void import("./export-panel.js").then(({ showExport }) => showExport(app));
  exporting.addEventListener("click", openExport);
  attachMenu(file, () => fileItems(app, choose));
  attachMenu(
    menu,
    () => [
      { name: "gallery", text: words.galleryItem, act: () => void openGallery(app) },
      "line",
      ...fileItems(app, choose),
      "line",
      { name: "export", text: words.exportItem, act: openExport },
      "line",
      ...benches.map((bench) => ({ name: bench.dataset.bench ?? "", text: bench.textContent ?? "", act: () => bench.click() })),
      { name: "lessons", text: words.lessons, act: () => lessons.click() },
      { name: "theme", text: themeLabel(app), act: () => toggleTheme(app) },
    ],
    { wide: true },
  );

  find("#bar").append(
    menu,
    h("span", { class: "mark", "aria-hidden": "true" }, /** @type {any} */ (mark())),
    h(
      "nav",
      { class: "workbenches", "aria-label": words.workbenches },
      ...benches,
      lessons,
    ),
    h("div", { class: "bar-title" }, title.element, state),
    h(
      "div",
      { class: "bar-actions" },
      undo,
      redo,
      h("span", { class: "bar-line", "aria-hidden": "true" }),
      gallery,
      file,
      exporting,
      theme,
      share,
      panel,
    ),
    chooser.element,
  );

  return {
    panel,
    choose,
    render() {
      const { store } = app;
      const isLessons = app.ui.value.workbench === "lessons";
      for (const bench of benches) attribute(bench, "aria-current", !isLessons && bench.dataset.bench === store.document.kind ? "page" : null);
      attribute(lessons, "aria-current", isLessons ? "page" : null);
      title.set(store.document.title || strings.untitled);
      title.input.size = Math.max(4, store.document.title.length);
      write(state, stateWord(app));
      undo.disabled = !store.canUndo;
      redo.disabled = !store.canRedo;
      const label = themeLabel(app);
      theme.title = label;
      theme.setAttribute("aria-label", label);
      const name = `${store.document.title || strings.untitled} · ${strings.app}`;
      if (!isLessons && document.title !== name) document.title = name;
    },
  };
}

/**
 * What has become of the work: saved to a file, edited since and kept in this browser, or kept nowhere.
 * @param {App} app
 */
function stateWord({ store, ui }) {
  if (store.edited) return ui.value.unkept ? strings.bar.unkept : strings.bar.edited;
  return store.origin.file === null ? "" : strings.bar.saved;
}

/** @param {App} app */
function themeLabel(app) {
  return app.ui.value.theme === "dark" ? strings.bar.toLight : strings.bar.toDark;
}
