/**
 * What a figure of a part shows: its document, its colours and what it is made of, to be read place by place.
 *
 * @import { Control, PartDocument, PartPlace, Point, RemotePart, View } from "../../directrix.js"
 * @import { Kernel } from "../kernel.js"
 * @import { Size } from "../plane.js"
 * @import { Host } from "../scene.js"
 */
import { remotePart } from "../../remote-part.js";
import { h } from "../dom.js";
import { fitting } from "../plane.js";
import { WholeScene } from "../whole-scene.js";
import { pictureOf } from "./picture.js";
import { createPlaces } from "./places.js";
import { partResult } from "./result.js";
import { partSheetOf } from "./style.js";

/** Room round the bodies in CSS pixels. */
const MARGIN = 12;
/** Pixels that are evaluated, of a picture at rest and of one that moves. */
const MOST = 2_000_000;
const MOVING = 250_000;

/** @typedef {{ part: RemotePart, document: Required<Pick<PartDocument, "materials" | "bodies">> & PartDocument }} Known `document` with every default */
/** @typedef {{ canvas: HTMLCanvasElement, view: View, size: Size, key: string }} Painted a picture with the view that it is of */

/** @extends {WholeScene<PartDocument>} */
export class PartScene extends WholeScene {
  #rested;
  #reading;
  #places;
  #key = h("div", { class: "key", "aria-hidden": "true" });
  #text = "";
  /** @type {Known | null} */
  #known = null;
  /** Whether the view follows the size. */
  #follows = true;
  #isMoving = false;
  /** @type {Painted | null} */
  #painted = null;
  /** The place that is to be read, and who waits for it. @type {{ at: Point, resolve: (place: PartPlace | null) => void, reject: (error: unknown) => void } | null} */
  #asked = null;

  /**
   * @param {Host} host
   * @param {{ say: (text: string) => void, rested: () => void }} more `rested`: another view has come to rest
   */
  constructor(host, { say, rested }) {
    super(host);
    this.#rested = rested;
    this.#reading = this.laneOf(() => 0, (kernel, signal) => this.#read(kernel, signal));
    this.#places = createPlaces({
      view: () => this.view,
      fitted: () => this.#fitted(),
      size: () => this.size,
      names: () => {
        const { materials = [], bodies = [], unit = "mm" } = this.#known?.document ?? {};
        return { materials, bodies, unit };
      },
      look: (view, isDrag) => this.#look(view, isDrag),
      rest: () => this.#look(this.view, false),
      probe: (at) => this.#probe(at),
      say,
    });
    this.buttons = h("div", { class: "tools" }, this.#key, this.#places.zooms);
  }

  get elements() {
    return this.#places.elements;
  }

  /** @param {Document} owner */
  sheet = (owner) => partSheetOf(owner);

  resized() {
    if (this.#follows) this.view = this.#fitted();
    this.#stretch();
    this.refresh();
  }

  /** Brings the picture up with everything that it depends on. */
  refresh() {
    if (this.incoming.waits || this.#known) this.lane.push();
  }

  /** Gives up what is asked for. */
  cancel() {
    this.lane.cancel();
    this.#reading.cancel();
    this.#places.clear();
  }

  /**
   * What a picture depends on besides the document.
   *
   * @param {number} ratio device pixels for one of CSS
   * @param {"light" | "dark"} [theme]
   */
  options(ratio, theme = this.theme) {
    return { ratio, theme, view: this.view, size: this.size, layers: [] };
  }

  /**
   * A picture apart from that of the screen.
   *
   * @param {HTMLCanvasElement} canvas
   * @param {{ ratio: number }} options
   * @param {Kernel} kernel
   * @param {AbortSignal} signal
   */
  async print(canvas, { ratio }, kernel, signal) {
    if (!this.#known) return;
    const painted = await pictureOf(await asked(kernel, this.#text, { signal }), { view: this.view, size: this.size, ratio, most: MOST }, { signal });
    [canvas.width, canvas.height] = [painted.width, painted.height];
    canvas.getContext("2d")?.drawImage(painted, 0, 0);
  }

  /** The view that shows all bodies. @returns {View} */
  #fitted() {
    return fitting(this.#known?.part.box ?? [], this.size, MARGIN);
  }

  /** @param {View} view @param {boolean} isDrag */
  #look(view, isDrag) {
    this.#follows = view.scale <= this.#fitted().scale;
    this.view = this.#follows ? this.#fitted() : view;
    this.#isMoving = isDrag;
    this.#stretch();
    this.refresh();
    if (!isDrag) this.#rested();
  }

  /** @param {Kernel} kernel @param {AbortSignal} signal */
  async turn(kernel, signal) {
    const control = this.begin(kernel, signal, "parts");
    const isNew = await this.#install(kernel, control);
    if (this.#known) await this.#paint(kernel, control);
    this.host.onprogress(1);
    if (isNew) this.host.onsolved("load");
  }

  /** @param {Kernel} kernel @param {Control} control @returns {Promise<boolean>} whether another part is there */
  #install(kernel, control) {
    return this.incoming.settle(control.signal, async (given, isStillWanted) => {
      const part = await asked(kernel, given.text, control);
      const document = /** @type {Known["document"]} */ (await part.defaults(control));
      const amounts = part.box ? await part.amounts({}, control) : { area: 0, amounts: [], bodies: [] };
      const rules = part.box && document.rules?.length ? (await part.violations({}, control)).rules : [];
      if (!isStillWanted()) return false;
      [this.document, this.#text, this.#known] = [given.document, given.text, { part, document }];
      this.result = partResult(part, { document, amounts, rules });
      this.#follows = true;
      this.view = this.#fitted();
      this.#painted = null;
      this.#places.clear();
      this.#name(amounts.area > 0 ? amounts.amounts : []);
      return true;
    });
  }

  /** The materials that there are. @param {number[]} amounts */
  #name(amounts) {
    const rows = (this.#known?.document.materials ?? []).flatMap(({ name, color }, k) => {
      const swatch = h("span", { class: "swatch" });
      swatch.style.background = color;
      return amounts[k] > 0 ? [h("span", {}, swatch, name)] : [];
    });
    this.#key.replaceChildren(...rows);
  }

  /** @param {Kernel} kernel @param {Control} control */
  async #paint(kernel, control) {
    const { size, view } = this;
    if (size.width < 1 || size.height < 1) return;
    const ratio = globalThis.devicePixelRatio || 1;
    const key = JSON.stringify([this.#text, view, size, ratio, this.#isMoving]);
    if (this.#painted?.key === key) return;
    const look = { view, size, ratio, most: this.#isMoving ? MOVING : MOST };
    const canvas = await pictureOf(await asked(kernel, this.#text, control), look, control);
    this.#painted = { canvas, view, size, key };
    this.#stretch();
    this.host.onpaint();
  }

  /** Shows the last picture where it belongs in the present view, until that has one of its own. */
  #stretch() {
    const painted = this.#painted;
    const { canvas } = this.host;
    this.#places.render();
    if (!painted) return;
    const ratio = globalThis.devicePixelRatio || 1;
    const [w, h] = [this.size.width, this.size.height].map((side) => Math.max(1, Math.round(side * ratio)));
    if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
    const context = canvas.getContext("2d");
    if (!context) return;
    context.clearRect(0, 0, w, h);
    const factor = this.view.scale / painted.view.scale;
    const [x, y] = [0, 1].map((axis) => (painted.view.center[axis] - this.view.center[axis]) * this.view.scale * ratio);
    const [width, height] = [painted.size.width * factor * ratio, painted.size.height * factor * ratio];
    const isWhole = factor === 1 && x === 0 && y === 0 && painted.canvas.width === w;
    if (isWhole) context.drawImage(painted.canvas, 0, 0);
    else context.drawImage(painted.canvas, w / 2 + x - width / 2, h / 2 - y - height / 2, width, height);
  }

  /** What there is at a place, once the kernel has a turn for it; only the last one that is asked for is answered. @param {Point} at */
  #probe(at) {
    this.#asked?.reject(null);
    /** @type {Promise<PartPlace | null>} */
    const found = new Promise((resolve, reject) => (this.#asked = { at, resolve, reject }));
    this.#reading.push();
    return found;
  }

  /** @param {Kernel} kernel @param {AbortSignal} signal */
  async #read(kernel, signal) {
    const wanted = this.#asked;
    if (!wanted || !this.#known) return;
    this.#asked = null;
    try {
      const part = await asked(kernel, this.#text, { signal });
      wanted.resolve(await part.probe(wanted.at, { signal }));
    } catch (error) {
      wanted.reject(error);
      throw error;
    }
  }
}

/**
 * A part whose questions the kernel answers, wherever it runs.
 *
 * @param {Kernel} kernel
 * @param {string} text
 * @param {Control} control
 * @returns {Promise<RemotePart>}
 */
const asked = (kernel, text, control) =>
  kernel.runsIn === "main thread"
    ? remotePart((args) => kernel.call("part", args.slice(0, 2), args[2]), text, control)
    : kernel.call("part", [text], control);
