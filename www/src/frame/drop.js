/**
 * Opening a document by dropping its file anywhere on the page.
 *
 * @import { App } from "../state/app.js"
 */
import { find } from "../dom.js";
import { dropped } from "../files/file-system.js";
import { words } from "../files/words.js";
import { strings } from "../strings.js";

/** @param {App} app */
export function listenToDrop(app) {
  const target = find("#drop");
  target.textContent = strings.canvas.drop;
  const carriesFile = (/** @type {DragEvent} */ event) => event.dataTransfer?.types.includes("Files") ?? false;
  addEventListener("dragover", (event) => {
    if (!carriesFile(event)) return;
    event.preventDefault();
    target.hidden = false;
  });
  addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) target.hidden = true;
  });
  addEventListener("drop", (event) => {
    if (!carriesFile(event)) return;
    event.preventDefault();
    target.hidden = true;
    const found = event.dataTransfer && dropped(event.dataTransfer);
    const count = event.dataTransfer?.files.length ?? 0;
    if (found) void open(found, count);
  });

  /**
   * @param {NonNullable<ReturnType<typeof dropped>>} found
   * @param {number} count of the files that came with it
   */
  async function open({ file, handle }, count) {
    const { openFile } = await import("../files/open.js");
    const opened = await openFile(app, file, await handle);
    if (!opened || count < 2) return;
    const text = words.onlyFirst(file.name, count);
    app.ui.set({ note: { tone: "plain", text } });
    app.say(text);
  }
}
