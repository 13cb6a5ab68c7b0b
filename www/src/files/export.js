/**
 * Exports the figure and the document as files.
 *
 * @import { App } from "../state/app.js"
 */
import { imageData } from "../kernel.js";
import { devicePixels, problem } from "../painter.js";
import { strings } from "../strings.js";
import { documentWithView } from "./document-view.js";
import { download } from "./download.js";
import { fileName } from "./names.js";
import { written } from "./written.js";

/** Pixels of an exported picture for one of the screen. */
const EXPORT_RATIO = 2;

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
  const { size, view, layers, theme, s, isoMaterial } = app.ui.value;
  const options = {
    ...devicePixels(size, kind === "png" ? EXPORT_RATIO : 1),
    ...(view ? { view } : {}),
    layers,
    theme,
    s,
    line: null,
    isoMaterial,
  };
  if (kind === "svg") return new Blob([await app.kernel.svg(document, options)], { type: "image/svg+xml" });
  const picture = await app.kernel.paint(document, options);
  const canvas = new OffscreenCanvas(picture.width, picture.height);
  canvas.getContext("2d")?.putImageData(imageData(picture), 0, 0);
  return canvas.convertToBlob({ type: "image/png" });
}
