/**
 * The feature list: bodies with their queues, and the shapes. Rows are chosen by pointer and by keys, renamed in place, hidden, put elsewhere by drag and by
 * Alt and an arrow, and have a menu.
 *
 * @import { Bench } from "../state.js"
 * @import { Row } from "./rows.js"
 */
import "../../../styles/part-tree.css";
import { attribute, h, write } from "../../dom.js";
import { attachMenu } from "../../frame/menu-button.js";
import { percent } from "../../format.js";
import { icon } from "../../icons.js";
import { mixed } from "../../oklab.js";
import { materialsOf } from "../edits/materials.js";
import { createActs } from "./acts.js";
import { createDrag } from "./drag.js";
import { mark } from "./marks.js";
import { chosenKey, diagnosticsFor, rowsOf, typedTo } from "./rows.js";
import { words } from "./words.js";

/** Milliseconds of a press by touch that asks for the menu, and between letters that are typed as one word. */
const LONG = 500;
const WORD = 700;
/** Most characters of a name. */
const LONGEST = 100;

/** @param {Bench} bench */
export function createTree(bench) {
  /** What was opened and closed. @type {Map<string, boolean>} */
  const opened = new Map();
  /** @type {Map<string, ReturnType<typeof createRow>>} */
  const made = new Map();
  /** @type {Row[]} */
  let rows = [];
  /** The row that has the tab stop, and the one that is renamed. */
  let at = "";
  /** @type {string | null} */
  let naming = null;
  let chosen = /** @type {string | null} */ (null);
  let typed = { text: "", time: 0 };

  const list = h("div", { class: "tree-rows", role: "tree", "aria-label": words.tree, "aria-describedby": "part-tree-help" });
  const add = h("button", { type: "button", class: "command-word", "data-action": "part-add" }, words.add);
  const element = h(
    "div",
    { class: "part-tree" },
    h("div", { class: "tree-head" }, h("h2", {}, words.heading), add),
    list,
    h("p", { id: "part-tree-help", class: "tree-help" }, words.help),
  );
  const acts = createActs(bench, { rename: startNaming, go });
  attachMenu(add, acts.additions);
  const drag = createDrag(list, { rows: () => rows, elementOf: (key) => made.get(key)?.element ?? null, put: acts.put });

  /** @param {string} key */
  const rowOf = (key) => rows.find((row) => row.key === key) ?? null;
  /** @param {EventTarget | null} target */
  const rowAt = (target) => {
    const key = target instanceof Element ? /** @type {HTMLElement | null} */ (target.closest("[role=treeitem]"))?.dataset.key : undefined;
    return key === undefined ? null : rowOf(key);
  };

  /** Goes to a row, which need not be drawn yet. @param {string} key */
  function go(key) {
    at = key;
    render();
    made.get(key)?.element.focus({ preventScroll: true });
    made.get(key)?.element.scrollIntoView({ block: "nearest" });
  }

  /** @param {Row} row */
  function choose(row) {
    at = row.key;
    acts.choose(row);
    go(row.key);
  }

  /** @param {Row} row @param {boolean} isOpen */
  function open(row, isOpen) {
    opened.set(row.key, isOpen);
    go(row.key);
  }

  /** @param {string} key */
  function startNaming(key) {
    const row = rowOf(key);
    if (!row || row.kind === "shapes" || row.kind === "default") return;
    naming = key;
    render();
    made.get(key)?.edit(row.name);
  }

  /** @param {string} text null gives up @param {boolean} isTaken */
  function endNaming(text, isTaken) {
    const row = naming === null ? null : rowOf(naming);
    if (!row) return;
    naming = null;
    const { key } = row;
    const hadFocus = list.contains(document.activeElement);
    if (isTaken) acts.rename(row, text);
    render();
    const next = made.get(key) ?? made.get(at);
    if (hadFocus) next?.element.focus({ preventScroll: true });
  }

  /** @param {Row} row @param {{left: number, top: number, bottom: number}} box */
  async function menu(row, box) {
    const items = acts.menuOf(row);
    if (items.length === 0) return;
    const { openMenu } = await import("../../frame/menu.js");
    openMenu(items, { label: row.name, box });
  }

  list.addEventListener("click", (event) => {
    const row = rowAt(event.target);
    if (!row || !(event.target instanceof Element) || naming === row.key || drag.ends()) return;
    if (event.target.closest(".tree-eye")) {
      acts.toggle(row);
      go(row.key);
    } else if (event.target.closest(".tree-fold") || row.kind === "shapes") open(row, !row.isOpen);
    else choose(row);
  });
  list.addEventListener("dblclick", (event) => {
    const row = rowAt(event.target);
    if (row && event.target instanceof Element && !event.target.closest("button, input")) startNaming(row.key);
  });
  list.addEventListener("contextmenu", (event) => {
    const row = rowAt(event.target);
    if (!row || event.target instanceof HTMLInputElement) return;
    event.preventDefault();
    // A long press has its own timer, and the browser may report it as well.
    if (/** @type {PointerEvent} */ (event).pointerType === "touch") return;
    choose(row);
    const box = event.button === 2 ? { left: event.clientX, top: event.clientY, bottom: event.clientY } : made.get(row.key)?.element.getBoundingClientRect();
    if (box) void menu(row, box);
  });
  list.addEventListener("pointerdown", (event) => {
    const row = rowAt(event.target);
    if (!row || event.button !== 0 || !(event.target instanceof Element) || event.target.closest(".tree-eye, .tree-fold, input")) return;
    const isGrip = event.target.closest(".tree-mark") !== null;
    if (row.kind === "feature" && (event.pointerType !== "touch" || isGrip)) drag.begin(event, row);
    if (event.pointerType === "touch") pressLong(event, row);
  });

  /** Opens the menu where a finger rests. @param {PointerEvent} down @param {Row} row */
  function pressLong(down, row) {
    const over = new AbortController();
    const stop = () => {
      clearTimeout(timer);
      over.abort();
    };
    const timer = setTimeout(() => {
      stop();
      drag.cancel();
      choose(row);
      void menu(row, { left: down.clientX, top: down.clientY, bottom: down.clientY });
    }, LONG);
    const moved = (/** @type {PointerEvent} */ event) => {
      if (Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) > 8) stop();
    };
    addEventListener("pointermove", moved, { signal: over.signal });
    for (const type of ["pointerup", "pointercancel"]) addEventListener(type, stop, { signal: over.signal });
  }

  list.addEventListener("keydown", (event) => {
    if (event.target instanceof HTMLInputElement) return;
    const row = rowAt(event.target);
    if (!row || event.ctrlKey || event.metaKey) return;
    if (!pressed(event, row)) return;
    event.preventDefault();
    event.stopPropagation();
  });

  /** What a key does; false when it means nothing here. @param {KeyboardEvent} event @param {Row} row */
  function pressed(event, row) {
    const here = rows.indexOf(row);
    const to = (/** @type {number} */ index) => {
      const next = rows[index];
      if (!next) return;
      if (next.kind === "shapes") go(next.key);
      else choose(next);
    };
    switch (event.key) {
      case "ArrowDown":
      case "ArrowUp": {
        const by = event.key === "ArrowDown" ? 1 : -1;
        if (event.altKey) acts.move(row, by);
        else to(here + by);
        return true;
      }
      case "ArrowRight":
        if (row.isOpen === false) open(row, true);
        else if (row.isOpen) to(here + 1);
        return true;
      case "ArrowLeft":
        if (row.isOpen) open(row, false);
        else if (row.level === 2) to(rows.findLastIndex((other, k) => k < here && other.level === 1));
        return true;
      case "Home":
        to(0);
        return true;
      case "End":
        to(rows.length - 1);
        return true;
      case "Enter":
      case " ":
        if (row.kind === "shapes") open(row, !row.isOpen);
        else choose(row);
        return true;
      case "F2":
        startNaming(row.key);
        return true;
      case "Delete":
      case "Backspace":
        acts.remove(row);
        return true;
      default: {
        if (event.key.length !== 1 || event.altKey) return false;
        const now = performance.now();
        typed = { text: now - typed.time > WORD ? event.key : typed.text + event.key, time: now };
        const found = typedTo(rows, here, typed.text);
        if (found !== null) to(found);
        return true;
      }
    }
  }

  function render() {
    const { document: doc, known, shown } = bench.now();
    rows = rowsOf(doc, opened, diagnosticsFor(doc, known));
    const next = chosenKey(shown, at);
    // The tab stop follows what is chosen elsewhere.
    if (next !== chosen && next !== null) at = next;
    chosen = next;
    if (!rowOf(at)) at = (chosen !== null && rowOf(chosen) ? chosen : rows[0]?.key) ?? "";
    const keys = new Set(rows.map(({ key }) => key));
    for (const [key, row] of made) {
      if (keys.has(key)) continue;
      row.element.remove();
      made.delete(key);
    }
    const focused = document.activeElement;
    rows.forEach((row, index) => {
      let item = made.get(row.key);
      if (!item) {
        item = createRow(row, endNaming);
        made.set(row.key, item);
      }
      if (list.children[index] !== item.element) list.insertBefore(item.element, list.children[index] ?? null);
      item.render(row, { isChosen: row.key === chosen, isTabStop: row.key === at, isNaming: row.key === naming, spoken: spokenRow(row) });
    });
    if (focused instanceof HTMLElement && focused !== document.activeElement && list.contains(focused)) focused.focus({ preventScroll: true });
  }

  /** @param {Row} row */
  function spokenRow(row) {
    const { document: doc } = bench.now();
    const colors = materialsOf(doc);
    const mix = (row.mix ?? []).flatMap((fraction, k) => (fraction > 0 && colors[k] ? [fraction === 1 ? colors[k].name : `${colors[k].name} ${percent(fraction)}`] : [])).join(", ");
    const base = {
      body: () => words.row.body(row.name),
      default: () => (row.mark === "blend" ? words.row.blend(doc.bodies[row.body].name) : words.row.standard(doc.bodies[row.body].name, mix)),
      feature: () => words.row.feature(row.name, row.feature + 1, doc.bodies[row.body].features?.length ?? 0, mix),
      shapes: () => words.row.shapes(Number(row.aside)),
      shape: () => words.row.shape(row.name, words.kinds[row.mark] ?? ""),
    }[row.kind]();
    return [base, ...(row.hidden ? [words.hidden] : []), ...(row.kind === "shape" && row.aside ? [row.aside] : [])].join(", ");
  }

  /**
   * @param {Row} first
   * @param {(text: string, isTaken: boolean) => void} named
   */
  function createRow(first, named) {
    const kind = first.kind;
    const name = h("span", { class: "tree-name" });
    const aside = h("span", { class: "tree-aside number" });
    const swatch = h("span", { class: "tree-swatch", "aria-hidden": "true" });
    const fold = h("span", { class: "tree-fold" }, /** @type {any} */ (icon("down")));
    const sign = h("span", { class: "tree-mark" }, /** @type {any} */ (mark(first.mark)));
    const eye = kind === "feature" ? h("button", { type: "button", class: "tree-eye", tabIndex: -1 }) : null;
    const reason = h("span", { class: "tree-reason", hidden: true });
    const field = h("input", { type: "text", class: "tree-field", maxLength: LONGEST, autocomplete: "off", spellcheck: false, hidden: true, "data-tree-name": "" });
    const line = h("span", { class: "tree-line" }, kind === "body" || kind === "shapes" ? fold : null, sign, name, field, aside, eye, swatch);
    const element = h("div", { role: "treeitem", class: `tree-row tree-${kind}`, "data-key": first.key, "aria-level": first.level }, line, reason);
    if (kind === "feature") element.dataset.partFeature = `${first.body}.${first.feature}`;
    if (kind === "body") element.dataset.partBody = String(first.body);
    if (kind === "default") element.dataset.partDefault = String(first.body);
    if (kind === "shape") element.dataset.treeShape = first.name;
    let drawn = first.mark;
    let eyed = "";
    let isOver = true;

    const settle = (/** @type {boolean} */ isTaken) => {
      if (isOver) return;
      isOver = true;
      named(field.value, isTaken);
    };
    field.addEventListener("blur", () => settle(true));
    field.addEventListener("keydown", (event) => {
      event.stopPropagation();
      if (event.key === "Enter") settle(true);
      if (event.key === "Escape") settle(false);
    });

    return {
      element,
      /** @param {string} text */
      edit(text) {
        isOver = false;
        field.value = text;
        field.focus();
        field.select();
      },
      /** @param {Row} row @param {{isChosen: boolean, isTabStop: boolean, isNaming: boolean, spoken: string}} state */
      render(row, { isChosen, isTabStop, isNaming, spoken }) {
        write(name, row.name);
        attribute(aside, "data-text", row.aside);
        attribute(element, "aria-label", spoken);
        attribute(element, "aria-selected", row.kind === "shapes" ? null : String(isChosen));
        attribute(element, "aria-expanded", row.isOpen === null ? null : String(row.isOpen));
        attribute(element, "tabindex", isTabStop ? "0" : "-1");
        element.classList.toggle("off", row.hidden);
        element.classList.toggle("unused", row.kind === "shape" && row.aside !== "");
        name.hidden = isNaming;
        field.hidden = !isNaming;
        attribute(field, "aria-label", words.rename(row.name));
        if (drawn !== row.mark) {
          drawn = row.mark;
          sign.replaceChildren(mark(row.mark));
        }
        if (eye) {
          const shape = row.hidden ? "shut" : "eye";
          if (eyed !== shape) {
            eyed = shape;
            eye.replaceChildren(mark(shape));
          }
          const label = (row.hidden ? words.show : words.hide)(row.name);
          attribute(eye, "aria-label", label);
          attribute(eye, "title", label);
        }
        swatch.hidden = row.mix === null;
        if (row.mix) swatch.style.backgroundColor = mixed(materialsOf(bench.now().document).map(({ color }) => color), row.mix);
        const { fault } = row;
        write(reason, fault?.message ?? "");
        reason.hidden = fault === null;
        element.classList.toggle("wrong", fault?.skipped === true);
        element.classList.toggle("remarked", fault?.skipped === false);
        attribute(element, "aria-description", fault?.message ?? null);
      },
    };
  }

  return { element, render };
}
