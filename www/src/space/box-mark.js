/**
 * A box along the axes as a person moves it: its edges, and a handle on each of its six sides.
 *
 * @import { Camera, Frame } from "./camera.js"
 * @import { Bounds, Vector } from "./vector.js"
 *
 * @typedef {object} Side One of the six sides.
 * @property {0 | 1 | 2} axis that it stands across
 * @property {"min" | "max"} end of the box that it is
 *
 * @typedef {object} BoxMoves Places are coordinates along the axis of the side.
 * @property {(side: Side, place: number, run: string) => void} move
 * @property {(side: Side, run: string) => void} end
 * @property {(run: string) => void} undo
 * @property {(side: Side, steps: number) => void} step by keys, towards greater coordinates: 1 is a step, 10 a long one, 0.1 a short one
 */
import { BackSide, BoxGeometry, Mesh, MeshBasicMaterial } from "three";
import { attribute, h, svg } from "../dom.js";
import { seenAt } from "./camera.js";
import { Lines } from "./lines.js";
import { SlideHandle } from "./slide-handle.js";
import { cornersOf, middleOf, subtract } from "./vector.js";

/** Opacity of the sides away from the eye: nothing lies over the colours of the body. */
const FILL = 0.07;
/** CSS pixels of the stem from a side to its handle, so that those of a thin box stand apart, by pointer and by touch. */
export const STEM = { fine: 18, coarse: 26 };
/** Corners that are joined by an edge, by their places in `cornersOf`. */
const EDGES = [0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7];

/** @type {readonly Side[]} */
export const SIDES = /** @type {const} */ ([0, 1, 2]).flatMap((axis) => /** @type {const} */ (["min", "max"]).map((end) => ({ axis, end })));

/** 1 where a side faces greater coordinates, else -1. @param {Side} side */
export const signOf = ({ end }) => (end === "max" ? 1 : -1);

/**
 * The handle of a side, which slides outwards.
 * @param {Side} side
 * @param {(side: Side) => string} label
 * @param {BoxMoves} moves
 * @param {() => Bounds | null} read the box as it stands
 * @param {string} [name] of its attribute
 */
export function sideHandle(side, label, moves, read, name = "data-box-handle") {
  const sign = signOf(side);
  return new SlideHandle(label(side), { [name]: `${"xyz"[side.axis]} ${side.end}` }, {
    start() {
      const box = read();
      return box && sign * box[side.end][side.axis];
    },
    move: (place, run) => moves.move(side, sign * place, run),
    end: (run) => moves.end(side, run),
    undo: moves.undo,
    step: (steps) => moves.step(side, steps),
  });
}

export class BoxMark {
  #fill = new Mesh(new BoxGeometry(1, 1, 1), new MeshBasicMaterial({ transparent: true, opacity: FILL, depthWrite: false, side: BackSide }));
  #outline = new Lines([], { color: "#4a45c8", width: 1.25, order: 32 });
  #stems = SIDES.map(() => svg("path", { class: "plane-arrow" }));
  #slides;
  #coarse = matchMedia("(pointer: coarse)");
  /** @type {Bounds | null} */
  #box = null;

  /** @param {(side: Side) => string} label @param {BoxMoves} moves */
  constructor(label, moves) {
    this.objects = [this.#fill, this.#outline.object];
    this.#fill.renderOrder = 31;
    this.#slides = SIDES.map((side) => sideHandle(side, label, moves, () => this.#box));
    this.overlay = svg("svg", { class: "plane-marks", "aria-hidden": "true" }, ...this.#stems);
    this.handles = h("div", { class: "gizmo-handles box-handles" }, ...this.#slides.map(({ element }) => element));
    this.set(null);
  }

  /** @param {Bounds | null} box null where there is none */
  set(box) {
    this.#box = box;
    this.#fill.visible = box !== null;
    this.#outline.show(box !== null);
    this.overlay.style.display = box ? "" : "none";
    this.handles.hidden = box === null;
    if (!box) return;
    const size = subtract(box.max, box.min);
    this.#fill.position.set(...middleOf(box));
    this.#fill.scale.set(...size);
    const corners = cornersOf(box);
    this.#outline.set(EDGES.flatMap((corner) => corners[corner]));
  }

  /** The corners, which have to lie within what is drawn. */
  get corners() {
    return this.#box ? cornersOf(this.#box) : [];
  }

  /** @param {string} accent CSS @param {number} depth what one CSS pixel towards the eye is worth */
  look(accent, depth) {
    this.#outline.paint(accent);
    this.#outline.raise(depth);
    this.#fill.material.color.set(accent);
  }

  /** @param {Camera} camera @param {Frame} frame */
  place(camera, frame) {
    const box = this.#box;
    if (!box) return;
    const middle = middleOf(box);
    const stem = this.#coarse.matches ? STEM.coarse : STEM.fine;
    const depths = SIDES.map((side, k) => {
      const foot = /** @type {Vector} */ (middle.map((value, axis) => (axis === side.axis ? box[side.end][axis] : value)));
      const outwards = /** @type {Vector} */ ([0, 1, 2].map((axis) => (axis === side.axis ? signOf(side) : 0)));
      const { at, by, length } = this.#slides[k].aim(camera, frame, foot, outwards, stem);
      const far = length > 0 ? stem / Math.max(length, stem / 2) : 0;
      const end = this.#slides[k].put([at[0] + by[0] * far, at[1] + by[1] * far], frame);
      attribute(this.#stems[k], "d", `M${at.map(round)}L${end.map(round)}`);
      return seenAt(camera, frame, foot).depth;
    });
    // What is nearer to the eye is reached first.
    const order = depths.map((_, k) => k).sort((a, b) => depths[b] - depths[a]);
    order.forEach((k, rank) => (this.#slides[k].element.style.zIndex = String(rank)));
  }

  /** @param {(side: Side) => {text: string, now: number, extent: readonly number[]}} of */
  describe(of) {
    SIDES.forEach((side, k) => {
      const { text, now, extent } = of(side);
      this.#slides[k].describe(text, now, extent);
    });
  }

  dispose() {
    this.#fill.geometry.dispose();
    this.#fill.material.dispose();
    this.#outline.dispose();
  }
}

/** @param {number} value */
const round = (value) => value.toFixed(1);
