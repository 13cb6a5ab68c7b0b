/**
 * The tools of the list of curves: each row goes up, down and away, and curves come in at an end and between two. Loaded when there are two curves.
 *
 * @import { App } from "../state/app.js"
 */
import "../../styles/stack.css";
import { commandReason, commandTitle, runCommand } from "../commands.js";
import { attribute, h, write } from "../dom.js";
import { icon } from "../icons.js";
import { words as flow } from "../harmonic/words.js";
import { curveName } from "../state/app.js";
import { isHarmonic } from "../state/look.js";
import { move, remove } from "./stack-commands.js";
import { words } from "./words.js";

/**
 * @param {App} app
 * @param {HTMLElement} list of the rows, one `.curve-line` for each curve
 */
export function createStackRows(app, list) {
  /** @typedef {{element: HTMLElement, up: HTMLButtonElement, down: HTMLButtonElement, away: HTMLButtonElement}} Tools */
  /** @type {Tools[]} */
  const tools = [];
  const command = (/** @type {string} */ name, /** @type {string} */ text) =>
    h("button", { type: "button", class: "command-word", "data-action": name, onclick: () => void runCommand(app, name) }, text);
  const add = command("add-curve", words.add);
  const insert = command("insert-curve", words.insert);
  list.after(h("div", { class: "stack-commands" }, add, insert));

  list.addEventListener("keydown", (event) => {
    const by = event.key === "ArrowUp" ? -1 : event.key === "ArrowDown" ? 1 : 0;
    const index = [...list.children].findIndex((line) => event.target instanceof Node && line.contains(event.target));
    if (!event.altKey || by === 0 || index < 0 || isHarmonic(app.store.document)) return;
    event.preventDefault();
    event.stopPropagation();
    if (move(app, index, by)) rowOf(index + by)?.focus();
  });

  /** @param {number} index */
  const rowOf = (index) => /** @type {HTMLElement | null} */ (list.children[index]?.querySelector("[data-curve-row]"));

  /** @param {number} index @returns {Tools} */
  function toolsOf(index) {
    const button = (/** @type {string} */ name, /** @type {string} */ picture, /** @type {() => void} */ act) =>
      h("button", { type: "button", class: "bare icon-only", "data-stack": `${name}-${index}`, onclick: act }, icon(picture));
    const shift = (/** @type {-1 | 1} */ by) => () => {
      if (!move(app, index, by)) return;
      // The pointer's next press means the same curve, and so does the key's.
      const next = tools[index + by];
      const wanted = by < 0 ? next?.up : next?.down;
      (wanted && !wanted.disabled ? wanted : rowOf(index + by))?.focus();
    };
    const up = button("up", "up", shift(-1));
    const down = button("down", "down", shift(1));
    const away = button("remove", "cross", () => {
      remove(app, index);
      rowOf(Math.max(0, index - 1))?.focus();
    });
    return { element: h("span", { class: "curve-tools" }, up, down, away), up, down, away };
  }

  /** @param {HTMLElement} button @param {string} text */
  function name(button, text) {
    attribute(button, "aria-label", text);
    attribute(button, "title", text);
  }

  return {
    render() {
      const { document } = app.store;
      const count = document.curves.length;
      const isFlow = isHarmonic(document);
      while (tools.length < Math.min(count, list.children.length)) {
        const item = toolsOf(tools.length);
        list.children[tools.length].append(item.element);
        tools.push(item);
      }
      tools.forEach((item, index) => {
        // Two curves have one order, which the command Swap turns round.
        item.element.hidden = count < 3;
        if (index >= count) return;
        // The curves of a harmonic blend lie side by side, in no order.
        item.up.hidden = item.down.hidden = isFlow;
        const label = curveName(document, index);
        name(item.up, words.up(label));
        name(item.down, words.down(label));
        name(item.away, words.remove(label));
        item.up.disabled = index === 0;
        item.down.disabled = index === count - 1;
      });
      add.disabled = commandReason(app, "add-curve") !== null;
      write(add, isFlow ? flow.add : words.add);
      add.title = add.disabled ? commandTitle(app, "add-curve") : isFlow ? flow.addHelp : words.addHelp;
      insert.hidden = isFlow;
      insert.disabled = commandReason(app, "insert-curve") !== null;
      insert.title = commandTitle(app, "insert-curve");
    },
  };
}
