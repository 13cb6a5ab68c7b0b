/**
 * Opening what is pasted anywhere on the page: a document, SVG or points as text, or a file. A text field keeps what is
 * pasted into it.
 *
 * @import { App } from "../state/app.js"
 */
import { words } from "../files/words.js";

/** @param {App} app */
export function listenToPaste(app) {
  addEventListener("paste", (event) => {
    const target = event.target instanceof HTMLElement ? event.target : null;
    if (target?.closest("textarea, select, [contenteditable]") || (target instanceof HTMLInputElement && isTyped(target))) return;
    const [file] = event.clipboardData?.files ?? [];
    const text = event.clipboardData?.getData("text/plain") ?? "";
    if (!file && text.trim() === "") return;
    event.preventDefault();
    void open(file, text);
  });

  /**
   * @param {File | undefined} file
   * @param {string} text when there is no file
   */
  async function open(file, text) {
    const { openFile, openText } = await import("../files/open.js");
    await (file ? openFile(app, file) : openText(app, words.pasted, text));
  }
}

/** @param {HTMLInputElement} input */
const isTyped = (input) => !["checkbox", "radio", "range", "button", "file", "color"].includes(input.type);
