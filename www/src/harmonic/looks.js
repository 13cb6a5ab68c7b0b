/**
 * The switch between the two blends of two closed curves and their difference, in the group Blend. It changes the look and not the document.
 *
 * @import { App } from "../state/app.js"
 *
 * @typedef {"ruled" | "harmonic" | "difference"} Look
 */
import { segment } from "../controls/choices.js";
import { h } from "../dom.js";
import { hasLooks, isHarmonic, lookedAt } from "../state/look.js";
import { words } from "./words.js";

const LOOKS = /** @type {const} */ (["ruled", "harmonic", "difference"]);

/** What is looked at. @param {App} app @returns {Look} */
export function lookOf(app) {
  if (!isHarmonic(lookedAt(app))) return "ruled";
  return app.ui.value.layers.includes("difference") && hasLooks(app.store.document) ? "difference" : "harmonic";
}

/** @param {App} app @param {Look} look */
export function setLook(app, look) {
  const blend = look === "ruled" ? "ruled" : "harmonic";
  const own = isHarmonic(app.store.document) ? "harmonic" : "ruled";
  const rest = app.ui.value.layers.filter((name) => name !== "difference");
  app.ui.set({ look: blend === own ? null : blend, layers: look === "difference" ? [...rest, "difference"] : rest, probe: null, line: null, witness: null });
  app.say(words.looking[look]);
}

/**
 * @param {App} app
 * @param {HTMLElement} place
 * @returns {{render: () => void}}
 */
export function createLooks(app, place) {
  const choice = segment(
    { label: words.look, name: "look", choices: LOOKS.map((value) => ({ value, text: words.looks[value] })) },
    (value) => setLook(app, value),
  );
  place.append(h("div", { class: "wide-row" }, h("span", { class: "row-label" }, words.look), choice.element), h("p", { class: "note" }, words.lookHelp));
  return {
    render() {
      place.hidden = !hasLooks(app.store.document);
      choice.set(lookOf(app));
    },
  };
}
