/**
 * The element `<directrix-figure>`: its attributes, its life on the page, and its parts. See docs/embedding.md.
 *
 * @import { CurvesDocument, DocumentInput, LayerName } from "../directrix.js"
 * @import { BodyScene } from "./body/body-scene.js"
 * @import { Kind } from "./kind.js"
 * @import { PartScene } from "./part/part-scene.js"
 * @import { ProblemScene } from "./problem/problem-scene.js"
 */
import { DirectrixError } from "../errors.js";
import { canRun } from "./able.js";
import { choiceOf } from "./choices.js";
import { attribute, write } from "./dom.js";
import { EditorLink } from "./editor-link.js";
import { failureOf } from "./failure.js";
import { createFrame } from "./frame.js";
import { Growth } from "./growth.js";
import { Handles } from "./handles.js";
import { isInSpace } from "./in-space.js";
import { kindOf, presetKind } from "./kind.js";
import { release, use, warm } from "./kernel.js";
import { Morph } from "./morph.js";
import { observe, observeSize } from "./observe.js";
import { Paper } from "./paper.js";
import { Scene } from "./scene.js";
import { readSource } from "./source.js";
import { sheetOf } from "./style.js";
import { themeAround, watchTheme } from "./theme.js";
import { words } from "./words.js";
import { Working } from "./working.js";

/** The largest step that a link may name. */
const LAST_STEP = 1_000_000;
/** A module may be imported where there is no page, as generators of sites do; an element is not made there. */
const Base = globalThis.HTMLElement ?? /** @type {typeof HTMLElement} */ (/** @type {unknown} */ (class {}));

export class DirectrixFigure extends Base {
  static observedAttributes = ["preset", "src", "presets", "controls", "theme", "reveal", "alt", "poster", "editor", "view", "step"];
  /** The folder of the presets, for figures without the attribute `presets`. @type {string | URL} */
  static presets = "./presets/";
  /** The editor, for figures without the attribute `editor`. @type {string | URL} */
  static editor = "./index.html";

  #frame;
  #host;
  /** What is shown: curves, a body or a part. @type {Scene} */
  #scene;
  #curves;
  /** What shows another kind than curves. @type {BodyScene | PartScene | ProblemScene | null} */
  #other = null;
  /** @type {Kind} */
  #kind = "curves";
  #handles;
  #growth;
  /** Place in the growth, 0 to 1, where it was moved; else that of the attribute. @type {number | null} */
  #progress = null;
  #morph;
  #paper;
  #working;
  #link;
  /** The document set by the property. @type {DocumentInput | null} */
  #given = null;
  #isStale = true;
  #isNear = false;
  #isSeen = false;
  #isRevealed = false;
  #owesFocus = false;
  #state = "waiting";
  /** @type {AbortController | null} */
  #fetching = null;
  /** Ends what the figure listens to while it is on a page. @type {(() => void)[]} */
  #endings = [];

  constructor() {
    super();
    this.#frame = createFrame({
      reveal: () => this.#reveal(),
      layer: (name, isOn) => this.#setLayer(name, isOn),
    });
    const { canvas, picture, bar, poster, paper, working, open } = this.#frame;
    this.#working = new Working(working, (progress) => this.dispatchEvent(new CustomEvent("progress", { detail: { progress } })));
    /** @type {import("./scene.js").Host} */
    const shown = {
      canvas,
      urgency: () => (this.#isSeen ? 0 : 1),
      onsolved: (kind) => this.#solved(kind),
      onpaint: () => this.#renderOverlay(),
      onprogress: (progress) => this.#working.set(progress),
      onproblem: (kind, error) => this.#failed(kind, error),
    };
    this.#host = shown;
    this.#scene = this.#curves = new Scene(shown);
    this.#handles = new Handles({
      state: () => (this.#hasHandles && this.#scene.document ? { document: this.#scene.document, view: this.#scene.view, size: this.#scene.size } : null),
      change: (document, isMoving) => this.#edit(document, isMoving),
      say: (text) => this.#say(text),
    });
    this.#growth = new Growth();
    this.#morph = new Morph({
      s: () => (this.#isGrowth ? this.#place : this.#scene.s),
      stages: () => (this.#isGrowth ? Math.max(1, this.#steps) : this.#scene.stages),
      isGrowth: () => this.#isGrowth,
      slider: () => this.#scene.slider,
      spoken: () => this.#scene.spoken,
      change: (s) => (this.#isGrowth ? this.#setPlace(s) : this.#setS(s)),
      isSeen: () => this.#isShownNow,
      say: (text) => this.#say(text),
    });
    this.#paper = new Paper(() => this.#scene, paper);
    this.#link = new EditorLink(open, () => {
      const { state } = this.#scene;
      const view = /** @type {"figure" | "steps" | "compare" | "solid"} */ (this.#other ? "figure" : this.#view);
      return state && { document: state, view, step: this.#linkedStep, editor: this.getAttribute("editor") ?? DirectrixFigure.editor };
    });
    picture.append(this.#growth.element, this.#handles.element);
    bar.prepend(...this.#morph.elements);
    poster.addEventListener("error", () => (poster.hidden = true));
    const root = this.attachShadow({ mode: "open" });
    root.append(this.#frame.element);
  }

  /** The document with the edits and the place that the person has chosen; `null` before the first one stands. */
  get document() {
    return structuredClone(this.#scene.state);
  }

  set document(given) {
    this.#given = given;
    this.#reload();
  }

  /** Place of the current in-between curve, 0 to 1. */
  get s() {
    return this.#scene.s;
  }

  set s(s) {
    if (typeof s !== "number" || !(s >= 0 && s <= 1)) throw new RangeError(`s: ${String(s)} was found; expected a number from 0 to 1`);
    this.#morph.stop();
    this.#setS(s);
  }

  /** What the matching is worth; `null` before the first one stands. */
  get result() {
    return this.#scene.result;
  }

  /** Where the figure is computed; `null` before that is known. */
  get runsIn() {
    return this.#scene.runsIn;
  }

  /** Plays from one curve to the other and back; with reduced motion nothing plays. */
  play() {
    if (this.#scene.stages > 0) this.#morph.play();
  }

  pause() {
    this.#morph.stop();
  }

  connectedCallback() {
    for (const name of ["document", "s"]) this.#upgrade(name);
    this.#dress();
    use();
    this.#observe();
    this.#render();
    this.#load();
    this.#scene.refresh();
  }

  disconnectedCallback() {
    for (const end of this.#endings.splice(0)) end();
    if (this.#fetching) this.#isStale = true;
    this.#abort();
    if (this.#state === "loading") this.#state = "waiting";
    this.#scene.cancel();
    this.#handles.reset();
    this.#morph.stop();
    this.#paper.cancel();
    this.#link.cancel();
    this.#working.end();
    [this.#isNear, this.#isSeen] = [false, false];
    release();
  }

  /** @param {string} name @param {string | null} before @param {string | null} now */
  attributeChangedCallback(name, before, now) {
    if (before === now) return;
    if (name === "preset" || name === "src" || name === "presets") {
      this.#given = null;
      this.#reload();
    }
    if (name === "step") this.#progress = null;
    if (this.isConnected) this.#render();
  }

  /** Whether the figure shows the growth step by step. */
  get #isGrowth() {
    return this.#view === "steps" && !this.#other;
  }

  /** A step without a view is one of the growth, as in a link. */
  get #view() {
    return this.hasAttribute("step") && !this.hasAttribute("view") ? "steps" : choiceOf(this, "view");
  }

  /** The number of the steps. */
  get #steps() {
    return this.#scene.steps?.lines.length ?? 0;
  }

  /** The place in the growth, 0 to 1. */
  get #place() {
    if (this.#progress !== null) return this.#progress;
    const step = Number(this.getAttribute("step") ?? 1);
    return this.#steps === 0 ? 0 : Math.min(1, Math.max(0, Math.trunc(step) || 0) / this.#steps);
  }

  /** The step that the link leads to: the one shown, or one of the attribute that comes after the growth, as the editor has them. */
  get #linkedStep() {
    const given = Number(this.getAttribute("step") ?? 1);
    const isLater = this.#progress === null && Number.isInteger(given) && given > this.#steps && given <= LAST_STEP;
    return isLater ? given : Math.max(1, this.#step);
  }

  get #step() {
    return Math.round(this.#place * this.#steps);
  }

  get #hasHandles() {
    return choiceOf(this, "controls") === "full" && !this.#other && !isInSpace(this.#scene.document);
  }

  /** Whether anybody can see it. */
  get #isShownNow() {
    return this.#isSeen && document.visibilityState === "visible";
  }

  /** A property that was set before the element was defined hides the accessor. @param {string} name */
  #upgrade(name) {
    if (!Object.hasOwn(this, name)) return;
    const self = /** @type {any} */ (this);
    const value = self[name];
    delete self[name];
    self[name] = value;
  }

  #observe() {
    this.#endings.push(
      ...observe(this, {
        near: (isNear) => {
          this.#isNear = isNear;
          this.#load();
        },
        seen: (isSeen) => {
          this.#isSeen = isSeen;
          this.#morph.resume();
        },
        woken: () => this.#morph.resume(),
      }),
      observeSize(this.#frame.picture, (size) => {
        this.#scene.resize(size);
        this.#renderOverlay();
      }),
      watchTheme(() => this.#paint()),
    );
  }

  /** Another document is wanted. */
  #reload() {
    this.#abort();
    this.#isStale = true;
    this.#load();
  }

  #abort() {
    this.#fetching?.abort();
    this.#fetching = null;
  }

  /** Loads what is wanted, once somebody is about to see it. */
  #load() {
    const isAsked = this.#isRevealed || choiceOf(this, "reveal") === "auto";
    const { src, preset } = this.#source;
    const isWanted = this.#given !== null || src !== null || preset !== null;
    if (!this.#isStale || !isWanted || !this.isConnected || !this.#isNear || !isAsked) return;
    this.#isStale = false;
    if (!canRun()) {
      this.#failed("kernel", new DirectrixError("no-wasm", "", words.errors.noWasm));
      return;
    }
    this.#become("loading");
    const fetching = new AbortController();
    this.#fetching = fetching;
    this.#working.begin();
    // The kernel begins with the smaller module, which knows curves alone.
    if ((this.#given === null ? presetKind(preset) : kindOf(this.#given)) === "curves") warm();
    void this.#open(fetching.signal);
  }

  /** @param {AbortSignal} signal */
  async #open(signal) {
    try {
      const given = this.#given ?? (await readSource(this.#source, signal));
      if (signal.aborted) return;
      await this.#suit(kindOf(given));
      if (signal.aborted) return;
      this.#fetching = null;
      this.#scene.open(given);
    } catch (error) {
      if (signal.aborted) return;
      this.#fetching = null;
      this.#failed("document", error);
    }
  }

  /** Takes the scene for a document: what shows bodies or parts comes with the first of them. @param {Kind} kind */
  async #suit(kind) {
    if (kind === this.#kind) return;
    const { size, theme } = this.#scene;
    const made = await this.#made(kind);
    // Another document may have come meanwhile, and found the same.
    if (kind === this.#kind) return;
    for (const element of this.#other ? [...this.#other.elements, this.#other.buttons] : []) element.remove();
    const { picture, bar } = this.#frame;
    if (made) {
      picture.append(...made.elements);
      bar.insertBefore(made.buttons, bar.querySelector(".rule"));
    }
    [this.#other, this.#kind] = [made, kind];
    this.#scene.cancel();
    this.#morph.stop();
    // It has all that is used of a scene here.
    this.#scene = made ? /** @type {Scene} */ (/** @type {unknown} */ (made)) : this.#curves;
    this.#dress();
    this.#scene.theme = theme;
    this.#scene.resize(size);
  }

  /** @param {Kind} kind */
  async #made(kind) {
    if (kind === "curves") return null;
    const acts = { say: (/** @type {string} */ text) => this.#say(text), rested: () => this.#paper.renew() };
    if (kind === "part") return new (await import("./part/part-scene.js")).PartScene(this.#host, acts);
    if (kind === "laplace") return new (await import("./problem/problem-scene.js")).ProblemScene(this.#host, acts);
    return new (await import("./body/body-scene.js")).BodyScene(this.#host, acts);
  }

  #dress() {
    const { ownerDocument } = this;
    const root = /** @type {ShadowRoot} */ (this.shadowRoot);
    root.adoptedStyleSheets = [sheetOf(ownerDocument), ...(this.#other ? [this.#other.sheet(ownerDocument)] : [])];
  }

  get #source() {
    const presets = this.getAttribute("presets") ?? DirectrixFigure.presets;
    return { src: this.getAttribute("src"), preset: this.getAttribute("preset"), presets };
  }

  #reveal() {
    this.#isRevealed = true;
    this.#owesFocus = true;
    this.#render();
    this.#load();
  }

  /** The button that reveals a figure had the focus, and is gone: the next control gets it unless something else has. */
  #handFocus() {
    const { activeElement } = document;
    if (this.#owesFocus && (!activeElement || activeElement === document.body)) {
      this.#frame.bar.querySelector("button")?.focus({ preventScroll: true });
    }
    this.#owesFocus = false;
  }

  /** @param {CurvesDocument} document @param {boolean} isMoving */
  #edit(document, isMoving) {
    this.#scene.edit(document, isMoving);
    this.#renderOverlay();
    this.#working.begin();
  }

  /** @param {number} s */
  #setS(s) {
    if (s === this.#scene.s || this.#scene.stages === 0) return;
    this.#scene.s = s;
    this.#morph.render();
    this.#tell("change", { reason: "s", s });
    this.#linkLater();
  }

  /** @param {number} place in the growth */
  #setPlace(place) {
    const before = this.#step;
    this.#progress = place;
    this.#morph.render();
    this.#renderOverlay();
    if (this.#step === before) return;
    this.#renderFrame();
    this.#tell("change", { reason: "step", step: this.#step });
    this.#linkLater();
  }

  /** @param {LayerName} name @param {boolean} isOn */
  #setLayer(name, isOn) {
    const others = this.#scene.shownLayers.filter((each) => each !== name);
    this.#scene.layers = isOn ? [...others, name] : others;
    this.#scene.refresh();
    this.#tell("change", { reason: "layers" });
    this.#linkLater();
  }

  /** @param {"load" | "edit"} kind */
  #solved(kind) {
    this.#working.end();
    this.#frame.problem.hidden = true;
    if (kind === "load") {
      this.#handles.reset();
      this.#morph.stop();
      this.#progress = null;
    }
    this.#become("shown");
    this.#render();
    this.#handFocus();
    this.#linkLater();
    this.#paper.renew();
    if (kind === "load") this.#tell("load", { runsIn: this.runsIn });
    else this.#tell("change", { reason: "document" });
  }

  /**
   * @param {"document" | "edit" | "kernel"} kind
   * @param {unknown} error
   */
  #failed(kind, error) {
    this.#working.end();
    const { text, detail } = failureOf(kind, error);
    this.#frame.problem.hidden = false;
    write(this.#frame.problem, text);
    this.#become(this.#scene.document ? "shown" : "failed");
    this.#render();
    this.dispatchEvent(new CustomEvent("error", { detail }));
  }

  /** @param {string} state */
  #become(state) {
    this.#state = state === "loading" && this.#scene.document ? "shown" : state;
  }

  /** @param {string} type @param {object} detail */
  #tell(type, detail) {
    const { document, s, result } = this;
    this.dispatchEvent(new CustomEvent(type, { detail: { document, s, result, ...detail } }));
  }

  /** @param {string} text */
  #say(text) {
    this.#frame.say(text);
  }

  /** Brings the frame up to date, and the picture with it. */
  #render() {
    const isRevealed = this.#renderFrame();
    this.#scene.hasHandles = this.#hasHandles;
    this.#scene.growsSteps = this.#isGrowth;
    this.#morph.render();
    this.#paint();
    this.#linkLater();
    if (isRevealed) this.#load();
  }

  /** Everything but picture and controls. @returns {boolean} whether the figure may be seen */
  #renderFrame() {
    const isRevealed = this.#isRevealed || choiceOf(this, "reveal") === "auto";
    this.#frame.render({
      state: this.#state,
      controls: choiceOf(this, "controls"),
      title: this.getAttribute("alt") ?? this.#scene.document?.title ?? words.figure,
      result: this.#scene.result,
      poster: this.getAttribute("poster"),
      isRevealed,
      hasLink: this.getAttribute("editor") !== "none",
      layers: this.#scene.shownLayers,
      hasLayers: this.#scene.hasLayers,
      growth: this.#isGrowth && this.#scene.steps ? { step: this.#step, steps: this.#steps } : null,
    });
    return isRevealed;
  }

  /** Paints in the theme of the place. */
  #paint() {
    const chosen = choiceOf(this, "theme");
    const theme = chosen === "auto" ? themeAround(this, this.#frame.ground) : chosen === "dark" ? "dark" : "light";
    attribute(this.#frame.inner, "data-theme", theme);
    if (this.#scene.theme !== theme) {
      this.#scene.theme = theme;
      this.#scene.refresh();
    }
    this.#renderOverlay();
  }

  #renderOverlay() {
    const { steps, view, size } = this.#scene;
    this.#growth.render({ steps: this.#isGrowth ? steps : null, step: this.#step, view, size });
    this.#handles.render();
  }

  #linkLater() {
    if (this.isConnected) this.#link.later();
  }
}
