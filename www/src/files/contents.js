/**
 * What an export holds, by format.
 *
 * @import { App } from "../state/app.js"
 * @import { Size } from "../types.js"
 * @import { Appearance } from "./pictures.js"
 *
 * @typedef {"png" | "svg" | "csv" | "json"} Format
 * @typedef {"lines" | "stages" | "cells"} Table
 * @typedef {"document" | "cells"} Content
 *
 * @typedef {Size & Appearance & {format: Format, table: Table, content: Content}} Wanted `table`: of CSV; `content`: of JSON
 */
import { cellsCsv, cellsJson } from "../cells/tables.js";
import { words } from "../cells/words.js";
import { words as exportWords } from "../frame/export-words.js";
import { blendOf } from "../harmonic/blend.js";
import { words as flow } from "../harmonic/words.js";
import { currentMatch } from "../state/app.js";
import { isHarmonic, lookedAt } from "../state/look.js";
import { gradientCsv, levelsCsv, linesCsv, stackCsv, stagesCsv } from "./csv.js";
import { documentWithView } from "./document-view.js";
import { fileName } from "./names.js";
import { pngOf, svgOf } from "./pictures.js";
import { written } from "./written.js";

/** Types of the texts. */
const TYPES = { svg: "image/svg+xml", csv: "text/csv", json: "application/json" };

/**
 * @param {App} app
 * @param {Wanted} wanted
 * @returns {Promise<Blob>}
 */
export async function fileOf(app, wanted) {
  if (wanted.format === "png") return pngOf(app, wanted);
  return new Blob([await textOf(app, wanted)], { type: TYPES[wanted.format] });
}

/**
 * The text of a format that is one.
 * @param {App} app
 * @param {Wanted} wanted
 * @returns {Promise<string>}
 */
export async function textOf(app, wanted) {
  if (wanted.format === "svg") return svgOf(app, wanted);
  if (wanted.format === "json") return wanted.content === "cells" ? cellsAsJson(app) : written(documentWithView(app));
  return { lines, stages, cells: cellsAsCsv }[wanted.table](app);
}

/**
 * The name of the file on disk.
 * @param {App} app
 * @param {Wanted} wanted
 */
export function nameOf(app, { format, table, content }) {
  const title = fileName(app.store.document.title);
  if (format === "json" && content === "cells") return `${title}-cells.json`;
  return format === "csv" ? `${title}-${table}.csv` : `${title}.${format}`;
}

/** @param {App} app */
async function lines(app) {
  if (isHarmonic(lookedAt(app))) return gradientCsv(await flowing(app));
  const { document } = app.store;
  const match = currentMatch(app) ?? (await app.kernel.match(document));
  if (match.spans) {
    if (match.spans.some((span) => span.lines.length === 0)) throw new Error(exportWords.noLines);
    return stackCsv(match.spans, document.curves.map(({ height }) => height));
  }
  if (match.lines.length === 0) throw new Error(exportWords.noLines);
  const [first = 0, second = 0] = document.curves.map(({ height }) => height);
  return linesCsv(match, second - first);
}

/** @param {App} app */
async function stages(app) {
  if (isHarmonic(lookedAt(app))) return levelsCsv(await flowing(app));
  const found = await app.kernel.stages(app.store.document);
  if (found.length === 0) throw new Error(exportWords.noStages);
  return stagesCsv(found);
}

/** The harmonic blend that is looked at. @param {App} app */
async function flowing(app) {
  const blend = await blendOf(app);
  if (!blend.ok) throw new Error(flow.noBlend);
  return blend;
}

/** @param {App} app */
async function cellsAsCsv(app) {
  const { document } = app.store;
  return cellsCsv(await cells(app), document.materials.map(({ name }) => name), document.unit);
}

/** @param {App} app */
async function cellsAsJson(app) {
  const { document } = app.store;
  const [found, amounts] = await Promise.all([cells(app), app.kernel.amounts(document)]);
  if (!amounts) throw new Error(words.none);
  return cellsJson(found, amounts, document.title);
}

/** @param {App} app */
async function cells(app) {
  if (isHarmonic(app.store.document)) throw new Error(flow.noCells);
  const found = await app.kernel.cells(app.store.document);
  if (found.length === 0) throw new Error(words.none);
  return found;
}
