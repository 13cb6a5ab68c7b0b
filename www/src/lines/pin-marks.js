/**
 * Pins on the figure, and handles at the ends of the line that is explained. Dragging such an end pins the line; the rest is solved
 * again on the way. They are elements of their own beside the control points, which keep their places.
 *
 * @import { App } from "../state/app.js"
 * @import { Point } from "../types.js"
 *
 * @typedef {{pin: number, end: "u" | "v"} | {line: number, end: "u" | "v"}} Mark
 */
import { KeyRun, stride } from "../controls/arrows.js";
import { whileHeld } from "../controls/held.js";
import { newRun } from "../controls/run.js";
import { attribute, find, h, svg } from "../dom.js";
import { fixed } from "../format.js";
import { nearestParameter, placeOn } from "../spline.js";
import { curveName, currentMatch } from "../state/app.js";
import { isHarmonic, lookedAt } from "../state/look.js";
import { toPlane, toScreen } from "../view.js";
import { dropPin, pinLine, pinsOf, putPin } from "./pin-edits.js";
import { domainOf, pinAt, pinOf } from "./pins.js";
import { words } from "./words.js";

/** Part of the domain of an arrow key. */
const STEP = 0.01;
/** Pixels before a press counts as a drag. */
const DEAD = 3;
const ENDS = /** @type {const} */ (["u", "v"]);

/** @param {App} app */
export function createPinMarks(app) {
  const path = svg("path", { class: "pin-lines" });
  const rivals = svg("path", { class: "rival-lines" });
  const drawing = svg("svg", { class: "marks", "aria-hidden": "true" }, rivals, path);
  const layer = h(
    "div",
    { class: "overlay pins", role: "application", "aria-label": words.pins.group, "aria-describedby": "pin-help", "data-pins": "" },
    h("p", { id: "pin-help", class: "spoken" }, words.pins.help),
  );
  find("#overlay").before(drawing);
  find("#overlay").after(layer);
  /** @type {HTMLButtonElement[]} */
  const buttons = [];
  /** @type {Mark[]} */
  let marks = [];
  /** @type {[Point, Point][]} */
  let contenders = [];
  const runs = new KeyRun("pin");

  /** @param {EventTarget | null} target */
  const markOf = (target) => marks[buttons.findIndex((button) => target instanceof Node && button.contains(target))];

  /** The ends of a line or a pin, as parameters of the curves as drawn. @param {Mark} mark */
  function endsOf(mark) {
    if ("pin" in mark) return pinsOf(app)[mark.pin] ?? null;
    const match = currentMatch(app);
    return match && pinOf(app.store.document, match, mark.line);
  }

  /** Makes sure that the line of a mark is pinned. @param {Mark} mark @param {string} name of the run @returns {Mark} */
  function pinned(mark, name) {
    if ("pin" in mark) return mark;
    const pin = pinLine(app, mark.line, name);
    return pin < 0 ? mark : { pin, end: mark.end };
  }

  /** @param {Mark} mark */
  function focus(mark) {
    render();
    const index = marks.findIndex(
      (other) => other.end === mark.end && "pin" in other && "pin" in mark && other.pin === mark.pin,
    );
    buttons[index]?.focus({ preventScroll: true });
  }

  /** @param {Mark} mark */
  function speak(mark) {
    const index = marks.findIndex((other) => JSON.stringify(other) === JSON.stringify(mark));
    app.say(buttons[index]?.getAttribute("aria-label") ?? "");
  }

  layer.addEventListener("focusin", (event) => {
    const mark = markOf(event.target);
    if (mark && "pin" in mark) app.ui.set({ pin: mark.pin });
  });

  layer.addEventListener("keydown", (event) => {
    const mark = markOf(event.target);
    if (!mark || event.ctrlKey || event.metaKey) return;
    const sign = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    if (sign) {
      const run = runs.press();
      const ends = endsOf(mark);
      const held = pinned(mark, run);
      const curve = app.store.document.curves[ENDS.indexOf(mark.end)];
      if (!ends || !curve || !("pin" in held)) return;
      const [low, high] = domainOf(curve);
      const by = sign * STEP * (high - low) * stride(event);
      putPin(app, held.pin, held.end, ends[held.end] + by, run);
      focus(held);
      speak(held);
    } else if ((event.key === "Delete" || event.key === "Backspace") && "pin" in mark) {
      dropPin(app, mark.pin);
      find("#probe-keys").focus();
    } else if (event.key === "Escape") {
      if (!app.store.cancel(runs.name)) {
        app.ui.set({ line: null, pin: null });
        find("#probe-keys").focus();
      }
      runs.renew();
    } else return;
    event.preventDefault();
    event.stopPropagation();
  });

  layer.addEventListener("pointerdown", (event) => {
    const mark = markOf(event.target);
    if (!mark || event.button !== 0) return;
    event.preventDefault();
    const button = /** @type {HTMLElement} */ (event.target);
    button.focus({ preventScroll: true });
    drag(event, mark);
  });

  /** @param {PointerEvent} down @param {Mark} mark */
  function drag(down, mark) {
    const name = newRun("pin drag");
    const curve = app.store.document.curves[ENDS.indexOf(mark.end)];
    let held = mark;
    let moved = false;
    /** @param {PointerEvent} event */
    const move = (event) => {
      if (event.pointerId !== down.pointerId) return;
      if (!moved && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) < DEAD) return;
      const { view, size } = app.ui.value;
      if (!view || !curve) return;
      if (!moved) held = pinned(mark, name);
      moved = true;
      if (!("pin" in held)) return;
      const box = find("#stage").getBoundingClientRect();
      const at = toPlane(view, size, [event.clientX - box.left, event.clientY - box.top]);
      putPin(app, held.pin, held.end, nearestParameter(curve, at), name);
    };
    /** @param {boolean} undo */
    const finish = (undo) => {
      delete layer.dataset.drag;
      if (undo) app.store.cancel(name);
      app.store.endRun();
      if (!moved || undo) return;
      focus(held);
      speak(held);
    };
    layer.dataset.drag = "";
    whileHeld({ move, finish });
  }

  /** @param {number} count */
  function grow(count) {
    while (buttons.length < count) {
      const button = h("button", { type: "button", class: "pin-end", "data-furniture": "" }, h("i", {}));
      buttons.push(button);
      layer.append(button);
    }
    while (buttons.length > count) buttons.pop()?.remove();
  }

  function render() {
    const { mode, view, size, drawing: isDrawing, composing, line, pin: chosen } = app.ui.value;
    const { document } = app.store;
    // A harmonic blend has no ruling lines to be pinned.
    layer.hidden = isHarmonic(lookedAt(app)) || mode !== "figure" || isDrawing || composing || !view || document.curves.length !== 2;
    drawing.style.display = layer.hidden ? "none" : "";
    if (layer.hidden || !view) return;
    const match = currentMatch(app);
    const ends = line === null || !match ? null : pinOf(document, match, line);
    const free = line !== null && ends !== null && pinAt(document, ends) < 0;
    marks = [
      ...pinsOf(app).flatMap((_, pin) => ENDS.map((end) => ({ pin, end }))),
      ...(free ? ENDS.map((end) => ({ line, end })) : []),
    ];
    grow(marks.length);
    /** @type {{[pin: number]: Point[]}} */
    const drawn = {};
    const bad = match?.diagnostics.find(({ code }) => code === "pins")?.pins ?? [];
    marks.forEach((mark, i) => {
      const button = /** @type {HTMLButtonElement} */ (buttons[i]);
      const index = ENDS.indexOf(mark.end);
      const curve = document.curves[index];
      const at = endsOf(mark)?.[mark.end];
      button.hidden = !curve || at === undefined;
      if (!curve || at === undefined) return;
      const [low, high] = domainOf(curve);
      const place = toScreen(view, size, placeOn(curve, (at - low) / (high - low)).at);
      button.style.transform = `translate(${place[0].toFixed(1)}px, ${place[1].toFixed(1)}px)`;
      const isPin = "pin" in mark;
      if (isPin) (drawn[mark.pin] ??= []).push(place);
      const name = curveName(document, index);
      const label = isPin
        ? words.pins.end(words.pins.pin(mark.pin), name, fixed(at, 3))
        : words.pins.lineEnd(mark.line, name, fixed(at, 3));
      attribute(button, "aria-label", label);
      attribute(button, "title", label);
      attribute(button, "data-pin-end", isPin ? `${mark.pin + 1}${mark.end}` : `line-${mark.end}`);
      button.classList.toggle("free", !isPin);
      button.classList.toggle("chosen", isPin && mark.pin === chosen);
      button.classList.toggle("wrong", isPin && bad.includes(mark.pin));
    });
    const d = (/** @type {Point[][]} */ list) =>
      list.map((points) => `M${points.map((p) => p.map((x) => x.toFixed(1)).join(" ")).join("L")}`).join("");
    attribute(path, "d", d(Object.values(drawn)));
    attribute(rivals, "d", line === null ? "" : d(contenders.map((pair) => pair.map((at) => toScreen(view, size, at)))));
  }

  return {
    render,
    /** Shows the rivals of the explained line. @param {[Point, Point][]} lines */
    contend(lines) {
      contenders = lines;
      render();
    },
  };
}
