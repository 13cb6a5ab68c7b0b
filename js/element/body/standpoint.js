/**
 * Where a figure in space is seen from, and when it is painted: the camera is fitted to what is shown, turned by hand, and kept while the size changes.
 *
 * @import { Camera, Frame } from "../../space/camera.js"
 * @import { Size } from "../plane.js"
 *
 * @typedef {Pick<Camera, "azimuth" | "elevation">} Direction
 *
 * @typedef {object} Seen What is seen.
 * @property {() => import("../../space/vector.js").Vector[] | null} corners of the box of what is shown; null while nothing is
 * @property {() => boolean} [isFlat] whether it is seen from above only, as the plane is
 * @property {() => Size} size of the figure in CSS pixels
 * @property {() => void} draw
 * @property {() => void} rested the camera has come to rest elsewhere
 * @property {(text: string) => void} say
 */
import { fitted, STANDARD } from "../../space/camera.js";
import { createOrbit } from "./orbit.js";

/** Milliseconds after a turn by keys until the picture is fine again. */
const IDLE = 250;
/** Where the plane is seen from: above, with x to the right. */
const ABOVE = { azimuth: -90, elevation: 90 };

export class Standpoint {
  /** @type {Camera} */
  camera = { ...STANDARD.iso, target: [0, 0, 0], distance: 1 };
  /** Whether what is painted has every detail, as at rest. */
  isFine = true;

  #seen;
  /** Distance of the camera that was fitted. */
  #fitted = 1;
  /** Whether the camera stands where it was fitted, and so follows the size. */
  #follows = true;
  #frame = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #idle;

  /** @param {Seen} seen */
  constructor(seen) {
    this.#seen = seen;
    this.orbit = createOrbit({
      camera: () => this.camera,
      frame: () => this.frame,
      fitted: () => this.#fitted,
      turn: (camera, isDrag) => this.#put(camera, isDrag),
      fit: (view) => this.fit(view && STANDARD[view]),
      rest: () => this.#rest(),
      isFlat: () => seen.isFlat?.() === true,
      say: seen.say,
    });
  }

  /** @returns {Frame} */
  get frame() {
    const { width, height } = this.#seen.size();
    return { size: { width: Math.max(1, width), height: Math.max(1, height) }, top: 0, bottom: 0 };
  }

  /** @param {Direction} [direction] */
  fit(direction = this.camera) {
    const corners = this.#seen.corners();
    if (!corners) return;
    this.camera = fitted(this.#seen.isFlat?.() ? ABOVE : direction, this.frame, corners);
    this.#fitted = this.camera.distance;
    this.#follows = true;
    this.repaint();
    this.#seen.rested();
  }

  /** The size is another one. */
  resize() {
    if (this.#follows) this.fit();
    this.repaint();
  }

  /** @param {Camera} camera @param {boolean} isDrag */
  #put(camera, isDrag) {
    // The plane is moved and brought nearer, never turned.
    this.camera = this.#seen.isFlat?.() ? { ...camera, ...ABOVE } : camera;
    this.#follows = false;
    this.isFine = false;
    this.repaint();
    if (!isDrag) this.settleLater();
  }

  /** Comes to rest after a while without another move. */
  settleLater() {
    clearTimeout(this.#idle);
    if (!this.isFine) this.#idle = setTimeout(() => this.#rest(), IDLE);
  }

  #rest() {
    clearTimeout(this.#idle);
    this.isFine = true;
    this.repaint();
    this.#seen.rested();
  }

  /** Paints before the next frame of the screen. */
  repaint() {
    if (this.#frame === 0 && this.#seen.corners()) this.#frame = requestAnimationFrame(() => this.paint());
  }

  /** Paints now. */
  paint() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    const { width, height } = this.#seen.size();
    if (this.#seen.corners() && width >= 1 && height >= 1) this.#seen.draw();
  }

  /** Paints no more until it is asked for again. */
  cancel() {
    clearTimeout(this.#idle);
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
  }

  /** What a picture depends on besides what is shown. @param {number} ratio device pixels for one of CSS @param {"light" | "dark"} theme */
  look(ratio, theme) {
    return { camera: this.camera, frame: this.frame, ratio, theme, isFine: this.isFine };
  }
}
