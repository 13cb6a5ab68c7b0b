/**
 * A field for one number: type, step with the arrows, or drag sideways.
 *
 * @import { Editing } from "./run.js"
 *
 * @typedef {object} NumberOptions
 * @property {string} label
 * @property {string} name for the tests and the data attribute
 * @property {Node | string} [prefix]
 * @property {number} min
 * @property {number} max
 * @property {number | (() => number)} step
 * @property {number} decimals shown at least
 * @property {boolean} [whole] whole numbers only
 * @property {boolean} [rounded] shown with its decimals alone, and with every digit while it has the focus
 *
 * @typedef {object} NumberField
 * @property {HTMLElement} element
 * @property {HTMLElement} error shown below the control
 * @property {(value: number) => void} set
 */
import { attribute, h, write } from "../dom.js";
import { editable, fixed, parse } from "../format.js";
import { strings } from "../strings.js";
import { newRun } from "./run.js";

/** Pixels of sideways movement before a press becomes a drag, and for one step of it. */
const DEAD = 3;
const PIXELS_A_STEP = 4;

/**
 * @param {NumberOptions} options
 * @param {Editing<number>} editing
 * @returns {NumberField}
 */
export function numberField(options, editing) {
  const { label, name, prefix, min, max, decimals, whole = false, rounded = false } = options;
  let value = min;
  let typed = false;
  let run = newRun(name);

  const error = h("div", { class: "field-error", id: `error-${name}`, hidden: true });
  const input = h("input", {
    type: "text",
    inputMode: whole ? "numeric" : "decimal",
    autocomplete: "off",
    spellcheck: false,
    role: "spinbutton",
    "aria-label": label,
    "aria-valuemin": min,
    "aria-valuemax": max,
    "data-field": name,
  });
  const element = h("span", { class: "field number" }, prefix ? h("span", { class: "prefix" }, prefix) : null, input);

  const step = () => (typeof options.step === "function" ? options.step() : options.step);
  const within = (/** @type {number} */ v) => {
    const bounded = Math.min(max, Math.max(min, v));
    return whole ? Math.round(bounded) : Number(bounded.toPrecision(12));
  };

  /** @param {string | null} message */
  function complain(message) {
    write(error, message ?? "");
    error.hidden = message === null;
    attribute(input, "aria-invalid", message === null ? null : "true");
    attribute(input, "aria-describedby", message === null ? null : error.id);
    element.classList.toggle("wrong", message !== null);
  }

  /** Why a text is not accepted, or null. @param {number | null} v */
  function reason(v) {
    if (v === null) return strings.field.notNumber;
    if (v >= min && v <= max && (!whole || Number.isInteger(v))) return null;
    return (whole ? strings.field.whole : strings.field.range)(editable(min, 0), editable(max, 0));
  }

  function show() {
    if (typed) return;
    const brief = whole || (rounded && document.activeElement !== input);
    const text = brief ? fixed(value, whole ? 0 : decimals) : editable(value, decimals);
    input.defaultValue = text;
    if (input.value !== text) input.value = text;
    attribute(input, "aria-valuenow", String(value));
  }

  /**
   * Keys that come faster than the page is drawn count on from each other, not from what is still shown.
   * @param {number} next
   * @param {string} [run]
   */
  function change(next, run) {
    value = next;
    editing.change(next, run);
  }

  /** @param {boolean} restore whether a wrong text gives way to the last valid value */
  function settle(restore) {
    if (!typed) return;
    const next = parse(input.value);
    const wrong = reason(next);
    if (wrong === null && next !== null) {
      typed = false;
      complain(null);
      if (next !== value) change(next);
    } else if (restore) {
      typed = false;
      complain(null);
    } else {
      complain(wrong);
    }
    show();
  }

  input.addEventListener("input", () => {
    typed = true;
    complain(reason(parse(input.value)));
  });
  input.addEventListener("focus", show);
  input.addEventListener("blur", () => {
    settle(true);
    show();
    run = newRun(name);
    editing.end?.();
  });
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") {
      settle(false);
      input.select();
    } else if (event.key === "Escape") {
      event.stopPropagation();
      if (typed) {
        typed = false;
        complain(null);
        show();
      } else {
        editing.cancel?.(run);
        run = newRun(name);
      }
      input.select();
    } else if (event.key === "ArrowUp" || event.key === "ArrowDown") {
      event.preventDefault();
      settle(true);
      const factor = event.shiftKey ? 10 : event.altKey && !whole ? 0.1 : 1;
      change(within(value + (event.key === "ArrowUp" ? 1 : -1) * factor * step()), run);
    }
  });

  input.addEventListener("mousedown", (event) => {
    if (document.activeElement !== input) event.preventDefault();
  });
  input.addEventListener("pointerdown", (down) => {
    if (down.button !== 0 || document.activeElement === input) return;
    const start = value;
    const drag = newRun(name);
    let dragging = false;
    const over = new AbortController();
    /** @param {PointerEvent} event */
    const move = (event) => {
      const by = event.clientX - down.clientX;
      if (!dragging && Math.abs(by) < DEAD) return;
      if (!dragging) input.setPointerCapture(down.pointerId);
      dragging = true;
      element.classList.add("dragging");
      const factor = event.shiftKey ? 10 : event.altKey && !whole ? 0.1 : 1;
      editing.change(within(start + Math.round(by / PIXELS_A_STEP) * factor * step()), drag);
    };
    /** @param {PointerEvent} event */
    const up = (event) => {
      over.abort();
      element.classList.remove("dragging");
      if (dragging) {
        if (event.type === "pointercancel") editing.cancel?.(drag);
        editing.end?.();
      } else if (event.type === "pointerup") {
        input.focus();
        input.select();
      }
    };
    window.addEventListener("pointermove", move, { signal: over.signal });
    window.addEventListener("pointerup", up, { signal: over.signal });
    window.addEventListener("pointercancel", up, { signal: over.signal });
  });

  return {
    element,
    error,
    set(next) {
      value = next;
      show();
    },
  };
}
