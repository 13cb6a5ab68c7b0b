/**
 * What a document says about its own view: the page keeps it apart, so that zooming is no edit, and puts it back into files.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Size } from "../types.js"
 */
import { FIRST_LAYERS, LAYERS } from "../state/app.js";
import { isCurves } from "../state/kind.js";

/** Place of the current in-between where a document names none. */
const FIRST_S = 0.4;
/** The layer that a phone leaves out at first: at its scale the dots run into each other. */
const CROWDED = "samples";

/**
 * The document without its view, and the view as the page keeps it.
 * @param {CurvesDocument} document complete, with every default
 */
export function splitView(document) {
  const { view, ...rest } = document;
  // What is shown besides is no matter of documents of other kinds; the modes are those of curves.
  if (!isCurves(document)) return { document, ui: /** @type {Partial<import("../state/app.js").Ui>} */ ({ mode: "figure" }), place: null };
  const layers = view?.layers?.filter((name) => LAYERS.some((layer) => layer === name));
  return {
    document: /** @type {CurvesDocument} */ (rest),
    ui: { layers: layers ?? firstLayers(), look: null, s: view?.s ?? FIRST_S, isoMaterial: view?.isoMaterial ?? 0, patterns: view?.patterns ?? false },
    place: view?.center && view.span ? { center: view.center, span: view.span } : null,
  };
}

/**
 * The view of a place on a canvas; one that follows its size where no place is named.
 * @param {ReturnType<typeof splitView>["place"]} place
 * @param {Size} size
 */
export function viewAt(place, { width, height }) {
  return { fitted: place === null, view: place && { center: place.center, scale: Math.min(width, height) / place.span } };
}

/** The layers shown where a document names none. */
function firstLayers() {
  const phone = matchMedia("(width < 600px)").matches;
  return FIRST_LAYERS.filter((name) => !phone || name !== CROWDED);
}

/**
 * A document with the view it is seen in, as it goes into a file.
 * @param {App} app
 * @param {CurvesDocument} [document] the open one when it is not given
 * @returns {CurvesDocument}
 */
export function documentWithView(app, document = app.store.document) {
  if (!isCurves(document)) return document;
  const { view, layers, s, size, isoMaterial, patterns } = app.ui.value;
  const place = view ? { center: view.center, span: Math.min(size.width, size.height) / view.scale } : {};
  return { ...document, view: { layers, s, ...(isoMaterial > 0 ? { isoMaterial } : {}), ...(patterns ? { patterns } : {}), ...place } };
}
