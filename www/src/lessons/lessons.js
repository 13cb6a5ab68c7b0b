/**
 * The workbench Lessons: a list, one step at a time, and a presentation of it. The open document stays as it is behind it.
 *
 * @import { App } from "../state/app.js"
 * @import { WholeLesson } from "./library.js"
 */
import "katex/dist/katex.css";
import "../../styles/lessons.css";
import { find, h, write } from "../dom.js";
import { problem } from "../painter.js";
import { takeHash } from "../state/session.js";
import { heads, openLesson } from "./library.js";
import { createList } from "./list.js";
import { createPage } from "./page.js";
import { linkTo, readPlace } from "./place.js";
import { words } from "./words.js";

/** What stands behind the lessons and must be neither seen nor reached. */
const BEHIND = ["#stage", "#inspector", "#status"];

/** @param {App} app */
export function createLessons(app) {
  const root = document.documentElement;
  /** @type {ReturnType<typeof createPage> | null} */
  let page = null;
  /** @type {WholeLesson | null} */
  let lesson = null;
  let number = 1;
  let mine = false;
  let isOn = false;
  let isLarge = false;
  let asked = 0;
  let theme = app.ui.value.theme;
  /** Where the lessons were left. */
  let last = linkTo(heads[0]?.name ?? "", 1);

  const list = createList();
  const place = h("div", { class: "lesson-place" });
  const back = h("a", { class: "lesson-turn", "data-lesson": "back" });
  const next = h("a", { class: "lesson-turn", "data-lesson": "next" });
  const count = h("span", { class: "number" });
  const foot = h("nav", { class: "lesson-foot", "aria-label": words.steps }, back, count, next);
  const scroll = h("main", { class: "lesson-scroll" }, place, foot, h("p", { class: "spoken" }, words.keys));
  const element = h("div", { class: "lessons", hidden: true }, list.element, scroll);
  find("#speech").before(element);

  const title = h("span", { class: "lesson-title" });
  const present = h("button", { type: "button", class: "bare word lesson-present", title: words.presentTitle, "data-lesson": "present", onclick: () => enlarge(true) }, words.present);
  const end = h("button", { type: "button", class: "bare word lesson-end", "data-lesson": "end", onclick: () => enlarge(false) }, words.endPresent);
  find(".bar-title").append(title);
  find(".bar-actions").prepend(present);
  element.append(end);

  addEventListener("hashchange", () => {
    if (app.ui.value.workbench === "lessons") void go();
  });
  // Keys, drops and what is pasted belong to the page behind; they end here as long as it is not seen.
  document.addEventListener("keydown", (event) => {
    if (!isOn) return;
    key(event);
    event.stopPropagation();
  });
  for (const name of ["paste", "dragover", "drop"]) {
    document.addEventListener(name, (event) => {
      if (!isOn) return;
      event.stopPropagation();
      if (name !== "paste") event.preventDefault();
    });
  }

  /** Corrects the address. @param {string} hash */
  function put(hash) {
    history.replaceState(history.state, "", hash);
    takeHash();
  }

  /** Shows the step that the address names. */
  async function go() {
    const turn = (asked += 1);
    const wanted = readPlace(location.hash);
    if (wanted.lesson === null) {
      put(last);
      return go();
    }
    const head = heads.find(({ name }) => name === wanted.lesson);
    if (!head) return refuse(words.unknown(wanted.lesson.slice(0, 80)));
    try {
      const opened = await openLesson(head.name);
      if (turn !== asked || !isOn) return;
      const step = Math.min(wanted.step, opened.steps.length);
      last = linkTo(head.name, step);
      if (step !== wanted.step) put(last);
      show(opened, step);
    } catch (error) {
      if (turn === asked) refuse(words.failed(problem(error).message));
    }
  }

  /** @param {WholeLesson} opened @param {number} step */
  function show(opened, step) {
    const moved = page !== null;
    page?.close();
    [lesson, number] = [opened, step];
    page = createPage(app, opened, step, { mine, setMine: (next) => (mine = next), large: isLarge });
    place.replaceChildren(page.element);
    list.render(opened.name, step);
    write(title, opened.title);
    document.title = words.title(page.title, opened.title);
    turn(back, neighbour(-1), words.back);
    turn(next, neighbour(1), step === opened.steps.length ? words.nextLesson : words.next);
    write(count, words.stepOf(step, opened.steps.length));
    foot.hidden = false;
    scroll.scrollTop = 0;
    if (!moved) return;
    page.heading.focus({ preventScroll: true });
    app.say(words.stepTitle(step, page.title));
  }

  /** @param {string} text */
  function refuse(text) {
    page?.close();
    page = lesson = null;
    place.replaceChildren(h("p", { class: "lesson-refused", role: "alert" }, text));
    list.render(null, 0);
    write(title, "");
    document.title = words.title(words.list, "");
    foot.hidden = true;
  }

  /** The link to the step before or after, across lessons; null at either end. @param {-1 | 1} by */
  function neighbour(by) {
    if (!lesson) return null;
    const step = number + by;
    if (step >= 1 && step <= lesson.steps.length) return linkTo(lesson.name, step);
    const other = heads[heads.findIndex(({ name }) => name === lesson?.name) + by];
    return other ? linkTo(other.name, by > 0 ? 1 : other.steps.length) : null;
  }

  /** @param {HTMLAnchorElement} link @param {string | null} href @param {string} text */
  function turn(link, href, text) {
    write(link, text);
    link.hidden = href === null;
    if (href !== null) link.setAttribute("href", href);
  }

  /** @param {boolean} large */
  function enlarge(large) {
    if (large === isLarge) return;
    isLarge = large;
    root.toggleAttribute("data-present", large);
    page?.enlarge(large);
    app.say(large ? words.presenting : words.presentEnded);
    if (large) page?.heading.focus({ preventScroll: true });
    else present.focus();
  }

  /** @param {KeyboardEvent} event */
  function key(event) {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target instanceof Element ? event.target : null;
    if (event.key === "Escape" && isLarge) enlarge(false);
    else if (target?.closest("input, select, textarea, [role=menu]")) return;
    else if (["ArrowRight", "PageDown"].includes(event.key)) step(1);
    else if (["ArrowLeft", "PageUp"].includes(event.key)) step(-1);
    else if (event.key.toLowerCase() === "p") enlarge(!isLarge);
    else if (event.key.toLowerCase() === "r") page?.reset();
    else return;
    event.preventDefault();
  }

  /** @param {-1 | 1} by */
  function step(by) {
    const href = neighbour(by);
    if (href !== null) location.hash = href;
  }

  /** @param {boolean} on */
  function turnOn(on) {
    isOn = on;
    // A panel may lie over the whole page.
    if (on) /** @type {HTMLElement | null} */ (document.querySelector("[data-panel] [data-close]"))?.click();
    element.hidden = !on;
    for (const selector of BEHIND) find(selector).inert = on;
    if (on) {
      app.tool?.close();
      app.ui.set({ playing: false, probe: null });
      root.dataset.workbench = "lessons";
      void go();
      return;
    }
    enlarge(false);
    delete root.dataset.workbench;
    asked += 1;
    page?.close();
    page = lesson = null;
    place.replaceChildren();
    write(title, "");
  }

  return {
    render() {
      const on = app.ui.value.workbench === "lessons";
      if (on !== isOn) turnOn(on);
      if (theme === app.ui.value.theme) return;
      theme = app.ui.value.theme;
      page?.draw();
    },
  };
}
