/**
 * The legend of the step picture: its marks in words, with how many there are.
 *
 * @import { Now } from "./groups.js"
 */
import "../../styles/step-controls.css";
import { h } from "../dom.js";
import { vertexName } from "./film.js";
import { words } from "./words.js";

/** @param {string} mark @param {number | null} count @param {string} text */
const item = (mark, count, text) =>
  h("span", { class: "steps-key", "data-key": mark }, h("i", { class: `key-${mark}` }), ...(count === null ? [] : [h("span", { class: "strong number" }, String(count))]), h("span", {}, text));

/** @returns {{element: HTMLElement, render: (now: Now) => void}} */
export function createLegend() {
  const element = h("div", { class: "steps-legend", "data-steps-legend": "" });
  let drawn = "";
  return {
    element,
    render(now) {
      const { at, hidden, focus, sets, scene } = now;
      const key = JSON.stringify([at, hidden, focus, sets?.visible.length, scene.lines.length]);
      if (key === drawn) return;
      drawn = key;
      element.replaceChildren(...itemsOf(now));
    },
  };
}

/** @param {Now} now */
function itemsOf({ scene: { phase, lines, redundant, left, chosen }, sets, focus, hidden }) {
  const l = words.legend;
  const isGrowing = phase === "growth" || phase === "start";
  const kept = lines.length - redundant.length;
  const items = [isGrowing ? item("accepted", lines.length, l.accepted(lines.length)) : item("accepted", kept, l.lines(kept))];
  if (sets && focus) {
    const candidates = sets.visible.filter(({ candidate }) => candidate).length;
    items.push(
      item("visible", sets.visible.length, l.visible(vertexName(focus.curve, focus.vertex))),
      item("valid", sets.valid.length, l.valid(sets.valid.length)),
      item("candidates", candidates, l.candidates(candidates)),
    );
  }
  if (phase === "removal") items.push(item("redundant", redundant.length, l.redundant));
  if (left) items.push(item("left", null, l.from));
  if (chosen && !hidden) {
    const text = { removal: l.removed, first: l.moved, second: l.moved, growth: l.winner, start: l.winner, end: l.winner }[phase];
    items.push(item("winner", 1, text));
  }
  return items;
}
