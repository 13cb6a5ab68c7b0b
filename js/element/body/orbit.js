/**
 * The camera of a figure, by pointer, touch and keys. The page keeps its wheel, and its finger until the picture was tapped: then a drag
 * turns, and two fingers move and zoom, until something else gets the focus.
 *
 * @import { Camera, Frame } from "../../space/camera.js"
 * @import { Move } from "../../space/keys.js"
 *
 * @typedef {object} Host
 * @property {() => Camera} camera
 * @property {() => Frame} frame
 * @property {() => number} fitted distance of the camera that sees the whole body
 * @property {(camera: Camera, isDrag: boolean) => void} turn
 * @property {(view?: import("../../space/camera.js").StandardView) => void} fit
 * @property {() => void} rest a drag has ended
 * @property {() => boolean} [isFlat] whether the picture is moved where others are turned
 * @property {(text: string) => void} say
 */
import { dragged, middleOf, panned, turned, zoomed } from "../../space/camera.js";
import { moveOf } from "../../space/keys.js";
import { h } from "../dom.js";
import { fixed } from "../words.js";
import { createZooms } from "../zooms.js";
import { words } from "./words.js";

/** CSS pixels that a press may move and still be a tap. */
const DEAD = 4;
/** Factor of a press of the buttons. */
const ZOOM = 1.25;
/** CSS pixels that a picture is moved by where another would turn by a degree. */
const SLIDE = 5;
/** Distances, as multiples of the fitted one. */
const NEAREST = 0.25;
const FARTHEST = 4;

let count = 0;

/** @param {Host} host */
export function createOrbit(host) {
  const id = `orbit-help-${(count += 1)}`;
  const help = h("p", { class: "spoken", id }, words.help);
  const element = h("div", { class: "orbit", role: "application", tabindex: "0", "aria-label": words.camera, "aria-describedby": id });
  const hint = h("p", { class: "hint", "aria-hidden": "true" }, h("span", { class: "drag" }, words.drag), h("span", { class: "tap" }, words.tap));
  /** @type {{ [name in import("../zooms.js").Zoom]: Move }} */
  const moves = { farther: { zoom: 1 / ZOOM }, nearer: { zoom: ZOOM }, fit: { fit: true } };
  const buttons = createZooms(words.camera, words, (name) => act(moves[name]));
  /** @type {Map<number, [number, number]>} */
  const held = new Map();
  let isMoved = false;
  let pans = false;

  /** @param {number} factor @param {[number, number]} [at] @param {boolean} [isDrag] */
  function zoom(factor, at = middleOf(host.frame()), isDrag = false) {
    const whole = host.fitted();
    const { distance } = host.camera();
    const wanted = Math.min(whole * FARTHEST, Math.max(whole * NEAREST, distance / factor));
    host.turn(zoomed(host.camera(), host.frame(), at, distance / wanted, whole), isDrag);
  }

  /** @param {Move} move */
  function act(move) {
    if ("view" in move || "fit" in move) host.fit("view" in move ? move.view : undefined);
    else if ("zoom" in move) zoom(move.zoom);
    else if ("pan" in move) host.turn(panned(host.camera(), host.frame(), ...move.pan), false);
    else if (host.isFlat?.()) host.turn(panned(host.camera(), host.frame(), move.turn[0] * SLIDE, -move.turn[1] * SLIDE), false);
    else host.turn(turned(host.camera(), ...move.turn), false);
    const { azimuth, elevation, distance } = host.camera();
    if ("zoom" in move) host.say(words.zoomed(fixed((100 * host.fitted()) / distance, 0)));
    else host.say("fit" in move ? words.fit : words.seen(fixed(azimuth, 0), fixed(elevation, 0)));
  }

  /** Place in a picture that may be scaled, as on slides. @param {PointerEvent} event @returns {[number, number]} */
  function placeOf({ clientX, clientY }) {
    const box = element.getBoundingClientRect();
    return [((clientX - box.left) * element.clientWidth) / (box.width || 1), ((clientY - box.top) * element.clientHeight) / (box.height || 1)];
  }

  /** By a press, which needs no ring round what was pressed. */
  function enter() {
    element.classList.add("pointed");
    element.focus({ preventScroll: true });
  }

  element.addEventListener("pointerdown", (event) => {
    if (event.button > 2 || (event.pointerType === "touch" && !element.classList.contains("entered"))) return;
    if (event.pointerType !== "touch") enter();
    element.setPointerCapture(event.pointerId);
    [isMoved, pans] = held.size === 0 ? [false, event.shiftKey || event.button > 0] : [true, pans];
    held.set(event.pointerId, placeOf(event));
    // Neither selects texts nor drags pictures of the page.
    event.preventDefault();
  });
  element.addEventListener("pointermove", (event) => {
    const before = held.get(event.pointerId);
    if (!before) return;
    const at = placeOf(event);
    const by = /** @type {[number, number]} */ ([at[0] - before[0], at[1] - before[1]]);
    if (!isMoved && Math.hypot(...by) < DEAD) return;
    isMoved = true;
    element.classList.add("held", "known");
    held.set(event.pointerId, at);
    if (held.size === 1) {
      host.turn(pans || host.isFlat?.() ? panned(host.camera(), host.frame(), ...by) : dragged(host.camera(), ...by), true);
      return;
    }
    const other = [...held].find(([pointer]) => pointer !== event.pointerId)?.[1] ?? before;
    const spread = (/** @type {[number, number]} */ [x, y]) => Math.max(1, Math.hypot(x - other[0], y - other[1]));
    host.turn(panned(host.camera(), host.frame(), by[0] / 2, by[1] / 2), true);
    zoom(spread(at) / spread(before), [(at[0] + other[0]) / 2, (at[1] + other[1]) / 2], true);
  });
  const up = (/** @type {PointerEvent} */ event) => {
    if (!held.delete(event.pointerId) || held.size > 0) return;
    element.classList.remove("held");
    host.rest();
  };
  element.addEventListener("pointerup", up);
  element.addEventListener("pointercancel", up);
  // A tap of a finger, which the page has not taken for a scroll.
  element.addEventListener("click", enter);
  element.addEventListener("contextmenu", (event) => element.classList.contains("entered") && event.preventDefault());
  element.addEventListener("focus", () => element.classList.add("entered"));
  element.addEventListener("blur", () => {
    element.classList.remove("entered", "held", "pointed");
    held.clear();
  });
  element.addEventListener("keydown", (event) => {
    element.classList.remove("pointed");
    if (event.ctrlKey || event.metaKey) return;
    const move = moveOf(event, true);
    if (event.key === "Escape") element.blur();
    else if (move) {
      element.classList.add("known");
      act(move);
    } else return;
    event.preventDefault();
  });

  return {
    /** What lies over the picture. */
    elements: [help, element, hint],
    buttons,
  };
}
