/**
 * What a figure of a body shows: its document, the verdict, the camera, and the section, which stands in for the place between curves.
 *
 * @import { BodySummary, CellVerdict, Control, HyperpatchDocument, RemoteHyperpatch } from "../../directrix.js"
 * @import { Kernel } from "../kernel.js"
 * @import { Host } from "../scene.js"
 * @import { Cut, Shape } from "./picture.js"
 */
import { STANDARD } from "../../space/camera.js";
import { cornersOf } from "../../space/vector.js";
import { isControl } from "../../connect.js";
import { body as remoteBody } from "../../remote-body.js";
import { WholeScene } from "../whole-scene.js";
import { fixed } from "../words.js";
import { cutOf, paint, shapeOf, within } from "./picture.js";
import { bodyResult } from "./result.js";
import { Standpoint } from "./standpoint.js";
import { bodySheetOf } from "./style.js";
import { words } from "./words.js";

/** Places of the section where it halts with reduced motion, less one. */
const STAGES = 10;
/**
 * What is left at least of the body's extent, and how far inside of what is left the face of the cut is found: a plane that lies in faces of
 * cells has no face.
 */
const LEFT = 0.02;
const INSIDE = 1e-6;
/** Distance of the triangles from the boundary, as a share of the diagonal: less than a pixel. */
const TOLERANCE = 1.5e-3;

/** @typedef {{ verdicts: CellVerdict[], volume: number, summary: BodySummary | null }} Known */

/** @extends {WholeScene<HyperpatchDocument>} */
export class BodyScene extends WholeScene {
  stages = STAGES;
  slider = words.section;

  #checks;
  #standpoint;
  #s = 0;
  #text = "";
  /** @type {Shape | null} */
  #shape = null;
  /** The cut that is painted, with the place that it is for. @type {{ s: number, cut: Cut | null }} */
  #cut = { s: 0, cut: null };
  /** @type {Known | null} */
  #known = null;

  /**
   * @param {Host} host
   * @param {{ say: (text: string) => void, rested: () => void }} more `rested`: the camera has come to rest elsewhere
   */
  constructor(host, { say, rested }) {
    super(host);
    this.#checks = this.laneOf(() => 2, (kernel, signal) => this.#check(kernel, signal));
    this.#standpoint = new Standpoint({
      corners: () => this.#shape && cornersOf(this.#shape.bounds),
      size: () => this.size,
      draw: () => this.#draw(),
      rested,
      say,
    });
  }

  get elements() {
    return this.#standpoint.orbit.elements;
  }

  get buttons() {
    return this.#standpoint.orbit.buttons;
  }

  /** @param {Document} owner */
  sheet = (owner) => bodySheetOf(owner);

  get s() {
    return this.#s;
  }

  set s(s) {
    this.#s = s;
    this.#standpoint.isFine = false;
    this.refresh();
  }

  /** The place of the section in words. */
  get spoken() {
    const plane = this.#planeAt(this.#s);
    return plane ? words.cut(fixed(plane.offset, 2)) : words.whole;
  }

  resized() {
    this.#standpoint.resize();
  }

  /** Brings the picture up with everything that it depends on. */
  refresh() {
    // Checks that were given up when the figure was taken from its page.
    if (this.#known && !this.#known.summary) this.#checks.push();
    if (this.incoming.waits || (this.#shape && this.#cut.s !== this.#s)) this.lane.push();
    else this.#standpoint.repaint();
  }

  /** Gives up what is asked for. */
  cancel() {
    this.#standpoint.cancel();
    this.lane.cancel();
    this.#checks.cancel();
  }

  /**
   * What a picture depends on besides the document.
   *
   * @param {number} ratio device pixels for one of CSS
   * @param {"light" | "dark"} [theme]
   */
  options(ratio, theme = this.theme) {
    return { ratio, theme, camera: this.#standpoint.camera, size: this.size, s: this.#cut.s, layers: [] };
  }

  /**
   * A picture apart from that of the screen.
   *
   * @param {HTMLCanvasElement} canvas
   * @param {{ ratio: number, theme: "light" | "dark" }} options
   */
  async print(canvas, { ratio, theme }) {
    if (this.#shape) paint(canvas, this.#shape, this.#cut.cut, { ...this.#look(ratio, theme), isFine: true });
  }

  /** @param {Kernel} kernel @param {AbortSignal} signal */
  async turn(kernel, signal) {
    const control = this.begin(kernel, signal, "bodies");
    if (this.incoming.waits) await this.#install(kernel, control);
    else if (this.document && this.#cut.s !== this.#s) this.#cut = await this.#section(kernel, control, this.#s);
    this.host.onprogress(1);
    this.#standpoint.repaint();
    this.#standpoint.settleLater();
  }

  /** @param {Kernel} kernel @param {Control} control */
  #install(kernel, control) {
    return this.incoming.settle(control.signal, async (given, isStillWanted) => {
      const body = await asked(kernel, given.text, control);
      const verdicts = await body.verdicts({ global: false }, control);
      const surface = await body.surface(within(body.cells, TOLERANCE), control);
      if (!isStillWanted()) return false;
      const volume = body.cells.reduce((sum, cell) => sum + Math.abs(cell.volume), 0);
      [this.document, this.#text] = [given.document, given.text];
      this.#known = { verdicts, volume, summary: null };
      this.result = bodyResult(verdicts, volume, null);
      this.#shape = shapeOf(surface);
      this.#s = 0;
      this.#cut = { s: 0, cut: null };
      this.#standpoint.isFine = true;
      this.#standpoint.fit(STANDARD.iso);
      this.#standpoint.paint();
      this.host.onsolved("load");
      this.#checks.push();
      return true;
    });
  }

  /** Every check to its end, which may take long. @param {Kernel} kernel @param {AbortSignal} signal */
  async #check(kernel, signal) {
    const known = this.#known;
    if (!known || known.summary) return;
    const body = await asked(kernel, this.#text, { signal });
    const verdicts = await body.verdicts({}, { signal });
    const summary = await body.summary({ signal });
    if (known !== this.#known) return;
    this.#known = { ...known, verdicts, summary };
    this.result = bodyResult(verdicts, known.volume, summary);
    this.#standpoint.repaint();
    this.host.onsolved("edit");
  }

  /**
   * @param {Kernel} kernel
   * @param {Control} control
   * @param {number} s
   */
  async #section(kernel, control, s) {
    const plane = this.#planeAt(s);
    const shape = this.#shape;
    if (!plane || !shape) return { s, cut: null };
    const { min, max } = shape.bounds;
    const body = await asked(kernel, this.#text, control);
    const section = await body.section({ normal: [0, 1, 0], offset: plane.offset + INSIDE * (max[1] - min[1]) }, {}, control);
    return { s, cut: cutOf(plane, section) };
  }

  /** The plane across y that takes away what is before it; null for the whole body. @param {number} s */
  #planeAt(s) {
    if (!this.#shape || s <= 0) return null;
    const { min, max } = this.#shape.bounds;
    return { normal: [0, 1, 0], offset: min[1] + Math.min(s, 1 - LEFT) * (max[1] - min[1]) };
  }

  #draw() {
    if (!this.#shape) return;
    paint(this.host.canvas, this.#shape, this.#cut.cut, this.#look(globalThis.devicePixelRatio || 1, this.theme));
    this.host.onpaint();
  }

  /** @param {number} ratio @param {"light" | "dark"} theme */
  #look(ratio, theme) {
    const folds = this.#known?.verdicts.flatMap(({ witness }) => (witness ? [witness.point] : [])) ?? [];
    const overlaps = this.#known?.summary?.pairs.flatMap(({ point }) => (point ? [point] : [])) ?? [];
    return { ...this.#standpoint.look(ratio, theme), witnesses: [...folds, ...overlaps] };
  }
}

/**
 * A body whose questions the kernel answers, wherever it runs.
 *
 * @param {Kernel} kernel
 * @param {string} text
 * @param {Control} control
 * @returns {Promise<RemoteHyperpatch>}
 */
function asked(kernel, text, control) {
  if (kernel.runsIn !== "main thread") return kernel.call("hyperpatch", [text], control);
  const call = (/** @type {"hyperpatch"} */ name, /** @type {any[]} */ args) => {
    const last = args.at(-1);
    const hasControl = args.length > 2 && typeof last === "object" && last !== null && isControl(last);
    return kernel.call(name, args.slice(0, 2), hasControl ? /** @type {Control} */ (last) : undefined);
  };
  return remoteBody({ call }, text, control);
}
