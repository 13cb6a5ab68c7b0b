/**
 * The ground of a figure: it knows its size, enlarges everything on it for a presentation, lights up what a term names, and says which
 * term the pointer is on.
 *
 * @import { Point, Size } from "../types.js"
 * @import { Parts } from "./parts.js"
 */
import { attribute, h, svg } from "../dom.js";
import { partAt, pathsOf } from "./parts.js";

/** How much thicker strokes are in a presentation, at most. */
const LARGE = 1.6;
/** The shorter side from which the kernel draws samples: smaller grounds are drawn as large as this, and shrunk. CSS pixels. */
const SAMPLES = 420;

/**
 * @param {object} acts
 * @param {boolean} acts.painted whether the kernel paints on it
 * @param {() => void} acts.resized
 * @param {(term: string | null) => void} acts.pointed at what a term of the text names
 */
export function createSurface({ painted, resized, pointed }) {
  const under = svg("path", { class: "lit-under" });
  const area = svg("path", { class: "lit-area" });
  const strokes = svg("path", { class: "lit-strokes" });
  const dots = svg("path", { class: "lit-dots" });
  const overlay = svg("svg", { class: "lesson-lit", "aria-hidden": "true" }, area, under, strokes, dots);
  const element = h("div", { class: "lesson-picture" }, /** @type {any} */ (overlay));
  /** @type {Size} */
  let box = { width: 0, height: 0 };
  let zoom = 1;
  let isLarge = false;
  /** @type {Parts} */
  let parts = new Map();
  /** @type {string | null} */
  let lit = null;
  /** @type {string | null} */
  let under_ = null;

  const observer = new ResizeObserver(([entry]) => {
    if (!entry) return;
    const { width, height } = entry.contentRect;
    if (width < 1 || height < 1) return;
    box = { width: Math.round(width), height: Math.round(height) };
    fit();
    resized();
  });
  observer.observe(element);

  /** Everything on the ground is drawn in a size that is smaller by the zoom. @returns {Size} */
  const size = () => ({ width: box.width / zoom, height: box.height / zoom });

  function fit() {
    const most = isLarge ? LARGE : 1;
    zoom = painted && box.width > 0 ? Math.min(most, Math.min(box.width, box.height) / SAMPLES) : most;
    const { width, height } = size();
    attribute(overlay, "viewBox", `0 0 ${width} ${height}`);
  }

  /** A place of the screen on the ground. @param {{clientX: number, clientY: number}} event @returns {Point} */
  function placeOf({ clientX, clientY }) {
    const { left, top } = element.getBoundingClientRect();
    return [(clientX - left) / zoom, (clientY - top) / zoom];
  }

  element.addEventListener("pointermove", (event) => point(partAt(parts, placeOf(event))));
  element.addEventListener("pointerleave", () => point(null));

  /** @param {string | null} term */
  function point(term) {
    if (term === under_) return;
    under_ = term;
    pointed(term);
  }

  function draw() {
    const paths = pathsOf(lit === null ? undefined : parts.get(lit));
    attribute(area, "d", paths.area);
    attribute(under, "d", paths.strokes);
    attribute(strokes, "d", paths.strokes);
    attribute(dots, "d", paths.dots);
    attribute(element, "data-lit", lit);
  }

  return {
    element,
    overlay,
    size,
    placeOf,
    get zoom() {
      return zoom;
    },
    /** @param {boolean} large */
    enlarge(large) {
      isLarge = large;
      fit();
    },
    /** What the terms name now. @param {Parts} next */
    name(next) {
      parts = next;
      draw();
    },
    /** @param {string | null} term */
    light(term) {
      lit = term;
      draw();
    },
    close: () => observer.disconnect(),
  };
}
