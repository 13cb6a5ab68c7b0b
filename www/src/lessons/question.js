/**
 * A question of a lesson: predict, then see. Choosing one of the answers, or a vertex of the figure, shows what is right and why; so does
 * asking for it.
 *
 * @import { App } from "../state/app.js"
 * @import { Question } from "../../../scripts/lib/lesson.mjs"
 *
 * @typedef {object} Answer What was answered, kept for as long as the page is open.
 * @property {number | null} choice null where a vertex was chosen, or the answer was asked for
 * @property {boolean | null} right
 * @property {string} text about a vertex
 */
import "../../styles/lesson-question.css";
import { h } from "../dom.js";
import { icon } from "../icons.js";
import { fill } from "./html.js";
import { words } from "./words.js";

/**
 * @param {App} app
 * @param {Question} question
 * @param {object} options
 * @param {Answer | null} options.answer
 * @param {(answer: Answer) => void} options.answered
 */
export function createQuestion(app, question, { answer, answered }) {
  const text = fill(h("p", { class: "lesson-ask" }), question.text);
  const told = h("div", { class: "lesson-told", hidden: true });
  const choices = question.choices.map((choice, k) => {
    const button = h("button", { type: "button", class: "lesson-choice", "data-choice": String(k), onclick: () => take({ choice: k, right: choice.right, text: "" }) });
    button.append(fill(h("span", {}), choice.text));
    return button;
  });
  const reveal = h("button", { type: "button", class: "bare word lesson-reveal", "data-lesson": "reveal", onclick: () => take({ choice: null, right: null, text: "" }) }, words.reveal);
  const element = h(
    "section",
    { class: "lesson-question", "aria-label": words.question },
    text,
    ...(choices.length > 0 ? [h("div", { class: "lesson-choices" }, ...choices)] : []),
    reveal,
    told,
  );

  /** @param {Answer} given @param {boolean} [quiet] it was answered before */
  function take(given, quiet = false) {
    if (!told.hidden) return;
    const verdict = given.right === null ? words.answer : given.right ? words.right : words.wrong;
    const reason = fill(h("span", {}), question.answer);
    told.replaceChildren(h("p", {}, h("strong", {}, verdict), " ", ...(given.text ? [`${given.text} `] : []), reason));
    told.hidden = false;
    for (const button of element.querySelectorAll(".lesson-reveal")) button.remove();
    element.dataset.verdict = given.right === null ? "told" : given.right ? "right" : "wrong";
    choices.forEach((button, k) => {
      const right = question.choices[k]?.right ?? false;
      const isMine = given.choice === k;
      button.setAttribute("aria-disabled", "true");
      button.classList.toggle("right", right);
      button.classList.toggle("chosen", isMine);
      const marks = [...(isMine ? [words.yours] : []), ...(right ? [words.rightChoice] : isMine ? [words.wrongChoice] : [])];
      if (marks.length > 0) button.append(...(right ? [icon("check", 14)] : []), h("span", { class: "lesson-mark" }, marks.join(", ")));
    });
    if (quiet) return;
    answered(given);
    told.scrollIntoView({ block: "nearest" });
    app.say([verdict, given.text, plain(reason)].filter(Boolean).join(" "));
  }

  if (answer) take(answer, true);

  return {
    element,
    /** Whether a vertex of the figure is asked for. */
    wantsVertex: question.choices.length === 0,
    get isOpen() {
      return told.hidden;
    },
    take,
  };
}

/** The words of an element, each formula once: MathML leaves out what is only for the eye. @param {HTMLElement} element */
function plain(element) {
  const copy = /** @type {HTMLElement} */ (element.cloneNode(true));
  for (const each of copy.querySelectorAll(".katex-html, annotation")) each.remove();
  return (copy.textContent ?? "").replace(/\s+/g, " ").trim();
}
