/**
 * The figure of a step, with its caption: on the curves of the lesson or on the reader's own, to be reset, and to be opened in the editor
 * as it stands.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument } from "../types.js"
 * @import { Step } from "../../../scripts/lib/lesson.mjs"
 * @import { WholeLesson } from "./library.js"
 *
 * @typedef {object} Host What a view of a figure is given.
 * @property {HTMLElement} element `data-drawn` says that the picture stands
 * @property {ReturnType<typeof createSurface>} surface
 * @property {Set<string>} terms those of the text
 * @property {() => string} alt
 * @property {() => void} touched the reader changed something
 * @property {(error: unknown) => void} failed why nothing is shown; null when something is. What was only given up, or comes after the end, is no failure
 *
 * @typedef {object} FigureView
 * @property {HTMLElement} status what it comes to, in a line
 * @property {HTMLElement | null} controls
 * @property {(document: CurvesDocument) => void} show from its first state
 * @property {() => void} draw again: size or theme changed
 * @property {() => {document: CurvesDocument, s: number | null, step: number | null} | null} state
 * @property {(told: ((right: boolean, text: string) => void) | null) => void} [ask] hides the line of the step until a vertex is chosen
 * @property {() => void} [focus] the keyboard chooses a vertex
 * @property {() => void} close
 */
import "../../styles/lesson-figure.css";
import { h, write } from "../dom.js";
import { explain } from "../explain.js";
import { openDocument } from "../files/open.js";
import { isCurves, isOf } from "../state/kind.js";
import { completed } from "../kernel.js";
import { problem } from "../painter.js";
import { hasSpace } from "../state/in-space.js";
import { keepNow } from "../state/session.js";
import { createCurvesView } from "./curves-view.js";
import { figureDocument } from "./document.js";
import { fill } from "./html.js";
import { createStepsView } from "./steps-view.js";
import { createSurface } from "./surface.js";
import { words } from "./words.js";

/** Why a figure of curves cannot show a document; null where it can. @param {CurvesDocument} document */
function lackOf(document) {
  if (!isCurves(document)) return words.needsCurves(isOf(document, "part"));
  if (document.curves.length < 2) return words.needsTwo;
  return hasSpace(document) ? words.planeOnly : null;
}

/**
 * @param {App} app
 * @param {object} options
 * @param {WholeLesson} options.lesson
 * @param {Step} options.step
 * @param {number} options.number of the step, from 1
 * @param {Set<string>} options.terms
 * @param {boolean} options.mine whether it shows the reader's own curves
 * @param {(mine: boolean) => void} options.setMine
 * @param {(term: string | null) => void} options.pointed at what a term names
 */
export function createFigure(app, { lesson, step, number, terms, mine, setMine, pointed }) {
  const { figure } = step;
  const message = h("p", { class: "lesson-message", role: "status", hidden: true });
  const note = h("p", { class: "lesson-mine", hidden: true });
  const element = h("figure", { class: "lesson-figure", "data-view": figure.view });
  // Only figures of curves can show the reader's own.
  const isFixed = Object.hasOwn(lesson.create, figure.view);
  let isMine = mine && !isFixed;
  let over = false;
  let changed = false;
  let asked = 0;

  const surface = createSurface({ painted: figure.view === "figure", resized: () => view.draw(), pointed });
  const host = {
    element,
    surface,
    terms,
    alt: () => (isMine ? words.mineAlt(app.store.document.title) : figure.alt),
    touched: () => (changed = true),
    failed: (/** @type {unknown} */ error) => {
      if (over || (error instanceof Error && error.name === "AbortError")) return;
      message.hidden = error === null;
      if (error === null) return;
      write(message, words.cannot(explain(app.store.document, problem(error))));
      element.dataset.drawn = "failed";
    },
  };
  const create = figure.view === "steps" ? createStepsView : (isFixed && lesson.create[figure.view]) || createCurvesView;
  const view = create(app, host, figure);

  const button = (/** @type {string} */ name, /** @type {string} */ text, /** @type {string} */ title, /** @type {() => void} */ act) =>
    h("button", { type: "button", class: "bare word", "data-lesson": name, title, onclick: act }, text);
  const own = button("mine", words.mine, "", () => use(!isMine));
  own.hidden = isFixed;
  const acts = h(
    "div",
    { class: "lesson-acts" },
    own,
    button("reset", words.reset, words.resetTitle, reset),
    button("open", words.open, "", () => void open()),
  );
  const bar = h("div", { class: "lesson-controls", role: "group", "aria-label": words.controls }, ...(view.controls ? [view.controls] : []), acts);
  const caption = h("figcaption", {}, h("strong", {}, words.figureLabel(number)), " ", fill(h("span", {}), figure.caption));
  surface.element.append(message);
  element.append(h("div", { class: "lesson-frame" }, view.status, surface.element, bar), note, caption);

  async function show() {
    const turn = (asked += 1);
    changed = false;
    delete element.dataset.drawn;
    own.setAttribute("aria-pressed", String(isMine));
    note.hidden = !isMine;
    write(note, words.mineNote(app.store.document.title));
    message.hidden = true;
    const lack = isMine ? lackOf(app.store.document) : null;
    if (lack) {
      write(message, lack);
      message.hidden = false;
      element.dataset.drawn = "failed";
      return;
    }
    try {
      const document = await completed(app.kernel, figureDocument(isMine ? app.store.document : lesson.documents[figure.document], figure));
      if (over || turn !== asked) return;
      view.show(document);
    } catch (error) {
      if (!over && turn === asked) host.failed(error);
    }
  }

  /** @param {boolean} next */
  function use(next) {
    isMine = next;
    setMine(next);
    app.say(next ? words.mineOn(app.store.document.title) : words.mineOff);
    void show();
  }

  function reset() {
    app.say(words.wasReset);
    void show();
  }

  /** Opens what the figure shows in the editor, in the same state. The reader's own document, where nothing differs, is just gone back to. */
  async function open() {
    const state = view.state();
    if (!state) return;
    const { document, s, step: at } = state;
    const same = isMine && figure.changes.length === 0 && !changed;
    if (!same) {
      keepNow();
      const shown = isFixed ? document : { ...document, view: { ...document.view, ...(s === null ? {} : { s }) } };
      if (!(await openDocument(app, shown, document.title))) {
        host.failed(new Error(app.ui.value.note?.text));
        return;
      }
    }
    app.ui.set(at === null ? { mode: "figure" } : { mode: "steps", step: at });
    location.hash = "#stage";
  }

  void show();

  return {
    element,
    reset,
    /** @param {string | null} term */
    light: (term) => surface.light(term),
    draw: () => view.draw(),
    ...(view.ask ? { ask: view.ask, focus: view.focus } : {}),
    /** @param {boolean} large */
    enlarge(large) {
      surface.enlarge(large);
      view.draw();
    },
    close() {
      over = true;
      view.close();
      surface.close();
    },
  };
}
