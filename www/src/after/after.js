/**
 * What the page fetches once its first figure is there: the switch of modes, the result in words, the styles of forced colours and small
 * windows, and what lets it work without a network.
 *
 * @import { App } from "../state/app.js"
 */
import "../../styles/access.css";
import { createModes } from "../modes/modes.js";
import { whenAtRest } from "../offline/rest.js";
import { createOutcome } from "./outcome.js";

/** @param {App} app */
export function createAfter(app) {
  const parts = [createModes(app), createOutcome(app)];
  whenAtRest(async () => (await import("../offline/offline.js")).startOffline(app));
  return {
    render() {
      for (const part of parts) part.render();
    },
  };
}
