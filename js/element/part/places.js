/**
 * Reading a figure of a part: by pointer, by a tap, and by keys, which move a mark. The page keeps its wheel, and its finger; a picture that
 * was brought nearer is moved by a drag of the mouse.
 *
 * @import { PartPlace, Point, View } from "../../directrix.js"
 * @import { Size } from "../plane.js"
 * @import { Zoom } from "../zooms.js"
 *
 * @typedef {object} Material
 * @property {string} name
 * @property {string} color
 *
 * @typedef {object} Host
 * @property {() => View} view
 * @property {() => View} fitted the view that shows all
 * @property {() => Size} size
 * @property {() => {materials: readonly Material[], bodies: readonly {name: string}[], unit: string}} names
 * @property {(view: View, isDrag: boolean) => void} look
 * @property {() => void} rest a drag has ended
 * @property {(at: Point) => Promise<PartPlace | null>} probe rejects where the question was given up
 * @property {(text: string) => void} say
 */
import { h } from "../dom.js";
import { toPlane, toScreen } from "../plane.js";
import { fixed } from "../words.js";
import { createZooms } from "../zooms.js";
import { words } from "./words.js";

/** CSS pixels that a press may move and still be a tap. */
const DEAD = 4;
/** Factor of a press of the buttons, and the nearest view as a multiple of the fitted one. */
const ZOOM = 1.5;
const NEAREST = 32;
/** CSS pixels of an arrow key, with Shift, and of the card from the mark. */
const STEP = 4;
const LONG_STEP = 40;
const GAP = 14;
const EDGE = 8;
/** Materials and features that the card names. */
const NAMED = 4;

let count = 0;

/** @param {Host} host */
export function createPlaces(host) {
  const id = `places-help-${(count += 1)}`;
  const help = h("p", { class: "spoken", id }, words.help);
  const element = h("div", { class: "places", role: "application", tabindex: "0", "aria-label": words.picture, "aria-describedby": id });
  const mark = h("div", { class: "mark", hidden: "" });
  const card = h("div", { class: "card", hidden: "", "aria-hidden": "true" });
  /** The place that is read. @type {Point | null} */
  let at = null;
  /** Of a drag: where it was last, and whether it is one. @type {{ last: [number, number], isMoved: boolean } | null} */
  let held = null;
  let asked = 0;

  /** @param {Zoom} zoom */
  function act(zoom) {
    const { view, fitted } = { view: host.view(), fitted: host.fitted() };
    const factor = zoom === "nearer" ? ZOOM : 1 / ZOOM;
    const scale = Math.min(fitted.scale * NEAREST, Math.max(fitted.scale, view.scale * factor));
    const center = scale === fitted.scale || zoom === "fit" ? fitted.center : (at ?? view.center);
    host.look(zoom === "fit" ? fitted : { center, scale }, false);
    host.say(zoom === "fit" ? words.fit : words.zoomed(fixed((100 * scale) / fitted.scale, 0)));
    render();
  }

  /** Place in a picture that may be scaled, as on slides. @param {PointerEvent | MouseEvent} event @returns {[number, number]} */
  function placeOf({ clientX, clientY }) {
    const box = element.getBoundingClientRect();
    return [((clientX - box.left) * element.clientWidth) / (box.width || 1), ((clientY - box.top) * element.clientHeight) / (box.height || 1)];
  }

  const isNear = () => host.view().scale > host.fitted().scale * 1.001;

  function render() {
    element.classList.toggle("moves", isNear());
    mark.hidden = at === null;
    if (at === null) {
      card.hidden = true;
      return;
    }
    const [x, y] = toScreen(host.view(), host.size(), at);
    mark.style.transform = `translate(${x}px, ${y}px)`;
    if (card.hidden) return;
    const { width, height } = host.size();
    const left = x + GAP + card.offsetWidth + EDGE > width ? x - GAP - card.offsetWidth : x + GAP;
    const top = Math.min(y - card.offsetHeight / 2, height - card.offsetHeight - EDGE);
    card.style.transform = `translate(${Math.round(Math.max(EDGE, left))}px, ${Math.round(Math.max(EDGE, top))}px)`;
  }

  /** @param {PartPlace} place */
  function fill({ body, fractions, distances, nearest }) {
    const { materials, bodies, unit } = host.names();
    const own = (fractions ?? []).map((fraction, k) => ({ fraction, material: materials[k] })).filter(({ fraction }) => fraction >= 5e-4);
    own.sort((a, b) => b.fraction - a.fraction);
    const held = [...distances].sort((a, b) => Number(b.feature === nearest) - Number(a.feature === nearest) || a.distance - b.distance).slice(0, NAMED);
    const percent = (/** @type {number} */ fraction) => words.percent(fixed(100 * fraction, 1));
    const far = (/** @type {number} */ distance) => words.distance(fixed(distance, 2), unit);
    const title = bodies.length > 1 ? [h("div", {}, h("span", { class: "name" }, bodies[body]?.name ?? ""))] : [];
    const rows = own.slice(0, NAMED).map(({ fraction, material }) => {
      const swatch = h("span", { class: "swatch" });
      swatch.style.background = material?.color ?? "";
      return h("div", {}, swatch, h("span", { class: "name" }, material?.name ?? ""), h("b", {}, percent(fraction)));
    });
    const notes = held.map(({ name, distance }) => h("div", { class: "far" }, h("span", { class: "name" }, name), h("b", {}, far(distance))));
    card.replaceChildren(...title, ...(fractions ? rows : [h("div", { class: "far" }, words.printed)]), ...notes);
    return words.spoken(
      bodies[body]?.name ?? "",
      fractions ? own.map(({ fraction, material }) => `${material?.name ?? ""} ${percent(fraction)}`) : [words.printed],
      held.map(({ name, distance }) => `${name} ${far(distance)}`),
    );
  }

  /** @param {Point | null} place @param {boolean} [aloud] */
  async function read(place, aloud = false) {
    const turn = (asked += 1);
    at = place;
    if (place === null) return render();
    render();
    try {
      const found = await host.probe(place);
      if (turn !== asked) return;
      card.hidden = found === null;
      const text = found ? fill(found) : words.outside;
      render();
      if (aloud) host.say(words.place(fixed(place[0], 2), fixed(place[1], 2), text));
    } catch {
      // Another place is asked for, or the figure itself says why nothing answers.
    }
  }

  /** @param {[number, number]} by CSS pixels */
  function step([dx, dy]) {
    const { width, height } = host.size();
    const [x, y] = at ? toScreen(host.view(), host.size(), at) : [width / 2 - dx, height / 2 - dy];
    const next = toPlane(host.view(), host.size(), [Math.min(width, Math.max(0, x + dx)), Math.min(height, Math.max(0, y + dy))]);
    void read(next, true);
  }

  element.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "touch" || event.button !== 0) return;
    element.classList.add("pointed");
    if (!isNear()) return;
    held = { last: placeOf(event), isMoved: false };
    element.setPointerCapture(event.pointerId);
  });
  element.addEventListener("pointermove", (event) => {
    if (event.pointerType === "touch") return;
    const place = placeOf(event);
    if (!held) return void read(toPlane(host.view(), host.size(), place));
    const [dx, dy] = [place[0] - held.last[0], place[1] - held.last[1]];
    if (!held.isMoved && Math.hypot(dx, dy) < DEAD) return;
    held = { last: place, isMoved: true };
    element.classList.add("held");
    const { center, scale } = host.view();
    host.look({ center: [center[0] - dx / scale, center[1] + dy / scale], scale }, true);
    void read(null);
  });
  const up = () => {
    if (held?.isMoved) host.rest();
    held = null;
    element.classList.remove("held");
  };
  element.addEventListener("pointerup", up);
  element.addEventListener("pointercancel", up);
  element.addEventListener("pointerleave", (event) => {
    if (event.pointerType !== "touch" && !held) void read(null);
  });
  // A tap of a finger, which the page has not taken for a scroll; a mouse has read it already.
  element.addEventListener("click", (event) => {
    element.classList.add("pointed");
    if (event.detail > 0) void read(toPlane(host.view(), host.size(), placeOf(event)), true);
  });
  element.addEventListener("blur", () => {
    element.classList.remove("pointed");
    void read(null);
  });
  element.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    element.classList.remove("pointed");
    const far = event.shiftKey ? LONG_STEP : STEP;
    const arrows = /** @type {{ [key: string]: [number, number] }} */ ({ ArrowLeft: [-far, 0], ArrowRight: [far, 0], ArrowUp: [0, -far], ArrowDown: [0, far] });
    const zooms = /** @type {{ [key: string]: Zoom }} */ ({ "+": "nearer", "=": "nearer", "-": "farther", f: "fit", F: "fit" });
    if (arrows[event.key]) step(arrows[event.key]);
    else if (zooms[event.key]) act(zooms[event.key]);
    else if (event.key === "Escape") element.blur();
    else return;
    event.preventDefault();
  });

  return {
    /** What lies over the picture. */
    elements: [help, element, mark, card],
    zooms: createZooms(words.view, words, act),
    render,
    /** Nothing is read any more. */
    clear: () => void read(null),
  };
}
