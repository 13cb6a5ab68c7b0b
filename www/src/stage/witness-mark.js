/**
 * A small cross in a ring at the place a failing certificate was asked to show.
 *
 * @import { App } from "../state/app.js"
 */
import "../../styles/marks.css";
import { attribute, find, svg } from "../dom.js";
import { toScreen } from "../view.js";

/** @param {App} app */
export function createWitness(app) {
  const mark = svg("g", { class: "witness" }, svg("circle", { r: 11 }), svg("path", { d: "M-4-4 4 4M4-4-4 4" }));
  const layer = svg("svg", { class: "marks", "aria-hidden": "true" }, mark);
  find("#overlay").before(layer);
  return {
    render() {
      const { witness, view, size } = app.ui.value;
      layer.style.display = witness && view ? "" : "none";
      if (!witness || !view) return;
      const [x, y] = toScreen(view, size, witness);
      attribute(mark, "transform", `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
    },
  };
}
