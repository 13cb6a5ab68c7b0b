/**
 * Arrows and squares round a point by which it is dragged: along an axis, in a plane of two axes, or across the view from its middle.
 *
 * @import { Camera, Frame } from "./camera.js"
 * @import { Vector } from "./vector.js"
 * @import { Point } from "../types.js"
 *
 * @typedef {object} GizmoMoves
 * @property {(place: Vector, run: string) => void} move
 * @property {(run: string) => void} end
 * @property {(run: string) => void} undo
 *
 * @typedef {"x" | "y" | "z" | "yz" | "xz" | "xy" | "view"} Part What the point is held by.
 */
import { whileHeld } from "../controls/held.js";
import { newRun } from "../controls/run.js";
import { attribute, h, svg } from "../dom.js";
import { axesOf, rayAt, seenAt, unitsPerPixel } from "./camera.js";
import { add, cross, dot, scaled, subtract, unit } from "./vector.js";

/** CSS pixels: an arrow, its head, the near and the far edge of a square. */
const LONG = 78;
const HEAD = 9;
const NEAR = 22;
const FAR = 38;
/** The least that is seen of an arrow and of a square by which they can still be held: the sine of the angle to the view. */
const LEAST = 0.18;

/** @type {Readonly<Record<Exclude<Part, "view">, {axes: number[]}>>} */
const PARTS = { yz: { axes: [1, 2] }, xz: { axes: [0, 2] }, xy: { axes: [0, 1] }, x: { axes: [0] }, y: { axes: [1] }, z: { axes: [2] } };

/** @type {readonly Vector[]} */
const UNITS = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/**
 * Where a point goes that is held by a part of the gizmo.
 * @param {Part} part
 * @param {Vector} start where it was
 * @param {Vector} back from the point to the eye
 * @param {{from: Vector, along: Vector}} ray through the pointer
 * @returns {Vector | null} null where the ray does not tell
 */
export function heldAt(part, start, back, { from, along }) {
  const axes = part === "view" ? [] : PARTS[part].axes;
  if (axes.length === 1) {
    // The point of the axis that is nearest to the ray.
    const axis = UNITS[axes[0]];
    const normal = cross(along, cross(axis, along));
    const slope = dot(axis, normal);
    return slope === 0 ? null : add(start, scaled(axis, dot(subtract(from, start), normal) / slope));
  }
  const normal = axes.length === 2 ? cross(UNITS[axes[0]], UNITS[axes[1]]) : back;
  const slope = dot(along, normal);
  if (slope === 0) return null;
  const t = dot(subtract(start, from), normal) / slope;
  return t > 0 ? add(from, scaled(along, t)) : null;
}

/** Rounds to whole steps, what is moved at all. @param {Vector} place @param {Vector} start @param {number} step */
export const onSteps = (place, start, step) =>
  /** @type {Vector} */ (place.map((value, k) => (Math.abs(value - start[k]) < step * 1e-6 ? start[k] : Math.round(value / step) * step)));

export class Gizmo {
  #parts;
  #handles;
  #names = ["x", "y", "z"].map((name) => svg("text", { class: "gizmo-name", "text-anchor": "middle", "dominant-baseline": "central" }, name));
  /** @type {Vector | null} */
  #point = null;
  /** @type {Part | null} */
  #held = null;
  /** @type {{camera: Camera, frame: Frame} | null} */
  #seen = null;

  /** @param {GizmoMoves} moves @param {() => number | null} step that places rest on; null for none */
  constructor(moves, step) {
    const names = /** @type {Exclude<Part, "view">[]} */ (Object.keys(PARTS));
    this.#parts = names.map((part) => ({ part, shape: svg("path", { class: PARTS[part].axes.length === 1 ? "gizmo-arrow" : "gizmo-square" }) }));
    this.element = svg("svg", { class: "plane-marks", "aria-hidden": "true" }, ...this.#parts.map(({ shape }) => shape), ...this.#names);
    // The keys of the picture and the number fields do the same, so these are no stops of the keyboard.
    this.#handles = /** @type {Part[]} */ ([...names, "view"]).map((part) => {
      const handle = h("div", { class: "gizmo-handle", "data-gizmo": part, "aria-hidden": "true" });
      handle.addEventListener("pointerdown", (down) => this.#hold(part, down, moves, step));
      return { part, handle };
    });
    this.handles = h("div", { class: "gizmo-handles" }, ...this.#handles.map(({ handle }) => handle));
    this.set(null);
  }

  /** @param {Vector | null} point null where there is nothing to be moved */
  set(point) {
    this.#point = point;
    this.element.style.display = point ? "" : "none";
    this.handles.hidden = !point;
  }

  /** @param {Camera} camera @param {Frame} frame */
  place(camera, frame) {
    this.#seen = { camera, frame };
    const point = this.#point;
    if (!point) return;
    const { back, right, up } = axesOf(camera);
    const middle = seenAt(camera, frame, point);
    const units = (unitsPerPixel(camera, frame) * middle.depth) / camera.distance;
    const at = (/** @type {number[]} */ shares) => seenAt(camera, frame, UNITS.reduce((sum, axis, k) => add(sum, scaled(axis, shares[k] * units)), point)).at;
    // Squares lie on the side of the eye, where nothing of the arrows crosses them.
    const sides = back.map((share) => (share < -0.05 ? -1 : 1));
    for (const { part, shape } of this.#parts) {
      const { axes } = PARTS[part];
      const isOpen = axes.length === 1 ? Math.hypot(dot(UNITS[axes[0]], right), dot(UNITS[axes[0]], up)) > LEAST : Math.abs(dot(cross(UNITS[axes[0]], UNITS[axes[1]]), back)) > LEAST;
      const isShown = isOpen && (this.#held === null || this.#held === part);
      shape.style.display = isShown ? "" : "none";
      shape.classList.toggle("held", this.#held === part);
      const along = (/** @type {number} */ far) => UNITS.map((_, k) => (axes.includes(k) ? far * (axes.length === 1 ? 1 : sides[k]) : 0));
      const { handle } = /** @type {{handle: HTMLElement}} */ (this.#handles.find((each) => each.part === part));
      handle.hidden = !isOpen;
      const place = axes.length === 1 ? at(along(LONG - HEAD / 2)) : at(along((NEAR + FAR) / 2));
      handle.style.transform = `translate(${place.map((value) => `${value.toFixed(1)}px`).join(", ")})`;
      if (axes.length === 1) {
        const tip = at(along(LONG));
        attribute(shape, "d", arrow(middle.at, tip));
        const name = this.#names[axes[0]];
        name.style.display = isShown ? "" : "none";
        const end = at(along(LONG + 12));
        attribute(name, "x", end[0].toFixed(1));
        attribute(name, "y", end[1].toFixed(1));
      } else {
        const corner = (/** @type {number} */ a, /** @type {number} */ b) => at(UNITS.map((_, k) => (k === axes[0] ? a * sides[k] : k === axes[1] ? b * sides[k] : 0)));
        attribute(shape, "d", `M${[corner(NEAR, NEAR), corner(FAR, NEAR), corner(FAR, FAR), corner(NEAR, FAR)].map(text).join("L")}Z`);
      }
    }
    const { handle } = this.#handles[this.#handles.length - 1];
    handle.style.transform = `translate(${middle.at.map((value) => `${value.toFixed(1)}px`).join(", ")})`;
  }

  /** @param {Part} part @param {PointerEvent} down @param {GizmoMoves} moves @param {() => number | null} stepOf */
  #hold(part, down, moves, stepOf) {
    const start = this.#point;
    const seen = this.#seen;
    if (down.button !== 0 || !start || !seen) return;
    down.preventDefault();
    down.stopPropagation();
    const { camera, frame } = seen;
    const back = unit(axesOf(camera).back);
    const box = this.handles.getBoundingClientRect();
    const placeOf = (/** @type {PointerEvent} */ { clientX, clientY }) => heldAt(part, start, back, rayAt(camera, frame, [clientX - box.left, clientY - box.top]));
    const from = placeOf(down);
    if (!from) return;
    const run = newRun("gizmo");
    this.#held = part;
    this.place(camera, frame);
    whileHeld({
      move: (event) => {
        const place = placeOf(event);
        if (!place) return;
        const free = add(start, subtract(place, from));
        const step = stepOf();
        moves.move(step === null ? free : onSteps(free, start, step), run);
      },
      finish: (undo) => {
        this.#held = null;
        if (undo) moves.undo(run);
        else moves.end(run);
        if (this.#seen) this.place(this.#seen.camera, this.#seen.frame);
      },
    });
  }
}

/** A line with a head. @param {Point} from @param {Point} to */
function arrow(from, to) {
  const by = [to[0] - from[0], to[1] - from[1]];
  const length = Math.max(1, Math.hypot(...by));
  const [x, y] = by.map((value) => value / length);
  const foot = [to[0] - x * HEAD, to[1] - y * HEAD];
  const wing = (/** @type {number} */ side) => /** @type {Point} */ ([foot[0] - y * side * HEAD * 0.4, foot[1] + x * side * HEAD * 0.4]);
  return `M${text(from)}L${text(to)}L${text(wing(1))}L${text(wing(-1))}L${text(to)}`;
}

/** @param {Point} at */
const text = (at) => at.map((value) => value.toFixed(1)).join(" ");
