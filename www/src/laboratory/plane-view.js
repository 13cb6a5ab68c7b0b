/**
 * The picture of a problem in the plane: the solution in the colours of the materials, and the segments of its boundary in those of their conditions.
 *
 * @import { Point, Size, View } from "../types.js"
 * @import { PictureWanted } from "../files/picture-rows.js"
 * @import { Sheet } from "../part/canvas.js"
 * @import { Mesh } from "./state.js"
 *
 * @typedef {object} PlanePicture
 * @property {View} view
 * @property {Size} size CSS pixels
 * @property {"light" | "dark"} theme
 * @property {boolean} hasGrid
 * @property {Sheet | null} sheet
 * @property {Mesh} mesh
 * @property {(element: number) => string | null} colorOf CSS colour of an element; null where a flux is given
 * @property {(element: number) => boolean} isChosen
 * @property {(element: number) => boolean} isWrong
 * @property {boolean} edges whether the ends of segments are marked
 * @property {number[]} isolines four numbers a segment, document units
 * @property {import("./mesh.js").Elements} boundary
 */
import { h } from "../dom.js";
import { createCanvas } from "../part/canvas.js";
import { toScreen } from "../view.js";
import { pointOf } from "./mesh.js";

/** CSS pixels of a segment and of the ink round it, of what is chosen, and of the tick at its end. */
const WIDTH = { color: 4, ink: 6, chosen: 11, tick: 4 };
const INK = { light: "#17191d", dark: "#f3f4f7" };
/** What a segment with a flux looks like. */
const FLUX = { light: "#c3c9d2", dark: "#4a4e58" };
/** Ground of the page, and what is wrong. */
const GROUND = { light: "#ffffff", dark: "#0e0f12" };
const ERROR = { light: "#b3261e", dark: "#ff8d85" };
/** CSS pixels of a segment whose ends are marked, at least. */
const LEAST = 5;
/** CSS pixels of the nearest segment that a place reads. */
const NEAR = 7;

export function createPlaneView() {
  const { canvas, draw } = createCanvas();
  const over = h("canvas", { class: "part-picture lab-outline", "aria-hidden": "true" });
  const context = over.getContext("2d");
  /** @type {PlanePicture | null} */
  let picture = null;

  return {
    canvas,
    over,
    /** @param {PlanePicture} next */
    draw(next) {
      picture = next;
      const { view, size, theme, hasGrid, sheet } = next;
      draw({ view, size, theme, hasGrid, sheets: sheet ? [sheet] : [], broken: null });
      if (!context) return;
      const ratio = window.devicePixelRatio || 1;
      const [width, height] = [Math.round(size.width * ratio), Math.round(size.height * ratio)];
      if (over.width !== width || over.height !== height) [over.width, over.height] = [width, height];
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      context.clearRect(0, 0, size.width, size.height);
      const style = getComputedStyle(over);
      outline(context, next, { chosen: style.getPropertyValue("--accent"), wrong: style.getPropertyValue("--error") });
    },
    /** What is seen now as a picture, without marks. @param {PictureWanted} wanted @returns {OffscreenCanvas | null} */
    picture({ width, height, theme, transparent }) {
      const made = new OffscreenCanvas(width, height);
      const target = made.getContext("2d");
      if (!target || !picture) return null;
      const { view, size, sheet } = picture;
      if (!transparent) {
        target.fillStyle = GROUND[theme];
        target.fillRect(0, 0, width, height);
      }
      const ratio = Math.min(width / size.width, height / size.height);
      target.setTransform(ratio, 0, 0, ratio, (width - ratio * size.width) / 2, (height - ratio * size.height) / 2);
      if (sheet) {
        const source = new OffscreenCanvas(...sheet.size);
        source.getContext("2d")?.putImageData(new ImageData(sheet.pixels, sheet.size[0], sheet.size[1]), 0, 0);
        const [[left, low], [right, high]] = sheet.box;
        const [from, to] = [toScreen(view, size, [left, high]), toScreen(view, size, [right, low])];
        target.drawImage(source, ...from, to[0] - from[0], to[1] - from[1]);
      }
      outline(/** @type {any} */ (target), { ...picture, theme, isChosen: () => false }, { chosen: "", wrong: ERROR[theme] });
      return made;
    },
    /** The segment nearest to a place of the screen, if it is near. @param {Point} at @returns {number | null} */
    elementAt(at) {
      if (!picture) return null;
      let [best, nearest] = [/** @type {number | null} */ (null), NEAR];
      for (let element = 0; element < picture.mesh.count; element += 1) {
        const distance = toSegment(at, ...endsOf(picture, element));
        if (distance < nearest) [best, nearest] = [element, distance];
      }
      return best;
    },
  };
}

/** Where a segment is seen. @param {PlanePicture} picture @param {number} element @returns {[Point, Point]} */
function endsOf({ boundary, view, size }, element) {
  return /** @type {[Point, Point]} */ ([0, 1].map((k) => toScreen(view, size, flat(pointOf(boundary, boundary.elements[2 * element + k])))));
}

/**
 * Lines of equal fraction, and the boundary over them.
 * @param {CanvasRenderingContext2D} context
 * @param {PlanePicture} picture
 * @param {{chosen: string, wrong: string}} colors
 */
function outline(context, picture, colors) {
  const { view, size, theme, colorOf, isChosen, isWrong, isolines, edges, mesh } = picture;
  Object.assign(context, { lineCap: "round", lineJoin: "round" });
  if (isolines.length > 0) {
    context.globalAlpha = 0.55;
    Object.assign(context, { strokeStyle: "#000000", lineWidth: 1 });
    context.beginPath();
    for (let k = 0; k < isolines.length; k += 4) {
      context.moveTo(...toScreen(view, size, [isolines[k], isolines[k + 1]]));
      context.lineTo(...toScreen(view, size, [isolines[k + 2], isolines[k + 3]]));
    }
    context.stroke();
    context.globalAlpha = 1;
  }
  stroke(context, picture, isChosen, () => colors.chosen, WIDTH.chosen);
  stroke(context, picture, isWrong, () => colors.wrong, WIDTH.chosen);
  stroke(context, picture, () => true, () => INK[theme], WIDTH.ink);
  stroke(context, picture, () => true, (element) => colorOf(element) ?? FLUX[theme], WIDTH.color);
  if (!edges) return;
  context.strokeStyle = INK[theme];
  context.lineWidth = 1;
  context.beginPath();
  for (let element = 0; element < mesh.count; element += 1) {
    const [a, b] = endsOf(picture, element);
    const long = Math.hypot(b[0] - a[0], b[1] - a[1]);
    // Where ticks would touch each other they say nothing.
    if (long < LEAST) continue;
    const across = [((b[1] - a[1]) / long) * WIDTH.tick, ((a[0] - b[0]) / long) * WIDTH.tick];
    context.moveTo(a[0] - across[0], a[1] - across[1]);
    context.lineTo(a[0] + across[0], a[1] + across[1]);
  }
  context.stroke();
}

/**
 * Segments of one colour as one path.
 * @param {CanvasRenderingContext2D} context
 * @param {PlanePicture} picture
 * @param {(element: number) => boolean} isDrawn
 * @param {(element: number) => string} color
 * @param {number} width
 */
function stroke(context, picture, isDrawn, color, width) {
  /** @type {Map<string, number[]>} */
  const byColor = new Map();
  for (let element = 0; element < picture.mesh.count; element += 1) {
    if (!isDrawn(element)) continue;
    const list = byColor.get(color(element));
    if (list) list.push(element);
    else byColor.set(color(element), [element]);
  }
  context.lineWidth = width;
  for (const [css, elements] of byColor) {
    context.strokeStyle = css;
    context.beginPath();
    for (const element of elements) {
      const [a, b] = endsOf(picture, element);
      context.moveTo(...a);
      context.lineTo(...b);
    }
    context.stroke();
  }
}

/** @param {readonly number[]} point @returns {Point} */
const flat = (point) => [point[0], point[1]];

/** @param {Point} at @param {Point} a @param {Point} b */
function toSegment(at, a, b) {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const square = dx * dx + dy * dy;
  const t = square > 0 ? Math.min(1, Math.max(0, ((at[0] - a[0]) * dx + (at[1] - a[1]) * dy) / square)) : 0;
  return Math.hypot(at[0] - a[0] - t * dx, at[1] - a[1] - t * dy);
}
