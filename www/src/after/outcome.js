/**
 * The picture in words: what the result is worth, and what the curves are. The canvas is described by both, and the first is spoken when
 * it has changed and the page rests, so that a drag says nothing until it is over.
 *
 * @import { App } from "../state/app.js"
 */
import { describe, describeCurves } from "../../../js/sentence.js";
import { attribute, find, h, write } from "../dom.js";
import { explain } from "../explain.js";
import { curveName } from "../state/app.js";
import { isCurves } from "../state/kind.js";
import { lookedAt } from "../state/look.js";

/** Milliseconds of rest before a result is spoken: what an edit says of itself comes first. */
const PAUSE = 900;

/** @param {App} app */
export function createOutcome(app) {
  const { store, results } = app;
  const result = h("p", { id: "outcome", class: "spoken", "aria-live": "polite" });
  const curves = h("p", { id: "outlines", class: "spoken" });
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  /** @type {unknown} */
  let seen = null;

  /** The sentence of what is shown, or null while it is on its way. */
  function sentence() {
    const { match, matched, problem } = results.value;
    // A document of another kind may have been opened during the pause, and its workbench says what it shows.
    if (!isCurves(store.document) || matched !== lookedAt(app) || match?.coarse) return null;
    return problem ? explain(store.document, problem) : match ? describe(match) : null;
  }

  function tell() {
    const text = sentence();
    if (text === null) return;
    write(result, text);
    write(curves, describeCurves(named(app)));
    if (result.isConnected) return;
    // Words that are there when the region comes are not spoken: nobody has changed anything yet.
    find("#picture").after(result, curves);
    attribute(find("#picture"), "aria-describedby", `${result.id} ${curves.id}`);
  }

  return {
    render() {
      const { match, problem } = results.value;
      const now = match ?? problem;
      if (now === seen) return;
      seen = now;
      clearTimeout(timer);
      if (result.isConnected) timer = setTimeout(tell, PAUSE);
      else tell();
    },
  };
}

/** The document with the names that its curves have on the page. @param {App} app */
function named({ store: { document } }) {
  return { ...document, curves: document.curves.map((curve, i) => ({ ...curve, name: curveName(document, i) })) };
}
