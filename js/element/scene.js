/**
 * What one figure shows: its document, the matching, and the picture on its canvas, kept up with each other by turns of the kernel.
 *
 * @import { CurvesDocument, LayerName, Match, Picture, View } from "../directrix.js"
 * @import { FigureResult } from "../element.js"
 * @import { Kernel } from "./kernel.js"
 * @import { Size } from "./plane.js"
 */
import { DirectrixError } from "../errors.js";
import { toText } from "../text.js";
import { stepsOf } from "./growth.js";
import { planePoints } from "./in-space.js";
import { Lane } from "./kernel.js";
import { fitting, toScreen } from "./plane.js";
import { summary } from "./result.js";
import { words } from "./words.js";

/** Device pixels painted at most while something moves, and the pause after which all of them are. */
const MOVING_PIXELS = 1_000_000;
const IDLE = 250;
/** Longest side of a picture that the kernel paints. */
const LARGEST = 4096;
/** Place of the current in-between curve where a document names none. */
const FIRST_S = 0.4;
/** @type {LayerName[]} */
const FIRST_LAYERS = ["material", "rulingLines", "samples", "unconnected"];
/** CSS pixels below which samples would run into each other. */
const CROWDED = 480;
/** Room round the curves in CSS pixels, and with control points. */
const MARGIN = 12;
const MARGIN_OF_HANDLES = 24;

/**
 * Whether an error says what is wrong with a document; what the module `figure` does not compute goes to `full`.
 *
 * @param {unknown} error
 * @returns {error is DirectrixError}
 */
const isOfDocument = (error) => error instanceof DirectrixError && error.code !== "not-in-module";

/**
 * @typedef {object} Host
 * @property {HTMLCanvasElement} canvas
 * @property {() => number} urgency see `Lane`
 * @property {(kind: "load" | "edit") => void} onsolved a new document stands on the canvas, or an edit has its result
 * @property {() => void} onpaint
 * @property {(progress: number) => void} onprogress
 * @property {(kind: "document" | "edit" | "kernel", error: unknown) => void} onproblem
 */

export class Scene {
  /** @type {Kernel["runsIn"] | null} */
  runsIn = null;
  /** The document as given, with the edits. @type {CurvesDocument | null} */
  document = null;
  /** The in-between curves are j = 0 to so many. */
  stages = 1;
  /** @type {FigureResult | null} */
  result = null;
  /** The steps of the greedy growth, where they are shown and there. @type {import("./growth.js").Steps | null} */
  steps = null;
  /** @type {View} */
  view = { center: [0, 0], scale: 1 };
  /** @type {Size} */
  size = { width: 0, height: 0 };
  /** @type {"light" | "dark"} */
  theme = "light";
  /** @type {LayerName[] | null} what the person has chosen */
  layers = null;
  hasLayers = true;
  /** What the slider is for, and its place in words where that is not s. */
  slider = words.morph.slider;
  spoken = null;

  #host;
  #lane;
  #s = FIRST_S;
  #hasHandles = false;
  #growsSteps = false;
  /** The document that the steps belong to. @type {CurvesDocument | null} */
  #grown = null;
  /** A document that is to be shown next. @type {{ text: string, document: CurvesDocument } | null} */
  #incoming = null;
  /** @type {Match | null} */
  #match = null;
  /** The document that the match belongs to, or that has none. @type {CurvesDocument | null} */
  #matched = null;
  #isMoving = false;
  #isFine = true;
  /** @type {"load" | "edit" | null} */
  #news = null;
  #painted = "";
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #idle;

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
    this.#lane = new Lane({
      work: (kernel, signal) => this.#turn(kernel, signal),
      failed: (error) => host.onproblem("kernel", error),
      urgency: host.urgency,
    });
  }

  get s() {
    return this.#s;
  }

  set s(s) {
    this.#s = s;
    this.#changed();
  }

  get hasHandles() {
    return this.#hasHandles;
  }

  set hasHandles(hasHandles) {
    if (hasHandles === this.#hasHandles) return;
    this.#hasHandles = hasHandles;
    this.#fit();
    this.#changed();
  }

  /** Whether the growth is shown step by step, in place of what comes of it. */
  get growsSteps() {
    return this.#growsSteps;
  }

  set growsSteps(growsSteps) {
    if (growsSteps === this.#growsSteps) return;
    this.#growsSteps = growsSteps;
    this.#changed();
  }

  /** The layers of the picture, control points aside. */
  get shownLayers() {
    const given = this.layers ?? this.document?.view?.layers;
    if (given) return given.filter((name) => name !== "controlPoints");
    return FIRST_LAYERS.filter((name) => name !== "samples" || this.size.width >= CROWDED);
  }

  /** The document with the place and the layers that the person has chosen, for a link. @returns {CurvesDocument | null} */
  get state() {
    const { document } = this;
    if (!document) return null;
    const view = {
      ...(this.layers ? { layers: this.layers } : {}),
      ...(this.#s === (document.view?.s ?? FIRST_S) ? {} : { s: this.#s }),
    };
    return Object.keys(view).length === 0 ? document : { ...document, view: { ...document.view, ...view } };
  }

  /**
   * Shows another document once it is found to be one; until then the last one stays.
   *
   * @param {import("../directrix.js").DocumentInput} given
   * @throws {DirectrixError} when it is no JSON or holds a number that is not finite
   */
  open(given) {
    const text = toText(given);
    this.#incoming = { text, document: parsed(text) };
    this.#lane.cancel();
    this.#lane.push();
  }

  /**
   * @param {CurvesDocument} document the one that is shown with some control point elsewhere
   * @param {boolean} isMoving whether more of it is about to come
   */
  edit(document, isMoving) {
    this.document = document;
    this.#isMoving = isMoving;
    if (!isMoving && !this.#isInside()) this.#fit();
    this.#changed();
  }

  /** @param {Size} size */
  resize(size) {
    if (size.width === this.size.width && size.height === this.size.height) return;
    this.size = size;
    this.#fit();
    this.#changed();
  }

  /** Paints again when anything that a picture depends on has changed. */
  refresh() {
    this.#changed();
  }

  /**
   * A picture apart from that of the screen, without control points.
   *
   * @param {HTMLCanvasElement} canvas
   * @param {ReturnType<Scene["options"]>} options
   * @param {Kernel} kernel
   * @param {AbortSignal} signal
   */
  async print(canvas, options, kernel, signal) {
    const layers = options.layers.filter((name) => name !== "controlPoints");
    show(canvas, await kernel.call("paint", [JSON.stringify(this.document), { ...options, layers }], { signal }));
  }

  /** Gives up what is asked for. */
  cancel() {
    clearTimeout(this.#idle);
    this.#lane.cancel();
  }

  /**
   * The options of a picture.
   *
   * @param {number} pixelRatio
   * @param {"light" | "dark"} [theme]
   */
  options(pixelRatio, theme = this.theme) {
    const { width, height } = this.size;
    const ratio = Math.min(pixelRatio, LARGEST / Math.max(width, height));
    return {
      width: Math.max(1, Math.round(width * ratio)),
      height: Math.max(1, Math.round(height * ratio)),
      pixelRatio: ratio,
      view: this.view,
      layers: /** @type {LayerName[]} */ ([
        ...(this.#growsSteps ? ["samples"] : this.shownLayers),
        ...(this.#hasHandles ? ["controlPoints"] : []),
      ]),
      theme,
      s: this.#growsSteps ? null : this.#s,
    };
  }

  #changed() {
    clearTimeout(this.#idle);
    this.#isFine = false;
    if (this.document || this.#incoming) this.#lane.push();
  }

  /** @param {Kernel} kernel @param {AbortSignal} signal */
  async #turn(kernel, signal) {
    this.runsIn = kernel.runsIn;
    const control = { signal, onprogress: this.#host.onprogress };
    if (this.#incoming) await this.#install(kernel, control);
    const { document } = this;
    if (!document) return;
    if (!this.#isAnswered(document, this.#isMoving)) await this.#solve(kernel, control, document);
    if (this.#growsSteps && this.result && this.#grown !== document) await this.#grow(kernel, control, document);
    if (this.#match && this.#matched === document) await this.#paint(kernel, control, document);
    this.#host.onprogress(1);
  }

  /** Whether the match of a document is there. @param {CurvesDocument} document @param {boolean} coarse */
  #isAnswered(document, coarse) {
    return this.#matched === document && (coarse || !this.#match?.coarse);
  }

  /** @param {Kernel} kernel @param {import("../directrix.js").Control} control */
  async #install(kernel, control) {
    const incoming = this.#incoming;
    if (!incoming) return;
    const { text, document } = incoming;
    try {
      const completed = await kernel.call("defaults", [text], { ...control });
      const match = await kernel.call("match", [text, {}], { ...control });
      if (this.#incoming !== incoming) return;
      this.document = document;
      const spans = completed.blend.kind === "harmonic" ? 1 : Math.max(1, document.curves.length - 1);
      this.stages = completed.blend.stages * spans;
      this.layers = null;
      this.#s = document.view?.s ?? FIRST_S;
      this.#isMoving = false;
      this.#isFine = true;
      this.#painted = "";
      this.#accept(document, match);
      this.#fit();
      this.#news = "load";
    } catch (error) {
      if (control.signal?.aborted || !isOfDocument(error)) throw error;
      this.#host.onproblem("document", error);
    }
    if (this.#incoming === incoming) this.#incoming = null;
  }

  /** @param {Kernel} kernel @param {import("../directrix.js").Control} control @param {CurvesDocument} document */
  async #solve(kernel, control, document) {
    const isNew = this.#matched !== document;
    try {
      const match = await kernel.call("match", [JSON.stringify(document), { coarse: this.#isMoving }], { ...control });
      this.#accept(document, match);
      if (isNew) this.#news ??= "edit";
    } catch (error) {
      if (control.signal?.aborted || !isOfDocument(error)) throw error;
      [this.#match, this.#matched, this.result] = [null, document, null];
      if (isNew) this.#host.onproblem("edit", error);
    }
  }

  /** @param {Kernel} kernel @param {import("../directrix.js").Control} control @param {CurvesDocument} document */
  async #grow(kernel, control, document) {
    const isWhole = document.curves.length === 2 && document.blend?.kind !== "harmonic";
    this.steps = isWhole ? stepsOf(await kernel.call("steps", [JSON.stringify(document)], { ...control })) : null;
    this.#grown = document;
    this.#news ??= "edit";
  }

  /** @param {CurvesDocument} document @param {Match} match */
  #accept(document, match) {
    [this.#match, this.#matched, this.result] = [match, document, summary(match, document)];
  }

  /** @param {Kernel} kernel @param {import("../directrix.js").Control} control @param {CurvesDocument} document */
  async #paint(kernel, control, document) {
    const { width, height } = this.size;
    if (width < 1 || height < 1) return;
    const full = globalThis.devicePixelRatio || 1;
    const moving = Math.min(full, Math.sqrt(MOVING_PIXELS / (width * height)));
    const isFine = this.#isFine || moving === full;
    const options = this.options(isFine ? full : moving);
    const coarse = Boolean(this.#match?.coarse);
    const key = JSON.stringify(options);
    if (this.#news !== null || key !== this.#painted || coarse) {
      const picture = await kernel.call("paint", [JSON.stringify(document), { ...options, coarse }], { ...control });
      show(this.#host.canvas, picture);
      this.#painted = key;
    }
    if (!isFine || coarse) this.#idle = setTimeout(() => this.#rest(), IDLE);
    const news = this.#news;
    this.#news = null;
    this.#host.onpaint();
    if (news) this.#host.onsolved(news);
  }

  /** The picture of a figure at rest. */
  #rest() {
    this.#isFine = true;
    this.#isMoving = false;
    this.#lane.push();
  }

  #fit() {
    const { width } = this.size;
    if (!this.#match || width < 1) return;
    const curves = this.#match.samples.flatMap(({ points }) => points);
    const handles = this.#hasHandles ? (this.document?.curves ?? []).flatMap(planePoints) : [];
    this.view = fitting([...curves, ...handles], this.size, this.#hasHandles ? MARGIN_OF_HANDLES : MARGIN);
  }

  /** Whether every control point can be reached. */
  #isInside() {
    const { width, height } = this.size;
    return (this.document?.curves ?? []).every((curve) =>
      planePoints(curve).every((at) => {
        const [x, y] = toScreen(this.view, this.size, at);
        return x >= 4 && y >= 4 && x <= width - 4 && y <= height - 4;
      }),
    );
  }
}

/** @param {string} text @returns {CurvesDocument} */
function parsed(text) {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new DirectrixError("syntax", "", /** @type {Error} */ (error).message);
  }
}

/** @param {HTMLCanvasElement} canvas @param {Picture} picture */
function show(canvas, { width, height, data }) {
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
  canvas.getContext("2d")?.putImageData(new ImageData(/** @type {Uint8ClampedArray<ArrayBuffer>} */ (data), width, height), 0, 0);
}
