/**
 * The lessons that there are. What the list shows comes with this module; the text of a lesson, with the documents of its figures, when it
 * is opened.
 *
 * @import { Lesson } from "../../../scripts/lib/lesson.mjs"
 *
 * @typedef {Omit<Lesson, "steps"> & {steps: string[]}} Head a lesson with the titles of its steps
 * @typedef {(app: import("../state/app.js").App, host: import("./figure.js").Host, figure: import("../../../scripts/lib/lesson.mjs").Figure) => import("./figure.js").FigureView} Create
 * @typedef {Lesson & {documents: {[name: string]: unknown}, create: {[view: string]: Create}}} WholeLesson
 *   `create`: what shows figures of other kinds than curves, as far as the lesson has such
 */

/** @type {{[view: string]: () => Promise<Create>}} */
const OTHERS = {
  body: async () => (await import("./body-view.js")).createBodyFigure,
  part: async () => (await import("./part-view.js")).createPartFigure,
  laplace: async () => (await import("./laplace-view.js")).createLaplaceFigure,
  grid: async () => (await import("./grid-view.js")).createGridFigure,
};

/** @type {{[path: string]: Head}} */
const found = import.meta.glob("../../lessons/*.md", { eager: true, query: "?head", import: "default" });
const whole = import.meta.glob("../../lessons/*.md", { import: "default" });

const ordered = Object.values(found).sort((a, b) => a.order - b.order);

/** In the order of the list: group by group, so that a lesson that came later stands with its own. */
export const heads = [...new Set(ordered.map(({ group }) => group))].flatMap((group) => ordered.filter((head) => head.group === group));

/** @param {string} name of a lesson that there is @returns {Promise<WholeLesson>} */
export async function openLesson(name) {
  const load = whole[`../../lessons/${name}.md`];
  if (!load) throw new Error(`there is no lesson ${name}`);
  const lesson = /** @type {WholeLesson} */ (await load());
  const views = [...new Set(lesson.steps.map(({ figure }) => figure.view))].filter((view) => Object.hasOwn(OTHERS, view));
  const create = Object.fromEntries(await Promise.all(views.map(async (view) => [view, await OTHERS[view]()])));
  return { ...lesson, create };
}
