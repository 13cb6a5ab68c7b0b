/**
 * The link of a figure to the editor: it leads to what is seen, and is written when that has come to rest.
 *
 * @typedef {object} Shown What the link leads to.
 * @property {import("../directrix.js").CurvesDocument} document
 * @property {"figure" | "steps" | "compare" | "solid"} view
 * @property {number} step
 * @property {string | URL} editor its address, for the page of the figure
 */
import { attribute } from "./dom.js";

/** Milliseconds after a change until the link has it as well. */
const SETTLED = 300;

export class EditorLink {
  #element;
  #shown;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {HTMLElement} element @param {() => Shown | null} shown null while nothing is */
  constructor(element, shown) {
    this.#element = element;
    this.#shown = shown;
  }

  later() {
    this.cancel();
    this.#timer = setTimeout(() => void this.#write(), SETTLED);
  }

  cancel() {
    clearTimeout(this.#timer);
  }

  async #write() {
    const shown = this.#shown();
    if (!shown) return;
    const { writeLink } = await import("../link.js");
    const { document: given, view, step, editor } = shown;
    const address = new URL(editor, document.baseURI);
    address.hash = writeLink({ document: given, ...(view === "figure" ? {} : { view }), ...(view === "steps" ? { step } : {}) });
    attribute(this.#element, "href", address.href);
  }
}
