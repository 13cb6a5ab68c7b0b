/** The place between the curves: play, slider and its reading. */
import { attribute, h, icon, write } from "./dom.js";
import { fixed, words } from "./words.js";

/** Milliseconds from one curve to the other. */
const SWEEP = 4000;
const STEP = 0.01;

/**
 * @typedef {object} Host
 * @property {() => number} s
 * @property {() => number} stages
 * @property {(s: number) => void} change
 * @property {() => boolean} isSeen whether anybody can see the figure now
 * @property {(text: string) => void} say
 */

export class Morph {
  #host;
  #still = matchMedia("(prefers-reduced-motion: reduce)");
  #isPlaying = false;
  #frame = 0;
  #before = 0;
  #direction = 1;
  #face = "";
  #play = h("button", { type: "button", class: "play", part: "play" });
  #input = h("input", { type: "range", min: "0", max: "1", step: String(STEP), "aria-label": words.morph.slider });
  #slider = h("span", { class: "slider" }, this.#input);
  #value = h("b", {});

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
    this.elements = [this.#play, this.#slider, h("span", { class: "place", "aria-hidden": "true" }, h("i", {}, "s"), " ", this.#value)];
    this.#play.addEventListener("click", () => this.#toggle());
    this.#input.addEventListener("input", () => {
      this.stop();
      host.change(this.#snapped(Number(this.#input.value)));
    });
  }

  get isPlaying() {
    return this.#isPlaying;
  }

  play() {
    if (this.#still.matches || this.#isPlaying) return;
    this.#isPlaying = true;
    this.resume();
    this.render();
  }

  stop() {
    this.#isPlaying = false;
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.render();
  }

  /** Goes on playing where that was interrupted, because nobody saw it. */
  resume() {
    if (!this.#isPlaying || this.#frame !== 0 || !this.#host.isSeen()) return;
    this.#before = performance.now();
    this.#frame = requestAnimationFrame((now) => this.#advance(now));
  }

  render() {
    const s = this.#host.s();
    const shown = fixed(s, 2);
    write(this.#value, shown);
    if (Number(this.#input.value) !== s) this.#input.value = String(s);
    this.#slider.style.setProperty("--fill", String(s));
    attribute(this.#input, "aria-valuetext", words.morph.place(shown));
    const face = this.#still.matches ? "step" : this.#isPlaying ? "pause" : "play";
    if (face === this.#face) return;
    this.#face = face;
    this.#play.replaceChildren(icon(face));
    attribute(this.#play, "aria-label", words.morph[face]);
    attribute(this.#play, "title", words.morph[face]);
  }

  /** @param {number} now */
  #advance(now) {
    this.#frame = 0;
    if (!this.#isPlaying || !this.#host.isSeen()) return;
    let next = this.#host.s() + (this.#direction * Math.min(100, now - this.#before)) / SWEEP;
    this.#before = now;
    if (next >= 1) [next, this.#direction] = [1, -1];
    if (next <= 0) [next, this.#direction] = [0, 1];
    this.#host.change(next);
    this.#frame = requestAnimationFrame((later) => this.#advance(later));
  }

  #toggle() {
    if (this.#still.matches) this.#step();
    else if (this.#isPlaying) this.stop();
    else this.play();
  }

  /** To the next curve in between, and from the last back to the first. */
  #step() {
    const stages = this.#host.stages();
    const j = Math.floor(this.#host.s() * stages + 1e-9) + 1;
    const next = j > stages ? 0 : j / stages;
    this.#host.change(next);
    this.#host.say(words.morph.place(fixed(next, 2)));
  }

  /** The stage itself when the slider stands within half a step of it. @param {number} s */
  #snapped(s) {
    const stages = this.#host.stages();
    const stage = Math.round(s * stages) / stages;
    return Math.abs(stage - s) <= STEP / 2 ? stage : s;
  }
}
