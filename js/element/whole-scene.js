/**
 * What figures of other documents than curves have in common: the module "full" reads them, they are shown once they are found to be sound, and they are
 * looked at but not edited. Each is to the element what the scene of curves is, see scene.js.
 *
 * @import { DocumentInput, LayerName, View } from "../directrix.js"
 * @import { FigureResult } from "../element.js"
 * @import { Kernel } from "./kernel.js"
 * @import { Size } from "./plane.js"
 * @import { Host } from "./scene.js"
 */
import { DirectrixError } from "../errors.js";
import { Incoming } from "./incoming.js";
import { isWhole, Lane } from "./kernel.js";

/** @template {object} D the document */
export class WholeScene {
  /** @type {Kernel["runsIn"] | null} */
  runsIn = null;
  /** @type {D | null} */
  document = null;
  /** @type {FigureResult | null} */
  result = null;
  /** @type {Size} */
  size = { width: 0, height: 0 };
  /** @type {"light" | "dark"} */
  theme = "light";
  /** @type {View} */
  view = { center: [0, 0], scale: 1 };
  /** Where the slider halts, and what it is for; none where there are no stages. */
  stages = 0;
  slider = "";

  // What only curves have.
  steps = null;
  layers = null;
  /** @type {LayerName[]} */
  shownLayers = [];
  hasLayers = false;
  hasHandles = false;
  growsSteps = false;

  /** The document that is to be shown next. @type {Incoming<D>} */
  incoming;
  /** Turns of the kernel. */
  lane;

  /** @param {Host} host */
  constructor(host) {
    this.host = host;
    this.incoming = new Incoming((error) => host.onproblem("document", error));
    this.lane = this.laneOf(host.urgency, (kernel, signal) => this.turn(kernel, signal));
  }

  /**
   * @param {Host["urgency"]} urgency
   * @param {(kernel: Kernel, signal: AbortSignal) => Promise<void>} work
   */
  laneOf(urgency, work) {
    return new Lane({ work, failed: (error) => this.host.onproblem("kernel", error), urgency });
  }

  /** Place of the slider, and its words. */
  get s() {
    return 0;
  }

  get spoken() {
    return "";
  }

  get state() {
    return this.document;
  }

  /**
   * Shows another document once it is found to be sound; until then the last one stays.
   *
   * @param {DocumentInput} given
   * @throws {DirectrixError} when it is no JSON or holds a number that is not finite
   */
  open(given) {
    this.incoming.take(given);
    this.lane.cancel();
    this.lane.push();
  }

  edit() {}

  /** @param {Size} size */
  resize(size) {
    if (size.width === this.size.width && size.height === this.size.height) return;
    this.size = size;
    this.resized();
  }

  /** The size is another one. @abstract */
  resized() {}

  /**
   * What the kernel does in a turn.
   *
   * @abstract
   * @param {Kernel} _kernel
   * @param {AbortSignal} _signal
   */
  async turn(_kernel, _signal) {}

  /**
   * Begins a turn.
   *
   * @param {Kernel} kernel
   * @param {AbortSignal} signal
   * @param {string} kind of documents, in the plural
   * @throws {DirectrixError} when the module does not know them
   */
  begin(kernel, signal, kind) {
    if (!isWhole()) throw new DirectrixError("not-in-module", "kind", `${kind} are read by the module "full"`);
    this.runsIn = kernel.runsIn;
    return { signal, onprogress: this.host.onprogress };
  }
}
