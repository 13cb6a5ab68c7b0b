/**
 * What is looked at of two closed curves: either blend, or how far they are apart. It is a matter of the look and not of the document.
 *
 * @import { App } from "../state/app.js"
 *
 * @typedef {"ruled" | "harmonic" | "difference"} Look
 */
import { hasLooks, isHarmonic, lookedAt } from "../state/look.js";
import { words } from "./words.js";

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
