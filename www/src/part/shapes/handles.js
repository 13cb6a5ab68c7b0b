/**
 * Shapes over the picture: outlines, each with a tab stop of its own, and the handles of the chosen one as buttons that take focus, keys and names.
 *
 * @import { Point, Size, View } from "../../types.js"
 * @import { Bench } from "../state.js"
 * @import { NamedShape } from "./geometry.js"
 * @import { Held } from "./places.js"
 */
import { attribute, h, svg, write } from "../../dom.js";
import { shapeOf, shapesOf } from "../edits/shapes.js";
import { handleCount, isReach } from "./geometry.js";
import { handleName, spokenPlace } from "./moves.js";
import { controlPath, handleAt, litBy, outlinePath, rolesOf } from "./places.js";
import { words } from "./words.js";

/** Pixels between one handle and the next that shows; those between them show once the picture is zoomed in. */
const APART = 12;
/** Pixels round the window within which a handle is made. */
const BEYOND = 30;

/**
 * @param {Bench} bench
 * @param {() => {hovered: string | null, rims: ReadonlyMap<string, number>, hidden: boolean}} state `rims` has the angles of rim handles that were dragged
 */
export function createHandles(bench, state) {
  const label = h("span", { class: "handle-name", "aria-hidden": "true" });
  const element = h("div", { class: "shape-overlay", role: "group", "aria-label": words.handles.region }, h("p", { id: "shape-help", class: "spoken" }, words.handles.help), label);
  /** @type {ReturnType<typeof createOutline>[]} */
  const outlines = [];

  /** An outline for every shape; those of shapes that are gone go as well. @param {number} count */
  function grow(count) {
    while (outlines.length < count) {
      const outline = createOutline();
      outlines.push(outline);
      label.before(outline.element);
    }
    while (outlines.length > count) outlines.pop()?.element.remove();
  }

  return {
    element,

    render() {
      const { document, shown, view, size } = bench.now();
      const { hovered, rims, hidden } = state();
      element.hidden = !view || !shown.shapes || shown.compare;
      if (!view || element.hidden) return;
      const shapes = shapesOf(document);
      grow(shapes.length);
      const role = rolesOf(document);
      const lit = litBy(document, shown.body, shown.feature);
      shapes.forEach((shape, i) => {
        const { name } = shape;
        const chosen = !hidden && name === shown.shape;
        outlines[i].render({
          shape,
          view,
          size,
          role: role(name),
          lit: lit.has(name) || name === shown.lit,
          chosen,
          hovered: !hidden && name === hovered,
          point: chosen ? shown.point : null,
          rim: rims.get(name) ?? 0,
          quiet: hidden,
        });
      });
      const shape = shapeOf(document, shown.shape);
      label.hidden = !shape || hidden;
      if (!shape || hidden) return;
      write(label, shown.point === null || isReach(shape, shown.point) ? shape.name : handleName(shape, shown.point));
      const [x, y] = handleAt(view, size, shape, shown.point ?? 0, rims.get(shape.name) ?? 0);
      const inside = x > -40 && y > -20 && x < size.width + 20 && y < size.height + 20;
      label.hidden = !inside;
      const width = label.offsetWidth;
      label.style.transform = `translate(${x + 16 + width > size.width ? x - 16 - width : x + 16}px, ${y < 32 ? y + 8 : y - 26}px)`;
    },

    /** @param {Held} held */
    focus({ shape, point }) {
      const index = shapesOf(bench.now().document).findIndex(({ name }) => name === shape);
      outlines[index]?.part(point)?.focus({ preventScroll: true });
    },

    /** Marks what is held, for the look of it. @param {Held | null} held @param {boolean} touch */
    hold(held, touch) {
      for (const each of element.querySelectorAll(".held")) each.classList.remove("held", "touched");
      if (!held) return;
      const index = shapesOf(bench.now().document).findIndex(({ name }) => name === held.shape);
      outlines[index]?.part(held.point)?.classList.add("held", ...(touch ? ["touched"] : []));
    },
  };
}

/**
 * @typedef {object} Look
 * @property {NamedShape} shape
 * @property {View} view
 * @property {Size} size
 * @property {"boundary" | "reference" | "unused"} role
 * @property {boolean} lit whether the chosen feature is measured to it, or what is said of it is looked at
 * @property {boolean} chosen
 * @property {boolean} hovered
 * @property {number | null} point the chosen one
 * @property {number} rim radians
 * @property {boolean} quiet no handles, and no tab stop
 */

function createOutline() {
  const under = svg("path", { class: "shape-under" });
  const line = svg("path", { class: "shape-line" });
  const control = svg("path", { class: "shape-control" });
  const glow = svg("path", { class: "shape-glow" });
  const stop = svg("path", { class: "shape-stop", role: "button", tabindex: "0" });
  const lines = svg("svg", { class: "shape-lines", width: 1, height: 1 }, glow, under, control, line, stop);
  const element = h("div", { class: "shape", role: "application", "aria-describedby": "shape-help" }, /** @type {any} */ (lines));
  /** @type {Map<number, HTMLButtonElement>} */
  const buttons = new Map();
  /** @type {unknown[]} */
  let traced = [];

  /** @param {Look} look @returns {Map<number, Point>} the handles that are made, with their places */
  function wanted({ shape, view, size, chosen, hovered, quiet, point, rim }) {
    /** @type {Map<number, Point>} */
    const places = new Map();
    if (quiet || (!chosen && !hovered)) return places;
    /** @type {Point} */
    let last = [-Infinity, -Infinity];
    for (let handle = 0; handle < handleCount(shape); handle += 1) {
      const at = handleAt(view, size, shape, handle, rim);
      const inside = at[0] > -BEYOND && at[1] > -BEYOND && at[0] < size.width + BEYOND && at[1] < size.height + BEYOND;
      const apart = isReach(shape, handle) || Math.max(Math.abs(at[0] - last[0]), Math.abs(at[1] - last[1])) >= APART;
      if (handle !== point && !(inside && apart)) continue;
      places.set(handle, at);
      last = at;
    }
    return places;
  }

  return {
    element,

    /** @param {number | null} point @returns {HTMLElement | SVGElement | undefined} */
    part: (point) => (point === null ? stop : buttons.get(point)),

    /** @param {Look} look */
    render(look) {
      const { shape, view, size, role, lit, chosen, hovered, point, rim, quiet } = look;
      const { name } = shape;
      const key = [shape, view, size.width, size.height, chosen, rim];
      if (key.some((each, i) => each !== traced[i])) {
        traced = key;
        const d = outlinePath(view, size, shape);
        for (const path of [under, line, glow, stop]) attribute(path, "d", d);
        let extra = chosen ? controlPath(view, size, shape) : "";
        if (chosen && shape.kind === "line") {
          const [a, b] = [0, 1].map((handle) => handleAt(view, size, shape, handle).map((value) => value.toFixed(1)).join(" "));
          extra = `M${a}L${b}`;
        }
        attribute(control, "d", extra || null);
      }
      attribute(element, "aria-label", words.handles.group(name));
      attribute(element, "data-role", role);
      for (const [flag, on] of Object.entries({ lit, chosen, hovered, whole: chosen && point === null, dot: shape.kind === "point" })) element.classList.toggle(flag, on);
      attribute(stop, "data-part-shape", name);
      attribute(stop, "aria-label", spokenPlace(shape, null));
      attribute(stop, "tabindex", quiet || (chosen && point !== null) ? "-1" : "0");
      attribute(stop, "aria-pressed", String(chosen));

      const places = wanted(look);
      for (const [handle, button] of buttons) {
        if (places.has(handle)) continue;
        button.remove();
        buttons.delete(handle);
      }
      let before = /** @type {Element} */ (lines);
      for (const [handle, [x, y]] of places) {
        let button = buttons.get(handle);
        if (!button) {
          button = h("button", { type: "button", class: "handle" });
          buttons.set(handle, button);
        }
        if (before.nextElementSibling !== button) before.after(button);
        before = button;
        attribute(button, "data-part-point", `${name}.${handle}`);
        button.classList.toggle("square", isReach(shape, handle));
        button.classList.toggle("round", !isReach(shape, handle));
        button.classList.toggle("chosen", chosen && handle === point);
        button.style.transform = `translate(${x.toFixed(2)}px, ${y.toFixed(2)}px)`;
        attribute(button, "tabindex", chosen && handle === point ? "0" : "-1");
        attribute(button, "aria-label", spokenPlace(shape, handle));
      }
    },
  };
}

/**
 * What an event is about: a handle by its number, or the whole of a shape.
 * @param {EventTarget | null} target
 * @returns {Held | null}
 */
export function heldBy(target) {
  if (!(target instanceof Element)) return null;
  const handle = target.closest("[data-part-point]")?.getAttribute("data-part-point");
  if (handle) {
    // A name may have points of its own.
    const dot = handle.lastIndexOf(".");
    return { shape: handle.slice(0, dot), point: Number(handle.slice(dot + 1)) };
  }
  const name = target.closest("[data-part-shape]")?.getAttribute("data-part-shape");
  return name === undefined || name === null ? null : { shape: name, point: null };
}
