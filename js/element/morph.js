/** Play, slider and reading: of the place between the curves, or of the steps of the growth. */
import { attribute, h, icon, write } from "./dom.js";
import { fixed, words } from "./words.js";

/** Milliseconds from one curve to the other, and for a step of the growth. */
const SWEEP = 4000;
const SWEEP_OF_STEP = 500;
const STEP = 0.01;

/**
 * @typedef {object} Host
 * @property {() => number} s the place, 0 to 1
 * @property {() => number} stages places where it stands on a stage, or a step, less one
 * @property {() => boolean} isGrowth whether the stages are steps of the growth
 * @property {() => string} slider what the slider is for, besides steps
 * @property {() => string | null} spoken the place in words; null where it is s
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
  #letter = h("i", {}, "s");
  #value = h("b", {});

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
    this.elements = [this.#play, this.#slider, h("span", { class: "place", "aria-hidden": "true" }, this.#letter, " ", this.#value)];
    this.#play.addEventListener("click", () => this.#toggle());
    this.#input.addEventListener("keydown", (event) => this.#key(event));
    this.#input.addEventListener("input", () => {
      const s = this.#snapped(Number(this.#input.value));
      this.stop();
      host.change(s);
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
    const isGrowth = this.#host.isGrowth();
    attribute(this.#input, "step", isGrowth ? "any" : String(STEP));
    attribute(this.#input, "aria-label", isGrowth ? words.growth.slider : this.#host.slider());
    const isCut = this.#host.spoken() !== null;
    this.#letter.hidden = isGrowth || isCut;
    write(this.#value, isGrowth ? `${this.#stage} / ${this.#host.stages()}` : `${isCut ? `${this.#host.slider()} ` : ""}${fixed(s, 2)}`);
    if (Number(this.#input.value) !== s) this.#input.value = String(s);
    this.#slider.style.setProperty("--fill", String(s));
    attribute(this.#input, "aria-valuetext", this.#spoken);
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
    const isGrowth = this.#host.isGrowth();
    const sweep = isGrowth ? SWEEP_OF_STEP * this.#host.stages() : SWEEP;
    let next = this.#host.s() + ((isGrowth ? 1 : this.#direction) * Math.min(100, now - this.#before)) / sweep;
    this.#before = now;
    if (next >= 1) [next, this.#direction] = [1, -1];
    if (next <= 0) [next, this.#direction] = [0, 1];
    this.#host.change(next);
    if (isGrowth && next === 1) return this.stop();
    this.#frame = requestAnimationFrame((later) => this.#advance(later));
  }

  #toggle() {
    if (this.#still.matches) this.#step();
    else if (this.#isPlaying) this.stop();
    else {
      if (this.#host.isGrowth() && this.#host.s() === 1) this.#host.change(0);
      this.play();
    }
  }

  /** An arrow key is a step of the growth. @param {KeyboardEvent} event */
  #key(event) {
    const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    if (!by || !this.#host.isGrowth()) return;
    event.preventDefault();
    this.stop();
    const stages = this.#host.stages();
    this.#host.change(Math.min(stages, Math.max(0, this.#stage + by)) / stages);
  }

  /** The stage, or step, that the place stands for. */
  get #stage() {
    return Math.round(this.#host.s() * this.#host.stages());
  }

  get #spoken() {
    if (this.#host.isGrowth()) return words.growth.step(this.#stage, this.#host.stages());
    return this.#host.spoken() ?? words.morph.place(fixed(this.#host.s(), 2));
  }

  /** To the next curve in between, and from the last back to the first. */
  #step() {
    const stages = this.#host.stages();
    const j = Math.floor(this.#host.s() * stages + 1e-9) + 1;
    const next = j > stages ? 0 : j / stages;
    this.#host.change(next);
    this.#host.say(this.#spoken);
  }

  /** The stage itself when the slider stands within half a step of it. @param {number} s */
  #snapped(s) {
    const stages = this.#host.stages();
    const stage = Math.round(s * stages) / stages;
    if (this.#host.isGrowth()) return stage;
    return Math.abs(stage - s) <= STEP / 2 ? stage : s;
  }
}
