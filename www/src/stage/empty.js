/**
 * The middle of the canvas while there is no curve: one sentence and where to start.
 *
 * @import { App } from "../state/app.js"
 */
import { runCommand } from "../commands.js";
import { find, h } from "../dom.js";
import { strings } from "../strings.js";
import { words } from "./empty-words.js";

/**
 * @param {App} app
 * @param {{gallery: () => void, choose: () => void}} acts
 */
export function createEmpty(app, { gallery, choose }) {
  /** @type {(name: string, text: string, act: () => void) => HTMLButtonElement} */
  const button = (name, text, act) =>
    h("button", { type: "button", class: name === "draw" ? "solid" : "outlined", "data-empty": name, onclick: act }, text);
  const presets = button("gallery", words.gallery, gallery);
  const element = h(
    "div",
    { class: "empty", "data-furniture": "", hidden: true },
    h("p", {}, words.line),
    h(
      "div",
      { class: "empty-commands" },
      button("draw", strings.commands.draw, () => void runCommand(app, "draw")),
      presets,
      button("import", words.import, choose),
    ),
  );
  find("#stage").append(element);
  return {
    render() {
      element.hidden = app.store.document.curves.length > 0 || app.ui.value.drawing;
    },
  };
}
