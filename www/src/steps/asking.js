/**
 * The question of the game over the picture, then the answer with the way on.
 *
 * @import { Steps } from "../../../js/directrix.js"
 * @import { Prediction } from "./prediction.js"
 */
import { h } from "../dom.js";
import { vertexName } from "./film.js";
import { isHidden } from "./prediction.js";
import { spokenAnswer } from "./spoken.js";
import { words } from "./words.js";

/**
 * @param {() => void} next goes to the next step
 * @returns {{element: HTMLElement, render: (prediction: Prediction | null, steps: Steps | null, at: number) => void}}
 */
export function createAsking(next) {
  const element = h("div", { class: "steps-ask", "data-furniture": "", hidden: true });
  let drawn = "";
  return {
    element,
    render(prediction, steps, at) {
      const line = steps?.growth[at - 1];
      const isOpen = steps !== null && isHidden(prediction, steps, at);
      const text = isOpen && line ? words.askShort(vertexName(0, line.from)) : spokenAnswer(prediction, steps, at);
      element.hidden = !text;
      const key = `${text} ${isOpen}`;
      if (!text || key === drawn) return;
      drawn = key;
      const isNext = !isOpen && steps !== null && at < steps.growth.length;
      element.dataset.verdict = isOpen || !prediction?.told ? "" : prediction.told.kind === "right" ? "right" : "wrong";
      element.replaceChildren(
        h("span", {}, text),
        ...(isNext ? [h("button", { type: "button", class: "command-word", "data-steps": "next", onclick: next }, words.next)] : []),
      );
    },
  };
}
