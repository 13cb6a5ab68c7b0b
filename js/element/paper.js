/**
 * The picture that a figure has on paper: in light colours, at the resolution of a printer.
 *
 * A page is printed at once, without time to paint, so the picture lies ready some time after the figure has come to rest: packed, as an
 * image that only print shows. Where a policy of the page forbids such an image, the picture of the screen is printed.
 *
 * @import { Scene } from "./scene.js"
 */
import { Lane } from "./kernel.js";

/** Milliseconds of rest. */
const REST = 1500;
/** Device pixels for a CSS pixel on paper, of which there are 96 to the inch. */
const RATIO = 3;

export class Paper {
  #scene;
  #image;
  #lane;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #rest;
  #address = "";
  #painted = "";

  /** @param {() => Scene} scene what is shown @param {HTMLImageElement} image */
  constructor(scene, image) {
    this.#scene = scene;
    this.#image = image;
    image.addEventListener("error", () => this.#forget());
    this.#lane = new Lane({
      work: (kernel, signal) => this.#paint(kernel, signal),
      failed: () => this.#forget(),
      urgency: () => 2,
    });
  }

  /** The figure looks different. */
  renew() {
    this.#lane.cancel();
    clearTimeout(this.#rest);
    this.#rest = setTimeout(() => this.#lane.push(), REST);
  }

  cancel() {
    this.#lane.cancel();
    clearTimeout(this.#rest);
    this.#forget();
  }

  #forget() {
    if (this.#address) URL.revokeObjectURL(this.#address);
    this.#address = this.#painted = "";
    this.#image.removeAttribute("src");
  }

  /** @param {import("./kernel.js").Kernel} kernel @param {AbortSignal} signal */
  async #paint(kernel, signal) {
    const scene = this.#scene();
    const { document, size, result } = scene;
    if (!document || !result || size.width < 1 || size.height < 1) return;
    const options = scene.options(RATIO, "light");
    const key = JSON.stringify([document, options]);
    if (key === this.#painted) return;
    const canvas = globalThis.document.createElement("canvas");
    await scene.print(canvas, options, kernel, signal);
    /** @type {Blob | null} */
    const blob = await new Promise((resolve) => canvas.toBlob(resolve));
    if (!blob || signal.aborted) return;
    this.#forget();
    this.#painted = key;
    this.#address = URL.createObjectURL(blob);
    this.#image.src = this.#address;
  }
}
