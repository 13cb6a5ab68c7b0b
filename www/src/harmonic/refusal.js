/**
 * Stands in for a mode that looks at ruling lines while the document has none, and says why.
 *
 * @import { App } from "../state/app.js"
 * @import { Place, View } from "../modes/modes.js"
 */
import "../../styles/harmonic.css";
import "../../styles/push.css";
import { h } from "../dom.js";
import { strong } from "../frame/status-parts.js";
import { fillStatus } from "../modes/status-line.js";
import { words } from "./words.js";

/**
 * @param {App} app
 * @param {Place} place
 * @param {"steps" | "compare" | "solid"} mode
 * @returns {View}
 */
export function createRefusal(app, { stage, status }, mode) {
  const back = h("button", { type: "button", class: "push", "data-action": "to-figure", onclick: () => app.ui.set({ mode: "figure" }) }, words.toFigure);
  stage.append(h("div", { class: "mode-refusal", "data-refusal": mode }, h("p", {}, words.modes[mode]), back));
  app.say(words.modes[mode]);
  return {
    render: () => fillStatus(status, "incomplete", [strong(words.refused)], []),
    close: () => {},
  };
}
