/**
 * Keys of the whole page: open and save, undo and redo, fit, zoom, play.
 *
 * @import { App } from "../state/app.js"
 */
import { save, saveCopy } from "../files/save.js";
import { fit, zoomBy } from "../stage/zoom.js";

/**
 * @param {App} app
 * @param {{togglePlay: () => void, choose: () => void}} acts what other parts of the page do
 */
export function listenToShortcuts(app, { togglePlay, choose }) {
  addEventListener("keydown", (event) => {
    const target = event.target instanceof HTMLElement ? event.target : null;
    if (event.defaultPrevented) return;
    if ((event.ctrlKey || event.metaKey) && !event.altKey) {
      if (fileKey(event, target)) return;
      if (target instanceof HTMLInputElement && target.type === "text" && target.value !== target.defaultValue) return;
      const key = event.key.toLowerCase();
      if (key === "z" && !event.shiftKey) app.store.undo();
      else if (key === "y" || (key === "z" && event.shiftKey)) app.store.redo();
      else return;
      event.preventDefault();
      return;
    }
    if (event.altKey || event.metaKey || (target instanceof HTMLInputElement && target.type === "text")) return;
    if (event.key === "f" || event.key === "F") void fit(app);
    else if (event.key === "+" || event.key === "=") zoomBy(app, 1);
    else if (event.key === "-") zoomBy(app, -1);
    else if (event.key === " " && !hasOwnSpace(target)) togglePlay();
    else return;
    event.preventDefault();
  });

  /** @param {KeyboardEvent} event @param {HTMLElement | null} target */
  function fileKey(event, target) {
    const key = event.key.toLowerCase();
    if (key !== "s" && (key !== "o" || event.shiftKey)) return false;
    event.preventDefault();
    if (event.repeat) return true;
    // What is still being typed belongs to the document that is saved.
    if (target instanceof HTMLInputElement) target.blur();
    if (key === "o") choose();
    else void (event.shiftKey ? saveCopy : save)(app);
    return true;
  }
}

/** Whether the space bar means something to the focused element itself. @param {HTMLElement | null} target */
function hasOwnSpace(target) {
  if (!target || target.dataset.handle !== undefined) return false;
  return target.matches("button, input, select, a, [role=menuitem], [role=tab]");
}
