/**
 * The list of operations: what makes the body, a line each. One is chosen by a click or the arrow keys, which also chooses what it touched; its
 * numbers can be changed where it stands, it can come earlier or later, and it can go.
 *
 * @import { App } from "../../state/app.js"
 * @import { Group } from "../../inspector/group.js"
 * @import { OperationResult } from "../../../../js/directrix.js"
 * @import { Known } from "../runner.js"
 * @import { BodyDocument } from "../document.js"
 * @import { Operation } from "../edits.js"
 */
import { attribute, h, write } from "../../dom.js";
import { bodyOf } from "../document.js";
import { changed, idsOf, shifted, without } from "../edits.js";
import { checkLines } from "./check-lines.js";
import { createNumbers } from "./operation-numbers.js";
import { words } from "./words.js";

const said = words.operations;
/** Operations listed at first: the newest. */
const LISTED = 60;

/**
 * @param {App} app
 * @param {object} of
 * @param {() => {known: Known | null, isCurrent: boolean}} of.now
 * @param {() => number} of.step of lengths, document units
 * @param {(result: OperationResult, operation: Operation) => void} of.show chooses what an operation touched
 * @param {import("./checks.js").Checks} of.checks
 * @returns {Group}
 */
export function operationsGroup(app, { now, step, show, checks }) {
  const { store } = app;
  /** The identifier of the chosen one. @type {number | null} */
  let chosen = null;
  let isWhole = false;
  /** @type {readonly Operation[] | null} */
  let drawn = null;
  let drawnKey = "";
  const list = h("div", { class: "operation-list", role: "listbox", "aria-label": said.list, "aria-describedby": "operation-help", "data-operations": "" });
  const help = h("p", { id: "operation-help", hidden: true }, said.help);
  const more = h("button", { type: "button", class: "command-word", "data-operations-all": "" }, said.showAll);
  const moreText = h("span", {});
  const moreRow = h("p", { class: "body-note operation-more" }, moreText, " ", more);
  more.addEventListener("click", () => {
    isWhole = true;
    drawn = null;
    render();
  });
  const numbers = createNumbers(app, {
    step,
    change(patch, run) {
      const place = placeOfChosen();
      if (place < 0) return;
      commit((document) => changed(document, place, patch), run);
    },
  });
  const earlier = push("earlier", () => shift(-1));
  const later = push("later", () => shift(1));
  const remove = push("remove", () => removeChosen());
  const made = checkLines();
  const detail = h("div", { class: "operation-detail" }, numbers.element, h("div", { class: "body-buttons" }, earlier, later, remove), made.element);

  /** @param {"earlier" | "later" | "remove"} name @param {() => void} act */
  function push(name, act) {
    return h("button", { type: "button", class: "push", "data-operation": name, onclick: act }, said[name]);
  }

  /** @param {(document: BodyDocument) => BodyDocument} change @param {string} [run] */
  function commit(change, run) {
    store.commit({ change: /** @type {any} */ (change), ...(run === undefined ? {} : { run }) });
  }

  const placeOfChosen = () => (chosen === null ? -1 : idsOf(bodyOf(app).operations).indexOf(chosen));

  /** @param {1 | -1} by */
  function shift(by) {
    const place = placeOfChosen();
    const { length } = bodyOf(app).operations;
    if (place < 0 || place + by < 0 || place + by >= length) return;
    commit((document) => shifted(document, place, by));
    app.say(said.shifted(place + by + 1, length));
    focusChosen();
  }

  function removeChosen() {
    const place = placeOfChosen();
    if (place < 0) return;
    const { operations } = bodyOf(app);
    const ids = idsOf(operations);
    const text = words.sentence(operations[place]);
    chosen = ids[place + 1] ?? ids[place - 1] ?? null;
    commit((document) => without(document, place));
    app.say(said.removed(text));
    focusChosen();
  }

  const focusChosen = () => /** @type {HTMLElement | null} */ (list.querySelector(`[data-operation-id="${chosen}"]`))?.focus();

  /** @param {number} id */
  function choose(id) {
    chosen = id;
    const { operations } = bodyOf(app);
    const place = placeOfChosen();
    const result = now().known?.operations.find((each) => each.id === id);
    render();
    if (result && operations[place]) show(result, operations[place]);
  }

  list.addEventListener("keydown", (event) => {
    const { operations } = bodyOf(app);
    const ids = idsOf(operations);
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    const focused = /** @type {HTMLElement} */ (event.target).dataset.operationId;
    const here = ids.indexOf(Number(focused));
    if (here < 0) return;
    if (event.altKey && by) {
      chosen = ids[here];
      shift(/** @type {1 | -1} */ (by));
    } else if (event.key === "Delete" || event.key === "Backspace") {
      chosen = ids[here];
      removeChosen();
    } else if (event.key === "Home" || event.key === "End") {
      choose(event.key === "Home" ? Number(/** @type {HTMLElement} */ (list.firstElementChild).dataset.operationId) : ids[ids.length - 1]);
      focusChosen();
    } else if (by && ids[here + by] !== undefined) {
      choose(ids[here + by]);
      focusChosen();
    } else if (event.key === "Enter" || event.key === " ") choose(ids[here]);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });

  function render() {
    const document = bodyOf(app);
    const { operations } = document;
    const ids = idsOf(operations);
    const { known } = now();
    const results = new Map(known?.operations.map((result) => [result.id, result]) ?? []);
    const from = isWhole ? 0 : Math.max(0, operations.length - LISTED);
    const key = `${from} ${chosen}`;
    if (operations !== drawn || key !== drawnKey) {
      drawn = operations;
      drawnKey = key;
      const focused = list.contains(globalThis.document.activeElement) ? /** @type {HTMLElement} */ (globalThis.document.activeElement).dataset.operationId : undefined;
      const rows = operations.slice(from).map((operation, n) => {
        const id = ids[from + n];
        const row = h(
          "div",
          { class: "operation-row", role: "option", "data-operation-id": String(id), onclick: () => choose(id) },
          h("span", { class: "number operation-place" }, String(from + n + 1)),
          h("span", { class: "operation-text" }, h("span", {}, words.sentence(operation)), h("span", { class: "operation-reason", hidden: true })),
        );
        row.tabIndex = id === chosen || (chosen === null && n === operations.length - from - 1) ? 0 : -1;
        attribute(row, "aria-selected", String(id === chosen));
        return row;
      });
      list.replaceChildren(...rows);
      if (chosen !== null && !ids.includes(chosen) && rows.length) rows[rows.length - 1].tabIndex = 0;
      if (focused !== undefined) /** @type {HTMLElement | null} */ (list.querySelector(`[data-operation-id="${focused}"]`) ?? list.querySelector('[tabindex="0"]'))?.focus();
    }
    for (const row of /** @type {Iterable<HTMLElement>} */ (list.children)) {
      const result = results.get(Number(row.dataset.operationId));
      const reason = /** @type {HTMLElement} */ (row.querySelector(".operation-reason"));
      const isIdle = result !== undefined && !result.applied;
      row.classList.toggle("idle", isIdle);
      reason.hidden = !isIdle;
      write(reason, isIdle ? `${said.idle}: ${result.reason ?? ""}` : "");
    }
    moreRow.hidden = from === 0;
    write(moreText, said.more(from));
    const place = placeOfChosen();
    detail.hidden = place < 0;
    if (place < 0) return;
    numbers.render(operations[place], document);
    earlier.disabled = place === 0;
    later.disabled = place === operations.length - 1;
    attribute(earlier, "title", earlier.disabled ? said.first : null);
    attribute(later, "title", later.disabled ? said.last : null);
    const result = results.get(ids[place]);
    made.render(result && result.made.length > 0 ? checks.of(result.id) : null);
  }

  return {
    name: "operations",
    heading: words.groups.operations,
    body: h("div", {}, help, moreRow, list, detail),
    phrase() {
      const idle = now().known?.operations.filter(({ applied }) => !applied).length ?? 0;
      return said.phrase(bodyOf(app).operations.length, idle);
    },
    render,
  };
}
