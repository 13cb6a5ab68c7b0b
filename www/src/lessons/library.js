/**
 * The lessons that there are. What the list shows comes with this module; the text of a lesson, with the documents of its figures, when it
 * is opened.
 *
 * @import { Lesson } from "../../../scripts/lib/lesson.mjs"
 *
 * @typedef {Omit<Lesson, "steps"> & {steps: string[]}} Head a lesson with the titles of its steps
 * @typedef {Lesson & {documents: {[name: string]: unknown}, createBody: typeof import("./body-view.js").createBodyFigure | null}} WholeLesson
 *   `createBody`: what shows figures of a body, where the lesson has one
 */

/** @type {{[path: string]: Head}} */
const found = import.meta.glob("../../lessons/*.md", { eager: true, query: "?head", import: "default" });
const whole = import.meta.glob("../../lessons/*.md", { import: "default" });

/** In the order of the list. */
export const heads = Object.values(found).sort((a, b) => a.order - b.order);

/** @param {string} name of a lesson that there is @returns {Promise<WholeLesson>} */
export async function openLesson(name) {
  const load = whole[`../../lessons/${name}.md`];
  if (!load) throw new Error(`there is no lesson ${name}`);
  const lesson = /** @type {WholeLesson} */ (await load());
  const hasBody = lesson.steps.some(({ figure }) => figure.view === "body");
  return { ...lesson, createBody: hasBody ? (await import("./body-view.js")).createBodyFigure : null };
}
