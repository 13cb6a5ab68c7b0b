/**
 * What a figure of a boundary value problem shows: in space its boundary, cut by the plane of the document, with the solution on it; in the plane the whole
 * of it.
 *
 * @import { Control, LaplaceBoundary, LaplaceDocument, RemoteLaplaceSolution } from "../../directrix.js"
 * @import { FigureResult } from "../../element.js"
 * @import { Cut, Shape } from "../body/picture.js"
 * @import { Kernel } from "../kernel.js"
 * @import { Host } from "../scene.js"
 */
import { remoteLaplace } from "../../remote-laplace.js";
import { STANDARD } from "../../space/camera.js";
import { cornersOf } from "../../space/vector.js";
import { paint } from "../body/picture.js";
import { Standpoint } from "../body/standpoint.js";
import { h } from "../dom.js";
import { NO_MATCHING } from "../no-matching.js";
import { WholeScene } from "../whole-scene.js";
import { faceOf, planeOf, shapeOf } from "./picture.js";
import { problemSheetOf } from "./style.js";
import { words } from "./words.js";

/** Pixels of the solution along the longer side, of small problems and of large ones, and how many elements make one large. */
const PIXELS = { small: 176, large: 96 };
const LARGE = 4000;
/** What a document names when it has no materials, as in docs/format.md. */
const MATERIALS = [{ color: "#f0e442" }, { color: "#009e73" }];

/** @extends {WholeScene<LaplaceDocument>} */
export class ProblemScene extends WholeScene {
  #standpoint;
  #kind = h("div", { class: "key" });
  /** @type {{ shape: Shape, cut: Cut | null, isFlat: boolean } | null} */
  #known = null;

  /**
   * @param {Host} host
   * @param {{ say: (text: string) => void, rested: () => void }} more `rested`: the camera has come to rest elsewhere
   */
  constructor(host, { say, rested }) {
    super(host);
    this.#standpoint = new Standpoint({
      corners: () => this.#known && cornersOf(this.#known.shape.bounds),
      isFlat: () => this.#known?.isFlat === true,
      size: () => this.size,
      draw: () => this.#draw(),
      rested,
      say,
    });
    this.buttons = h("div", { class: "tools" }, this.#kind, this.#standpoint.orbit.buttons);
  }

  get elements() {
    return this.#standpoint.orbit.elements;
  }

  /** @param {Document} owner */
  sheet = (owner) => problemSheetOf(owner);

  resized() {
    this.#standpoint.resize();
  }

  /** Brings the picture up with everything that it depends on. */
  refresh() {
    if (this.incoming.waits) this.lane.push();
    else this.#standpoint.repaint();
  }

  /** Gives up what is asked for. */
  cancel() {
    this.#standpoint.cancel();
    this.lane.cancel();
  }

  /**
   * What a picture depends on besides the document.
   *
   * @param {number} ratio device pixels for one of CSS
   * @param {"light" | "dark"} [theme]
   */
  options(ratio, theme = this.theme) {
    return { ratio, theme, camera: this.#standpoint.camera, size: this.size, layers: [] };
  }

  /**
   * A picture apart from that of the screen.
   *
   * @param {HTMLCanvasElement} canvas
   * @param {{ ratio: number, theme: "light" | "dark" }} options
   */
  async print(canvas, { ratio, theme }) {
    if (this.#known) paint(canvas, this.#known.shape, this.#known.cut, { ...this.#standpoint.look(ratio, theme), isFine: true });
  }

  /** @param {Kernel} kernel @param {AbortSignal} signal */
  async turn(kernel, signal) {
    const control = this.begin(kernel, signal, "boundary value problems");
    if (this.incoming.waits) await this.#install(kernel, control);
    this.host.onprogress(1);
    this.#standpoint.repaint();
  }

  /** @param {Kernel} kernel @param {Control} control */
  #install(kernel, control) {
    return this.incoming.settle(control.signal, async (given, isStillWanted) => {
      /** @type {LaplaceBoundary} */
      const boundary = await kernel.call("boundary", [given.text], control);
      const solution = boundary.ready ? await solved(kernel, boundary, control) : null;
      const { materials = MATERIALS } = given.document;
      const [plane, isFlat] = [boundary.dimension === 3 ? planeOf(given.document) : null, boundary.dimension === 2];
      const pixels = boundary.elements.length / boundary.dimension > LARGE ? PIXELS.large : PIXELS.small;
      const cut = solution && (isFlat || plane) ? await faceOf(solution, { boundary, materials, plane }, pixels, { signal: control.signal }) : null;
      if (!isStillWanted()) return false;
      this.document = given.document;
      this.#known = { shape: shapeOf(boundary, materials), cut, isFlat };
      this.result = resultOf(given.document, boundary, solution);
      this.#kind.textContent = isFlat ? words.plane : cut ? words.section : words.space;
      // A picture that is not turned has no hint that it could be.
      this.#standpoint.orbit.elements[2].hidden = isFlat;
      this.#standpoint.isFine = true;
      this.#standpoint.fit(STANDARD.iso);
      this.#standpoint.paint();
      this.host.onsolved("load");
      return true;
    });
  }

  #draw() {
    if (!this.#known) return;
    paint(this.host.canvas, this.#known.shape, this.#known.cut, this.#standpoint.look(globalThis.devicePixelRatio || 1, this.theme));
    this.host.onpaint();
  }
}

/**
 * The solution of a problem, wherever the kernel runs.
 *
 * @param {Kernel} kernel
 * @param {LaplaceBoundary} boundary
 * @param {Control} control
 * @returns {Promise<RemoteLaplaceSolution>}
 */
function solved(kernel, { dimension, vertices, elements, groups, conditions, composition, solver }, control) {
  const input = { dimension, vertices, elements, groups, conditions, composition, solver };
  if (kernel.runsIn !== "main thread") return kernel.call("solveLaplace", [input], control);
  return remoteLaplace((args) => kernel.call("solveLaplace", args.slice(0, 2), args[2]), input, control);
}

/**
 * What a problem is worth, in numbers and in words.
 *
 * @param {LaplaceDocument} document
 * @param {LaplaceBoundary} boundary
 * @param {RemoteLaplaceSolution | null} solution
 * @returns {FigureResult}
 */
export function resultOf({ title = "", section }, { dimension, elements, diagnostics }, solution) {
  const faults = diagnostics.filter(({ remark }) => !remark);
  const ok = solution?.converged === true;
  const iterations = solution ? Math.max(...solution.iterations) : 0;
  const facts = [
    dimension === 2 ? words.plane : section ? words.section : words.space,
    words.elements(elements.length / dimension, dimension),
    ...(solution ? [ok ? words.solved : words.notConverged, words.iterations(iterations)] : faults.slice(0, 1).map(({ message }) => message)),
  ];
  return {
    ...NO_MATCHING,
    diagnostics: [...new Set(diagnostics.map(({ code }) => code))],
    ok,
    verified: ok,
    text: words.named(title, facts),
    brief: facts.slice(1).join(", "),
  };
}
