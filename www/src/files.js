/**
 * Documents in and out: presets, files, exports.
 *
 * @import { App } from "./state/app.js"
 * @import { CurvesDocument } from "./types.js"
 */
import { completed, imageData } from "./kernel.js";
import { devicePixels, problem } from "./painter.js";
import { FIRST_LAYERS, LAYERS } from "./state/app.js";
import { only, within } from "./state/selection.js";
import { strings } from "./strings.js";

/** Pixels of an exported picture for one of the screen. */
const EXPORT_RATIO = 2;

/**
 * What a document says about its own view, as the page keeps it.
 * @param {CurvesDocument} document complete, with every default
 */
export function splitView(document) {
  const { view, ...rest } = document;
  const layers = view?.layers?.filter((name) => LAYERS.some((layer) => layer === name));
  return {
    document: /** @type {CurvesDocument} */ (rest),
    ui: { layers: layers ?? [...FIRST_LAYERS], s: view?.s ?? 0.4 },
    place: view?.center && view.span ? { center: view.center, span: view.span } : null,
  };
}

/**
 * Opens a document that has not been checked. Whatever is wrong with it, the open one stays.
 * @param {App} app
 * @param {unknown} raw
 * @param {string} name for the message
 * @returns {Promise<boolean>} whether it was opened
 */
export async function openDocument(app, raw, name) {
  try {
    const { document, ui, place } = splitView(await completed(app.kernel, raw));
    app.store.open(document);
    const { size } = app.ui.value;
    app.ui.set({
      ...ui,
      selection: within(only(1, 0), document),
      probe: null,
      witness: null,
      note: null,
      playing: false,
      fitted: place === null,
      view: place ? { center: place.center, scale: Math.min(size.width, size.height) / place.span } : null,
    });
    return true;
  } catch (error) {
    const { path = "", message } = problem(error);
    refuse(app, name, strings.errors.document(path, message));
    return false;
  }
}

/**
 * @param {App} app
 * @param {File} file
 */
export async function openFile(app, file) {
  let raw;
  try {
    raw = JSON.parse(await file.text());
  } catch (error) {
    refuse(app, file.name, `${strings.errors.notJson} (${problem(error).message})`);
    return;
  }
  await openDocument(app, raw, file.name);
}

/** @param {App} app @param {string} name @param {string} reason */
function refuse(app, name, reason) {
  const text = strings.errors.open(name, reason.replace(/\.$/, ""));
  app.ui.set({ note: { tone: "error", text } });
  app.say(text);
}

/**
 * The document with the view it is seen in, as it goes into a file.
 * @param {App} app
 * @returns {CurvesDocument}
 */
export function documentWithView(app) {
  const { view, layers, s, size } = app.ui.value;
  return {
    ...app.store.document,
    view: { layers, s, ...(view ? { center: view.center, span: Math.min(size.width, size.height) / view.scale } : {}) },
  };
}

/**
 * JSON with one line for each array of numbers, so that a document is easy to read and to compare.
 * @param {unknown} value
 */
export function written(value) {
  const text = JSON.stringify(value, null, 2);
  return `${text.replace(/\[[^[\]{}]*\]/g, (list) => list.replace(/\s*\n\s*/g, " ").replace(/\[ | \]/g, (edge) => edge.trim()))}\n`;
}

/**
 * @param {App} app
 * @param {"svg" | "png" | "json"} kind
 */
export async function exportAs(app, kind) {
  try {
    download(await contents(app, kind), `${fileName(app.store.document.title)}.${kind}`);
    if (kind === "json") app.store.kept();
  } catch (error) {
    const text = strings.errors.export(problem(error).message);
    app.ui.set({ note: { tone: "error", text } });
    app.say(text);
  }
}

/**
 * @param {App} app
 * @param {"svg" | "png" | "json"} kind
 * @returns {Promise<Blob>}
 */
async function contents(app, kind) {
  const { document } = app.store;
  if (kind === "json") return new Blob([written(documentWithView(app))], { type: "application/json" });
  const { size, view, layers, theme, s } = app.ui.value;
  const options = {
    ...devicePixels(size, kind === "png" ? EXPORT_RATIO : 1),
    ...(view ? { view } : {}),
    layers,
    theme,
    s,
    line: null,
  };
  if (kind === "svg") return new Blob([await app.kernel.svg(document, options)], { type: "image/svg+xml" });
  const picture = await app.kernel.paint(document, options);
  const canvas = new OffscreenCanvas(picture.width, picture.height);
  canvas.getContext("2d")?.putImageData(imageData(picture), 0, 0);
  return canvas.convertToBlob({ type: "image/png" });
}

/** @param {Blob} blob @param {string} name */
function download(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** @param {string} title */
function fileName(title) {
  const plain = title
    .normalize("NFKD")
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-|-$/g, "");
  return plain || "directrix";
}
