/**
 * Small pictures of shapes: the outline as it was read, and the curve that stands for it.
 *
 * @import { Point, Shape } from "../types.js"
 */
import { svg } from "../dom.js";
import { outline } from "../spline.js";
import { boxOf } from "./choose.js";

/** Most vertices of an outline in a picture; more cannot be told apart. */
const VERTICES = 600;
const MARGIN = 4;

/**
 * The part of the plane that a picture shows.
 * @typedef {{scale: number, center: Point, width: number, height: number}} Frame
 */

/**
 * The frame that shows all of the points in a picture of a size.
 * @param {readonly Point[]} points
 * @param {number} width
 * @param {number} height
 * @returns {Frame}
 */
export function frameOf(points, width, height) {
  const { low, high } = boxOf(points);
  const span = [high[0] - low[0], high[1] - low[1]];
  const scale = Math.min((width - 2 * MARGIN) / (span[0] || 1), (height - 2 * MARGIN) / (span[1] || 1));
  return { scale, center: [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2], width, height };
}

/** @param {Frame} frame @param {Point} at */
const place = ({ scale, center, width, height }, [x, y]) => [width / 2 + (x - center[0]) * scale, height / 2 - (y - center[1]) * scale];

/**
 * The closed path of an outline.
 * @param {Frame} frame
 * @param {readonly Point[]} points
 */
function path(frame, points) {
  const step = Math.ceil(points.length / VERTICES);
  const shown = points.filter((_, i) => i % step === 0).map((at) => place(frame, at).map((v) => v.toFixed(1)).join(" "));
  return `M${shown.join("L")}Z`;
}

/**
 * An outline by itself.
 * @param {readonly Point[]} points
 * @param {number} width
 * @param {number} height
 */
export function thumbnail(points, width, height) {
  const frame = frameOf(points, width, height);
  return svg("svg", { class: "import-thumbnail", width, height, "aria-hidden": "true" }, svg("path", { d: path(frame, points) }));
}

/**
 * Outlines with the curves fitted to them and their control points.
 * @param {SVGSVGElement} element
 * @param {Frame} frame
 * @param {{points: readonly Point[], curve: Shape | null}[]} shapes
 */
export function drawPreview(element, frame, shapes) {
  element.replaceChildren(
    ...shapes.map(({ points }) => svg("path", { class: "import-read", d: path(frame, points) })),
    ...shapes.flatMap(({ curve }) => {
      if (!curve) return [];
      const chain = outline(curve).map(({ at }) => place(frame, at).map((v) => v.toFixed(1)).join(" "));
      const dots = curve.points.map((at) => {
        const [cx, cy] = place(frame, at);
        return svg("circle", { cx: cx.toFixed(1), cy: cy.toFixed(1), r: curve.points.length > 60 ? 1 : 1.75 });
      });
      return [svg("path", { class: "import-curve", d: `M${chain.join("L")}Z` }), ...dots];
    }),
  );
}
