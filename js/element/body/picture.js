/**
 * The picture of a body on a canvas: its boundary, the face of a cut, boundary curves, corners, and crosses where something is wrong.
 *
 * @import { BodySection, BodySurface, CellSummary } from "../../directrix.js"
 * @import { Camera, Frame } from "../../space/camera.js"
 * @import { Bounds } from "../../space/vector.js"
 * @import { Plane } from "./raster.js"
 *
 * @typedef {object} Shape What is drawn; made once for each body.
 * @property {BodySurface} surface
 * @property {Float32Array} labs
 * @property {Bounds} bounds
 *
 * @typedef {{ plane: Plane, section: BodySection, labs: Float32Array }} Cut
 *
 * @typedef {object} Look
 * @property {Camera} camera
 * @property {Frame} frame
 * @property {number} ratio device pixels for one of CSS
 * @property {"light" | "dark"} theme
 * @property {boolean} isFine whether edges are smooth; a picture that moves is coarser
 * @property {boolean} [isSmall] without corners, and with thin lines
 * @property {readonly (readonly number[])[]} [witnesses]
 */
import { labsOf } from "../../space/colors.js";
import { projection, Raster } from "./raster.js";

/** Pixels of the raster for one of a fine picture, either way, and how many the raster may have. */
const FINE = 2;
const MOST = 4_000_000;
/** Device pixels of a picture that moves. */
const MOVING = 700_000;
/** CSS pixels: pieces of a line that is partly hidden; how much nearer than what they lie on lines and dots count. */
const PIECE = 3;
const NEARER = 4;
const NEARER_DOT = 10;
/** Lines, dots and crosses, as in the workbench. */
const INK = "#101216";
const ERROR = { light: "#b3261e", dark: "#ff8d85" };
const RADIUS = 3;
const RING = 1.2;
const CROSS = 5;

/**
 * How far triangles may lie from the boundary: a share of the diagonal of the corners; no options where these have none.
 *
 * @param {CellSummary[]} cells
 * @param {number} share
 * @returns {{ tolerance?: number }}
 */
export function within(cells, share) {
  const points = cells.flatMap(({ corners }) => corners);
  const spans = [0, 1, 2].map((axis) => {
    const [low, high] = points.reduce(([low, high], point) => [Math.min(low, point[axis]), Math.max(high, point[axis])], [Infinity, -Infinity]);
    return high - low;
  });
  const diagonal = Math.hypot(...spans);
  return diagonal > 0 && Number.isFinite(diagonal) ? { tolerance: share * diagonal } : {};
}

/** @param {BodySurface} surface @returns {Shape} */
export function shapeOf(surface) {
  const [min, max] = [Math.min, Math.max].map((least) =>
    [0, 1, 2].map((axis) => {
      let found = surface.positions[axis] ?? 0;
      for (let n = axis; n < surface.positions.length; n += 3) found = least(found, surface.positions[n]);
      return found;
    }),
  );
  return { surface, labs: labsOf(surface.colors), bounds: /** @type {Bounds} */ ({ min, max }) };
}

/** @param {Plane} plane @param {BodySection} section @returns {Cut} */
export const cutOf = (plane, section) => ({ plane, section, labs: labsOf(section.colors) });

/**
 * Paints a body and sizes the canvas.
 *
 * @param {HTMLCanvasElement} canvas
 * @param {Shape} shape
 * @param {Cut | null} cut
 * @param {Look} look
 */
export function paint(canvas, shape, cut, look) {
  const { width, height } = look.frame.size;
  const area = width * height;
  const ratio = look.isFine ? look.ratio : Math.min(look.ratio, Math.sqrt(MOVING / area));
  const [w, h] = [width, height].map((side) => Math.max(1, Math.round(side * ratio)));
  const count = look.isFine && w * h * FINE * FINE <= MOST ? FINE : 1;
  const raster = new Raster(w * count, h * count);
  const seen = projection(look.camera, look.frame, ratio * count);
  raster.fill({ ...shape.surface, labs: shape.labs }, seen, cut?.plane);
  if (cut) raster.fill({ positions: cut.section.positions, indices: cut.section.indices, labs: cut.labs }, seen);
  if (canvas.width !== w) canvas.width = w;
  if (canvas.height !== h) canvas.height = h;
  const context = canvas.getContext("2d");
  if (!context) return;
  context.putImageData(raster.image(count), 0, 0);
  const drawing = createDrawing(context, raster, look, ratio, count);
  drawing.lines(edgesOf(shape.surface), { width: look.isSmall ? 0.6 : 0.9, opacity: 0.5, cut: cut?.plane ?? null });
  if (cut) drawing.lines(outlineOf(cut.section), { width: 1.9, opacity: 1, cut: null });
  if (!look.isSmall) drawing.dots(shape.surface.corners.map(({ position }) => position), cut?.plane ?? null);
  drawing.crosses(look.witnesses ?? []);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Raster} raster
 * @param {Look} look
 * @param {number} ratio device pixels for one of CSS
 * @param {number} count pixels of the raster for one of the canvas
 */
function createDrawing(context, raster, { camera, frame, theme }, ratio, count) {
  const seen = projection(camera, frame, ratio);
  const place = new Float32Array(3);
  // Of one over the depth, at the distance of the target.
  const nearer = (frame.size.height > 0 ? 1 / frame.size.height : 0) * 0.37;

  /** Whether nothing hides what is at `place`, or next to it: lines on a rim lie half beside their wall. @param {number} pixels of CSS towards the eye */
  function isOpen(pixels) {
    const [x, y, near] = place;
    if (!(near > 0)) return false;
    const least = near * (1 + nearer * pixels);
    const [column, row] = [Math.floor(x * count), Math.floor(y * count)];
    for (const [right, down] of [[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]]) {
      const [i, j] = [column + right, row + down];
      if (i < 0 || j < 0 || i >= raster.width || j >= raster.height) return true;
      if (raster.nearness[j * raster.width + i] <= least) return true;
    }
    return false;
  }

  return {
    /**
     * @param {ArrayLike<number>[]} polylines three numbers a point
     * @param {{ width: number, opacity: number, cut: Plane | null }} how
     */
    lines(polylines, { width, opacity, cut }) {
      context.beginPath();
      const point = [0, 0, 0];
      const to = new Float32Array(3);
      for (const line of polylines) {
        let isDown = false;
        for (let n = 0; n + 5 < line.length; n += 3) {
          seen.place(line, n, place, 0);
          seen.place(line, n + 3, to, 0);
          const far = Math.hypot(to[0] - place[0], to[1] - place[1]) / ratio;
          const pieces = Math.max(1, Math.min(400, Math.ceil(far / PIECE)));
          for (let piece = n === 0 ? 0 : 1; piece <= pieces; piece += 1) {
            for (let k = 0; k < 3; k += 1) point[k] = line[n + k] + (piece / pieces) * (line[n + 3 + k] - line[n + k]);
            seen.place(point, 0, place, 0);
            const isShown = isBefore(point, cut) && isOpen(NEARER);
            if (isShown && isDown) context.lineTo(place[0], place[1]);
            else if (isShown) context.moveTo(place[0], place[1]);
            isDown = isShown;
          }
        }
      }
      context.globalAlpha = opacity;
      context.lineWidth = width * ratio;
      context.lineJoin = context.lineCap = "round";
      context.strokeStyle = INK;
      context.stroke();
      context.globalAlpha = 1;
    },
    /** @param {readonly (readonly number[])[]} points @param {Plane | null} cut */
    dots(points, cut) {
      for (const point of points) {
        seen.place(point, 0, place, 0);
        if (!isBefore(point, cut) || !isOpen(NEARER_DOT)) continue;
        context.beginPath();
        context.arc(place[0], place[1], RADIUS * ratio, 0, 2 * Math.PI);
        context.fillStyle = "#ffffff";
        context.fill();
        context.lineWidth = RING * ratio;
        context.strokeStyle = INK;
        context.stroke();
      }
    },
    /** @param {readonly (readonly number[])[]} points */
    crosses(points) {
      for (const [width, color] of /** @type {const} */ ([[5, theme === "dark" ? "#0e0f12" : "#ffffff"], [2, ERROR[theme]]])) {
        context.beginPath();
        for (const point of points) {
          seen.place(point, 0, place, 0);
          const [x, y] = place;
          const arm = CROSS * ratio;
          context.moveTo(x - arm, y - arm);
          context.lineTo(x + arm, y + arm);
          context.moveTo(x - arm, y + arm);
          context.lineTo(x + arm, y - arm);
        }
        context.lineWidth = width * ratio;
        context.lineCap = "round";
        context.strokeStyle = color;
        context.stroke();
      }
    },
  };
}

/** @param {readonly number[]} point @param {Plane | null} cut */
const isBefore = (point, cut) => !cut || point[0] * cut.normal[0] + point[1] * cut.normal[1] + point[2] * cut.normal[2] >= cut.offset;

/** The boundary curves. @param {BodySurface} surface */
const edgesOf = ({ edges, edgePositions }) => edges.map(({ start, count }) => edgePositions.subarray(3 * start, 3 * (start + count)));

/** Where cells end on the face of a cut. @param {BodySection} section */
function outlineOf({ outline, positions }) {
  return Array.from({ length: outline.length / 2 }, (_, n) =>
    [outline[2 * n], outline[2 * n + 1]].flatMap((vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)]),
  );
}
