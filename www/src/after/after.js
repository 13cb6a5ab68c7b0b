/**
 * What the page fetches once its first figure is there: the switch of modes, files that are dropped or pasted, the result in words, the styles of forced colours and small
 * windows, and what lets it work without a network.
 *
 * @import { App } from "../state/app.js"
 */
import "../../styles/access.css";
import { listenToDrop } from "../frame/drop.js";
import { listenToPaste } from "../import/paste.js";
import { createModes } from "../modes/modes.js";
import { whenAtRest } from "../offline/rest.js";
import { isCurves } from "../state/kind.js";
import { createOutcome } from "./outcome.js";

/** @param {App} app */
export function createAfter(app) {
  listenToDrop(app);
  listenToPaste(app);
  const modes = createModes(app);
  const outcome = createOutcome(app);
  whenAtRest(async () => (await import("../offline/offline.js")).startOffline(app));
  return {
    render() {
      const hasCurves = isCurves(app.store.document);
      // Modes are those of curves; one that is left because another kind of document was opened still has to close.
      if (!hasCurves && app.ui.value.mode !== "figure") app.ui.set({ mode: "figure" });
      modes.render();
      if (hasCurves) outcome.render();
    },
  };
}
