/**
 * What the page asks of documents that are not of curves, by their kind. Their workbenches are in `main.js`.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Kernel, Size } from "../types.js"
 *
 * @typedef {{title: string}} Raw A document that has not been checked.
 * @typedef {{id: string, line: string, document: Raw}} KindPreset `id` is its name in links, `line` says why it matters
 *
 * @typedef {object} Kind
 * @property {(kernel: Kernel, raw: any) => Promise<CurvesDocument>} completed the document with every default, in the place of the documents that
 *   the page passes around; rejects with a DirectrixError when it is none
 * @property {object} [empty] what a new document has besides version and title; without it a new document is one of curves
 * @property {() => Promise<readonly KindPreset[]>} presets
 * @property {(app: App) => Promise<void>} showGallery
 * @property {(app: App) => Promise<void>} showExport
 * @property {(kernel: Kernel, document: any, size: Size, ratio: number, signal?: AbortSignal) => Promise<string>} thumbnail address of a small picture, as
 *   data; it stands on a light and on a dark ground. `size` in CSS pixels, each of `ratio` pixels of the device
 */

/** @type {{[kind: string]: () => Promise<Kind>}} */
const KINDS = {
  hyperpatch: async () => (await import("../hyperpatch/kind.js")).bodyKind,
  part: async () => (await import("../part/kind.js")).partKind,
  laplace: async () => (await import("../laboratory/kind.js")).laboratoryKind,
};

/**
 * What is known of a kind; null of curves and of what is no kind.
 * @param {unknown} raw
 */
export async function kindOf(raw) {
  const { kind = null } = /** @type {{kind?: unknown}} */ (raw ?? {});
  return typeof kind === "string" && Object.hasOwn(KINDS, kind) ? KINDS[kind]() : null;
}

/** The preset of a name, of whatever kind but curves; undefined where there is none. @param {string} id */
export async function presetOfAnyKind(id) {
  const all = await Promise.all(Object.values(KINDS).map(async (load) => (await load()).presets()));
  return all.flat().find((preset) => preset.id === id)?.document;
}
