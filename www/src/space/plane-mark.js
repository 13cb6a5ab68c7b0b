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
import { DoubleSide, BufferAttribute, BufferGeometry, Mesh, MeshBasicMaterial } from "three";
import { attribute, svg } from "../dom.js";
import { seenAt } from "./camera.js";
import { planeAxes } from "./cut.js";
import { Lines } from "./lines.js";
import { extentAlong } from "./plane.js";
import { SlideHandle } from "./slide-handle.js";
import { add, between, scaled } from "./vector.js";

/** How far the frame reaches beyond the body, as a share of the body, and the opacity of the plane. */
const ROOM = 0.1;
const FILL = 0.035;
/** The plane lies a little behind the face of the section, whose colours it would tint. */
const BEHIND = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 4 };
/** CSS pixels: the squares at the corners, and the arrow with its head. */
const SQUARE = 7;
const ARROW = 46;
const HEAD = 5;

export class PlaneMark {
  #geometry = new BufferGeometry();
  #fill = new Mesh(this.#geometry, new MeshBasicMaterial({ transparent: true, opacity: FILL, depthWrite: false, side: DoubleSide, ...BEHIND }));
  #outline = new Lines([], { color: "#4a45c8", width: 1, order: 30 });
  #squares = [0, 1, 2, 3].map(() => svg("rect", { class: "plane-square", width: SQUARE, height: SQUARE, rx: 1 }));
  #arrow = svg("path", { class: "plane-arrow" });
  #head = svg("path", { class: "plane-head" });
  /** @type {Vector[]} */
  #corners = [];
  /** @type {Plane | null} */
  #plane = null;
  #slide;

  /** @param {string} label @param {PlaneMoves} moves */
  constructor(label, moves) {
    this.objects = [this.#fill, this.#outline.object];
    this.#fill.renderOrder = 29;
    this.overlay = svg("svg", { class: "plane-marks", "aria-hidden": "true" }, this.#arrow, this.#head, ...this.#squares);
    // The arrow points to what is taken away, against the normal.
    this.#slide = new SlideHandle(label, { "data-plane-handle": "" }, { ...moves, start: () => this.#plane && -this.#plane.offset, move: (place, run) => moves.move(-place, run) });
    this.handle = this.#slide.element;
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
    const { at: anchor, by, length } = this.#slide.aim(camera, frame, sides[best], scaled(plane.normal, -1), ARROW);
    const at = this.#slide.put(anchor, frame);
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
    this.#slide.describe(text, now, extent);
  }

  dispose() {
    this.#geometry.dispose();
    this.#fill.material.dispose();
    this.#outline.dispose();
  }
}

/** @param {number} value */
const round = (value) => value.toFixed(1);
