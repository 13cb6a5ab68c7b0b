/**
 * Modes that look at two curves look at one span of a stack: they are given the page with the document of that span, and a choice of spans stands
 * beside the switch of modes.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument } from "../types.js"
 */
import "../../styles/stack.css";
import { spanOf } from "../../../js/span.js";
import { h } from "../dom.js";
import { spanName } from "../state/app.js";
import { words } from "./words.js";

/** @type {WeakMap<CurvesDocument, CurvesDocument[]>} */
const known = new WeakMap();

/**
 * The chosen span of a stack, the same object for the same document; other documents as they are.
 * @param {CurvesDocument} document
 * @param {number} span
 */
function shownOf(document, span) {
  const last = document.curves.length - 2;
  if (last < 1) return document;
  const parts = known.get(document) ?? [];
  known.set(document, parts);
  const index = Math.min(span, last);
  return (parts[index] ??= spanOf(document, index));
}

/**
 * The page with the document of the chosen span. What is committed goes to the whole document.
 * @param {App} app
 * @returns {App}
 */
export function spanApp(app) {
  const store = new Proxy(app.store, {
    get(whole, name) {
      if (name === "document") return shownOf(whole.document, app.ui.value.span);
      const value = Reflect.get(whole, name);
      return typeof value === "function" ? value.bind(whole) : value;
    },
  });
  // The tool of the canvas is set on the page itself.
  return new Proxy(app, { get: (whole, name) => (name === "store" ? store : Reflect.get(whole, name)) });
}

/** The choice of a span. @param {App} app */
export function spanChoice(app) {
  const list = h("select", { "data-field": "span", "aria-label": words.span });
  const element = h("label", { class: "span-choice" }, words.span, h("span", { class: "field select" }, list));
  list.addEventListener("change", () => {
    const span = Number(list.value);
    app.ui.set({ span });
    app.say(words.spanChosen(spanName(span)));
  });
  let drawn = 0;
  return {
    element,
    render() {
      const spans = app.store.document.curves.length - 1;
      element.hidden = spans < 2;
      if (element.hidden) return;
      if (spans !== drawn) {
        drawn = spans;
        list.replaceChildren(...Array.from({ length: spans }, (_, k) => h("option", { value: String(k) }, spanName(k))));
      }
      list.value = String(Math.min(app.ui.value.span, spans - 1));
    },
  };
}
