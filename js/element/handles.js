/**
 * Control points as elements over the picture, for pointer, touch and keys.
 *
 * @import { Curve, CurvesDocument, Point, View } from "../directrix.js"
 * @import { Size } from "./plane.js"
 */
import { attribute, h } from "./dom.js";
import { planePoints } from "./in-space.js";
import { arrowStep, toPlane, toScreen } from "./plane.js";
import { fixed, words } from "./words.js";

/** @type {{ [key: string]: Point }} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Milliseconds after the last key until a move by keys counts as over. */
const PAUSE = 400;

/**
 * @typedef {object} Host
 * @property {() => { document: CurvesDocument, view: View, size: Size } | null} state `null` while there is no figure
 * @property {(document: CurvesDocument, isMoving: boolean) => void} change
 * @property {(text: string) => void} say
 */

/** A clamped curve repeats its first point at the end, and both share a handle. @param {Curve} curve */
const handleCount = ({ form, points }) => (form === "clamped" ? points.length - 1 : points.length);

/**
 * A document with one control point elsewhere.
 *
 * @param {CurvesDocument} document
 * @param {number} curve
 * @param {number} point
 * @param {Point} at
 * @returns {CurvesDocument}
 */
function moved(document, curve, point, at) {
  const isThere = (/** @type {number} */ i, /** @type {Curve} */ { form, points }) =>
    i === point || (form === "clamped" && point === 0 && i === points.length - 1);
  const curves = document.curves.map((each, c) =>
    c === curve ? { ...each, points: planePoints(each).map((from, i) => (isThere(i, each) ? at : from)) } : each,
  );
  return { ...document, curves };
}

export class Handles {
  #host;
  /** @type {HTMLButtonElement[][]} */
  #buttons = [[], []];
  #groups;
  /** The point of each curve that Tab leads to. */
  #stops = [0, 0];
  /** The document before the move that Escape takes back. @type {CurvesDocument | null} */
  #before = null;
  /** @type {{ id: number, curve: number, point: number, offset: Point } | null} */
  #held = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #pause;

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
    const help = h("p", { class: "spoken", id: "help" }, words.handles.help);
    this.#groups = [0, 1].map(() => h("div", { role: "group", "aria-describedby": "help" }));
    this.element = h("div", { class: "handles" }, help, ...this.#groups);
    this.element.addEventListener("pointerdown", (event) => this.#grab(event));
    this.element.addEventListener("pointermove", (event) => this.#drag(event));
    this.element.addEventListener("pointerup", (event) => this.#drop(event));
    this.element.addEventListener("pointercancel", (event) => this.#drop(event));
    this.element.addEventListener("keydown", (event) => this.#key(event));
    this.element.addEventListener("focusin", (event) => {
      const at = placeOf(event.target);
      if (!at) return;
      this.#stops[at.curve] = at.point;
      if (!this.#held) this.#before = this.#host.state()?.document ?? null;
      this.render();
    });
    this.element.addEventListener("focusout", () => this.#settle());
  }

  /** Whether a point is being moved. */
  get isHeld() {
    return this.#held !== null;
  }

  /** Forgets the move under way: another document has come. */
  reset() {
    this.#held = null;
    this.#before = null;
    clearTimeout(this.#pause);
    this.#pause = undefined;
    for (const element of this.element.querySelectorAll(".held")) element.classList.remove("held", "touched");
  }

  render() {
    const state = this.#host.state();
    this.element.hidden = !state;
    if (!state) return;
    const { document, view, size } = state;
    this.#groups.forEach((group, c) => {
      const curve = document.curves[c];
      const buttons = this.#buttons[c];
      const count = curve ? handleCount(curve) : 0;
      for (let i = buttons.length; i < count; i++) {
        const button = h("button", { type: "button", class: `handle ${c === 0 ? "round" : "square"}`, "data-handle": `${c} ${i}` });
        buttons.push(button);
        group.append(button);
      }
      for (const extra of buttons.splice(count)) extra.remove();
      attribute(group, "aria-label", words.handles.group(curve?.name ?? words.handles.curve(c)));
      this.#stops[c] = Math.min(this.#stops[c], Math.max(0, count - 1));
      buttons.forEach((button, i) => {
        const at = planePoints(curve)[i];
        const [x, y] = toScreen(view, size, at);
        button.style.transform = `translate(${x.toFixed(2)}px, ${y.toFixed(2)}px)`;
        attribute(button, "tabindex", this.#stops[c] === i ? "0" : "-1");
        attribute(button, "aria-label", spoken(c, i, at));
      });
    });
  }

  /** @param {PointerEvent} event */
  #grab(event) {
    const at = placeOf(event.target);
    const state = this.#host.state();
    if (!at || !state || this.#held || event.button !== 0) return;
    const button = this.#buttons[at.curve][at.point];
    const [x, y] = toScreen(state.view, state.size, planePoints(state.document.curves[at.curve])[at.point]);
    const from = this.#pointer(event);
    button.setPointerCapture(event.pointerId);
    button.focus({ preventScroll: true });
    this.#before = state.document;
    this.#held = { id: event.pointerId, ...at, offset: [x - from[0], y - from[1]] };
    button.classList.add("held", ...(event.pointerType === "touch" ? ["touched"] : []));
    event.preventDefault();
  }

  /** @param {PointerEvent} event */
  #drag(event) {
    const held = this.#held;
    const state = this.#host.state();
    if (!held || !state || held.id !== event.pointerId) return;
    const [x, y] = this.#pointer(event);
    const inside = (/** @type {number} */ value, /** @type {number} */ side) => Math.min(side, Math.max(0, value));
    const place = /** @type {Point} */ ([
      inside(x + held.offset[0], state.size.width),
      inside(y + held.offset[1], state.size.height),
    ]);
    this.#move(state.document, held.curve, held.point, toPlane(state.view, state.size, place), true);
  }

  /** @param {PointerEvent} event */
  #drop(event) {
    const held = this.#held;
    if (!held || held.id !== event.pointerId) return;
    this.#held = null;
    this.#buttons[held.curve][held.point]?.classList.remove("held", "touched");
    const state = this.#host.state();
    if (!state) return;
    if (state.document !== this.#before) this.#host.change(state.document, false);
    this.#host.say(spoken(held.curve, held.point, planePoints(state.document.curves[held.curve])[held.point]));
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const at = placeOf(event.target);
    const state = this.#host.state();
    if (!at || !state || event.ctrlKey || event.metaKey) return;
    const { curve, point } = at;
    const arrow = ARROWS[event.key];
    const count = this.#buttons[curve].length;
    if (arrow) {
      const by = arrowStep(state.document) * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
      const [x, y] = state.document.curves[curve].points[point];
      const place = /** @type {Point} */ ([tidy(x + arrow[0] * by), tidy(y + arrow[1] * by)]);
      this.#move(state.document, curve, point, place, true);
      this.#host.say(spoken(curve, point, place));
      clearTimeout(this.#pause);
      this.#pause = setTimeout(() => this.#settle(), PAUSE);
    } else if (event.key === "PageDown" || event.key === "PageUp") {
      this.#buttons[curve][(point + (event.key === "PageDown" ? 1 : count - 1)) % count].focus({ preventScroll: true });
    } else if (event.key === "Escape" && this.#before && this.#before !== state.document) {
      this.#held = null;
      this.#buttons[curve][point].classList.remove("held", "touched");
      this.#host.change(this.#before, false);
      this.#host.say(`${words.handles.restored}: ${spoken(curve, point, planePoints(this.#before.curves[curve])[point])}`);
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  }

  /** The end of a move by keys. */
  #settle() {
    if (this.#pause === undefined) return;
    clearTimeout(this.#pause);
    this.#pause = undefined;
    const state = this.#host.state();
    if (state) this.#host.change(state.document, false);
  }

  /**
   * @param {CurvesDocument} document
   * @param {number} curve
   * @param {number} point
   * @param {Point} at
   * @param {boolean} isMoving
   */
  #move(document, curve, point, at, isMoving) {
    const [x, y] = document.curves[curve].points[point];
    if (x !== at[0] || y !== at[1]) this.#host.change(moved(document, curve, point, at), isMoving);
  }

  /** @param {PointerEvent} event @returns {Point} CSS pixels from the upper left corner of the picture */
  #pointer(event) {
    const { left, top, width } = this.element.getBoundingClientRect();
    // A page may scale its figures, as slides do.
    const scale = width / this.element.offsetWidth || 1;
    return [(event.clientX - left) / scale, (event.clientY - top) / scale];
  }
}

/** Without the digits that sums of decimal steps leave behind. @param {number} value */
const tidy = (value) => Number(value.toPrecision(12));

/** @param {number} curve @param {number} point @param {Point} at */
function spoken(curve, point, [x, y]) {
  return words.handles.point(words.handles.name(curve, point), fixed(x, 2), fixed(y, 2));
}

/** @param {EventTarget | null} target */
function placeOf(target) {
  const name = target instanceof HTMLElement ? target.dataset.handle : undefined;
  if (name === undefined) return null;
  const [curve, point] = name.split(" ").map(Number);
  return { curve, point };
}
