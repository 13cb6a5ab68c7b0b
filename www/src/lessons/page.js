/**
 * One step of a lesson: its text, its figure, and its questions.
 *
 * @import { App } from "../state/app.js"
 * @import { WholeLesson } from "./library.js"
 * @import { Answer } from "./question.js"
 */
import { h } from "../dom.js";
import { createFigure } from "./figure.js";
import { fill } from "./html.js";
import { createQuestion } from "./question.js";
import { linkTerms, termsIn } from "./terms.js";
import { words } from "./words.js";

/** Answers that were given, by lesson, step and question, for as long as the page is open. @type {Map<string, Answer>} */
const answers = new Map();

/**
 * @param {App} app
 * @param {WholeLesson} lesson
 * @param {number} number of the step, from 1
 * @param {{mine: boolean, setMine: (mine: boolean) => void, large: boolean}} options
 */
export function createPage(app, lesson, number, { mine, setMine, large }) {
  const step = lesson.steps[number - 1];
  if (!step) throw new RangeError(`the lesson ${lesson.name} has no step ${number}`);
  const heading = h("h1", { tabIndex: -1 }, step.title);
  const element = h(
    "article",
    { class: "lesson" },
    h("p", { class: "lesson-eyebrow" }, h("span", {}, lesson.title), " · ", h("span", { class: "number" }, words.stepOf(number, lesson.steps.length))),
    heading,
  );
  /** @type {ReturnType<typeof createQuestion>[]} */
  const questions = [];
  const parts = step.blocks.map((block, k) => {
    if (block.kind === "figure") return null;
    if (block.kind === "question") {
      const key = `${lesson.name} ${number} ${k}`;
      const question = createQuestion(app, block.question, {
        answer: answers.get(key) ?? null,
        answered: (answer) => {
          answers.set(key, answer);
          if (question.wantsVertex && answer.right === null) figure.ask?.(null);
        },
      });
      questions.push(question);
      return question.element;
    }
    return fill(h("div", { class: block.kind === "formula" ? "lesson-formula" : "lesson-text" }), block.html);
  });
  for (const part of parts) if (part) element.append(part);
  const caption = fill(h("div", {}), step.figure.caption);
  const linked = linkTerms(element, () => figure);
  const figure = createFigure(app, {
    lesson,
    step,
    number,
    terms: new Set([...termsIn(element), ...termsIn(caption)]),
    mine,
    setMine,
    pointed: linked.pointed,
  });
  figure.enlarge(large);
  const place = parts.indexOf(null);
  const before = parts.slice(place < 0 ? parts.length : place).find((part) => part !== null);
  if (before) before.before(figure.element);
  else element.append(figure.element);
  const asking = questions.find((question) => question.wantsVertex && question.isOpen);
  if (asking && figure.ask) {
    figure.ask((right, text) => asking.take({ choice: null, right, text }));
    const choose = h("button", { type: "button", class: "bare word lesson-reveal", "data-lesson": "choose", onclick: () => figure.focus?.() }, words.chooseVertex);
    asking.element.querySelector(".lesson-reveal")?.before(choose);
  }

  return { element, heading, title: step.title, reset: figure.reset, draw: figure.draw, enlarge: figure.enlarge, close: figure.close };
}
