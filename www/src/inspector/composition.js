/**
 * Strips that show how the composition runs along a curve, with a stop at every key: drag one, move it with the arrows, add one by
 * double click. They stand for every curve while compositions are edited, else for those that are not the same everywhere.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument } from "../types.js"
 * @import { Key } from "../stage/key-edits.js"
 */
import { attribute, h, write } from "../dom.js";
import { mixed } from "../oklab.js";
import { choose, dragKey, insert, pressed, spokenKey } from "../stage/key-edits.js";
import { curveName, pointName } from "../state/app.js";
import { isOpen } from "../spline.js";
import { mixAt } from "../state/composition.js";
import { strings } from "../strings.js";

/**
 * @param {App} app
 * @param {number} curve
 */
export function compositionStrip(app, curve) {
  const bar = h("div", { class: "composition", role: "group", "data-strip": curve });
  const along = h("span", {});
  const count = h("span", {});
  const element = h(
    "div",
    { class: "composition-row" },
    bar,
    h("div", { class: "composition-note number" }, along, count),
  );
  /** @type {HTMLButtonElement[]} */
  const stops = [];

  /** @param {MouseEvent} event */
  function fractionAt(event) {
    const box = bar.getBoundingClientRect();
    return Math.min(1 - 1e-6, Math.max(0, (event.clientX - box.left) / box.width));
  }
  /** @param {EventTarget | null} target */
  const indexOf = (target) => stops.findIndex((stop) => stop === target);

  /** @param {Key} key */
  function focus(key) {
    app.ui.set({ composing: true });
    choose(app, key);
    render();
    stops[key.index]?.focus({ preventScroll: true });
  }

  bar.addEventListener("focusin", (event) => {
    const index = indexOf(event.target);
    if (index >= 0) choose(app, { curve, index });
  });
  bar.addEventListener("pointerdown", (event) => {
    const index = indexOf(event.target);
    if (index < 0 || event.button !== 0) return;
    event.preventDefault();
    focus({ curve, index });
    dragKey(app, event, { curve, index }, fractionAt);
  });
  bar.addEventListener("dblclick", (event) => {
    if (indexOf(event.target) < 0) focus(insert(app, curve, fractionAt(event)));
  });
  bar.addEventListener("keydown", (event) => {
    const index = indexOf(event.target);
    if (index < 0) return;
    if (event.key === "Enter" || event.key === " ") app.ui.set({ composing: true });
    const next = pressed(app, event, { curve, index });
    if (!next) return;
    event.preventDefault();
    event.stopPropagation();
    focus(next);
  });

  /** @param {number} wanted */
  function grow(wanted) {
    while (stops.length < wanted) {
      const name = `${pointName(curve, stops.length)} stop`;
      const stop = h("button", { type: "button", class: "stop", "data-stop": name });
      stops.push(stop);
      bar.append(stop);
    }
    while (stops.length > wanted) stops.pop()?.remove();
  }

  function render() {
    const { document } = app.store;
    const { composing, key } = app.ui.value;
    const keys = document.curves[curve]?.composition ?? [];
    element.hidden = keys.length === 0 || (keys.length < 2 && !composing);
    if (element.hidden) return;
    bar.style.backgroundImage = gradient(document, curve);
    attribute(bar, "aria-label", strings.composition.group(curveName(document, curve)));
    write(along, strings.materials.along(curveName(document, curve)));
    write(count, strings.materials.stops(keys.length));
    grow(keys.length);
    const chosen = composing && key?.curve === curve ? key.index : null;
    const colors = document.materials.map(({ color }) => color);
    keys.forEach(({ at, mix }, index) => {
      const stop = stops[index];
      stop.style.left = `${at * 100}%`;
      stop.style.setProperty("--mix", mixed(colors, mix));
      attribute(stop, "aria-label", spokenKey(document, { curve, index }));
      attribute(stop, "tabindex", index === (chosen ?? 0) ? "0" : "-1");
      stop.classList.toggle("chosen", index === chosen);
    });
  }
  return { element, render };
}

/**
 * @param {CurvesDocument} document
 * @param {number} curve
 */
function gradient({ curves, materials }, curve) {
  const keys = curves[curve].composition;
  const open = isOpen(curves[curve]);
  const colors = materials.map(({ color }) => color);
  const stops = [
    { at: 0, mix: mixAt(keys, 0, open) },
    ...keys,
    // Just before the seam: at 1 the first key itself may stand.
    { at: 1, mix: mixAt(keys, 1 - 1e-9, open) },
  ];
  const list = stops.map(({ at, mix }) => `${mixed(colors, mix)} ${(at * 100).toFixed(2)}%`);
  return `linear-gradient(to right in oklab, ${list.join(", ")})`;
}
