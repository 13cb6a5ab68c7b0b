/**
 * Arrow keys: where they lead, how far, and which of them belong to one run of edits.
 *
 * @import { Point } from "../types.js"
 */
import { newRun } from "./run.js";

/** Milliseconds between two keys that still belong to one run. */
const PAUSE = 1000;

/** The way of each, with y up. @type {{[key: string]: Point}} */
export const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** How many steps a key goes: ten with Shift, a tenth with Alt. @param {Pick<KeyboardEvent, "shiftKey" | "altKey">} event */
export const stride = ({ shiftKey, altKey }) => (shiftKey ? 10 : altKey ? 0.1 : 1);

/** Keys that follow each other without a pause are one run of edits. */
export class KeyRun {
  #what;
  #last = 0;

  /** @param {string} what is edited */
  constructor(what) {
    this.#what = what;
    this.name = newRun(what);
  }

  /** A key is pressed. @returns {string} the run that it belongs to */
  press() {
    const now = performance.now();
    if (now - this.#last > PAUSE) this.renew();
    this.#last = now;
    return this.name;
  }

  /** Whatever comes is another run. */
  renew() {
    this.name = newRun(this.#what);
  }
}
