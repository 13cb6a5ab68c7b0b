/**
 * A saved body that is added to the open one: chosen as a file.
 *
 * @import { HyperpatchDocument } from "../../../../js/directrix.js"
 * @import { App } from "../../state/app.js"
 */
import { h } from "../../dom.js";
import { problem } from "../../painter.js";
import { isBody } from "../kind.js";
import { words } from "./words.js";

const said = words.build;

/**
 * Adds the cells of a document to those of the open one.
 * @param {App} app
 * @param {HyperpatchDocument} other
 * @param {string} name by which it is spoken of
 * @returns {Promise<string | null>} why it was not added, or null
 */
export async function mergeBody(app, other, name) {
  const { store, kernel } = app;
  for (;;) {
    const before = store.document;
    const origin = store.origin;
    /** @type {HyperpatchDocument} */
    let next;
    try {
      next = await kernel.merge(/** @type {any} */ (before), other);
    } catch (error) {
      return problem(error).message;
    }
    if (store.origin !== origin) return null;
    // What was edited meanwhile is not lost: it is merged again.
    if (store.document !== before) continue;
    const last = next.operations.at(-1);
    if (last?.op !== "cells" || next.operations.length === /** @type {any} */ (before).operations.length) return said.empty;
    store.commit({ change: (document) => /** @type {any} */ ({ ...document, ...next }) });
    app.say(said.merged(last.cells.length, name));
    return null;
  }
}

/** @param {App} app */
export function addBody(app) {
  const input = h("input", { type: "file", accept: ".json,application/json", hidden: true, "data-add-body": "" });
  input.addEventListener("change", async () => {
    const [file] = input.files ?? [];
    input.value = "";
    if (!file) return;
    const reason = await added(file);
    app.ui.set({ note: reason === null ? null : { tone: "error", text: reason } });
  });
  document.body.append(input);

  /** @param {File} file @returns {Promise<string | null>} */
  async function added(file) {
    /** @type {unknown} */
    let value;
    try {
      value = JSON.parse(await file.text());
    } catch {
      return said.notBody;
    }
    return isBody(/** @type {any} */ (value)) ? mergeBody(app, /** @type {HyperpatchDocument} */ (value), file.name) : said.notBody;
  }

  return { choose: () => input.click(), close: () => input.remove() };
}
