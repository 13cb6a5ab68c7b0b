/**
 * Commands of the harmonic blend. Each is one entry of the log, and says what it did.
 *
 * @import { App } from "../state/app.js"
 */
import { curveName } from "../state/app.js";
import { withBlend } from "../state/look.js";
import { whole } from "../state/selection.js";
import { withCurveInside } from "./edits.js";
import { words } from "./words.js";

/** Another curve inside: a circle, or a copy of a curve. @param {App} app @param {number} [copied] */
export function addInside(app, copied) {
  const { document } = app.store;
  const next = withCurveInside(document, copied === undefined ? undefined : document.curves[copied]);
  if (!next) {
    app.ui.set({ note: { tone: "plain", text: words.noRoom } });
    app.say(words.noRoom);
    return;
  }
  app.store.commit({ change: () => next });
  const index = next.curves.length - 1;
  app.ui.set({ selection: whole(index) });
  app.say((copied === undefined ? words.added : words.copied)(curveName(next, index)));
}

/** Goes over to the harmonic blend. @param {App} app */
export function useHarmonic(app) {
  app.store.commit({ change: (document) => withBlend(document, "harmonic") });
  app.say(words.used);
}
