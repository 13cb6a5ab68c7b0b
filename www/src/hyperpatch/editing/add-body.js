/**
 * A saved body that is added to the open one: from a file that is chosen or dropped on the group, or from text that is pasted there.
 *
 * @import { HyperpatchDocument } from "../../../../js/directrix.js"
 * @import { App } from "../../state/app.js"
 */
import { h, write } from "../../dom.js";
import { problem } from "../../painter.js";
import { isOf } from "../../state/kind.js";
import { words } from "./words.js";

const said = words.build;

/**
 * Adds the cells of a document to those of the open one.
 * @param {App} app
 * @param {HyperpatchDocument} other
 * @param {string} name by which it is spoken of
 * @returns {Promise<string | null>} why it was not added, or null
 */
async function mergeBody(app, other, name) {
  const { store, kernel } = app;
  const { origin } = store;
  for (;;) {
    const before = /** @type {HyperpatchDocument} */ (/** @type {unknown} */ (store.document));
    /** @type {HyperpatchDocument} */
    let next;
    try {
      next = await kernel.merge(before, other);
    } catch (error) {
      return problem(error).message;
    }
    if (store.origin !== origin) return null;
    // What was edited meanwhile is not lost: it is merged with that.
    if (/** @type {unknown} */ (store.document) !== before) continue;
    const last = next.operations.at(-1);
    if (last?.op !== "cells" || next.operations.length === before.operations.length) return said.empty;
    const { materials, operations } = next;
    store.commit({ change: (document) => /** @type {any} */ ({ ...document, materials, operations }) });
    app.say(said.merged(last.cells.length, name));
    return null;
  }
}

/** @param {App} app */
export function addBody(app) {
  const input = h("input", { type: "file", accept: ".json,application/json", hidden: true, "data-add-body": "" });
  const error = h("p", { class: "field-error", role: "alert", hidden: true, "data-add-error": "" });
  const choose = h("button", { type: "button", class: "push", "data-add-choose": "", onclick: () => input.click() }, said.choose);
  const element = h("div", { class: "body-adding" }, h("p", { class: "body-note" }, said.importNote), h("div", { class: "body-buttons" }, choose), input, error);
  input.addEventListener("change", () => {
    const [file] = input.files ?? [];
    if (file) void take(file, file.name);
    input.value = "";
  });

  /** @param {{text: () => Promise<string>}} from @param {string} name */
  async function take(from, name) {
    const reason = await added(from, name);
    error.hidden = reason === null;
    write(error, reason ?? "");
  }

  /** @param {{text: () => Promise<string>}} from @param {string} name @returns {Promise<string | null>} */
  async function added(from, name) {
    /** @type {unknown} */
    let value;
    try {
      value = JSON.parse(await from.text());
    } catch {
      return said.notBody;
    }
    const isObject = typeof value === "object" && value !== null;
    return isObject && isOf(/** @type {any} */ (value), "hyperpatch") ? mergeBody(app, /** @type {HyperpatchDocument} */ (value), name) : said.notBody;
  }

  return {
    element,
    /** Takes what is dropped or pasted on an element, which elsewhere on the page opens. @param {HTMLElement} target */
    listen(target) {
      target.addEventListener("dragover", (event) => {
        if (!event.dataTransfer?.types.includes("Files")) return;
        event.preventDefault();
        event.stopPropagation();
        target.classList.add("dropping");
      });
      target.addEventListener("dragleave", () => target.classList.remove("dropping"));
      target.addEventListener("drop", (event) => {
        const [file] = event.dataTransfer?.files ?? [];
        target.classList.remove("dropping");
        if (!file) return;
        event.preventDefault();
        event.stopPropagation();
        void take(file, file.name);
      });
      target.addEventListener("paste", (event) => {
        const [file] = event.clipboardData?.files ?? [];
        const text = event.clipboardData?.getData("text/plain") ?? "";
        const isTyped = event.target instanceof HTMLInputElement && event.target.type === "text";
        if (isTyped || (!file && text.trim() === "")) return;
        event.preventDefault();
        event.stopPropagation();
        void take(file ?? { text: async () => text }, file?.name ?? said.pasted);
      });
    },
  };
}
