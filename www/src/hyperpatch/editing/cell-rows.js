/**
 * Choosing several cells, and what happens to edits that make one invalid.
 *
 * @import { Known } from "../runner.js"
 * @import { Shown } from "../state.js"
 */
import { checkBox, segment } from "../../controls/choices.js";
import { row } from "../../controls/row.js";
import { h, write } from "../../dom.js";
import { words } from "./words.js";

const said = words.cells;

/**
 * @param {object} of
 * @param {() => {known: Known | null, shown: Shown}} of.now
 * @param {(patch: Partial<Shown>) => void} of.change
 */
export function cellRows({ now, change }) {
  const several = checkBox({ name: "body-several", text: [said.several] }, (on) => change({ picksCells: on }));
  const count = h("span", { class: "number body-chosen-count" });
  const all = h("button", { type: "button", class: "command-word", "data-cells": "all" }, said.all);
  const none = h("button", { type: "button", class: "command-word", "data-cells": "none" }, said.none);
  all.addEventListener("click", () => {
    const ids = now().known?.cells.map(({ id }) => id) ?? [];
    change({ cells: ids, cell: ids.at(-1) ?? null });
  });
  none.addEventListener("click", () => change({ cells: [], cell: null }));
  const policy = segment(
    { label: words.refusal.setting, name: "invalid", choices: /** @type {const} */ (["ask", "refuse", "keep"]).map((value) => ({ value, text: words.refusal.settings[value] })) },
    (value) => change({ invalid: value }),
  );
  return {
    element: h("div", {}, h("div", { class: "body-choosing" }, several.element, count, all, none), row(words.refusal.setting, policy)),
    render() {
      const { shown } = now();
      several.set(shown.picksCells);
      policy.set(shown.invalid);
      write(count, shown.cells.length > 1 ? said.chosen(shown.cells.length) : "");
    },
  };
}
