/**
 * Opening what is pasted anywhere on the page: a document, SVG or points as text, or a file. A text field keeps what is
 * pasted into it.
 *
 * @import { App } from "../state/app.js"
 */
import { openFile, openText } from "../files/open.js";
import { strings } from "../strings.js";

/** @param {App} app */
export function listenToPaste(app) {
  addEventListener("paste", (event) => {
    const target = event.target instanceof HTMLElement ? event.target : null;
    if (target?.closest("textarea, select, [contenteditable]") || (target instanceof HTMLInputElement && isTyped(target))) return;
    const [file] = event.clipboardData?.files ?? [];
    const text = event.clipboardData?.getData("text/plain") ?? "";
    if (!file && text.trim() === "") return;
    event.preventDefault();
    if (file) void openFile(app, file);
    else void openText(app, strings.import.pasted, text);
  });
}

/** @param {HTMLInputElement} input */
const isTyped = (input) => !["checkbox", "radio", "range", "button", "file", "color"].includes(input.type);
