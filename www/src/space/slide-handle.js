/**
 * A handle that slides along one direction of space, by pointer, touch and keys: what a plane or the side of a box is moved by.
 *
 * @import { Camera, Frame } from "./camera.js"
 * @import { Vector } from "./vector.js"
 * @import { Point } from "../types.js"
 *
 * @typedef {object} Slides Places count along the direction, in document units.
 * @property {() => number | null} start where it stands; null while it cannot be moved
 * @property {(place: number, run: string) => void} move
 * @property {(run: string) => void} end
 * @property {(run: string) => void} undo
 * @property {(steps: number) => void} step by keys: 1 is a step, 10 a long one, 0.1 a short one
 */
import { stride } from "../controls/arrows.js";
import { whileHeld } from "../controls/held.js";
import { newRun } from "../controls/run.js";
import { attribute, h } from "../dom.js";
import { seenAt, unitsPerPixel } from "./camera.js";
import { add, scaled } from "./vector.js";

/** CSS pixels of the direction on the screen below which it has none there. */
const LEAST = 4;
/** CSS pixels that a handle keeps from the edges of the picture. */
const EDGE = 16;
/** Steps of keys. @type {{[key: string]: number}} */
const KEYS = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 };

export class SlideHandle {
  /** Pixels of the screen for a unit along the direction. @type {Point} */
  #direction = [0, 0];

  /**
   * @param {string} label
   * @param {{[name: string]: string}} attributes of the handle
   * @param {Slides} slides
   */
  constructor(label, attributes, slides) {
    this.element = h("button", { type: "button", class: "plane-handle", role: "slider", "aria-label": label, ...attributes });
    this.element.addEventListener("pointerdown", (down) => this.#hold(down, slides));
    this.element.addEventListener("keydown", (event) => {
      const by = KEYS[event.key];
      if (by === undefined || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      event.stopPropagation();
      slides.step(by * stride(event));
    });
  }

  /**
   * How the direction is seen from a place.
   * @param {Camera} camera
   * @param {Frame} frame
   * @param {Vector} from
   * @param {Vector} along of length 1
   * @param {number} far CSS pixels
   * @returns {{at: Point, by: Point, length: number}} where the place is seen, and from there what lies so far along the direction
   */
  aim(camera, frame, from, along, far) {
    const units = far * unitsPerPixel(camera, frame);
    const { at } = seenAt(camera, frame, from);
    const tip = seenAt(camera, frame, add(from, scaled(along, units))).at;
    const by = /** @type {Point} */ ([tip[0] - at[0], tip[1] - at[1]]);
    const length = Math.hypot(...by);
    // Seen straight on, the direction has none on the screen; then it is down.
    this.#direction = length < LEAST ? [0, far / units] : [by[0] / units, by[1] / units];
    return { at, by, length };
  }

  /** How the direction is seen where nothing is seen in perspective. @param {Point} direction pixels of the screen for a unit along it */
  set direction(direction) {
    this.#direction = direction;
  }

  /** @param {Point} at CSS pixels @param {Pick<Frame, "size">} frame @returns {Point} where it stands, clear of the edges of the picture */
  put(at, { size: { width, height } }) {
    const place = /** @type {Point} */ ([Math.min(width - EDGE, Math.max(EDGE, at[0])), Math.min(height - EDGE, Math.max(EDGE, at[1]))]);
    this.element.style.transform = `translate(${place[0].toFixed(1)}px, ${place[1].toFixed(1)}px)`;
    return place;
  }

  /** @param {string} text @param {number} now @param {readonly number[]} extent the ends of its way */
  describe(text, now, [low, high]) {
    attribute(this.element, "aria-valuetext", text);
    attribute(this.element, "aria-valuenow", String(now));
    attribute(this.element, "aria-valuemin", String(low));
    attribute(this.element, "aria-valuemax", String(high));
  }

  /** @param {PointerEvent} down @param {Slides} slides */
  #hold(down, slides) {
    const start = slides.start();
    if (down.button !== 0 || start === null) return;
    down.preventDefault();
    down.stopPropagation();
    this.element.focus({ preventScroll: true });
    const run = newRun("slide");
    const [x, y] = this.#direction;
    const from = [down.clientX, down.clientY];
    whileHeld({
      move: (event) => {
        const [dx, dy] = [event.clientX - from[0], event.clientY - from[1]];
        slides.move(start + (dx * x + dy * y) / (x * x + y * y), run);
      },
      finish: (undo) => (undo ? slides.undo(run) : slides.end(run)),
    });
  }
}
