/**
 * A plane as a person moves it: its frame round the body, and a handle with an arrow along its normal.
 *
 * @import { Camera, Frame } from "./camera.js"
 * @import { Plane } from "./plane.js"
 * @import { Vector } from "./vector.js"
 * @import { Point } from "../types.js"
 *
 * @typedef {object} PlaneMoves
 * @property {(offset: number, run: string) => void} move offset along the normal that the frame was drawn with
 * @property {(run: string) => void} end
 * @property {(run: string) => void} undo
 * @property {(steps: number) => void} step by keys: 1 is a step, 10 a long one, 0.1 a short one
 */
import { stride } from "../controls/arrows.js";
import { DoubleSide, BufferAttribute, BufferGeometry, Mesh, MeshBasicMaterial } from "three";
import { whileHeld } from "../controls/held.js";
import { newRun } from "../controls/run.js";
import { attribute, h, svg } from "../dom.js";
import { seenAt, unitsPerPixel } from "./camera.js";
import { planeAxes } from "./cut.js";
import { Lines } from "./lines.js";
import { extentAlong } from "./plane.js";
import { add, between, scaled } from "./vector.js";

/** How far the frame reaches beyond the body, as a share of the body, and the opacity of the plane. */
const ROOM = 0.1;
const FILL = 0.035;
/** CSS pixels: the squares at the corners, the arrow with its head, and what it needs to have a direction. */
const SQUARE = 7;
const ARROW = 46;
const HEAD = 5;
const LEAST = 4;

export class PlaneMark {
  #geometry = new BufferGeometry();
  #fill = new Mesh(this.#geometry, new MeshBasicMaterial({ transparent: true, opacity: FILL, depthWrite: false, side: DoubleSide }));
  #outline = new Lines([], { color: "#4a45c8", width: 1, order: 30 });
  #squares = [0, 1, 2, 3].map(() => svg("rect", { class: "plane-square", width: SQUARE, height: SQUARE, rx: 1 }));
  #arrow = svg("path", { class: "plane-arrow" });
  #head = svg("path", { class: "plane-head" });
  /** @type {Vector[]} */
  #corners = [];
  /** @type {Plane | null} */
  #plane = null;
  /** Pixels of the screen for a unit along the normal, at the handle. @type {Point} */
  #direction = [0, 0];

  /** @param {string} label @param {PlaneMoves} moves */
  constructor(label, moves) {
    this.objects = [this.#fill, this.#outline.object];
    this.#fill.renderOrder = 29;
    this.overlay = svg("svg", { class: "plane-marks", "aria-hidden": "true" }, this.#arrow, this.#head, ...this.#squares);
    this.handle = h("button", { type: "button", class: "plane-handle", role: "slider", "aria-label": label, "data-plane-handle": "" });
    this.handle.addEventListener("pointerdown", (down) => this.#hold(down, moves));
    this.handle.addEventListener("keydown", (event) => {
      const by = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[event.key];
      if (by === undefined || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      event.stopPropagation();
      moves.step(by * stride(event));
    });
  }

  /**
   * @param {Plane | null} plane
   * @param {ArrayLike<number>} positions of the body
   */
  set(plane, positions) {
    this.#plane = plane;
    const isShown = plane !== null && positions.length > 0;
    this.#fill.visible = isShown;
    this.#outline.show(isShown);
    this.overlay.style.display = isShown ? "" : "none";
    this.handle.hidden = !isShown;
    if (!isShown) return;
    const [right, up] = planeAxes(plane.normal);
    const reach = [right, up].map((axis) => {
      const [low, high] = extentAlong(axis, positions);
      const room = Math.max(high - low, 1e-6) * ROOM;
      return [low - room, high + room];
    });
    const foot = scaled(plane.normal, plane.offset);
    const at = (/** @type {number} */ i, /** @type {number} */ j) => add(foot, add(scaled(right, reach[0][i]), scaled(up, reach[1][j])));
    this.#corners = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)];
    this.#geometry.setAttribute("position", new BufferAttribute(new Float32Array(this.#corners.flat()), 3));
    this.#geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.#geometry.computeBoundingSphere();
    this.#outline.set(this.#corners.flatMap((corner, i) => [...corner, ...this.#corners[(i + 1) % 4]]));
  }

  /** The corners of the frame, which have to lie within what is drawn. */
  get corners() {
    return this.#plane ? this.#corners : [];
  }

  /** @param {string} accent CSS */
  paint(accent) {
    this.#outline.paint(accent);
    this.#fill.material.color.set(accent);
  }

  /** @param {number} depth what one CSS pixel towards the eye is worth */
  raise(depth) {
    this.#outline.raise(depth);
  }

  /** @param {Camera} camera @param {Frame} frame */
  place(camera, frame) {
    const plane = this.#plane;
    if (!plane || this.#corners.length === 0) return;
    const seen = this.#corners.map((corner) => seenAt(camera, frame, corner).at);
    this.#squares.forEach((square, i) => {
      attribute(square, "x", (seen[i][0] - SQUARE / 2).toFixed(1));
      attribute(square, "y", (seen[i][1] - SQUARE / 2).toFixed(1));
    });
    // The middle of the side that lies farthest to the right, where the body hides it least.
    const sides = this.#corners.map((corner, i) => between(corner, this.#corners[(i + 1) % 4], 0.5));
    const places = sides.map((side) => seenAt(camera, frame, side).at);
    const best = places.reduce((k, [x], i) => (x > places[k][0] ? i : k), 0);
    const { width, height } = frame.size;
    const at = /** @type {Point} */ ([Math.min(width - 16, Math.max(16, places[best][0])), Math.min(height - 16, Math.max(16, places[best][1]))]);
    const units = ARROW * unitsPerPixel(camera, frame);
    const tip = seenAt(camera, frame, add(sides[best], scaled(plane.normal, -units))).at;
    const by = /** @type {Point} */ ([tip[0] - places[best][0], tip[1] - places[best][1]]);
    const length = Math.hypot(...by);
    // Seen straight on, the arrow has no direction; then up is along the normal.
    this.#direction = length < LEAST ? [0, -ARROW / units] : [-by[0] / units, -by[1] / units];
    this.handle.style.transform = `translate(${at[0].toFixed(1)}px, ${at[1].toFixed(1)}px)`;
    const end = /** @type {Point} */ ([at[0] + by[0], at[1] + by[1]]);
    const along = /** @type {Point} */ (length > 0 ? [-by[0] / length, -by[1] / length] : [0, -1]);
    for (const part of [this.#arrow, this.#head]) part.style.display = length < 2 * HEAD ? "none" : "";
    attribute(this.#arrow, "d", `M${at.map(round)}L${end.map(round)}`);
    const side = /** @type {Point} */ ([-along[1], along[0]]);
    const wing = (/** @type {number} */ sign) => [0, 1].map((k) => round(end[k] + along[k] * HEAD * 1.6 + sign * side[k] * HEAD * 0.8));
    attribute(this.#head, "d", `M${end.map(round)}L${wing(1)}L${wing(-1)}Z`);
  }

  /** @param {string} text @param {number} now @param {[number, number]} extent */
  describe(text, now, extent) {
    attribute(this.handle, "aria-valuetext", text);
    attribute(this.handle, "aria-valuenow", String(now));
    attribute(this.handle, "aria-valuemin", String(extent[0]));
    attribute(this.handle, "aria-valuemax", String(extent[1]));
  }

  /** @param {PointerEvent} down @param {PlaneMoves} moves */
  #hold(down, moves) {
    const plane = this.#plane;
    if (down.button !== 0 || !plane) return;
    down.preventDefault();
    down.stopPropagation();
    this.handle.focus({ preventScroll: true });
    const run = newRun("plane");
    const [x, y] = this.#direction;
    const start = plane.offset;
    const from = [down.clientX, down.clientY];
    whileHeld({
      move: (event) => {
        const [dx, dy] = [event.clientX - from[0], event.clientY - from[1]];
        moves.move(start + (dx * x + dy * y) / (x * x + y * y), run);
      },
      finish: (undo) => (undo ? moves.undo(run) : moves.end(run)),
    });
  }

  dispose() {
    this.#geometry.dispose();
    this.#fill.material.dispose();
    this.#outline.dispose();
  }
}

/** @param {number} value */
const round = (value) => value.toFixed(1);
