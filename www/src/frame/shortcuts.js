/**
 * Keys of the whole page. All but those of files and of the morph come from the table of commands.
 *
 * @import { App } from "../state/app.js"
 */
import { commandOf, runCommand } from "../commands.js";
import { isCurves } from "../state/kind.js";
import { saving } from "./file-menu.js";

/** Commands that a text field leaves to the page, as long as nothing is being typed in it. */
const PAST_FIELDS = ["undo", "redo"];
/** Topics whose keys belong to the canvas: elsewhere Delete must not take a point away. */
const ON_CANVAS = ["select", "points"];
/** Topics whose keys work in each mode but the figure, where all do, and in other workbenches. @type {{[mode: string]: string[]}} */
const IN_MODE = { steps: ["document", "mode", "view"], compare: ["document", "mode"], solid: ["document", "mode"], part: ["document", "view"], hyperpatch: ["document"], laplace: ["document"] };

/**
 * @param {App} app
 * @param {{togglePlay: () => void, choose: () => void}} acts what other parts of the page do
 */
export function listenToShortcuts(app, { togglePlay, choose }) {
  addEventListener("keydown", (event) => {
    const target = event.target instanceof HTMLElement ? event.target : null;
    if (event.defaultPrevented) return;
    if ((event.ctrlKey || event.metaKey) && !event.altKey && fileKey(event, target)) return;
    const command = commandOf(event);
    if (isText(target)) {
      const typed = target instanceof HTMLInputElement && target.value !== target.defaultValue;
      if (typed || !command || !PAST_FIELDS.includes(command.name)) return;
    }
    const mode = isCurves(app.store.document) ? app.ui.value.mode : app.store.document.kind;
    if (command) {
      if (IN_MODE[mode] && !IN_MODE[mode].includes(command.topic)) return;
      if (target instanceof HTMLSelectElement || (ON_CANVAS.includes(command.topic) && !isOnCanvas(target))) return;
      runCommand(app, command.name);
    } else if (event.key === " " && mode === "figure" && !hasOwnSpace(target) && !event.ctrlKey && !event.altKey && !event.metaKey) {
      togglePlay();
    } else return;
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
    else void saving().then(({ save, saveCopy }) => (event.shiftKey ? saveCopy : save)(app));
    return true;
  }
}

/** @param {HTMLElement | null} target */
const isText = (target) =>
  target instanceof HTMLTextAreaElement || (target instanceof HTMLInputElement && target.type === "text");

/** @param {HTMLElement | null} target */
const isOnCanvas = (target) => !target || target === document.body || target.closest("#stage") !== null;

/** Whether the space bar means something to the focused element itself. @param {HTMLElement | null} target */
function hasOwnSpace(target) {
  if (!target || target.dataset.handle !== undefined) return false;
  return target.matches("button, input, select, a, [role=menuitem], [role=tab]");
}
