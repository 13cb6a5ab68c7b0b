/**
 * What the menu File holds; on a phone it is part of the one menu.
 *
 * @import { App } from "../state/app.js"
 * @import { Item } from "./menu.js"
 */
import { commandItems } from "../commands.js";
import { strings } from "../strings.js";

/** Loaded when something is saved; the browser counts the press for long enough. */
export const saving = () => import("../files/save.js");

/**
 * @param {App} app
 * @param {() => void} choose asks for a file to open
 * @returns {(Item | "line")[]}
 */
export function fileItems(app, choose) {
  const words = strings.file;
  return [
    ...commandItems(app, ["new"]),
    { name: "open", text: words.open, keys: "Ctrl+O", act: choose },
    { name: "save", text: words.save, keys: "Ctrl+S", act: () => void saving().then(({ save }) => save(app)) },
    { name: "save-copy", text: words.saveCopy, keys: "Ctrl+Shift+S", act: () => void saving().then(({ saveCopy }) => saveCopy(app)) },
    {
      name: "recent",
      text: words.recent,
      act: () => void import("./recent-panel.js").then(({ showRecent }) => showRecent(app)),
    },
    ...commandItems(app, ["line", "shortcuts", "about"]),
  ];
}
