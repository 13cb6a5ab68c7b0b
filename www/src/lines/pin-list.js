/**
 * The list of pins in the inspector: a field for either end, a button that removes, and beside them why two cannot be kept.
 *
 * @import { App } from "../state/app.js"
 */
import "../../styles/lines.css";
import { numberField } from "../controls/number-field.js";
import { attribute, h, write } from "../dom.js";
import { icon, symbol } from "../icons.js";
import { pinFault } from "../explain.js";
import { curveName, currentMatch } from "../state/app.js";
import { dropPin, pinsOf, putPin } from "./pin-edits.js";
import { domainOf } from "./pins.js";
import { words as all } from "./words.js";

const words = all.pins;
const ENDS = /** @type {const} */ (["u", "v"]);

/**
 * @param {App} app
 * @returns {{element: HTMLElement, render: () => void}}
 */
export function createPinList(app) {
  const rows = h("ol", { class: "pin-rows", "aria-label": words.heading });
  const reason = h("p", { class: "field-error", "data-pin-reason": "", role: "status" });
  const element = h("div", { class: "pin-list", "data-pin-list": "" }, rows, reason);
  /** @type {ReturnType<typeof createRow>[]} */
  const shown = [];
  /** Domains the fields were made for. */
  let made = "";

  return {
    element,
    render() {
      const pins = pinsOf(app);
      const { curves } = app.store.document;
      element.hidden = pins.length === 0 || curves.length !== 2;
      if (element.hidden) return;
      const key = JSON.stringify(curves.map((curve, i) => [domainOf(curve), curveName(app.store.document, i)]));
      if (key !== made) {
        rows.replaceChildren();
        shown.length = 0;
      }
      made = key;
      while (shown.length < pins.length) {
        const row = createRow(app, shown.length);
        shown.push(row);
        rows.append(row.element);
      }
      while (shown.length > pins.length) shown.pop()?.element.remove();
      const fault = currentMatch(app)?.diagnostics.find(({ code }) => code === "pins");
      const bad = fault?.pins ?? [];
      shown.forEach((row, i) => row.render(app.ui.value.pin === i, bad.includes(i)));
      reason.hidden = bad.length === 0;
      write(reason, fault ? `${pinFault(fault)} ${words.mend(bad.length)}` : "");
    },
  };
}

/** @param {App} app @param {number} index */
function createRow(app, index) {
  const name = h(
    "button",
    { type: "button", class: "command-word pin-name", onclick: () => app.ui.set({ pin: index, line: null }) },
    words.pin(index),
  );
  const fields = ENDS.map((end, i) => {
    const curve = app.store.document.curves[i];
    const [min, max] = curve ? domainOf(curve) : [0, 1];
    const step = (max - min) / 100;
    return numberField(
      { label: words.field(index, curveName(app.store.document, i)), name: `pin-${index + 1}${end}`, prefix: symbol(end), min, max, step, decimals: 3 },
      {
        change: (value, run) => putPin(app, index, end, value, run),
        end: () => app.store.endRun(),
        cancel: (run) => void app.store.cancel(run),
      },
    );
  });
  const remove = h(
    "button",
    { type: "button", class: "bare icon-only", "aria-label": words.remove(index), title: words.remove(index), "data-pin-remove": index + 1 },
    icon("cross", 14),
  );
  remove.addEventListener("click", () => {
    const list = remove.closest("[data-pin-list]");
    dropPin(app, index);
    requestAnimationFrame(() => {
      const next = /** @type {HTMLElement | null} */ (list?.querySelector("[data-pin-remove]") ?? document.querySelector("[data-select=method]"));
      next?.focus();
    });
  });
  const element = h("li", { class: "pin-row" }, name, ...fields.map((field) => field.element), remove, ...fields.map((field) => field.error));
  return {
    element,
    /** @param {boolean} chosen @param {boolean} wrong */
    render(chosen, wrong) {
      const pin = pinsOf(app)[index];
      if (!pin) return;
      ENDS.forEach((end, i) => fields[i]?.set(pin[end]));
      attribute(name, "aria-pressed", String(chosen));
      element.classList.toggle("wrong", wrong);
    },
  };
}
